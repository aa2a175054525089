// The recorded path of a disk of a billiard: lines, or parabolas under gravity, from turn to turn.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/compact_rational.h"
#include "filtered/billiards/billiard_gaps.h"
#include "filtered/billiards/number_kinds.h"

namespace voroproof::internal {

Vec3 value_of(const CompactVec3& v);

// A time, exactly and enclosed.
struct BilliardTime {
  CompactRational exact;
  DoubleBall near;
  explicit BilliardTime(const CompactRational& t) : exact(t), near(enclosed(t)) {}
  Rational value() const { return exact.value(); }
};

// A place that is moved along lines, exactly. Nearly all numbers are binary64: what these make is a
// whole number of units that are a power of two.
class ExactPlace {
 public:
  explicit ExactPlace(const Vec3& place);

  // Moves it by velocity * (to - from).
  void move(const CompactVec3& velocity, const CompactRational& from, const CompactRational& to);
  void move(const Vec3& by);

  Vec3 value() const;
  Vector3<DoubleBall> near() const;

 private:
  void add(std::size_t axis, const Integer& units, long exponent);

  std::array<Integer, 3> units_;
  long exponent_ = 0;         // a unit is 2^exponent_
  std::optional<Vec3> rest_;  // the part that is no whole number of units
};

// A piece of a path, from the claim that turned the disk to the next one that does.
struct BilliardLine {
  BilliardTime from;
  CompactVec3 velocity;  // at `from`
  Flight<DoubleBall> near;
  std::int64_t claim = -1;         // by which the disk turned, counted from 0; -1 at the start
  std::optional<BilliardPair> by;  // the collision that it was
  std::int64_t turns = 0;          // claims that turned it, with this one
};

// The lines of one disk in a window of time: the one that it is on at the beginning comes first.
class BilliardPath {
 public:
  // `gravity`: the acceleration on all lines.
  BilliardPath(const BilliardDisk& disk, const Vec3& gravity);

  std::size_t size() const { return lines_.size(); }
  const BilliardLine& operator[](std::size_t k) const { return lines_[k]; }
  const BilliardLine& back() const { return lines_.back(); }

  // The k-th line exactly.
  Flight<Rational> exact(std::size_t k) const;
  Flight<Rational> exact_last() const { return exact(size() - 1); }

  void turn(const BilliardTime& t, const CompactVec3& velocity, std::int64_t claim,
            const std::optional<BilliardPair>& by);
  void forget_all_but_last() { lines_.erase(lines_.begin(), lines_.end() - 1); }

 private:
  // How the place changes on the line up to a time, besides by its velocity.
  Vec3 fall(const BilliardLine& line, const Rational& to) const;

  std::vector<BilliardLine> lines_;
  ExactPlace last_;              // where the last line begins
  std::optional<Vec3> gravity_;  // none where there is no gravity
};

}  // namespace voroproof::internal
