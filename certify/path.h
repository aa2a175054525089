// The path of a disk under the recorded truth: exactly known, piecewise linear.
//
// Claimed times and velocities are binary64 nearly always, and then a position is a sum of products
// of two of them: a dyadic number, held exactly as a short sum of doubles. Where a file or a scene
// gives other numbers, or the sum grows long, the path goes on in rationals.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "exact/compact_rational.h"
#include "filtered/numbers/dd_ball.h"
#include "history/events.h"

namespace voroproof::internal {

class Fingerprint;
class JsonReader;

// A number held exactly as a sum of doubles that do not overlap (J. R. Shewchuk, "Adaptive
// precision floating-point arithmetic and fast robust geometric predicates", Discrete Comput. Geom.
// 18, 1997): each is below the last place of the next.
class DyadicSum {
 public:
  DyadicSum() = default;
  explicit DyadicSum(double x) { part_[0] = x; }

  // Adds v (t - s), exactly. False, and the sum is as before, where it would be too long, or a
  // product is too small or too large for the rounding errors to be doubles.
  bool add_way(double v, double t, double s);

  // An enclosure. The fourth part is less than the last place of the third, so that both together
  // are less than twice the third.
  DdBall near() const { return {part_[0], part_[1], 2 * std::fabs(part_[2])}; }
  Rational exact() const;
  void add_to(Fingerprint& fingerprint) const;  // the sum as it is held
  // From text, a JSON array. Throws InputError where it is no such sum.
  static DyadicSum read(JsonReader& json);

 private:
  friend class ReplayWriter;
  static constexpr int kMax = 4;
  int size() const;

  std::array<double, kMax> part_{};  // greatest first; then zeros
};

// A velocity: `exact` is null where its components are binary64.
struct Velocity {
  Vec2 near{};
  std::shared_ptr<const ExactVec2> exact;

  Velocity() = default;
  explicit Velocity(const Vec2& v) : near(v) {}
  Velocity(const CompactRational& x, const CompactRational& y);
  explicit Velocity(const ExactVec2& v) : Velocity(v[0], v[1]) {}
  ExactVec2 value() const;
  void add_to(Fingerprint& fingerprint) const;
};

// Two lines of a processor's caches.
class alignas(64) Path {
 public:
  // The path from the point (x, y) at time 0.
  Path(const CompactRational& x, const CompactRational& y, const Velocity& v);

  // The path since its last turn, at time t.
  Path(double t, const DyadicSum& x, const DyadicSum& y, const Velocity& v)
      : t_(t), x_(x), y_(y), velocity_(v) {}
  Path(const Rational& t, const ExactVec2& p, const Velocity& v)
      : velocity_(v), exact_(std::make_shared<const Exact>(Exact{t, p})) {}

  // From the time t on, no earlier than the last, the disk goes on with velocity v.
  void turn(double t, const Velocity& v);
  void turn(const Rational& t, const Velocity& v);

  const Velocity& velocity() const { return velocity_; }
  Rational since() const;  // the time of the last turn
  double since_up() const { return exact_ ? round_up(exact_->t) : t_; }  // not below it
  ExactVec2 at(const Rational& t) const;
  // Where the last turn was and at what time, if the path is one of binary64 values.
  struct Start {
    double t;
    DdBall x, y;
  };
  std::optional<Start> start() const;
  // An enclosure of the position at time t, on such a path.
  std::optional<std::array<DdBall, 2>> near(double t) const;
  void add_to(Fingerprint& fingerprint) const;

 private:
  friend class ReplayWriter;
  struct Exact {
    Rational t;
    ExactVec2 p;
  };
  double t_ = 0;
  DyadicSum x_, y_;
  Velocity velocity_;
  std::shared_ptr<const Exact> exact_;  // where it is not in binary64: instead of t_, x_, y_
};

}  // namespace voroproof::internal
