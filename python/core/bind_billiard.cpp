#include <pybind11/stl.h>

#include "python/core/arrays.h"
#include "python/core/attention.h"
#include "python/core/bind.h"
#include "python/core/made_text.h"
#include "python/core/number_caster.h"
#include "voroproof/billiard.h"

namespace py = pybind11;
using namespace py::literals;

namespace voroproof::python {
namespace {

BilliardHistory simulated(const Billiard& billiard, py::object progress, int threads, int max_bits,
                          std::uint64_t max_events) {
  Attention attention(std::move(progress));
  const SimulateOptions options = simulate_options(threads, max_bits, max_events, attention);
  BilliardHistory history = attention.spend([&] { return simulate(billiard, options); });
  attention.report(history.ending.t, history.events.size());
  return history;
}

BilliardHistory made(const Billiard& billiard, const Number& horizon, const std::string& producer,
                     const py::array_t<BilliardEvent, py::array::c_style>& events,
                     const Ending& ending) {
  BilliardHistory history;
  history.scene_sha256 = billiard.sha256();
  history.dimension = billiard.dimension();
  history.horizon = horizon;
  history.producer = producer;
  history.events = rows_in(events);
  history.ending = ending;
  return history;
}

void bind_billiard_history(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(BilliardEvent, t, kind, ids, image, velocity, center);
  module.attr("billiard_event_dtype") = py::dtype::of<BilliardEvent>();
  py::class_<BilliardHistory>(module, "BilliardHistory")
      .def(py::init(&made), "billiard"_a, "horizon"_a, "producer"_a, "rows"_a, "ending"_a)
      .def_property_readonly("rows",
                             [](const py::object& self) {
                               return rows_of(self.cast<const BilliardHistory&>().events, self);
                             })
      .def_readonly("horizon", &BilliardHistory::horizon)
      .def_readonly("producer", &BilliardHistory::producer)
      .def_readonly("rounded", &BilliardHistory::rounded)
      .def_readonly("ending", &BilliardHistory::ending)
      .def("write", [](const BilliardHistory& h, const std::string& path) {
        Attention::without_lock([&] {
          write_history(path, h);
          return 0;
        });
      });
}

}  // namespace

void bind_billiard(py::module_& module) {
  py::class_<Billiard>(module, "Billiard")
      .def("text", &Billiard::text)
      .def("sha256", &Billiard::sha256)
      .def_property_readonly("dimension", &Billiard::dimension)
      .def_property_readonly("horizon", &Billiard::horizon)
      .def("size", &Billiard::size)
      .def("write", [](const Billiard& b, const std::string& path) { write_billiard(path, b); });
  module.def("read_billiard", &read_billiard);
  module.def("parse_billiard", [](const std::string& text) { return Billiard(text); });
  module.def("make_billiard",
             [](const std::string& text) { return without_lines([&] { return Billiard(text); }); });
  bind_billiard_history(module);
  module.def("read_billiard_history", [](const std::string& path, const Billiard& billiard) {
    return Attention::without_lock([&] { return read_history(path, billiard); });
  });
  module.def("simulate", &simulated, "billiard"_a, "progress"_a, "threads"_a, "max_bits"_a,
             "max_events"_a);
}

}  // namespace voroproof::python
