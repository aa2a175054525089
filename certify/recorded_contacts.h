// Contacts and overlaps under the recorded truth (docs/claim.md).
//
// On the recorded paths the gap of a pair goes below zero at an *entry*. Each entry has to be
// answered by a claimed collision of that pair within the tolerance of it, each claimed collision
// answers one entry, and an overlap ends within the tolerance of the claim that answers it. What
// the rounding of the file's numbers can have caused is no overlap; a claimed collision without an
// entry is right where the two come as near as that rounding lets them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "certify/gap.h"
#include "exact/generators.h"
#include "exact/predicates.h"

namespace voroproof::internal {

class RecordedContacts {
 public:
  // `tolerance`: of times. `window`: an entry at this time or later, near the horizon, needs no
  // answer. `diagrams`: it matters whether a generator lies inside another.
  RecordedContacts(const Rational& tolerance, const Rational& window, bool diagrams)
      : tolerance_(tolerance), window_(window), diagrams_(diagrams) {}

  using Pair = std::pair<GenId, GenId>;

  // The two on their lines, whose places are those at the time `at`.
  struct Motions {
    Rational at;
    MovingSite<Rational> first, second;
  };

  // A pair on its present lines, from the time since which the two are watched on these.
  struct Lines {
    Pair pair;
    Gap gap;
    Rational from;
    Rational reach;
    Rational rounding;  // length by which roundings may have moved the two
    bool collided;      // the last thing that happened to them was their own collision, at `from`
    Motions motions;
  };

  // Whether an overlap of the two on these lines is no deeper than roundings may be.
  static bool is_rounding(const Lines& lines, const Gap::Overlap& o) {
    return o.shallow && 4 * lines.rounding <= lines.reach;
  }

  // An overlap that nothing excuses.
  struct Missing {
    double lo, hi;    // an enclosure of its entry
    Motions motions;  // then
  };
  // The two go on as the lines say until `end`; each time of a pair is passed once. `watched`: the
  // pair is still watched after that. Throws Undecided.
  std::optional<Missing> pass(const Lines& lines, const Rational& end, bool watched);

  enum class Contact { right, graze, none, elsewhere, parting };
  struct Answer {
    Contact contact;
    std::optional<Missing> entry;  // elsewhere
  };
  // Whether a collision claimed at t, no earlier than `from`, answers an entry. pass() comes first,
  // up to t.
  Answer answer(const Lines& lines, const Rational& t);

  // Whether anything is carried over from earlier lines, of any pair, and of this one.
  bool carries_any() const { return !carried_.empty(); }
  bool carries(const Pair& pair) const { return !carried_.empty() && carried_.contains(pair); }
  std::vector<Pair> carried() const;
  // Whether the tangency of the pair has had the wrong sign since its last entry, and nothing has
  // been proved since. What has been at the time t, on the lines of then, is noted.
  bool hidden(const Pair& pair) const;
  void reveal(const Pair& pair, const Rational& t);

  // Overlaps within the rounding that no claim answers, and entries left out at the horizon.
  std::int64_t rounded() const { return rounded_; }
  std::int64_t left_out() const { return left_out_; }

 private:
  struct Carried {
    GapTime entry;
    Motions motions;      // at the entry: one of the two may have turned since
    bool over = false;    // the two overlap no more
    bool shallow = true;  // never deeper than the rounding
    bool hidden = false;
    std::optional<Rational> answered;  // by a claim at this time
    std::optional<Rational> revealed;  // proved harmless at this time
  };
  bool at_horizon(const GapTime& t) const { return t.compare(window_) >= 0; }
  using Pairs = std::map<Pair, Carried>;
  void forget_if_done(Pairs::iterator it);
  std::optional<Missing> give_up(Pairs::iterator it);
  static Missing missing(const Carried& c);

  const Rational &tolerance_, &window_;
  bool diagrams_;
  Pairs carried_;  // pairs that overlap, or have, and owe an answer or a proof
  std::int64_t rounded_ = 0, left_out_ = 0;
};

}  // namespace voroproof::internal
