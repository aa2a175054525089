// How times, and by exact/names.h generators, appear in the sentences of a certificate.
#pragma once

#include <string>

#include "exact/names.h"
#include "history/json_text.h"

namespace voroproof::internal {

inline std::string between(double lo, double hi) {
  return "at a time in [" + number_text(lo) + ", " + number_text(hi) + "]";
}

}  // namespace voroproof::internal
