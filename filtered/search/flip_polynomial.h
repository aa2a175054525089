// The flip polynomial of a quadruplet as a function of time: its values, its slopes and its
// coefficients over a window, in any number type that Motion gives sites in.
#pragma once

#include <array>

#include "exact/generators.h"
#include "exact/predicates.h"
#include "filtered/numbers/subdivision.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/edge_predicates.h"

namespace voroproof::internal {

// The sign of f just after a root of the flip polynomial phi, whose sign there is s:
// phi is f itself, or C where f = -C^2.
inline Sign cotangency_sign(Sign s, bool cocircular) { return cocircular ? Sign::negative : s; }

// The flip polynomial of q at the given sites.
template <class T>
T flip_value(const std::array<Site<T>, 4>& s, bool cocircular) {
  // The base is the last site everywhere: another base may turn the sign.
  return cocircular ? cocircularity(s[3], s[0], s[1], s[2]) : cotangency(s[0], s[1], s[2], s[3]);
}

template <class T>
T flip_value(const Motion& m, const Quad& q, const T& t, bool cocircular) {
  return flip_value(sites(m, q, t), cocircular);
}

// The flip polynomial's derivative in time at t, or over the interval t.
template <class T>
T flip_slope(const Motion& m, const Quad& q, const T& t, bool cocircular) {
  return flip_value(moving_sites(m, q, t), cocircular).slope;
}

// The flip polynomial over [a, b], unscaled Bernstein coefficients.
template <class T, class Make>
Coefficients<T> form_in(const Motion& motion, const Quad& q, const Rational& a, const Rational& b,
                        bool cocircular, const Make& make) {
  const std::array<Site<T>, 4> at_a = sites(motion, q, make(a));
  const std::array<Site<T>, 4> at_b = sites(motion, q, make(b));
  const auto x = [&](int i, int j) {
    return Form<T, 1>{{at_a[i].x - at_a[j].x, at_b[i].x - at_b[j].x}};
  };
  const auto y = [&](int i, int j) {
    return Form<T, 1>{{at_a[i].y - at_a[j].y, at_b[i].y - at_b[j].y}};
  };
  const auto p = [&](int i, int j) {
    return tangency_of(x(i, j), y(i, j), Form<T, 0>{{at_a[i].r - at_a[j].r}});
  };
  if (cocircular) {
    const auto term = [&](int k, int i, int j) {
      return cocircularity_term(p(k, 3), x(i, 3), y(i, 3), x(j, 3), y(j, 3));
    };
    return unscaled(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1), make);
  }
  return unscaled(cotangency_of(p(0, 1) * p(2, 3), p(0, 2) * p(1, 3), p(0, 3) * p(1, 2)), make);
}

}  // namespace voroproof::internal
