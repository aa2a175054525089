// Circles tangent to three generators, in 200-digit arithmetic.
//
// A circle of centre x and radius rho that touches a disk (c, r) from outside has
// |x - c| = rho + r; one that touches the container (O, R) from inside has |x - O| = R - rho.
// Squared, and with the offset w = r for a disk and w = -R for the container, both read
//   |x - c|^2 = (rho + w)^2.
// With u = x - c_i and s = rho + w_i, the differences of the equations of j and k to that of i
// are two planes in (u, s) space, and the equation of i is the cone |u|^2 = s^2: the tangent
// circles are where the line common to the planes meets the cone.
#pragma once

#include <vector>

#include "tests/oracle/circle.h"

namespace voroproof::oracle {

using Work = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<200>,
                                           boost::multiprecision::et_off>;

// Distances below this, the container's radius being between 1/2 and 1, count as zero.
const Work& contact_tolerance();  // 1e-60

// A circle in the normalized frame of `Generators`.
struct TangentCircle {
  Work x, y, radius;
};

// Whether centres and radii of two circles differ by less than the contact tolerance.
bool coincide(const TangentCircle& a, const TangentCircle& b);

// Disks 0 ... n-1 and the container -1, moved and scaled by a power of two so that the
// container has its centre at the origin and a radius in [1/2, 1).
class Generators {
 public:
  // Throws std::invalid_argument unless the container's radius is positive.
  Generators(const std::vector<Circle>& disks, const Circle& container);

  int disk_count() const { return static_cast<int>(sites_.size()) - 1; }

  // Every circle of positive radius that is tangent to the generators i, j and k, outside the
  // disks and inside the container among them: none, one or two. Other generators are ignored.
  std::vector<TangentCircle> tangent_circles(int i, int j, int k) const;

  // How far `circle` is from the generator: zero when tangent, negative when it enters the disk
  // or leaves the container.
  Work gap(int generator, const TangentCircle& circle) const;

  // Whether some generator's gap is so negative that plain doubles show it. The circle must not
  // be larger than the container.
  bool clearly_not_empty(const TangentCircle& circle) const;

  // Unit vector from the centre of a circle tangent to the generator towards their contact.
  std::array<Work, 2> contact_direction(int generator, const TangentCircle& circle) const;

  // The same contact as a direction (of any length) seen from the generator's own centre.
  std::array<Work, 2> direction_from_centre(int generator, const TangentCircle& circle) const;

  // Whether the contacts of i, j and k follow each other counterclockwise.
  bool counterclockwise(int i, int j, int k, const TangentCircle& circle) const;

  // Throws std::invalid_argument when a radius is negative, when generators overlap by more
  // than the tolerance, or when a point (radius 0) touches another generator: then the two
  // tangent circles of a vertex coincide and contact orders mean nothing.
  void check_disjoint() const;

  // The circle in the caller's frame.
  Circle restored(const TangentCircle& circle) const;

 private:
  struct Site {
    Work x, y, offset;
    double approximate_x, approximate_y, approximate_offset;
  };
  const Site& site(int generator) const { return sites_[static_cast<std::size_t>(generator + 1)]; }

  Work origin_x_, origin_y_;
  int exponent_ = 0;  // normalized length = length * 2^-exponent
  std::vector<Site> sites_;
};

}  // namespace voroproof::oracle
