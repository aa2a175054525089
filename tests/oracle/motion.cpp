#include "tests/oracle/motion.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace voroproof::oracle {
namespace {

template <class Vector>
auto dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1];
}

template <class Vector>
Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

template <class Number, class Vector>
Vector plus_scaled(const Vector& a, const Number& factor, const Vector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1]};
}

// Squared distance minus squared contact distance of two points in relative motion,
// a t^2 + 2 b t + c, with a >= 0.
template <class Number>
struct Separation {
  Number a, b, c;

  template <class Vector>
  Separation(const Vector& offset, const Vector& velocity, const Number& contact_distance)
      : a(dot(velocity, velocity)),
        b(dot(offset, velocity)),
        c(dot(offset, offset) - contact_distance * contact_distance) {}

  Number at(const Number& t) const { return (a * t + 2 * b) * t + c; }

  // When it falls to zero, coming from c >= 0 (but for rounding): the contact of two disks.
  std::optional<Number> falling_root() const {
    const Number discriminant = b * b - a * c;
    if (!(b < 0) || discriminant < 0) return std::nullopt;
    return c / (sqrt(discriminant) - b);
  }

  // When it rises to zero, coming from c <= 0 (but for rounding): the contact with the container.
  std::optional<Number> rising_root() const {
    const Number discriminant = b * b - a * c;
    if (a == 0 || discriminant < 0) return std::nullopt;
    const Number root = sqrt(discriminant);
    return b > 0 ? Number(-c / (b + root)) : Number((root - b) / a);
  }
};

std::string names(int i, int j) { return std::to_string(i) + " and " + std::to_string(j); }

}  // namespace

template <unsigned Digits>
BasicMotionOracle<Digits>::BasicMotionOracle(const MotionScene& scene,
                                             const std::vector<MotionRecord>& records)
    : container_centre_{rounded<Number>(scene.container.x), rounded<Number>(scene.container.y)},
      container_radius_(rounded<Number>(scene.container.radius)),
      wall_restitution_(rounded<Number>(scene.wall_restitution)),
      disk_restitution_(rounded<Number>(scene.disk_restitution)),
      wall_law_(scene.wall_law) {
  for (const MovingDisk& d : scene.disks) {
    const Piece initial{Number(0),
                        {rounded<Number>(d.x), rounded<Number>(d.y)},
                        {rounded<Number>(d.vx), rounded<Number>(d.vy)}};
    bodies_.push_back({rounded<Number>(d.radius), rounded<Number>(d.mass), {initial}});
  }
  for (const MotionRecord& record : records) {
    if (record.maneuver) {
      times_.push_back(apply(*record.maneuver));
    } else if (record.collision) {
      const auto [i, j] = std::minmax(record.collision->i, record.collision->j);
      times_.push_back(i < 0 ? collide_wall(j) : collide_disks(i, j));
    } else {
      throw std::invalid_argument("motion: a record is empty");
    }
  }
}

template <unsigned Digits>
double BasicMotionOracle<Digits>::nearest_double(std::size_t record) const {
  return mpfr_get_d(times_.at(record).backend().data(), MPFR_RNDN);
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::tolerance() const -> Number {
  return container_radius_ * container_radius_ * pow(Number(10), -static_cast<int>(Digits / 3));
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::body(int disk) const -> const Body& {
  if (disk < 0 || static_cast<std::size_t>(disk) >= bodies_.size()) {
    throw std::invalid_argument("motion: there is no disk " + std::to_string(disk));
  }
  return bodies_[static_cast<std::size_t>(disk)];
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::body(int disk) -> Body& {
  return const_cast<Body&>(std::as_const(*this).body(disk));
}

// ---- Reading the paths ----

template <unsigned Digits>
auto BasicMotionOracle<Digits>::piece_at(int disk, const Number& t) const -> const Piece& {
  const std::vector<Piece>& path = body(disk).path;
  const auto after = std::upper_bound(path.begin(), path.end(), t,
                                      [](const Number& x, const Piece& p) { return x < p.start; });
  return after == path.begin() ? path.front() : *(after - 1);
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::position(int disk, const Number& t) const -> Vector {
  const Piece& piece = piece_at(disk, t);
  return plus_scaled(piece.at, Number(t - piece.start), piece.v);
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::velocity(int disk, const Number& t) const -> Vector {
  return piece_at(disk, t).v;
}

template <unsigned Digits>
std::vector<Circle> BasicMotionOracle<Digits>::disks_at(const Number& t) const {
  std::vector<Circle> disks;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Vector p = position(static_cast<int>(i), t);
    disks.push_back({Real(p[0]), Real(p[1]), Real(bodies_[i].radius)});
  }
  return disks;
}

// ---- Events ----

template <unsigned Digits>
void BasicMotionOracle<Digits>::add_piece(int disk, const Number& t, const Vector& v) {
  std::vector<Piece>& path = body(disk).path;
  const Piece& last = path.back();
  const Vector at = plus_scaled(last.at, Number(t - last.start), last.v);
  path.push_back({t, at, v});
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::collide_disks(int i, int j) -> Number {
  if (i == j) throw std::invalid_argument("motion: a disk collides with itself");
  const Body &a = body(i), &b = body(j);
  const Number since = std::max(a.path.back().start, b.path.back().start);
  const Vector offset = minus(position(j, since), position(i, since));
  const Vector relative = minus(b.path.back().v, a.path.back().v);
  const Separation<Number> separation(offset, relative, Number(a.radius + b.radius));
  const auto root = separation.falling_root();
  if (!root) throw std::invalid_argument("motion: disks " + names(i, j) + " do not meet");
  if (separation.c < -tolerance()) {
    throw std::invalid_argument("motion: disks " + names(i, j) + " overlap already");
  }

  // Touching already: rounding must not put the contact into the past.
  const Number wait = std::max(Number(0), *root);
  const Number t = since + wait;
  const Vector n = plus_scaled(offset, wait, relative);
  const Number impulse = (1 + disk_restitution_) * dot(relative, n) / dot(n, n) / (a.mass + b.mass);
  const Vector v_i = plus_scaled(a.path.back().v, Number(b.mass * impulse), n);
  const Vector v_j = plus_scaled(b.path.back().v, Number(-a.mass * impulse), n);
  add_piece(i, t, v_i);
  add_piece(j, t, v_j);
  return t;
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::collide_wall(int i) -> Number {
  const Body& a = body(i);
  const Piece& last = a.path.back();
  const Vector offset = minus(last.at, container_centre_);
  const Separation<Number> separation(offset, last.v, Number(container_radius_ - a.radius));
  const auto root = separation.rising_root();
  if (!root) {
    throw std::invalid_argument("motion: disk " + std::to_string(i) + " does not meet the wall");
  }
  if (separation.c > tolerance()) {
    throw std::invalid_argument("motion: disk " + std::to_string(i) + " is outside already");
  }

  const Number wait = std::max(Number(0), *root);
  const Number t = last.start + wait;
  const Vector n = plus_scaled(offset, wait, last.v);
  const Number normal_part = dot(last.v, n) / dot(n, n);
  Vector v;
  if (wall_law_ == WallLaw::normal) {
    v = plus_scaled(last.v, Number(-(1 + wall_restitution_) * normal_part), n);
  } else {
    const Vector reflected = plus_scaled(last.v, Number(-2 * normal_part), n);
    v = {wall_restitution_ * reflected[0], wall_restitution_ * reflected[1]};
  }
  add_piece(i, t, v);
  return t;
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::apply(const ManeuverRecord& record) -> Number {
  const Number t = rounded<Number>(record.t);
  if (t < body(record.i).path.back().start) {
    throw std::invalid_argument("motion: a maneuver of disk " + std::to_string(record.i) +
                                " comes before an earlier event of it");
  }
  add_piece(record.i, t, {rounded<Number>(record.vx), rounded<Number>(record.vy)});
  return t;
}

// ---- Overlaps ----

template <unsigned Digits>
void BasicMotionOracle<Digits>::examine_pair(int i, int j, const Number& t0, const Number& t1,
                                             std::optional<Contact>& first) const {
  const bool wall = i < 0;
  std::vector<Number> cuts{t0, t1};
  const auto cut_at_pieces = [&](int disk) {
    for (const Piece& piece : body(disk).path) {
      if (t0 < piece.start && piece.start < t1) cuts.push_back(piece.start);
    }
  };
  cut_at_pieces(j);
  if (!wall) cut_at_pieces(i);
  std::sort(cuts.begin(), cuts.end());

  const Number slack = tolerance();
  const Number contact_distance =
      wall ? Number(container_radius_ - body(j).radius) : Number(body(i).radius + body(j).radius);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Number& start = cuts[k];
    const Number length = cuts[k + 1] - start;
    const Vector other = wall ? container_centre_ : position(i, start);
    const Vector other_v = wall ? Vector{Number(0), Number(0)} : velocity(i, start);
    const Separation<Number> separation(minus(position(j, start), other),
                                        minus(velocity(j, start), other_v), contact_distance);
    // A convex function of time: the container is left first at an end of the piece, two disks
    // come closest in its middle or at an end.
    Number begins(0);
    if (wall) {
      if (separation.c <= slack) {
        if (separation.at(length) <= slack) continue;
        begins = separation.rising_root().value_or(length);
      }
    } else {
      const Number closest =
          separation.b < 0 ? std::min(length, Number(-separation.b / separation.a)) : Number(0);
      if (separation.at(closest) >= -slack) continue;
      begins = separation.falling_root().value_or(closest);
    }
    const Number t = std::clamp(Number(start + begins), t0, t1);
    if (!first || t < first->t) first = Contact{t, i, j};
    return;
  }
}

template <unsigned Digits>
auto BasicMotionOracle<Digits>::first_missed_contact(const Number& t0, const Number& t1) const
    -> std::optional<Contact> {
  std::optional<Contact> first;
  const int n = static_cast<int>(bodies_.size());
  for (int i = -1; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) examine_pair(i, j, t0, t1, first);
  }
  return first;
}

template class BasicMotionOracle<300>;
template class BasicMotionOracle<1000>;

}  // namespace voroproof::oracle
