// How many roots a polynomial has in a window, by the signs of its Bernstein coefficients there
// (Descartes' rule: as many as their sign variations, or fewer by an even number).
#pragma once

#include <bit>

namespace voroproof::internal {

// Bit k of `positive` (of `negative`): coefficient k is certainly so; the others have any sign.
// Returns the number of roots, 0 or 1, or -1 where the signs do not tell: the polynomial may have
// more roots than one, or a root at an end.
inline int roots_by_signs(unsigned positive, unsigned negative, int degree) {
  const unsigned all = (2U << degree) - 1;
  const unsigned uncertain = all & ~(positive | negative);
  if (uncertain != 0) {
    // One uncertain coefficient between different signs changes nothing: it may have either.
    // Anything else, and one at an end, is not known.
    const unsigned between =
        ((positive << 1) & (negative >> 1)) | ((negative << 1) & (positive >> 1));
    if ((uncertain & ~between) != 0) return -1;
    positive |= uncertain;
  }
  const int variations = std::popcount((positive ^ (positive >> 1)) & (all >> 1));
  return variations <= 1 ? variations : -1;
}

}  // namespace voroproof::internal
