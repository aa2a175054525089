// The real roots of a polynomial by CGAL's univariate algebraic kernel. For evidence.cpp alone.
#pragma once

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/Gmpz.h>

#include <utility>
#include <vector>

#include "certify/evidence/cgal_motion.h"

namespace voroproof::internal::cgal {

// Integer coefficients, rational bounds, roots isolated by Descartes' method. Needs nothing besides
// GMP.
using AlgebraicKernel = CGAL::Algebraic_kernel_d_1<CGAL::Gmpz>;

class Roots {
 public:
  // Precondition: f is not zero.
  explicit Roots(const Polynomial& f) {
    CGAL::Polynomial<CGAL::Gmpz> numerator;
    CGAL::Gmpz denominator;
    CGAL::Fraction_traits<Polynomial>::Decompose()(f, numerator, denominator);
    std::vector<std::pair<AlgebraicKernel::Algebraic_real_1, int>> found;
    kernel_.solve_1_object()(numerator, std::back_inserter(found));
    for (auto& [root, multiplicity] : found) roots_.push_back(std::move(root));
  }

  // The indices of the roots in [lo, hi], as first and one beyond the last.
  std::pair<std::size_t, std::size_t> in(const Gmpq& lo, const Gmpq& hi) const {
    const auto compare = kernel_.compare_1_object();
    std::size_t first = 0;
    while (first < roots_.size() && compare(roots_[first], lo) == CGAL::SMALLER) ++first;
    std::size_t end = first;
    while (end < roots_.size() && compare(roots_[end], hi) != CGAL::LARGER) ++end;
    return {first, end};
  }

  // Times before and after root i, no farther apart than 2^(2 - bits), without another between.
  // Nothing where roots are nearer to each other than that.
  std::optional<std::array<Gmpq, 2>> around(std::size_t i, int bits) const {
    const auto [lo, hi] = kernel_.approximate_absolute_1_object()(roots_[i], bits);
    const Gmpq step = Gmpq(1) / CGAL::ipower(Gmpq(2), bits);
    const std::array<Gmpq, 2> times{lo - step, hi + step};
    const auto [first, end] = in(times[0], times[1]);
    if (end - first != 1) return std::nullopt;
    return times;
  }

 private:
  AlgebraicKernel kernel_;
  std::vector<AlgebraicKernel::Algebraic_real_1> roots_;  // distinct, in ascending order
};

}  // namespace voroproof::internal::cgal
