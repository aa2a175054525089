// voroproof._core: the library as Python sees it, without comfort. The package around it
// (python/voroproof/) is what users see.
#include "python/core/bind.h"
#include "voroproof/version.h"

PYBIND11_MODULE(_core, module) {
  using namespace voroproof::python;
  module.attr("version") = voroproof::version();
  bind_errors(module);
  bind_scene(module);
  bind_history(module);
  bind_billiard(module);
  bind_certify(module);
  bind_diagram(module);
  bind_movie(module);
  bind_queries(module);
  bind_plan(module);
}
