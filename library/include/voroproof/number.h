// Exact numbers as values: what scenes are made of.
#pragma once

#include <string>

#include "voroproof/export.h"

namespace voroproof {

namespace internal {
struct NumberAccess;
}

// A rational number. It does not calculate: it holds what was given, exactly.
class VOROPROOF_API Number {
 public:
  Number() = default;  // zero
  // The binary64 itself. Throws std::invalid_argument where it is not finite.
  Number(double x);               // NOLINT(google-explicit-constructor): a number is a number
  Number(int x) : nearest_(x) {}  // NOLINT(google-explicit-constructor)
  // A decimal ("0.1", "1e-3"), a fraction ("1/3") or a hexadecimal float ("0x1.8p-3"), exactly as
  // it denotes. Throws std::invalid_argument where the text is none of them.
  explicit Number(const std::string& text);

  // The nearest binary64, ties to even.
  double nearest() const { return nearest_; }
  bool is_double() const { return exact_.empty(); }
  // The shortest decimal that reads back as the binary64, else "p/q" in lowest terms: what
  // Number(text) takes.
  std::string text() const;

  friend bool operator==(const Number& a, const Number& b) {
    return a.nearest_ == b.nearest_ && a.exact_ == b.exact_;
  }
  friend bool operator!=(const Number& a, const Number& b) { return !(a == b); }

 private:
  friend struct internal::NumberAccess;
  double nearest_ = 0;
  std::string exact_;  // "p/q" where it is no binary64
};

// A number of which the library knows bounds: lower <= number <= upper, as near as binary64 allows
// where not said otherwise.
struct Enclosure {
  double lower = 0, upper = 0;
};

}  // namespace voroproof
