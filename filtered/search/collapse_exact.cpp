// The exact tier of the search for collapses.
#include <algorithm>
#include <compare>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "filtered/numbers/subdivision.h"
#include "filtered/search/collapse.h"
#include "filtered/search/edge_predicates.h"
#include "filtered/search/flip_polynomial.h"

namespace voroproof::internal {

namespace {

// Effort, by which nothing is decided. A root that is still to come is narrowed no further than
// this,
constexpr int kBitsBeforeWaiting = 256;
// and each to a length of 2^-64 of the edge's time scale to begin with.
constexpr int kBitsOfShortest = 64;

std::array<Site<Polynomial<Tower>>, 4> paths(const Quad& q, ExactMotion& exact) {
  std::array<Site<Polynomial<Tower>>, 4> out;
  const GenId ids[4] = {q.l, q.r, q.s, q.e};
  for (int k = 0; k < 4; ++k) {
    const ExactMotion::State& s = exact.state(ids[k]);
    const Tower t(s.t_ref);
    out[k] = {Polynomial<Tower>{s.x - s.vx * t, s.vx}, Polynomial<Tower>{s.y - s.vy * t, s.vy},
              Polynomial<Tower>{exact.radius(ids[k])}};
  }
  return out;
}

bool equal_radii(const Quad& q, ExactMotion& exact) {
  const Tower r = exact.radius(q.l);
  return exact.radius(q.r) == r && exact.radius(q.s) == r && exact.radius(q.e) == r;
}

Polynomial<Tower> flip_polynomial(const Quad& q, ExactMotion& exact) {
  const auto p = paths(q, exact);
  return equal_radii(q, exact) ? cocircularity(p[3], p[0], p[1], p[2])
                               : cotangency(p[0], p[1], p[2], p[3]);
}

std::array<Site<Tower>, 4> exact_sites(const Quad& q, const Rational& t, ExactMotion& exact) {
  const Tower at(t);
  return {exact.site(q.l, at), exact.site(q.r, at), exact.site(q.s, at), exact.site(q.e, at)};
}

// The part around x of an interval that contains x, in which no tangency of the four vanishes but
// perhaps at x.
RootInterval clear_of_tangencies(const Quad& q, ExactMotion& exact, const ExactTime& x,
                                 RootInterval within) {
  const auto at = paths(q, exact);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      within =
          clear_of(tangency_of(at[i].x - at[j].x, at[i].y - at[j].y, at[i].r - at[j].r), x, within);
    }
  }
  return within;
}

// Both in-circle signs at an exact time at which the circles exist.
std::array<Sign, 2> exact_incircles(const Quad& q, const Rational& t, ExactMotion& exact) {
  const auto at = exact_sites(q, t, exact);
  const auto triples = EdgeTriples<Tower>::of(q, at);
  const Sign f = sign(cotangency(at[0], at[1], at[2], at[3]));
  return {incircle(triples.start, at[3], q.e == container_id, f),
          incircle(triples.end, at[2], q.s == container_id, f)};
}

}  // namespace

// Four generators at rest relative to each other: the edge is legal for good unless
// they are cotangent now and the rule of the largest id is against it.
Collapse CollapseSearch::at_rest(const Quad& q, const Moment& now) {
  const Collapse legal = Collapse::none_until(std::numeric_limits<double>::infinity());
  if (legal_while_cotangent(q)) return legal;
  if (sign(flip_value(motion_, q, DoubleBall::hull(now.lo, now.hi), false)) != Sign::unknown) {
    counts_.count(Predicate::flip_search, Tier::filter);
    return legal;
  }
  if (sign(flip_value(motion_, q, now.dd, false)) != Sign::unknown) {
    counts_.count(Predicate::flip_search, Tier::dd);
    return legal;
  }
  const MakeBall make{motion_.goal_bits() + 32};
  const Ball at = make.hull(to_rational(now.lo), to_rational(now.hi));
  if (is_certain(sign(flip_value(motion_, q, at, false)))) {
    counts_.count(Predicate::flip_search, Tier::ball);
    return legal;
  }
  try {
    ExactMotion exact(motion_);
    const auto s = exact_incircles(q, to_rational(now.hi), exact);
    counts_.count(Predicate::flip_search, Tier::exact);
    if (s[0] != Sign::zero || s[1] != Sign::zero) return legal;
  } catch (const BudgetExceeded& e) {
    throw Undecided(std::string("four generators at relative rest may be cotangent: ") + e.what(),
                    q);
  }
  const Ball t(to_rational(now.hi), motion_.goal_bits() + 32);
  const auto answer = while_cotangent(q, {Sign::zero, Sign::zero}, t);
  if (!answer) throw Undecided("the order of four generators on their circle is not decided", q);
  return *answer;
}

namespace {

// The roots of an edge's flip polynomial after the start of a search, and rational times beside
// each: so near that neither the polynomial nor a tangency of the four changes its sign between the
// root and the time. So the in-circle functions have the signs there that they have just beside the
// root (docs/certificate.md, Lemma 6.17).
class EdgeRoots {
 public:
  // `scale`: the edge's time scale.
  EdgeRoots(const Motion& motion, const Quad& q, ExactMotion& exact, const Polynomial<Tower>& phi,
            const Rational& start, const Rational& end, const Rational& scale, const Moment* now)
      : motion_(motion),
        q_(q),
        exact_(exact),
        start_(start),
        end_(end),
        scale_(scale),
        roots_(real_roots(phi, start, end)) {
    if (now != nullptr) instant_ = now->exact(exact);
  }

  std::size_t size() const { return roots_.size(); }
  const ExactTime& operator[](std::size_t k) const { return roots_[k]; }
  // The order of the root and the time at which the search starts: the instant, if there is one.
  std::strong_ordering order_to_start(std::size_t k) {
    return instant_ ? compare(roots_[k], *instant_) : compare(roots_[k], start_);
  }
  bool starts_at_instant() const { return instant_.has_value(); }

  // Narrows root k, which has that order to the start, and finds the times beside it. The one
  // before is after the root before, the start and the instant too; the one after is before the
  // next root.
  void narrow(std::size_t k, std::strong_ordering order) {
    const Rational shortest = scale_ >> kBitsOfShortest;
    roots_[k].refine(shortest);
    beside_ = roots_[k].interval();
    if (beside_.is_point()) {
      const Rational at = beside_.lo, last = k > 0 ? roots_[k - 1].interval().hi : start_,
                     next = k + 1 < roots_.size() ? roots_[k + 1].interval().lo : end_;
      beside_ = {std::max<Rational>((at + last) / 2, at - shortest),
                 std::min<Rational>((at + next) / 2, at + shortest)};
    }
    const MakeBall make{motion_.goal_bits() + 32};
    if (!keeps_tangencies(sites(motion_, q_, make.hull(beside_.lo, beside_.hi)))) {
      beside_ = clear_of_tangencies(q_, exact_, roots_[k], beside_);
    }
    if (instant_ && order > 0) {
      beside_.lo = std::max<Rational>(beside_.lo, rational_between(*instant_, roots_[k]));
    }
  }
  const RootInterval& beside() const { return beside_; }

  // Whether both circles of the edge are in conflict after root k, which narrow() has been at, and
  // one at it. For that it is narrowed further, to so many bits to begin with and no more than
  // `most`: throws RootTooBlurred.
  bool shrinks(std::size_t k, int bits, int most) {
    const auto s = exact_incircles(q_, beside_.hi, exact_);
    if (s[0] != Sign::negative || s[1] != Sign::negative) return false;
    for (;; bits *= 2) {
      const RootInterval& at = roots_[k].interval();
      const Sign contacts =
          contact_order(q_, sites(motion_, q_, MakeBall{bits}.hull(at.lo, at.hi)));
      if (is_certain(contacts)) return contacts == Sign::positive;
      if (bits > most) throw RootTooBlurred("the order of the contacts at a flip", bits);
      roots_[k].refine(scale_ >> bits);
    }
  }

 private:
  const Motion& motion_;
  const Quad& q_;
  ExactMotion& exact_;
  const Rational &start_, &end_, &scale_;
  std::vector<ExactTime> roots_;
  std::optional<ExactTime> instant_;
  RootInterval beside_;  // the times beside the root that narrow() has been at
};

}  // namespace

Collapse CollapseSearch::exactly(const Quad& q, const Rational& start, const Moment* now,
                                 double end) {
  ExactMotion exact(motion_);
  const Polynomial<Tower> phi = flip_polynomial(q, exact);
  // A root is narrowed to so many bits, so that its circles show whether they exist and which they
  // touch.
  const int least = motion_.goal_bits() + 32;
  const int most = std::max(least, motion_.options().max_bits / 8);
  const Rational scale =
      to_rational(time_scale(motion_, q, voroproof::internal::round_down(start)));
  if (phi.is_zero()) {
    Rational t = start;
    if (now != nullptr) {
      const RootInterval about{to_rational(now->lo),
                               to_rational(now->hi) + (scale >> kBitsOfShortest)};
      t = clear_of_tangencies(q, exact, now->exact(exact), about).hi;
    }
    const auto answer = while_cotangent(q, exact_incircles(q, t, exact), Ball(t, least));
    if (!answer) {
      throw Undecided("four generators stay cotangent, in an order that is not decided", q);
    }
    return *answer;
  }
  const Rational finish = std::max<Rational>(to_rational(end), start), beyond = finish + scale;
  EdgeRoots roots(motion_, q, exact, phi, start, beyond, scale, now);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const auto order = roots.order_to_start(k);
    if (order < 0) continue;
    if (order == 0) {
      if (!roots.starts_at_instant()) continue;  // the search starts at a root: beyond it
      roots.narrow(k, order);
      if (!roots.shrinks(k, least, most)) continue;
      Collapse answer;
      answer.kind = Collapse::Kind::now;
      return answer;
    }
    // Later: does the edge collapse here? Whether its circles exist is not asked: those of an edge
    // of the diagram do, and others are not there any more. Where the answer takes many bits it can
    // wait, for an event may come before the root.
    if (compare(roots[k], finish) > 0) break;
    roots.narrow(k, order);
    const double reached = voroproof::internal::round_down(roots.beside().lo);
    const bool can_wait =
        reached > (now != nullptr ? now->hi : voroproof::internal::round_up(start));
    try {
      if (roots.shrinks(k, least, can_wait ? std::min(most, kBitsBeforeWaiting) : most)) {
        // A root that is a point needs an interval all the same: it may not be an end.
        return Collapse::at_root(roots.beside().lo, roots.beside().hi);
      }
    } catch (const RootTooBlurred&) {
      if (!can_wait) throw;
      return Collapse::none_until(reached);
    }
  }
  return Collapse::none_until(voroproof::internal::round_down(finish));
}

ExactTime CollapseSearch::exact_root(const Quad& q, const Rational& lo, const Rational& hi,
                                     ExactMotion& exact) {
  if (lo == hi) return ExactTime(lo);
  const Polynomial<Tower> phi = flip_polynomial(q, exact);
  const Sign at_lo = sign(phi.evaluate(Tower(lo))), at_hi = sign(phi.evaluate(Tower(hi)));
  if (at_lo != Sign::zero && at_lo == -at_hi) return ExactTime(phi, RootInterval{lo, hi});
  return real_roots(phi, lo, hi).at(0);  // the root is of even order
}

}  // namespace voroproof::internal
