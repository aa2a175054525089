// Polynomials over a window of time in the scaled Bernstein basis, of a degree known when the
// program is compiled, over any number type: doubles, four doubles side by side, balls.
#pragma once

#include <array>

namespace voroproof::internal {

// The coefficients of a polynomial in the Bernstein basis, each times its binomial (degree over k):
// products are plain convolutions so. A form of degree 1 is a linear function, given by its values
// at both ends; one of degree 0 is a constant.
template <class T, int degree>
struct Form {
  std::array<T, degree + 1> c;
};

// The binomials of degree n.
template <int n>
constexpr std::array<int, n + 1> binomials() {
  std::array<int, n + 1> out{1};
  for (int k = 1; k <= n; ++k) out[k] = out[k - 1] * (n - k + 1) / k;
  return out;
}

namespace form_detail {

// All of this must end up in line: loops over coefficients would keep them in memory.
template <int degree, class T, class Coefficient, int... k>
[[gnu::always_inline]] inline Form<T, degree> made(const Coefficient& of,
                                                   std::integer_sequence<int, k...>) {
  return {{of(std::integral_constant<int, k>{})...}};
}
template <int degree, class T, class Coefficient>
[[gnu::always_inline]] inline Form<T, degree> made(const Coefficient& of) {
  return made<degree, T>(of, std::make_integer_sequence<int, degree + 1>{});
}

// p_i q_(k-i) + ... + p_last q_(k-last)
template <int k, int i, int last, class P, class Q>
[[gnu::always_inline]] inline auto convolution(const P& p, const Q& q) -> typename P::value_type {
  if constexpr (i == last) {
    return p[i] * q[k - i];
  } else {
    return p[i] * q[k - i] + convolution<k, i + 1, last>(p, q);
  }
}

}  // namespace form_detail

template <class T, int n>
[[gnu::always_inline]] inline Form<T, n> operator+(const Form<T, n>& p, const Form<T, n>& q) {
  return form_detail::made<n, T>([&](auto k) -> T { return p.c[k] + q.c[k]; });
}
template <class T, int n>
[[gnu::always_inline]] inline Form<T, n> operator-(const Form<T, n>& p, const Form<T, n>& q) {
  return form_detail::made<n, T>([&](auto k) -> T { return p.c[k] - q.c[k]; });
}
// Minus a constant, which is a form of any degree with all coefficients equal. The binomials of
// degree 2 are all that is needed.
template <class T>
[[gnu::always_inline]] inline Form<T, 2> operator-(const Form<T, 2>& p, const Form<T, 0>& q) {
  return {{p.c[0] - q.c[0], p.c[1] - (q.c[0] + q.c[0]), p.c[2] - q.c[0]}};
}
template <class T, int n, int m>
[[gnu::always_inline]] inline Form<T, n + m> operator*(const Form<T, n>& p, const Form<T, m>& q) {
  return form_detail::made<n + m, T>([&](auto k) __attribute__((always_inline))->T {
    constexpr int first = k > m ? k - m : 0, last = k < n ? int{k} : n;
    return form_detail::convolution<k, first, last>(p.c, q.c);
  });
}
// The mixed products once, twice as large.
template <class T, int n>
[[gnu::always_inline]] inline Form<T, 2 * n> squared(const Form<T, n>& p) {
  const Form<T, n> twice = p + p;
  return form_detail::made<2 * n, T>([&](auto k) __attribute__((always_inline))->T {
    constexpr int first = k > n ? k - n : 0, last = (k - 1) / 2;
    if constexpr (first > last || k == 0) {
      return p.c[k / 2] * p.c[k / 2];
    } else if constexpr (k % 2 != 0) {
      return form_detail::convolution<k, first, last>(twice.c, p.c);
    } else {
      return form_detail::convolution<k, first, last>(twice.c, p.c) + p.c[k / 2] * p.c[k / 2];
    }
  });
}

}  // namespace voroproof::internal
