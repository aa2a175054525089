#include "apps/paper/predictions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/static_diagram.h"
#include "filtered/search/root_presence.h"

namespace voroproof::internal {

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
    const Moment instant = Moment::at(to_rational(start));
    for (const auto h : changed_) predict_flip(d.quad(h), instant);
    std::set<std::pair<GenId, GenId>> pairs;
    for (const auto h : adjacent_) pairs.insert(std::minmax(d.org(h), d.dest(h)));
    for (const auto& [i, j] : pairs)
      collisions_ += contacts_.from(i, j, instant, horizon_).kind != NextContact::Kind::none;
  }
  changed_.clear();
  adjacent_.clear();
  moved_.clear();
}

void PredictionCounter::predict_flip(const Quad& edge, const Moment& now) {
  if (edge.s == edge.e) return;
  roots_ += flip_polynomial_has_root(motion_, edge, now.lo, horizon_);
  const double contact = first_contact(edge, now);
  if (flips_within(edge, now.lo, contact)) {
    ++flips_;
    ++flips_before_contact_;
  } else if (flips_within(edge, contact, horizon_)) {
    ++flips_;
  }
}

// A time before which no two of the four touch, but next to it they do; or the horizon.
double PredictionCounter::first_contact(const Quad& edge, const Moment& now) {
  double first = horizon_;
  const std::array<GenId, 4> four{edge.l, edge.r, edge.s, edge.e};
  for (const GenId i : four) {
    for (const GenId j : four) {
      if (i >= j) continue;
      const NextContact contact = contacts_.from(i, j, now, first);
      if (contact.kind == NextContact::Kind::at) first = std::min(first, contact.lo);
    }
  }
  return std::max(first, now.lo);
}

bool PredictionCounter::flips_within(const Quad& edge, double start, double end) {
  while (start < end) {
    const Collapse found = collapses_.after(edge, start, end);
    if (found.kind != Collapse::Kind::none) return true;
    if (!(found.lo > start)) break;
    start = found.lo;
  }
  return false;
}

}  // namespace voroproof::internal
