#include "exact/rational.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace voroproof::internal {
namespace {

// ---- Rounding --------------------------------------------------------------

enum class Magnitude { towards_zero, nearest, away };

// q > 0. Written with integers only, so that neither the processor's rounding
// mode nor a second rounding at subnormals can touch the result.
double round_magnitude(const Rational& q, Magnitude mode) {
  constexpr int precision = std::numeric_limits<double>::digits;
  constexpr long max_exponent = std::numeric_limits<double>::max_exponent - 1;
  constexpr long min_unit = std::numeric_limits<double>::min_exponent - precision;
  constexpr double infinity = std::numeric_limits<double>::infinity();

  Integer numerator = q.get_num();
  Integer denominator = q.get_den();
  // exponent := floor(log2 q); the bit lengths give it up to one.
  long exponent = static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) -
                  static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  {
    const Integer scaled_numerator = exponent < 0 ? Integer(numerator << -exponent) : numerator;
    const Integer scaled_denominator =
        exponent > 0 ? Integer(denominator << exponent) : denominator;
    if (scaled_numerator < scaled_denominator) --exponent;
  }
  if (exponent > max_exponent) {
    return mode == Magnitude::towards_zero ? std::numeric_limits<double>::max() : infinity;
  }

  // q = (integer + remainder / denominator) 2^unit, the integer below 2^53.
  long unit = std::max(exponent - (precision - 1), min_unit);
  if (unit < 0) {
    numerator <<= -unit;
  } else {
    denominator <<= unit;
  }
  Integer integer, remainder;
  mpz_fdiv_qr(integer.get_mpz_t(), remainder.get_mpz_t(), numerator.get_mpz_t(),
              denominator.get_mpz_t());
  bool increase = false;
  if (mode == Magnitude::away) {
    increase = remainder != 0;
  } else if (mode == Magnitude::nearest) {
    const int half = cmp(Integer(2 * remainder), denominator);
    increase = half > 0 || (half == 0 && mpz_odd_p(integer.get_mpz_t()));
  }
  if (increase) ++integer;
  if (mpz_sizeinbase(integer.get_mpz_t(), 2) > static_cast<std::size_t>(precision)) {
    integer >>= 1;  // it is 2^53
    ++unit;
  }
  if (unit > max_exponent - (precision - 1)) return infinity;
  return std::ldexp(integer.get_d(), static_cast<int>(unit));
}

// Whether q is a binary64 for certain: a short numerator over a power of two within the range of
// normal numbers. Most numbers are, and need no rounding.
bool is_plain_double(const Rational& q) {
  const mpz_srcptr numerator = q.get_num_mpz_t(), denominator = q.get_den_mpz_t();
  const std::size_t bits = mpz_sizeinbase(numerator, 2);
  const std::size_t below = mpz_sizeinbase(denominator, 2) - 1;
  return bits <= 53 && below <= 1000 && mpz_scan1(denominator, 0) == below;
}

double round_with(const Rational& q, Magnitude if_positive, Magnitude if_negative) {
  if (sgn(q) == 0) return 0;
  if (is_plain_double(q)) return q.get_d();
  if (sgn(q) > 0) return round_magnitude(q, if_positive);
  const double magnitude = round_magnitude(Rational(-q), if_negative);
  return magnitude == 0 ? 0 : -magnitude;
}

// ---- Reading ---------------------------------------------------------------

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hexadecimal_digit(char c) {
  return is_decimal_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

Rational power(unsigned long base, long exponent) {
  Integer magnitude;
  mpz_ui_pow_ui(magnitude.get_mpz_t(), base, static_cast<unsigned long>(std::abs(exponent)));
  Rational result(magnitude);
  if (exponent < 0) mpq_inv(result.get_mpq_t(), result.get_mpq_t());
  return result;
}

// Recursive descent over one number; the first fault met is kept in `fault`.
class NumberReader {
 public:
  explicit NumberReader(std::string_view text) : rest_(text) {}

  std::optional<Rational> read() {
    if (rest_.empty()) return refuse("is empty");
    if (rest_.size() > max_number_text) {
      return refuse("is longer than " + std::to_string(max_number_text) + " characters");
    }
    const bool negative = take('-');
    std::optional<Rational> value;
    if (rest_.starts_with("0x") || rest_.starts_with("0X")) {
      rest_.remove_prefix(2);
      value = read_scaled(hexadecimal);
    } else {
      value = read_decimal_or_fraction();
    }
    if (!value) return value;
    if (!rest_.empty()) return refuse("has text after the number");
    return negative ? Rational(-*value) : value;
  }

  const std::string& fault() const { return fault_; }

 private:
  struct Notation {
    int base;
    bool (*is_digit)(char);
    std::string_view exponent_marks;
    unsigned long exponent_base;
    int exponents_per_digit;  // base = exponent_base^exponents_per_digit
    long max_exponent;
  };
  static constexpr Notation decimal{10, is_decimal_digit, "eE", 10, 1, max_decimal_exponent};
  static constexpr Notation hexadecimal{16, is_hexadecimal_digit, "pP", 2, 4, max_binary_exponent};

  std::nullopt_t refuse(std::string why) {
    fault_ = std::move(why);
    return std::nullopt;
  }

  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::string take_digits(bool (*is_digit)(char)) {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_digit);
    std::string digits(rest_.begin(), end);
    rest_.remove_prefix(digits.size());
    return digits;
  }

  std::optional<Rational> read_decimal_or_fraction() {
    if (const std::size_t slash = rest_.find('/'); slash == std::string_view::npos) {
      return read_scaled(decimal);
    }
    const std::string numerator = take_digits(is_decimal_digit);
    if (numerator.empty() || !take('/')) return refuse("is not a fraction of two integers");
    const std::string denominator = take_digits(is_decimal_digit);
    if (denominator.empty()) return refuse("is not a fraction of two integers");
    Rational value{Integer(numerator, 10), Integer(denominator, 10)};
    if (value.get_den() == 0) return refuse("has a zero denominator");
    value.canonicalize();
    return value;
  }

  // digits [ '.' digits ] [ mark [ '+' | '-' ] digits ]
  std::optional<Rational> read_scaled(const Notation& notation) {
    std::string digits = take_digits(notation.is_digit);
    if (digits.empty()) return refuse("is not a number");
    long exponent = 0;
    if (take('.')) {
      const std::string fraction = take_digits(notation.is_digit);
      if (fraction.empty()) return refuse("has no digit after the point");
      digits += fraction;
      exponent -= notation.exponents_per_digit * static_cast<long>(fraction.size());
    }
    if (!rest_.empty() && notation.exponent_marks.find(rest_.front()) != std::string_view::npos) {
      rest_.remove_prefix(1);
      const std::optional<long> written = read_exponent(notation.max_exponent);
      if (!written) return std::nullopt;
      exponent += *written;
    }
    return Rational(Rational(Integer(digits, notation.base)) *
                    power(notation.exponent_base, exponent));
  }

  std::optional<long> read_exponent(long max_exponent) {
    const bool negative = take('-');
    if (!negative) take('+');
    const std::string digits = take_digits(is_decimal_digit);
    if (digits.empty()) return refuse("has no digit in its exponent");
    long exponent = 0;
    for (const char c : digits) {
      exponent = 10 * exponent + (c - '0');
      if (exponent > max_exponent) {
        return refuse("has an exponent beyond " + std::to_string(max_exponent));
      }
    }
    return negative ? -exponent : exponent;
  }

  std::string_view rest_;
  std::string fault_;
};

}  // namespace

Rational to_rational(double x) {
  if (!std::isfinite(x)) throw std::domain_error("to_rational: the double is not finite");
  return Rational(x);
}

double round_nearest(const Rational& q) {
  return round_with(q, Magnitude::nearest, Magnitude::nearest);
}
double round_down(const Rational& q) {
  return round_with(q, Magnitude::towards_zero, Magnitude::away);
}
double round_up(const Rational& q) {
  return round_with(q, Magnitude::away, Magnitude::towards_zero);
}

Rational rounding_breakpoint(double a, double b) {
  const auto value = [](double x) {
    if (std::isfinite(x)) return to_rational(x);
    const Rational limit = 2 * to_rational(std::ldexp(1.0, 1023));
    return x > 0 ? limit : Rational(-limit);
  };
  return (value(a) + value(b)) / 2;
}

std::size_t bit_size(const Rational& q) {
  return std::max(mpz_sizeinbase(q.get_num_mpz_t(), 2), mpz_sizeinbase(q.get_den_mpz_t(), 2));
}

std::optional<Rational> rational_sqrt(const Rational& q) {
  // A fraction in lowest terms is a square iff both its parts are.
  if (!mpz_perfect_square_p(q.get_num_mpz_t()) || !mpz_perfect_square_p(q.get_den_mpz_t())) {
    return std::nullopt;
  }
  return Rational(Integer(sqrt(q.get_num())), Integer(sqrt(q.get_den())));
}

std::optional<Rational> parse_rational(std::string_view text, std::string* reason) {
  NumberReader reader(text);
  std::optional<Rational> value = reader.read();
  if (!value && reason) *reason = reader.fault();
  return value;
}

}  // namespace voroproof::internal
