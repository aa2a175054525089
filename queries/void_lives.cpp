#include "queries/void_lives.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "queries/between_roots.h"
#include "queries/lines.h"

namespace voroproof {
namespace {

using HalfEdge = Diagram::HalfEdge;

// What an edge has of the graph: nodes, and which two of them are joined along it.
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

// Sets of things that are found to belong together.
template <class T>
class Classes {
 public:
  const T& find(const T& x) {
    const auto at = parent_.emplace(x, x).first;
    if (at->second == x) return at->first;
    const T root = find(at->second);
    return parent_.insert_or_assign(x, root).first->second;
  }
  // The smaller stands for both.
  void join(const T& a, const T& b) {
    const T x = find(a), y = find(b);
    parent_.insert_or_assign(std::max(x, y), std::min(x, y));
  }

 private:
  std::map<T, T> parent_;
};

// The voids as the graph changes.
class Lives {
 public:
  explicit Lives(std::size_t edges) : graphs_(edges) {}

  void change(const Change& change) { graphs_[change.edge] = change.graph; }
  void meet(const Meeting& meeting) {
    for (const Triple& v : meeting.vertices) places_.join(meeting.vertices[0], v);
  }

  // After all changes and meetings of one time.
  void settle(const Enclosure& t) {
    Classes<ClearanceNode> components;
    std::set<ClearanceNode> nodes;
    for (const EdgeGraph& graph : graphs_) {
      nodes.insert(graph.nodes.begin(), graph.nodes.end());
      for (const auto& [a, b] : graph.links) components.join(a, b);
    }
    // Which voids there were at the nodes of each, by its smallest.
    std::map<ClearanceNode, std::set<std::size_t>> before;
    std::map<std::size_t, std::set<ClearanceNode>> after;
    for (const ClearanceNode& node : nodes) {
      std::set<std::size_t>& olds = before[components.find(node)];
      const auto [first, last] = old_.equal_range(place(node));
      for (auto at = first; at != last; ++at) olds.insert(at->second);
    }
    for (const auto& [component, olds] : before) {
      for (const std::size_t v : olds) after[v].insert(component);
    }
    std::map<ClearanceNode, std::size_t> numbers;
    for (const auto& [component, olds] : before) {
      const bool same = olds.size() == 1 && after.at(*olds.begin()).size() == 1;
      numbers[component] = same ? *olds.begin() : lives_.size();
      if (!same) lives_.push_back({t, t, {olds.begin(), olds.end()}, {}, component});
    }
    for (const std::size_t v : present_) {
      const auto into = after.find(v);
      if (into != after.end() && into->second.size() == 1 &&
          numbers.at(*into->second.begin()) == v) {
        continue;
      }
      lives_[v].to = t;
      if (into == after.end()) continue;
      for (const ClearanceNode& component : into->second) {
        lives_[v].after.push_back(numbers.at(component));
      }
    }
    present_.clear();
    members_.clear();
    for (const ClearanceNode& node : nodes) {
      const std::size_t v = numbers.at(components.find(node));
      present_.insert(v);
      members_.emplace(node, v);
    }
    places_ = {};
  }

  // Before the changes and meetings of the next time; the meetings are noted.
  void place_members() {
    old_.clear();
    for (const auto& [node, v] : members_) old_.emplace(place(node), v);
  }

  std::vector<VoidLife> finish(const Enclosure& t) {
    for (const std::size_t v : present_) lives_[v].to = t;
    return std::move(lives_);
  }

 private:
  // Vertices that meet are at one place.
  ClearanceNode place(const ClearanceNode& node) {
    if (node.kind != ClearanceNode::Kind::vertex) return node;
    return vertex_node(places_.find(node.generators));
  }

  std::vector<EdgeGraph> graphs_;
  Classes<Triple> places_;
  std::map<ClearanceNode, std::size_t> members_;   // of the voids
  std::multimap<ClearanceNode, std::size_t> old_;  // the same by their places
  std::set<std::size_t> present_;
  std::vector<VoidLife> lives_;
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
  std::vector<Change>& changes = walk.changes;
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return compare(a.t, b.t) < 0; });
  Lives lives(diagram.disks() == 1 ? 1 : static_cast<std::size_t>(diagram.edges()));
  auto meeting = walk.meetings.begin();
  for (auto change = changes.begin(); change != changes.end();) {
    const AlgebraicTime t = change->t;
    for (; meeting != walk.meetings.end() && compare(t, meeting->t) >= 0; ++meeting) {
      lives.meet(*meeting);
    }
    lives.place_members();
    for (; change != changes.end() && compare(change->t, t) == 0; ++change) lives.change(*change);
    lives.settle(enclosure(t));
  }
  return lives.finish(end);
}

}  // namespace voroproof
