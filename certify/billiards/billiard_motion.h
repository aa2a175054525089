// The true motion of a billiard, as far as it is known: the disks turn by the law where they touch.
// Who touches next it is told.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/billiards/true_path.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {

// The lines on which two are; of a wall and a disk both are that of the disk.
struct PairLines {
  const BilliardPair& pair;
  const TrueLine &a, &b;
};

class BilliardMotion {
 public:
  // Both must outlive it. `horizon`: no contact is looked for after it.
  BilliardMotion(const Billiard& billiard, const Rational& horizon, const MotionOptions& options);

  const std::vector<TruePath>& paths() const { return paths_; }
  const BilliardGaps<Rational>& exact() const { return exact_; }
  const BilliardGaps<DoubleBall>& near() const { return near_; }
  int bits() const { return bits_; }
  TrueTime time(const Rational& t) const { return {t, bits_}; }
  bool is_fixed(GenId i) const {
    return i < 0 || billiard_.disks[static_cast<std::size_t>(i)].fixed;
  }

  // The last lines of the pair.
  PairLines last(const BilliardPair& pair) const;
  // Whether these lines begin where the two have collided with each other.
  bool have_met(const BilliardPair& pair, const TrueLine* a, const TrueLine* b) const;
  // Two that have collided cannot meet again on the same lines: their gap is convex, or linear.
  bool part_for_good(const BilliardPair& pair) const;

  // When the later of the two lines begins.
  TrueTime since(const PairLines& on) const { return later(on.a.from, on.b.from); }
  // The later of two times; where that is not told, one that encloses both.
  TrueTime later(const TrueTime& x, const TrueTime& y) const;
  TrueTime earlier(const TrueTime& x, const TrueTime& y) const;

  // The first time in [from, until], and up to the horizon, at which the two touch and approach, or
  // overlap. `from` is since(), or later than where they have met. Throws TooCoarse, and Undecided
  // where they are in touch and pressed together.
  std::optional<TrueTime> contact(const PairLines& on, const TrueTime& from,
                                  const Rational& until) const;
  // Whether their gap is zero, exactly.
  bool touch(const PairLines& on, const Rational& t) const;

  // Centres and velocities at a collision; of a wall none.
  template <class T>
  struct Bounce {
    std::array<Vector3<T>, 2> p, before, after;
  };
  // By the law of collision, of two that touch at t.
  Bounce<Ball> bounce(const BilliardPair& pair, const TrueTime& t) const;
  // The centre of a disk on its last line, and its velocity.
  Vector3<Ball> place(GenId disk, const TrueTime& t) const;
  Vector3<Ball> velocity(GenId disk, const TrueTime& t) const;

  // The two have contact() on their last lines, which was looked for up to `until`, and turn; or
  // the disk has that maneuver. `claim`, `line`: see TrueLine.
  void collide(const BilliardPair& pair, const TrueTime& t, const Rational& until,
               std::int64_t claim, std::int64_t line);
  void maneuver(const BilliardManeuver& maneuver, std::int64_t claim, std::int64_t line);

  // Lines that end before t are of no use any more.
  void forget_before(const Rational& t);

  // Computes all anew with twice the bits. Throws Undecided, with the reason, where there are no
  // more; all stays as it is then, and is not tried again.
  void refine(const std::string& reason);

 private:
  struct Turn {
    BilliardPair pair;                 // the one that collides
    const BilliardManeuver* maneuver;  // else null
    double until;
    std::int64_t claim, line;
  };

  TruePath& path(GenId i) { return paths_[static_cast<std::size_t>(i)]; }
  const TrueLine& last(GenId i) const { return paths_[static_cast<std::size_t>(i)].back(); }
  void start();
  void collide(const BilliardPair& pair, const TrueTime& t, const Turn& turn);
  void turn(const BilliardManeuver& maneuver, const Turn& turn);
  void push(GenId disk, TrueLine line);
  template <class T>
  Bounce<T> bounce_of(const BilliardGaps<T>& gaps, const BilliardPair& pair, const Flight<T>& a,
                      const Flight<T>& b, const T& t) const;
  bool are_exact(const PairLines& on, const TrueTime& t) const {
    return on.a.exact && on.b.exact && t.exact;
  }
  std::optional<TrueTime> exact_contact(const PairLines& on, const Rational& from,
                                        const Rational& length) const;
  std::optional<TrueTime> ball_contact(const PairLines& on, const TrueTime& from,
                                       const Rational& length, bool met) const;
  TrueLine line_of(const TrueTime& t, std::optional<Flight<Rational>> exact,
                   Flight<Ball> ball) const;

  const Billiard& billiard_;
  Rational horizon_;
  int bits_, max_bits_;
  bool is_spent_ = false;  // as many bits have been tried as there are
  BilliardGaps<Rational> exact_;
  BilliardGaps<DoubleBall> near_;
  BilliardGaps<Ball> ball_;
  std::vector<TruePath> paths_;
  // By disk: how many lines were of use once, and how many of these there are no more.
  std::vector<std::size_t> forgotten_, dropped_;
  std::vector<Turn> turns_;  // all, in the order in which they were told
};

}  // namespace voroproof::internal
