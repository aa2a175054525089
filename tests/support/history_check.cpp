#include "tests/support/history_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "tests/oracle/cgal_apollonius.h"
#include "tests/oracle/tangent_circles.h"

namespace voroproof::internal::testing {
namespace {

using oracle::Generators;
using oracle::TangentCircle;
using oracle::Work;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Gaps between events below this are too narrow to look into.
constexpr double kNarrow = 1e-9;

// Found by a check; the message is the fault.
struct Fault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// ---- Is an edge legal at one instant? By tangent circles, not by predicates. ----

std::optional<TangentCircle> counterclockwise_circle(const Generators& at, int i, int j, int k) {
  for (const TangentCircle& circle : at.tangent_circles(i, j, k)) {
    if (at.counterclockwise(i, j, k, circle)) return circle;
  }
  return std::nullopt;
}

// Positive: e is outside the circle of the edge's start vertex and s outside that of its end
// vertex. Zero: the four are cotangent. nullopt: the circles do not exist, or do not agree.
std::optional<int> legality(const Generators& at, const Quad& q) {
  const auto side = [&at](int i, int j, int k, int tested) -> std::optional<int> {
    const auto circle = counterclockwise_circle(at, i, j, k);
    if (!circle) return std::nullopt;
    const Work gap = at.gap(tested, *circle);
    if (abs(gap) < oracle::contact_tolerance()) return 0;
    return gap > 0 ? 1 : -1;
  };
  const auto start = side(q.l, q.s, q.r, q.e), end = side(q.r, q.e, q.l, q.s);
  // An edge between two circles, of which one touches all four generators and the other does not.
  if (start && end && *start + *end == 1) return 1;
  // Or both do, and the edge leads from the one to the other.
  if (start && end && *start == 0 && *end == 0) {
    const auto a = counterclockwise_circle(at, q.l, q.s, q.r);
    const auto b = counterclockwise_circle(at, q.r, q.e, q.l);
    if (!oracle::coincide(*a, *b)) return 1;
  }
  return start == end ? start : std::nullopt;
}

// Whether q stays at an instant at which nothing happens: cotangent then means for ever.
std::optional<bool> is_legal(const Generators& at, const Quad& q) {
  if (q.s == q.e) return true;
  const auto sign = legality(at, q);
  if (!sign) return std::nullopt;
  return *sign == 0 ? std::max(q.l, q.r) > std::max(q.s, q.e) : *sign > 0;
}

// Whether an edge that is illegal just after an instant has shrunk to a point at it: two circles
// may touch the same four generators, and an edge lead from the one to the other. Then e touches
// the start circle elsewhere than between r and l.
bool has_shrunk(const Generators& just_after, const Quad& q) {
  const auto start = counterclockwise_circle(just_after, q.l, q.s, q.r);
  return start && just_after.counterclockwise(q.r, q.e, q.l, *start);
}

// ---- The motion. ----

bool is_motion(const Event& e) { return e.kind != Event::Kind::flip; }

template <unsigned Digits>
class Checker {
 public:
  using Motion = oracle::BasicMotionOracle<Digits>;
  using Number = typename Motion::Number;

  Checker(const Scene& scene, const RecordedRun& run, const HistoryCheck& check,
          CheckCounts& counts)
      : scene_(scene),
        run_(run),
        check_(check),
        counts_(counts),
        motion_scene_(oracle_scene(scene)),
        records_(motion_records(scene, run)),
        motion_(motion_scene_, records_),
        container_(oracle::rounded(motion_scene_.container)),
        horizon_(oracle::rounded<Number>(scene.horizon)) {}

  void run_all() {
    check_frame();
    check_states();
    check_motion_order();
    check_diagrams();
  }

 private:
  int disks() const { return static_cast<int>(scene_.disks.size()); }
  Number number(double x) const { return Number(x); }

  // Whether the nearest double of some number within `slack` of `value` is `claimed`.
  bool rounds_to(const Number& value, double claimed, const Number& slack) const {
    if (claimed == 0 && std::signbit(claimed)) return false;
    const Number low = (Number(claimed) + Number(std::nextafter(claimed, -kInfinity))) / 2;
    const Number high = (Number(claimed) + Number(std::nextafter(claimed, kInfinity))) / 2;
    return low - slack <= value && value <= high + slack;
  }

  std::vector<oracle::MotionRecord> first_records(std::size_t k) const {
    return {records_.begin(), records_.begin() + static_cast<long>(k)};
  }
  std::vector<Event>::const_iterator next_event(const Event& e) const {
    return run_.events.begin() + (&e - run_.events.data()) + 1;
  }
  std::vector<Event>::const_iterator end_of_instant(const Event& e) const {
    return std::find_if(next_event(e), run_.events.end(),
                        [&e](const Event& f) { return f.t != e.t; });
  }

  void check_frame() const {
    if (!run_.complete()) throw Fault("stopped: " + run_.outcome.reason);
    if (run_.begins != 1) throw Fault("begin was called " + std::to_string(run_.begins) + " times");
    double t = 0;
    const double end = scene_.horizon.get_d() * (1 + 1e-15);
    for (const Event& e : run_.events) {
      if (!(e.t >= t && e.t <= end)) throw Fault("out of order or beyond the horizon: " + text(e));
      t = e.t;
    }
    // Every maneuver up to the horizon took place.
    const auto due = std::count_if(scene_.maneuvers.begin(), scene_.maneuvers.end(),
                                   [&](const Maneuver& m) { return m.t <= scene_.horizon; });
    if (static_cast<std::size_t>(due) != run_.count(Event::Kind::maneuver)) {
      throw Fault("wrong number of maneuvers");
    }
  }

  void check_states() const {
    const Number tiny = pow(Number(10), -60);
    Number scale = abs(oracle::rounded<Number>(scene_.container_radius)) +
                   abs(oracle::rounded<Number>(scene_.cx)) +
                   abs(oracle::rounded<Number>(scene_.cy)) + 1;
    std::size_t k = 0;
    for (const Event& e : run_.events) {
      if (!is_motion(e)) continue;
      const Number& t = motion_.times()[k++];
      if (!rounds_to(t, e.t, tiny * (1 + abs(t)))) {
        throw Fault(text(e) + ", but the time is " + t.str(25));
      }
      const auto check_state = [&](int id, const RoundedState& s, const auto& velocity) {
        const auto p = motion_.position(id, t);
        if (!rounds_to(p[0], s.px, tiny * scale) || !rounds_to(p[1], s.py, tiny * scale)) {
          throw Fault(text(e) + ", but the place of " + std::to_string(id) + " is (" +
                      p[0].str(25) + ", " + p[1].str(25) + ")");
        }
        const Number speed = abs(velocity[0]) + abs(velocity[1]) + 1;
        if (!rounds_to(velocity[0], s.vx, tiny * speed) ||
            !rounds_to(velocity[1], s.vy, tiny * speed)) {
          throw Fault(text(e) + ", but the velocity of " + std::to_string(id) + " is (" +
                      velocity[0].str(25) + ", " + velocity[1].str(25) + ")");
        }
      };
      // Where the disk has further events at this instant, only the records so far count.
      std::optional<Motion> prefix;
      const auto velocity = [&](int id) {
        const bool again = std::any_of(next_event(e), end_of_instant(e), [&](const Event& f) {
          return is_motion(f) && (f.i == id || f.j == id);
        });
        if (!again) return motion_.velocity(id, t + pow(Number(10), -150));
        if (!prefix) prefix.emplace(motion_scene_, first_records(k));
        return prefix->velocity(id, t + 1);
      };
      if (e.i != container_id) check_state(e.i, e.first, velocity(e.i));
      if (e.kind == Event::Kind::collision) check_state(e.j, e.second, velocity(e.j));
    }
    if (const auto missed = motion_.first_missed_contact(Number(0), horizon_)) {
      throw Fault("missed contact of " + std::to_string(missed->i) + " and " +
                  std::to_string(missed->j) + " at " + missed->t.str(25));
    }
  }

  // ---- What is simultaneous. ----

  // The smallest pair that touches at t and approaches by the velocities just after `prefix`.
  std::optional<std::pair<int, int>> approaching(const Motion& prefix, const Number& t) const {
    const Number later = t + pow(Number(10), -150);
    const Number tiny = pow(Number(10), -60);
    for (int i = container_id; i < disks(); ++i) {
      for (int j = i + 1; j < disks(); ++j) {
        const auto pj = prefix.position(j, t), vj = prefix.velocity(j, later);
        typename Motion::Vector pi{oracle::rounded<Number>(scene_.cx),
                                   oracle::rounded<Number>(scene_.cy)};
        typename Motion::Vector vi{Number(0), Number(0)};
        Number reach = oracle::rounded<Number>(scene_.container_radius) - radius(j);
        if (i != container_id) {
          pi = prefix.position(i, t);
          vi = prefix.velocity(i, later);
          reach = radius(i) + radius(j);
        }
        const Number dx = pj[0] - pi[0], dy = pj[1] - pi[1];
        if (abs(dx * dx + dy * dy - reach * reach) > tiny * (1 + reach * reach)) continue;
        const Number closing = dx * (vj[0] - vi[0]) + dy * (vj[1] - vi[1]);
        if (i == container_id ? closing > tiny : closing < -tiny) return std::pair(i, j);
      }
    }
    return std::nullopt;
  }
  Number radius(int i) const {
    return oracle::rounded<Number>(scene_.disks[static_cast<std::size_t>(i)].radius);
  }

  // At every instant with several events: collisions of the smallest approaching pair, then
  // maneuvers by disk, then collisions, then flips.
  void check_motion_order() const {
    std::size_t record = 0;
    for (std::size_t first = 0; first < run_.events.size();) {
      std::size_t last = first;
      while (last < run_.events.size() && run_.events[last].t == run_.events[first].t) ++last;
      if (last - first > 1) {
        check_motion_order(first, last, record);
        ++counts_.ties;
      }
      for (; first < last; ++first) record += is_motion(run_.events[first]);
    }
  }

  void check_motion_order(std::size_t first, std::size_t last, std::size_t record) const {
    const auto prefix = [&](std::size_t k) { return Motion(motion_scene_, first_records(k)); };
    // One recorded time may stand for two instants, if rarely: then this is not for us.
    for (std::size_t k = first, r = record; k < last; ++k) {
      if (!is_motion(run_.events[k])) continue;
      if (abs(motion_.times()[r] - motion_.times()[record]) > pow(Number(10), -60)) return;
      ++r;
    }
    int stage = 0;  // 0 collisions, 1 maneuvers, 2 collisions again, 3 flips
    int maneuvered = -1;
    for (std::size_t k = first; k < last; ++k) {
      const Event& e = run_.events[k];
      if (e.kind == Event::Kind::flip) {
        if (stage < 3 && record > 0 && k > first) {
          const auto pair = approaching(prefix(record), motion_.times()[record - 1]);
          if (pair) throw Fault("before flips nothing may approach: " + text(e));
        }
        stage = 3;
        continue;
      }
      if (stage == 3) throw Fault("after a flip at the same instant: " + text(e));
      const Number& t = motion_.times()[record];
      const auto pair = approaching(prefix(record), t);
      if (e.kind == Event::Kind::collision) {
        if (!pair) throw Fault("does not approach: " + text(e));
        if (*pair != std::pair(e.i, e.j)) {
          throw Fault(text(e) + ", but the pair " + std::to_string(pair->first) + " " +
                      std::to_string(pair->second) + " comes first");
        }
        if (stage == 1) stage = 2;
      } else {
        if (stage == 0 && pair) throw Fault("before collisions of the same instant: " + text(e));
        if (stage == 2) throw Fault("after the collisions that follow maneuvers: " + text(e));
        if (stage == 1 && maneuvered >= e.i) throw Fault("maneuvers not in order: " + text(e));
        stage = 1;
        maneuvered = e.i;
      }
      ++record;
    }
  }

  // ---- The diagram. ----

  Generators generators_at(const Number& t) const {
    return Generators(motion_.disks_at(t), container_);
  }

  void check_diagrams() {
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
  oracle::MotionScene motion_scene_;
  std::vector<oracle::MotionRecord> records_;
  Motion motion_;
  oracle::Circle container_;
  Number horizon_;
  std::set<Quad> edges_;
  std::vector<Quad> changed_;
};

template <unsigned Digits>
void check(const Scene& scene, const RecordedRun& run, const HistoryCheck& check,
           CheckCounts& counts) {
  Checker<Digits>(scene, run, check, counts).run_all();
}

}  // namespace

oracle::MotionScene oracle_scene(const Scene& scene) {
  oracle::MotionScene result;
  result.container = {scene.cx, scene.cy, scene.container_radius};
  result.wall_restitution = scene.container_restitution;
  result.wall_law =
      scene.law == ContainerLaw::normal ? oracle::WallLaw::normal : oracle::WallLaw::whole;
  result.disk_restitution = scene.restitution;
  for (const DiskInput& d : scene.disks) {
    result.disks.push_back({d.x, d.y, d.vx, d.vy, d.radius, d.mass});
  }
  return result;
}

// A maneuver at the instant of an earlier event of its
// disk is moved by less than anything here resolves, since the oracle rounds that event's time.
std::vector<oracle::MotionRecord> motion_records(const Scene& scene, const RecordedRun& run) {
  const Rational nudge(1, Integer(1) << 700);
  std::vector<oracle::MotionRecord> records;
  std::map<int, double> last;
  std::vector<std::size_t> done(scene.disks.size(), 0);
  for (const Event& e : run.events) {
    if (e.kind == Event::Kind::collision) {
      records.push_back(oracle::collision(e.i, e.j));
      last[e.i] = last[e.j] = e.t;
    } else if (e.kind == Event::Kind::maneuver) {
      // The k-th maneuver of the disk.
      std::size_t k = done.at(static_cast<std::size_t>(e.i))++;
      const auto it = std::find_if(scene.maneuvers.begin(), scene.maneuvers.end(),
                                   [&](const Maneuver& m) { return m.disk == e.i && k-- == 0; });
      if (it == scene.maneuvers.end()) throw Fault("a maneuver too many: " + text(e));
      const bool shared = last.count(e.i) != 0 && last[e.i] == e.t;
      records.push_back(
          oracle::maneuver(e.i, shared ? Rational(it->t + nudge) : it->t, it->vx, it->vy));
      last[e.i] = e.t;
    }
  }
  return records;
}

std::vector<oracle::Quadruple> quadruples(const std::vector<Quad>& edges) {
  std::vector<oracle::Quadruple> result;
  for (const Quad& q : edges) result.push_back({q.l, q.r, q.s, q.e});
  return result;
}

CheckCounts& CheckCounts::operator+=(const CheckCounts& o) {
  brute_force += o.brute_force;
  cgal += o.cgal;
  legality += o.legality;
  flip_times += o.flip_times;
  ties += o.ties;
  skipped += o.skipped;
  return *this;
}

std::string check_history(const Scene& scene, const RecordedRun& run, const HistoryCheck& options,
                          CheckCounts* counts) {
  CheckCounts seen;
  std::string fault;
  try {
    // 300 digits carry some 70 collisions of one causal chain.
    if (run.count(Event::Kind::collision) <= 50) {
      check<300>(scene, run, options, seen);
    } else {
      check<1000>(scene, run, options, seen);
    }
  } catch (const std::exception& e) {
    fault = e.what();
  }
  if (counts != nullptr) *counts += seen;
  return fault;
}

}  // namespace voroproof::internal::testing
