// The diagram of a world at one instant, with the disks that have no cell and who hides them; and
// which of its edges have become other ones.
#pragma once

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "exact/topology/diagram.h"
#include "exact/world_events.h"

namespace voroproof::internal {

class LiveDiagram {
 public:
  using HalfEdge = Diagram::HalfEdge;
  static constexpr GenId visible = -2, absent = -3;

  // No disk is there.
  explicit LiveDiagram(int disks)
      : diagram_(disks), host_(static_cast<std::size_t>(disks), absent) {}

  const Diagram& diagram() const { return diagram_; }
  // Who hides the disk; or that it is visible or absent.
  GenId host(GenId g) const { return host_[g]; }
  bool is_visible(GenId g) const { return g == container_id || host_[g] == visible; }
  int visible_disks() const { return visible_disks_; }
  // The one of the least id. Precondition: there is one.
  GenId first_visible() const {
    return static_cast<GenId>(std::find(host_.begin(), host_.end(), visible) - host_.begin());
  }
  // The disks that j hides.
  std::vector<GenId> guests(GenId j) const {
    std::vector<GenId> all;
    for (auto g = guests_.lower_bound({j, container_id}); g != guests_.end() && g->first == j; ++g)
      all.push_back(g->second);
    return all;
  }

  // The beginning: these edges, of the disks that have these hosts, or are visible or absent.
  void begin(Diagram diagram, const std::vector<GenId>& host) {
    diagram_ = std::move(diagram);
    for (GenId g = 0; g < static_cast<GenId>(host.size()); ++g) set_host(g, host[g]);
    for (int edge = 0; edge < diagram_.edges(); ++edge) touched_.push_back(edge);
  }
  void set_host(GenId g, GenId host) {
    visible_disks_ += (host == visible) - (host_[g] == visible);
    guests_.erase({host_[g], g});
    host_[g] = host;
    if (host >= container_id) guests_.insert({host, g});
    moved_.push_back(g);
  }
  // For a disk without edges that goes.
  void leave(GenId g) { set_host(g, absent); }

  void flip(HalfEdge h) {
    diagram_.flip(h);
    const HalfEdge t = Diagram::twin(h);
    for (const HalfEdge k :
         {h, diagram_.next(h), diagram_.previous(h), diagram_.next(t), diagram_.previous(t)}) {
      touched_.push_back(k / 2);
    }
  }
  // The disk, whose cell has two edges or none, is hidden by j from now on, and all that it hides.
  void hide(GenId g, GenId j) {
    const int before = diagram_.edges();
    if (before > 0) {
      for (const int edge : diagram_.remove(g)) touched_.push_back(edge);
      for (int gone = diagram_.edges(); gone < before; ++gone) touched_.push_back(gone);
    }
    set_host(g, j);
    for (const GenId guest : guests(g)) set_host(guest, j);
  }
  // The disk becomes visible where no edge is before: alone, or with the one other.
  void appear(GenId g) {
    const GenId other = visible_disks_ == 1 ? first_visible() : g;
    set_host(g, visible);
    if (other == g) return;
    diagram_.start(other, g);
    touched_.insert(touched_.end(), {0, 1, 2});
  }
  void appear(GenId g, HalfEdge h) {
    set_host(g, visible);
    diagram_.insert_in_edge(h, g);
    for (const HalfEdge k : diagram_.ring(g)) {
      touched_.push_back(k / 2);
      touched_.push_back(diagram_.next(k) / 2);
    }
  }
  // Two that have one place and one radius exchange what they are in the diagram.
  void exchange(GenId i, GenId j) {
    if (is_visible(i) && is_visible(j)) {
      if (diagram_.edges() > 0) diagram_.exchange(i, j);
    } else {
      const GenId seen = is_visible(i) ? i : j, other = i + j - seen;
      rename(seen, other);
    }
    touch_around(i);
    touch_around(j);
  }
  // The edges of the cell and those that have it at an end.
  void touch_around(GenId g) {
    if (!is_visible(g) || diagram_.edges() == 0) return;
    for (const HalfEdge h : diagram_.ring(g)) {
      touched_.push_back(h / 2);
      touched_.push_back(diagram_.next(h) / 2);
    }
  }

  // The edges that have become other ones since this was asked last, some more than once, and some
  // that are no more.
  std::vector<int> take_touched() { return std::exchange(touched_, {}); }
  // The disks that have become hidden by another, visible or absent since this was asked last.
  std::vector<GenId> take_moved() { return std::exchange(moved_, {}); }

 private:
  // A hidden disk takes the place of the visible one that hides it.
  void rename(GenId seen, GenId hidden) {
    if (diagram_.edges() > 0) diagram_.exchange(seen, hidden);
    set_host(hidden, visible);
    set_host(seen, hidden);
    for (const GenId guest : guests(seen)) set_host(guest, hidden);
  }

  Diagram diagram_;
  std::vector<GenId> host_;
  std::set<std::pair<GenId, GenId>> guests_;  // host, guest
  int visible_disks_ = 0;
  std::vector<int> touched_;
  std::vector<GenId> moved_;
};

}  // namespace voroproof::internal
