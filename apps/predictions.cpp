#include "apps/predictions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinetic/static_diagram.h"

namespace voroproof {

PredictionCounter::PredictionCounter(const MotionInput& input)
    : horizon_(round_nearest(input.horizon)),
      motion_(input, MotionOptions{}),
      collapses_(motion_, tiers_),
      contacts_(motion_, tiers_),
      diagram_(Diagram(static_cast<int>(input.disks.size()))) {}

void PredictionCounter::begin(const std::vector<Quad>& initial) {
  diagram_ = NamedDiagram(diagram_of(motion_.size(), initial));
  for (int edge = 0; edge < diagram_.diagram().edges(); ++edge) {
    changed_.insert(2 * edge);
    adjacent_.insert(2 * edge);
  }
}

void PredictionCounter::flip(double t, const Quad& edge) {
  advance(t);
  const Diagram& d = diagram_.diagram();
  const Diagram::HalfEdge h = diagram_.flip(edge), twin = Diagram::twin(h);
  for (const auto side : {h, d.next(h), d.previous(h), d.next(twin), d.previous(twin)})
    changed_.insert(side & ~1);
  adjacent_.insert(h & ~1);
}

void PredictionCounter::collide(double t, GenId i, GenId j) {
  advance(t);
  motion_.collide(i, j, t);
  moved_.insert({i, j});
}

// Everything of one recorded instant is taken together.
void PredictionCounter::advance(double t) {
  if (t != now_) predict();
  now_ = t;
}

void PredictionCounter::predict() {
  const Diagram& d = diagram_.diagram();
  moved_.erase(container_id);
  for (const GenId g : moved_) {
    const auto first = d.anchor(g);
    auto h = first;
    if (h >= 0) do {
        changed_.insert(h & ~1);
        adjacent_.insert(h & ~1);
        changed_.insert(d.next(h) & ~1);  // the edge opposite g at this vertex
        h = d.rotate(h);
      } while (h != first);
  }
  const double start = std::nextafter(now_, std::numeric_limits<double>::infinity());
  if (start <= horizon_) {
    for (const auto h : changed_) flips_ += flips_again(d.quad(h), start);
    std::set<std::pair<GenId, GenId>> pairs;
    for (const auto h : adjacent_) pairs.insert(std::minmax(d.org(h), d.dest(h)));
    const Instant instant = instant_at(to_rational(start));
    for (const auto& [i, j] : pairs)
      collisions_ += contacts_.from(i, j, instant, horizon_).kind != NextContact::Kind::none;
  }
  changed_.clear();
  adjacent_.clear();
  moved_.clear();
}

bool PredictionCounter::flips_again(const Quad& edge, double start) {
  if (edge.s == edge.e) return false;
  while (start < horizon_) {
    const Collapse found = collapses_.after(edge, start, horizon_);
    if (found.kind != Collapse::Kind::none) return true;
    if (!(found.lo > start)) break;
    start = found.lo;
  }
  return false;
}

}  // namespace voroproof
