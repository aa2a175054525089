// Instants of a history, and their exact order.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "filtered/motion/motion.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"

namespace voroproof::internal {

// An instant, with what it takes to compare it exactly: lo <= instant <= hi.
struct Moment {
  enum class Kind { rational, flip, contact, state };
  Kind kind = Kind::rational;
  double lo = 0, hi = 0;
  std::shared_ptr<const Rational> t;  // rational, where it is no binary64: lo < hi
  Quad quad{};                        // flip: isolated in [lo, hi], or more narrowly:
  std::shared_ptr<const RootInterval> root;
  GenId i = 0, j = 0;  // contact of i and j near lo
  int state = 0;       // state: when generator j began this state
  // The instant, where it is known so well.
  DdBall dd{0, 0, std::numeric_limits<double>::infinity()};

  static Moment at(double t);
  static Moment at(const Rational& t);
  Rational exact() const;  // requires a rational moment
  // When q collapses: `c` is a root.
  static Moment of(const Quad& q, const Collapse& c);
  // When i and j touch: `c` is not `none`.
  static Moment of(GenId i, GenId j, const NextContact& c);
};

// The interval that isolates the root c of a flip polynomial.
std::pair<Rational, Rational> interval_of(const Collapse& c);

// Compares moments. Flips and contacts are those of the present motion of their generators: such a
// moment is of use until one of these changes its motion.
class Chronology {
 public:
  // `beyond_filter` counts the comparisons that doubles and double-doubles do not decide, `counts`
  // what decides them.
  Chronology(Motion& motion, const CollapseSearch& collapses, const ContactSearch& contacts,
             std::int64_t& beyond_filter, TierCounts& counts)
      : motion_(motion),
        collapses_(collapses),
        contacts_(contacts),
        beyond_filter_(beyond_filter),
        counts_(counts) {}

  // Negative, zero or positive. Throws Undecided.
  int compare(const Moment& a, const Moment& b);
  // The order that compare() would give, with the motion as precise as it is: nothing where the
  // motion would have to be more precise. `why_not` says then why the exact comparison failed.
  std::optional<int> known_order(const Moment& a, const Moment& b, std::string* why_not = nullptr);

  // Whether a moment is no further than the tolerance from the time. Throws Undecided.
  bool within(const Rational& tolerance, const Moment& m, const Rational& t);

  // The moment as the searches of filtered/ take it; valid as long as this object.
  Instant instant(const Moment& m) const;

  // begin_present(): from now on events happen at another instant than those before. note_present()
  // and note_flip() then note a flip or contact that is proved to happen at that instant, before
  // the motion changes.
  void begin_present();
  void note_present(const Moment& m);
  void note_flip(const Quad& q);
  // Notes what the collisions of the instant have to do with each other, after they have happened.
  void note_collisions(const Moment& m);
  // A moment at the present instant as the searches take it, with what is known to happen at it.
  Instant present(const Moment& m) const;

  DdBall narrow(const Moment& m) const;  // as double-doubles tell
  Ball ball(const Moment& m) const;      // to as many bits as the motion is known to
  std::array<double, 2> enclosure(const Moment& m) const;  // as balls tell

 private:
  static ExactTime exact_time(const Moment& m, ExactMotion& exact);
  bool same_by_symmetry(const Moment& a, const Moment& b) const;
  // As known_order(), of two whose enclosures do not tell.
  std::optional<int> known_order_of_near(const Moment& a, const Moment& b, std::string* why_not);
  std::optional<int> by_balls(const Moment& a, const Moment& b) const;

  Motion& motion_;
  const CollapseSearch& collapses_;
  const ContactSearch& contacts_;
  std::int64_t& beyond_filter_;
  TierCounts& counts_;
  Coincidence present_;
};

}  // namespace voroproof::internal
