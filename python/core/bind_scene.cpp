#include <pybind11/stl.h>

#include "python/core/bind.h"
#include "python/core/made_text.h"
#include "python/core/number_caster.h"
#include "voroproof/generators.h"
#include "voroproof/scene.h"

namespace py = pybind11;
using namespace py::literals;

namespace voroproof::python {
namespace {

using Radii = ReferenceOptions::Radii;
using Pattern = GridOptions::Motion;

template <class Value>
Value named(const char* what, const std::string& name,
            std::initializer_list<std::pair<const char*, Value>> values) {
  std::string all;
  for (const auto& [word, value] : values) {
    if (name == word) return value;
    all += std::string(all.empty() ? "" : ", ") + word;
  }
  throw std::invalid_argument(std::string(what) + ": none of " + all);
}

void bind_generators(py::module_& module) {
  module.def(
      "reference_scene",
      [](int n, std::uint64_t seed, const std::string& radii, double rmin, double rmax,
         double density, double speed, double restitution, double horizon) {
        return reference_scene(
            {n, seed,
             named<Radii>(
                 "radii", radii,
                 {{"uniform", Radii::uniform}, {"log", Radii::log}, {"equal", Radii::equal}}),
             rmin, rmax, density, speed, restitution, horizon});
      },
      "n"_a, "seed"_a, "radii"_a, "rmin"_a, "rmax"_a, "density"_a, "speed"_a, "restitution"_a,
      "horizon"_a);
  module.def(
      "grid_scene",
      [](int n, std::uint64_t seed, const std::string& motion, double spacing, double radius,
         double speed, double horizon) {
        return grid_scene({n, seed,
                           named<Pattern>("motion", motion,
                                          {{"rest", Pattern::rest},
                                           {"common", Pattern::common},
                                           {"random", Pattern::random},
                                           {"shear", Pattern::shear}}),
                           spacing, radius, speed, horizon});
      },
      "n"_a, "seed"_a, "motion"_a, "spacing"_a, "radius"_a, "speed"_a, "horizon"_a);
  module.def(
      "swarm_scene",
      [](int n, std::uint64_t seed, double spacing, double radius, double horizon) {
        return swarm_scene({n, seed, spacing, radius, horizon});
      },
      "n"_a, "seed"_a, "spacing"_a, "radius"_a, "horizon"_a);
}

using Source = std::optional<std::pair<std::string, std::string>>;

// The scene of a text that was made of values in memory: errors name no line, and without a source
// its identity is that of the file that would be written.
Scene made_scene(const std::string& text, const Source& source) {
  Scene scene = without_lines([&] { return parse_scene(text); });
  scene.source.reset();
  if (source) scene.source = {source->first, source->second};
  return scene;
}

Source source_of(const Scene& scene) {
  if (!scene.source) return std::nullopt;
  return std::pair(scene.source->file_sha256, scene.source->values_sha256);
}

}  // namespace

void bind_scene(py::module_& module) {
  py::class_<Scene>(module, "Scene")
      .def_property_readonly("container",
                             [](const Scene& s) {
                               return std::tuple(s.container_x, s.container_y, s.container_radius);
                             })
      .def_readonly("restitution", &Scene::restitution)
      .def_readonly("container_restitution", &Scene::container_restitution)
      .def_property_readonly(
          "container_law",
          [](const Scene& s) { return s.law == ContainerLaw::whole ? "whole" : "normal"; })
      .def_readonly("horizon", &Scene::horizon)
      .def_readonly("name", &Scene::name)
      .def_readonly("comment", &Scene::comment)
      .def("disks",
           [](const Scene& s) {
             py::list all;
             for (const Disk& d : s.disks) {
               all.append(py::make_tuple(d.x, d.y, d.radius, d.vx, d.vy, d.mass));
             }
             return all;
           })
      .def("maneuvers",
           [](const Scene& s) {
             py::list all;
             for (const Maneuver& m : s.maneuvers) {
               all.append(py::make_tuple(m.t, m.disk, m.vx, m.vy));
             }
             return all;
           })
      .def("radii",
           [](const Scene& s) {
             std::vector<double> radii;
             for (const Disk& d : s.disks) radii.push_back(d.radius.nearest());
             return radii;
           })
      .def("source", &source_of)
      .def("size", [](const Scene& s) { return s.disks.size(); })
      .def("text", [](const Scene& s) { return scene_text(s); })
      .def("sha256", [](const Scene& s) { return scene_sha256(s); })
      .def("write", [](const Scene& s, const std::string& path) { write_scene(path, s); });
  module.def("read_scene", &read_scene);
  module.def("parse_scene", [](const std::string& text) { return parse_scene(text); });
  module.def("make_scene", &made_scene, "text"_a, "source"_a);
  bind_generators(module);
}

}  // namespace voroproof::python
