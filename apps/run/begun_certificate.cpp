#include "apps/run/begun_certificate.h"

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "apps/cli/command_line.h"
#include "history/atomic_file.h"
#include "history/error.h"
#include "history/validate.h"

namespace voroproof::internal {

void BegunCertificate::require_replaceable() const {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path_, error))) return;
  try {
    if (std::filesystem::is_regular_file(path_, error) &&
        format_of_file(path_).name == "voroproof-shard") {
      return;
    }
  } catch (const InputError&) {
    // Then it is of no format.
  }
  throw UsageError("--report: " + printable(path_, 4096) +
                   " is there, which what is proved is kept in, and is something else");
}

std::optional<Shard> BegunCertificate::find(const ShardFile& wanted) const {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path_, error)) return std::nullopt;
  ShardFile found = read_shard(path_);
  std::string other = difference(wanted, found);
  if (other.empty() && (found.number != wanted.number || found.of != wanted.of)) {
    other = "of another shard";
  }
  if (!other.empty()) throw InputError(path_, 0, "", "is " + other + " than the run asked for");
  if (!found.shard.begin || !found.shard.end ||
      found.shard.certificate.verdict != Verdict::certified) {
    throw InputError(path_, 0, "", "is of no run that can be taken up");
  }
  return std::move(found.shard);
}

void BegunCertificate::keep(const ShardFile& so_far) {
  try {
    AtomicFile file(path_);
    file.write(shard_text(so_far));
    file.commit();
  } catch (const OutputError& error) {
    if (!told_) {
      std::cerr << "voroproof: " << printable(error.what(), 4096)
                << "; the run goes on, and cannot be taken up from here\n";
    }
    told_ = true;
  }
}

void BegunCertificate::forget() const { std::remove(path_.c_str()); }

}  // namespace voroproof::internal
