#include "engine/billiard/meeting_time.h"

namespace voroproof::internal {
namespace {

Sign known(Sign sign) {
  if (sign == Sign::unknown) throw MoreBits("whether two touch, or when, is not told");
  return sign;
}

template <class T>
T half(const T& x);
template <>
Rational half(const Rational& x) {
  return x / 2;
}
template <>
Ball half(const Ball& x) {
  return x * Ball(0.5, 64);
}

// The other root of a u^2 + 2 b u, which is not 0.
template <class T>
T second_root(const T& a, const T& b) {
  return (b + b) / (a * T(-1));
}
template <>
Ball second_root(const Ball& a, const Ball& b) {
  return (b + b) / -a;
}

}  // namespace

Rational exact_root(const Rational& x) {
  constexpr std::size_t most_bits = 1U << 18U;
  const Integer &n = x.get_num(), &d = x.get_den();
  if (mpz_sizeinbase(n.get_mpz_t(), 2) + mpz_sizeinbase(d.get_mpz_t(), 2) > most_bits ||
      mpz_perfect_square_p(n.get_mpz_t()) == 0 || mpz_perfect_square_p(d.get_mpz_t()) == 0)
    throw NoFraction();
  return Rational(sqrt(n), sqrt(d));
}

template <class T>
std::optional<T> meeting_time(const GapForm<T>& form, bool parting) {
  const T &c = form[0], &a = form[2];
  const T b = half(form[1]);
  const Sign bends = sign(a);
  const bool is_convex = bends == Sign::positive || bends == Sign::zero;
  if (parting || sign(c) == Sign::zero) {
    if (parting && is_convex) return std::nullopt;
    const Sign rises = parting && sign(b) == Sign::unknown ? Sign::unknown : sign(b);
    if (!parting && known(rises) == Sign::negative) return c;  // at once
    if (is_convex) return std::nullopt;
    known(bends);
    if (known(rises) != Sign::positive)
      throw BilliardStop("two are in touch, do not part, and are pressed together");
    return second_root(a, b);
  }
  if (known(sign(c)) == Sign::negative) throw BilliardStop("two overlap");
  if (is_convex && (sign(b) == Sign::positive || sign(b) == Sign::zero)) return std::nullopt;
  const T discriminant = b * b - a * c;
  const Sign meets = known(sign(discriminant));
  if (meets == Sign::negative || (meets == Sign::zero && is_convex)) return std::nullopt;
  if (known(bends) != Sign::negative && known(sign(b)) != Sign::negative) return std::nullopt;
  return T(c / T(exact_root(discriminant) - b));
}

template std::optional<Rational> meeting_time(const GapForm<Rational>&, bool);
template std::optional<Ball> meeting_time(const GapForm<Ball>&, bool);

}  // namespace voroproof::internal
