// Exact numbers between Python and the library: Fraction, int, float, Decimal and text one way,
// Fraction the other.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "voroproof/number.h"

namespace voroproof::python {

// Throws std::invalid_argument for text that is no number and for floats that are not finite, and
// pybind11::cast_error for an object that is none of these.
Number number_of(pybind11::handle object);
pybind11::object fraction(const Number& number);

}  // namespace voroproof::python

namespace pybind11::detail {

template <>
struct type_caster<voroproof::Number> {
  PYBIND11_TYPE_CASTER(voroproof::Number, const_name("Fraction"));

  bool load(handle source, bool) {
    try {
      value = voroproof::python::number_of(source);
    } catch (const cast_error&) {
      return false;
    }
    return true;
  }
  static handle cast(const voroproof::Number& number, return_value_policy, handle) {
    return voroproof::python::fraction(number).release();
  }
};

}  // namespace pybind11::detail
