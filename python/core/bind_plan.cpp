#include <pybind11/stl.h>

#include "python/core/attention.h"
#include "python/core/bind.h"
#include "python/core/number_caster.h"
#include "voroproof/plan.h"

namespace py = pybind11;
using namespace py::literals;

namespace voroproof::python {
namespace {

using Three = std::array<Number, 3>;
using Five = std::array<Number, 5>;

py::object tuple_of(const std::optional<Approach>& a) {
  if (!a) return py::none();
  return py::make_tuple(a->i, a->j, a->t, py::make_tuple(a->gap.lower, a->gap.upper));
}

// Vehicles are radius, start, goal.
py::dict planned(const std::vector<Five>& vehicles, const Three& container, const Number& arrive,
                 const Number& clearance, const std::string& name, py::object progress) {
  PlanTask task;
  task.container_x = container[0];
  task.container_y = container[1];
  task.container_radius = container[2];
  task.arrive = arrive;
  task.clearance = clearance;
  task.name = name;
  for (const Five& v : vehicles) task.vehicles.push_back({v[0], v[1], v[2], v[3], v[4]});
  Attention attention(std::move(progress));
  Plan plan = attention.spend([&] {
    return make_plan(task, [&](std::size_t conjunctions) { return attention(conjunctions); });
  });
  return py::dict("found"_a = plan.found, "scene"_a = std::move(plan.scene),
                  "nearest"_a = tuple_of(plan.nearest), "conflict"_a = tuple_of(plan.conflict),
                  "avoided"_a = plan.avoided);
}

}  // namespace

void bind_plan(py::module_& module) {
  module.def("plan", &planned, "vehicles"_a, "container"_a, "arrive"_a, "clearance"_a, "name"_a,
             "progress"_a);
}

}  // namespace voroproof::python
