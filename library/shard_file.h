// The certificates of shards as files, and joined to that of the whole (docs/certificate.md,
// section 13).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/report.h"
#include "certify/shard.h"

namespace voroproof::internal {

inline constexpr int most_shards = 1'000'000;

// The number of a shard, and of how many: "2/8" is {2, 8}. Nothing where the text is of no shard.
std::optional<std::pair<int, int>> part_of(const std::string& text);

// A shard, and what it is of.
struct ShardFile {
  int number = 1, of = 1;  // as in ShardTask
  CertificationRun run;
  CertifyOptions options;
  Shard shard;
};

std::string shard_text(const ShardFile& file);

// Says of a certificate's words that they are about a shard.
std::string about_shard(const ShardFile& file, const std::string& about);

// Throws InputError.
ShardFile read_shard(const std::string& path);

// Why the two are not of one history, or not by one program with the same options; empty if they
// are. The names of the files may differ.
std::string difference(const ShardFile& a, const ShardFile& b);

// Adds what comes next to a shard that is right up to where this begins.
void append(Shard& shard, Shard&& next);

// The certificate of the whole from those of its shards, in any order. Those behind the first that
// is not certified do not matter. Throws InputError, naming the file at fault, where they do not
// fit together: of other histories or options; one twice, or missing; one that does not begin where
// the one before it ends; one whose witness CGAL contradicts.
ShardFile merge_shards(const std::vector<std::string>& paths);

}  // namespace voroproof::internal
