#include <pybind11/stl.h>

#include "python/core/attention.h"
#include "python/core/bind.h"
#include "python/core/events.h"
#include "voroproof/movie.h"

namespace py = pybind11;
using namespace py::literals;

namespace voroproof::python {

void bind_movie(py::module_& module) {
  module.def(
      "movie_page",
      [](const Scene& scene, const EventTable& history, const std::optional<std::string>& report,
         std::optional<int> follow) {
        return Attention::without_lock([&] {
          Report told;
          if (report) told.json = *report;
          return movie_page(scene, history.history(), {follow, report ? &told : nullptr});
        });
      },
      "scene"_a, "history"_a, "report"_a, "follow"_a);
}

}  // namespace voroproof::python
