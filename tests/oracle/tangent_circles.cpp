#include "tests/oracle/tangent_circles.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace voroproof::oracle {
namespace {

struct Vector3 {
  Work x, y, s;
};

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.s - a.s * b.y, a.s * b.x - a.x * b.s, a.x * b.y - a.y * b.x};
}

// The bilinear form whose zero set is the cone x^2 + y^2 = s^2.
Work cone(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y - a.s * b.s; }

// The finite real roots of a t^2 + 2 b t + c, computed without cancellation.
std::vector<Work> roots(const Work& a, const Work& b, const Work& c) {
  const Work discriminant = b * b - a * c;
  if (discriminant < 0) return {};
  const Work root = sqrt(discriminant);
  const Work q = b < 0 ? Work(root - b) : Work(-root - b);
  if (q == 0) return a == 0 ? std::vector<Work>{} : std::vector<Work>{Work(0)};
  if (a == 0) return {c / q};
  return {q / a, c / q};
}

}  // namespace

const Work& contact_tolerance() {
  static const Work tolerance("1e-60");
  return tolerance;
}

bool coincide(const TangentCircle& a, const TangentCircle& b) {
  const Work& tolerance = contact_tolerance();
  return abs(a.x - b.x) < tolerance && abs(a.y - b.y) < tolerance &&
         abs(a.radius - b.radius) < tolerance;
}

Generators::Generators(const std::vector<Circle>& disks, const Circle& container)
    : origin_x_(container.x), origin_y_(container.y) {
  if (!(container.radius > 0))
    throw std::invalid_argument("the container's radius is not positive");
  frexp(Work(container.radius), &exponent_);
  const auto add = [this](const Circle& c, int sign) {
    Site s;
    s.x = ldexp(Work(c.x) - origin_x_, -exponent_);
    s.y = ldexp(Work(c.y) - origin_y_, -exponent_);
    s.offset = sign * ldexp(Work(c.radius), -exponent_);
    s.approximate_x = static_cast<double>(s.x);
    s.approximate_y = static_cast<double>(s.y);
    s.approximate_offset = static_cast<double>(s.offset);
    sites_.push_back(std::move(s));
  };
  sites_.reserve(disks.size() + 1);
  add(container, -1);
  for (const Circle& disk : disks) add(disk, 1);
}

std::vector<TangentCircle> Generators::tangent_circles(int i, int j, int k) const {
  const Site& base = site(i);
  // Each plane is {P : normal . P = level}, P = (u, s).
  const auto plane = [&base](const Site& other, Vector3& normal, Work& level) {
    normal = {other.x - base.x, other.y - base.y, other.offset - base.offset};
    level = cone(normal, normal) / 2;
  };
  Vector3 a, b;
  Work level_a, level_b;
  plane(site(j), a, level_a);
  plane(site(k), b, level_b);

  const Vector3 direction = cross(a, b);
  const Work norm =
      direction.x * direction.x + direction.y * direction.y + direction.s * direction.s;
  if (norm == 0) return {};
  const Vector3 p = cross(b, direction), q = cross(direction, a);
  const Vector3 foot{(level_a * p.x + level_b * q.x) / norm, (level_a * p.y + level_b * q.y) / norm,
                     (level_a * p.s + level_b * q.s) / norm};

  std::vector<TangentCircle> result;
  for (const Work& t : roots(cone(direction, direction), cone(foot, direction), cone(foot, foot))) {
    const TangentCircle circle{base.x + foot.x + t * direction.x, base.y + foot.y + t * direction.y,
                               foot.s + t * direction.s - base.offset};
    if (!(circle.radius > 0)) continue;
    // Squaring also let in circles tangent in the wrong sense, and planes that are parallel but
    // for rounding give a meaningless line: only true tangency passes.
    const Work tolerance = contact_tolerance() * (1 + circle.radius);
    if (abs(gap(i, circle)) <= tolerance && abs(gap(j, circle)) <= tolerance &&
        abs(gap(k, circle)) <= tolerance) {
      result.push_back(circle);
    }
  }
  return result;
}

Work Generators::gap(int generator, const TangentCircle& circle) const {
  const Site& s = site(generator);
  const Work dx = circle.x - s.x, dy = circle.y - s.y;
  const Work distance = sqrt(dx * dx + dy * dy);
  // For the container, offset = -R and the gap is R - distance - radius.
  return generator < 0 ? Work(-s.offset - distance - circle.radius)
                       : Work(distance - s.offset - circle.radius);
}

bool Generators::clearly_not_empty(const TangentCircle& circle) const {
  // All quantities are below 4, so the rounding errors below stay under 1e-14.
  constexpr double margin = 1e-9;
  const double x = static_cast<double>(circle.x), y = static_cast<double>(circle.y),
               radius = static_cast<double>(circle.radius);
  const Site& container = sites_.front();
  if (-container.approximate_offset - std::sqrt(x * x + y * y) - radius < -margin) return true;
  for (std::size_t g = 1; g < sites_.size(); ++g) {
    const Site& s = sites_[g];
    const double dx = x - s.approximate_x, dy = y - s.approximate_y;
    if (std::sqrt(dx * dx + dy * dy) - s.approximate_offset - radius < -margin) return true;
  }
  return false;
}

std::array<Work, 2> Generators::contact_direction(int generator,
                                                  const TangentCircle& circle) const {
  // The divisor is minus the distance of the centres when the generator is the container, whose
  // contact lies on the far side from its centre.
  const Site& s = site(generator);
  const Work signed_distance = circle.radius + s.offset;
  return {(s.x - circle.x) / signed_distance, (s.y - circle.y) / signed_distance};
}

std::array<Work, 2> Generators::direction_from_centre(int generator,
                                                      const TangentCircle& circle) const {
  const Site& s = site(generator);
  return {circle.x - s.x, circle.y - s.y};
}

bool Generators::counterclockwise(int i, int j, int k, const TangentCircle& circle) const {
  const auto a = contact_direction(i, circle), b = contact_direction(j, circle),
             c = contact_direction(k, circle);
  return (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]);
}

void Generators::check_disjoint() const {
  for (int i = 0; i < disk_count(); ++i) {
    const Site& a = site(i);
    if (a.offset < 0) {
      throw std::invalid_argument("the radius of disk " + std::to_string(i) + " is negative");
    }
    const TangentCircle disk{a.x, a.y, a.offset};
    for (int j = -1; j < i; ++j) {
      const Work distance = gap(j, disk);
      const bool disk_with_point = a.offset == 0 || site(j).offset == 0;
      if (disk_with_point ? distance <= contact_tolerance() : distance < -contact_tolerance()) {
        throw std::invalid_argument(
            "generators " + std::to_string(j) + " and " + std::to_string(i) +
            (disk_with_point ? ", one a point, touch or overlap" : " overlap"));
      }
    }
  }
}

Circle Generators::restored(const TangentCircle& circle) const {
  return {Real(ldexp(circle.x, exponent_) + origin_x_),
          Real(ldexp(circle.y, exponent_) + origin_y_), Real(ldexp(circle.radius, exponent_))};
}

}  // namespace voroproof::oracle
