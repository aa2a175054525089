#include "certify/certifier.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cfloat>
#include <cmath>
#include <deque>
#include <future>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include "certify/contact_proof.h"
#include "certify/edge_proof.h"
#include "certify/initial_proof.h"
#include "certify/witness.h"
#include "filtered/collapse.h"
#include "filtered/contact.h"
#include "history/error.h"
#include "history/json_text.h"
#include "topology/diagram.h"

namespace voroproof {

namespace {

using HalfEdge = Diagram::HalfEdge;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Half width of the bracket that is tried around a claimed flip time, relative to max(1, t) and
// within the tolerance: wide beside the errors of doubles, narrow beside the gaps between events.
constexpr double kBracket = 0x1p-20;

// The same where double-doubles look: what is proved free of roots then begins further away.
constexpr double kWideBracket = 0x1p-21;

// How many of the claims that are near each other in time are looked at together.
constexpr std::size_t kMaxNear = 64;

// A false claim is called mistimed where the event comes within so many tolerances of it.
constexpr int kMistimed = 1000;

// An instant of the history, with what it takes to compare it exactly.
struct Moment {
  enum class Kind { rational, flip, contact, state };
  Kind kind = Kind::rational;
  double lo = 0, hi = 0;
  Rational t;   // rational
  Quad quad{};  // flip: isolated in [lo, hi], or more narrowly:
  std::shared_ptr<const RootInterval> root;
  GenId i = 0, j = 0;          // contact of i and j near lo
  int state = 0;               // state: when generator j began this state
  DdBall dd{0, 0, kInfinity};  // the instant, where it is known so well

  static Moment at(double t) {
    Moment m;
    m.t = to_rational(t);
    m.lo = m.hi = t;
    return m;
  }
  static Moment at(const Rational& t) {
    Moment m;
    m.t = t;
    m.lo = round_down(t);
    m.hi = round_up(t);
    return m;
  }
};

// What is known of a V-edge since its quadruplet or the motion of its generators last changed: it
// is legal and does not collapse until `from`.
struct Life {
  double from = 0;
  long born = 0;         // the instant at which it began
  bool illegal = false;  // it has to flip at that instant
  bool due = false;      // it collapses at `root`, next
  Collapse root;
};

// The pair of a V-edge likewise: apart or parting, no contact until `from`. Under the recorded
// truth it may overlap then: since `overlap` before.
struct Adjacency {
  double from = 0;
  long born = 0;
  double overlap = 0;
};

// The path of a disk under the recorded truth: rational, in fact dyadic.
struct Path {
  Rational t, x, y, vx, vy;
  ExactVec2 at(const Rational& time) const {
    const Rational dt = time - t;
    return {x + vx * dt, y + vy * dt};
  }
};

struct Refuted {
  Divergence divergence;
};

// What the claims before a time amount to, under the recorded truth.
struct Checkpoint {
  double t = 0;
  Diagram diagram{0};
  std::vector<Path> paths;
  std::vector<ExactVec2> claimed_v;
  std::vector<int> last_event;
  int motion_events = 0;
  std::size_t next_maneuver = 0;
  std::set<std::size_t> done_maneuvers;
  double top_speed = 0;
};

std::string text(const Quad& q) {
  return "[" + std::to_string(q.l) + "," + std::to_string(q.r) + "," + std::to_string(q.s) + "," +
         std::to_string(q.e) + "]";
}
std::string text(GenId i, GenId j) {
  return "[" + std::to_string(i) + "," + std::to_string(j) + "]";
}
std::string between(double lo, double hi) {
  return "at a time in [" + number_text(lo) + ", " + number_text(hi) + "]";
}

bool same_generators(const Quad& a, const Quad& b) {
  std::array<GenId, 4> x{a.l, a.r, a.s, a.e}, y{b.l, b.r, b.s, b.e};
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  return x == y;
}

template <class T>
using Vec2Pair = std::array<std::array<T, 2>, 2>;
using BallVec2 = std::array<DoubleBall, 2>;

Rational square(const Rational& x) { return x * x; }
template <class T>
T norm2(const std::array<T, 2>& v) {
  return v[0] * v[0] + v[1] * v[1];
}
template <class T>
std::array<T, 2> minus(const std::array<T, 2>& a, const std::array<T, 2>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

// An enclosure: get_d() rounds towards zero.
DoubleBall ball(const Rational& q) {
  const double x = q.get_d();
  return {x, std::fabs(x) * 0x1p-52 + DBL_MIN};
}
BallVec2 ball(const ExactVec2& v) { return {ball(v[0]), ball(v[1])}; }

// An upper bound of the length of a vector, good to a part in 10^15.
Rational length_bound(const ExactVec2& v) {
  const double n = round_up(norm2(v));
  return to_rational(std::nextafter(std::sqrt(n), kInfinity));
}

class Certifier {
 public:
  Certifier(const Scene& scene, const MotionInput& input, HistorySource& history,
            const CertifyOptions& options)
      : scene_(scene),
        history_(history),
        options_(options),
        horizon_(history.header().horizon),
        search_end_(round_up(last_instant())),
        horizon_down_(round_down(last_instant())),
        motion_(with_horizon(input, to_rational(search_end_)), options.motion),
        diagram_(motion_.size()),
        collapses_(motion_, certificate_.tiers),
        contacts_(motion_, certificate_.tiers),
        tolerance_up_(round_up(options.tolerance)),
        last_event_(motion_.size() + 1, 0) {
    for (const DiskSpec& d : scene.disks) {
      claimed_v_.push_back({d.vx, d.vy});
      if (options.truth == Truth::recorded) paths_.push_back({0, d.x, d.y, d.vx, d.vy});
      note_speed({d.vx, d.vy});
    }
  }

  // The whole history, or that part of it which begins at the checkpoint and ends at `until`: the
  // verdict of a part that is not the last is `certified` where all is right up to `until`.
  Certificate run(const Checkpoint* checkpoint = nullptr, std::optional<double> until = {}) {
    try {
      try {
        if (checkpoint != nullptr) {
          resume(*checkpoint);
        } else {
          start();
        }
        while (!near_.empty() || refill()) process_next();
        if (until) {
          finish_part(*until);
        } else {
          finish();
        }
      } catch (const Refuted& r) {
        throw Refuted{first_divergence(r.divergence)};
      }
    } catch (const Refuted& r) {
      certificate_.verdict = Verdict::refuted;
      certificate_.divergence = r.divergence;
      prefix_until(certificate_.divergence->t);
    } catch (const Undecided& u) {
      certificate_.verdict = Verdict::undecided;
      certificate_.reason = u.what();
      certificate_.reason_line = line_;
      prefix_until(frontier_.lo);
    }
    certificate_.highest_bits = motion_.highest_bits();
    if (ulps_count_ > 0) certificate_.ulps_mean = ulps_sum_ / static_cast<double>(ulps_count_);
    return std::move(certificate_);
  }

 private:
  static MotionInput with_horizon(MotionInput input, const Rational& horizon) {
    input.horizon = horizon;
    return input;
  }

  // ---- Claims. ----
  struct Claim {
    Event event;
    std::int64_t line;
  };

  // Reads the claims that follow within twice the tolerance of the next one: their true order may
  // differ from that of the file.
  bool refill() {
    while (!ended_ && (near_.empty() || (near_.size() < kMaxNear &&
                                         time(near_.back().event) <=
                                             time(near_.front().event) + 2 * tolerance_up_))) {
      std::optional<Event> event = history_.next();
      if (!event) {
        ended_ = true;
        break;
      }
      near_.push_back({std::move(*event), history_.line()});
      times_.push_back(time(near_.back().event));
      lines_.push_back(history_.line());
    }
    return !near_.empty();
  }

  [[noreturn]] void refute(Fault fault, const std::string& truth, Witness witness = {}) {
    Divergence d;
    d.fault = fault;
    d.line = line_;
    d.t = claim_ ? time(*claim_) : frontier_.lo;
    d.claim = claim_;
    d.truth = truth;
    d.witness = std::move(witness);
    throw Refuted{std::move(d)};
  }

  [[noreturn]] void refute_missing_flip(const Quad& q, const Collapse& root) {
    Divergence d = missing_flip(q, root);
    throw Refuted{std::move(d)};
  }

  Divergence missing_flip(const Quad& q, const Collapse& root) {
    const auto [lo, hi] = interval_of(root);
    Divergence d;
    d.fault = Fault::missing_event;
    d.t = root.lo;
    d.line = line_at(root.lo);
    d.truth = "edge " + text(canonical(q)) + " flips " + between(root.lo, root.hi);
    d.true_flip = canonical(q);
    d.true_time = {root.lo, root.hi};
    d.witness = collapse_witness(motion_, q, lo, hi);
    return d;
  }

  Divergence missing_contact(GenId i, GenId j, double lo, double hi) {
    Divergence d;
    d.fault = options_.truth == Truth::recorded ? Fault::overlap : Fault::missing_event;
    d.t = lo;
    d.line = line_at(lo);
    d.truth = "generators " + text(i, j) + " touch and approach " + between(lo, hi);
    d.true_contact = {i, j};
    d.true_time = {lo, hi};
    d.witness = contact_witness(motion_, i, j, to_rational(lo), to_rational(hi));
    return d;
  }

  // The line of the first claim later than t, or the last line read.
  std::int64_t line_at(double t) const {
    const auto it = std::upper_bound(times_.begin(), times_.end(), t);
    return it == times_.end() ? history_.line() : lines_[it - times_.begin()];
  }

  void prefix_until(double t) {
    certificate_.prefix_t = std::min(t, frontier_.lo);
    const auto it = std::lower_bound(times_.begin(), times_.end(), certificate_.prefix_t);
    certificate_.prefix_events = std::min<std::int64_t>(it - times_.begin(), processed_);
  }

  // ---- Time. ----
  // No event that the file may claim lies beyond it.
  Rational last_instant() const { return horizon_ + history_.header().horizon_error; }

  Instant instant(const Moment& m) {
    Instant now;
    now.lo = m.lo;
    now.hi = m.hi;
    now.dd = narrow(m);
    now.exact = [this, m](ExactMotion& exact) { return exact_time_of(m, exact); };
    return now;
  }

  ExactTime exact_time_of(const Moment& m, ExactMotion& exact) const {
    switch (m.kind) {
      case Moment::Kind::rational:
        break;
      case Moment::Kind::flip: {
        const RootInterval r =
            m.root ? *m.root : RootInterval{to_rational(m.lo), to_rational(m.hi)};
        return CollapseSearch::exact_root(m.quad, r.lo, r.hi, exact);
      }
      case Moment::Kind::contact:
        return ContactSearch::exact_time(m.i, m.j, to_rational(m.lo), exact);
      case Moment::Kind::state:
        return time_of(exact.start(m.state, m.j));
    }
    return ExactTime(m.t);
  }

  // Negative, zero or positive.
  int compare_moments(const Moment& a, const Moment& b) {
    if (a.hi < b.lo) return -1;
    if (b.hi < a.lo) return 1;
    if (a.kind == Moment::Kind::rational && b.kind == Moment::Kind::rational) {
      return a.t < b.t ? -1 : a.t > b.t ? 1 : 0;
    }
    const DdBall difference = narrow(a) - narrow(b);
    const Sign s = sign(difference);
    if (s == Sign::negative || s == Sign::positive) return static_cast<int>(s);
    ++certificate_.beyond_filter;
    std::string budget;
    for (bool tried = false;;) {
      const Sign t = sign(ball_of(a) - ball_of(b));
      if (t == Sign::negative || t == Sign::positive) return static_cast<int>(t);
      if (!tried) {
        tried = true;
        try {
          ExactMotion exact(motion_);
          const auto c = compare(exact_time_of(a, exact), exact_time_of(b, exact));
          return c < 0 ? -1 : c > 0 ? 1 : 0;
        } catch (const BudgetExceeded& e) {
          budget = e.what();
        }
      }
      if (!motion_.raise_precision()) {
        throw Undecided("two events may be simultaneous: " + budget);
      }
    }
  }

  DdBall narrow(const Moment& m) const {
    if (m.dd.rad < kInfinity) return m.dd;
    if (m.kind == Moment::Kind::rational) {
      const double near = round_nearest(m.t);
      const double error = std::fabs(round_nearest(Rational(m.t - to_rational(near))));
      return DdBall(near, 0, error * (1 + 0x1p-50));
    }
    const double middle = 0.5 * (m.lo + m.hi);
    DdBall best(middle, 0, (m.hi - m.lo) * (1 + 0x1p-50));
    if (m.kind == Moment::Kind::state) return best;
    if (m.kind == Moment::Kind::contact) {
      const DdBall dd = contacts_.refine(m.i, m.j, middle);
      return dd.rad < best.rad ? dd : best;
    }
    // Each step squares the relative width, or does not help.
    double lo = m.lo, hi = m.hi;
    for (int step = 0; step < 3; ++step) {
      const DdBall dd = collapses_.refine(m.quad, lo, hi);
      if (!(dd.rad < 0.5 * best.rad)) break;
      best = dd;
      if (best.rad < 0x1p-60 * (1 + best.hi)) break;
      lo = std::max(lo, below(best));
      hi = std::min(hi, above(best));
    }
    return best;
  }

  static double below(const DdBall& t) {
    return std::nextafter(t.hi + std::nextafter(t.lo - t.rad, -kInfinity), -kInfinity);
  }
  static double above(const DdBall& t) {
    return std::nextafter(t.hi + std::nextafter(t.lo + t.rad, kInfinity), kInfinity);
  }

  Ball ball_of(const Moment& m) {
    const int bits = motion_.goal_bits() + 32;
    switch (m.kind) {
      case Moment::Kind::rational:
        break;
      case Moment::Kind::flip:
        return m.root ? collapses_.refine(m.quad, m.root->lo, m.root->hi, bits)
                      : collapses_.refine(m.quad, to_rational(m.lo), to_rational(m.hi), bits);
      case Moment::Kind::contact:
        return contacts_.refine(m.i, m.j, to_rational(0.5 * (m.lo + m.hi)), bits);
      case Moment::Kind::state: {
        Ball b(to_rational(m.dd.hi) + to_rational(m.dd.lo), bits);
        b.widen(Magnitude::of(m.dd.rad));
        return b;
      }
    }
    return Ball(m.t, bits);
  }

  // Whether a moment is within the tolerance of the claimed time.
  bool within_tolerance(const Moment& m, const Rational& claimed) {
    const Moment first = Moment::at(claimed - options_.tolerance);
    const Moment last = Moment::at(claimed + options_.tolerance);
    return compare_moments(m, first) >= 0 && compare_moments(m, last) <= 0;
  }

  // Where the truth has come to. A later moment makes it move on, and then nothing may be left
  // that had to happen before.
  void advance(const Moment& m) {
    const int order = compare_moments(m, frontier_);
    if (order < 0) {
      refute(Fault::wrong_order, "the event lies " + between(m.lo, m.hi) +
                                     ", before the event claimed before it, and cannot be swapped "
                                     "with it");
    }
    if (order > 0) {
      leave_instant();
      frontier_ = m;
      ++instant_;
      return;
    }
    if (processed_ > 0) ++certificate_.simultaneous;
    if (m.kind != Moment::Kind::flip) frontier_ = m;
  }

  // Every edge illegal at the present instant must have flipped.
  void leave_instant() {
    for (const int e : illegal_) {
      const Life& life = lives_[e];
      if (life.illegal && life.born == instant_) {
        Collapse c;
        c.lo = frontier_.lo;
        c.hi = frontier_.hi;
        Divergence d = missing_flip(diagram_.quad(2 * e), c);
        d.witness = motion_witness(motion_, generators(diagram_.quad(2 * e)), to_rational(c.lo));
        throw Refuted{d};
      }
    }
    illegal_.clear();
  }

  static std::vector<GenId> generators(const Quad& q) { return {q.l, q.r, q.s, q.e}; }

  static std::pair<Rational, Rational> interval_of(const Collapse& c) {
    if (c.fine) return {c.fine->lo, c.fine->hi};
    return {to_rational(c.lo), to_rational(c.hi)};
  }

  static Moment moment_of(const Quad& q, const Collapse& c) {
    Moment m;
    m.kind = Moment::Kind::flip;
    m.quad = q;
    m.lo = c.lo;
    m.hi = c.hi;
    m.root = c.fine;
    return m;
  }

  // ---- Lives of edges. ----
  // A root of a flip polynomial, the only one in [lo, hi].
  struct Isolated {
    Moment m;
    double lo = 0, hi = 0;
  };

  std::optional<Collapse> first_collapse(const Quad& q, double from, double end) {
    while (from < end) {
      const Collapse c = collapses_.after(q, from, end);
      if (c.kind == Collapse::Kind::root) return c;
      if (!(c.lo > from)) {
        throw Undecided("the life of edge " + text(canonical(q)) + " is not decided", q);
      }
      from = c.lo;
    }
    return std::nullopt;
  }

  // A life begins at m. `own`: m is a root of the edge's own polynomial, isolated so, and the edge
  // is what the flip there left.
  void begin_life(int edge, const Moment& m, const Isolated* own = nullptr) {
    Life& life = lives_[edge];
    life = {};
    life.born = instant_;
    const Quad q = diagram_.quad(2 * edge);
    life.from = own != nullptr ? own->hi : m.lo;
    const bool isolated = own != nullptr && m.root == nullptr;
    if (isolated || q.s == q.e) return;
    if (own == nullptr && proved_not_cotangent(motion_, q, m.lo, m.hi)) return;
    ++certificate_.beyond_filter;
    const double soon = std::nextafter(m.hi, kInfinity);
    const Collapse c = own != nullptr ? collapses_.after(q, m.hi, soon, m.root.get())
                                      : collapses_.from(q, instant(m), soon);
    switch (c.kind) {
      case Collapse::Kind::none:
        life.from = std::max(c.lo, m.lo);
        break;
      case Collapse::Kind::root:
        life.due = true;
        life.root = c;
        break;
      case Collapse::Kind::now:
        life.illegal = true;
        illegal_.push_back(edge);
        break;
    }
  }

  // The life ends at m without a flip of the edge; `closed`: a collapse at m itself is missed too.
  void end_life(int edge, const Moment& m, bool closed = false) {
    ++certificate_.edge_lives;
    Life& life = lives_[edge];
    const Quad q = diagram_.quad(2 * edge);
    if (life.illegal) {
      if (life.born == instant_ && !closed) return;
      Collapse c;
      c.lo = c.hi = m.lo;
      refute_missing_flip(q, c);
    }
    if (!life.due) {
      if (proved_free(motion_, q, life.from, m.hi)) return;
      ++certificate_.beyond_filter;
      const auto c = first_collapse(q, life.from, m.hi);
      if (!c) return;
      life.due = true;
      life.root = *c;
    }
    const int order = compare_moments(moment_of(q, life.root), m);
    if (order < 0 || (order == 0 && closed)) refute_missing_flip(q, life.root);
  }

  // ---- Lives of pairs. ----
  std::pair<GenId, GenId> pair_of(int edge) const {
    if (diagram_.edges() == 0) return {container_id, 0};
    return std::minmax(diagram_.org(2 * edge), diagram_.dest(2 * edge));
  }

  void begin_pair(int edge, const Moment& m) { pairs_[edge] = {m.lo, instant_}; }

  // As only the motion of the pair changes: an overlap goes on.
  void go_on_with_pair(int edge, const Moment& m) {
    const bool collided = colliding_ && pair_of(edge) == *colliding_;
    pairs_[edge] = {m.lo, instant_, collided ? 0 : pairs_[edge].overlap};
  }

  // Whether the last thing that happened to both was their own collision.
  bool partners(GenId i, GenId j) const {
    return i != container_id && last_event_[i + 1] != 0 && last_event_[i + 1] == last_event_[j + 1];
  }

  // The pair's adjacency, or its motion, ends at m without a collision of the two.
  void end_pair(int edge, const Moment& m, bool closed = false) {
    const auto [i, j] = pair_of(edge);
    if (partners(i, j)) {
      pairs_[edge].overlap = 0;
      if (options_.truth == Truth::recorded) check_parting(i, j, pairs_[edge].from, m);
      return;
    }
    ++certificate_.pair_lives;
    const double from = pairs_[edge].from;
    if (options_.truth == Truth::recorded && motion_.same_velocity(i, j)) {
      check_at_rest(edge, m);
      return;
    }
    if (proved_apart(motion_, i, j, from, m.hi)) {
      pairs_[edge].overlap = 0;
      return;
    }
    ++certificate_.beyond_filter;
    if (options_.truth == Truth::recorded) {
      check_overlap(edge, m);
      return;
    }
    const Moment begin = Moment::at(to_rational(from));
    const NextContact c = contacts_.from(i, j, instant(begin), std::nextafter(m.hi, kInfinity));
    if (c.kind == NextContact::Kind::none) return;
    const int order = compare_moments(contact_moment(i, j, c), m);
    if (order > 0) return;
    if (order == 0 && !closed) {
      // They touch as something else happens. If they still approach after it, that is for their
      // next life; but of collisions at one instant the smallest pair comes first.
      if (colliding_ && std::pair(i, j) < *colliding_) {
        refute(Fault::wrong_order, "generators " + text(i, j) +
                                       " touch and approach at the same instant and come first");
      }
      return;
    }
    throw Refuted{missing_contact(i, j, c.lo, c.hi)};
  }

  static Moment contact_moment(GenId i, GenId j, const NextContact& c) {
    Moment m;
    m.kind = Moment::Kind::contact;
    m.lo = c.lo;
    m.hi = c.hi;
    m.i = i;
    m.j = j;
    return m;
  }

  // |offset + w s|^2 - reach^2, s from the time `at`, in the recorded motion: all rational.
  Contact<Rational> exact_contact(GenId i, GenId j, const Rational& at) {
    const auto site = [&](GenId g) -> MovingSite<Rational> {
      if (g == container_id) {
        return {scene_.cx, scene_.cy, 0, 0, Rational(-scene_.container_radius)};
      }
      const ExactVec2 p = paths_[g].at(at);
      return {p[0], p[1], paths_[g].vx, paths_[g].vy, scene_.disks[g].radius};
    };
    return {site(i), site(j)};
  }

  // Recorded truth: after its own collision a pair parts. The law holds within a tolerance, so that
  // one that should stay in contact may come nearer again, but not far.
  void check_parting(GenId i, GenId j, double from, const Moment& m) {
    const DoubleBall start(from);
    const Contact<DoubleBall> near(motion_.moving_site(i, start), motion_.moving_site(j, start));
    const Sign parting = sign(near.b);
    if (parting == Sign::positive || parting == Sign::zero) return;
    const Contact<Rational> k = exact_contact(i, j, to_rational(from));
    if (sgn(k.b) >= 0) return;
    // At the nearest point of the life.
    const Rational end = to_rational(m.hi) - to_rational(from);
    Rational s = -k.b / k.a;
    if (s > end) s = end;
    const Rational lost = -s * (k.a * s + 2 * k.b);  // of the squared distance
    const Rational depth = options_.tolerance * to_rational(top_speed_);
    if (lost <= 2 * scene_reach(i, j) * depth) return;
    throw Refuted{missing_contact(i, j, from, m.hi)};
  }

  // Recorded truth: two with the same velocity, or a disk at rest and the container, may overlap no
  // longer than others, but for a rounding error.
  void check_at_rest(int edge, const Moment& m) {
    const auto [i, j] = pair_of(edge);
    const bool wall = i == container_id;
    Adjacency& pair = pairs_[edge];
    const double before = std::exchange(pair.overlap, 0);
    const DoubleBall start(pair.from);
    const Contact<DoubleBall> near(motion_.moving_site(i, start), motion_.moving_site(j, start));
    if (sign(near.c) == (wall ? Sign::negative : Sign::positive)) return;
    const Rational from = to_rational(pair.from), reach = scene_reach(i, j);
    const Rational over = exact_contact(i, j, from).c * (wall ? 1 : -1);
    if (over <= 2 * options_.law_tolerance * reach * reach) return;
    pair.overlap = before + (m.hi - pair.from);
    if (pair.overlap <= tolerance_up_) return;
    throw Refuted{missing_contact(i, j, pair.from, m.hi)};
  }

  // Recorded truth: two disks may overlap, or a disk leave the container, for no longer than the
  // tolerance.
  void check_overlap(int edge, const Moment& m) {
    const auto [i, j] = pair_of(edge);
    const bool wall = i == container_id;
    Adjacency& pair = pairs_[edge];
    const double from = pair.from, before = std::exchange(pair.overlap, 0);
    const Contact<Rational> k = exact_contact(i, j, to_rational(from));
    const Rational discriminant = k.b * k.b - k.a * k.c;
    if (sgn(k.a) == 0) {
      pair.overlap = before;
      check_at_rest(edge, m);
      return;
    }
    if (!wall && sgn(discriminant) <= 0) return;
    constexpr int bits = 512;
    const Ball a(k.a, bits), b(k.b, bits), root = sqrt(Ball(discriminant, bits));
    const Ball enter = (-b - root) / a, leave = (root - b) / a;
    const Ball end(Rational(to_rational(m.hi) - to_rational(from)), bits), zero(bits);
    const Ball tolerance(options_.tolerance, bits);
    const auto first = [&](const Ball& x, const Ball& y) {
      return sign(x - y) == Sign::negative ? x : y;
    };
    const auto last = [&](const Ball& x, const Ball& y) {
      return sign(x - y) == Sign::positive ? x : y;
    };
    // An overlap from lo to hi of this life. Ends that cannot be told apart differ by nothing that
    // counts.
    const auto allowed = [&](const Ball& lo, const Ball& hi) {
      Ball length = hi - lo;
      if (sign(length) != Sign::positive) return true;
      if (sign(lo) != Sign::positive) length = length + Ball(to_rational(before), bits);
      if (sign(end - hi) != Sign::positive) {
        double low = 0;
        length.to_interval(low, pair.overlap);
      }
      return sign(length - tolerance) == Sign::negative;
    };
    const bool fine = wall ? allowed(zero, first(enter, end)) && allowed(last(leave, zero), end)
                           : allowed(last(enter, zero), first(leave, end));
    if (fine) return;
    double lo = 0, hi = 0;
    (Ball(to_rational(from), bits) + (wall ? leave : last(enter, zero))).to_interval(lo, hi);
    throw Refuted{missing_contact(i, j, lo, hi)};
  }

  // ---- The start. ----
  // Whether a claim at t = 0 is of a change of the motion, and not one that in truth comes later.
  bool turns_at_start(const Event& event) {
    if (std::holds_alternative<FlipEvent>(event)) return false;
    if (options_.truth == Truth::recorded) return true;
    if (const auto* m = std::get_if<ManeuverEvent>(&event)) {
      const auto k = scheduled(*m, 0);
      return !k || scene_.maneuvers[*k].t == 0;
    }
    const auto& claim = std::get<CollideEvent>(event);
    const NextContact c = next_contact(0, claim.i, claim.j);
    return c.kind == NextContact::Kind::none ||
           compare_moments(contact_moment(claim.i, claim.j, c), frontier_) <= 0;
  }

  void start() {
    frontier_ = Moment::at(Rational(0));
    refill();
    // What happens to the motion at t = 0 comes before the diagram at 0+.
    while (!near_.empty() && sgn(exact_time(near_.front().event)) == 0 &&
           turns_at_start(near_.front().event)) {
      take(0);
      if (const auto* c = std::get_if<CollideEvent>(&*claim_)) {
        collide(*c);
      } else {
        maneuver(std::get<ManeuverEvent>(*claim_));
      }
      done();
      refill();
    }
    claim_.reset();
    line_ = 1;
    std::vector<Quad> initial;
    if (history_.header().initial) {
      initial = *history_.header().initial;
    } else if (motion_.size() >= 2) {
      if (!options_.propose_initial) {
        throw Undecided("the history gives no initial diagram, and none is at hand");
      }
      initial = options_.propose_initial(motion_);
      certificate_.remarks.push_back(
          "the history gives no initial diagram: that of the scene was constructed and proved");
    }
    std::string why;
    if (motion_.size() < 2) {
      if (!initial.empty()) {
        refute(Fault::wrong_initial_diagram, "a diagram of fewer than two disks has no edge");
      }
    } else {
      try {
        diagram_ = diagram_of(motion_.size(), initial);
      } catch (const std::invalid_argument& e) {
        refute(Fault::wrong_initial_diagram, e.what());
      }
      if (!diagram_.is_valid(&why)) refute(Fault::wrong_initial_diagram, why);
      if (const auto f = initial_fault(diagram_, motion_, 0, certificate_.tiers)) {
        Witness w;
        if (f->vertex && f->conflict) {
          w = conflict_witness(motion_, *f->vertex, *f->conflict, 0);
        } else if (f->edge) {
          w = motion_witness(motion_, generators(*f->edge), 0);
        } else if (f->vertex) {
          w = motion_witness(motion_, {f->vertex->begin(), f->vertex->end()}, 0);
        }
        refute(Fault::wrong_initial_diagram, f->truth, w);
      }
    }
    const int edges = diagram_.edges();
    lives_.assign(edges, {});
    collected_.assign(edges, 0);
    pairs_.assign(motion_.size() == 1 ? 1 : edges, {});
    const Moment now = Moment::at(Rational(0));
    for (int e = 0; e < edges; ++e) begin_life(e, now);
    for (int e = 0; e < static_cast<int>(pairs_.size()); ++e) begin_pair(e, now);
    begun_ = true;
  }

  // ---- Parts. ----
  // Goes on from what the part before has proved to be right up to the checkpoint.
  void resume(const Checkpoint& c) {
    diagram_ = c.diagram;
    paths_ = c.paths;
    claimed_v_ = c.claimed_v;
    last_event_ = c.last_event;
    motion_events_ = c.motion_events;
    next_maneuver_ = c.next_maneuver;
    done_maneuvers_ = c.done_maneuvers;
    top_speed_ = c.top_speed;
    restart_all();
    frontier_ = Moment::at(c.t);
    ++instant_;
    Life life;
    life.from = c.t;
    lives_.assign(diagram_.edges(), life);
    collected_.assign(diagram_.edges(), 0);
    pairs_.resize(motion_.size() == 1 ? 1 : diagram_.edges());
    begun_ = true;
    for (int e = 0; e < static_cast<int>(pairs_.size()); ++e) {
      // From their last change of motion, so that an overlap is measured whole.
      const auto [i, j] = pair_of(e);
      double from = round_up(paths_[j].t);
      if (i != container_id) from = std::max(from, round_up(paths_[i].t));
      pairs_[e].from = from;
    }
  }

  void restart_all() {
    for (GenId g = 0; g < motion_.size(); ++g) {
      if (last_event_[g + 1] == 0) continue;
      const Path& p = paths_[g];
      motion_.restart(g, p.t, p.x, p.y, p.vx, p.vy);
    }
  }

  // ---- One claim. ----
  void take(std::size_t k) {
    claim_ = std::move(near_[k].event);
    line_ = near_[k].line;
    near_.erase(near_.begin() + static_cast<std::ptrdiff_t>(k));
  }

  void done() {
    ++processed_;
    if (options_.monitor && (processed_ & 0xff) == 0 &&
        !options_.monitor(frontier_.lo, processed_)) {
      throw CertificationInterrupted{};
    }
  }

  void process_next() {
    refill();
    const bool alone =
        near_.size() == 1 || time(near_[1].event) > time(near_[0].event) + 2 * tolerance_up_;
    const std::size_t k = alone ? 0 : earliest();
    take(k);
    if (const auto* f = std::get_if<FlipEvent>(&*claim_)) {
      flip(*f);
    } else if (const auto* c = std::get_if<CollideEvent>(&*claim_)) {
      collide(*c);
    } else {
      maneuver(std::get<ManeuverEvent>(*claim_));
    }
    if (k > 0) ++certificate_.swaps;
    done();
  }

  // Which of the near claims is the first in truth. Only a claim that is certainly earlier than
  // those before it, and whose own edge or pair is there already, goes before them.
  std::size_t earliest() {
    std::size_t best = 0;
    std::optional<Moment> first = probe(near_[0].event);
    if (!first) return 0;
    for (std::size_t k = 1; k < near_.size(); ++k) {
      // No truth within the tolerance of this claim comes first.
      if (time(near_[k].event) - tolerance_up_ > first->hi) continue;
      const std::optional<Moment> m = probe(near_[k].event);
      if (m && m->hi < first->lo) {
        first = m;
        best = k;
      }
    }
    if (best > 0 && options_.strict) {
      take(0);
      refute(Fault::wrong_order,
             "an event claimed after it happens before it, " + between(first->lo, first->hi));
    }
    return best;
  }

  // The true time of a claim whose edge or pair is there.
  std::optional<Moment> probe(const Event& event) {
    if (const auto* f = std::get_if<FlipEvent>(&event)) {
      const HalfEdge h = find(f->quad);
      if (h < 0 || lives_[h / 2].illegal || lives_[h / 2].due) return std::nullopt;
      const Quad q = diagram_.quad(h);
      const double from = lives_[h / 2].from;
      if (const auto root = bracket(q, from, f->t)) return root->m;
      const auto c = first_collapse(q, from, f->t + tolerance_up_);
      if (!c) return std::nullopt;
      return moment_of(q, *c);
    }
    if (options_.truth == Truth::recorded) return Moment::at(exact_time(event));
    if (const auto* c = std::get_if<CollideEvent>(&event)) {
      const int e = adjacency(c->i, c->j);
      if (e < 0) return std::nullopt;
      const NextContact next = next_contact(e, c->i, c->j);
      if (next.kind == NextContact::Kind::none) return std::nullopt;
      return contact_moment(c->i, c->j, next);
    }
    return std::nullopt;
  }

  // ---- Flips. ----
  // The half-edge with this quadruplet, or -1.
  HalfEdge find(const Quad& q) const {
    if (diagram_.edges() == 0) return -1;
    const HalfEdge first = diagram_.anchor(degree_hint(q));
    HalfEdge h = first;
    const bool from_l = diagram_.org(first) == q.l;
    do {
      const HalfEdge g = from_l ? h : Diagram::twin(h);
      if (diagram_.quad(g) == q) return g;
      h = diagram_.rotate(h);
    } while (h != first);
    return -1;
  }
  // The container has many neighbours.
  GenId degree_hint(const Quad& q) const { return q.l == container_id ? q.r : q.l; }

  // The flip of q near the claimed time, if that is easily proved.
  std::optional<Isolated> bracket(const Quad& q, double from, double t) const {
    Isolated root;
    root.m.kind = Moment::Kind::flip;
    root.m.quad = q;
    const double pad = std::fmin(kBracket * std::fmax(1, t), 0.99 * tolerance_up_);
    root.lo = root.m.lo = t - pad;
    root.hi = root.m.hi = t + pad;
    if (from <= root.lo && proved_collapse(motion_, q, root.lo, root.hi)) return root;
    // The polynomial is flat there, or an event is near.
    const double wide = kWideBracket * std::fmax(1, t);
    root.lo = std::fmax(from, t - wide);
    root.hi = t + wide;
    const auto dd = newton_collapse(motion_, collapses_, q, root.lo, root.hi);
    if (!dd) return std::nullopt;
    root.m.dd = *dd;
    root.m.lo = below(*dd);
    root.m.hi = above(*dd);
    if (!(root.m.lo >= t - 0.99 * tolerance_up_ && root.m.hi <= t + 0.99 * tolerance_up_)) {
      return std::nullopt;
    }
    return root;
  }

  // When the edge of h flips for this claim, or a refutation.
  struct Found {
    Isolated root;
    bool own = true;  // root is one of the edge's own polynomial; else it flips with others
  };
  Found collapse_for(const FlipEvent& claim, HalfEdge h) {
    const Quad q = diagram_.quad(h);
    const Life& life = lives_[h / 2];
    const Rational t = exact_time(Event(claim));
    std::optional<Isolated> easy;
    if (!life.illegal && !life.due) easy = bracket(q, life.from, claim.t);
    if (easy && proved_free(motion_, q, life.from, easy->lo)) return {*easy};
    ++certificate_.beyond_filter;
    if (life.illegal) {
      if (life.born != instant_) {
        refute(Fault::wrong_order, "the edge flips at an earlier instant");
      }
      const Moment& m = frontier_;
      if (!within_tolerance(m, t)) mistimed(q, {Collapse::Kind::root, m.lo, m.hi, nullptr}, t);
      return {{m, m.lo, m.hi}, false};
    }
    const double end = round_up(Rational(t + options_.tolerance));
    std::optional<Collapse> c =
        life.due ? std::optional(life.root) : first_collapse(q, life.from, end);
    if (!c) {
      c = first_collapse(q, std::max(life.from, end), search_end_);
      if (c) mistimed(q, *c, t);
      refute(Fault::spurious_event,
             "edge " + text(canonical(q)) + " does not collapse under its present motion",
             motion_witness(motion_, generators(q), t));
    }
    const Moment m = moment_of(q, *c);
    if (!within_tolerance(m, t)) mistimed(q, *c, t);
    return {{m, m.lo, m.hi}};
  }

  void flip(const FlipEvent& claim) {
    HalfEdge h = find(claim.quad);
    const HalfEdge mirrored = h < 0 ? find_mirrored(claim.quad) : -1;
    if (h < 0 && mirrored < 0) {
      refute(Fault::edge_not_present,
             "no edge of the diagram has the quadruplet " + text(claim.quad));
    }
    Found found;
    if (h >= 0) {
      try {
        found = collapse_for(claim, h);
      } catch (const Refuted&) {
        // Both edges of Configuration I may be there, and the other one be meant.
        h = find_mirrored(claim.quad);
        if (h < 0 || !bracket(diagram_.quad(h), lives_[h / 2].from, claim.t)) throw;
        resolve(h);
        found = collapse_for(claim, h);
      }
    } else {
      h = mirrored;
      resolve(h);
      found = collapse_for(claim, h);
    }
    const int edge = h / 2;
    const Quad q = diagram_.quad(h);
    const Life life = lives_[edge];
    const Moment& m = found.root.m;
    const bool own = found.own;
    if (!life.illegal) {
      if (options_.truth == Truth::exact && m.hi >= horizon_down_ &&
          compare_moments(m, Moment::at(last_instant())) > 0) {
        refute(Fault::spurious_event,
               "the edge flips " + between(m.lo, m.hi) + ", after the horizon");
      }
      advance(m);
    }
    if (life.illegal) ++certificate_.simultaneous;
    if (options_.truth == Truth::exact && own) count_ulps(m, claim.t);
    ++certificate_.flips;

    const int around[4] = {diagram_.next(h) / 2, diagram_.previous(h) / 2, diagram_.next(h ^ 1) / 2,
                           diagram_.previous(h ^ 1) / 2};
    std::array<int, 4> others{};
    int count = 0;
    for (const int e : around) {
      if (e == edge ||
          std::find(others.begin(), others.begin() + count, e) != others.begin() + count) {
        continue;
      }
      others[count++] = e;
    }
    end_pair(edge, m);
    for (int k = 0; k < count; ++k) end_life(others[k], m);
    diagram_.flip(h);
    const Isolated* const root = own ? &found.root : nullptr;
    begin_life(edge, m, root);
    for (int k = 0; k < count; ++k) {
      // An edge of the same four generators has the same root, and is legal beyond it.
      const bool same = own && same_generators(diagram_.quad(2 * others[k]), q);
      begin_life(others[k], m, same ? root : nullptr);
    }
    begin_pair(edge, m);
  }

  [[noreturn]] void mistimed(const Quad& q, const Collapse& c, const Rational& claimed) {
    const auto [lo, hi] = interval_of(c);
    const Rational far = kMistimed * options_.tolerance;
    const bool near = lo - claimed <= far && claimed - hi <= far;
    Divergence d;
    d.fault = near || hi < claimed ? Fault::wrong_time : Fault::spurious_event;
    d.line = line_;
    d.t = time(*claim_);
    d.claim = claim_;
    d.truth = "edge " + text(canonical(q)) + " flips " + between(c.lo, c.hi);
    d.true_flip = canonical(q);
    d.true_time = {c.lo, c.hi};
    d.witness = collapse_witness(motion_, q, lo, hi);
    throw Refuted{d};
  }

  // A quadruplet whose two third generators are exchanged is that of an edge whose producer does
  // not orient its quadruplets, or a fault. One alone is a fault: the doubt is kept until enough
  // others show that orientation has no meaning in this file.
  HalfEdge find_mirrored(const Quad& q) const {
    const Quad swapped = canonical(Quad{q.l, q.r, q.e, q.s});
    const HalfEdge h = find(swapped);
    return h >= 0 ? h : find(reversed(swapped));
  }

  // Takes the claim for one of the edge of h.
  void resolve(HalfEdge h) {
    if (certificate_.resolved++ > 0) return;
    Divergence d;
    d.fault = Fault::wrong_quadruple;
    d.line = line_;
    d.t = time(*claim_);
    d.claim = claim_;
    d.truth = "the edge with these generators is " + text(canonical(diagram_.quad(h)));
    d.true_flip = canonical(diagram_.quad(h));
    d.witness = motion_witness(motion_, generators(diagram_.quad(h)), to_rational(d.t));
    certificate_.first_resolved = d;
    certificate_.first_resolved_prefix = processed_;
  }

  void count_ulps(const Moment& m, double claimed) {
    const DdBall d = narrow(m) - DdBall(claimed);
    const double ulp = std::nextafter(claimed, kInfinity) - claimed;
    double error = std::fabs(d.hi + d.lo) / ulp;
    if (d.rad > 0.01 * ulp) {
      double lo = 0, hi = 0;
      (ball_of(m) - Ball(exact_time(*claim_), motion_.goal_bits() + 32)).to_interval(lo, hi);
      error = std::fmax(std::fabs(lo), std::fabs(hi)) / ulp;
    }
    ulps_sum_ += error;
    ++ulps_count_;
    if (error > certificate_.ulps_max) {
      certificate_.ulps_max = error;
      certificate_.ulps_max_line = line_;
    }
  }

  // ---- Collisions and maneuvers. ----
  // A V-edge between the two, or -1.
  int adjacency(GenId i, GenId j) const {
    if (motion_.size() == 1) return 0;
    const HalfEdge first = diagram_.anchor(j);
    HalfEdge h = first;
    do {
      if (diagram_.dest(h) == i) return h / 2;
      h = diagram_.rotate(h);
    } while (h != first);
    return -1;
  }

  NextContact next_contact(int edge, GenId i, GenId j) {
    if (partners(i, j)) return {};
    const Moment from = Moment::at(to_rational(begun_ ? pairs_[edge].from : 0));
    NextContact c = contacts_.from(i, j, instant(from), search_end_);
    if (c.kind != NextContact::Kind::at) return c;
    const DdBall dd = contacts_.refine(i, j, 0.5 * (c.lo + c.hi));
    if (dd.rad < kInfinity) {
      c.lo = std::max(c.lo, below(dd));
      c.hi = std::min(c.hi, above(dd));
    }
    return c;
  }

  // The edges that have one of the two disks among their generators: spokes first.
  void collect_around(GenId i, GenId j) {
    spokes_.clear();
    rim_.clear();
    if (!begun_) return;
    if (motion_.size() == 1) {
      spokes_.push_back(0);
      return;
    }
    const long spoke = ++collection_, any = ++collection_;
    const auto add = [this](std::vector<int>& to, int edge, long stamp, long known) {
      if (collected_[edge] >= known) return;
      collected_[edge] = stamp;
      to.push_back(edge);
    };
    const auto each = [this, i, j](auto&& visit) {
      for (const GenId g : {i, j}) {
        if (g == container_id) continue;
        const HalfEdge first = diagram_.anchor(g);
        HalfEdge h = first;
        do {
          visit(h);
          h = diagram_.rotate(h);
        } while (h != first);
      }
    };
    each([&](HalfEdge h) { add(spokes_, h / 2, spoke, spoke); });
    each([&](HalfEdge h) { add(rim_, diagram_.next(h) / 2, any, spoke); });
  }

  void end_around(const Moment& m) {
    if (diagram_.edges() == 0) return;
    for (const int e : spokes_) end_life(e, m);
    for (const int e : rim_) end_life(e, m);
  }
  void begin_around(const Moment& m) {
    for (const int e : spokes_) go_on_with_pair(e, m);
    if (diagram_.edges() == 0) return;
    for (const int e : spokes_) begin_life(e, m);
    for (const int e : rim_) begin_life(e, m);
  }
  void end_pairs_around(const Moment& m) {
    for (const int e : spokes_) {
      if (!colliding_ || pair_of(e) != *colliding_) end_pair(e, m);
    }
  }

  void collide(const CollideEvent& claim) {
    require_maneuvers_before(time(*claim_));
    colliding_ = {claim.i, claim.j};
    const int edge = begun_ ? adjacency(claim.i, claim.j) : 0;
    if (edge < 0) {
      refute(Fault::wrong_pair, "generators " + text(claim.i, claim.j) +
                                    " are not adjacent in the diagram, so they do not touch");
    }
    const Rational t = exact_time(Event(claim));
    if (options_.truth == Truth::exact) {
      collide_exactly(claim, edge, t);
    } else {
      collide_as_recorded(claim, t);
    }
    colliding_.reset();
    ++certificate_.collisions;
  }

  void collide_exactly(const CollideEvent& claim, int edge, const Rational& t) {
    const GenId i = claim.i, j = claim.j;
    const NextContact c = next_contact(edge, i, j);
    if (c.kind == NextContact::Kind::none) {
      refute(Fault::spurious_event,
             "generators " + text(i, j) + " do not touch under their present motion",
             motion_witness(motion_, {i, j}, t));
    }
    Moment m = contact_moment(i, j, c);
    if (!within_tolerance(m, t)) {
      Divergence d;
      const Rational far = kMistimed * options_.tolerance;
      const bool near = to_rational(c.lo) - t <= far;
      d.fault = near ? Fault::wrong_time : Fault::spurious_event;
      d.line = line_;
      d.t = claim.t;
      d.claim = claim_;
      d.truth = "generators " + text(i, j) + " touch " + between(c.lo, c.hi);
      d.true_contact = {i, j};
      d.true_time = {c.lo, c.hi};
      d.witness = contact_witness(motion_, i, j, to_rational(c.lo), to_rational(c.hi));
      throw Refuted{d};
    }
    advance(m);
    collect_around(i, j);
    end_pairs_around(m);
    end_around(m);
    // The law between the claimed values first, while the state before is at hand.
    if (claim.p[1])
      check_law(claim, {*exact_center(claim, 0 + (i == container_id)), *exact_center(claim, 1)});
    const Impact impact = motion_.collide(i, j, 0.5 * (m.lo + m.hi));
    m.kind = Moment::Kind::state;
    m.state = motion_.state_id(j);
    m.dd = impact.time_dd;
    frontier_ = m;
    check_state(claim, 1, impact.second);
    if (i != container_id) check_state(claim, 0, impact.first);
    note_motion(i, j, claim,
                {{{to_rational(impact.first.vx), to_rational(impact.first.vy)},
                  {to_rational(impact.second.vx), to_rational(impact.second.vy)}}});
    begin_around(m);
  }

  // Claimed values against the true ones (correctly rounded): positions within the tolerance of
  // time at the top speed, velocities within it relative to that speed.
  void check_state(const CollideEvent& claim, int side, const RoundedState& truth) {
    const ExactVec2 v{to_rational(truth.vx), to_rational(truth.vy)};
    const ExactVec2 p{to_rational(truth.px), to_rational(truth.py)};
    note_speed(v);
    check_values(exact_velocity(claim, side), exact_center(claim, side), v, p);
  }

  void check_values(const std::optional<ExactVec2>& v, const std::optional<ExactVec2>& p,
                    const ExactVec2& true_v, const ExactVec2& true_p) {
    const Rational allowed2 = square(options_.tolerance * to_rational(top_speed_));
    if (v && norm2(minus(*v, true_v)) > allowed2) {
      refute(Fault::wrong_response, "the velocity is (" + number_text(true_v[0].get_d()) + ", " +
                                        number_text(true_v[1].get_d()) + ")");
    }
    check_center(p, true_p);
  }

  void check_center(const std::optional<ExactVec2>& p, const ExactVec2& true_p) {
    if (!p) return;
    const BallVec2 off = minus(ball(*p), ball(true_p));
    const DoubleBall near = ball(options_.tolerance) * DoubleBall(top_speed_);
    if (sign(norm2(off) - near * near) == Sign::negative) return;
    // A centre is written as binary64.
    const Rational rounding = 4 * length_bound(true_p) / (Rational(1) << 53);
    const Rational allowed = options_.tolerance * to_rational(top_speed_) + rounding;
    if (norm2(minus(*p, true_p)) > square(allowed)) {
      refute(Fault::wrong_response, "the centre is (" + number_text(true_p[0].get_d()) + ", " +
                                        number_text(true_p[1].get_d()) + ")");
    }
  }

  void note_speed(const ExactVec2& v) {
    const DoubleBall speed = sqrt(norm2(ball(v)));
    top_speed_ = std::max(top_speed_, std::nextafter(speed.mid + speed.rad, kInfinity));
  }

  ExactVec2 normal(GenId i, const std::array<ExactVec2, 2>& p) const {
    return i == container_id ? minus(p[1], ExactVec2{scene_.cx, scene_.cy}) : minus(p[1], p[0]);
  }

  // Velocities after a collision with centres p and the claimed velocities before it: the law of
  // docs/formats.md, for the container with n = c - O.
  // In rationals or in enclosures: `of` converts.
  template <class T, class Of>
  Vec2Pair<T> law(GenId i, GenId j, const Vec2Pair<T>& p, Of&& of) const {
    const auto both = [&of](const ExactVec2& v) { return std::array<T, 2>{of(v[0]), of(v[1])}; };
    Vec2Pair<T> v{std::array<T, 2>{T(0), T(0)}, both(claimed_v_[j])};
    if (i == container_id) {
      const std::array<T, 2> n = minus(p[1], both({scene_.cx, scene_.cy}));
      const T q = T(v[1][0] * n[0] + v[1][1] * n[1]) / norm2(n);
      const T e = of(scene_.container_restitution);
      for (int k = 0; k < 2; ++k) {
        v[1][k] = scene_.law == ContainerLaw::whole ? T(e * (v[1][k] - T(2) * q * n[k]))
                                                    : T(v[1][k] - (T(1) + e) * q * n[k]);
      }
      return v;
    }
    v[0] = both(claimed_v_[i]);
    const std::array<T, 2> n = minus(p[1], p[0]), w = minus(v[1], v[0]);
    const Rational& mi = scene_.disks[i].mass;
    const Rational& mj = scene_.disks[j].mass;
    if (mi + mj == 0) throw Undecided("two points without mass touch", i, j);
    const T a = of(mi), b = of(mj);
    const T q =
        (T(1) + of(scene_.restitution)) * T(w[0] * n[0] + w[1] * n[1]) / T(norm2(n) * T(a + b));
    for (int k = 0; k < 2; ++k) {
      v[0][k] = v[0][k] + b * q * n[k];
      v[1][k] = v[1][k] - a * q * n[k];
    }
    return v;
  }
  std::array<ExactVec2, 2> law(GenId i, GenId j, const std::array<ExactVec2, 2>& p) const {
    if (norm2(normal(i, p)) == 0) {
      throw Undecided("the centres of two that touch coincide: there is no normal", i, j);
    }
    return law<Rational>(i, j, p, [](const Rational& q) { return q; });
  }

  // The same in doubles; false says nothing.
  bool certainly_obeys_law(const CollideEvent& claim, const std::array<ExactVec2, 2>& p) const {
    const GenId i = claim.i, j = claim.j;
    const Vec2Pair<DoubleBall> at{ball(p[0]), ball(p[1])};
    const auto v = law<DoubleBall>(i, j, at, [](const Rational& q) { return ball(q); });
    DoubleBall speed = sqrt(norm2(ball(claimed_v_[j])));
    if (i != container_id) speed = speed + sqrt(norm2(ball(claimed_v_[i])));
    const DoubleBall allowed = ball(options_.law_tolerance) * speed;
    for (const int side : {0, 1}) {
      if (side == 0 && i == container_id) continue;
      const auto claimed = exact_velocity(claim, side);
      if (claimed &&
          sign(norm2(minus(ball(*claimed), v[side])) - allowed * allowed) != Sign::negative) {
        return false;
      }
    }
    return true;
  }

  // Whether the claimed velocities are those of the law with centres p, within the tolerance. The
  // centres are written as binary64, so that the normal is known no better than that.
  bool obeys_law(const CollideEvent& claim, const std::array<ExactVec2, 2>& p) const {
    if (certainly_obeys_law(claim, p)) return true;
    const GenId i = claim.i, j = claim.j;
    if (norm2(normal(i, p)) == 0) return false;
    const auto v = law(i, j, p);
    Rational speed = length_bound(claimed_v_[j]);
    if (i != container_id) speed += length_bound(claimed_v_[i]);
    const Rational reach = scene_reach(i, j);
    const Rational normal = 16 * length_bound(p[1]) / (reach * (Rational(1) << 53));
    const Rational allowed2 = square((options_.law_tolerance + normal) * speed);
    for (const int side : {0, 1}) {
      if (side == 0 && i == container_id) continue;
      const auto claimed = exact_velocity(claim, side);
      if (claimed && norm2(minus(*claimed, v[side])) > allowed2) return false;
    }
    return true;
  }

  Rational scene_reach(GenId i, GenId j) const {
    return i == container_id ? Rational(scene_.container_radius - scene_.disks[j].radius)
                             : Rational(scene_.disks[i].radius + scene_.disks[j].radius);
  }

  void check_law(const CollideEvent& claim, const std::array<ExactVec2, 2>& p) {
    if (!claim.v[1] || obeys_law(claim, p)) return;
    refute_response(claim, p);
  }

  [[noreturn]] void refute_response(const CollideEvent& claim, const std::array<ExactVec2, 2>& p) {
    if (norm2(normal(claim.i, p)) == 0) {
      refute(Fault::wrong_response, "the centres coincide and give no normal",
             motion_witness(motion_, {claim.i, claim.j}, exact_time(*claim_)));
    }
    const auto v = law(claim.i, claim.j, p);
    std::string truth = "by the law of collision the velocities are ";
    for (const int side : {0, 1}) {
      if (side == 0 && claim.i == container_id) continue;
      truth += "(" + number_text(v[side][0].get_d()) + ", " + number_text(v[side][1].get_d()) + ")";
      if (side == 0) truth += " and ";
    }
    refute(Fault::wrong_response, truth,
           motion_witness(motion_, {claim.i, claim.j}, exact_time(*claim_)));
  }

  // What a collision leaves for later claims; `computed` where the claim gives no velocities.
  void note_motion(GenId i, GenId j, const CollideEvent& claim,
                   const std::array<ExactVec2, 2>& computed) {
    const int event = ++motion_events_;
    for (const int side : {0, 1}) {
      const GenId g = side == 0 ? i : j;
      if (g == container_id) continue;
      claimed_v_[g] = exact_velocity(claim, side).value_or(computed[side]);
      last_event_[g + 1] = event;
    }
  }

  // Where the file gives none: by the law from the centres that it gives, else from the path.
  std::array<ExactVec2, 2> computed_velocities(const CollideEvent& claim,
                                               const std::array<ExactVec2, 2>& path) const {
    std::array<ExactVec2, 2> v = law(claim.i, claim.j, recorded_centers(claim, path));
    for (ExactVec2& w : v) {
      for (Rational& x : w) x = to_rational(round_nearest(x));
    }
    return v;
  }

  static std::array<ExactVec2, 2> recorded_centers(const CollideEvent& claim,
                                                   std::array<ExactVec2, 2> path) {
    for (const int side : {0, 1}) {
      if (const auto p = exact_center(claim, side)) path[side] = *p;
    }
    return path;
  }

  void collide_as_recorded(const CollideEvent& claim, const Rational& t) {
    const GenId i = claim.i, j = claim.j;
    std::array<ExactVec2, 2> path;
    path[1] = paths_[j].at(t);
    if (i != container_id) path[0] = paths_[i].at(t);
    check_recorded_contact(i, j, t, path);
    const Moment m = claim.exact ? Moment::at(t) : Moment::at(claim.t);
    advance(m);
    collect_around(i, j);
    end_pairs_around(m);
    end_around(m);
    for (const int side : {0, 1}) {
      if (side == 0 && i == container_id) continue;
      check_center(exact_center(claim, side), path[side]);
    }
    std::array<ExactVec2, 2> after;
    if (claim.v[1]) {
      check_recorded_law(claim, path);
    } else {
      after = computed_velocities(claim, path);
      remark_velocities(claim.p[1].has_value());
    }
    note_motion(i, j, claim, after);
    for (const int side : {0, 1}) {
      const GenId g = side == 0 ? i : j;
      if (g == container_id) continue;
      note_speed(claimed_v_[g]);
      turn(g, t, path[side], claimed_v_[g]);
    }
    begin_around(m);
  }

  // The law with the centres of the path, or with those that the file gives.
  void check_recorded_law(const CollideEvent& claim, const std::array<ExactVec2, 2>& path) {
    if (!obeys_law(claim, path) && !obeys_law(claim, recorded_centers(claim, path))) {
      refute_response(claim, path);
    }
  }

  // Recorded truth: the disk goes on with velocity v.
  void turn(GenId g, const Rational& t, const ExactVec2& p, const ExactVec2& v) {
    paths_[g] = {t, p[0], p[1], v[0], v[1]};
    motion_.restart(g, t, p[0], p[1], v[0], v[1]);
  }

  void remark_velocities(bool centers) {
    if (centers ? remarked_centers_ : remarked_paths_) return;
    (centers ? remarked_centers_ : remarked_paths_) = true;
    certificate_.remarks.push_back(
        centers
            ? "collisions without velocities: computed by the law from the recorded centres"
            : "collisions without velocities and centres: computed by the law from the path; such "
              "a file soon leaves its producer's motion");
  }

  // The same in doubles; false says nothing. `path`: where the two are at the claimed time.
  bool certainly_in_contact(GenId i, GenId j, const std::array<ExactVec2, 2>& path) const {
    const auto site = [&](GenId g, const ExactVec2& p) -> MovingSite<DoubleBall> {
      if (g == container_id) {
        return {ball(scene_.cx), ball(scene_.cy), 0.0, 0.0, -ball(scene_.container_radius)};
      }
      return {ball(p[0]), ball(p[1]), ball(paths_[g].vx), ball(paths_[g].vy),
              ball(scene_.disks[g].radius)};
    };
    const Contact<DoubleBall> k{site(i, path[0]), site(j, path[1])};
    const DoubleBall s = ball(options_.tolerance);
    const Sign before = sign((k.a * s - DoubleBall(2) * k.b) * s + k.c);
    const Sign after = sign((k.a * s + DoubleBall(2) * k.b) * s + k.c);
    return i == container_id ? before == Sign::negative && after == Sign::positive
                             : before == Sign::positive && after == Sign::negative;
  }

  // Recorded truth: the pair touches within the tolerance of the claimed time.
  void check_recorded_contact(GenId i, GenId j, const Rational& t,
                              const std::array<ExactVec2, 2>& path) {
    if (certainly_in_contact(i, j, path)) return;
    const Contact<Rational> k = exact_contact(i, j, t);
    const Rational& tol = options_.tolerance;
    const auto value = [&](const Rational& s) { return Rational((k.a * s + 2 * k.b) * s + k.c); };
    const bool wall = i == container_id;
    const Rational before = value(-tol), after = value(tol);
    // A change from apart to overlapping within the tolerance.
    if (wall ? sgn(before) <= 0 && sgn(after) >= 0 : sgn(before) >= 0 && sgn(after) <= 0) return;
    const Rational discriminant = k.b * k.b - k.a * k.c;
    if (sgn(k.a) > 0 && sgn(discriminant) >= 0) {
      constexpr int bits = 512;
      const Ball root = sqrt(Ball(discriminant, bits)), b(k.b, bits), a(k.a, bits);
      const Ball contact = wall ? (root - b) / a : (-b - root) / a;
      const Ball limit(tol, bits);
      if (sign(contact - limit) != Sign::positive && sign(contact + limit) != Sign::negative)
        return;
      double lo = 0, hi = 0;
      (Ball(t, bits) + contact).to_interval(lo, hi);
      Divergence d;
      const double far = kMistimed * tolerance_up_;
      d.fault = std::fabs(lo - round_nearest(t)) <= far ? Fault::wrong_time : Fault::spurious_event;
      d.line = line_;
      d.t = time(*claim_);
      d.claim = claim_;
      d.truth = "generators " + text(i, j) + " touch " + between(lo, hi);
      d.true_contact = {i, j};
      d.true_time = {lo, hi};
      d.witness = contact_witness(motion_, i, j, to_rational(lo), to_rational(hi));
      throw Refuted{d};
    }
    if (!wall && sgn(k.a) > 0) {
      // They only come near: a graze. Near enough for a contact within the tolerance of time?
      Rational s = -k.b / k.a;
      s = std::max(Rational(-tol), std::min(tol, s));
      const Rational distance2 = value(s) + square(scene_reach(i, j));
      const Rational reach = scene_reach(i, j) + tol * to_rational(std::sqrt(round_up(k.a)));
      if (distance2 <= square(reach)) return;
    }
    refute(Fault::spurious_event, "generators " + text(i, j) + " do not touch",
           motion_witness(motion_, {i, j}, t));
  }

  // Which maneuver of the scene is claimed: in any order among those of one instant.
  std::optional<std::size_t> scheduled(const ManeuverEvent& claim, const Rational& t) const {
    const auto& all = scene_.maneuvers;
    for (std::size_t k = next_maneuver_; k < all.size(); ++k) {
      if (all[k].disk == claim.disk && !done_maneuvers_.contains(k)) return k;
      if (all[k].t > t + options_.tolerance) break;
    }
    return std::nullopt;
  }

  void note_maneuver(std::size_t k, const ManeuverEvent& claim, const ExactVec2& v) {
    done_maneuvers_.insert(k);
    while (done_maneuvers_.erase(next_maneuver_) > 0) ++next_maneuver_;
    claimed_v_[claim.disk] = exact_velocity(claim).value_or(v);
    last_event_[claim.disk + 1] = ++motion_events_;
  }

  void maneuver(const ManeuverEvent& claim) {
    const Rational t = exact_time(Event(claim));
    const auto k = scheduled(claim, t);
    if (!k) refute(Fault::spurious_event, "the scene schedules no such maneuver");
    const Maneuver& due = scene_.maneuvers[*k];
    if (abs(Rational(t - due.t)) > options_.tolerance) {
      refute(Fault::wrong_time, "the maneuver is scheduled at t = " + due.t.get_str());
    }
    if (due.t > last_instant()) {
      refute(Fault::spurious_event,
             "the maneuver is scheduled at t = " + due.t.get_str() + ", after the horizon");
    }
    require_maneuvers_before(round_down(due.t));
    const ExactVec2 v{due.vx, due.vy};
    const auto claimed = exact_velocity(claim);
    const Rational speed = length_bound(v);
    if (claimed && norm2(minus(*claimed, v)) > square(options_.law_tolerance * speed)) {
      refute(Fault::wrong_response, "the scheduled velocity is (" + number_text(v[0].get_d()) +
                                        ", " + number_text(v[1].get_d()) + ")");
    }
    const bool exact = options_.truth == Truth::exact;
    const Moment m = Moment::at(exact ? due.t : t);
    advance(m);
    const GenId g = claim.disk;
    collect_around(container_id, g);
    end_pairs_around(m);
    end_around(m);
    note_maneuver(*k, claim, v);
    note_speed(claimed_v_[g]);
    if (exact) {
      const RoundedState s = motion_.maneuver(g, m.t, v[0], v[1]);
      check_center(exact_center(claim), {to_rational(s.px), to_rational(s.py)});
    } else {
      const ExactVec2 p = paths_[g].at(m.t);
      check_center(exact_center(claim), p);
      turn(g, m.t, p, claimed_v_[g]);
    }
    begin_around(m);
    ++certificate_.maneuvers;
  }

  // Every maneuver scheduled before t must have been claimed.
  void require_maneuvers_before(double t) {
    const auto& all = scene_.maneuvers;
    while (done_maneuvers_.erase(next_maneuver_) > 0) ++next_maneuver_;
    if (next_maneuver_ == all.size()) return;
    const Maneuver& m = all[next_maneuver_];
    if (m.t > horizon_ || m.t + options_.tolerance >= to_rational(t)) return;
    Divergence d;
    d.fault = Fault::missing_event;
    d.line = line_;
    d.t = round_nearest(m.t);
    d.truth =
        "disk " + std::to_string(m.disk) + " is scheduled for a maneuver at t = " + m.t.get_str();
    throw Refuted{d};
  }

  // ---- Skimming: what the claims say, unproved. ----
 public:
  // Before the first claim that is skimmed. Gives the initial diagram of the file, or the one
  // proposed for it. Throws std::invalid_argument where it is none.
  std::vector<Quad> skim_start() {
    std::vector<Quad> initial;
    if (history_.header().initial) {
      initial = *history_.header().initial;
    } else if (motion_.size() >= 2 && options_.propose_initial) {
      restart_all();  // collisions at t = 0
      initial = options_.propose_initial(motion_);
    }
    if (motion_.size() >= 2) diagram_ = diagram_of(motion_.size(), initial);
    collected_.assign(diagram_.edges(), 0);
    begun_ = true;
    return initial;
  }

  // Takes the claim for true. False where it makes no sense on what is known.
  bool skim(const Event& event) {
    claim_ = event;
    if (const auto* f = std::get_if<FlipEvent>(&event)) {
      HalfEdge h = find(f->quad);
      if (h < 0) h = find_mirrored(f->quad);
      if (h < 0 || diagram_.quad(h).s == diagram_.quad(h).e) return false;
      diagram_.flip(h);
      return true;
    }
    const Rational t = exact_time(event);
    if (const auto* c = std::get_if<CollideEvent>(&event)) {
      std::array<ExactVec2, 2> path;
      path[1] = paths_[c->j].at(t);
      if (c->i != container_id) path[0] = paths_[c->i].at(t);
      std::array<ExactVec2, 2> after;
      if (!c->v[1]) {
        try {
          after = computed_velocities(*c, path);
        } catch (const Undecided&) {
          return false;
        }
      }
      note_motion(c->i, c->j, *c, after);
      for (const int side : {0, 1}) {
        const GenId g = side == 0 ? c->i : c->j;
        if (g != container_id) skim_turn(g, t, path[side]);
      }
      return true;
    }
    const auto& m = std::get<ManeuverEvent>(event);
    const auto k = scheduled(m, t);
    if (!k) return false;
    const Maneuver& maneuver = scene_.maneuvers[*k];
    note_maneuver(*k, m, {maneuver.vx, maneuver.vy});
    skim_turn(m.disk, t, paths_[m.disk].at(t));
    return true;
  }

  Checkpoint checkpoint(double t) const {
    return {t,           diagram_,       paths_,         claimed_v_,
            last_event_, motion_events_, next_maneuver_, done_maneuvers_,
            top_speed_};
  }

 private:
  void skim_turn(GenId g, const Rational& t, const ExactVec2& p) {
    const ExactVec2& v = claimed_v_[g];
    note_speed(v);
    paths_[g] = {t, p[0], p[1], v[0], v[1]};
  }

  // ---- The end. ----
  // The end of a part: nothing may be left that has to happen up to that time.
  void finish_part(double until) {
    claim_.reset();
    line_ = history_.line();
    require_maneuvers_before(until);
    leave_instant();
    const Moment m = Moment::at(until);
    for (int e = 0; e < static_cast<int>(pairs_.size()); ++e) end_pair(e, m, true);
    for (int e = 0; e < diagram_.edges(); ++e) end_life(e, m, true);
    certificate_.prefix_events = processed_;
    certificate_.prefix_t = until;
    certificate_.verdict = Verdict::certified;
  }

  void finish() {
    claim_.reset();
    line_ = history_.line();
    const auto* stop = std::get_if<HistoryStop>(&history_.ending());
    // What the file cannot say for certain is not held against it.
    Rational end = horizon_ - history_.header().horizon_error;
    if (stop != nullptr) end = stop->exact_t ? *stop->exact_t : to_rational(stop->t);
    if (stop == nullptr || end > frontier_.t) {
      for (std::size_t k = next_maneuver_; k < scene_.maneuvers.size(); ++k) {
        if (scene_.maneuvers[k].t > end || done_maneuvers_.contains(k)) continue;
        if (stop != nullptr && scene_.maneuvers[k].t == end) continue;
        Divergence d;
        d.fault = Fault::missing_event;
        d.line = line_;
        d.t = round_nearest(scene_.maneuvers[k].t);
        d.truth = "disk " + std::to_string(scene_.maneuvers[k].disk) +
                  " is scheduled for a maneuver at t = " + scene_.maneuvers[k].t.get_str();
        throw Refuted{d};
      }
    }
    // The horizon of some files is rounded, and events may lie beyond it.
    Moment m = Moment::at(end);
    if (compare_moments(m, frontier_) < 0) m = frontier_;
    if (stop == nullptr) leave_instant();
    for (int e = 0; e < static_cast<int>(pairs_.size()); ++e) end_pair(e, m, stop == nullptr);
    for (int e = 0; e < diagram_.edges(); ++e) end_life(e, m, stop == nullptr);
    if (stop == nullptr && !history_.counts_match()) {
      refute(Fault::bad_count, "the file has " + std::to_string(history_.counts().flips) +
                                   " flips, " + std::to_string(history_.counts().collisions) +
                                   " collisions and " +
                                   std::to_string(history_.counts().maneuvers) + " maneuvers");
    }
    certificate_.prefix_events = processed_;
    certificate_.prefix_t = round_down(end);
    if (stop != nullptr) {
      certificate_.verdict = Verdict::undecided;
      certificate_.reason = "the history stops at t = " + number_text(stop->t) +
                            " and is right up to there: " + stop->reason;
      certificate_.reason_line = line_;
    } else {
      certificate_.verdict = Verdict::certified;
    }
  }

  // What was refuted may be the consequence of something missed before: the earliest event that
  // every open life should have had, up to the refuted claim. Contacts come first everywhere: disks
  // that move through each other lead the edges into degeneracies that are costly to decide.
  Divergence first_divergence(const Divergence& found) {
    Divergence first = found;
    if (!begun_) return first;
    double limit =
        found.true_time && (*found.true_time)[0] < found.t ? (*found.true_time)[0] : found.t;
    const double margin =
        found.fault == Fault::missing_event || found.fault == Fault::overlap ? 0 : tolerance_up_;
    limit = std::min(limit, search_end_);
    for (int e = 0; e < static_cast<int>(pairs_.size()); ++e) {
      const auto [i, j] = pair_of(e);
      if (partners(i, j) || proved_apart(motion_, i, j, pairs_[e].from, limit)) continue;
      const Moment begin = Moment::at(to_rational(pairs_[e].from));
      const NextContact c = contacts_.from(i, j, instant(begin), limit);
      if (c.kind == NextContact::Kind::none || c.hi >= limit - margin - tolerance_up_) continue;
      limit = c.lo;
      first = missing_contact(i, j, c.lo, c.hi);
    }
    for (int e = 0; e < diagram_.edges(); ++e) {
      const Quad q = diagram_.quad(2 * e);
      Life& life = lives_[e];
      if (life.illegal) continue;
      std::optional<Collapse> c;
      if (life.due) {
        c = life.root;
      } else if (!proved_free(motion_, q, life.from, limit)) {
        c = first_collapse(q, life.from, limit);
      }
      if (!c || c->hi >= limit - margin) continue;
      limit = c->lo;
      first = missing_flip(q, *c);
    }
    return first;
  }

  const Scene& scene_;
  HistorySource& history_;
  const CertifyOptions& options_;
  Certificate certificate_;
  Rational horizon_;
  double search_end_;    // no event lies beyond it
  double horizon_down_;  // nor at or before it beyond the last instant
  Motion motion_;
  Diagram diagram_;
  CollapseSearch collapses_;
  ContactSearch contacts_;
  double tolerance_up_;
  double top_speed_ = 0;  // an upper bound of all speeds so far

  std::deque<Claim> near_;
  bool ended_ = false;
  std::vector<double> times_;        // of the claims read
  std::vector<std::int64_t> lines_;  // theirs
  std::optional<Event> claim_;       // being checked
  std::int64_t line_ = 1;
  std::int64_t processed_ = 0;

  bool begun_ = false;
  Moment frontier_;
  long instant_ = 0;
  std::vector<Life> lives_;
  std::vector<Adjacency> pairs_;
  std::vector<int> illegal_;
  std::vector<int> spokes_, rim_;
  std::vector<long> collected_;  // by edge: the last collection it is in
  long collection_ = 0;
  std::optional<std::pair<GenId, GenId>> colliding_;

  std::vector<ExactVec2> claimed_v_;
  std::vector<Path> paths_;      // of the recorded truth
  std::vector<int> last_event_;  // of each generator: its last change of motion, numbered
  int motion_events_ = 0;
  std::size_t next_maneuver_ = 0;
  std::set<std::size_t> done_maneuvers_;  // those past next_maneuver_
  bool remarked_centers_ = false, remarked_paths_ = false;
  double ulps_sum_ = 0;
  std::int64_t ulps_count_ = 0;
};

// ---- The recorded truth, in parts. ----
// Under the recorded truth the motion before a time is known from the claims alone, so that the
// parts of a history are proved independently: each that its claims are right and that nothing is
// missing between its two ends, given that the diagram at its beginning is right. The parts depend
// on the file only, not on the number of threads.

struct ReadClaim {
  Event event;
  std::int64_t line;
};

// A part of a history as a history.
class Section : public HistorySource {
 public:
  // `rest`: the history, where the part is the last; `ended` where it has given all its claims.
  Section(HistoryHeader header, std::vector<ReadClaim> claims, HistorySource* rest, bool ended)
      : header_(std::move(header)), claims_(std::move(claims)), rest_(rest), ended_(ended) {}

  void set_next_line(std::int64_t line) { next_line_ = line; }

  const HistoryHeader& header() const override { return header_; }
  std::optional<Event> next() override {
    if (taken_ < claims_.size()) return claims_[taken_++].event;
    taken_ = claims_.size() + 1;
    return ended_ ? std::nullopt : rest_->next();
  }
  std::int64_t line() const override {
    if (taken_ > claims_.size()) return rest_ != nullptr ? rest_->line() : next_line_;
    return taken_ == 0 ? 1 : claims_[taken_ - 1].line;
  }
  // Of the last part only.
  const std::variant<HistoryEnd, HistoryStop>& ending() const override { return rest_->ending(); }
  const HistoryCounts& counts() const override { return rest_->counts(); }
  bool counts_match() const override { return rest_->counts_match(); }
  std::vector<std::string> remarks() const override { return {}; }
  std::optional<std::int64_t> shadow_line(const Quad&, double, double) const override {
    return std::nullopt;
  }

 private:
  HistoryHeader header_;
  std::vector<ReadClaim> claims_;
  std::size_t taken_ = 0;
  HistorySource* rest_;
  bool ended_;
  std::int64_t next_line_ = 0;  // of the claim after the part
};

void add(Certificate& total, Certificate&& part) {
  if (part.first_resolved && !total.first_resolved) {
    total.first_resolved = std::move(part.first_resolved);
    total.first_resolved_prefix = total.prefix_events + part.first_resolved_prefix;
  }
  total.verdict = part.verdict;
  total.divergence = std::move(part.divergence);
  total.reason = std::move(part.reason);
  total.reason_line = part.reason_line;
  total.prefix_events += part.prefix_events;
  total.prefix_t = part.prefix_t;
  total.flips += part.flips;
  total.collisions += part.collisions;
  total.maneuvers += part.maneuvers;
  total.edge_lives += part.edge_lives;
  total.pair_lives += part.pair_lives;
  total.beyond_filter += part.beyond_filter;
  total.simultaneous += part.simultaneous;
  total.swaps += part.swaps;
  total.resolved += part.resolved;
  total.highest_bits = std::max(total.highest_bits, part.highest_bits);
  total.tiers += part.tiers;
  for (std::string& remark : part.remarks) {
    if (std::find(total.remarks.begin(), total.remarks.end(), remark) == total.remarks.end()) {
      total.remarks.push_back(std::move(remark));
    }
  }
}

class PartwiseCertifier {
 public:
  PartwiseCertifier(const Scene& scene, const MotionInput& input, HistorySource& history,
                    const CertifyOptions& options)
      : scene_(scene),
        input_(input),
        history_(history),
        options_(options),
        header_(history.header()),
        skimmer_(scene, input, history, options),
        gap_(8 * round_up(options.tolerance)),
        size_(std::max(options.least_part, options.least_part / 4096 * scene.disks.size())) {}

  ~PartwiseCertifier() { cancelled_ = true; }  // the futures wait

  Certificate run() {
    std::exception_ptr unreadable;
    try {
      read_parts();
    } catch (const InputError&) {
      // What comes before it may be refuted.
      unreadable = std::current_exception();
    }
    while (!running_.empty() && good_) collect();
    if (good_ && unreadable) std::rethrow_exception(unreadable);
    if (interrupted_) throw CertificationInterrupted{};
    return std::move(total_);
  }

 private:
  std::optional<ReadClaim> read() {
    auto event = history_.next();
    if (!event) return std::nullopt;
    return ReadClaim{std::move(*event), history_.line()};
  }

  void read_parts() {
    std::vector<ReadClaim> claims;
    std::optional<ReadClaim> next = read();
    std::shared_ptr<Checkpoint> begin;  // of the present part
    // Collisions and maneuvers at t = 0 come before the initial diagram.
    bool clear = true;
    const auto take = [&] {
      clear = clear && skimmer_.skim(next->event);
      claims.push_back(std::move(*next));
      next = read();
    };
    while (next && clear && time(next->event) == 0 &&
           !std::holds_alternative<FlipEvent>(next->event)) {
      take();
    }
    try {
      const bool proposed = !header_.initial && !scene_.disks.empty();
      const std::vector<Quad> initial = skimmer_.skim_start();
      if (proposed && scene_.disks.size() >= 2 && !initial.empty()) {
        header_.initial = initial;
        total_.remarks.push_back(
            "the history gives no initial diagram: that of the scene was constructed and proved");
      }
    } catch (const std::invalid_argument&) {
      clear = false;  // for the first part to say why
    } catch (const Undecided&) {
      clear = false;
    }
    while (good_ && next && clear) {
      const double last = claims.empty() ? 0 : time(claims.back().event);
      if (claims.size() >= size_ && time(next->event) - last > gap_) {
        const double until = last + 0.5 * (time(next->event) - last);
        auto section = std::make_shared<Section>(header_, std::move(claims), nullptr, true);
        section->set_next_line(next->line);
        claims.clear();
        start(section, begin, until);
        begin = std::make_shared<Checkpoint>(skimmer_.checkpoint(until));
      }
      take();
    }
    if (!good_) return;
    const bool ended = !next;
    if (next) claims.push_back(std::move(*next));
    start(std::make_shared<Section>(header_, std::move(claims), &history_, ended), begin, {});
  }

  void start(std::shared_ptr<Section> section, std::shared_ptr<const Checkpoint> begin,
             std::optional<double> until) {
    const std::int64_t part = started_++;
    auto work = [this, part, section = std::move(section), begin = std::move(begin), until] {
      CertifyOptions options = options_;
      options.monitor = [this, part](double t, std::int64_t events) {
        return report(part, t, events);
      };
      return Certifier(scene_, input_, *section, options).run(begin.get(), until);
    };
    if (options_.threads == 1) {
      running_.push_back(std::async(std::launch::deferred, std::move(work)));
      collect();
      return;
    }
    while (good_ && running_.size() >= static_cast<std::size_t>(options_.threads)) collect();
    if (good_) running_.push_back(std::async(std::launch::async, std::move(work)));
  }

  // Takes over the result of the earliest part that runs.
  void collect() {
    std::future<Certificate> first = std::move(running_.front());
    running_.pop_front();
    try {
      add(total_, first.get());
      good_ = total_.verdict == Verdict::certified;
    } catch (const CertificationInterrupted&) {
      interrupted_ = true;
      good_ = false;
    } catch (...) {
      cancelled_ = true;
      throw;
    }
    if (!good_) cancelled_ = true;
    const std::lock_guard lock(mutex_);
    ++collected_;
    collected_events_ = total_.prefix_events;
  }

  // The progress of the earliest part is that of the whole.
  bool report(std::int64_t part, double t, std::int64_t events) {
    if (cancelled_) return false;
    const std::lock_guard lock(mutex_);
    if (part != collected_ || !options_.monitor) return true;
    if (!options_.monitor(t, collected_events_ + events)) cancelled_ = true;
    return !cancelled_;
  }

  const Scene& scene_;
  const MotionInput& input_;
  HistorySource& history_;
  const CertifyOptions& options_;
  HistoryHeader header_;
  Certifier skimmer_;
  double gap_;        // between the claims on both sides of an end, so that no two swap across it
  std::size_t size_;  // claims of a part, at least
  Certificate total_;
  bool good_ = true, interrupted_ = false;
  std::int64_t started_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;
  std::int64_t collected_ = 0, collected_events_ = 0;  // guarded by mutex_
  std::deque<std::future<Certificate>> running_;       // last: they use the others
};

// ---- What the whole file says. ----

// Quadruplets that had to be resolved are the producer's way only where there are many.
void settle_orientation(Certificate& c, bool strict) {
  if (!c.first_resolved) return;
  if (!strict && c.resolved >= 2 && 5 * c.resolved >= c.flips) {
    c.remarks.push_back("the quadruplets are not oriented: " + std::to_string(c.resolved) +
                        " were resolved by the diagram, the first on line " +
                        std::to_string(c.first_resolved->line));
    return;
  }
  if (c.verdict == Verdict::undecided) return;
  c.verdict = Verdict::refuted;
  c.divergence = c.first_resolved;
  c.prefix_events = c.first_resolved_prefix;
  c.prefix_t = std::min(c.prefix_t, c.first_resolved->t);
}

// A missing flip may be claimed, as one that is none.
void name_shadow(Certificate& c, const HistorySource& history, double tolerance) {
  if (!c.divergence || c.divergence->fault != Fault::missing_event || !c.divergence->true_flip) {
    return;
  }
  Divergence& d = *c.divergence;
  const double far = kMistimed * tolerance;
  const auto line =
      history.shadow_line(*d.true_flip, (*d.true_time)[0] - far, (*d.true_time)[1] + far);
  if (!line) return;
  d.line = *line;
  d.truth += ", which the file takes for a shadow flip";
}

}  // namespace

Certificate certify(const Scene& scene, const MotionInput& input, HistorySource& history,
                    const CertifyOptions& options) {
  Certificate c = options.truth == Truth::recorded
                      ? PartwiseCertifier(scene, input, history, options).run()
                      : Certifier(scene, input, history, options).run();
  const auto told = history.remarks();
  c.remarks.insert(c.remarks.begin(), told.begin(), told.end());
  settle_orientation(c, options.strict);
  name_shadow(c, history, round_up(options.tolerance));
  return c;
}

}  // namespace voroproof
