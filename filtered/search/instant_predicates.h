// Predicates of the generators at one exact time: written once for every number type, decided by
// the cheapest that can.
#pragma once

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "exact/directions.h"
#include "exact/predicates.h"
#include "filtered/motion/enclosures.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/stats.h"
#include "filtered/search/collapse.h"
#include "filtered/search/ladder.h"

namespace voroproof::internal {

class InstantPredicates {
 public:
  // The states of `motion` are in force at t. It must outlive this object.
  InstantPredicates(const Motion& motion, const Rational& t, TierCounts& counts,
                    std::vector<Rational> constants = {})
      : motion_(motion), counts_(counts), t_(t), constants_(std::move(constants)) {
    const double nearest = round_nearest(t);
    const DoubleBall at(nearest, distance(t, nearest));
    doubles_.reserve(motion.size() + 1);
    for (GenId g = container_id; g < motion.size(); ++g) doubles_.push_back(motion.site(g, at));
    for (const Rational& q : constants_) {
      const double x = round_nearest(q);
      double_constants_.emplace_back(x, distance(q, x));
    }
  }

  const Motion& motion() const { return motion_; }
  const Rational& t() const { return t_; }
  const Site<DoubleBall>& rough(GenId g) const { return doubles_[g + 1]; }

  // Runs a predicate, given as a template over (sites, square root), through the tiers until it
  // gives a value. It must give one over exact numbers. `proof` gives the value where something
  // else than arithmetic proves it, and is asked before exact numbers are. Throws Undecided where
  // those need more than the budget, and std::domain_error where one generator lies inside another,
  // so that no circle touches both.
  template <class F, class Proof>
  auto decide(F&& predicate, Proof&& proof) {
    using Answer = typename std::decay_t<decltype(proof())>::value_type;
    Ladder<Answer> ladder(counts_, Predicate::incircle);
    if (motion_.options().filters) {
      const Rung doubles{Tier::filter, [&] { return predicate(DoubleSites(*this), OwnRoot{}); }};
      const Rung dds{Tier::dd, [&] { return predicate(DdSites(*this), OwnRoot{}); }};
      if (const auto r = ladder.climb(doubles, dds)) return *r;
    }
    const Rung balls{Tier::ball, [&] { return predicate(BallSites(*this), OwnRoot{}); }};
    const Rung exactly{Tier::exact, [&] {
                         ExactMotion exact(motion_);
                         return predicate(ExactSites(*this, exact),
                                          [&](const Tower& x) { return exact.field().sqrt(x); });
                       }};
    if (const auto r = ladder.climb(balls, Rung{Tier::symmetry, proof}, exactly)) return *r;
    throw Undecided("a predicate at an instant: " + ladder.budget());
  }

  template <class F>
  auto decide(F&& predicate) {
    return decide(predicate, [&] { return decltype(predicate(BallSites(*this), OwnRoot{}))(); });
  }

  // Does what decide() does, for a predicate that gives a sign, unknown where it cannot tell.
  template <class F>
  Sign decide_sign(F&& predicate) {
    return decide([&](auto at, auto root) -> std::optional<Sign> {
      const Sign s = predicate(at, root);
      if (s == Sign::unknown) return std::nullopt;
      return s;
    });
  }

  // The sign of such an expression.
  template <class F>
  Sign sign_of(F&& expression) {
    return decide_sign([&](auto at, auto root) { return sign(expression(at, root)); });
  }

  // A ball that contains the value of such an expression.
  template <class F>
  auto ball(F&& expression) const {
    return expression(BallSites(*this), OwnRoot{});
  }

 private:
  static double distance(const Rational& q, double nearest) {
    return std::fabs(round_nearest(Rational(q - to_rational(nearest)))) * (1 + 0x1p-50);
  }

  // The input of a predicate: the sites, and constants that are not the motion's. In doubles they
  // are at hand; else they are computed when asked for.
  class DoubleSites {
   public:
    explicit DoubleSites(const InstantPredicates& p) : p_(&p) {}
    const Site<DoubleBall>& operator()(GenId g) const { return p_->rough(g); }
    const DoubleBall& constant(std::size_t k) const { return p_->double_constants_[k]; }

   private:
    const InstantPredicates* p_;
  };

  class DdSites {
   public:
    explicit DdSites(const InstantPredicates& p) : p_(&p), t_(dd_of(p.t_)) {}
    Site<DdBall> operator()(GenId g) const { return p_->motion_.site(g, t_); }
    DdBall constant(std::size_t k) const { return dd_of(p_->constants_[k]); }

   private:
    const InstantPredicates* p_;
    DdBall t_;
  };

  class BallSites {
   public:
    explicit BallSites(const InstantPredicates& p)
        : p_(&p), bits_(p.motion_.goal_bits() + 32), t_(p.t_, bits_) {}
    Site<Ball> operator()(GenId g) const { return p_->motion_.site(g, t_); }
    Ball constant(std::size_t k) const { return Ball(p_->constants_[k], bits_); }

   private:
    const InstantPredicates* p_;
    int bits_;
    Ball t_;
  };

  class ExactSites {
   public:
    ExactSites(const InstantPredicates& p, ExactMotion& exact) : p_(&p), exact_(&exact), t_(p.t_) {}
    Site<Tower> operator()(GenId g) const { return exact_->site(g, t_); }
    Tower constant(std::size_t k) const { return Tower(p_->constants_[k]); }

   private:
    const InstantPredicates* p_;
    ExactMotion* exact_;
    Tower t_;
  };

  const Motion& motion_;
  TierCounts& counts_;
  Rational t_;
  std::vector<Rational> constants_;
  std::vector<Site<DoubleBall>> doubles_;
  std::vector<DoubleBall> double_constants_;
};

}  // namespace voroproof::internal
