#include "filtered/search/root_presence.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "filtered/numbers/double_roots.h"
#include "filtered/numbers/subdivision.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/flip_polynomial.h"

namespace voroproof::internal {
namespace {

bool has_root_in_balls(const Motion& motion, const Quad& q, double start, double end) {
  const int bits = motion.goal_bits() + 32;
  const MakeBall make{bits};
  const Ball half = make(Rational(1, 2));
  struct Part {
    Coefficients<Ball> c;
    int depth;
  };
  std::vector<Part> parts{{form_in<Ball>(motion, q, to_rational(start), to_rational(end),
                                         flip_polynomial_is_cocircularity(motion, q), make),
                           0}};
  const auto is_told = [](const Ball& c) {
    return sign(c) == Sign::positive || sign(c) == Sign::negative;
  };
  const Coefficients<Ball>& whole = parts[0].c;
  if (std::none_of(whole.begin(), whole.end(), is_told)) return false;
  while (!parts.empty()) {
    Part part = std::move(parts.back());
    parts.pop_back();
    const int roots = count_roots_in(part.c);
    if (roots == 0) continue;
    if (roots == 1 || part.depth == bits / 4) return true;
    Part left{{}, part.depth + 1}, right{{}, part.depth + 1};
    halve_in(part.c, half, left.c, right.c);
    parts.push_back(std::move(right));
    parts.push_back(std::move(left));
  }
  return false;
}

}  // namespace

bool flip_polynomial_has_root(const Motion& motion, const Quad& q, double start, double end) {
  if (!(start < end)) return false;
  BernsteinForm form;
  if (form_flip_polynomial<true>(motion, q, start, end, form)) return false;
  bool found = false;
  const double reached = each_root(form, start, end, [&](const DoubleRoot&) {
    found = true;
    return false;
  });
  return found || (reached < end && has_root_in_balls(motion, q, start, end));
}

}  // namespace voroproof::internal
