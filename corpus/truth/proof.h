// How a question was decided: the columns BITS and PROOF.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "exact/rational.h"

namespace voroproof::truth {

struct Proof {
  int bits = 0;  // 0: exact arithmetic alone
  std::string text() const { return std::to_string(bits) + (bits == 0 ? " exact" : " interval"); }
};

// The least precision at which `answer(bits)`, which intervals give, is there: it is held against
// the `exact` one. Both are right, or this program is wrong.
template <class Answer, class Ask>
Proof proof_of(const Answer& exact, const Ask& answer) {
  for (int bits = 53; bits <= 53 << 10; bits *= 2) {
    const std::optional<Answer> found = answer(bits);
    if (!found) continue;
    if (*found != exact) throw std::logic_error("truth: interval and exact arithmetic disagree");
    return {bits};
  }
  return {};
}

// That of a sign. Zeros have none by intervals.
template <class Ask>
Proof proof_of_sign(internal::Sign exact, const Ask& sign) {
  if (exact == internal::Sign::zero) return {};
  return proof_of(exact, [&](int bits) -> std::optional<internal::Sign> {
    const internal::Sign s = sign(bits);
    return internal::is_certain(s) ? std::optional(s) : std::nullopt;
  });
}

}  // namespace voroproof::truth
