// The parts of the module.
#pragma once

#include <pybind11/pybind11.h>

namespace voroproof::python {

void bind_errors(pybind11::module_& module);
void bind_scene(pybind11::module_& module);
void bind_history(pybind11::module_& module);
void bind_billiard(pybind11::module_& module);
void bind_certify(pybind11::module_& module);
void bind_diagram(pybind11::module_& module);
void bind_movie(pybind11::module_& module);
void bind_queries(pybind11::module_& module);
void bind_plan(pybind11::module_& module);

}  // namespace voroproof::python
