#include "apps/run/begun_certificate.h"

#include "history/error.h"
#include "history/sha256.h"
#include "library/index_format.h"

namespace voroproof::internal {
namespace {

bool is_of_bytes(const ShardFile& file, const std::string& history) {
  const std::optional<Cut>& end = file.shard.end;
  return end ? sha256_of_stretch(history, 0, end->offset) == end->bytes_sha256
             : sha256_of_file(history) == file.run.history_sha256;
}

}  // namespace

std::optional<ShardFile> finished_shard(const std::string& path, const ShardFile& wanted,
                                        const std::string& history) {
  try {
    ShardFile found = read_shard(path);
    const bool same = difference(wanted, found).empty() && found.number == wanted.number &&
                      found.of == wanted.of &&
                      found.shard.certificate.verdict != Verdict::undecided &&
                      is_of_bytes(found, history);
    return same ? std::optional(std::move(found)) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<Shard> BegunCertificate::find(const ShardFile& wanted) const {
  if (!file_.is_there()) return std::nullopt;
  ShardFile found = read_shard(path());
  std::string other = difference(wanted, found);
  if (other.empty() && (found.number != wanted.number || found.of != wanted.of)) {
    other = "of another shard";
  }
  if (!other.empty()) throw InputError(path(), 0, "", "is " + other + " than the run asked for");
  if (!found.shard.begin || !found.shard.end ||
      found.shard.certificate.verdict != Verdict::certified) {
    throw InputError(path(), 0, "", "is of no run that can be taken up");
  }
  return std::move(found.shard);
}

}  // namespace voroproof::internal
