// A history dealt out in parts.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/checker.h"
#include "certify/options.h"
#include "certify/read_ahead.h"
#include "certify/replay.h"
#include "certify/shard.h"
#include "exact/prefetch.h"

namespace voroproof::internal {

// Events and their lines, in little memory: nearly all are flips at a time that is a double.
class ClaimList {
 public:
  std::size_t size() const { return claims_.size(); }
  void reserve(std::size_t claims) { claims_.reserve(claims); }
  void add(Event&& event, std::int64_t line);
  // Never none: as HistorySource gives an event, put in its place.
  std::optional<Event> event(std::size_t k) const;
  std::int64_t line(std::size_t k) const { return claims_[k].line; }
  // How many there are of these, at most.
  std::size_t turns() const { return others_.size(); }
  // The first from the k-th on that is a turn, or nearly: no flip at a time that is a double; or
  // their number.
  std::size_t turn_from(std::size_t k) const {
    while (k < claims_.size() && claims_[k].quad.l != kOther) ++k;
    return k;
  }
  // Asks for the memory of claims that are taken after the k-th.
  [[gnu::always_inline]] void prefetch(std::size_t k) const {
    if (k + 8 < claims_.size()) internal::prefetch(&claims_[k + 8]);
    if (k + 4 >= claims_.size()) return;
    const Quad& later = claims_[k + 4].quad;
    if (later.l == kOther) internal::prefetch(&others_[later.r]);
  }

 private:
  static constexpr GenId kOther = container_id - 1;  // no generator
  struct Claim {
    double t;
    Quad quad;  // l is kOther where the event is another: then r is its index in others_
    std::int64_t line;
  };
  std::vector<Claim> claims_;
  std::vector<Event> others_;
};

// The leader has computed this for a part, under the exact truth (certify/turn_leader.h).
struct LedPart;

// Claims that follow each other, to be proved on their own.
struct Part {
  std::size_t number;  // from 0
  std::shared_ptr<const ClaimList> list;
  std::unique_ptr<HistorySource>
      claims;                         // the list; where the part is the last, and all that follows
  std::vector<Replay::Place> places;  // places of the claims, as reading took them
  Replay replay;                      // before them; under the exact truth the diagram alone
  std::optional<double> begin;        // none for the first part
  std::optional<PartEnd> end;         // none for the last
  std::shared_ptr<const LedPart> led{};  // exact truth
};

// Reads a history part by part. The parts depend on the file only.
class PartReader {
 public:
  // Everything must outlive the reader, and the reader its parts. `remarks` receives what is to be
  // said of the initial diagram. `marks`: cut() will be asked for.
  PartReader(const Scene& scene, const MotionInput& input, HistorySource& history,
             const CertifyOptions& options, std::vector<std::string>& remarks, bool marks = false);

  // Goes on at the cut, which is taken at its word: what next() gives then is what it gives behind
  // the cut of that name, if there is one. Before the first next(). Throws InputError where the
  // state is none of this scene, or the history cannot be read from there. Precondition: marks.
  void start_at(const IndexedCut& start);

  // The header, with the initial diagram once the first part has been read.
  const HistoryHeader& header() const { return header_; }

  // The next part; nothing after the last. Throws InputError where the history cannot be read: what
  // has been read of the part is lost then.
  std::optional<Part> next();
  // All that is left is the last part: also what next() has read of a part that it could not read
  // to its end. Where the history cannot be read its claims say so, when they come to that.
  Part rest();
  // The last part again, with the claims of the lists before its own, and all as the history has
  // it. Precondition: it was the last.
  std::unique_ptr<HistorySource> rest(std::vector<std::shared_ptr<const ClaimList>> lists);
  // Those claims of the part, which is not the last, that are no flips at times that are doubles.
  std::unique_ptr<HistorySource> turns(const Part& part) const;

  // Whether there is no next part.
  bool done() const { return done_; }
  // The number of the next part, and when it begins.
  std::size_t number() const { return number_; }
  double begins_at() const { return begin_.value_or(0); }
  // The bytes of the history before it, and what these claims lead to.
  std::int64_t offset() const { return offset_; }
  // The hash of these bytes. Precondition: marks.
  Sha256 digest() const { return history_.digest_up_to(offset_); }
  const Replay& replay() const { return replay_; }
  // The place before the next part. Preconditions: marks, !done().
  Cut cut() const;

 private:
  class Section;

  void take_next_claim();
  void begin_history();
  void take_initial_diagram();
  bool may_end() const;
  bool is_full() const;

  const MotionInput& input_;
  HistorySource& history_;
  const CertifyOptions& options_;
  std::vector<std::string>& remarks_;
  HistoryHeader header_;
  double gap_;        // between the claims on both sides of an end, so that no two swap across it
  std::size_t size_;  // claims of a part, at least
  double horizon_;    // nearly
  Replay replay_;     // state after the claims taken
  ReadAhead ahead_;   // claims of the history, read and not yet taken
  // The present part.
  std::size_t number_ = 0;
  ClaimList claims_;
  double last_ = 0;  // the time of the last of them
  std::vector<Replay::Place> places_;
  Replay before_;
  std::optional<double> begin_;
  std::size_t in_parts_ = 0;  // claims, of all parts before it
  // The counts of all claims taken.
  HistoryCounts taken_;
  std::int64_t line_ = 1, offset_ = 0;  // place of the last claim taken
  bool marks_;
  std::string header_sha256_;
  // Whether the claims so far make sense. The others are left to the last part, to say why not.
  bool clear_ = true;
  bool done_ = false;
};

}  // namespace voroproof::internal
