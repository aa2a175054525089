#include "exact/sign_evaluator.h"

#include <algorithm>
#include <utility>

#include "exact/patience.h"

namespace voroproof::internal {
namespace {

constexpr Ball::Precision first_precision = 320;

Ball to_ball(const Rational& q, Ball::Precision precision) { return {q, precision}; }
Ball to_ball(const Tower& x, Ball::Precision precision) { return ball(x, precision); }

}  // namespace

Approximation approximate(const Polynomial<Rational>& f, Ball::Precision /*precision*/) {
  std::vector<Integer> coefficients = primitive_integers(f);
  const std::size_t size = coefficients.size();
  return {std::move(coefficients), std::vector<Integer>(size)};
}

Approximation approximate(const Polynomial<Tower>& f, Ball::Precision precision) {
  if (const auto rational = as_rational(f)) return approximate(*rational, precision);
  std::vector<std::pair<Rational, Rational>> bounds;
  Integer scale = 1;
  for (const Tower& c : f.coefficients()) {
    bounds.push_back(ball(c, precision).rational_interval());
    scale = lcm(scale, lcm(bounds.back().first.get_den(), bounds.back().second.get_den()));
  }
  Approximation result;
  for (const auto& [lo, hi] : bounds) {
    const Rational width = (hi - lo) * scale;
    result.coefficients.push_back(lo.get_num() * (scale / lo.get_den()));
    result.widths.push_back(width.get_num());
  }
  return result;
}

template <class T>
SignEvaluator<T>::SignEvaluator(const Polynomial<T>& f)
    : f_(f), approximation_(approximate(f, first_precision)) {}

template <class T>
Sign SignEvaluator<T>::operator()(const Rational& x) const {
  Patience::ask();
  // Horner's rule for q^n f(p / q), q > 0, and for a bound of its error.
  const Integer magnitude = abs(x.get_num());
  Integer value = 0;
  Integer error = 0;
  Integer power = 1;
  for (std::size_t i = approximation_.coefficients.size(); i-- > 0;) {
    value = value * x.get_num() + approximation_.coefficients[i] * power;
    error = error * magnitude + approximation_.widths[i] * power;
    power *= x.get_den();
  }
  if (error == 0 || mpz_cmpabs(value.get_mpz_t(), error.get_mpz_t()) > 0) {
    return sign_of(sgn(value));
  }
  // Next to a root that x has been halved towards, the value is as small as x is long.
  const auto length = static_cast<Ball::Precision>(bit_size(x));
  const Sign s = this->value(x, first_precision + 2 * length).sign();
  return s != Sign::unknown ? s : sign(f_.evaluate(T(x)));
}

template <class T>
Ball SignEvaluator<T>::value(const Rational& x, Ball::Precision precision) const {
  const Ball at(x, precision);
  Ball value(precision);
  for (int i = f_.degree(); i >= 0; --i) value = value * at + to_ball(f_[i], precision);
  return value;
}

template <class T>
Rational SignEvaluator<T>::secant(const Rational& lo, const Rational& hi,
                                  Ball::Precision bits) const {
  const auto length = static_cast<Ball::Precision>(std::max(bit_size(lo), bit_size(hi)));
  const Ball::Precision precision = first_precision + 2 * (length + bits);
  const Ball at_lo = value(lo, precision);
  const Ball part = at_lo / (at_lo - value(hi, precision));
  const Integer whole = Integer(1) << static_cast<mp_bitcnt_t>(bits);
  Integer nearest = whole / 2;
  if (part.is_finite()) {
    const Rational scaled = part.midpoint() * whole + Rational(1, 2);
    mpz_fdiv_q(nearest.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  }
  Rational result(std::clamp<Integer>(nearest, 0, whole), whole);
  result.canonicalize();
  return result;
}

template <class T>
Sign sign_at(const Polynomial<T>& f, const Rational& x) {
  return SignEvaluator<T>(f)(x);
}

#define VOROPROOF_INSTANTIATE(T)   \
  template class SignEvaluator<T>; \
  template Sign sign_at(const Polynomial<T>&, const Rational&);
VOROPROOF_INSTANTIATE(Rational)
VOROPROOF_INSTANTIATE(Tower)
#undef VOROPROOF_INSTANTIATE

}  // namespace voroproof::internal
