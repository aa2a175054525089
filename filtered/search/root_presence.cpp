#include "filtered/search/root_presence.h"

#include <algorithm>
#include <cmath>
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

// The most pieces that are looked at.
constexpr int kMaxLooks = 200;

// The result in doubles: that there is a root, or up to where there is none.
struct Shown {
  bool has_root;
  double reached;
};

// Over [start, end] at once.
Shown at_once(const Motion& motion, const Quad& q, double start, double end) {
  BernsteinForm form;
  if (form_flip_polynomial<true>(motion, q, start, end, form)) return {false, end};
  bool found = false;
  const double reached = each_root(form, start, end, [&](const DoubleRoot&) {
    found = true;
    return false;
  });
  return {found, reached};
}

// Over pieces: doubles do not tell roots near the start from each other beside what the polynomial
// is at a far end. A piece that does not show all is made shorter, down to `least`.
Shown in_pieces(const Motion& motion, const Quad& q, double start, double end, double least) {
  double from = start, length = end - start;
  for (int looks = 0; looks < kMaxLooks && from < end && length >= least; ++looks) {
    const double until = std::min(end, from + length);
    const Shown shown = at_once(motion, q, from, until);
    if (shown.has_root) return shown;
    length *= shown.reached == until ? 4 : 0.0625;
    from = shown.reached;
  }
  return {false, from};
}

}  // namespace

bool flip_polynomial_has_root(const Motion& motion, const Quad& q, double start, double end) {
  if (!(start < end)) return false;
  // Some units of the last place at the least, so that pieces have a length.
  const double least =
      std::max(0x1p-32 * (end - start), 0x1p-48 * std::max(std::fabs(start), std::fabs(end)));
  const Shown near = in_pieces(motion, q, start, end, least);
  if (near.has_root || near.reached == end) return near.has_root;
  // Mostly the edge has just flipped, and its old root is next to the start: a later one is as
  // good, and if there is none, balls tell of little more than that root.
  const double beyond = std::min(end, near.reached + 16 * least);
  const Shown far = in_pieces(motion, q, beyond, end, least);
  return far.has_root ||
         has_root_in_balls(motion, q, near.reached, far.reached == end ? beyond : end);
}

}  // namespace voroproof::internal
