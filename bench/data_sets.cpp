#include "bench/data_sets.h"

#include <map>
#include <stdexcept>
#include <utility>

#include "corpus/generate.h"
#include "engine/static_diagram.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::bench {

namespace {

ReferenceOptions options_of(const std::string& name) {
  ReferenceOptions o;
  if (name == "reference") return o;
  if (name == "equal") {
    o.radii = ReferenceOptions::Radii::equal;
    o.rmax = 5;
    return o;
  }
  if (name == "nearly_equal") {
    o.rmin = 5;
    o.rmax = 5 * (1 + 1e-9);
    return o;
  }
  if (name == "dense") {
    o.density = 0.4;
    return o;
  }
  if (name == "log_radii") {
    o.radii = ReferenceOptions::Radii::log;
    o.rmin = 0.1;
    o.rmax = 30;
    o.density = 0.3;
    return o;
  }
  throw std::invalid_argument("no data set is called " + name);
}

DataSet make(const std::string& name) {
  DataSet set{name, generate_reference(options_of(name)), nullptr, {}};
  set.motion = motion_of(set.scene);
  TierCounts counts;
  const Diagram diagram = static_diagram(*set.motion, 0, counts);
  for (const Quad& q : diagram.quads()) {
    if (q.s != q.e) set.quads.push_back(q);
  }
  return set;
}

}  // namespace

std::unique_ptr<ComputedMotion> motion_of(const Scene& scene) {
  return std::make_unique<ComputedMotion>(motion_input(scene), MotionOptions{});
}

const DataSet& data_set(const std::string& name) {
  static std::map<std::string, DataSet> made;
  const auto found = made.find(name);
  if (found != made.end()) return found->second;
  return made.emplace(name, make(name)).first->second;
}

}  // namespace voroproof::internal::bench
