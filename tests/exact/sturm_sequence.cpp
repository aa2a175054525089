#include "tests/exact/sturm_sequence.h"

#include <stdexcept>
#include <utility>

namespace voroproof::internal::testing {

namespace {

// The positive multiple of f in which sequences of remainders stay small.
Polynomial<Rational> tamed(const Polynomial<Rational>& f) {
  return from_integers(primitive_integers(f));
}
Polynomial<Tower> tamed(const Polynomial<Tower>& f) {
  if (f.is_zero()) return f;
  if (const auto rational = as_rational(f)) return over_tower(tamed(*rational));
  const Tower magnitude = sign(f.leading()) == Sign::negative ? -f.leading() : f.leading();
  return f * (Tower(1) / magnitude);
}

}  // namespace

template <class T>
SturmSequence<T>::SturmSequence(const Polynomial<T>& f) {
  if (f.is_zero()) throw std::invalid_argument("the zero polynomial has no Sturm sequence");
  std::vector<Polynomial<T>> sequence{tamed(f)};
  Polynomial<T> next = tamed(f.derivative());
  while (!next.is_zero()) {
    sequence.push_back(std::move(next));
    const std::size_t last = sequence.size() - 1;
    next = tamed(-divide(sequence[last - 1], sequence[last]).remainder);
  }
  // The last one is gcd(f, f'). Divided by it, the sequence is one of the
  // square-free part; elsewhere than at repeated roots nothing changes.
  const Polynomial<T> repeated = sequence.back();
  for (const Polynomial<T>& p : sequence) {
    sequence_.emplace_back(repeated.degree() > 0 ? divide(p, repeated).quotient : p);
  }
}

template <class T>
typename SturmSequence<T>::End SturmSequence<T>::end(const Rational& x) const {
  End result{x, 0, false};
  Sign last = Sign::zero;
  for (const SignEvaluator<T>& p : sequence_) {
    const Sign s = p(x);
    if (&p == &sequence_.front()) result.is_root = s == Sign::zero;
    if (s == Sign::zero) continue;
    if (s == -last) ++result.variations;
    last = s;
  }
  return result;
}

template <class T>
int SturmSequence<T>::count(const Rational& lo, const Rational& hi) const {
  if (lo > hi) throw std::invalid_argument("SturmSequence: an interval with lo > hi");
  return end(lo).variations - end(hi).variations;
}

template <class T>
void SturmSequence<T>::isolate_inside(const End& lo, const End& hi,
                                      std::vector<RootInterval>& roots) const {
  const int inside = lo.variations - hi.variations - (hi.is_root ? 1 : 0);
  if (inside == 0) return;
  if (inside == 1 && !lo.is_root && !hi.is_root) {
    roots.push_back({lo.at, hi.at});
    return;
  }
  const End middle = end((lo.at + hi.at) / 2);
  isolate_inside(lo, middle, roots);
  if (middle.is_root) roots.push_back({middle.at, middle.at});
  isolate_inside(middle, hi, roots);
}

template <class T>
std::vector<RootInterval> SturmSequence<T>::isolate(const Rational& lo, const Rational& hi) const {
  if (lo > hi) throw std::invalid_argument("SturmSequence: an interval with lo > hi");
  const End first = end(lo);
  const End last = end(hi);
  std::vector<RootInterval> roots;
  if (first.is_root) roots.push_back({lo, lo});
  if (lo == hi) return roots;
  isolate_inside(first, last, roots);
  if (last.is_root) roots.push_back({hi, hi});
  return roots;
}

template class SturmSequence<Rational>;
template class SturmSequence<Tower>;

}  // namespace voroproof::internal::testing
