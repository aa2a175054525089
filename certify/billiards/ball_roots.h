// Where a polynomial falls below zero, whose coefficients are balls.
#pragma once

#include <optional>
#include <vector>

#include "exact/ball.h"

namespace voroproof::internal {

// The first u in [0, length] at which the polynomial comes to zero and falls; none where it is
// positive throughout. Its coefficients are from the constant term up. Precondition: f(0) > 0 for
// all polynomials in the balls. Throws TooCoarse where the balls do not tell.
std::optional<Ball> first_fall(const std::vector<Ball>& f, const Rational& length);

}  // namespace voroproof::internal
