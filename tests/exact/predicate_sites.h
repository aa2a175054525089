// Four sites for the tests of the predicates: in general position, in every special one, or as a
// list of small integers says.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <ostream>
#include <vector>

#include "exact/predicates.h"
#include "exact/rational.h"
#include "tests/exact/fraction.h"

namespace voroproof::internal::testing {

template <class T>
using Sites = std::array<Site<T>, 4>;

// Four sites, one of which may be the container.
struct Four {
  Sites<Rational> at;
  int wall = -1;  // which, -1 for none
};

inline void showValue(const Four& four, std::ostream& out) {
  for (int k = 0; k < 4; ++k) {
    const Site<Rational>& s = four.at[k];
    out << (k == four.wall ? "container " : "disk ") << s.x << " " << s.y << " radius " << s.r
        << "\n";
  }
}

// A unit vector, by the tangent of half its angle: counterclockwise as that grows.
struct Unit {
  Rational x, y;
};
inline Unit unit(const Rational& half) {
  const Rational square = half * half;
  return {(1 - square) / (1 + square), 2 * half / (1 + square)};
}

// The site of signed radius r at the place where the circle meets it in this direction. That of
// the container is seen on the other side of the circle's centre: rho + r is negative.
inline Site<Rational> set_on(const Site<Rational>& circle, const Unit& to, const Rational& r,
                             const Rational& stretch = 1) {
  const Rational reach = (circle.r + r) * stretch;
  return {circle.x + reach * to.x, circle.y + reach * to.y, r};
}

// What a description of small integers says, one after the other.
class Reader {
 public:
  explicit Reader(const std::vector<int>& numbers) : numbers_(numbers) {}
  int integer() { return numbers_[next_++ % numbers_.size()]; }
  Rational any() {
    constexpr int denominators[] = {1, 1, 2, 3, 5};
    const int n = integer();
    return fraction(n, denominators[std::abs(integer()) % 5]);
  }
  Rational size() { return abs(any()) / 4; }
  Unit direction() { return unit(any() / 3); }

 private:
  const std::vector<int>& numbers_;
  std::size_t next_ = 0;
};

enum class Kind {
  general,
  equal_radii,  // of the disks
  points,
  touching,   // each with the one before it
  contained,  // likewise, but from inside: the tangency vanishes
  collinear,
  cotangent,   // one circle touches all four
  cocircular,  // likewise, the disks of one radius
  on_line,     // a line touches all four
  lattice,     // coincident sites are frequent
};
inline const std::vector<Kind> all_kinds = {
    Kind::general,   Kind::equal_radii, Kind::points,     Kind::touching, Kind::contained,
    Kind::collinear, Kind::cotangent,   Kind::cocircular, Kind::on_line,  Kind::lattice};

inline Four make(Kind kind, int wall, const std::vector<int>& numbers) {
  Reader read(numbers);
  Four four{{}, wall};
  const Site<Rational> circle{read.any(), read.any(), read.size() + 1};
  const Rational common = read.size();
  const Unit line = read.direction();
  for (int k = 0; k < 4; ++k) {
    Site<Rational>& s = four.at[k];
    s = {read.any(), read.any(), read.size()};
    if (kind == Kind::equal_radii || kind == Kind::cocircular) s.r = common;
    if (kind == Kind::points) s.r = 0;
    if (kind == Kind::lattice) {
      s = {read.integer() % 3, read.integer() % 3, std::abs(read.integer() % 2)};
    }
    if (k == wall) s.r = -20 - s.r;
    const Unit to = read.direction();
    if (kind == Kind::cotangent || kind == Kind::cocircular) s = set_on(circle, to, s.r);
    if (kind == Kind::on_line) {
      s = {circle.x + line.x * s.x - line.y * s.r, circle.y + line.y * s.x + line.x * s.r, s.r};
    }
    if (kind == Kind::collinear) s = {circle.x + line.x * s.x, circle.y + line.y * s.x, s.r};
    if (k > 0 && (kind == Kind::touching || kind == Kind::contained)) {
      const Site<Rational>& last = four.at[k - 1];
      const Rational reach = last.r + (kind == Kind::touching ? s.r : Rational(-s.r));
      s = {last.x + reach * to.x, last.y + reach * to.y, s.r};
    }
  }
  return four;
}

// Of any size of the test case.
inline rc::Gen<int> number(int low, int high) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}
inline rc::Gen<std::vector<int>> numbers() {
  return rc::gen::container<std::vector<int>>(48, number(-12, 12));
}
inline rc::Gen<Four> fours(const std::vector<Kind>& kinds = all_kinds) {
  return rc::gen::apply(make, rc::gen::elementOf(kinds), number(-1, 3), numbers());
}

// Disks of which none lies in another, and that reach into the container if there is one.
inline bool are_separate(const Four& four) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      const bool wall = i == four.wall || j == four.wall;
      const Sign wanted = wall ? Sign::negative : Sign::positive;
      if (sign(tangency(four.at[i], four.at[j])) != wanted) return false;
    }
  }
  return true;
}

template <class T>
T f_of(const Sites<T>& at) {
  return cotangency(at[0], at[1], at[2], at[3]);
}
template <class T>
T c_of(const Sites<T>& at) {
  return cocircularity(at[0], at[1], at[2], at[3]);
}

// Three of the four in cyclic order, the first no container.
using Order = std::array<int, 3>;
inline Order disk_leads(const Order& o, int wall) {
  return o[0] == wall ? Order{o[1], o[2], o[0]} : o;
}
template <class T>
TangentTriple<T> triple(const Sites<T>& at, const Order& o, int wall) {
  return {at[o[0]], at[o[1]], at[o[2]], o[1] == wall || o[2] == wall};
}

// Each site as `change` makes it.
template <class Change>
Four changed(const Four& four, Change&& change) {
  Four other = four;
  for (Site<Rational>& s : other.at) s = change(s);
  return other;
}

}  // namespace voroproof::internal::testing
