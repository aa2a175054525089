#include "filtered/billiards/billiard_gaps.h"

#include "filtered/billiards/number_kinds.h"

namespace voroproof::internal {
namespace {

bool has_gravity(const Billiard& billiard) {
  for (const Rational& x : billiard.gravity)
    if (x != 0) return true;
  return false;
}

}  // namespace

template <class T>
BilliardGaps<T>::BilliardGaps(const Billiard& billiard, int bits)
    : falls_(has_gravity(billiard)),
      round_(billiard.round.has_value()),
      gravity_(of_kind<T>(billiard.gravity, bits)),
      sides_(of_kind<T>(billiard.lattice.sides, bits)),
      restitution_(of_kind<T>(billiard.restitution, bits)),
      shear_(of_kind<T>(billiard.lattice.shear, bits)) {
  if (round_) {
    center_ = of_kind<T>(billiard.round->center, bits);
    radius_ = of_kind<T>(billiard.round->radius, bits);
    round_restitution_ = of_kind<T>(billiard.round->restitution, bits);
  }
  for (const BilliardDisk& d : billiard.disks) {
    disks_.push_back({of_kind<T>(d.radius, bits), of_kind<T>(d.growth, bits),
                      of_kind<T>(d.mass, bits), d.fixed});
  }
  for (const BilliardWall& w : billiard.walls) {
    walls_.push_back({of_kind<T>(w.normal, bits), of_kind<T>(w.offset, bits),
                      of_kind<T>(w.speed, bits), of_kind<T>(w.restitution, bits)});
  }
}

template <class T>
int BilliardGaps<T>::degree(const BilliardPair& pair) const {
  if (!falls_) return 2;
  if (pair.a < 0) return round_ ? 4 : 2;
  return disk(pair.a).fixed != disk(pair.b).fixed ? 4 : 2;
}

template <class T>
Vector3<T> BilliardGaps<T>::fall(const T& t) const {
  return gravity_ * T(t * t / whole<T>(2));
}

template <class T>
Vector3<T> BilliardGaps<T>::place(GenId i, const Flight<T>& flight, const T& t) const {
  const T passed = t - flight.t0;
  Vector3<T> x = flight.x + flight.v * passed;
  if (falls_ && !disk(i).fixed) x = x + gravity_ * T(passed * passed / whole<T>(2));
  return x;
}

template <class T>
Vector3<T> BilliardGaps<T>::velocity(GenId i, const Flight<T>& flight, const T& t) const {
  if (!falls_ || disk(i).fixed) return flight.v;
  return flight.v + gravity_ * T(t - flight.t0);
}

template <class T>
Vector3<T> BilliardGaps<T>::offset(const LatticeImage& k, const T& t) const {
  Vector3<T> offset{whole<T>(0), whole<T>(0), whole<T>(0)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (k[axis] != 0) offset[axis] = whole<T>(k[axis]) * sides_[axis];
  }
  if (k[1] != 0) offset[0] = offset[0] + drift(k)[0] * t;
  return offset;
}

template <class T>
Vector3<T> BilliardGaps<T>::drift(const LatticeImage& k) const {
  if (k[1] == 0) return {whole<T>(0), whole<T>(0), whole<T>(0)};
  return {T(whole<T>(k[1]) * shear_ * sides_[1]), whole<T>(0), whole<T>(0)};
}

template <class T>
T BilliardGaps<T>::reach(const BilliardPair& pair, const T& t) const {
  const Disk& b = disk(pair.b);
  const T radius = b.radius + b.growth * t;
  if (pair.a < 0) return radius_ - radius;
  const Disk& a = disk(pair.a);
  return radius + a.radius + a.growth * t;
}

template <class T>
GapForm<T> BilliardGaps<T>::form(const BilliardPair& pair, const Flight<T>& a, const Flight<T>& b,
                                 const T& since, const T& depth) const {
  const T zero = whole<T>(0);
  GapForm<T> form{zero, zero, zero, zero, zero};
  Vector3<T> d = place(pair.b, b, since), v = velocity(pair.b, b, since);
  T fall = falls_ && !disk(pair.b).fixed ? T(whole<T>(1) / whole<T>(2)) : zero;
  if (pair.a < 0 && !round_) {
    const Wall& w = wall(pair.a);
    const Disk& of = disk(pair.b);
    form[0] = dot(w.normal, d) - w.offset - w.speed * since - of.radius - of.growth * since + depth;
    form[1] = dot(w.normal, v) - w.speed - of.growth;
    if (falls_) form[2] = dot(w.normal, gravity_) * fall;
    return form;
  }
  T rate;
  if (pair.a < 0) {
    d = d - center_;
    rate = zero - disk(pair.b).growth;
  } else {
    if (pair.image != LatticeImage{}) {
      d = d + offset(pair.image, since);
      v = v + drift(pair.image);
    }
    d = d - place(pair.a, a, since);
    v = v - velocity(pair.a, a, since);
    rate = disk(pair.a).growth + disk(pair.b).growth;
    if (falls_ && !disk(pair.a).fixed) fall = fall - whole<T>(1) / whole<T>(2);
    if (disk(pair.a).fixed == disk(pair.b).fixed) fall = zero;
  }
  // The reach is from inside in a round frame: then a gap that is deeper needs a greater one.
  const bool inside = pair.a < 0;
  const T reach_now = inside ? T(reach(pair, since) + depth) : T(reach(pair, since) - depth);
  const T two = whole<T>(2);
  if (!falls_) {
    form[0] = dot(d, d) - reach_now * reach_now;
    form[1] = two * T(dot(d, v) - reach_now * rate);
    form[2] = dot(v, v) - rate * rate;
  } else {
    // |d + v u + g u^2|^2 less the square of the reach.
    const Vector3<T> g = gravity_ * fall;
    form[0] = dot(d, d) - reach_now * reach_now;
    form[1] = two * T(dot(d, v) - reach_now * rate);
    form[2] = dot(v, v) + two * dot(d, g) - rate * rate;
    form[3] = two * dot(v, g);
    form[4] = dot(g, g);
  }
  if (inside) {
    for (T& c : form) c = zero - c;
  }
  return form;
}

template <class T>
typename BilliardGaps<T>::Response BilliardGaps<T>::response(const BilliardPair& pair,
                                                             const std::array<Vector3<T>, 2>& p,
                                                             const std::array<Vector3<T>, 2>& v,
                                                             const T& t) const {
  const Disk& b = disk(pair.b);
  const T one = whole<T>(1), zero = whole<T>(0);
  if (pair.a < 0 && !round_) {
    const Wall& w = wall(pair.a);
    const T rate = dot(v[1], w.normal) - w.speed - b.growth;
    return {zero, T(zero - (one + w.restitution) * rate), w.normal, one};
  }
  if (pair.a < 0) {
    const Vector3<T> n = p[1] - center_;
    const T n2 = dot(n, n);
    if (sign(n2) == Sign::zero) return {zero, zero, n, n2};
    const T rate = dot(v[1], n) + b.growth * reach(pair, t);
    return {zero, T(zero - (one + round_restitution_) * rate / n2), n, n2};
  }
  const Disk& a = disk(pair.a);
  const Vector3<T> n = p[1] + offset(pair.image, t) - p[0];
  const T n2 = dot(n, n);
  if (sign(n2) == Sign::zero) return {zero, zero, n, n2};
  const Vector3<T> w = v[1] + drift(pair.image) - v[0];
  const T q = (one + restitution_) * T(dot(w, n) - (a.growth + b.growth) * reach(pair, t)) / n2;
  // Both are fixed: nothing changes.
  const T share_a = a.fixed ? zero : b.fixed ? one : T(b.mass / T(a.mass + b.mass));
  const T share_b = b.fixed ? zero : a.fixed ? one : T(a.mass / T(a.mass + b.mass));
  return {T(q * share_a), T(zero - q * share_b), n, n2};
}

template class BilliardGaps<Rational>;
template class BilliardGaps<DoubleBall>;
template class BilliardGaps<Ball>;

DoubleBall value_at(const GapForm<DoubleBall>& form, double u) {
  DoubleBall value = form.back();
  for (std::size_t k = form.size() - 1; k-- > 0;) value = value * DoubleBall(u) + form[k];
  return value;
}

GapForm<DoubleBall> derivative(const GapForm<DoubleBall>& form) {
  GapForm<DoubleBall> result;
  for (std::size_t k = 1; k < form.size(); ++k) {
    result[k - 1] = form[k] * DoubleBall(static_cast<double>(k));
  }
  result.back() = DoubleBall(0);
  return result;
}

namespace {

// C(j, k) / C(n, k) for n = 2 and n = 4, as doubles with their errors.
DoubleBall bernstein_share(int n, int j, int k) {
  const auto choose = [](int m, int of) {
    int c = 1;
    for (int i = 0; i < of; ++i) c = c * (m - i) / (i + 1);
    return static_cast<double>(c);
  };
  return DoubleBall(choose(j, k)) / DoubleBall(choose(n, k));
}

// The coefficients in the Bernstein basis of [lo, lo + width].
GapForm<DoubleBall> bernstein(const GapForm<DoubleBall>& form, int degree, double lo,
                              double width) {
  static const auto shares = [] {
    std::array<std::array<std::array<DoubleBall, 5>, 5>, 5> table{};
    for (const int n : {2, 4}) {
      for (int j = 0; j <= n; ++j) {
        for (int k = 0; k <= j; ++k) table[n][j][k] = bernstein_share(n, j, k);
      }
    }
    return table;
  }();
  GapForm<DoubleBall> c = form;
  if (lo != 0) {
    for (int i = 0; i < degree; ++i) {
      for (int k = degree - 1; k >= i; --k) c[k] = c[k] + DoubleBall(lo) * c[k + 1];
    }
  }
  DoubleBall power(width);
  for (int k = 1; k <= degree; ++k) {
    c[k] = c[k] * power;
    power = power * DoubleBall(width);
  }
  GapForm<DoubleBall> b{};
  for (int j = 0; j <= degree; ++j) {
    b[j] = c[0];
    for (int k = 1; k <= j; ++k) b[j] = b[j] + shares[degree][j][k] * c[k];
  }
  return b;
}

bool positive_on(const GapForm<DoubleBall>& form, int degree, double lo, double hi, int halvings) {
  const double width = (hi - lo) * (1 + 0x1p-50) + DBL_MIN;
  const GapForm<DoubleBall> b = bernstein(form, degree, lo, width);
  bool all = true;
  for (int j = 0; j <= degree; ++j) all = all && sign(b[j]) == Sign::positive;
  if (all) return true;
  if (halvings == 0 || sign(b[0]) != Sign::positive) return false;
  const double middle = lo + (hi - lo) / 2;
  return positive_on(form, degree, middle, hi, halvings - 1) &&
         positive_on(form, degree, lo, middle, halvings - 1);
}

}  // namespace

namespace {

// Whether a form of degree 2 is positive on all of [0, hi] because it rises from the start, falls
// to the end, or has no root at all.
bool is_plainly_positive(const GapForm<DoubleBall>& form, double hi) {
  if (sign(form[0]) != Sign::positive) return false;
  const bool is_convex = sign(form[2]) != Sign::negative && sign(form[2]) != Sign::unknown;
  if (!is_convex) return false;
  if (sign(form[1]) == Sign::positive) return true;
  const DoubleBall four(4);
  if (sign(form[1] * form[1] - four * form[0] * form[2]) == Sign::negative) return true;
  const DoubleBall end(hi);
  return sign(form[1] + DoubleBall(2) * form[2] * end) == Sign::negative &&
         sign(value_at(form, hi)) == Sign::positive;
}

}  // namespace

bool certainly_positive(const GapForm<DoubleBall>& form, int degree, double lo, double hi) {
  constexpr int most_halvings = 6;
  if (degree == 2 && lo >= 0 && is_plainly_positive(form, hi)) return true;
  return positive_on(form, degree, lo, hi, most_halvings);
}

}  // namespace voroproof::internal
