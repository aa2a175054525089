// The roots of a Bernstein form in doubles: subdivision until the signs of the coefficients, each
// beyond the error bound, tell how many roots a piece has.
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "exact/rational.h"
#include "exact/rounding.h"
#include "filtered/numbers/bernstein_form.h"
#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

struct DoubleRoot {
  double lo, hi;    // times; the only root of the piece lies between
  double piece_hi;  // end of the piece, as a time
  Sign after;       // sign of the polynomial beyond the root
};

// The times of a piece's parameters; rounding moves them by less than `slack`.
struct TimeMap {
  double a, width, slack;
  TimeMap(double from, double to)
      : a(from),
        width(to - from),
        slack(4 * unit_roundoff * (std::fabs(from) + std::fabs(to)) + DBL_MIN) {}
  double operator()(double x) const { return a + width * x; }
};

namespace double_roots_detail {

constexpr int kMaxDepth = 24;

struct Piece {
  double u0, u1;  // the part of the window
  std::array<double, 9> c;
};

// Bounds of the coefficients of a piece of degree 8: of the first four, the next four, the last.
struct Errors {
  Lanes low, high;
  double last;
};
// They grow or fall with the coefficient; none exceeds `err`.
Errors errors_of(const Piece& p, const GrowingBound& bound, double err);
inline double largest(const Errors& err) { return std::max(err.low[0], err.last); }
inline double largest(double err) { return err; }

// How many roots a piece has: 0, 1 (a simple one, with certain signs at both ends), or -1: not
// known yet. `err`: of every coefficient or of each.
int count_roots(const Piece& p, int degree, double err);
int count_roots(const Piece& p, int degree, const Errors& err);
void halve(int degree, const double* c, double* left, double* right);
// Narrows the root of a piece. False where the ends of the piece are too near.
bool narrow(const Piece& p, int degree, double err, const TimeMap& time, DoubleRoot& root);

// Does what each_root() below does; `errors(piece)` gives the error bounds of the piece's
// coefficients.
template <class ErrorsOf, class OnRoot>
double each_root(const BernsteinForm& form, const ErrorsOf& errors, double start, double end,
                 OnRoot&& on_root) {
  const TimeMap time(start, end);
  Piece stack[kMaxDepth + 2];
  int top = 0;
  stack[0] = {0, 1, form.c};
  while (top >= 0) {
    const auto err = errors(stack[top]);
    const int roots = count_roots(stack[top], form.degree, err);
    if (roots == 0) {
      --top;
      continue;
    }
    if (roots == 1) {
      const Piece piece = stack[top];
      --top;
      DoubleRoot root;
      if (!narrow(piece, form.degree, largest(err), time, root)) {
        return piece.u0 == 0 ? start : time(piece.u0) - time.slack;
      }
      if (!on_root(root)) return root.lo;
      continue;
    }
    const Piece piece = stack[top];
    if (piece.u1 - piece.u0 < 0x1p-23) {
      return piece.u0 == 0 ? start : time(piece.u0) - time.slack;
    }
    const double mid = 0.5 * (piece.u0 + piece.u1);
    stack[top].u0 = mid;
    stack[top].u1 = piece.u1;
    stack[top + 1].u0 = piece.u0;
    stack[top + 1].u1 = mid;
    halve(form.degree, piece.c.data(), stack[top + 1].c.data(), stack[top].c.data());
    ++top;
  }
  return end;
}

}  // namespace double_roots_detail

// Roots of the form, first to last: calls `on_root(root)`, which says whether to go
// on. Returns the time up to which everything is decided: the end of the window
// unless the search was stopped or a piece cannot be decided.
template <class OnRoot>
double each_root(const BernsteinForm& form, double start, double end, OnRoot&& on_root) {
  return double_roots_detail::each_root(
      form, [&](const double_roots_detail::Piece&) { return form.err; }, start, end, on_root);
}
// Finds the roots like each_root() above, by both bounds of a form of degree 8.
template <class OnRoot>
double each_root(const BernsteinForm& form, const GrowingBound& bound, double start, double end,
                 OnRoot&& on_root) {
  return double_roots_detail::each_root(
      form,
      [&](const double_roots_detail::Piece& p) {
        return double_roots_detail::errors_of(p, bound, form.err);
      },
      start, end, on_root);
}

}  // namespace voroproof::internal
