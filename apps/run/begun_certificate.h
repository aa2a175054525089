// What a run of `certify` has proved so far, kept beside its report for a later run.
#pragma once

#include <optional>
#include <string>

#include "library/shard_file.h"

namespace voroproof::internal {

// The file REPORT.partial: a shard that begins where the run began and ends where it had come to.
class BegunCertificate {
 public:
  explicit BegunCertificate(const std::string& report) : path_(report + ".partial") {}

  const std::string& path() const { return path_; }

  // Throws UsageError where something else than what a run leaves has its name: it would be
  // replaced, and removed at the end.
  void require_replaceable() const;

  // What an earlier run of the same has left; nothing if it has left nothing. `wanted`: what it has
  // to be of. Throws InputError where it is of something else.
  std::optional<Shard> find(const ShardFile& wanted) const;

  // Replaces it. A disk that is full is no reason to end the run: the user is told, once.
  void keep(const ShardFile& so_far);

  // The report says more.
  void forget() const;

 private:
  std::string path_;
  bool told_ = false;
};

}  // namespace voroproof::internal
