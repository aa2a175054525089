// How generators and times appear in the sentences of a certificate.
#pragma once

#include <string>

#include "exact/generators.h"
#include "history/json_text.h"

namespace voroproof {

inline std::string text(const Quad& q) {
  return "[" + std::to_string(q.l) + "," + std::to_string(q.r) + "," + std::to_string(q.s) + "," +
         std::to_string(q.e) + "]";
}
inline std::string text(GenId i, GenId j) {
  return "[" + std::to_string(i) + "," + std::to_string(j) + "]";
}
inline std::string between(double lo, double hi) {
  return "at a time in [" + number_text(lo) + ", " + number_text(hi) + "]";
}

}  // namespace voroproof
