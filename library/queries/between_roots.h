// A stretch of time, cut where one of several polynomials vanishes.
#pragma once

#include <functional>
#include <vector>

#include "exact/algebraic.h"
#include "exact/enclosure.h"

namespace voroproof::internal {

using AlgebraicTime = AlgebraicNumber<Rational>;

inline Enclosure enclosure(const AlgebraicTime& t) {
  return {round_down(t.interval().lo), round_up(t.interval().hi)};
}

// Whether two times are the same. Times of between_roots() are narrow: two that are still together
// are asked for a common root of their polynomials at once, where compare() would part them first.
bool same_time(const AlgebraicTime& a, const AlgebraicTime& b);

// Calls part(since, inside) for the parts between two roots in [from, to] (from < to), in order:
// since when, and a time within the part; the times are of the candidates' own polynomials, where
// these change their signs. Candidates that are zero do not count. Nothing is asked
// between an end of the stretch and a root within some 2^-60 of it: there a flip may be near whose
// recorded time is rounded.
void between_roots(const Rational& from, const Rational& to,
                   const std::vector<Polynomial<Rational>>& candidates,
                   const std::function<void(const AlgebraicTime&, const Rational&)>& part);

}  // namespace voroproof::internal
