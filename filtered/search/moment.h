// Moments: times as tightly as doubles can say and exactly on demand; and their order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "exact/algebraic.h"
#include "filtered/motion/exact_motion.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/stats.h"
#include "filtered/search/symmetry.h"

namespace voroproof::internal {

class Chronology;
class CollapseSearch;
class ContactSearch;
struct Collapse;
struct NextContact;

using ExactTime = AlgebraicNumber<Tower>;

// An element of the tower as a time.
ExactTime time_of(const Tower& t);

// An instant, with what it takes to compute it exactly: lo <= instant <= hi.
struct Moment {
  enum class Kind : std::uint8_t { rational, flip, contact, state };
  Kind kind = Kind::rational;
  bool tight = false;     // dd is as narrow as it gets without more precision
  double lo = 0, hi = 0;  // isolate a flip or contact, except where `fine` does
  DdBall dd;              // encloses the instant, too
  Quad quad{};            // flip
  GenId i = 0, j = 0;     // contact of i and j
  int state = 0;          // state: when generator j began this state
  // A rational that is no binary64, or what isolates a flip that neighbouring doubles do not.
  std::shared_ptr<const RootInterval> fine;
  const Chronology* present = nullptr;  // which has what is known to happen at the instant, or null

  static Moment at(double t);
  static Moment at(const Rational& t);
  // When q collapses: the only root of its polynomial in `fine`, or without that in [lo, hi].
  static Moment of(const Quad& q, double lo, double hi, std::shared_ptr<const RootInterval> fine) {
    Moment m(Kind::flip, lo, hi);
    m.quad = q;
    m.fine = std::move(fine);
    return m;
  }
  static Moment of(const Quad& q, const Collapse& c);  // `c` is a root
  // When i and j touch: the only time in [lo, hi].
  static Moment of(GenId i, GenId j, double lo, double hi) {
    Moment m(Kind::contact, lo, hi);
    m.i = i;
    m.j = j;
    return m;
  }
  static Moment of(GenId i, GenId j, const NextContact& c);  // `c` is not `none`

  Moment() = default;

  bool is_flip() const { return kind == Kind::flip; }
  bool is_contact() const { return kind == Kind::contact; }
  double middle() const { return 0.5 * (lo + hi); }
  // The interval that isolates a flip.
  RootInterval root() const;
  // Requires a rational moment.
  Rational rational() const { return fine ? fine->lo : to_rational(lo); }
  // The instant in the field of `exact`. A flip or contact is that of the present motion of its
  // generators. Throws BudgetExceeded.
  ExactTime exact(ExactMotion& exact) const;
  // The instant lies in `t`, too, and no double-double tells it more narrowly.
  void narrow_to(const DdBall& t) {
    double below = 0, above = 0;
    enclose(t, below, above);
    lo = std::max(lo, below);
    hi = std::min(hi, above);
    dd = t;
    tight = true;
  }
  // i and j have collided at the instant, which left the larger, j, in this state.
  void collided(GenId of_i, GenId of_j, int state_of_j) {
    kind = Kind::state;
    i = of_i;
    j = of_j;
    state = state_of_j;
  }
  // Throws Undecided, with the flip or contact.
  [[noreturn]] void give_up(const std::string& reason) const;

 private:
  Moment(Kind of_kind, double from, double to)
      : kind(of_kind), lo(from), hi(to), dd(0.5 * (from + to), 0, (to - from) * (1 + 0x1p-50)) {}
};

// Compares moments. Flips and contacts are those of the present motion of their generators: such a
// moment is of use until one of these changes its motion.
class Chronology {
 public:
  // `counts` has what decides a comparison.
  Chronology(Motion& motion, const CollapseSearch& collapses, const ContactSearch& contacts,
             TierCounts& counts)
      : motion_(motion), collapses_(collapses), contacts_(contacts), counts_(counts) {}
  Chronology(const Chronology&) = delete;
  Chronology& operator=(const Chronology&) = delete;

  // Negative, zero or positive. Throws Undecided.
  int compare(const Moment& a, const Moment& b);
  // The order that compare() would give, with the motion as precise as it is: nothing where the
  // motion would have to be more precise. `why_not` says then why the exact comparison failed.
  std::optional<int> known_order(const Moment& a, const Moment& b, std::string* why_not = nullptr);
  // The same with the motion as precise as it takes: nothing where the bits do not suffice.
  std::optional<int> order(const Moment& a, const Moment& b, std::string& why_not);

  // Whether a moment is no further than the tolerance from the time. Throws Undecided.
  bool within(const Rational& tolerance, const Moment& m, const Rational& t);

  // The moment as double-doubles tell: tight.
  Moment instant(const Moment& m) const;

  // begin_present(): from now on events happen at another instant than those before. note_present()
  // and note_flip() then note a flip or contact that is proved to happen at that instant, before
  // the motion changes.
  void begin_present();
  void note_present(const Moment& m);
  void note_flip(const Quad& q) { present_.flips.push_back(states_of(motion_, q)); }
  // Notes what the collisions of the instant have to do with each other, after they have happened.
  void note_collisions(const Moment& m);
  // A moment at the present instant as the searches take it, with what is known to happen at it.
  Moment present(const Moment& m) const;
  // Flips and contacts known to happen at the present instant.
  const Coincidence& known() const { return present_; }

  DdBall narrow(const Moment& m) const;  // as double-doubles tell
  Ball ball(const Moment& m) const;      // to as many bits as the motion is known to
  std::array<double, 2> enclosure(const Moment& m) const;  // as balls tell

 private:
  bool same_by_symmetry(const Moment& a, const Moment& b) const;
  // As known_order(), of two whose enclosures do not tell.
  std::optional<int> known_order_of_near(const Moment& a, const Moment& b, std::string* why_not);
  std::optional<int> by_balls(const Moment& a, const Moment& b) const;

  Motion& motion_;
  const CollapseSearch& collapses_;
  const ContactSearch& contacts_;
  TierCounts& counts_;
  Coincidence present_;
};

}  // namespace voroproof::internal
