#include "filtered/search/contact.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/rounding.h"
#include "filtered/motion/rough_site.h"
#include "filtered/search/ladder.h"

namespace voroproof::internal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The delay from the reference time to the contact, where the signs are certain.
// nullopt: not decided. A result with `none` set: there is no contact.
template <class T>
struct Delay {
  bool none = false;
  T s;
};

template <class T>
std::optional<Delay<T>> delay(const Contact<T>& k, bool wall, bool points, const T& zero) {
  const Sign b = sign(k.b);
  if (wall) {
    // c <= 0: the disk is inside, and leaves wherever it moves at all.
    if (sign(k.a) == Sign::zero) return Delay<T>{true, zero};
    const T disc = k.b * k.b - k.a * k.c;
    if (sign(disc) != Sign::positive) return std::nullopt;
    const T root = sqrt(disc);
    if (b == Sign::positive) return Delay<T>{false, -k.c / (k.b + root)};
    return Delay<T>{false, (root - k.b) / k.a};
  }
  if (b == Sign::positive || b == Sign::zero) return Delay<T>{true, zero};
  if (b != Sign::negative) return std::nullopt;
  const T disc = k.b * k.b - k.a * k.c;
  const Sign s = sign(disc);
  if (s == Sign::zero && points) return std::nullopt;  // they meet: see exactly()
  if (s == Sign::negative || s == Sign::zero) return Delay<T>{true, zero};
  if (s != Sign::positive) return std::nullopt;
  return Delay<T>{false, k.c / (sqrt(disc) - k.b)};
}

// Two generators of radius zero, as far as doubles tell: the container is none.
bool are_points(const Motion& motion, GenId i, GenId j) {
  return motion.doubles(i).r == 0 && motion.doubles(j).r == 0;
}

// Two disks in plain doubles with error bounds, at a time or within h of it. Per coordinate the
// offset d errs by eta, at most the errors of both centres and u R, R = |dx| + |dy|; the velocity w
// by omega, likewise, with W. Roundings of the bounds are paid for by the last factors.
struct RoughPair {
  static constexpr double u = unit_roundoff, up = 1 + 0x1p-40, tiny = 0x1p-900;
  double dx, dy, R, eta, reach, rho;

  RoughPair(const DoubleMotion& mi, const DoubleMotion& mj, double t, double h) {
    const RoughSite<double> i = rough_site(mi, t, h), j = rough_site(mj, t, h);
    dx = j.at.x - i.at.x;
    dy = j.at.y - i.at.y;
    R = std::fabs(dx) + std::fabs(dy);
    eta = i.error + j.error + u * R;
    reach = i.at.r + j.at.r;
    rho = mi.ex + mj.ex + u * reach;
  }
  // |d|^2 - reach^2, from the inputs 2 (R + eta) eta + 2 (reach + rho) rho, from roundings 4 u of
  // the sum of the squares.
  double c() const { return dx * dx + dy * dy - reach * reach; }
  double c_error() const {
    return (2 * (R + eta) * eta + 2 * (reach + rho) * rho + 4 * u * (R * R + reach * reach)) * up +
           tiny;
  }
  bool apart() const { return c() > c_error(); }

  // The next contact of the two, with a = |w|^2 and b = d.w, w their relative velocity. There is
  // certainly none where they do not approach (b > 0), or pass each other (the discriminant b^2 - a
  // c is negative). It comes after the delay c / (sqrt(b^2 - a c) - b), which lies between the
  // quotients of the bounds; less than 8 u for the roundings of these.
  struct Meeting {
    enum class Kind { none, after, unknown };
    Kind kind = Kind::unknown;
    double lo = 0, hi = 0;  // the delay
  };
  Meeting meeting(const DoubleMotion& mi, const DoubleMotion& mj) const {
    using Kind = Meeting::Kind;
    const double wx = mj.vx - mi.vx, wy = mj.vy - mi.vy, W = std::fabs(wx) + std::fabs(wy);
    const double omega = mi.ev + mj.ev + u * W;
    // The error of b: R omega + W eta + 2 eta omega comes from the inputs, 3 u R W from two
    // products and a sum.
    const double b = dx * wx + dy * wy;
    const double e_b = (R * omega + W * eta + 2 * eta * omega + 3 * u * R * W) * up + tiny;
    if (b > e_b) return {Kind::none};
    const double a = wx * wx + wy * wy, k = c(), size = std::fabs(k);
    const double e_a = (2 * (W + omega) * omega + 3 * u * W * W) * up + tiny, e_c = c_error();
    const double e = ((2 * std::fabs(b) + e_b) * e_b + a * e_c + size * e_a + e_a * e_c +
                      4 * u * (b * b + a * size)) *
                         up +
                     tiny;
    const double discriminant = b * b - a * k;
    if (discriminant < -e) return {Kind::none};
    if (!(b < -e_b && discriminant > e && k > e_c)) return {};
    const double least = (k - e_c) / (std::sqrt(discriminant + e) + (e_b - b));
    const double most = (k + e_c) / (std::sqrt(discriminant - e) - (e_b + b));
    return {Kind::after, least * (1 - 0x1p-50), most * (1 + 0x1p-50)};
  }
};

// These go further than rounding may have changed a time x that is not negative.
double down(double x) { return x * (1 - 0x1p-51); }
double up(double x) { return x * (1 + 0x1p-51); }

// Whether [lo, hi] will do as the enclosure of a contact: one does that is short beside the delay,
// or as short as doubles are there; one that reaches the present does not.
bool is_answer(const Moment& now, double lo, double hi) {
  return lo > now.hi && hi - lo < std::fmax(0x1p-20 * (lo - now.hi), 0x1p-40 * hi);
}

Ball hull_of(double lo, double hi, int bits) {
  Ball t(Rational((to_rational(lo) + to_rational(hi)) / 2), bits);
  if (lo < hi) t.widen(Magnitude::of(hi - lo));
  return t;
}

}  // namespace

NextContact ContactSearch::from(GenId i, GenId j, const Moment& now, double end) {
  // Two disks of the same collision leave each other, or stay at rest in contact.
  const bool wall = i == container_id;
  if (!wall && motion_.state_id(i) > 0 && motion_.state_id(i) == motion_.state_id(j)) return {};
  if (motion_.same_velocity(i, j)) return {};
  if (!wall && motion_.options().filters) {
    using Kind = RoughPair::Meeting::Kind;
    const DoubleMotion &mi = motion_.doubles(i), &mj = motion_.doubles(j);
    const auto [kind, least, most] = RoughPair(mi, mj, now.lo, 0).meeting(mi, mj);
    const double lo = down(now.lo + least), hi = up(now.lo + most);
    if (kind == Kind::none || (kind == Kind::after && (lo > end || is_answer(now, lo, hi)))) {
      counts_.count(Predicate::contact_search, Tier::filter);
      if (kind == Kind::none || lo > end) return {};
      return {NextContact::Kind::at, lo, hi};
    }
  }
  return slow(i, j, now, end);
}

namespace {

// The enclosure of a time in doubles.
std::array<double, 2> enclosure(const DoubleBall& t) {
  return {down(t.mid - t.rad), up(t.mid + t.rad)};
}
std::array<double, 2> enclosure(const DdBall& t) {
  return {std::nextafter(t.hi + t.lo - t.rad, -kInfinity),
          std::nextafter(t.hi + t.lo + t.rad, kInfinity)};
}
std::array<double, 2> enclosure(const Ball& t) {
  double lo = 0, hi = 0;
  t.to_interval(lo, hi);
  return {lo, hi};
}

}  // namespace

// The contact by numbers of one kind; `t`: now.lo. Returns nothing where they do not tell it from
// the present, or tell it badly.
template <class T>
std::optional<NextContact> ContactSearch::in(GenId i, GenId j, const Moment& now, double end,
                                             const T& t, const T& zero) const {
  const Contact<T> k(motion_.moving_site(i, t), motion_.moving_site(j, t));
  const auto d = delay(k, i == container_id, are_points(motion_, i, j), zero);
  if (!d) return std::nullopt;
  if (d->none) return NextContact{};
  const auto [lo, hi] = enclosure(t + d->s);
  if (lo > end) return NextContact{};
  if (!is_answer(now, lo, hi)) return std::nullopt;
  return NextContact{NextContact::Kind::at, lo, hi};
}

NextContact ContactSearch::slow(GenId i, GenId j, const Moment& now, double end) {
  Ladder<NextContact> ladder(counts_, Predicate::contact_search);
  if (motion_.options().filters) {
    const Rung doubles{Tier::filter,
                       [&] { return in(i, j, now, end, DoubleBall(now.lo), DoubleBall()); }};
    const Rung dds{Tier::dd, [&] { return in(i, j, now, end, DdBall(now.lo), DdBall()); }};
    if (const auto found = ladder.climb(doubles, dds)) return *found;
  }
  const Rung balls{Tier::ball, [&] {
                     const int bits = motion_.goal_bits() + 32;
                     return in(i, j, now, end, Ball(now.lo, bits), Ball(bits));
                   }};
  const Rung symmetry{Tier::symmetry, [&] { return by_symmetry(i, j, now); }};
  const Rung exact{Tier::exact, [&] { return std::optional(exactly(i, j, now, end)); }};
  if (const auto found = ladder.climb(balls, symmetry, exact)) return *found;
  if (const auto found = ladder.with_more_bits(motion_, balls)) return *found;
  throw Undecided("the next contact of a pair is not decided with " +
                      std::to_string(motion_.options().max_bits) +
                      " bits; exactly: " + ladder.budget(),
                  i, j);
}

// The answer where symmetry proves that neither moves; or that the pair touches now, and the signs
// say that it approaches, or that two disks part.
std::optional<NextContact> ContactSearch::by_symmetry(GenId i, GenId j, const Moment& now) const {
  const bool wall = i == container_id;
  if (motion_.is_rational(i) && motion_.is_rational(j)) return std::nullopt;
  const auto symmetry = motion_.symmetry();
  const PairStates states = states_of(motion_, i, j);
  if (symmetry->at_rest(states[0]) && symmetry->at_rest(states[1])) return NextContact{};
  if (now.present == nullptr) return std::nullopt;
  if (!symmetry->touch(states, now.present->known())) return std::nullopt;
  const Ball t = hull_of(now.lo, now.hi, motion_.goal_bits() + 32);
  const Sign b = sign(Contact<Ball>(motion_.moving_site(i, t), motion_.moving_site(j, t)).b);
  const Sign approach = wall ? Sign::positive : Sign::negative;
  if (b != approach && (wall || b != -approach)) return std::nullopt;
  if (b != approach) return NextContact{};
  return NextContact{NextContact::Kind::now, now.lo, now.hi};
}

NextContact ContactSearch::exactly(GenId i, GenId j, const Moment& now, double end) {
  const bool wall = i == container_id;
  ExactMotion exact(motion_);
  const Rational near = to_rational(now.lo);
  const Contact<Tower> k(exact.moving_site(i, near), exact.moving_site(j, near));
  if (sign(k.a) == Sign::zero) return {};
  const Tower disc = k.b * k.b - k.a * k.c;
  const Sign s = sign(disc);
  if (!wall && s == Sign::zero && sign(exact.radius(i) + exact.radius(j)) == Sign::zero &&
      sign(k.b) == Sign::negative) {
    // Two points meet: announced as a contact, which Motion::collide refuses.
    const auto [lo, hi] = double_interval(Tower(near) - k.b / k.a);
    if (lo > end) return {};
    return {NextContact::Kind::at, std::max(lo, now.hi), std::max(hi, now.hi)};
  }
  if (!wall && s != Sign::positive) return {};
  if (wall && s == Sign::zero) {
    throw Undecided("a disk slides along the container: it has no motion in this model", i, j);
  }
  // A motion that is given may have this: a disk outside the container that never comes in.
  if (s == Sign::negative) return {};
  const Tower root = exact.field().sqrt(disc);
  const Tower delay = wall ? (root - k.b) / k.a : (-root - k.b) / k.a;
  const Tower t = Tower(near) + delay;
  const ExactTime instant = now.exact(exact);
  const auto order = voroproof::internal::compare(time_of(t), instant);
  if (order < 0) return {};  // the pair parts: the root lies behind
  if (order == 0) return {NextContact::Kind::now, now.lo, now.hi};
  const auto [lo, hi] = double_interval(t);
  if (lo > end) return {};
  return {NextContact::Kind::at, lo, hi};
}

bool ContactSearch::certainly_apart(GenId i, GenId j, const Moment& now) const {
  const Sign apart = i == container_id ? Sign::negative : Sign::positive;
  if (motion_.options().filters) {
    if (i != container_id) {
      const double t = 0.5 * (now.lo + now.hi);
      const double h = std::fmax(now.hi - t, t - now.lo) * (1 + 0x1p-50);
      if (RoughPair(motion_.doubles(i), motion_.doubles(j), t, h).apart()) return true;
    }
    const DoubleBall t = DoubleBall::hull(now.lo, now.hi);
    return sign(Contact<DoubleBall>(motion_.moving_site(i, t), motion_.moving_site(j, t)).c) ==
           apart;
  }
  return apart_by_balls(i, j, now);
}

bool ContactSearch::apart_by_balls(GenId i, GenId j, const Moment& now) const {
  const Ball t = hull_of(now.lo, now.hi, motion_.goal_bits() + 32);
  return sign(Contact<Ball>(motion_.moving_site(i, t), motion_.moving_site(j, t)).c) ==
         (i == container_id ? Sign::negative : Sign::positive);
}

DdBall ContactSearch::refine(GenId i, GenId j, double t) const {
  const DdBall at(t);
  const Contact<DdBall> k(motion_.moving_site(i, at), motion_.moving_site(j, at));
  const auto d = delay(k, i == container_id, are_points(motion_, i, j), DdBall());
  if (!d || d->none) return {t, 0, kInfinity};
  return at + d->s;
}

Ball ContactSearch::refine(GenId i, GenId j, const Rational& t, int bits) const {
  const Ball at(t, bits);
  const Contact<Ball> k(motion_.moving_site(i, at), motion_.moving_site(j, at));
  const auto d = delay(k, i == container_id, are_points(motion_, i, j), Ball(bits));
  if (!d || d->none) {
    Ball all(bits);
    all.widen(Magnitude::power_of_two(1 << 20));
    return all;
  }
  return at + d->s;
}

ExactTime ContactSearch::exact_time(GenId i, GenId j, const Rational& near, ExactMotion& exact) {
  const Contact<Tower> k(exact.moving_site(i, near), exact.moving_site(j, near));
  const Tower root = exact.field().sqrt(k.b * k.b - k.a * k.c);
  const Tower s = ((i == container_id ? root : -root) - k.b) / k.a;
  return time_of(Tower(near) + s);
}

}  // namespace voroproof::internal
