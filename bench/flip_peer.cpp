#include "bench/flip_peer.h"

#include <array>

#include "exact/polynomial.h"
#include "exact/predicates.h"

namespace voroproof::internal::bench {

namespace {

using Path = Site<Polynomial<Rational>>;

Path path_of(const Scene& scene, GenId g) {
  if (g == container_id) {
    return {Polynomial<Rational>{scene.cx}, Polynomial<Rational>{scene.cy},
            Polynomial<Rational>{Rational(-scene.container_radius)}};
  }
  const DiskInput& d = scene.disks[static_cast<std::size_t>(g)];
  return {Polynomial<Rational>{d.x.value(), d.vx.value()},
          Polynomial<Rational>{d.y.value(), d.vy.value()}, Polynomial<Rational>{d.radius.value()}};
}

}  // namespace

std::vector<Integer> flip_polynomial_of(const Scene& scene, const Quad& q) {
  const std::array<Path, 4> p{path_of(scene, q.l), path_of(scene, q.r), path_of(scene, q.s),
                              path_of(scene, q.e)};
  const bool equal_radii = p[0].r == p[1].r && p[0].r == p[2].r && p[0].r == p[3].r;
  return primitive_integers(equal_radii ? cocircularity(p[0], p[1], p[2], p[3])
                                        : cotangency(p[0], p[1], p[2], p[3]));
}

}  // namespace voroproof::internal::bench
