#include "voroproof/number.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exact/rational.h"
#include "history/json_text.h"
#include "library/values.h"

namespace voroproof {

Number::Number(double x) : nearest_(x + 0.0) {  // not -0
  if (!std::isfinite(x)) throw std::invalid_argument("voroproof::Number: not finite");
}

Number::Number(const std::string& text) {
  std::string reason;
  const auto value = internal::parse_rational(text, &reason);
  if (!value) throw std::invalid_argument("voroproof::Number: " + reason);
  *this = internal::number(*value);
}

std::string Number::text() const { return is_double() ? internal::number_text(nearest_) : exact_; }

namespace internal {

struct NumberAccess {
  // The fraction in lowest terms is no binary64; `nearest` is the nearest one.
  static voroproof::Number exactly(const std::string& fraction, double nearest) {
    voroproof::Number number;
    number.nearest_ = nearest;
    number.exact_ = fraction;
    return number;
  }
};

Rational rational(const voroproof::Number& number) {
  return number.is_double() ? to_rational(number.nearest()) : Rational(number.text());
}

voroproof::Number number(const Rational& q) {
  const double nearest = round_nearest(q);
  if (std::isfinite(nearest) && to_rational(nearest) == q) return nearest;
  return NumberAccess::exactly(q.get_str(), nearest);
}

Rational instant(const voroproof::Number& t) {
  Rational q = rational(t);
  if (q < 0) throw std::invalid_argument("t: negative");
  return q;
}

Rational probe_radius(const voroproof::Number& probe) {
  Rational q = rational(probe);
  if (q < 0) throw std::invalid_argument("probe: negative");
  return q;
}

MotionOptions motion_options(int max_bits) {
  constexpr int least = 64;
  if (max_bits < least) throw std::invalid_argument("max_bits: less than 64");
  MotionOptions options;
  options.max_bits = max_bits;
  options.start_bits = std::min(options.start_bits, max_bits);
  return options;
}

EngineOptions engine_options(int max_bits) {
  EngineOptions options;
  options.motion = motion_options(max_bits);
  return options;
}

voroproof::Enclosure enclosure_value(const Enclosure& enclosure) {
  return {enclosure.lo, enclosure.hi};
}

}  // namespace internal
}  // namespace voroproof
