#include "kernel/roots.h"

#include <algorithm>

namespace voroproof_kernel {

Form operator+(const Form& p, const Form& q) {
  Form r(p);
  for (std::size_t k = 0; k < r.size(); ++k) r[k] += q[k];
  return r;
}
Form operator-(const Form& p, const Form& q) {
  Form r(p);
  for (std::size_t k = 0; k < r.size(); ++k) r[k] -= q[k];
  return r;
}
Form operator*(const Form& p, const Form& q) {
  Form r(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) r[i + j] += p[i] * q[j];
  }
  return r;
}

int variations(const Form& p) {
  int changes = 0, last = 0;
  for (const Int& c : p) {
    const int s = sgn(c);
    changes += s * last < 0;
    if (s != 0) last = s;
  }
  return changes;
}

bool is_zero(const Form& p) {
  return std::all_of(p.begin(), p.end(), [](const Int& c) { return c == 0; });
}

// Over the right half z = 1 + 2w; the left half is the mirror image.
void halve(const Form& p, Form& left, Form& right) {
  const auto upper = [](Form& q) {
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
      for (std::size_t k = q.size() - 1; k-- > i;) q[k] += q[k + 1];
    }
    for (std::size_t k = 1; k < q.size(); ++k) q[k] <<= k;
  };
  right = p;
  left.assign(p.rbegin(), p.rend());
  upper(right);
  upper(left);
  std::reverse(left.begin(), left.end());
}

// z = ((a2 - a) + w (b2 - a)) / ((b - a2) + w (b - b2)), in Horner's scheme.
Form restricted(const Form& p, const Rat& a, const Rat& b, const Rat& a2, const Rat& b2) {
  if (a == a2 && b == b2) return p;
  const Rat of[] = {a2 - a, b2 - a, b - a2, b - b2};
  Int scale = 1;
  for (const Rat& x : of) scale = lcm(scale, Int(denominator(x)));
  Int c[4];
  for (int k = 0; k < 4; ++k) c[k] = numerator(Rat(of[k] * scale));
  const Form above{c[0], c[1]}, below{c[2], c[3]};
  Form result{p.back()}, power{1};
  for (std::size_t k = p.size() - 1; k-- > 0;) {
    power = power * below;
    result = result * above + Form{p[k]} * power;
  }
  return result;
}

namespace {

// Without zero coefficients at the ends (roots at the ends of the interval) and common factors.
void make_primitive(Form& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  p.erase(p.begin(), std::find_if(p.begin(), p.end(), [](const Int& c) { return c != 0; }));
  Int content = 0;
  for (const Int& c : p) content = gcd(content, c);
  for (Int& c : p) c /= content;
}

// p modulo q up to a constant, by whole numbers; with `quotient`, p / q, a division without rest.
Form remainder(Form p, const Form& q, Form* quotient = nullptr) {
  if (quotient != nullptr) quotient->assign(p.size() - q.size() + 1, 0);
  while (p.size() >= q.size()) {
    const std::size_t shift = p.size() - q.size();
    if (quotient == nullptr) {
      const Int g = gcd(p.back(), q.back()), up = q.back() / g, by = p.back() / g;
      for (Int& c : p) c *= up;
      for (std::size_t k = 0; k < q.size(); ++k) p[k + shift] -= by * q[k];
    } else {
      const Int by = p.back() / q.back();
      (*quotient)[shift] = by;
      for (std::size_t k = 0; k < q.size(); ++k) p[k + shift] -= by * q[k];
    }
    p.pop_back();
  }
  return p;
}

}  // namespace

Form common(Form p, Form q) {
  make_primitive(p);
  make_primitive(q);
  while (!q.empty()) {
    if (p.size() < q.size()) std::swap(p, q);
    p = remainder(std::move(p), q);
    make_primitive(p);
    std::swap(p, q);
  }
  return p;
}

Form squarefree(const Form& p) {
  Form whole(p);
  make_primitive(whole);
  if (whole.size() < 2) return whole;
  Form derivative(whole.begin() + 1, whole.end());
  for (std::size_t k = 0; k < derivative.size(); ++k) derivative[k] *= k + 1;
  const Form g = common(whole, derivative);
  Form result;
  remainder(whole, g, &result);
  return result;
}

Instant at(const Rat& t) { return {t, t, {}, t, t}; }

void Instant::refine() {
  form = restricted(form, a, b, lo, hi);
  const Rat middle = (lo + hi) / 2;
  Form left, right;
  halve(form, left, right);
  if (variations(left) % 2 == 1) {
    hi = middle;
    form = std::move(left);
  } else if (variations(right) % 2 == 1) {
    lo = middle;
    form = std::move(right);
  } else {
    lo = hi = middle;
  }
  a = lo;
  b = hi;
}

int compare(Instant& x, const Rat& t) {
  if (x.is_point()) return x.lo < t ? -1 : x.lo > t;
  if (t <= x.lo) return 1;
  if (t >= x.hi) return -1;
  if (variations(restricted(x.form, x.a, x.b, x.lo, t)) % 2 == 1) {
    x.hi = t;
    return -1;
  }
  if (variations(restricted(x.form, x.a, x.b, t, x.hi)) % 2 == 1) {
    x.lo = t;
    return 1;
  }
  x = at(t);
  return 0;
}

int compare(Instant& x, Instant& y) {
  for (int round = 0;; ++round) {
    if (y.is_point()) return compare(x, Rat(y.lo));
    if (x.is_point()) return -compare(y, Rat(x.lo));
    if (x.hi <= y.lo) return -1;
    if (y.hi <= x.lo) return 1;
    if (round % 16 == 8) {
      const Rat lo = std::max(x.lo, y.lo), hi = std::min(x.hi, y.hi);
      const Form g =
          common(restricted(x.form, x.a, x.b, lo, hi), restricted(y.form, y.a, y.b, lo, hi));
      if (variations(g) % 2 == 1) return 0;
    }
    x.refine();
    if (!y.is_point()) y.refine();
  }
}

}  // namespace voroproof_kernel
