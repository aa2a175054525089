// The proof so far of a run of `certify`, kept beside its report for a later run.
#pragma once

#include <optional>
#include <string>

#include "apps/run/partial_file.h"
#include "library/shard_file.h"

namespace voroproof::internal {

// The file REPORT.partial: a shard that begins where the run began and ends where it had come to.
class BegunCertificate {
 public:
  explicit BegunCertificate(const std::string& report) : file_(report, "voroproof-shard") {}

  const std::string& path() const { return file_.path(); }

  // Throws UsageError where something else than what a run leaves has its name.
  void require_replaceable() const { file_.require_replaceable("--report"); }

  // Returns the shard that an earlier run of the same kind has left, or nothing. `wanted` says
  // which run it has to be. Throws InputError where the file belongs to another run.
  std::optional<Shard> find(const ShardFile& wanted) const;

  void keep(const ShardFile& so_far) { file_.keep(shard_text(so_far)); }
  void forget() const { file_.forget(); }

 private:
  PartialFile file_;
};

// The certificate at `path`, where it is of the shard that is `wanted`, and of the bytes that the
// history has: who asks for this shard gets it again. Else nothing, whatever is there; nor where it
// is undecided, which may have been for a limit.
std::optional<ShardFile> finished_shard(const std::string& path, const ShardFile& wanted,
                                        const std::string& history);

}  // namespace voroproof::internal
