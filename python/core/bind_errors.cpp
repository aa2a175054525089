// The errors of the library as those of voroproof.errors.
#include "python/core/bind.h"
#include "voroproof/error.h"

namespace py = pybind11;

namespace voroproof::python {
namespace {

template <class... Arguments>
void raise(const char* name, const Arguments&... arguments) {
  const py::object type = py::module_::import("voroproof.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& e) {
    raise("InputError", e.what(), e.file(), e.line(), e.field(), e.reason());
  } catch (const OutputError& e) {
    raise("OutputError", e.what());
  } catch (const Undecided& e) {
    raise("Undecided", e.what());
  } catch (const Interrupted& e) {
    raise("Interrupted", e.what());
  } catch (const Error& e) {
    raise("Error", e.what());
  }
}

}  // namespace

void bind_errors(py::module_&) { py::register_exception_translator(translate); }

}  // namespace voroproof::python
