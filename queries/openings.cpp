#include "queries/openings.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "exact/polynomial.h"
#include "exact/roots.h"
#include "queries/clearance.h"

namespace voroproof {
namespace {

using P = Polynomial<Rational>;

// A few generators on lines, in the time since `start`.
class Lines {
 public:
  Lines(const Paths& paths, const std::set<GenId>& generators, const Rational& start)
      : start_(start) {
    GenId next = 0;
    for (const GenId g : generators) {
      local_[g] = g == container_id ? container_id : next++;
      const RecordedState& piece = paths.piece(g, start);
      const ExactVec2 p = position_at(piece, start);
      lines_[g] = {P{p[0], piece.velocity[0]}, P{p[1], piece.velocity[1]}, paths.signed_radius(g)};
    }
    const RecordedState& container = paths.piece(container_id, start);
    input_.container_x = container.center[0];
    input_.container_y = container.center[1];
    input_.container_radius = -paths.signed_radius(container_id);
    for (const GenId g : generators) {
      if (g == container_id) continue;
      const RecordedState& piece = paths.piece(g, start);
      const ExactVec2 p = position_at(piece, start);
      input_.disks.push_back(
          {p[0], p[1], paths.signed_radius(g), piece.velocity[0], piece.velocity[1], 1});
    }
  }

  // Vanishes where the gap is twice the probe's radius.
  P gate(GenId i, GenId j, const Rational& probe) const {
    const Line &a = lines_.at(i), &b = lines_.at(j);
    const P x = a.x - b.x, y = a.y - b.y;
    const Rational reach = a.radius + b.radius + 2 * probe;
    return x * x + y * y - P{reach * reach};
  }
  // Vanishes where a circle of the probe's radius touches all three.
  P vertex(const Triple& v, const Rational& probe) const {
    const Line &a = lines_.at(v[0]), &b = lines_.at(v[1]), &c = lines_.at(v[2]);
    const P bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const Rational ra = a.radius + probe, rb = b.radius + probe, rc = c.radius + probe;
    // The centre y, from that of a: 2 y.b = eb and 2 y.c = ec, and y.y = ra^2.
    const P eb = bx * bx + by * by + P{ra * ra - rb * rb};
    const P ec = cx * cx + cy * cy + P{ra * ra - rc * rc};
    const P u = eb * cy - ec * by, w = bx * ec - cx * eb;
    const P det = bx * cy - by * cx;
    return u * u + w * w - det * det * Rational(4 * ra * ra);
  }

  // Whether the probe fits along the edge, or at the vertex, at a time since the start. The closed
  // edge around a lone disk is given as [l,r,l,l].
  bool passes(const Quad& q, const Rational& t, const Rational& probe) const {
    const Motion motion(input_, {});
    TierCounts counts;
    InstantPredicates predicates(motion, t, counts, {probe});
    if (q.s == q.l) {
      return clearance_to_probe(predicates, gate_node(0, container_id), 0) != Sign::negative;
    }
    const Quad own{local_.at(q.l), local_.at(q.r), local_.at(q.s), local_.at(q.e)};
    for (const ClearanceNode& node : edge_profile(predicates, own)) {
      if (clearance_to_probe(predicates, node, 0) == Sign::negative) return false;
    }
    return true;
  }
  bool fits(const Triple& v, const Rational& t, const Rational& probe) const {
    const Motion motion(input_, {});
    TierCounts counts;
    InstantPredicates predicates(motion, t, counts, {probe});
    const Triple own{local_.at(v[0]), local_.at(v[1]), local_.at(v[2])};
    return clearance_to_probe(predicates, vertex_node(own), 0) != Sign::negative;
  }

 private:
  struct Line {
    P x, y;
    Rational radius;  // signed
  };
  Rational start_;
  std::map<GenId, GenId> local_;
  std::map<GenId, Line> lines_;
  MotionInput input_;
};

// Joins what is open from one part of the window to the next.
class Openings {
 public:
  // Open, or not, from the enclosed time on.
  void turn(const Enclosure& t, bool open) {
    if (open == open_) return;
    if (open) {
      all_.push_back({t, t});
    } else {
      all_.back().to = t;
    }
    open_ = open;
  }
  std::vector<Opening> finish(const Rational& end) {
    turn(enclosure(end), false);
    return std::move(all_);
  }

 private:
  std::vector<Opening> all_;
  bool open_ = false;
};

// From `start` for `length`: candidates are the polynomials at whose roots it may turn.
void follow(Openings& openings, const Rational& start, const Rational& length,
            const std::vector<P>& candidates, const std::function<bool(const Rational&)>& open) {
  P product{1};
  for (const P& f : candidates) {
    if (!f.is_zero()) product = product * f;
  }
  std::vector<RootInterval> roots = isolate_roots(product, Rational(0), length);
  // No decision at an end of the part, where a flip is near and recorded times are rounded: so
  // narrow the roots first.
  const Rational width = (1 + start + length) / Rational(Integer(1) << 60);
  for (RootInterval& root : roots) refine(product, root, width);
  Rational before = 0;  // where the last root, or the part, left off
  Enclosure since = enclosure(start);
  for (std::size_t k = 0; k <= roots.size(); ++k) {
    const Rational next = k < roots.size() ? roots[k].lo : length;
    // Nothing lies between the start or the end and a root just there.
    if (before < next || roots.empty()) {
      openings.turn(since, open(Rational((before + next) / 2)));
    }
    if (k == roots.size()) break;
    since = {round_down(Rational(start + roots[k].lo)), round_up(Rational(start + roots[k].hi))};
    before = roots[k].hi;
  }
}

// Walks through the window. `present` gives what is to be watched now, in the diagram; each part in
// which it stays the same and its generators keep their lines goes to `part`.
template <class Watched>
void walk(const Paths& paths, HistoryCursor& history, const Window& window,
          const std::function<std::vector<Watched>()>& present,
          const std::function<std::set<GenId>(const std::vector<Watched>&)>& generators,
          const std::function<void(const std::vector<Watched>&, const Rational&, const Rational&)>&
              part) {
  history.seek(window.from);
  Rational since = window.from;
  std::vector<Watched> watched = present();
  const auto close = [&](const Rational& t) {
    if (t <= since) return;
    const std::set<GenId> all = generators(watched);
    Rational from = since;
    std::vector<Rational> ends = paths.turns({all.begin(), all.end()}, since, t);
    ends.push_back(t);
    for (const Rational& to : ends) {
      part(watched, from, to);
      from = to;
    }
    since = t;
  };
  const std::size_t end = history.position_at(window.to);
  while (history.position() < end) {
    const Rational t = std::min(exact_time(history.event(history.position())), window.to);
    history.next();
    std::vector<Watched> now = present();
    if (now == watched) continue;
    close(t);
    watched = std::move(now);
  }
  close(window.to);
}

}  // namespace

std::vector<Opening> tunnel_openings(const Paths& paths, HistoryCursor& history, GenId i, GenId j,
                                     const Rational& probe, const Window& window) {
  if (i == container_id) std::swap(i, j);
  const Diagram& diagram = history.diagram().diagram();
  Openings openings;
  const auto present = [&] {
    std::vector<Quad> edges;
    if (diagram.disks() == 1) return std::vector<Quad>{{i, j, i, i}};
    const Diagram::HalfEdge first = diagram.anchor(i);
    Diagram::HalfEdge h = first;
    do {
      if (diagram.dest(h) == j) edges.push_back(diagram.quad(h));
      h = diagram.rotate(h);
    } while (h != first);
    std::sort(edges.begin(), edges.end());
    return edges;
  };
  const auto generators = [](const std::vector<Quad>& edges) {
    std::set<GenId> all;
    for (const Quad& q : edges) all.insert({q.l, q.r, q.s, q.e});
    return all;
  };
  const auto part = [&](const std::vector<Quad>& edges, const Rational& from, const Rational& to) {
    if (edges.empty()) {
      openings.turn(enclosure(from), false);
      return;
    }
    const Lines lines(paths, generators(edges), from);
    std::vector<P> candidates{lines.gate(i, j, probe)};
    for (const Quad& q : edges) {
      if (q.s == q.l) continue;
      candidates.push_back(lines.vertex(start_vertex(q), probe));
      candidates.push_back(lines.vertex(end_vertex(q), probe));
    }
    follow(openings, from, to - from, candidates, [&](const Rational& t) {
      return std::any_of(edges.begin(), edges.end(),
                         [&](const Quad& q) { return lines.passes(q, t, probe); });
    });
  };
  walk<Quad>(paths, history, window, present, generators, part);
  return openings.finish(window.to);
}

std::vector<Opening> void_openings(const Paths& paths, HistoryCursor& history, const Triple& vertex,
                                   const Rational& probe, const Window& window) {
  const Triple name = canonical(vertex);
  const std::set<GenId> all(name.begin(), name.end());
  Openings openings;
  const auto present = [&] {
    return history.diagram().has_vertex(name) ? std::vector<Triple>{name} : std::vector<Triple>{};
  };
  const auto generators = [&](const std::vector<Triple>& there) {
    return there.empty() ? std::set<GenId>{} : all;
  };
  const auto part = [&](const std::vector<Triple>& there, const Rational& from,
                        const Rational& to) {
    if (there.empty()) {
      openings.turn(enclosure(from), false);
      return;
    }
    const Lines lines(paths, all, from);
    follow(openings, from, to - from, {lines.vertex(name, probe)},
           [&](const Rational& t) { return lines.fits(name, t, probe); });
  };
  walk<Triple>(paths, history, window, present, generators, part);
  return openings.finish(window.to);
}

}  // namespace voroproof
