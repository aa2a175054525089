// Whether two touch on their true lines, but where they collide.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "certify/billiards/billiard_motion.h"
#include "certify/billiards/billiard_path.h"

namespace voroproof::internal {

// Pairs that touch at an instant at which one of the two turns, by that instant.
using Touches = std::map<Rational, std::set<BilliardPair>>;

class TrueLives {
 public:
  // All must outlive it. `filters`: doubles decide where they can.
  TrueLives(const BilliardMotion& motion, bool filters) : motion_(motion), filters_(filters) {}

  // Follows the pair through [from, to], at whose end all of its turns up to then are known. The
  // first contact that is not one of its collisions; none where there is none. One at `to` counts
  // where that is the end of all. Adds to `touches`, and to `lives` how many lines were looked at.
  // Throws TooCoarse and Undecided.
  std::optional<TrueTime> find_contact(const BilliardPair& pair, const BilliardTime& from,
                                       const BilliardTime& to, bool is_end, Touches& touches,
                                       std::int64_t& lives) const;

 private:
  // Lines that two keep, with those that follow them.
  struct Life {
    const BilliardPair& pair;
    const TrueLine &a, &b;
    const TrueLine *next_a, *next_b;
  };
  // The window.
  struct Span {
    const BilliardTime &from, &to;
    bool is_end;
  };
  std::optional<TrueTime> find_contact(const Life& life, const Span& span, Touches& touches,
                                       std::int64_t& lives) const;
  bool is_certainly_free(const Life& life, bool met, const Span& span) const;
  void note_touches(const Life& life, const Span& span, const TrueTime& start, const TrueTime& end,
                    Touches& touches) const;

  const BilliardMotion& motion_;
  bool filters_;
};

}  // namespace voroproof::internal
