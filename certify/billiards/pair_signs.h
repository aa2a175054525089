// The signs of a polynomial over an interval, exactly.
#pragma once

#include <optional>
#include <vector>

#include "exact/algebraic.h"

namespace voroproof::internal {

// The sign of f just after u.
Sign sign_after(const Polynomial<Rational>& f, const Rational& u);

// The roots of f in [lo, hi]; none where it is zero.
std::vector<AlgebraicNumber<Rational>> roots_of(const Polynomial<Rational>& f, const Rational& lo,
                                                const Rational& hi);

// Where f goes from positive to negative in [lo, hi], or begins to fall at lo from zero.
std::optional<AlgebraicNumber<Rational>> first_fall(const Polynomial<Rational>& f,
                                                    const Rational& lo, const Rational& hi);

// Whether f is negative somewhere in [lo, hi].
bool is_negative_in(const Polynomial<Rational>& f, const Rational& lo, const Rational& hi);

}  // namespace voroproof::internal
