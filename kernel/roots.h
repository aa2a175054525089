// Polynomials over an interval of time, and instants that are their roots.
//
// Over [a, b] time is t = (a + z b)/(1 + z), z in (0, oo). A form of degree d is the polynomial in
// z that (1 + z)^d makes of a polynomial of degree d in t; c[0] is its value at a, c[d] that at b,
// up to positive factors. By Descartes' rule it has at most V roots in (a, b), V the sign changes
// of its coefficients, counted with multiplicity, and as many modulo 2.
#pragma once

#include <vector>

#include "kernel/numbers.h"

namespace voroproof_kernel {

struct Form : std::vector<Int> {
  using std::vector<Int>::vector;
};
Form operator+(const Form& p, const Form& q);  // of one degree
Form operator-(const Form& p, const Form& q);
Form operator*(const Form& p, const Form& q);

int variations(const Form& p);
bool is_zero(const Form& p);
// The forms over the two halves of the interval.
void halve(const Form& p, Form& left, Form& right);
// The form over [a2, b2] of a form over [a, b].
Form restricted(const Form& p, const Rat& a, const Rat& b, const Rat& a2, const Rat& b2);
// What has the same roots inside the interval, each once. p is not zero.
Form squarefree(const Form& p);
// The roots inside the interval that both have. Neither is zero.
Form common(Form p, Form q);

// A point of time lo = hi, or the only root, a simple one, of a form over [a, b] in (lo, hi).
struct Instant {
  Rat lo, hi;
  Form form;
  Rat a, b;
  bool is_point() const { return lo == hi; }
  // Halves (lo, hi), or finds that the root is its middle.
  void refine();
};
Instant at(const Rat& t);

// The sign of x - y, refining both. Ends always: equal roots are roots of a common divisor.
int compare(Instant& x, Instant& y);
int compare(Instant& x, const Rat& t);

}  // namespace voroproof_kernel
