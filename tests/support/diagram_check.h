// The diagrams of a run, held against tangent circles, brute force and CGAL.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact/generators.h"
#include "exact/topology/diagram.h"
#include "tests/oracle/brute_force.h"
#include "tests/oracle/cgal_apollonius.h"
#include "tests/oracle/motion.h"
#include "tests/oracle/tangent_circles.h"
#include "tests/support/checked_run.h"
#include "tests/support/edge_legality.h"

namespace voroproof::internal::testing {

// The replayed diagram: between events it is the one of the oracles, at events its flips are right.
template <unsigned Digits>
class DiagramCheck {
 public:
  using Run = CheckedRun<Digits>;
  using Number = typename Run::Number;
  using Generators = oracle::Generators;

  explicit DiagramCheck(const Run& given)
      : scene_(given.scene),
        run_(given.run),
        check_(given.check),
        counts_(given.counts),
        motion_scene_(given.motion_scene),
        motion_(given.motion),
        container_(oracle::rounded(given.motion_scene.container)) {}

  void run_all() {
    if (disks() < 2) {
      if (!run_.initial.empty() || run_.count(Event::Kind::flip) != 0 ||
          !run_.final_diagram.empty()) {
        throw Fault("edges with fewer than two disks");
      }
      return;
    }
    if (!std::is_sorted(run_.initial.begin(), run_.initial.end())) throw Fault("unsorted initial");
    edges_ = {run_.initial.begin(), run_.initial.end()};
    Diagram diagram = diagram_of(disks(), run_.initial);
    std::vector<double> gaps{0};
    for (const Event& e : run_.events) {
      if (e.t != gaps.back()) gaps.push_back(e.t);
    }
    const double end = scene_.horizon.get_d();
    const std::size_t pieces = gaps.size();
    gaps.push_back(end);
    const auto chosen = [&](std::size_t k, int wanted) {
      const std::size_t step =
          std::max<std::size_t>(1, pieces / static_cast<std::size_t>(std::max(wanted, 1)));
      return wanted > 0 && k % step == step / 2;
    };

    std::size_t next = 0;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const double t = gaps[piece], gap = gaps[piece + 1] - t;
      const std::size_t first = next;
      while (next < run_.events.size() && run_.events[next].t == t) ++next;
      const bool wide = gap > kNarrow;
      if (next == first + 1 && run_.events[first].kind == Event::Kind::flip && wide && piece > 0 &&
          t - gaps[piece - 1] > kNarrow) {
        check_flip_time(run_.events[first]);
      }
      const bool several = next > first + 1 && wide;
      std::optional<Generators> just_after;
      if (several) just_after = generators_at(number(t) + number(std::min(0.382 * gap, 1e-6)));
      for (std::size_t k = first; k < next; ++k) {
        if (run_.events[k].kind != Event::Kind::flip) continue;
        if (several && check_.one_time_is_one_instant)
          check_flip_order(*just_after, run_.events[k]);
        flip(diagram, run_.events[k]);
      }
      if (!wide) continue;
      const Number between = number(t) + number(0.38196601125010515) * number(gap);
      if (chosen(piece, check_.legality_instants)) check_legality(between);
      if (chosen(piece, check_.brute_force_instants)) check_brute_force(between);
    }
    const std::vector<Quad> replayed(edges_.begin(), edges_.end());
    if (replayed != diagram.quads()) throw Fault("two replays differ");
    if (replayed != run_.final_diagram) throw Fault("the engine ends with another diagram");
  }

 private:
  // Gaps between events below this are too narrow to look into.
  static constexpr double kNarrow = 1e-9;

  int disks() const { return static_cast<int>(scene_.disks.size()); }
  Number number(double x) const { return Number(x); }

  Generators generators_at(const Number& t) const {
    return Generators(motion_.disks_at(t), container_);
  }

  // Twice: in the set of names, by the definition of a flip, and in the half-edges.
  void flip(Diagram& diagram, const Event& e) {
    const Quad q = e.edge;
    if (q != canonical(q)) throw Fault("not the canonical name: " + text(e));
    if (edges_.erase(q) == 0) throw Fault("there is no such edge: " + text(e));
    if (q.s == q.e) throw Fault("this edge cannot flip: " + text(e));
    // The neighbour between a and b with vertex [a, b, old] now has `fresh` there instead.
    const auto change = [&](int a, int b, int old, int fresh) {
      for (auto it = edges_.begin(); it != edges_.end(); ++it) {
        for (Quad w : {*it, reversed(*it)}) {
          if (w.l == a && w.r == b && w.e == old) {
            edges_.erase(it);
            w.e = fresh;
            changed_.push_back(canonical(w));
            return;
          }
        }
      }
      // A neighbour on two sides has been changed on one of them just now.
      for (Quad& c : changed_) {
        for (Quad w : {c, reversed(c)}) {
          if (w.l == a && w.r == b && w.e == old) {
            w.e = fresh;
            c = canonical(w);
            return;
          }
        }
      }
      throw Fault("a neighbour is missing: " + text(e));
    };
    changed_.clear();
    // Vertices [l, s, r] and [l, r, e] become [l, s, e] and [r, e, s].
    change(q.l, q.s, q.r, q.e);
    change(q.s, q.r, q.l, q.e);
    change(q.r, q.e, q.l, q.s);
    change(q.e, q.l, q.r, q.s);
    edges_.insert(changed_.begin(), changed_.end());
    edges_.insert(canonical(flipped(q)));

    Diagram::HalfEdge h = 0;
    while (h < 2 * diagram.edges() && diagram.quad(h) != q) ++h;
    if (h == 2 * diagram.edges()) throw Fault("no half-edge: " + text(e));
    diagram.flip(h);
    std::string why;
    if (!diagram.is_valid(&why)) throw Fault(why + " after " + text(e));
  }

  void check_flip_time(const Event& e) {
    const Number t = number(e.t);
    const Number before = (t + number(std::nextafter(e.t, -kInfinity))) / 2;
    const Number after = (t + number(std::nextafter(e.t, kInfinity))) / 2;
    // A state that changes within the half unit would have to be looked at from both sides.
    const auto sooner = legality(generators_at(before), e.edge);
    const auto later = legality(generators_at(after), e.edge);
    if (!sooner || !later) {
      ++counts_.skipped;
      return;
    }
    if (*sooner < 0) throw Fault("illegal before its time: " + text(e));
    if (*later > 0) throw Fault("still legal at its time: " + text(e));
    ++counts_.flip_times;
  }

  void check_flip_order(const Generators& just_after, const Event& e) {
    for (const Quad& q : edges_) {
      const auto legal = is_legal(just_after, q);
      if (!legal) {
        ++counts_.skipped;
        return;
      }
      if (!*legal && has_shrunk(just_after, q)) {
        if (q == e.edge) return;
        throw Fault(text(e) + ", but " + text(q) + " comes first");
      }
    }
    throw Fault("a flip of a legal edge: " + text(e));
  }

  void check_legality(const Number& t) {
    const Generators at = generators_at(t);
    for (const Quad& q : edges_) {
      const auto legal = is_legal(at, q);
      if (!legal) {
        try {
          at.check_disjoint();
        } catch (const std::invalid_argument&) {
          ++counts_.skipped;  // a point touches something
          return;
        }
        throw Fault("the edge " + text(q) + " has no vertices at t = " + t.str(25));
      }
      if (!*legal) throw Fault("the edge " + text(q) + " is illegal at t = " + t.str(25));
    }
    ++counts_.legality;
  }

  void check_brute_force(const Number& t) {
    const std::vector<oracle::Circle> disks = motion_.disks_at(t);
    oracle::BruteDiagram truth;
    try {
      truth = oracle::brute_force_diagram(disks, container_);
    } catch (const std::invalid_argument&) {
      ++counts_.skipped;
      return;
    }
    const std::vector<Quad> now(edges_.begin(), edges_.end());
    std::string why;
    if (!oracle::agrees(truth, quadruples(now), &why)) {
      throw Fault("at t = " + t.str(25) + " by brute force: " + why);
    }
    ++counts_.brute_force;
    if (!truth.degenerate) check_cgal(disks, now, t);
  }

  // Whether a line touches all three, or nearly so, each from the same side: a unit vector with
  // the same products with both offsets as the radii differ by.
  bool have_common_tangent(const oracle::ExactCircle& a, const oracle::ExactCircle& b,
                           const oracle::ExactCircle& c) const {
    const Rational ux = b.x - a.x, uy = b.y - a.y, wx = c.x - a.x, wy = c.y - a.y;
    const Rational u = b.radius - a.radius, w = c.radius - a.radius;
    const Rational x = u * wy - w * uy, y = w * ux - u * wx, det = ux * wy - uy * wx;
    const Rational size = scene_.container_radius * scene_.container_radius;
    return abs(Rational(x * x + y * y - det * det)) <= 1e-40 * size * size;
  }

  // With centres rounded to 200 bits, where nothing touches or is cotangent, and no three have a
  // circle that the rounding could turn inside out.
  void check_cgal(const std::vector<oracle::Circle>& disks, const std::vector<Quad>& now,
                  const Number& t) {
    std::vector<oracle::ExactCircle> exact;
    for (std::size_t i = 0; i < disks.size(); ++i) {
      exact.push_back({dyadic(disks[i].x), dyadic(disks[i].y), scene_.disks[i].radius});
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Rational dx = exact[i].x - exact[j].x, dy = exact[i].y - exact[j].y;
        const Rational reach = exact[i].radius + exact[j].radius;
        if (dx * dx + dy * dy <= reach * reach) return;
      }
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          if (have_common_tangent(exact[i], exact[j], exact[k])) return;
        }
      }
    }
    std::string why;
    if (!oracle::agrees_with_cgal(exact, motion_scene_.container, quadruples(now), &why)) {
      throw Fault("at t = " + t.str(25) + " by CGAL: " + why);
    }
    ++counts_.cgal;
  }

  static Rational dyadic(const oracle::Real& x) {
    mpf_class shortened(0, 256);
    mpfr_get_f(shortened.get_mpf_t(), x.backend().data(), MPFR_RNDN);
    return Rational(shortened);
  }

  const Scene& scene_;
  const RecordedRun& run_;
  const HistoryCheck& check_;
  CheckCounts& counts_;
  const oracle::MotionScene& motion_scene_;
  const typename Run::Motion& motion_;
  oracle::Circle container_;
  std::set<Quad> edges_;
  std::vector<Quad> changed_;
};

}  // namespace voroproof::internal::testing
