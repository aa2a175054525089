#include "filtered/worlds/rough_rows.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <type_traits>

#include "filtered/numbers/subdivision.h"

namespace voroproof::internal {
namespace {

DoubleBall shortened(const DdBall& a) { return {a.hi, (std::fabs(a.lo) + a.rad) * (1 + 0x1p-49)}; }

template <class T>
T in(const DdBall& a) {
  if constexpr (std::is_same_v<T, DdBall>) {
    return a;
  } else {
    return shortened(a);
  }
}

}  // namespace

void RoughRows::set(GenId g, const Site<Polynomial<Rational>>& site) {
  const auto line = [&](const Polynomial<Rational>& f) {
    const auto coefficient = [&](int k) {
      DdBall c = f.degree() < k ? DdBall() : MakeDd{}(f[k]);
      if (!filters_) c.rad = std::numeric_limits<double>::infinity();
      return c;
    };
    return Line{coefficient(0), coefficient(1)};
  };
  const Lines all{line(site.x), line(site.y), line(site.r)};
  if (g == container_id) {
    circle_ = all;
  } else {
    (moving_ ? set_[g] : sites_[g]) = {all, site.r};
  }
}

RoughRows::RoughRows(const RoughRows* moving, const Rational& t)
    : moving_(moving), rest_(MakeDd{}(t)), filters_(moving->filters_) {}

RoughRows::Lines RoughRows::lines(GenId g) const {
  if (!moving_) return g == container_id ? *circle_ : sites_[g].lines;
  const auto known = set_.find(g);
  if (known != set_.end()) return known->second.lines;
  const Site<DdBall> at = moving_->site(g, rest_);
  return {{at.x, {}}, {at.y, {}}, {at.r, {}}};
}

// A radius that does not change is the same where the others rest.
const Polynomial<Rational>* RoughRows::radius(GenId g) const {
  if (!moving_) return &sites_[g].radius;
  const auto known = set_.find(g);
  if (known != set_.end()) return &known->second.radius;
  const Polynomial<Rational>* moving = moving_->radius(g);
  return moving != nullptr && moving->degree() < 1 ? moving : nullptr;
}

Site<DdBall> RoughRows::site(GenId g, const DdBall& t) const {
  const auto value = [&](const Line& f) { return f.at_zero + f.rate * t; };
  const Lines all = lines(g);
  return {value(all.x), value(all.y), value(all.r)};
}

// The middle in double-doubles: only what the time leaves open and one rounding is lost.
Site<DoubleBall> RoughRows::site(GenId g, const DoubleBall& t) const {
  const Lines all = lines(g);
  const auto value = [&](const Line& f) {
    DdBall at = f.at_zero + f.rate * DdBall(t.mid);
    at.rad += (std::fabs(f.rate.hi) * (1 + 0x1p-50) + f.rate.rad) * t.rad * (1 + 0x1p-49) + DBL_MIN;
    return shortened(at);
  };
  return {value(all.x), value(all.y), value(all.r)};
}

GeneratorRow<DoubleBall> RoughRows::row_of(const Site<DoubleBall>& base, GenId g,
                                           const DoubleBall& t) const {
  if (is_infinity(g)) return {0.0, 0.0, 0.0, 1.0};
  const Site<DoubleBall> to = site(g, t);
  return g == container_id ? row_of_circle(base, to) : row(base, to);
}

DoubleBall RoughRows::tangency_of(GenId a, GenId b, const DoubleBall& t) const {
  return a == container_id ? row_of(site(b, t), a, t).p : row_of(site(a, t), b, t).p;
}

bool RoughRows::have_one_radius(const Quad& q) const {
  const Polynomial<Rational>* one = nullptr;
  for (const GenId g : {q.l, q.r, q.s, q.e}) {
    if (g == container_id && has_circle()) return false;
    if (g == container_id) continue;
    const Polynomial<Rational>* other = radius(g);
    if (other == nullptr || (one != nullptr && !(*one == *other))) return false;
    one = other;
  }
  return true;
}

template <class T>
SiteForm<T> RoughRows::over(GenId g, double a, double b) const {
  if (is_infinity(g)) return {};
  const Site<DdBall> at_a = site(g, DdBall(a)), at_b = site(g, DdBall(b));
  return {{{in<T>(at_a.x), in<T>(at_b.x)}},
          {{in<T>(at_a.y), in<T>(at_b.y)}},
          {{in<T>(at_a.r), in<T>(at_b.r)}}};
}

template <class T>
Form<T, 2> RoughRows::tangency_over(GenId g, const SiteForm<T>& of_g, GenId h,
                                    const SiteForm<T>& of_h) const {
  if (is_infinity(g) || is_infinity(h)) return {{T(1.0), T(2.0), T(1.0)}};
  const Form<T, 1> x = of_g.x - of_h.x, y = of_g.y - of_h.y;
  if (g != container_id && h != container_id) {
    return voroproof::internal::tangency_of(x, y, of_g.r - of_h.r);
  }
  return squared(of_g.r + of_h.r) - (squared(x) + squared(y));
}

double RoughRows::time_scale(const Quad& q, double t) const {
  const GenId base = q.l == container_id ? q.r : q.l;
  const Lines from = lines(base);
  const auto at = [t](const Line& f) { return f.at_zero.hi + f.rate.hi * t; };
  double size = 0, speed = 0;
  for (const GenId g : {q.l, q.r, q.s, q.e}) {
    if (g == base || is_infinity(g)) continue;
    const Lines to = lines(g);
    size = std::max(size, std::fabs(at(to.x) - at(from.x)) + std::fabs(at(to.y) - at(from.y)) +
                              std::fabs(at(to.r)) + std::fabs(at(from.r)));
    speed = std::max(speed, std::fabs(to.x.rate.hi - from.x.rate.hi) +
                                std::fabs(to.y.rate.hi - from.y.rate.hi) + std::fabs(to.r.rate.hi) +
                                std::fabs(from.r.rate.hi));
  }
  return size / speed;
}

#define VOROPROOF_INSTANTIATE(T)                                                 \
  template SiteForm<T> RoughRows::over(GenId, double, double) const;             \
  template Form<T, 2> RoughRows::tangency_over(GenId, const SiteForm<T>&, GenId, \
                                               const SiteForm<T>&) const;
VOROPROOF_INSTANTIATE(DoubleBall)
VOROPROOF_INSTANTIATE(DdBall)
#undef VOROPROOF_INSTANTIATE

}  // namespace voroproof::internal
