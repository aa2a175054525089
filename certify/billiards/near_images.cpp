#include "certify/billiards/near_images.h"

#include <algorithm>
#include <cstddef>

namespace voroproof::internal {

std::vector<LatticeImage> NearImages::all(const BilliardPair& pair, const Flight<Rational>& a,
                                          const Flight<Rational>& b, const Rational& t) const {
  if (pair.a < 0 || !billiard_.lattice.is_periodic()) return {LatticeImage{}};
  const Vec3 d = gaps_.place(pair.b, b, t) - gaps_.place(pair.a, a, t);
  const auto nearest = [&](std::size_t axis, const Rational& x) {
    const Rational& side = billiard_.lattice.sides[axis];
    if (side == 0) return 0;
    const Rational shifted = Rational(1, 2) - x / side;
    Integer k;
    mpz_fdiv_q(k.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
    return k.fits_sint_p() ? static_cast<int>(k.get_si()) : 0;
  };
  const auto reach = [&](std::size_t axis) { return billiard_.lattice.sides[axis] == 0 ? 0 : 1; };
  std::vector<LatticeImage> images;
  const int z = nearest(2, d[2]), y = nearest(1, d[1]);
  for (int dz = -reach(2); dz <= reach(2); ++dz) {
    for (int dy = -reach(1); dy <= reach(1); ++dy) {
      const LatticeImage row{0, y + dy, z + dz};
      const int x = nearest(0, d[0] + gaps_.drift(row)[0] * t);
      for (int dx = -reach(0); dx <= reach(0); ++dx) images.push_back({x + dx, row[1], row[2]});
    }
  }
  return images;
}

LatticeImage NearImages::nearest(const BilliardPair& pair, const Flight<Rational>& a,
                                 const Flight<Rational>& b, const Rational& t) const {
  const std::vector<LatticeImage> images = all(pair, a, b, t);
  if (images.size() == 1) return images.front();
  const Vec3 d = gaps_.place(pair.b, b, t) - gaps_.place(pair.a, a, t);
  const auto distance2 = [&](const LatticeImage& image) {
    const Vec3 moved = d + gaps_.offset(image, t);
    return Rational(dot(moved, moved));
  };
  return *std::min_element(images.begin(), images.end(),
                           [&](const LatticeImage& k, const LatticeImage& other) {
                             return distance2(k) < distance2(other);
                           });
}

}  // namespace voroproof::internal
