#include "engine/world/world_sweep.h"

#include <utility>

#include "engine/world/hosts.h"
#include "engine/world/moving_edge.h"
#include "engine/world/next_root.h"
#include "exact/patience.h"

namespace voroproof::internal {

WorldSweep::WorldSweep(LiveDiagram& live, const MovingRows& rows, const Rational& now, Rational end,
                       ChangeSink& sink)
    : live_(live), rows_(rows), now_(now), end_(std::move(end)), sink_(sink) {}

std::optional<LazyTime> WorldSweep::next() const {
  if (queue_.empty()) return std::nullopt;
  LazyTime first = found_.at(queue_.begin()->second);
  for (auto k = std::next(queue_.begin()); k != queue_.end() && k->first <= first.hi(); ++k) {
    const LazyTime& other = found_.at(k->second);
    if (compare(other, first) < 0) first = other;
  }
  return first;
}

void WorldSweep::run_before(const Rational& until) {
  for (auto t = next(); t && compare(*t, until) < 0; t = next()) step(*t);
}

void WorldSweep::run_up_to(const Rational& until) {
  for (auto t = next(); t && compare(*t, until) <= 0; t = next()) step(*t);
}

void WorldSweep::step(const LazyTime& t) {
  now_ = t;
  gather_due();
  settle();
  look_ahead();
}

void WorldSweep::begin_instant(const Rational& t) {
  now_ = t;
  gather_due();
}

void WorldSweep::gather_due() {
  std::vector<Item> due;
  for (const auto& [key, item] : queue_) {
    if (key > now_.hi()) break;
    if (compare(found_.at(item), now_) == 0) due.push_back(item);
  }
  for (const Item& item : due) {
    schedule(item, std::nullopt);
    const auto [kind, index] = item;
    if (kind == Kind::alone) continue;  // is examined in any case
    if (kind == Kind::exit) {
      exits_.insert(index);
      stale_disks_.insert(index);
      continue;
    }
    suspect(index);
    if (kind == Kind::collapse) due_edges_.insert(index);
    if (kind != Kind::meeting) continue;
    const Quad q = live_.diagram().quad(2 * index);
    const auto [i, j] = std::minmax(q.l, q.r);
    if (i != container_id && coincide_at(rows_, i, j, now_)) {
      swaps_.insert({i, j});
    } else {
      const bool is_inner =
          i != container_id && sign_at(rows_.excess(i, j), now_.exact()) == Sign::positive;
      touches_.insert(is_inner ? Pair(i, j) : Pair(j, i));
    }
  }
}

void WorldSweep::schedule(const Item& item, std::optional<LazyTime> time) {
  const auto known = found_.find(item);
  if (known != found_.end()) {
    queue_.erase({known->second.lo(), item});
    found_.erase(known);
  }
  if (!time) return;
  queue_.insert({time->lo(), item});
  found_.emplace(item, std::move(*time));
}

std::optional<LazyTime> WorldSweep::collapse_of(const Quad& q) const {
  if (q.s == q.e) return std::nullopt;
  const bool flipped = has_flipped(q);
  const std::optional<double> beyond = now_.alone_until(q);
  RoughCollapse rough;
  if (!flipped) {
    rough = rough_collapse(rows_.rough(), q, now_.lo(), now_.hi(), round_up(end_));
  } else if (beyond) {
    rough = rough_collapse(rows_.rough(), q, *beyond, *beyond, round_up(end_));
  }
  if (rough.kind == RoughCollapse::Kind::none) return std::nullopt;
  if (rough.kind == RoughCollapse::Kind::collapses) {
    const auto polynomial = [&rows = rows_, q] { return MovingEdge(rows, q).polynomial(); };
    return LazyTime(rows_.rough(), q, rough.root, polynomial);
  }
  const MovingEdge moving(rows_, q);
  const auto collapses = [&](const WorldTime& t, Sign after) {
    return moving.collapses_at(t, after);
  };
  return first_root(moving.polynomial(), now_.exact(), end_, collapses, flipped);
}

void WorldSweep::look_ahead() {
  const Diagram& diagram = live_.diagram();
  for (const int edge : stale_edges_) {
    Patience::ask_now();
    std::optional<LazyTime> collapse, meeting;
    if (edge < diagram.edges()) {
      const Quad q = diagram.quad(2 * edge);
      collapse = collapse_of(q);
      meeting = meeting_after(rows_, q.l, q.r, now_, end_);
    }
    schedule({Kind::collapse, edge}, std::move(collapse));
    schedule({Kind::meeting, edge}, std::move(meeting));
  }
  for (const GenId g : stale_disks_) {
    const GenId host = live_.host(g);
    std::optional<LazyTime> exit;
    if (host >= container_id) exit = exit_after(rows_, host, g, now_, end_);
    schedule({Kind::exit, g}, std::move(exit));
  }
  std::optional<LazyTime> leaves;
  if (rows_.has_circle() && live_.visible_disks() == 1) {
    leaves = meeting_after(rows_, live_.first_visible(), container_id, now_, end_);
  }
  schedule({Kind::alone, 0}, std::move(leaves));
  flips_.clear();
  due_edges_.clear();
  fresh_edges_.clear();
  turned_.clear();
  arrived_.clear();
  edges_seen_.merge(stale_edges_);
  disks_seen_.merge(stale_disks_);
  stale_edges_.clear();
  stale_disks_.clear();
}

}  // namespace voroproof::internal
