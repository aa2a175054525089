#include "library/queries/void_lives.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "library/queries/between_roots.h"
#include "library/queries/changing_components.h"
#include "library/queries/lines.h"

namespace voroproof::internal {
namespace {

using HalfEdge = Diagram::HalfEdge;

// The edge's part of the graph: nodes, and which two of them are joined along it; sorted.
struct EdgeGraph {
  std::vector<ClearanceNode> nodes;
  std::vector<std::pair<ClearanceNode, ClearanceNode>> links;
  bool operator==(const EdgeGraph&) const = default;
};

EdgeGraph graph_of(const std::vector<Lines::Fit>& along) {
  EdgeGraph graph;
  std::optional<ClearanceNode> last;  // from which the probe has come along so far
  for (const Lines::Fit& fit : along) {
    if (!fit.fits) {
      last.reset();
    } else if (fit.node.kind != ClearanceNode::Kind::gate) {
      graph.nodes.push_back(fit.node);
      if (last) graph.links.emplace_back(*last, fit.node);
      last = fit.node;
    }
  }
  std::sort(graph.nodes.begin(), graph.nodes.end());
  std::sort(graph.links.begin(), graph.links.end());
  return graph;
}

struct Change {
  AlgebraicTime t;
  std::size_t edge;
  EdgeGraph graph;  // from then on
};

// The four vertices of a flipped edge.
struct Meeting {
  Rational t;
  std::array<Triple, 4> vertices;
};

// Follows every edge through the window, one life after the other.
class EdgeWalk {
 public:
  EdgeWalk(const Paths& paths, HistoryCursor& history, const Rational& probe, const Window& window)
      : paths_(paths), history_(history), probe_(probe), window_(window) {}

  void run() {
    history_.seek(window_.from);
    const Diagram& diagram = history_.diagram().diagram();
    const bool ring = diagram.disks() == 1;
    const std::size_t edges = ring ? 1 : static_cast<std::size_t>(diagram.edges());
    since_.assign(edges, window_.from);
    if (ring) {
      follow(0, {0, container_id, 0, 0}, window_.to);
      return;
    }
    const std::size_t end = history_.position_at(window_.to);
    while (history_.position() < end) {
      const Event& event = history_.event(history_.position());
      if (const auto* flip = std::get_if<FlipEvent>(&event)) {
        const Rational t = std::min(exact_time(event), window_.to);
        const HalfEdge h = history_.diagram().find(flip->quad);
        // Where there is no such edge, next() says so.
        if (h >= 0) note_flip(h, flip->quad, t);
      }
      history_.next();
    }
    for (std::size_t e = 0; e < edges; ++e) {
      follow(e, diagram.quad(static_cast<HalfEdge>(2 * e)), window_.to);
    }
  }

  std::vector<Change> changes;
  std::vector<Meeting> meetings;  // in order of time

 private:
  void note_flip(HalfEdge h, const Quad& q, const Rational& t) {
    const Diagram& d = history_.diagram().diagram();
    const HalfEdge other = Diagram::twin(h);
    for (const HalfEdge side : {h, d.next(h), d.previous(h), d.next(other), d.previous(other)}) {
      follow(static_cast<std::size_t>(side / 2), d.quad(side), t);
    }
    const Quad after = flipped(q);
    meetings.push_back(
        {t, {start_vertex(q), end_vertex(q), start_vertex(after), end_vertex(after)}});
  }

  // The life of an edge up to `to`, piece by piece of its generators' paths.
  void follow(std::size_t edge, const Quad& q, const Rational& to) {
    const Rational from = std::exchange(since_[edge], to);
    if (to <= from) return;
    std::vector<Rational> ends = paths_.turns({q.l, q.r, q.s, q.e}, from, to);
    ends.push_back(to);
    Rational start = from;
    for (const Rational& end : ends) {
      follow_piece(edge, q, start, end);
      start = end;
    }
  }

  void follow_piece(std::size_t edge, const Quad& q, const Rational& from, const Rational& to) {
    const Lines lines(paths_, {q.l, q.r, q.s, q.e}, from);
    std::vector<Polynomial<Rational>> candidates{lines.gate(q.l, q.r, probe_)};
    if (q.s != q.l) {
      candidates.push_back(lines.vertex(start_vertex(q), probe_));
      candidates.push_back(lines.vertex(end_vertex(q), probe_));
    }
    std::optional<EdgeGraph> last;
    const auto part = [&](const AlgebraicTime& since, const Rational& inside) {
      EdgeGraph graph = graph_of(lines.along(q, inside, probe_));
      if (last == graph) return;
      changes.push_back({last ? since : AlgebraicTime(from), edge, graph});
      last = std::move(graph);
    };
    between_roots(from, to, candidates, part);
    // A piece that is all near a root and its ends.
    if (!last) part(from, Rational((from + to) / 2));
  }

  const Paths& paths_;
  HistoryCursor& history_;
  const Rational& probe_;
  const Window& window_;
  std::vector<Rational> since_;  // the start of each edge's present life
};

// Changes of one time, in the order in which they were found.
using Instant = std::vector<const Change*>;

// All changes, in order of time. Most times are those of several edges, and in scenes of equal
// disks those of many: each is compared with one of each time that is so near that their intervals
// overlap, which is one time as a rule.
std::vector<Instant> in_order(const std::vector<Change>& changes) {
  std::vector<const Change*> ascending;
  for (const Change& change : changes) ascending.push_back(&change);
  std::stable_sort(ascending.begin(), ascending.end(), [](const Change* a, const Change* b) {
    return a->t.interval().lo < b->t.interval().lo;
  });
  std::vector<Instant> instants;
  std::size_t first_near = 0;  // instants before it are earlier
  Rational near_up_to;
  for (const Change* change : ascending) {
    const RootInterval& interval = change->t.interval();
    if (instants.empty() || interval.lo > near_up_to) {
      first_near = instants.size();
      near_up_to = interval.hi;
    }
    near_up_to = std::max(near_up_to, interval.hi);
    const auto same =
        std::find_if(instants.begin() + static_cast<std::ptrdiff_t>(first_near), instants.end(),
                     [&](const Instant& i) { return same_time(change->t, i.front()->t); });
    if (same == instants.end()) {
      instants.push_back({change});
    } else {
      same->push_back(change);
    }
  }
  for (Instant& instant : instants) std::sort(instant.begin(), instant.end());
  std::stable_sort(instants.begin(), instants.end(), [](const Instant& a, const Instant& b) {
    return compare(a.front()->t, b.front()->t) < 0;
  });
  return instants;
}

// The items of the first list that the second has not; both are sorted.
template <class T>
std::vector<T> without(const std::vector<T>& all, const std::vector<T>& others) {
  std::vector<T> left;
  std::set_difference(all.begin(), all.end(), others.begin(), others.end(),
                      std::back_inserter(left));
  return left;
}

// The voids as the graph changes. A void is a component of it, and bears its number as a mark.
class Lives {
 public:
  explicit Lives(std::size_t edges) : graphs_(edges) {}

  // Changes and meetings of one time; settle() makes them true.
  void change(const Change& change) { changes_[change.edge] = change.graph; }
  void meet(const Meeting& meeting) { meetings_.push_back(meeting.vertices); }

  void settle(const Enclosure& t) {
    const std::vector<MetPlace> met = met_places();
    std::set<std::size_t> concerned;  // voids that may change or end
    const auto concern = [&](const ClearanceNode& node) {
      const auto there = voids_.of(node);
      if (!there) return;
      concerned.insert(voids_.marks(*there).begin(), voids_.marks(*there).end());
      voids_.mark(*there, {});
    };
    for (const MetPlace& place : met) {
      for (const Triple& v : place.vertices) concern(vertex_node(v));
    }
    for (const auto& [edge, graph] : changes_) {
      for (const ClearanceNode& node : graphs_[edge].nodes) concern(node);
      for (const ClearanceNode& node : graph.nodes) concern(node);
    }
    apply_changes();
    for (const MetPlace& place : met) {
      for (const Triple& v : place.vertices) {
        if (const auto there = voids_.of(vertex_node(v))) voids_.mark(*there, place.voids);
      }
    }
    renumber(t, concerned);
  }

  std::vector<VoidLife> finish(const Enclosure& t) {
    for (Life& life : lives_) {
      if (!life.ended) life.to = t;
    }
    return {lives_.begin(), lives_.end()};
  }

 private:
  // A void that has not ended has no `to` yet.
  struct Life : VoidLife {
    bool ended = false;
  };
  // Vertices that are one point at this time, and the voids there were at them.
  struct MetPlace {
    std::set<Triple> vertices;
    std::set<std::size_t> voids;
  };

  std::set<std::size_t> voids_at(const ClearanceNode& node) const {
    const auto there = voids_.of(node);
    return there ? voids_.marks(*there) : std::set<std::size_t>{};
  }

  // Meetings that share vertices are one place.
  std::vector<MetPlace> met_places() {
    std::vector<MetPlace> places;
    for (const auto& vertices : meetings_) {
      MetPlace joined{{vertices.begin(), vertices.end()}, {}};
      std::erase_if(places, [&](MetPlace& place) {
        const bool shares = std::any_of(vertices.begin(), vertices.end(), [&](const Triple& v) {
          return place.vertices.contains(v);
        });
        if (shares) joined.vertices.merge(place.vertices);
        return shares;
      });
      places.push_back(std::move(joined));
    }
    for (MetPlace& place : places) {
      for (const Triple& v : place.vertices) place.voids.merge(voids_at(vertex_node(v)));
    }
    meetings_.clear();
    return places;
  }

  // Nodes come before others go, and go before links come: so parts have nodes of all the voids
  // whose marks they bear.
  void apply_changes() {
    for (const auto& [edge, graph] : changes_) {
      for (const ClearanceNode& node : without(graph.nodes, graphs_[edge].nodes)) voids_.add(node);
    }
    for (const auto& [edge, graph] : changes_) {
      for (const auto& [a, b] : without(graphs_[edge].links, graph.links)) voids_.cut(a, b);
    }
    for (const auto& [edge, graph] : changes_) {
      for (const auto& node : without(graphs_[edge].nodes, graph.nodes)) voids_.remove(node);
    }
    for (auto& [edge, graph] : changes_) {
      for (const auto& [a, b] : without(graph.links, graphs_[edge].links)) voids_.link(a, b);
      graphs_[edge] = std::move(graph);
    }
    changes_.clear();
  }

  void renumber(const Enclosure& t, const std::set<std::size_t>& concerned) {
    const std::vector<ChangingComponents::Id> touched = voids_.take_touched();
    std::map<std::size_t, std::vector<ChangingComponents::Id>> after;
    for (const auto now : touched) {
      for (const std::size_t v : voids_.marks(now)) after[v].push_back(now);
    }
    for (const auto now : touched) {
      const std::set<std::size_t>& olds = voids_.marks(now);
      if (olds.size() == 1 && after.at(*olds.begin()).size() == 1) continue;
      Life life{{t, t, {olds.begin(), olds.end()}, {}, voids_.smallest(now)}};
      voids_.mark_anew(now, lives_.size());
      lives_.push_back(std::move(life));
    }
    for (const std::size_t v : concerned) {
      const auto into = after.find(v);
      Life& life = lives_[v];
      if (into != after.end()) {
        for (const auto now : into->second) life.after.push_back(*voids_.marks(now).begin());
        if (life.after == std::vector<std::size_t>{v}) {
          life.after.clear();
          continue;
        }
      }
      life.to = t;
      life.ended = true;
    }
  }

  std::vector<EdgeGraph> graphs_;
  std::map<std::size_t, EdgeGraph> changes_;  // by edge
  std::vector<std::array<Triple, 4>> meetings_;
  ChangingComponents voids_;
  std::vector<Life> lives_;
};

}  // namespace

std::vector<VoidLife> void_lives(const Paths& paths, HistoryCursor& history, const Rational& probe,
                                 const Window& window) {
  const Diagram& diagram = history.diagram().diagram();
  const Enclosure start = enclosure(window.from), end = enclosure(window.to);
  if (diagram.disks() == 0) {
    if (probe > -paths.signed_radius(container_id)) return {};
    return {{start, end, {}, {}, {}}};
  }
  EdgeWalk walk(paths, history, probe, window);
  walk.run();
  Lives lives(diagram.disks() == 1 ? 1 : static_cast<std::size_t>(diagram.edges()));
  auto meeting = walk.meetings.begin();
  for (const Instant& instant : in_order(walk.changes)) {
    const AlgebraicTime& t = instant.front()->t;
    for (; meeting != walk.meetings.end(); ++meeting) {
      const auto order = compare(t, meeting->t);
      if (order < 0) break;
      if (order == 0) lives.meet(*meeting);
    }
    for (const Change* change : instant) lives.change(*change);
    lives.settle(enclosure(t));
  }
  return lives.finish(end);
}

}  // namespace voroproof::internal
