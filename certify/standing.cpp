#include "certify/standing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "history/json_text.h"

namespace voroproof::internal {

Standing standing_of(Sign c_sign, Sign b_sign, Sign a_sign, double c, double b, double a,
                     double reach, bool wall) {
  Standing s{};
  s.apart = wall ? -c_sign : c_sign;
  s.parting = wall ? -b_sign : b_sign;
  s.at_rest = a_sign == Sign::zero;
  // sqrt(square) - reach, without cancellation.
  const auto beyond = [reach](double more) {
    return more / (std::sqrt(std::max(more + reach * reach, 0.0)) + reach);
  };
  s.gap = std::fabs(beyond(c));
  s.speed = std::fabs(b) / std::sqrt(std::max(c + reach * reach, 0.0));
  s.passes = !wall && s.apart == Sign::positive && s.parting == Sign::negative && a > 0;
  if (s.passes) s.least = std::max(beyond(c - b / a * b), 0.0);
  return s;
}

std::string amount(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

std::string text_of(const Standing& s, double t) {
  const std::string then = " at t = " + number_text(t);
  std::string text;
  if (s.apart == Sign::positive) {
    text = "do not touch:" + then + " they are " + amount(s.gap) + " apart";
    if (s.passes) text += ", and never nearer than " + amount(s.least);
    return text;
  }
  if (s.apart == Sign::negative) {
    text = "overlap by " + amount(s.gap) + then;
  } else if (s.apart == Sign::zero) {
    text = "touch" + then;
  } else {
    text = "touch" + then + ", or nearly";
  }
  if (s.at_rest) return text + ", and are at rest relative to each other";
  if (s.parting == Sign::positive) return text + ", and part at a speed of " + amount(s.speed);
  if (s.parting == Sign::negative) return text;
  return text + ", and do not approach";
}

}  // namespace voroproof::internal
