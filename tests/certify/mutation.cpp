#include "tests/certify/mutation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/predicates.h"
#include "exact/topology/diagram.h"
#include "tests/support/compact_arithmetic.h"

namespace voroproof::internal::testing {

namespace {

using Claims = std::vector<voroproof::internal::Event>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double& time_of(voroproof::internal::Event& e) {
  return std::visit([](auto& x) -> double& { return x.t; }, e);
}

template <class T>
std::vector<std::size_t> places(const Claims& events) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < events.size(); ++k) {
    if (std::holds_alternative<T>(events[k])) out.push_back(k);
  }
  return out;
}

std::optional<std::size_t> any(const std::vector<std::size_t>& from, Random& random) {
  if (from.empty()) return std::nullopt;
  return from[random() % from.size()];
}

// Events in order of time, ties as they were.
void sort(Claims& events) {
  std::stable_sort(events.begin(), events.end(),
                   [](const auto& a, const auto& b) { return time(a) < time(b); });
}

Diagram::HalfEdge find(const Diagram& d, const Quad& q) {
  for (Diagram::HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    if (d.quad(h) == q) return h;
  }
  return -1;
}

// The diagram before event k.
Diagram replayed(const Scene& scene, const ClaimedHistory& h, std::size_t k) {
  Diagram d = diagram_of(static_cast<int>(scene.disks.size()), *h.header.initial);
  for (std::size_t i = 0; i < k; ++i) {
    if (const auto* f = std::get_if<FlipEvent>(&h.events[i])) d.flip(find(d, f->quad));
  }
  return d;
}

// A time strictly between event k - 1 and event k (or the ends), and the index k.
std::optional<std::pair<std::size_t, double>> gap(const Scene& scene, const Claims& events,
                                                  Random& random) {
  const std::size_t k = random() % (events.size() + 1);
  const double a = k == 0 ? 0 : time(events[k - 1]);
  const double b = k == events.size() ? scene.horizon.get_d() : time(events[k]);
  if (!(b - a > 1e-3)) return std::nullopt;
  return std::pair(k, a + (b - a) * uniform(random, 0.3, 0.7));
}

std::optional<Quad> some_edge(const Diagram& d, Random& random) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    const auto h = static_cast<Diagram::HalfEdge>(random() % (2 * d.edges()));
    const Quad q = d.quad(h);
    if (q.s != q.e) return q;
  }
  return std::nullopt;
}

// Where generator g was last known before event k, and how it moves since.
struct Path {
  double t = 0;
  Vec2 p{}, v{};
};
Path path(const Scene& scene, const Claims& events, std::size_t k, GenId g) {
  const DiskInput& d = scene.disks[g];
  Path out{0, {round_nearest(d.x), round_nearest(d.y)}, {round_nearest(d.vx), round_nearest(d.vy)}};
  for (std::size_t i = 0; i < k; ++i) {
    if (const auto* c = std::get_if<CollideEvent>(&events[i])) {
      if (c->i == g) out = {c->t, *c->p[0], *c->v[0]};
      if (c->j == g) out = {c->t, *c->p[1], *c->v[1]};
    } else if (const auto* m = std::get_if<ManeuverEvent>(&events[i]); m && m->disk == g) {
      out = {m->t, *m->p, *m->v};
    }
  }
  return out;
}

// The cotangency of the four generators of q at time t, before event k.
double cotangency_at(const Scene& scene, const Claims& events, std::size_t k, const Quad& q,
                     double t) {
  const auto site = [&](GenId g) -> Site<double> {
    if (g == container_id) {
      return {scene.cx.get_d(), scene.cy.get_d(), -scene.container_radius.get_d()};
    }
    const Path at = path(scene, events, k, g);
    return {at.p[0] + at.v[0] * (t - at.t), at.p[1] + at.v[1] * (t - at.t),
            round_nearest(scene.disks[g].radius)};
  };
  return cotangency(site(q.l), site(q.r), site(q.s), site(q.e));
}

bool near_enough(const Vec2& a, const Vec2& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]) <=
         1e-3 * (std::hypot(a[0], a[1]) + std::hypot(b[0], b[1]));
}

}  // namespace

std::optional<ClaimedHistory> mutate(const Scene& scene, const ClaimedHistory& right, Mutation kind,
                                     double tolerance, double slack, Random& random) {
  ClaimedHistory h = right;
  Claims& events = h.events;
  const auto flip_at = [&](std::size_t k) -> FlipEvent& { return std::get<FlipEvent>(events[k]); };
  const auto hit_at = [&](std::size_t k) -> CollideEvent& {
    return std::get<CollideEvent>(events[k]);
  };
  const auto flips = places<FlipEvent>(events);
  const auto hits = places<CollideEvent>(events);
  const auto maneuvers = places<ManeuverEvent>(events);
  const GenId n = static_cast<GenId>(scene.disks.size());
  const auto erase = [&](std::size_t k) {
    events.erase(events.begin() + static_cast<std::ptrdiff_t>(k));
  };
  const auto insert = [&](std::size_t k, voroproof::internal::Event e) {
    events.insert(events.begin() + static_cast<std::ptrdiff_t>(k), std::move(e));
  };
  switch (kind) {
    case Mutation::time_beyond_tolerance: {
      if (events.empty()) return std::nullopt;
      const std::size_t k = random() % events.size();
      double& t = time_of(events[k]);
      // The time is moved beyond the rounding of this sum, too.
      const bool later = random() % 2 == 0;
      double moved = later ? t + (tolerance + slack) : t - (tolerance + slack);
      for (int u = 0; u < 2; ++u) moved = std::nextafter(moved, later ? kInfinity : -kInfinity);
      if (moved < 0 || moved > scene.horizon.get_d()) return std::nullopt;
      t = moved;
      sort(events);
      break;
    }
    case Mutation::swapped_neighbours: {
      if (events.size() < 2) return std::nullopt;
      const std::size_t k = random() % (events.size() - 1);
      if (!(time(events[k + 1]) - time(events[k]) > tolerance * (1 + 1e-9))) return std::nullopt;
      std::swap(time_of(events[k]), time_of(events[k + 1]));
      std::swap(events[k], events[k + 1]);
      break;
    }
    case Mutation::dropped_flip: {
      const auto k = any(flips, random);
      if (!k) return std::nullopt;
      erase(*k);
      break;
    }
    case Mutation::duplicated_flip: {
      const auto k = any(flips, random);
      if (!k) return std::nullopt;
      insert(*k, events[*k]);
      break;
    }
    case Mutation::inserted_flip:
    case Mutation::flip_and_its_reversal: {
      const auto place = gap(scene, events, random);
      if (!place || n < 2) return std::nullopt;
      const auto q = some_edge(replayed(scene, h, place->first), random);
      if (!q) return std::nullopt;
      if (kind == Mutation::flip_and_its_reversal) {
        insert(place->first, FlipEvent{place->second, canonical(flipped(*q)), {}});
      }
      insert(place->first, FlipEvent{place->second, canonical(*q), {}});
      break;
    }
    case Mutation::shadow_flip_as_real: {
      // A root of the cotangency between two events, where the edge does not flip.
      if (n < 2 || events.empty()) return std::nullopt;
      for (int attempt = 0; attempt < 30; ++attempt) {
        const std::size_t k = random() % (events.size() + 1);
        double a = k == 0 ? 0 : time(events[k - 1]);
        double b = k == events.size() ? scene.horizon.get_d() : time(events[k]);
        const double margin = 10 * tolerance;
        a += margin;
        b -= margin;
        const auto q = some_edge(replayed(scene, h, k), random);
        if (!(a < b) || !q) continue;
        const auto value = [&](double t) { return cotangency_at(scene, events, k, *q, t); };
        const bool sign = value(a) > 0;
        if (sign == (value(b) > 0)) continue;
        while (true) {
          const double middle = 0.5 * (a + b);
          if (!(a < middle && middle < b)) break;
          (value(middle) > 0) == sign ? a = middle : b = middle;
        }
        insert(k, FlipEvent{b, canonical(*q), {}});
        h.count();
        return h;
      }
      return std::nullopt;
    }
    case Mutation::wrong_quadruple: {
      const auto k = any(flips, random);
      if (!k) return std::nullopt;
      Quad& q = flip_at(*k).quad;
      const GenId g = static_cast<GenId>(random() % static_cast<std::uint64_t>(n + 1)) - 1;
      GenId* slot[4] = {&q.l, &q.r, &q.s, &q.e};
      GenId& old = *slot[random() % 4];
      if (old == g) return std::nullopt;
      old = g;
      if (!names_an_edge(q)) return std::nullopt;
      q = canonical(q);
      break;
    }
    case Mutation::rotated_quadruple: {
      const auto k = any(flips, random);
      if (!k) return std::nullopt;
      Quad& q = flip_at(*k).quad;
      q = canonical(random() % 2 == 0 ? Quad{q.s, q.e, q.r, q.l} : Quad{q.s, q.e, q.l, q.r});
      if (!names_an_edge(q)) return std::nullopt;
      break;
    }
    case Mutation::mirrored_quadruple: {
      const auto k = any(flips, random);
      if (!k) return std::nullopt;
      Quad& q = flip_at(*k).quad;
      q = canonical(Quad{q.l, q.r, q.e, q.s});
      break;
    }
    case Mutation::same_four_generators: {
      const auto k = any(flips, random);
      if (!k) return std::nullopt;
      const Quad q = flip_at(*k).quad;
      const Diagram d = replayed(scene, h, *k);
      std::array<GenId, 4> four{q.l, q.r, q.s, q.e};
      std::sort(four.begin(), four.end());
      for (Diagram::HalfEdge e = 0; e < 2 * d.edges(); e += 2) {
        const Quad other = d.quad(e);
        std::array<GenId, 4> o{other.l, other.r, other.s, other.e};
        std::sort(o.begin(), o.end());
        if (o != four || canonical(other) == canonical(q)) continue;
        flip_at(*k).quad = canonical(other);
        return h;
      }
      return std::nullopt;
    }
    case Mutation::dropped_flip_and_return: {
      // A flip that is undone while nothing else touches the edge.
      for (const std::size_t k : flips) {
        const Quad back = canonical(flipped(flip_at(k).quad));
        for (std::size_t m = k + 1; m < events.size(); ++m) {
          if (const auto* f = std::get_if<FlipEvent>(&events[m]); f != nullptr && f->quad == back) {
            if (random() % 3 != 0) break;
            erase(m);
            erase(k);
            h.count();
            return h;
          }
        }
      }
      return std::nullopt;
    }
    case Mutation::missed_three_to_two: {
      std::vector<std::size_t> candidates;
      for (const std::size_t k : flips) {
        const Quad q = flip_at(k).quad;
        const Diagram d = replayed(scene, h, k);
        for (const GenId g : {q.l, q.r}) {
          int degree = 0;
          for (Diagram::HalfEdge e = 0; e < 2 * d.edges(); ++e) degree += d.org(e) == g;
          if (degree == 3) candidates.push_back(k);
        }
      }
      const auto k = any(candidates, random);
      if (!k) return std::nullopt;
      erase(*k);
      break;
    }
    case Mutation::dropped_collision: {
      const auto k = any(hits, random);
      if (!k) return std::nullopt;
      erase(*k);
      break;
    }
    case Mutation::inserted_collision: {
      const auto place = gap(scene, events, random);
      if (!place || n < 2) return std::nullopt;
      // The velocities are left unchanged, so that nothing else becomes wrong.
      const auto q = some_edge(replayed(scene, h, place->first), random);
      if (!q) return std::nullopt;
      CollideEvent c{.t = place->second, .i = std::min(q->l, q->r), .j = std::max(q->l, q->r)};
      const auto velocity = [&](GenId g) { return path(scene, events, place->first, g).v; };
      if (c.i != container_id) c.v[0] = velocity(c.i);
      c.v[1] = velocity(c.j);
      insert(place->first, c);
      break;
    }
    case Mutation::wrong_pair: {
      const auto k = any(hits, random);
      if (!k) return std::nullopt;
      CollideEvent& c = hit_at(*k);
      const GenId g = static_cast<GenId>(random() % static_cast<std::uint64_t>(n));
      if (g == c.i || g == c.j || (c.i != container_id && g < c.i)) return std::nullopt;
      c.j = g;
      break;
    }
    case Mutation::velocity_off: {
      const auto k = any(hits, random);
      if (!k) return std::nullopt;
      CollideEvent& c = hit_at(*k);
      Vec2& v = *c.v[c.i == container_id ? 1 : random() % 2];
      if (std::hypot(v[0], v[1]) < 0.1) return std::nullopt;
      for (double& x : v) x *= 1 + 1e-6;
      break;
    }
    case Mutation::energy_preserving_response: {
      const auto k = any(hits, random);
      if (!k) return std::nullopt;
      CollideEvent& c = hit_at(*k);
      const double angle = uniform(random, 1e-6, 1) * (random() % 2 == 0 ? 1 : -1);
      for (auto& v : c.v) {
        if (v)
          *v = {std::cos(angle) * (*v)[0] - std::sin(angle) * (*v)[1],
                std::sin(angle) * (*v)[0] + std::cos(angle) * (*v)[1]};
      }
      const Vec2& v = *c.v[1];
      if (std::hypot(v[0], v[1]) < 0.1) return std::nullopt;
      break;
    }
    case Mutation::exchanged_velocities: {
      const auto k = any(hits, random);
      if (!k || hit_at(*k).i == container_id) return std::nullopt;
      CollideEvent& c = hit_at(*k);
      if (near_enough(*c.v[0], *c.v[1])) return std::nullopt;
      std::swap(c.v[0], c.v[1]);
      break;
    }
    case Mutation::center_off: {
      const auto k = any(hits, random);
      if (!k) return std::nullopt;
      (*hit_at(*k).p[1])[random() % 2] += 1e-5 * scene.container_radius.get_d();
      break;
    }
    case Mutation::wrong_initial_diagram: {
      if (n < 2) return std::nullopt;
      Diagram d = diagram_of(n, *h.header.initial);
      const auto q = some_edge(d, random);
      if (!q) return std::nullopt;
      d.flip(find(d, *q));
      h.header.initial = d.quads();
      break;
    }
    case Mutation::dropped_tail: {
      if (events.size() < 2) return std::nullopt;
      events.resize(1 + random() % (events.size() - 1));
      break;
    }
    case Mutation::wrong_counts: {
      std::int64_t* counts[3] = {&h.claimed_counts.flips, &h.claimed_counts.collisions,
                                 &h.claimed_counts.maneuvers};
      ++*counts[random() % 3];
      return h;
    }
    case Mutation::dropped_maneuver: {
      const auto k = any(maneuvers, random);
      if (!k) return std::nullopt;
      erase(*k);
      break;
    }
    case Mutation::changed_maneuver: {
      const auto k = any(maneuvers, random);
      if (!k) return std::nullopt;
      Vec2& v = *std::get<ManeuverEvent>(events[*k]).v;
      if (std::hypot(v[0], v[1]) < 0.1) return std::nullopt;
      for (double& x : v) x *= 1 + 1e-6;
      break;
    }
    case Mutation::count:
      return std::nullopt;
  }
  h.count();
  return h;
}

}  // namespace voroproof::internal::testing
