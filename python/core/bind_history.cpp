#include <pybind11/stl.h>

#include "python/core/arrays.h"
#include "python/core/attention.h"
#include "python/core/bind.h"
#include "python/core/events.h"
#include "python/core/number_caster.h"
#include "voroproof/simulate.h"
#include "voroproof/version.h"

namespace py = pybind11;
using namespace py::literals;

namespace voroproof::python {
namespace {

EventTable simulated(const Scene& scene, py::object progress, int threads, int max_bits,
                     std::uint64_t max_events) {
  Attention attention(std::move(progress));
  const SimulateOptions options = simulate_options(threads, max_bits, max_events, attention);
  EventTable table = attention.spend([&] {
    EventTable made;
    made.head.scene_sha256 = scene_sha256(scene);
    made.head.horizon = scene.horizon;
    made.head.producer = std::string("voroproof ") + version();
    RowSink sink(made);
    made.head.ending = simulate(scene, sink, options);
    return made;
  });
  attention.report(table.head.ending.t, table.rows.size());
  return table;
}

EventTable made(const std::string& scene_sha256, const Number& horizon, const std::string& producer,
                const std::optional<std::vector<std::array<int, 4>>>& initial,
                const py::array_t<EventRow, py::array::c_style>& rows, const Ending& ending) {
  EventTable table;
  table.head.scene_sha256 = scene_sha256;
  table.head.horizon = horizon;
  table.head.producer = producer;
  table.head.ending = ending;
  if (initial) {
    table.head.initial.emplace();
    for (const auto& q : *initial) table.head.initial->push_back({q[0], q[1], q[2], q[3]});
  }
  table.rows = rows_in(rows);
  for (const EventRow& row : table.rows) event_of(row);
  return table;
}

}  // namespace

void bind_history(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(EventRow, t, kind, ids, velocity, center);
  module.attr("event_dtype") = py::dtype::of<EventRow>();
  py::class_<Ending>(module, "Ending")
      .def(py::init([](bool complete, double t, const std::string& reason) {
             return Ending{complete, t, reason};
           }),
           "complete"_a, "t"_a, "reason"_a)
      .def_readonly("complete", &Ending::complete)
      .def_readonly("t", &Ending::t)
      .def_readonly("reason", &Ending::reason);
  py::class_<EventTable>(module, "EventTable")
      .def(py::init(&made), "scene_sha256"_a, "horizon"_a, "producer"_a, "initial"_a, "rows"_a,
           "ending"_a)
      .def_property_readonly(
          "rows",
          [](const py::object& self) { return rows_of(self.cast<const EventTable&>().rows, self); })
      .def_property_readonly("scene_sha256",
                             [](const EventTable& h) { return h.head.scene_sha256; })
      .def_property_readonly("horizon", [](const EventTable& h) { return h.head.horizon; })
      .def_property_readonly("producer", [](const EventTable& h) { return h.head.producer; })
      .def_property_readonly("rounded", [](const EventTable& h) { return h.head.rounded; })
      .def_property_readonly("ending", [](const EventTable& h) { return h.head.ending; })
      .def_property_readonly("initial",
                             [](const EventTable& h) -> py::object {
                               if (!h.head.initial) return py::none();
                               return array_of(*h.head.initial);
                             })
      .def("write", [](const EventTable& h, const std::string& path) {
        Attention::without_lock([&] {
          write_history(path, h.history());
          return 0;
        });
      });
  module.def("read_history", [](const std::string& path) {
    return Attention::without_lock([&] { return read_table(path); });
  });
  module.def("simulate", &simulated, "scene"_a, "progress"_a, "threads"_a, "max_bits"_a,
             "max_events"_a);
}

}  // namespace voroproof::python
