// Real roots by Sturm sequences: a second way to the roots that exact/roots.h isolates.
#pragma once

#include <vector>

#include "exact/roots.h"

namespace voroproof::internal::testing {

// The Sturm sequence of the square-free part of f (not zero, or
// std::invalid_argument).
template <class T>
class SturmSequence {
 public:
  explicit SturmSequence(const Polynomial<T>& f);

  // The number of distinct roots of f in the half-open interval (lo, hi].
  int count(const Rational& lo, const Rational& hi) const;
  // Isolates as isolate_roots does, by this sequence alone.
  std::vector<RootInterval> isolate(const Rational& lo, const Rational& hi) const;

 private:
  struct End {  // of an interval
    Rational at;
    int variations;
    bool is_root;
  };
  End end(const Rational& x) const;
  void isolate_inside(const End& lo, const End& hi, std::vector<RootInterval>& roots) const;

  std::vector<SignEvaluator<T>> sequence_;
};

}  // namespace voroproof::internal::testing
