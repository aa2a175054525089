// All that is done at an instant of a sweep.
#include <algorithm>
#include <utility>

#include "engine/world/cell_exit.h"
#include "engine/world/hosts.h"
#include "engine/world/moving_edge.h"
#include "engine/world/touch.h"
#include "engine/world/world_sweep.h"
#include "exact/patience.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {

void WorldSweep::turn(GenId g) {
  turned_.insert(g);
  live_.touch_around(g);
  if (live_.is_visible(g)) {
    for (const GenId guest : live_.guests(g)) {
      exits_.insert(guest);
      stale_disks_.insert(guest);
    }
  } else {
    exits_.insert(g);
    stale_disks_.insert(g);
  }
  absorb();
}

void WorldSweep::arrive(GenId g) {
  turn(g);
  arrived_.insert(g);
}

void WorldSweep::suspect(const std::vector<int>& edges, const std::vector<GenId>& disks) {
  for (const int edge : edges) {
    stale_edges_.insert(edge);
    if (edge < live_.diagram().edges()) suspect(edge);
  }
  for (const GenId g : disks) {
    exits_.insert(g);
    stale_disks_.insert(g);
  }
}

void WorldSweep::suspect(int edge) {
  new_pairs_.insert(edge);
  new_edges_.insert(edge);
  stale_edges_.insert(edge);
}

// Takes note of what has changed.
void WorldSweep::absorb() {
  for (const int edge : live_.take_touched()) {
    std::erase_if(illegal_, [&](const auto& known) { return known.second == edge; });
    due_edges_.erase(edge);
    fresh_edges_.erase(edge);
    if (edge < live_.diagram().edges()) {
      suspect(edge);
    } else {
      new_pairs_.erase(edge);
      new_edges_.erase(edge);
      stale_edges_.insert(edge);
    }
  }
  for (const GenId g : live_.take_moved()) stale_disks_.insert(g);
}

// Swaps, hides, appears, then flips; within each the smallest first (docs/formats.md, section 20).
void WorldSweep::settle() {
  std::size_t steps = 0;
  do {
    Patience::ask_now();
    const auto edges = static_cast<std::size_t>(live_.diagram().edges());
    if (++steps > 1000 + edges * edges) throw Undecided("the events of one instant do not end");
    absorb();
    examine_pairs();
  } while (swap_one() || hide_one() || appear_one() || touch_one() || flip_one());
  check_crowded();
  sink_.instant_is_over();
}

// Beside others that it touches when it comes out the cell of a disk may need other flips than
// those of edges that collapse.
void WorldSweep::check_crowded() {
  const Diagram& diagram = live_.diagram();
  for (const GenId g : std::exchange(crowded_, {})) {
    if (!live_.is_visible(g) || diagram.edges() == 0) continue;
    for (const HalfEdge h : diagram.ring(g)) {
      for (const HalfEdge k : {h, diagram.next(h)}) {
        const Quad q = diagram.quad(k);
        if (q.s == q.e || !MovingEdge(rows_, q).is_illegal_after(now_.exact())) continue;
        throw Undecided("a disk comes out where it touches more than one other", g, q.l);
      }
    }
  }
}

void WorldSweep::examine_pairs() {
  for (const int edge : new_pairs_) {
    const Quad q = live_.diagram().quad(2 * edge);
    for (const auto& [g, j] : {Pair(q.l, q.r), Pair(q.r, q.l)}) {
      if (g != container_id && hides_after(rows_, j, g, now_)) hides_.insert({g, j});
    }
  }
  new_pairs_.clear();
  if (rows_.has_circle() && live_.visible_disks() == 1) {
    const GenId g = live_.first_visible();
    if (hides_after(rows_, container_id, g, now_)) hides_.insert({g, container_id});
  }
}

bool WorldSweep::swap_one() {
  if (swaps_.empty()) return false;
  const auto [i, j] = *swaps_.begin();
  swaps_.erase(swaps_.begin());
  if (!live_.is_visible(i) || !live_.is_visible(j)) return true;
  if (arrived_.contains(i) || arrived_.contains(j)) return true;
  if (turned_.contains(i) || turned_.contains(j)) {
    if (sign_after(rows_.tangency_of(i, j), now_.exact()) != Sign::positive) return true;  // hides
    throw Undecided("two disks are the same at one instant, and one of them turns", i, j);
  }
  exchange(i, j);
  return true;
}

void WorldSweep::exchange(GenId i, GenId j) {
  for (GenId g = 0; g < rows_.disks(); ++g) {
    if (g == i || g == j || !rows_.is_there(g) || arrived_.contains(g)) continue;
    if (coincide_at(rows_, g, i, now_)) {
      throw Undecided("three disks are the same at one instant", i, j);
    }
  }
  if (!sink_.takes_swaps()) {
    if (live_.is_visible(i) && live_.is_visible(j)) {
      throw Undecided("two disks are the same while another jumps", i, j);
    }
    const GenId seen = live_.is_visible(i) ? i : j;
    take_place(i + j - seen, seen);
    return;
  }
  live_.exchange(i, j);
  sink_.change(now_, Swap{std::min(i, j), std::max(i, j)});
}

// g comes into some edge of the cell of j, which has it as its host, and takes one edge of that
// cell after the other.
void WorldSweep::take_place(GenId g, GenId j) {
  const Diagram& diagram = live_.diagram();
  if (diagram.edges() == 0) {
    live_.appear(g);
    sink_.change(now_, Appear{g, j, std::nullopt});
  } else {
    const HalfEdge at = diagram.anchor(j);
    sink_.change(now_, Appear{g, j, diagram.quad(at)});
    live_.appear(g, at);
  }
  if (diagram.edges() > 0) {
    HalfEdge to_g = diagram.anchor(j);
    while (diagram.dest(to_g) != g) to_g = diagram.rotate(to_g);
    while (diagram.rotate(diagram.rotate(to_g)) != to_g) flip(diagram.rotate(to_g));
  }
  live_.hide(j, g);
  sink_.change(now_, Hide{j, g});
}

bool WorldSweep::hide_one() {
  std::erase_if(hides_, [&](const Pair& pair) {
    return !live_.is_visible(pair.first) || !live_.is_visible(pair.second);
  });
  // One that is not beside its host alone, since another is there that hides, too, comes after
  // that.
  const Diagram& diagram = live_.diagram();
  for (const auto& [g, j] : hides_) {
    const std::optional<HalfEdge> spoke =
        diagram.edges() > 0 ? edge_without_length(diagram, g, j) : -1;
    if (!spoke) continue;
    const std::vector<GenId> beside = diagram.neighbours(g);
    if (*spoke < 0 && !std::binary_search(beside.begin(), beside.end(), j) && !beside.empty()) {
      continue;
    }
    if (*spoke >= 0) {
      flip(*spoke);
    } else {
      live_.hide(g, j);
      sink_.change(now_, Hide{g, j});
    }
    return true;
  }
  if (hides_.empty()) return false;
  const auto [g, j] = *hides_.begin();
  throw Undecided("a disk is hidden while its cell has an area", g, j);
}

bool WorldSweep::appear_one() {
  while (!exits_.empty()) {
    const GenId g = *exits_.begin();
    exits_.erase(exits_.begin());
    const GenId j = live_.host(g);
    if (j < container_id || hides_after(rows_, j, g, now_)) continue;
    if (j >= 0 && hides_after(rows_, g, j, now_)) {
      exchange(g, j);
      exits_.insert(g);
      return true;
    }
    const GenId host = host_after(rows_, g, now_);
    if (host != LiveDiagram::visible) {
      live_.set_host(g, host);
      continue;
    }
    const GenId last = visible_host(j);
    if (live_.diagram().edges() == 0) {
      live_.appear(g);
      sink_.change(now_, Appear{g, last, std::nullopt});
    } else {
      const std::vector<GenId> others = also_left_at(rows_, live_, last, g, now_);
      if (!others.empty()) crowded_.insert(g);
      const GenId from = nearest_after(rows_, last, others, g, now_);
      HalfEdge h = cell_exit(rows_, live_.diagram(), from, g, now_.exact());
      // Between it and one that g touches then the edge is named with the host.
      if (live_.diagram().dest(h) == last) h = Diagram::twin(h);
      const Quad at = live_.diagram().quad(h);
      sink_.change(now_, Appear{g, at.l, at});
      live_.appear(g, h);
    }
    return true;
  }
  return false;
}

bool WorldSweep::touch_one() {
  if (touches_.empty()) return false;
  const auto [g, j] = *touches_.begin();
  touches_.erase(touches_.begin());
  if (!live_.is_visible(g) || !live_.is_visible(j) || live_.diagram().edges() <= 3) return true;
  for (const HalfEdge h : flips_after_touch(rows_, live_.diagram(), g, j, now_.exact())) flip(h);
  return true;
}

// Itself or who hides it.
GenId WorldSweep::visible_host(GenId j) const {
  while (!live_.is_visible(j)) {
    if (live_.host(j) == LiveDiagram::absent) {
      throw Undecided("the host of a hidden disk is not there");
    }
    j = live_.host(j);
  }
  return j;
}

// Edges of the same four generators have the same cotangency.
bool WorldSweep::has_flipped(const Quad& q) const {
  return std::any_of(flips_.begin(), flips_.end(),
                     [&](const Quad& other) { return same_generators(q, other); });
}

bool WorldSweep::flip_one() {
  for (const int edge : new_edges_) {
    const Quad q = live_.diagram().quad(2 * edge);
    // One that a flip has just made is legal.
    if (q.s == q.e || fresh_edges_.contains(edge)) continue;
    const bool collapses =
        due_edges_.contains(edge) || (!is_legal_edge(rows_.rough(), q, now_.lo(), now_.hi()) &&
                                      MovingEdge(rows_, q).collapses_at(now_.exact()));
    if (collapses) illegal_.insert({canonical(q), edge});
  }
  new_edges_.clear();
  if (illegal_.empty()) return false;
  const HalfEdge h = 2 * illegal_.begin()->second;
  illegal_.erase(illegal_.begin());
  flips_.push_back(live_.diagram().quad(h));
  flip(h);
  absorb();
  fresh_edges_.insert(h / 2);
  return true;
}

void WorldSweep::flip(HalfEdge h) {
  const Quad q = canonical(live_.diagram().quad(h));
  live_.flip(h);
  sink_.change(now_, q);
}

}  // namespace voroproof::internal
