// The names of V-edges, V-vertices and pairs of generators as files and messages write them.
#pragma once

#include <string>

#include "exact/generators.h"

namespace voroproof::internal {

// "[l,r,s,e]"
inline std::string text_of(const Quad& q) {
  return "[" + std::to_string(q.l) + "," + std::to_string(q.r) + "," + std::to_string(q.s) + "," +
         std::to_string(q.e) + "]";
}

// "[i,j,k]"
inline std::string text_of(const Triple& v) {
  return "[" + std::to_string(v[0]) + "," + std::to_string(v[1]) + "," + std::to_string(v[2]) + "]";
}

// "[i,j]"
inline std::string text_of(GenId i, GenId j) {
  return "[" + std::to_string(i) + "," + std::to_string(j) + "]";
}

}  // namespace voroproof::internal
