#include "history/scene_value.h"

#include <cmath>

#include "history/scene.h"

namespace voroproof::internal {

CompactRational scene_value(JsonReader& json) {
  static const Rational largest = to_rational(max_scene_value);
  static const Rational smallest = to_rational(min_scene_value);
  const Number number = json.number();
  const auto check = [&](bool within) {
    if (!within) json.fail("beyond the limits of a scene: 0 or 1e-100 to 1e100 in magnitude");
  };
  if (!number.exact) {
    const double magnitude = std::fabs(number.nearest);
    check(magnitude == 0 || (magnitude <= max_scene_value && magnitude >= min_scene_value));
    return number.nearest;
  }
  const Rational& q = *number.exact;
  check(q == 0 || (abs(q) <= largest && abs(q) >= smallest));
  // A fraction is limited so that writers can always write what was read, as "p/q".
  const auto digits = [](mpz_srcptr z) { return mpz_sizeinbase(z, 10); };
  if (digits(q.get_num_mpz_t()) + digits(q.get_den_mpz_t()) + 2 > max_number_text)
    json.fail("a fraction of more than " + std::to_string(max_number_text) + " characters");
  return q;
}

std::variant<std::string, Integer> read_seed(JsonReader& json) {
  if (json.text_is_next()) return std::string(json.text());
  return json.big_integer();
}

}  // namespace voroproof::internal
