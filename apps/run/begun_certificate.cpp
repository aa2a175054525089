#include "apps/run/begun_certificate.h"

#include "history/error.h"

namespace voroproof::internal {

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
