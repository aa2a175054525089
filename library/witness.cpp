#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

#include "exact/rational.h"
#include "library/values.h"

namespace voroproof::internal {
namespace {

// The value of "1.25e-700": a bound may be smaller than what files may hold.
Rational value_of(const std::string& decimal) {
  const std::size_t e = decimal.find('e');
  const std::optional<Rational> mantissa = parse_rational(decimal.substr(0, e));
  if (!mantissa) throw std::logic_error("witness: not a decimal: " + decimal);
  const long exponent = e == std::string::npos ? 0 : std::stol(decimal.substr(e + 1));
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(exponent)));
  return exponent < 0 ? Rational(*mantissa / power) : Rational(*mantissa * power);
}

Bounds bounds_of(const EvidenceNumber& n) {
  if (!n.exact.empty()) {
    const voroproof::Number exact = number(Rational(n.exact));
    return {exact, exact};
  }
  return {number(value_of(n.lower)), number(value_of(n.upper))};
}

WitnessMotion motion_of(const EvidenceMotion& m) {
  return {m.id,
          number(m.t0),
          bounds_of(m.x),
          bounds_of(m.y),
          bounds_of(m.vx),
          bounds_of(m.vy),
          bounds_of(m.radius)};
}

}  // namespace

voroproof::Witness witness_value(const Witness& witness) {
  voroproof::Witness out;
  for (const EvidenceMotion& m : witness.generators) out.generators.push_back(motion_of(m));
  out.polynomial_is = witness.polynomial_is;
  for (const EvidenceNumber& c : witness.polynomial) out.polynomial.push_back(bounds_of(c));
  if (witness.root) out.root = {number((*witness.root)[0]), number((*witness.root)[1])};
  if (witness.t) out.t = number(*witness.t);
  out.vertex = witness.vertex;
  out.contains = witness.conflict;
  return out;
}

}  // namespace voroproof::internal
