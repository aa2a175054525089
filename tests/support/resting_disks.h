// Sets of disks at rest.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exact/motion_input.h"
#include "exact/rational.h"
#include "tests/support/dice.h"

namespace voroproof::internal::testing {

struct Disk {
  Rational x, y, r;
};
using Disks = std::vector<Disk>;

inline MotionInput input_of(const Disks& disks, const Rational& radius = 10) {
  MotionInput input;
  input.container_radius = radius;
  for (const Disk& d : disks) input.disks.push_back({d.x, d.y, d.r, 0, 0, 1});
  return input;
}

// The lines x = x0, y = y0, x = x1 and y = y1.
struct Walls {
  Rational x0, y0, x1, y1;
};

// For Frame::box.
inline MotionInput input_between(const Disks& disks, const Walls& w) {
  MotionInput input = input_of(disks);
  for (const auto& [x, y] : {std::pair(w.x0, w.y0), {w.x0, w.y0}, {w.x1, w.y1}, {w.x1, w.y1}}) {
    input.disks.push_back({x, y, 0, 0, 0, 1});
  }
  return input;
}

// Whether another disk contains disk g; of equal ones the first is contained by none of them.
inline bool another_contains(const Disks& disks, std::size_t g) {
  for (std::size_t h = 0; h < disks.size(); ++h) {
    const Rational dx = disks[h].x - disks[g].x, dy = disks[h].y - disks[g].y,
                   dr = disks[h].r - disks[g].r;
    const bool equal = dx == 0 && dy == 0 && dr == 0;
    if (h != g && dr >= 0 && dx * dx + dy * dy <= dr * dr && (!equal || h < g)) return true;
  }
  return false;
}

inline std::string text(const Disks& disks) {
  std::string all;
  for (const Disk& d : disks) {
    all += "\n" + d.x.get_str() + " " + d.y.get_str() + " " + d.r.get_str();
  }
  return all;
}

// Centres within [-6, 6], radii up to `largest`, some of them 0.
inline Disks random_disks(Dice& dice, int n, const Rational& largest) {
  constexpr int fine = 1 << 20;
  const auto part = [&] { return Rational(dice(0, fine), fine); };
  Disks disks;
  for (int k = 0; k < n; ++k) {
    const Rational x = part(), y = part(), r = part();
    disks.push_back(
        {12 * x - 6, 12 * y - 6, dice(0, 4) == 0 ? Rational(0) : Rational(largest * r)});
  }
  return disks;
}

// Coordinates and radii from few whole numbers: many disks touch, coincide, or are cotangent.
inline Disks lattice_disks(Dice& dice, int n, int most) {
  Disks disks;
  for (int k = 0; k < n; ++k) {
    disks.push_back({dice(-most, most), dice(-most, most), dice(0, 2)});
  }
  return disks;
}

}  // namespace voroproof::internal::testing
