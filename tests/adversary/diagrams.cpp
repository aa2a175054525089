#include "tests/adversary/diagrams.h"

#include <algorithm>
#include <set>

#include "tests/oracle/brute_force.h"

namespace voroproof::internal::adversary {
namespace {

using Corner = std::array<int, 3>;

Opinion wrong(const std::string& why) { return {Finding::wrong, why}; }
Opinion unclear(const std::string& why) { return {Finding::unclear, why}; }

// The diagram as its set of edges.
class Claimed {
 public:
  explicit Claimed(const std::vector<Edge>& edges) {
    for (const Edge& q : edges) edges_.insert(canonical(q));
  }
  bool has(const Edge& q) const { return edges_.count(canonical(q)) == 1; }

  // False where the edge is not there or cannot flip.
  bool flip(const Edge& named) {
    const auto [l, r, s, e] = named;
    if (s == e || edges_.erase(canonical(named)) == 0) return false;
    return replace(l, s, Corner{l, s, r}, e) && replace(s, r, Corner{l, s, r}, e) &&
           replace(e, l, Corner{l, r, e}, s) && replace(r, e, Corner{l, r, e}, s) &&
           edges_.insert(canonical({s, e, r, l})).second;
  }
  std::vector<Edge> edges() const { return {edges_.begin(), edges_.end()}; }
  std::set<Corner> corners() const {
    std::set<Corner> corners;
    for (const auto& [l, r, s, e] : edges_) {
      corners.insert(turned({l, s, r}));
      corners.insert(turned({l, r, e}));
    }
    return corners;
  }

 private:
  static Corner turned(const Corner& t) {
    if (t[1] < t[0] && t[1] < t[2]) return {t[1], t[2], t[0]};
    if (t[2] < t[0] && t[2] < t[1]) return {t[2], t[0], t[1]};
    return t;
  }
  // The edge of a and b at the corner gets another third generator there.
  bool replace(int a, int b, const Corner& corner, int third) {
    for (const Edge& q : edges_) {
      const auto [l, r, s, e] = q;
      if (!((l == a && r == b) || (l == b && r == a))) continue;
      Edge changed = q;
      if (turned({l, s, r}) == turned(corner)) {
        changed[2] = third;
      } else if (turned({l, r, e}) == turned(corner)) {
        changed[3] = third;
      } else {
        continue;
      }
      edges_.erase(q);
      return edges_.insert(canonical(changed)).second;
    }
    return false;
  }
  std::set<Edge> edges_;
};

// Whether all generators but its contacts stay clear of an empty circle by more than the places of
// the generators, of some 30 digits, are uncertain. A tie that lasts looks like a near miss there.
bool is_clear(const oracle::CotangentClass& c, const std::vector<oracle::Circle>& disks,
              const oracle::Circle& container) {
  const oracle::Real margin = container.radius * 1e-20;
  for (int id = -1; id < static_cast<int>(disks.size()); ++id) {
    if (std::count(c.contacts.begin(), c.contacts.end(), id) > 0) continue;
    const oracle::Circle& g = id < 0 ? container : disks[id];
    const oracle::Real x = c.circle.x - g.x, y = c.circle.y - g.y, d = sqrt(x * x + y * y);
    if ((id < 0 ? g.radius - d : d - g.radius) - c.circle.radius <= margin) return false;
  }
  return true;
}

// The opinion of the oracle of 200 digits.
Opinion confirm(const Motion& motion, const Claimed& claimed, Wide t) {
  const auto real = [](Wide x) {
    const Wide a = static_cast<double>(x), b = static_cast<double>(x - a);
    return oracle::Real(static_cast<double>(a)) + static_cast<double>(b) +
           static_cast<double>(x - a - b);
  };
  const SceneData& s = *motion.scene;
  std::vector<oracle::Circle> disks;
  for (std::size_t k = 0; k < motion.paths.size(); ++k) {
    const WideVec p = motion.paths[k].at(t);
    disks.push_back({real(p.x), real(p.y), s.disks[k].radius});
  }
  const std::string at = " at " + std::to_string(static_cast<double>(t));
  try {
    const auto truth = oracle::brute_force_diagram(disks, {s.cx, s.cy, s.radius});
    std::string why;
    if (oracle::agrees(truth, claimed.edges(), &why)) {
      // Which of the diagrams that agree is the one of the format's rule, brute force cannot say.
      return truth.degenerate ? unclear("a tie" + at) : Opinion{};
    }
    const std::set<Corner> corners = claimed.corners();
    bool all_clear = true, missing = false;
    for (const oracle::CotangentClass& c : truth.classes) {
      const bool clear = c.contacts.size() == 3 && is_clear(c, disks, {s.cx, s.cy, s.radius});
      all_clear = all_clear && clear;
      missing |= clear && corners.count({c.contacts[0], c.contacts[1], c.contacts[2]}) == 0;
    }
    if (!missing && !all_clear) return unclear("nearly a tie" + at);
    return wrong("the diagram is wrong" + at + ": " + why);
  } catch (const std::exception& error) {
    return unclear("no diagram" + at + ": " + error.what());
  }
}

// Whether a disk lies inside another or outside the container, as late turns make it for a moment:
// it has no cell then, and histories go on with the edges that it had.
bool one_is_hidden(const Sites& sites) {
  for (std::size_t i = 0; i < sites.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Real sign = tangency(sites[i], sites[j]);
      if (sites[j].container() ? sign > 0 : sign < 0) return true;
    }
  }
  return false;
}

// Judges by empty circles, and by more digits where they say no or are near. The claimed edges need
// not be compared: they were at the start, and flips keep what they say together with the corners.
Opinion look(const Motion& motion, const Claimed& claimed, Wide t, bool edges_too) {
  const Sites sites = motion.sites_at(t);
  if (one_is_hidden(sites)) return {};
  const int n = static_cast<int>(sites.size()) - 1;
  std::vector<Vertex> vertices;
  for (const Corner& g : claimed.corners()) {
    const auto c = tangent_circle(site(sites, g[0]), site(sites, g[1]), site(sites, g[2]));
    if (!c) return confirm(motion, claimed, t);
    const Real margin = 1e-12L * motion.scene->radius;
    for (int id = -1; id < n; ++id) {
      if (id == g[0] || id == g[1] || id == g[2]) continue;
      if (clearance(site(sites, id), *c) < margin) return confirm(motion, claimed, t);
    }
    vertices.push_back({g, *c});
  }
  if (!edges_too) return {};
  const std::vector<Edge> edges = edges_between(vertices, sites);
  const bool same =
      static_cast<int>(edges.size()) == 3 * (n + 1) - 6 &&
      std::all_of(edges.begin(), edges.end(), [&](const Edge& q) { return claimed.has(q); });
  return same ? Opinion{} : confirm(motion, claimed, t);
}

// Whether the edge is legal at t: positive both in-circle functions, negative both, or mixed (0).
int legality(const Motion& motion, const Edge& q, Wide t) {
  const Sites sites = motion.sites_at(t);
  const auto [l, r, s, e] = q;
  const Real a = in_circle(site(sites, l), site(sites, s), site(sites, r), site(sites, e));
  const Real b = in_circle(site(sites, r), site(sites, e), site(sites, l), site(sites, s));
  return a > 0 && b > 0 ? 1 : a < 0 && b < 0 ? -1 : 0;
}

// A claimed flip, alone: does the edge collapse within the tolerance of the claimed time? Diagrams
// are looked at up to `end`. Of flips in company only what is looked at after them shows whether
// all of them are right.
Opinion judge_flip(const Motion& motion, const Line& line, double horizon, double end,
                   bool company) {
  const double lo = std::max(0.0, line.t - tolerance), hi = line.t + tolerance;
  const int before = legality(motion, line.edge, lo), after = legality(motion, line.edge, hi);
  if (before == 1 && after == -1) {
    if (company && hi >= end) return unclear("flips of the same generators before the horizon");
    const bool in_time = hi <= horizon || legality(motion, line.edge, horizon) == -1;
    return in_time ? Opinion{} : unclear("a flip that may be after the horizon");
  }
  if (before == 1 && after == 1 && !company && lo > 0 && hi <= horizon) {
    for (int k = 1; k < 64; ++k) {
      if (legality(motion, line.edge, lo + (hi - lo) * k / 64) != 1) {
        return unclear("a flip that is near");
      }
    }
    return wrong("a flip at " + std::to_string(line.t) + " of an edge that stays legal");
  }
  return unclear("a flip that samples do not show");
}

}  // namespace

Opinion judge_diagrams(const Motion& motion, const History& history, double end,
                       const std::vector<double>& turns, const std::vector<double>& hints) {
  Claimed claimed(history.initial);
  const int generators = motion.scene->size() + 1;
  if (static_cast<int>(claimed.edges().size()) != 3 * generators - 6) {
    return wrong("the first diagram has another number of edges");
  }
  // Where nothing may be looked at: around claimed flips, whose times may be off by the tolerance.
  // A turn changes the motion just where the path does, and no diagram.
  std::vector<std::pair<double, double>> taboo{{0, 0}};
  for (const double t : turns) taboo.emplace_back(t, t);
  for (const Line& line : history.lines) {
    if (line.kind != Line::Kind::flip) continue;
    taboo.emplace_back(line.t - 1.01 * tolerance, line.t + 1.01 * tolerance);
  }
  std::sort(taboo.begin(), taboo.end());
  std::vector<double> samples;
  double a = 0;
  for (std::size_t k = 0; k < taboo.size(); ++k) {
    a = std::max(a, taboo[k].second);
    const double b = std::min(end, k + 1 < taboo.size() ? taboo[k + 1].first : end);
    if (!(a < b)) continue;
    const double near = std::min(0.01 * (b - a), tolerance);
    for (const double t : {a + near, a + 0.25 * (b - a), (a + b) / 2, b - near}) {
      samples.push_back(t);
    }
    for (const double t : hints) {
      if (a < t && t < b) samples.push_back(t);
    }
  }
  std::sort(samples.begin(), samples.end());

  Opinion doubt;
  const auto take = [&](const Opinion& o) {
    if (o.finding == Finding::unclear) doubt = o;
    return o.finding == Finding::wrong;
  };
  // The diagram at 0+, which no tolerance of claims reaches.
  Real speed = 1e-9L;
  for (const Path& path : motion.paths) {
    for (const Piece& piece : path.pieces()) {
      speed = std::max(speed, length({static_cast<Real>(piece.v.x), static_cast<Real>(piece.v.y)}));
    }
  }
  double soon = static_cast<double>(1e-12L * motion.scene->radius / speed);
  for (const double t : turns) {
    if (t > 0) soon = std::min(soon, t / 2);
  }
  const Opinion start = look(motion, claimed, soon, true);
  if (take(start)) return start;
  std::size_t next = 0;
  bool first = true;
  for (std::size_t k = 0; k <= history.lines.size(); ++k) {
    const double until = k < history.lines.size() ? history.lines[k].t : history.horizon;
    for (; next < samples.size() && samples[next] < until; ++next) {
      const Opinion o = look(motion, claimed, samples[next], first);
      if (take(o)) return o;
      first = false;
    }
    if (k == history.lines.size()) break;
    const Line& line = history.lines[k];
    if (line.kind != Line::Kind::flip) continue;
    // Others of the same generators nearby: the edge may be legal again between samples.
    bool company = false;
    for (const Line& other : history.lines) {
      int shared = 0;
      for (const int id : line.edge) shared += concerns(other, id) ? 1 : 0;
      company = company ||
                (&other != &line && shared >= 2 && std::abs(other.t - line.t) <= 3 * tolerance);
    }
    for (const Line& other : history.lines) {
      const bool turns_it = other.kind != Line::Kind::flip &&
                            (concerns(line, other.j) || (other.i >= 0 && concerns(line, other.i)));
      // Whether the order of the file is right then, samples do not say.
      if (turns_it && std::abs(other.t - line.t) <= 2 * tolerance) {
        doubt = unclear("a flip near a turn of its generators");
      }
    }
    if (!claimed.flip(line.edge)) return wrong("a flip of an edge that is not there");
    const Opinion o = judge_flip(motion, line, history.horizon, end, company);
    if (take(o)) return o;
  }
  return doubt;
}

}  // namespace voroproof::internal::adversary
