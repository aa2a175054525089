// The roots of a Bernstein form in doubles: subdivision until the signs of the coefficients, each
// beyond the error bound, tell how many roots a piece has.
#pragma once

#include <array>

#include "exact/rational.h"
#include "filtered/bernstein.h"

namespace voroproof {

struct DoubleRoot {
  double lo, hi;    // times; the only root of the piece lies between
  double piece_hi;  // end of the piece, as a time
  Sign after;       // of the polynomial beyond the root
};

// The times of a piece's parameters; rounding moves them by less than `slack`.
struct TimeMap {
  double a, width, slack;
  TimeMap(double from, double to)
      : a(from), width(to - from), slack(4 * 0x1p-53 * (std::fabs(from) + std::fabs(to))) {}
  double operator()(double x) const { return a + width * x; }
};

namespace double_roots_detail {

constexpr int kMaxDepth = 24;

struct Piece {
  double u0, u1;  // the part of the window
  std::array<double, 9> c;
};

// How many roots a piece has: 0, 1 (a simple one, with certain signs at both ends), or
// -1: not known yet.
int count_roots(const Piece& p, int degree, double err);
void halve(int degree, const double* c, double* left, double* right);
// Narrows the root of a piece. False where the ends of the piece are too near.
bool narrow(const Piece& p, int degree, double err, const TimeMap& time, DoubleRoot& root);

}  // namespace double_roots_detail

// Roots of the form, first to last: calls `on_root(root)`, which says whether to go
// on. Returns the time up to which everything is decided: the end of the window
// unless the search was stopped or a piece cannot be decided.
template <class OnRoot>
double each_root(const BernsteinForm& form, double start, double end, OnRoot&& on_root) {
  using namespace double_roots_detail;
  const TimeMap time(start, end);
  Piece stack[kMaxDepth + 2];
  int top = 0;
  stack[0] = {0, 1, form.c};
  while (top >= 0) {
    const int roots = count_roots(stack[top], form.degree, form.err);
    if (roots == 0) {
      --top;
      continue;
    }
    if (roots == 1) {
      const Piece piece = stack[top];
      --top;
      DoubleRoot root;
      if (!narrow(piece, form.degree, form.err, time, root)) {
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

}  // namespace voroproof
