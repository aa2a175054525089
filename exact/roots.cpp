#include "exact/roots.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "exact/patience.h"

namespace voroproof::internal {
namespace {

Rational midpoint(const Rational& a, const Rational& b) { return (a + b) / 2; }

// ---- Descartes' rule in the Bernstein basis ----------------------------------------

// Coefficients b_0 ... b_n of a positive multiple of a polynomial of degree n in the Bernstein
// basis of some interval [lo, hi], each known up to +-error. The coefficients over the two halves
// are averages of them, so an error bound for all stays one.
struct Bernstein {
  std::vector<Integer> b;
  Integer error;

  Bernstein(std::vector<Integer> coefficients, const Integer& error_bound)
      : b(std::move(coefficients)), error(error_bound) {}

  std::size_t degree() const { return b.size() - 1; }
  Sign sign(std::size_t i) const { return is_open(b[i]) ? Sign::unknown : sign_of(sgn(b[i])); }
  // Nothing is known any more.
  bool is_exhausted() const {
    return std::all_of(b.begin(), b.end(), [this](const Integer& c) { return is_open(c); });
  }

 private:
  bool is_open(const Integer& c) const {
    return error != 0 && mpz_cmpabs(c.get_mpz_t(), error.get_mpz_t()) <= 0;
  }
};

Integer binomial(std::size_t m, std::size_t k) {
  Integer result;
  mpz_bin_uiui(result.get_mpz_t(), m, k);
  return result;
}

// f(lo + (hi - lo) x) in the Bernstein basis of 0 <= x <= 1.
Bernstein bernstein_on(const Approximation& f, const Rational& lo, const Rational& hi) {
  const std::size_t n = f.coefficients.size() - 1;
  const Integer scale = lcm(lo.get_den(), hi.get_den());
  const Integer start = lo.get_num() * (scale / lo.get_den());
  const Integer width = hi.get_num() * (scale / hi.get_den()) - start;

  // Power basis, by Horner's rule: g(x) = scale^n f((start + width x) / scale). An
  // error of a coefficient of f grows at most as if start were |start|, when all
  // terms of its image are positive: their sum at x = 1 bounds the errors of g, and
  // of its Bernstein coefficients, whose weights below are at most 1.
  std::vector<Integer> g(n + 1);
  Integer error = 0;
  const Integer reach = abs(start) + width;
  Integer power = 1;
  for (std::size_t i = n + 1; i-- > 0;) {
    for (std::size_t k = n - i; k > 0; --k) g[k] = g[k] * start + g[k - 1] * width;
    g[0] = g[0] * start + f.coefficients[i] * power;
    error = error * reach + f.widths[i] * power;
    power *= scale;
  }

  // b_i = sum_k C(i,k) / C(n,k) g_k, times the least common multiple of all C(n,k).
  Integer common = 1;
  for (std::size_t k = 0; k <= n; ++k) common = lcm(common, binomial(n, k));
  Bernstein result{std::vector<Integer>(n + 1), error * common};
  for (std::size_t k = 0; k <= n; ++k) {
    const Integer weighted = common / binomial(n, k) * g[k];
    for (std::size_t i = k; i <= n; ++i) result.b[i] += binomial(i, k) * weighted;
  }
  return result;
}

// Takes out powers of two: exactly, or, where there is an error, as far as it stays
// large against the units then lost.
void shorten(Bernstein& f) {
  constexpr std::size_t error_bits = 40;
  if (f.error == 0) {
    mp_bitcnt_t zeros = ~mp_bitcnt_t{0};
    for (const Integer& c : f.b) {
      if (c != 0) zeros = std::min(zeros, mpz_scan1(c.get_mpz_t(), 0));
    }
    for (Integer& c : f.b) c >>= zeros;
    return;
  }
  const std::size_t bits = mpz_sizeinbase(f.error.get_mpz_t(), 2);
  if (bits <= error_bits) return;
  const mp_bitcnt_t excess = bits - error_bits;
  for (Integer& c : f.b) c >>= excess;  // down, by less than one
  f.error >>= excess;
  f.error += 2;
}

// Splits f at the middle of its interval: `f` becomes the left half, the result is
// the right one. De Casteljau's scheme without its divisions by two: after j
// rounds an entry is too large by 2^j, which is made up to 2^n everywhere.
Bernstein split(Bernstein& f) {
  const std::size_t n = f.degree();
  std::vector<Integer> row = f.b;
  f.error <<= n;
  Bernstein right{std::vector<Integer>(n + 1), f.error};
  for (std::size_t j = 0; j <= n; ++j) {
    f.b[j] = row[0] << (n - j);
    right.b[n - j] = row[n - j] << (n - j);
    for (std::size_t i = 0; i < n - j; ++i) row[i] += row[i + 1];
  }
  shorten(f);
  shorten(right);
  return right;
}

// The greatest number of sign variations that the coefficients can have, given the
// exact signs of the first and the last.
int max_sign_variations(const Bernstein& f, Sign first, Sign last) {
  // The most variations of the sequence so far that ends with a sign.
  constexpr int impossible = -1000;
  int positive = impossible;
  int negative = impossible;
  bool begun = false;
  for (std::size_t i = 0; i <= f.degree(); ++i) {
    const Sign s = i == 0 ? first : i == f.degree() ? last : f.sign(i);
    if (s == Sign::zero) continue;
    const int to_positive = begun ? std::max(positive, negative + 1) : 0;
    const int to_negative = begun ? std::max(negative, positive + 1) : 0;
    // An unknown one may be zero too, but no sequence gains from a zero.
    positive = s == Sign::negative ? impossible : to_positive;
    negative = s == Sign::positive ? impossible : to_negative;
    begun = true;
  }
  return begun ? std::max(positive, negative) : 0;
}

// Bisection by Descartes' rule. Signs at interval ends are exact: where the
// coefficients leave one open, the polynomial itself is asked.
template <class T>
class Isolation {
 public:
  Isolation(const Polynomial<T>& f, const SignEvaluator<T>& sign_at, long precision)
      : approximation_(approximate(f, precision)), sign_at_(sign_at), max_depth_(precision) {}

  // The roots in [lo, hi], lo < hi; nullopt if the precision is too low, or the
  // depth (which equals it) too small, as for every multiple root.
  std::optional<std::vector<RootInterval>> run(const Rational& lo, const Rational& hi) {
    roots_.clear();
    const Bernstein f = bernstein_on(approximation_, lo, hi);
    const End first = end(lo, f.sign(0));
    const End last = end(hi, f.sign(f.degree()));
    if (first.sign == Sign::zero) roots_.push_back({lo, lo});
    if (!run_inside(f, first, last, 0)) return std::nullopt;
    if (last.sign == Sign::zero) roots_.push_back({hi, hi});
    return roots_;
  }

  // Whether bisection is not even needed to see that there is no root in [lo, hi].
  bool is_plainly_rootless(const Rational& lo, const Rational& hi) const {
    const Bernstein f = bernstein_on(approximation_, lo, hi);
    const Sign first = f.sign(0);
    const Sign last = f.sign(f.degree());
    const bool ends_known = first != Sign::zero && last != Sign::zero && first != Sign::unknown;
    return ends_known && first == last && max_sign_variations(f, first, last) == 0;
  }

 private:
  struct End {
    Rational at;
    Sign sign;
  };
  End end(const Rational& x, Sign approximate) const {
    return {x, approximate == Sign::unknown ? sign_at_(x) : approximate};
  }

  bool run_inside(Bernstein f, const End& lo, const End& hi, long depth) {
    const int variations = max_sign_variations(f, lo.sign, hi.sign);
    if (variations == 0) return true;
    // Signs at both ends fix the parity: if there is one at most, there is one.
    if (variations == 1 && lo.sign != Sign::zero && hi.sign != Sign::zero) {
      roots_.push_back({lo.at, hi.at});
      return true;
    }
    if (depth == max_depth_ || f.is_exhausted()) return false;
    Bernstein right = split(f);
    const End middle = end(midpoint(lo.at, hi.at), right.sign(0));
    if (!run_inside(std::move(f), lo, middle, depth + 1)) return false;
    if (middle.sign == Sign::zero) roots_.push_back({middle.at, middle.at});
    return run_inside(std::move(right), middle, hi, depth + 1);
  }

  Approximation approximation_;
  const SignEvaluator<T>& sign_at_;
  long max_depth_;
  std::vector<RootInterval> roots_;
};

constexpr long first_precision = 64;
// Without success up to here, multiple roots are looked for. Over the rationals the
// precision is a mere depth, and the square-free part is cheap.
template <class T>
constexpr long last_hopeful_precision = 1024;
template <>
constexpr long last_hopeful_precision<Rational> = first_precision;

template <class T>
std::vector<RootInterval> isolate_by_descartes(const Polynomial<T>& f, const Rational& lo,
                                               const Rational& hi) {
  const SignEvaluator<T> sign_at(f);
  for (long precision = first_precision; precision <= last_hopeful_precision<T>; precision *= 2) {
    if (auto roots = Isolation<T>(f, sign_at, precision).run(lo, hi)) return *std::move(roots);
  }
  const Polynomial<T> simple = square_free_part(f);
  const SignEvaluator<T> sign_of_simple(simple);
  for (long precision = 2 * first_precision;; precision *= 2) {
    if (auto roots = Isolation<T>(simple, sign_of_simple, precision).run(lo, hi)) {
      return *std::move(roots);
    }
  }
}

template <class T>
void require_not_zero(const Polynomial<T>& f) {
  if (f.is_zero()) throw std::invalid_argument("the zero polynomial has no isolated roots");
}

}  // namespace

template <class T>
SignsAround signs_around(const Polynomial<T>& f, const RootInterval& root) {
  require_not_zero(f);
  if (!root.is_point()) return {sign_at(f, root.lo), sign_at(f, root.hi)};
  // The first derivative that does not vanish decides.
  Polynomial<T> derivative = f;
  Sign before = Sign::positive;
  Sign after = sign_at(derivative, root.lo);
  while (after == Sign::zero) {
    derivative = derivative.derivative();
    before = -before;
    after = sign_at(derivative, root.lo);
  }
  return {before * after, after};
}

// ---- Isolation and refinement ------------------------------------------------------

template <class T>
std::vector<RootInterval> isolate_roots(const Polynomial<T>& f, const Rational& lo,
                                        const Rational& hi) {
  require_not_zero(f);
  if (lo > hi) throw std::invalid_argument("isolate_roots: an interval with lo > hi");
  if (lo == hi) {
    if (sign_at(f, lo) != Sign::zero) return {};
    return {{lo, hi}};
  }
  if (f.degree() == 0) return {};
  if (const auto rational = as_rational(f)) return isolate_by_descartes(*rational, lo, hi);
  return isolate_by_descartes(f, lo, hi);
}

template <class T>
bool is_plainly_rootless(const Polynomial<T>& f, const Rational& lo, const Rational& hi) {
  if (f.is_zero()) return false;
  return Isolation<T>(f, SignEvaluator<T>(f), last_hopeful_precision<T>)
      .is_plainly_rootless(lo, hi);
}

template <class T>
void halve(const SignEvaluator<T>& f, Sign at_lo, RootInterval& root) {
  const Rational middle = midpoint(root.lo, root.hi);
  const Sign at_middle = f(middle);
  if (at_middle == Sign::zero) {
    root = {middle, middle};
  } else if (at_middle == at_lo) {
    root.lo = middle;
  } else {
    root.hi = middle;
  }
}

namespace {

// How many bisections an interval takes to be no wider than `width`.
unsigned long halvings_to(const Rational& width, const RootInterval& interval) {
  if (width <= 0) throw std::invalid_argument("refine: the width must be positive");
  const Rational ratio = (interval.hi - interval.lo) / width;
  if (ratio <= 1) return 0;
  const Integer whole = (ratio.get_num() + ratio.get_den() - 1) / ratio.get_den();
  return mpz_sizeinbase(Integer(whole - 1).get_mpz_t(), 2);
}

// Does that number of bisections at once, if the root is where the secant foretells it.
template <class T>
bool leap(const SignEvaluator<T>& f, Sign at_lo, RootInterval& root, unsigned long halvings) {
  const Rational width = root.hi - root.lo, part = width >> halvings;
  const Rational near = root.lo + width * f.secant(root.lo, root.hi, halvings);
  const Sign at_near = near == root.lo ? at_lo : near == root.hi ? -at_lo : f(near);
  if (at_near == Sign::zero) {
    root = {near, near};
    return true;
  }
  const bool beyond = at_near == at_lo;
  const Rational other = near + (beyond ? part : Rational(-part));
  const Sign at_other = other == root.lo ? at_lo : other == root.hi ? -at_lo : f(other);
  if (at_other == Sign::zero) {
    root = {other, other};
    return true;
  }
  if (at_other == at_near) return false;
  root = beyond ? RootInterval{near, other} : RootInterval{other, near};
  return true;
}

}  // namespace

template <class T>
void refine(const SignEvaluator<T>& f, Sign at_lo, RootInterval& root, const Rational& width) {
  constexpr unsigned long first_leap = 4;
  unsigned long left = halvings_to(width, root), next = first_leap;
  while (left > 0 && !root.is_point()) {
    const unsigned long halvings = std::min(next, left);
    if (halvings >= first_leap && leap(f, at_lo, root, halvings)) {
      left -= halvings;
      next *= 2;
    } else {
      halve(f, at_lo, root);
      --left;
      next = std::max(first_leap, next / 2);
    }
  }
}

template <class T>
void refine(const Polynomial<T>& f, RootInterval& root, const Rational& width) {
  if (halvings_to(width, root) == 0) return;
  const SignsAround ends = signs_around(f, root);
  const SignEvaluator<T> evaluator(ends.before == ends.after ? square_free_part(f) : f);
  refine(evaluator, evaluator(root.lo), root, width);
}

#define VOROPROOF_INSTANTIATE(T)                                                             \
  template SignsAround signs_around(const Polynomial<T>&, const RootInterval&);              \
  template std::vector<RootInterval> isolate_roots(const Polynomial<T>&, const Rational&,    \
                                                   const Rational&);                         \
  template bool is_plainly_rootless(const Polynomial<T>&, const Rational&, const Rational&); \
  template void halve(const SignEvaluator<T>&, Sign, RootInterval&);                         \
  template void refine(const SignEvaluator<T>&, Sign, RootInterval&, const Rational&);       \
  template void refine(const Polynomial<T>&, RootInterval&, const Rational&);
VOROPROOF_INSTANTIATE(Rational)
VOROPROOF_INSTANTIATE(Tower)
#undef VOROPROOF_INSTANTIATE

}  // namespace voroproof::internal
