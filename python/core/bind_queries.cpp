#include <pybind11/stl.h>

#include "python/core/arrays.h"
#include "python/core/attention.h"
#include "python/core/bind.h"
#include "python/core/events.h"
#include "python/core/number_caster.h"
#include "voroproof/free_space.h"
#include "voroproof/queries.h"
#include "voroproof/recorded_motion.h"

namespace py = pybind11;
using namespace py::literals;

namespace voroproof::python {
namespace {

py::tuple tuple_of(const Enclosure& e) { return py::make_tuple(e.lower, e.upper); }

py::object tuple_of(const std::optional<LeastGap>& g) {
  if (!g) return py::none();
  return py::make_tuple(g->i, g->j, g->t, tuple_of(g->gap), g->contact);
}

py::tuple tuple_of(const ClosestPairs& c) { return py::make_tuple(c.pairs, tuple_of(c.gap)); }

py::tuple tuple_of(const std::vector<int>& ids) { return py::cast(ids).cast<py::tuple>(); }

py::object tuple_of(const std::optional<ClearancePlace>& place) {
  if (!place) return py::none();
  static constexpr const char* kinds[] = {"vertex", "gate", "far"};
  return py::make_tuple(kinds[static_cast<int>(place->kind)], tuple_of(place->generators));
}

py::tuple tuple_of(const Tunnel& t) {
  return py::make_tuple(py::make_tuple(t.edge.l, t.edge.r, t.edge.s, t.edge.e), tuple_of(t.closes),
                        tuple_of(std::optional(t.at)));
}

py::tuple tuple_of(const VanishingVoid& v) {
  return py::make_tuple(tuple_of(v.vanishes), tuple_of(v.at));
}

py::tuple tuple_of(const Opening& o) { return py::make_tuple(tuple_of(o.from), tuple_of(o.to)); }

py::object tuple_of(const std::optional<OffsetPoint>& p) {
  if (!p) return py::none();
  return py::make_tuple(p->i, p->j, p->side, tuple_of(p->x), tuple_of(p->y));
}

py::tuple tuple_of(const OffsetArc& arc) {
  return py::make_tuple(arc.generator, tuple_of(arc.from), tuple_of(arc.to));
}

py::tuple tuple_of(const VoidLife& v) {
  return py::make_tuple(tuple_of(v.from), tuple_of(v.to), v.before, v.after, tuple_of(v.at));
}

py::tuple tuple_of(const Void& v);

template <class Items>
py::list list_of(const Items& items) {
  py::list all;
  for (const auto& item : items) all.append(tuple_of(item));
  return all;
}

py::tuple tuple_of(const Void& v) {
  py::list vertices;
  for (const auto& ids : v.vertices) vertices.append(py::make_tuple(ids[0], ids[1], ids[2]));
  return py::make_tuple(vertices, list_of(v.tunnels), tuple_of(v.widest.vanishes),
                        tuple_of(v.widest.at));
}

std::vector<Number> exact_times(const py::iterable& times) {
  std::vector<Number> all;
  for (const py::handle t : times) all.push_back(number_of(t));
  return all;
}

// An array of shape (times, disks, 2).
py::array_t<double> sample(const RecordedMotion& motion, const py::iterable& times) {
  const std::vector<Number> all = exact_times(times);
  const auto places = Attention::without_lock([&] {
    std::vector<std::vector<Vector>> out;
    out.reserve(all.size());
    for (const Number& t : all) out.push_back(motion.positions(t));
    return out;
  });
  const std::size_t disks = places.empty() ? motion.positions(0).size() : places.front().size();
  py::array_t<double> out({places.size(), disks, std::size_t{2}});
  auto to = out.mutable_unchecked<3>();
  for (std::size_t k = 0; k < places.size(); ++k) {
    for (std::size_t g = 0; g < disks; ++g) {
      for (const int axis : {0, 1}) to(k, g, axis) = places[k][g][axis];
    }
  }
  return out;
}

py::array_t<double> gaps(const RecordedMotion& motion, int i, int j, const py::iterable& times) {
  const std::vector<Number> all = exact_times(times);
  const auto values = Attention::without_lock([&] {
    std::vector<double> out;
    out.reserve(all.size());
    for (const Number& t : all) out.push_back(motion.gap(i, j, t));
    return out;
  });
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

void bind_motion(py::module_& module) {
  py::class_<RecordedMotion>(module, "RecordedMotion")
      .def(py::init([](const Scene& scene, const EventTable& history) {
        return Attention::without_lock(
            [&] { return std::make_unique<RecordedMotion>(scene, history.history()); });
      }))
      .def("positions",
           [](const RecordedMotion& m, const Number& t) { return array_of(m.positions(t)); })
      .def("velocities",
           [](const RecordedMotion& m, const Number& t) { return array_of(m.velocities(t)); })
      .def("sample", &sample)
      .def("gap", &RecordedMotion::gap)
      .def("gaps", &gaps)
      .def("neighbours",
           [](RecordedMotion& m, int disk, const Number& from, const Number& to) {
             py::list all;
             for (const Neighbourhood& n : m.neighbours(disk, from, to)) {
               all.append(py::make_tuple(n.generator, n.from, n.to));
             }
             return all;
           })
      .def("least_gap",
           [](RecordedMotion& m, int i, int j, const Number& from, const Number& to) {
             return tuple_of(std::optional(m.least_gap(i, j, from, to)));
           })
      .def("least_gap_of_all", [](RecordedMotion& m, const Number& from,
                                  const Number& to) { return tuple_of(m.least_gap(from, to)); })
      .def("tunnel_openings",
           [](RecordedMotion& m, int i, int j, const Number& probe, const Number& from,
              const Number& to) {
             return list_of(
                 Attention::without_lock([&] { return m.tunnel_openings(i, j, probe, from, to); }));
           })
      .def("void_openings",
           [](RecordedMotion& m, const std::array<int, 3>& vertex, const Number& probe,
              const Number& from, const Number& to) {
             return list_of(
                 Attention::without_lock([&] { return m.void_openings(vertex, probe, from, to); }));
           })
      .def("void_lives",
           [](RecordedMotion& m, const Number& probe, const Number& from, const Number& to) {
             return list_of(Attention::without_lock([&] { return m.void_lives(probe, from, to); }));
           });
}

}  // namespace

void bind_queries(py::module_& module) {
  bind_motion(module);
  py::class_<Instant>(module, "Instant")
      .def(py::init([](const Scene& scene, const Number& t, int max_bits) {
        return Attention::without_lock(
            [&] { return std::make_unique<Instant>(scene, t, max_bits); });
      }))
      .def("nearest",
           [](Instant& instant, const Number& x, const Number& y, std::size_t count) {
             py::list all;
             for (const NearDisk& n : instant.nearest(x, y, count)) {
               all.append(py::make_tuple(n.disk, tuple_of(n.distance), n.tied));
             }
             return all;
           })
      .def("neighbours",
           [](Instant& instant, int disk) {
             py::list all;
             for (const Neighbour& n : instant.neighbours(disk)) {
               all.append(py::make_tuple(n.generator, n.edges, tuple_of(n.gap)));
             }
             return all;
           })
      .def("closest_generators", [](Instant& i) { return tuple_of(i.closest_generators()); })
      .def("closest_disks", [](Instant& i) { return tuple_of(i.closest_disks()); })
      .def("offset",
           [](Instant& i, const Number& probe) {
             return list_of(Attention::without_lock([&] { return i.offset(probe); }));
           })
      .def("voids",
           [](Instant& i, const Number& probe) {
             return list_of(Attention::without_lock([&] { return i.voids(probe); }));
           })
      .def("critical", [](Instant& i) {
        const CriticalRadii radii = Attention::without_lock([&] { return i.critical(); });
        return py::make_tuple(list_of(radii.tunnels), list_of(radii.voids));
      });
}

}  // namespace voroproof::python
