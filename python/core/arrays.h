// Vectors of the library as arrays of NumPy, and back.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "voroproof/history.h"

namespace voroproof::python {

// An array of shape (n, 2).
inline pybind11::array_t<double> array_of(const std::vector<Vector>& vectors) {
  pybind11::array_t<double> out(
      {static_cast<pybind11::ssize_t>(vectors.size()), pybind11::ssize_t{2}});
  auto to = out.mutable_unchecked<2>();
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    to(k, 0) = vectors[k][0];
    to(k, 1) = vectors[k][1];
  }
  return out;
}

// An array of shape (n, 4).
inline pybind11::array_t<std::int32_t> array_of(const std::vector<Edge>& edges) {
  pybind11::array_t<std::int32_t> out(
      {static_cast<pybind11::ssize_t>(edges.size()), pybind11::ssize_t{4}});
  auto to = out.mutable_unchecked<2>();
  for (std::size_t k = 0; k < edges.size(); ++k) {
    to(k, 0) = edges[k].l;
    to(k, 1) = edges[k].r;
    to(k, 2) = edges[k].s;
    to(k, 3) = edges[k].e;
  }
  return out;
}

// The rows themselves, for reading; the array keeps their owner.
template <class Row>
pybind11::array rows_of(const std::vector<Row>& rows, const pybind11::object& owner) {
  pybind11::array_t<Row> view(static_cast<pybind11::ssize_t>(rows.size()), rows.data(), owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

// The rows of an array of events, copied. Throws std::invalid_argument for another shape.
template <class Row>
std::vector<Row> rows_in(const pybind11::array_t<Row, pybind11::array::c_style>& events) {
  if (events.ndim() != 1) throw std::invalid_argument("events: not an array of one dimension");
  return {events.data(), events.data() + events.size()};
}

}  // namespace voroproof::python
