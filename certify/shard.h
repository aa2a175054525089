// A shard: parts of a history that follow each other, certified by one process. What a run has
// proved so far is a shard, too.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "certify/certificate.h"
#include "history/history_reader.h"

namespace voroproof::internal {

// A place between two parts of a history, and all that the parts after it depend on.
struct Cut {
  std::int64_t part = 0;      // the number of the part that begins here
  double t = 0;               // at which it begins
  HistoryCounts claims;       // before it
  std::int64_t line = 1;      // the last before it
  std::int64_t offset = 0;    // end of that line, as HistorySource has it
  std::string header_sha256;  // hash of the scene and the history's header
  std::string bytes_sha256;   // hash of the history's content up to the offset
  std::string state_sha256;   // hash of the diagram and the recorded motion after these claims
  bool operator==(const Cut&) const = default;
};

// A cut as an index (docs/formats.md, section 19) has it: nothing of it is believed.
struct IndexedCut {
  Cut cut;             // but for header_sha256
  std::string digest;  // Sha256::state() of the content before it
  std::string state;   // as Replay::put() writes it
  std::string file;    // where this is from
  std::int64_t line = 0;
};

// The proved knowledge of a shard: between the two cuts the history is as the certificate says, if
// it is right before the first. Where the history is over there is no cut, and a shard that begins
// there has no part.
struct Shard {
  std::optional<Cut> begin, end;
  Certificate certificate;
};

// Which parts are to be certified.
struct ShardTask {
  // The shard with this number, from 1, among `of` shards. The horizon is divided into so many
  // equal slices of time, and a part is of the shard in whose slice it begins.
  int number = 1, of = 1;
  // The parts of the shard before this one are certified already.
  std::optional<Cut> from{};
  // A cut before the shard, and no later than `from`: the history is read from there on, and not
  // from its beginning.
  std::optional<IndexedCut> start{};
  // Whether somebody wants to know what has been proved by now. Asked for each part.
  std::function<bool()> is_due{};
  // Some time after `is_due`: what is certified by then, from `from` on where that is given.
  std::function<void(Shard so_far)> proved{};
};

// The number of the shard, of so many, in whose slice of the time up to the horizon a part is that
// begins at t.
int shard_of(double t, double horizon, int of);

// The certificate of what `total` is about and of what comes next, which `next` is about: its
// verdict is that of `next`. Precondition: total.verdict is `certified`, or it is of nothing.
void append(Certificate& total, Certificate&& next);

}  // namespace voroproof::internal
