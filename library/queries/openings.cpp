#include "library/queries/openings.h"

#include <algorithm>
#include <functional>
#include <set>

#include "library/queries/between_roots.h"
#include "library/queries/lines.h"

namespace voroproof::internal {
namespace {

using P = Polynomial<Rational>;

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

// Follows what may be open from one time to another; it may turn at the roots of the candidates.
void follow(Openings& openings, const Rational& from, const Rational& to,
            const std::vector<P>& candidates, const std::function<bool(const Rational&)>& open) {
  between_roots(from, to, candidates, [&](const AlgebraicTime& since, const Rational& inside) {
    openings.turn(enclosure(since), open(inside));
  });
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
    for (const Diagram::HalfEdge h : diagram.ring(i)) {
      if (diagram.dest(h) == j) edges.push_back(diagram.quad(h));
    }
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
    follow(openings, from, to, candidates, [&](const Rational& t) {
      return std::any_of(edges.begin(), edges.end(), [&](const Quad& q) {
        const std::vector<Lines::Fit> nodes = lines.along(q, t, probe);
        return std::all_of(nodes.begin(), nodes.end(), [](const Lines::Fit& n) { return n.fits; });
      });
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
    follow(openings, from, to, {lines.vertex(name, probe)},
           [&](const Rational& t) { return lines.fits(name, t, probe); });
  };
  walk<Triple>(paths, history, window, present, generators, part);
  return openings.finish(window.to);
}

}  // namespace voroproof::internal
