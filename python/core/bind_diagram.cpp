#include <pybind11/stl.h>

#include "python/core/arrays.h"
#include "python/core/attention.h"
#include "python/core/bind.h"
#include "python/core/events.h"
#include "python/core/frame.h"
#include "python/core/number_caster.h"
#include "voroproof/diagram.h"
#include "voroproof/static_diagram.h"

namespace py = pybind11;
using namespace py::literals;

namespace voroproof::python {
namespace {

template <class Items, class Field>
py::array_t<double> vectors(const Items& items, Field field) {
  std::vector<Vector> all;
  for (const auto& item : items) all.push_back(item.*field);
  return array_of(all);
}

template <class Items, class Field>
py::array_t<double> numbers(const Items& items, Field field) {
  std::vector<double> all;
  for (const auto& item : items) all.push_back(item.*field);
  return py::array_t<double>(static_cast<py::ssize_t>(all.size()), all.data());
}

py::array_t<std::int32_t> vertex_names(const std::vector<Vertex>& vertices) {
  py::array_t<std::int32_t> out({static_cast<py::ssize_t>(vertices.size()), py::ssize_t{3}});
  auto to = out.mutable_unchecked<2>();
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    for (const int side : {0, 1, 2}) to(k, side) = vertices[k].generators[side];
  }
  return out;
}

py::list list_of(const std::vector<std::vector<Vector>>& lines) {
  py::list all;
  for (const auto& line : lines) all.append(array_of(line));
  return all;
}

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

StaticDiagram static_diagram(const Numbers& centers, const Numbers& radii, const Frame& frame) {
  const auto at = centers.unchecked<2>();
  const auto radius = radii.unchecked<1>();
  std::vector<Circle> disks;
  disks.reserve(radius.shape(0));
  for (py::ssize_t k = 0; k < radius.shape(0); ++k) {
    disks.push_back({{at(k, 0), at(k, 1)}, radius(k)});
  }
  return Attention::without_lock([&] {
    if (const auto walls = walls_of(frame)) {
      return StaticDiagram::between_walls(std::move(disks), *walls);
    }
    return StaticDiagram(std::move(disks), circle_of(frame));
  });
}

using Corners = std::optional<std::array<double, 4>>;

Box box_of(const StaticDiagram& diagram, const Corners& corners) {
  if (!corners) return diagram.box();
  const auto& [x0, y0, x1, y1] = *corners;
  return {{x0, y0}, {x1, y1}};
}

// Start, control, end, weight, error: shape (k, 8).
py::array_t<double> array_of_arcs(const std::vector<Arc>& arcs) {
  py::array_t<double> out({static_cast<py::ssize_t>(arcs.size()), py::ssize_t{8}});
  auto to = out.mutable_unchecked<2>();
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const auto& [start, control, end, weight, error] = arcs[k];
    int column = 0;
    for (const Vector& v : {start, control, end}) {
      for (const double x : v) to(k, column++) = x;
    }
    to(k, column++) = weight;
    to(k, column) = error;
  }
  return out;
}

// Shape (n, 7).
py::array_t<double> array_of_measures(const std::vector<Measure>& measures) {
  py::array_t<double> out({static_cast<py::ssize_t>(measures.size()), py::ssize_t{7}});
  auto to = out.mutable_unchecked<2>();
  for (std::size_t k = 0; k < measures.size(); ++k) {
    const Measure& m = measures[k];
    int column = 0;
    for (const double x : {m.area, m.perimeter, m.centroid[0], m.centroid[1], m.area_error,
                           m.perimeter_error, m.centroid_error}) {
      to(k, column++) = x;
    }
  }
  return out;
}

// Shapes (n,): generators and distances.
py::tuple nearest(const StaticDiagram& diagram, const Numbers& points) {
  const auto at = points.unchecked<2>();
  std::vector<Vector> places;
  places.reserve(at.shape(0));
  for (py::ssize_t k = 0; k < at.shape(0); ++k) places.push_back({at(k, 0), at(k, 1)});
  const std::vector<Nearest> all = Attention::without_lock([&] { return diagram.nearest(places); });
  py::array_t<int> generators(at.shape(0));
  auto to = generators.mutable_unchecked<1>();
  for (py::ssize_t k = 0; k < at.shape(0); ++k) to(k) = all[k].generator;
  return py::make_tuple(generators, numbers(all, &Nearest::distance));
}

// Centre, radius, generators.
py::tuple empty_circle(const EmptyCircle& circle) {
  return py::make_tuple(py::make_tuple(circle.center[0], circle.center[1]), circle.radius,
                        py::tuple(py::cast(circle.generators)));
}

void bind_static_diagram(py::module_& module) {
  py::class_<StaticDiagram>(module, "StaticDiagram")
      .def(py::init(&static_diagram), "centers"_a, "radii"_a, "frame"_a)
      .def("hosts",
           [](const StaticDiagram& d) {
             return py::array_t<int>(static_cast<py::ssize_t>(d.hosts().size()), d.hosts().data());
           })
      .def("edges", [](const StaticDiagram& d) { return array_of(d.edges()); })
      .def("vertices", [](const StaticDiagram& d) { return vertex_names(d.vertices()); })
      .def("vertex_positions",
           [](const StaticDiagram& d) { return vectors(d.vertices(), &Vertex::center); })
      .def("vertex_radii",
           [](const StaticDiagram& d) { return numbers(d.vertices(), &Vertex::radius); })
      .def("box",
           [](const StaticDiagram& d) {
             const Box b = d.box();
             return std::tuple(b.low[0], b.low[1], b.high[0], b.high[1]);
           })
      .def(
          "cells",
          [](const StaticDiagram& d, const Corners& box, std::optional<double> tolerance) {
            const Box cut = box_of(d, box);
            py::list all;
            for (const auto& cell : d.cells(cut, tolerance.value_or(d.tolerance(cut)))) {
              all.append(list_of(cell));
            }
            return all;
          },
          "box"_a, "tolerance"_a)
      .def(
          "arcs",
          [](const StaticDiagram& d, const Corners& box) {
            py::list all;
            for (const auto& edge : Attention::without_lock([&] { return d.arcs(box_of(d, box)); }))
              all.append(array_of_arcs(edge));
            return all;
          },
          "box"_a)
      .def(
          "measures",
          [](const StaticDiagram& d, const Corners& box) {
            return array_of_measures(
                Attention::without_lock([&] { return d.measures(box_of(d, box)); }));
          },
          "box"_a)
      .def("nearest", &nearest, "points"_a)
      .def(
          "largest_empty_circle",
          [](const StaticDiagram& d, const Corners& box) -> py::object {
            const auto circle =
                Attention::without_lock([&] { return d.largest_empty_circle(box_of(d, box)); });
            return circle ? py::object(empty_circle(*circle)) : py::none();
          },
          "box"_a)
      .def(
          "voids",
          [](const StaticDiagram& d, double probe, const Corners& box) {
            py::list all;
            for (const EmptyCircle& circle :
                 Attention::without_lock([&] { return d.voids(box_of(d, box), probe); })) {
              all.append(empty_circle(circle));
            }
            return all;
          },
          "probe"_a, "box"_a)
      .def(
          "geojson",
          [](const StaticDiagram& d, const Corners& box, std::optional<double> tolerance,
             const std::vector<StaticDiagram::Column>& columns) {
            const Box cut = box_of(d, box);
            return d.geojson(cut, tolerance.value_or(d.tolerance(cut)), columns);
          },
          "box"_a, "tolerance"_a, "columns"_a);
}

}  // namespace

void bind_diagram(py::module_& module) {
  py::class_<Diagram>(module, "Diagram")
      .def_readonly("t", &Diagram::t)
      .def_readonly("scene_sha256", &Diagram::scene_sha256)
      .def_property_readonly("container",
                             [](const Diagram& d) {
                               return std::tuple(d.container_center[0], d.container_center[1],
                                                 d.container_radius);
                             })
      .def("positions", [](const Diagram& d) { return vectors(d.disks, &PlacedDisk::center); })
      .def("velocities", [](const Diagram& d) { return vectors(d.disks, &PlacedDisk::velocity); })
      .def("radii", [](const Diagram& d) { return numbers(d.disks, &PlacedDisk::radius); })
      .def("vertices", [](const Diagram& d) { return vertex_names(d.vertices); })
      .def("vertex_positions",
           [](const Diagram& d) { return vectors(d.vertices, &Vertex::center); })
      .def("vertex_radii", [](const Diagram& d) { return numbers(d.vertices, &Vertex::radius); })
      .def("edges", [](const Diagram& d) { return array_of(d.edges); })
      .def("neighbours", [](const Diagram& d, int g) { return neighbours(d, g); })
      .def("edge_polylines",
           [](const Diagram& d, double tolerance) { return list_of(edge_polylines(d, tolerance)); })
      .def("cell_polygons",
           [](const Diagram& d, double tolerance) { return list_of(cell_polygons(d, tolerance)); })
      .def("write", [](const Diagram& d, const std::string& path) { write_diagram(path, d); });
  bind_static_diagram(module);
  module.def("read_diagram", &read_diagram);
  module.def(
      "diagram_of_scene",
      [](const Scene& scene, const Number& t, int max_bits) {
        return Attention::without_lock([&] { return diagram_at(scene, t, max_bits); });
      },
      "scene"_a, "t"_a, "max_bits"_a);
  module.def(
      "diagram_of_history",
      [](const Scene& scene, const EventTable& history, const Number& t, bool checked) {
        return Attention::without_lock(
            [&] { return diagram_at(scene, history.history(), t, 32768, checked); });
      },
      "scene"_a, "history"_a, "t"_a, "checked"_a);
}

}  // namespace voroproof::python
