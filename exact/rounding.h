// The basis of all error bounds in doubles: IEEE 754 binary64, rounded to nearest after every
// operation.
//
// The compiler must neither contract a product and a sum to one operation nor reorder: that is
// asked for in packaging/cmake/Voroproof.cmake, and what can be seen of it at compile time is
// required here. The rest belongs to the thread at run time, where other code may have changed it:
// see require_ieee_arithmetic().
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "error bounds do not hold with -ffast-math or its parts"
#endif
static_assert(FLT_EVAL_METHOD == 0, "doubles must be computed as doubles");
static_assert(DBL_MANT_DIG == 53 && DBL_MIN_EXP == -1021 && DBL_MAX_EXP == 1024);

namespace voroproof::internal {

// The unit roundoff: a rounded result is within u of the true one, relative to either.
inline constexpr double unit_roundoff = 0x1p-53;

// Whether this thread computes so: to nearest, ties to even, with subnormal numbers and without
// contraction. Programs that are linked with -ffast-math turn subnormal numbers off at their start,
// and fesetround() turns the rounding.
bool arithmetic_is_ieee();

// Throws std::runtime_error where it does not.
void require_ieee_arithmetic();

}  // namespace voroproof::internal
