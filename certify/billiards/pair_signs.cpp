#include "certify/billiards/pair_signs.h"

namespace voroproof::internal {

Sign sign_after(const Polynomial<Rational>& f, const Rational& u) {
  if (f.is_zero()) return Sign::zero;
  return signs_around(f, AlgebraicNumber<Rational>(u)).after;
}

std::vector<AlgebraicNumber<Rational>> roots_of(const Polynomial<Rational>& f, const Rational& lo,
                                                const Rational& hi) {
  if (f.degree() < 1 || hi < lo) return {};
  return real_roots(f, lo, hi);
}

std::optional<AlgebraicNumber<Rational>> first_fall(const Polynomial<Rational>& f,
                                                    const Rational& lo, const Rational& hi) {
  for (const auto& root : roots_of(f, lo, hi)) {
    const SignsAround signs = signs_around(f, root);
    const bool before = signs.before == Sign::positive || compare(root, lo) == 0;
    if (before && signs.after == Sign::negative) return root;
  }
  return std::nullopt;
}

bool is_negative_in(const Polynomial<Rational>& f, const Rational& lo, const Rational& hi) {
  if (f.is_zero()) return false;
  if (sign(f.evaluate(lo)) == Sign::negative || sign(f.evaluate(hi)) == Sign::negative) return true;
  for (const auto& root : roots_of(f, lo, hi)) {
    const SignsAround signs = signs_around(f, root);
    if ((signs.before == Sign::negative && compare(root, lo) > 0) ||
        (signs.after == Sign::negative && compare(root, hi) < 0))
      return true;
  }
  return false;
}

}  // namespace voroproof::internal
