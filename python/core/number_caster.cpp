#include "python/core/number_caster.h"

namespace py = pybind11;

namespace voroproof::python {

Number number_of(py::handle object) {
  PyObject* const p = object.ptr();
  if (PyFloat_Check(p)) return Number(PyFloat_AS_DOUBLE(p));
  if (PyUnicode_Check(p)) return Number(py::cast<std::string>(object));
  if (PyBool_Check(p)) throw py::cast_error("a truth value is no number");
  if (PyIndex_Check(p)) {
    return Number(
        py::cast<std::string>(py::str(py::module_::import("operator").attr("index")(object))));
  }
  if (py::hasattr(object, "as_integer_ratio")) {
    const py::tuple ratio = object.attr("as_integer_ratio")();
    return Number(py::cast<std::string>(py::str(ratio[0])) + "/" +
                  py::cast<std::string>(py::str(ratio[1])));
  }
  throw py::cast_error("not a number");
}

py::object fraction(const Number& number) {
  const py::object type = py::module_::import("fractions").attr("Fraction");
  return number.is_double() ? type(number.nearest()) : type(number.text());
}

}  // namespace voroproof::python
