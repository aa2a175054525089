// Points that meet at a disk. Two points that graze one disk from two sides and meet there are
// never neighbours, so that no search for the contact of two neighbours tells of them. There is no
// diagram at that instant, and none is known after it. (The certifier's rule is 3.18 of
// docs/certificate.md.)
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "filtered/motion/motion.h"
#include "filtered/numbers/next_double.h"
#include "filtered/search/contact.h"

namespace voroproof::internal {

class Meetings {
 public:
  // `motion` must outlive this object.
  explicit Meetings(const Motion& motion) : motion_(motion) {}

  // The next contact of the points a < b on their present lines, which are neighbours of one disk.
  void note(GenId a, GenId b, const NextContact& contact) {
    if (contact.kind == NextContact::Kind::none) return;
    if (contact.kind == NextContact::Kind::now) give_up(a, b);
    all_.push_back({a, b, motion_.state_id(a), motion_.state_id(b), contact.lo});
  }

  // Throws Undecided, with the pair, where two points that were noted, and have not turned since,
  // may meet at t or before.
  void require_none_until(double t) {
    for (std::size_t k = 0; k < all_.size();) {
      const Meeting& m = all_[k];
      if (motion_.state_id(m.a) != m.state_a || motion_.state_id(m.b) != m.state_b) {
        all_[k] = all_.back();
        all_.pop_back();
        continue;
      }
      if (m.lo <= t) {
        before_ = std::min(before_, next_below(m.lo));
        give_up(m.a, m.b);
      }
      ++k;
    }
  }

  // Before the meeting that was told; infinite if there is none.
  double before() const { return before_; }

 private:
  struct Meeting {
    GenId a, b;
    int state_a, state_b;  // Motion::state_id()
    double lo;             // not before this time
  };

  [[noreturn]] static void give_up(GenId a, GenId b) {
    throw Undecided("two points meet at a disk between them", a, b);
  }

  const Motion& motion_;
  std::vector<Meeting> all_;
  double before_ = std::numeric_limits<double>::infinity();
};

}  // namespace voroproof::internal
