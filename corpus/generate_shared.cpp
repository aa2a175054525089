#include "corpus/generate_shared.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace voroproof::internal {

Vec polar(double angle, double length) {
  Real cosine(0), sine(0), argument(angle);
  mpfr_sin_cos(sine, cosine, argument, MPFR_RNDN);
  return {cosine.times(length), sine.times(length)};
}

double sine(double angle) {
  Real value(angle);
  mpfr_sin(value, value, MPFR_RNDN);
  return mpfr_get_d(value, MPFR_RNDN);
}

std::string text(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return std::string(buffer, end);
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

bool finite_and_positive(double x) { return std::isfinite(x) && x > 0; }
bool finite_and_not_negative(double x) { return std::isfinite(x) && x >= 0; }

Scene empty_scene(std::string family, int n, std::uint64_t seed, double container_radius,
                  double horizon) {
  Scene scene;
  scene.container_radius = to_rational(container_radius);
  scene.horizon = to_rational(horizon);
  scene.name = std::move(family) + "-n" + std::to_string(n) + "-seed" + std::to_string(seed);
  scene.seed = Integer(std::to_string(seed));
  scene.disks.reserve(n);
  return scene;
}

void add_disk(Scene& scene, Vec centre, double radius, Vec velocity) {
  DiskInput disk;
  disk.x = centre.x;
  disk.y = centre.y;
  disk.radius = radius;
  disk.vx = velocity.x;
  disk.vy = velocity.y;
  disk.mass = square(disk.radius);
  scene.disks.push_back(std::move(disk));
}

}  // namespace voroproof::internal
