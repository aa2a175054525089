#include <pybind11/stl.h>

#include "python/core/attention.h"
#include "python/core/bind.h"
#include "python/core/events.h"
#include "python/core/frame.h"
#include "python/core/number_caster.h"
#include "voroproof/billiard.h"
#include "voroproof/certify.h"
#include "voroproof/certify_diagram.h"

namespace py = pybind11;
using namespace py::literals;

namespace voroproof::python {
namespace {

py::tuple pair_of(const Bounds& b) { return py::make_tuple(b.lower, b.upper); }

py::dict dict_of(const Witness& w) {
  py::list generators, polynomial;
  for (const WitnessMotion& m : w.generators) {
    generators.append(py::make_tuple(m.generator, m.t0, pair_of(m.x), pair_of(m.y), pair_of(m.vx),
                                     pair_of(m.vy), pair_of(m.signed_radius)));
  }
  for (const Bounds& c : w.polynomial) polynomial.append(pair_of(c));
  py::object root = py::none();
  if (w.root) root = py::make_tuple((*w.root)[0], (*w.root)[1]);
  return py::dict("generators"_a = generators, "polynomial_is"_a = w.polynomial_is,
                  "polynomial"_a = polynomial, "root"_a = root, "t"_a = w.t, "vertex"_a = w.vertex,
                  "contains"_a = w.contains);
}

py::dict dict_of(const Divergence& d) {
  py::object edge = py::none();
  if (d.edge) edge = py::make_tuple(d.edge->l, d.edge->r, d.edge->s, d.edge->e);
  py::object pair = py::none();
  if (d.pair) pair = py::make_tuple((*d.pair)[0], (*d.pair)[1]);
  return py::dict("fault"_a = d.fault, "line"_a = d.line, "t"_a = d.t, "truth"_a = d.truth,
                  "edge"_a = edge, "pair"_a = pair, "witness"_a = dict_of(d.witness));
}

py::dict dict_of(const Report& r) {
  py::object divergence = py::none();
  if (r.divergence) divergence = dict_of(*r.divergence);
  py::list leniency;
  for (const Leniency& l : r.leniency) leniency.append(py::make_tuple(l.name, l.words, l.count));
  return py::dict("verdict"_a = name(r.verdict), "words"_a = r.words, "about"_a = r.about,
                  "reservations"_a = r.reservations, "reason"_a = r.reason,
                  "divergence"_a = divergence, "evidence"_a = r.evidence,
                  "prefix_events"_a = r.prefix_events, "prefix_t"_a = r.prefix_t,
                  "flips"_a = r.flips, "collisions"_a = r.collisions, "maneuvers"_a = r.maneuvers,
                  "leniency"_a = leniency, "remarks"_a = r.remarks, "json"_a = r.json);
}

CertifyOptions options_of(const std::string& truth, const std::string& events,
                          const Number& tolerance, const Number& law_tolerance,
                          const std::string& order, bool strict, int threads, int max_bits,
                          Attention& attention) {
  CertifyOptions options;
  if (truth != "exact" && truth != "recorded") {
    throw std::invalid_argument("truth: neither \"exact\" nor \"recorded\"");
  }
  options.truth = truth == "exact" ? Truth::exact : Truth::recorded;
  if (events != "all" && events != "collisions") {
    throw std::invalid_argument("events: neither \"all\" nor \"collisions\"");
  }
  options.events = events == "all" ? EventKinds::all : EventKinds::collisions;
  if (order != "format" && order != "any") {
    throw std::invalid_argument("order: neither \"format\" nor \"any\"");
  }
  options.any_order = order == "any";
  options.tolerance = tolerance;
  options.law_tolerance = law_tolerance;
  options.strict = strict;
  options.threads = threads;
  options.max_bits = max_bits;
  options.monitor = [&](double t, std::int64_t events) { return attention(t, events); };
  return options;
}

// Adds a function that certifies: judge(scene, history, options).
template <class Subject, class Claims, class Judge>
void bind_judge(py::module_& module, const char* name, Judge judge) {
  module.def(
      name,
      [judge](const Subject& scene, const Claims& history, py::object progress,
              const std::string& truth, const std::string& events, const Number& tolerance,
              const Number& law_tolerance, const std::string& order, bool strict, int threads,
              int max_bits) {
        Attention attention(std::move(progress));
        const CertifyOptions options = options_of(truth, events, tolerance, law_tolerance, order,
                                                  strict, threads, max_bits, attention);
        const Report report = attention.spend([&] { return judge(scene, history, options); });
        attention.report(report.prefix_t, report.prefix_events);
        return dict_of(report);
      },
      "scene"_a, "history"_a, "progress"_a, "truth"_a, "events"_a, "tolerance"_a, "law_tolerance"_a,
      "order"_a, "strict"_a, "threads"_a, "max_bits"_a);
}

using Vertices = std::tuple<std::vector<std::array<int, 3>>, std::vector<Vector>,
                            std::vector<double>>;  // generators, centres, radii

py::dict judged_diagram(const std::vector<Vector>& centers, const std::vector<double>& radii,
                        const Frame& frame, const std::optional<std::vector<int>>& hosts,
                        const std::optional<std::vector<std::array<int, 4>>>& edges,
                        const std::optional<std::vector<std::array<int, 2>>>& neighbours,
                        const std::optional<Vertices>& vertices, double tolerance, int threads) {
  DiagramClaim claim;
  for (std::size_t k = 0; k < radii.size(); ++k) claim.disks.push_back({centers[k], radii[k]});
  claim.frame = circle_of(frame);
  claim.walls = walls_of(frame);
  claim.hosts = hosts;
  if (edges) {
    claim.edges.emplace();
    for (const auto& [l, r, s, e] : *edges) claim.edges->push_back({l, r, s, e});
  }
  claim.neighbours = neighbours;
  if (vertices) {
    claim.vertices.emplace();
    const auto& [names, places, sizes] = *vertices;
    if (names.size() != places.size() || names.size() != sizes.size()) {
      throw std::invalid_argument("vertices: arrays of several lengths");
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      claim.vertices->push_back({names[k], places[k], sizes[k]});
    }
  }
  const DiagramReport r =
      Attention::without_lock([&] { return certify_diagram(claim, tolerance, threads); });
  return py::dict("verdict"_a = name(r.verdict), "about"_a = r.about,
                  "reservations"_a = r.reservations, "reason"_a = r.reason);
}

}  // namespace

void bind_certify(py::module_& module) {
  bind_judge<Scene, EventTable>(
      module, "certify",
      [](const Scene& scene, const EventTable& history, const CertifyOptions& options) {
        return certify(scene, history.history(), options);
      });
  bind_judge<Billiard, BilliardHistory>(
      module, "certify",
      [](const Billiard& billiard, const BilliardHistory& history, const CertifyOptions& options) {
        return certify(billiard, history, options);
      });
  bind_judge<std::string, std::string>(module, "certify_files", &certify_files);
  module.def("certify_diagram", &judged_diagram, "centers"_a, "radii"_a, "frame"_a, "hosts"_a,
             "edges"_a, "neighbours"_a, "vertices"_a, "tolerance"_a, "threads"_a);
  module.def("explain", [](const std::string& json) {
    Report report;
    report.json = json;
    return explain(report);
  });
}

}  // namespace voroproof::python
