#include "tests/world/sampled_history.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "tests/world/edge_set.h"

namespace voroproof::internal::testing {

namespace {

template <class Item>
std::vector<Item> only_in(const std::vector<Item>& a, const std::vector<Item>& b) {
  std::vector<Item> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest;
}
std::vector<GenId> only_in(const std::set<GenId>& a, const std::set<GenId>& b) {
  return only_in(std::vector(a.begin(), a.end()), std::vector(b.begin(), b.end()));
}

bool is_swap(const BruteDiagram& a, const BruteDiagram& b, GenId i, GenId j) {
  const auto other = [&](GenId g) { return g == i ? j : g == j ? i : g; };
  std::vector<Quad> edges;
  for (const Quad& q : a.edges) {
    edges.push_back(canonical(Quad{other(q.l), other(q.r), other(q.s), other(q.e)}));
  }
  std::sort(edges.begin(), edges.end());
  std::set<GenId> visible;
  for (const GenId g : a.visible) visible.insert(other(g));
  return edges == b.edges && visible == b.visible;
}

std::optional<Change> change_of_edges(const BruteDiagram& a, const BruteDiagram& b) {
  const std::vector<Quad> out = only_in(a.edges, b.edges), in = only_in(b.edges, a.edges);
  if (out.size() == 5 && in.size() == 5) {
    for (const Quad& q : out) {
      const Quad after = canonical(flipped(q));
      if (std::find(in.begin(), in.end(), after) != in.end()) return q;
    }
  }
  for (const GenId i : a.visible) {
    for (const GenId j : a.visible) {
      if (i < j && is_swap(a, b, i, j)) return Swap{i, j};
    }
  }
  return std::nullopt;
}

std::optional<Change> change_by_appear(const BruteDiagram& a, const BruteDiagram& b, GenId g) {
  const GenId j = a.host.contains(g) ? a.host.at(g) : container_id;
  if (a.visible.size() < 2) return Appear{g, j, std::nullopt};
  const std::vector<Quad> out = only_in(a.edges, b.edges);
  if (out.size() != 1 || only_in(b.edges, a.edges).size() != 4) return std::nullopt;
  const Quad q = out.front();
  if (q.l == j) return Appear{g, j, q};
  if (q.r == j) return Appear{g, j, reversed(q)};
  return std::nullopt;
}

// The world as it rests at t, without the disk g.
World resting_without(const World& world, GenId g, const Rational& t) {
  World rest;
  if (world.circle) {
    rest.circle = world.circle;
    rest.circle->radius += world.circle->growth * t;
    rest.circle->growth = 0;
  }
  for (GenId k = 0; k < static_cast<GenId>(world.disks.size()); ++k) {
    GrowingDisk s = state_at(world, k, t);
    s.vx = s.vy = s.growth = 0;
    // One that is not there comes long after all is done.
    const bool there = k != g && is_present(world, k, t);
    rest.disks.push_back({there ? Rational(0) : Rational(Integer(1) << 200), {}, s});
  }
  return rest;
}

class Sampler {
 public:
  Sampler(const World& world, int samples) : world_(world), samples_(samples) {}

  SampledHistory history() {
    std::set<Rational> cuts{0, world_.horizon};
    for (const auto& [t, g] : scheduled()) cuts.insert(t);
    for (auto from = cuts.begin(); std::next(from) != cuts.end(); ++from) {
      look_between(*from, *std::next(from));
      schedule(*std::next(from));
    }
    return out_;
  }

  // Changes from one time on until another, both excluded.
  void look_between(const Rational& from, const Rational& to) {
    std::vector<Rational> times{odd_time_between(from, to, 1 << 10)};
    for (int k = 1; k < samples_; ++k)
      times.push_back(odd_time_between(from, to, way / samples_ * k));
    times.push_back(odd_time_between(from, to, way - 1000));
    BruteDiagram last = brute_diagram(world_, times.front());
    if (out_.events.empty() && out_.initial.empty()) out_.initial = last.edges;
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      BruteDiagram next = brute_diagram(world_, times[k + 1]);
      look(times[k], last, times[k + 1], next, 0);
      last = std::move(next);
    }
  }

  SampledHistory out_;

 private:
  std::set<std::pair<Rational, GenId>> scheduled() const {
    std::set<std::pair<Rational, GenId>> all;
    const auto add = [&](const Rational& t, GenId g) {
      if (0 < t && t <= world_.horizon) all.emplace(t, g);
    };
    for (GenId g = 0; g < static_cast<GenId>(world_.disks.size()); ++g) {
      add(world_.disks[g].enter, g);
      if (world_.disks[g].leave) add(*world_.disks[g].leave, g);
    }
    for (const WorldManeuver& m : world_.maneuvers) add(m.t, m.disk);
    return all;
  }

  void look(const Rational& from, const BruteDiagram& a, const Rational& to, const BruteDiagram& b,
            int depth) {
    if (a.edges == b.edges && a.visible == b.visible) return;
    const double t = round_nearest(from);
    if (t == round_nearest(to)) {
      const std::vector<Change> changes = changes_of(a, b, from);
      for (const Change& change : changes) {
        out_.events.push_back({to_rational(t), {}});
        std::visit([&](const auto& what) { out_.events.back().what = what; }, change);
      }
      if (!changes.empty()) return;
    }
    if (depth > 100) {
      out_.why_not = "several changes at " + std::to_string(t);
      return;
    }
    const Rational middle = (from + to) / 2;  // as odd as they are
    const BruteDiagram between = brute_diagram(world_, middle);
    look(from, a, middle, between, depth + 1);
    look(middle, between, to, b, depth + 1);
  }

  // One change, or two flips: three disks of one radius that are alone in the plane come to be on
  // one line, and nobody changes places.
  std::vector<Change> changes_of(const BruteDiagram& a, const BruteDiagram& b, const Rational& t) {
    const auto change = single_change(a, b);
    if (!change) return {};
    const auto* swap = std::get_if<Swap>(&*change);
    if (swap == nullptr || is_near(swap->i, swap->j, t)) return {*change};
    for (const Quad& q : a.edges) {
      EdgeSet once(a.edges);
      if (q.s == q.e) continue;
      once.flip(q);
      for (const Quad& r : once.edges()) {
        EdgeSet twice = once;
        if (r.s == r.e) continue;
        twice.flip(r);
        if (twice.edges() == b.edges) return {q, r};
      }
    }
    return {};
  }

  // Whether the two are at one place, but for what they move in a part of the time.
  bool is_near(GenId i, GenId j, const Rational& t) const {
    const GrowingDisk p = state_at(world_, i, t), q = state_at(world_, j, t);
    const Rational way = world_.horizon * (abs(p.vx - q.vx) + abs(p.vy - q.vy)) / (1 << 20);
    return abs(p.x - q.x) + abs(p.y - q.y) <= way;
  }

  // The turn or jump at t.
  void schedule(const Rational& t) {
    for (const auto& [when, g] : scheduled()) {
      if (when != t) continue;
      const Rational rounded = to_rational(round_nearest(t));
      const WorldDisk& disk = world_.disks[g];
      const auto m = std::find_if(world_.maneuvers.begin(), world_.maneuvers.end(),
                                  [&, g = g](const auto& x) { return x.t == t && x.disk == g; });
      if (m != world_.maneuvers.end() && !m->is_jump()) {
        out_.events.push_back({rounded, PathTurn{g, m->velocity, std::nullopt, m->growth}});
        continue;
      }
      Jump jump{g, {}, {}, {}, {}, {}};
      // The state before, with nothing else in between.
      const Rational before = odd_time_between(t, 0, 1);
      if (disk.enter < t) jump.out = run_of_radius(g, before, true);
      if (!disk.leave || t < *disk.leave) jump.in = run_of_radius(g, t, false);
      out_.events.push_back({rounded, jump});
    }
  }

  // The steps while the radius of g falls from its value at t, or rises to it.
  std::vector<Step> run_of_radius(GenId g, const Rational& t, bool falls) {
    World rest = resting_without(world_, g, t);
    const BruteDiagram others = brute_diagram(rest, 0);
    GrowingDisk state = state_at(world_, g, t);
    state.vx = state.vy = 0;
    double least = 1e300;
    const auto distance = [&](const Rational& x, const Rational& y) {
      return std::hypot(Rational(x - state.x).get_d(), Rational(y - state.y).get_d());
    };
    for (const GenId h : others.visible) {
      const GrowingDisk& d = rest.disks[h].state;
      least = std::min(least, distance(d.x, d.y) - d.radius.get_d());
    }
    if (rest.circle) {
      const WorldCircle& c = *rest.circle;
      least = std::min(least, c.radius.get_d() - distance(c.center.x, c.center.y));
    }
    if (least == 1e300) {
      if (falls) return {Hide{g, container_id}};
      return {Appear{g, container_id, std::nullopt}};
    }
    // Just hidden where the radius is -least.
    const Rational way_down = state.radius + to_rational(least + std::fabs(least) * 1e-9);
    if (way_down <= 0) return {};
    state.growth = falls ? -1 : 1;
    if (!falls) state.radius -= way_down;
    rest.disks[g] = {0, {}, state};
    rest.horizon = way_down;
    Sampler inner(rest, samples_);
    inner.look_between(0, way_down);
    if (!inner.out_.why_not.empty()) out_.why_not = inner.out_.why_not;
    std::vector<Step> steps;
    for (const WorldEvent& event : inner.out_.events) {
      if (const auto* q = std::get_if<Quad>(&event.what)) steps.push_back(*q);
      if (const auto* h = std::get_if<Hide>(&event.what)) steps.push_back(*h);
      if (const auto* a = std::get_if<Appear>(&event.what)) steps.push_back(*a);
    }
    return steps;
  }

  const World& world_;
  int samples_;
};

}  // namespace

std::optional<Change> single_change(const BruteDiagram& a, const BruteDiagram& b) {
  const std::vector<GenId> out = only_in(a.visible, b.visible), in = only_in(b.visible, a.visible);
  if (out.empty() && in.empty()) return change_of_edges(a, b);
  if (out.size() == 1 && in.empty()) {
    const bool lone = a.visible.size() <= 2;
    const bool pair =
        only_in(a.edges, b.edges).size() == 4 && only_in(b.edges, a.edges).size() == 1;
    const GenId g = out.front();
    if (!lone && !pair) return std::nullopt;
    return Hide{g, b.host.contains(g) ? b.host.at(g) : container_id};
  }
  if (in.size() == 1 && out.empty()) return change_by_appear(a, b, in.front());
  if (in.size() != 1 || out.size() != 1) return std::nullopt;
  const auto [i, j] = std::minmax(in.front(), out.front());
  if (is_swap(a, b, i, j)) return Swap{i, j};
  return std::nullopt;
}

SampledHistory sampled_history(const World& world, int samples) {
  return Sampler(world, samples).history();
}

}  // namespace voroproof::internal::testing
