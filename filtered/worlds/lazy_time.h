// When something happens in a world: an enclosure, and the exact number where somebody asks for it.
#pragma once

#include <compare>
#include <functional>
#include <memory>
#include <optional>

#include "exact/algebraic.h"
#include "filtered/worlds/rough_edge.h"

namespace voroproof::internal {

// A value. A copy shares what is found out.
class LazyTime {
 public:
  using Exact = AlgebraicNumber<Rational>;

  LazyTime(Exact t);
  LazyTime(const Rational& t) : LazyTime(Exact(t)) {}
  // The only root of the polynomial in [lo, hi], at which it changes its sign; what `polynomial`
  // refers to outlives it, and does not change while the exact number may be asked for.
  LazyTime(double lo, double hi, std::function<Polynomial<Rational>()> polynomial);
  // The collapse of an edge at a root of its polynomial f (rough_edge.h), likewise. `rows`
  // outlives it, too.
  LazyTime(const RoughRows& rows, const Quad& q, const DoubleRoot& root,
           std::function<Polynomial<Rational>()> polynomial);

  // It is in [lo, hi].
  double lo() const { return known_->lo; }
  double hi() const { return known_->hi; }
  const Exact& exact() const;
  double nearest() const;
  // If it is a collapse of an edge with the same four generators: a time after hi() up to which
  // their polynomial has no other root after this one.
  std::optional<double> alone_until(const Quad& q) const;

  friend std::strong_ordering compare(const LazyTime& x, const LazyTime& y);
  friend std::strong_ordering compare(const LazyTime& x, const Rational& t);

 private:
  struct Known {
    double lo = 0, hi = 0;
    const RoughRows* rows = nullptr;
    Quad q{};
    double piece_hi = 0;
    std::function<Polynomial<Rational>()> polynomial{};
    std::optional<Exact> exact{};
  };
  std::shared_ptr<Known> known_;
};

}  // namespace voroproof::internal
