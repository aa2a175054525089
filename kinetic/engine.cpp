#include "kinetic/engine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>

#include "exact/patience.h"
#include "filtered/numbers/next_double.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"
#include "kinetic/inelastic_collapse.h"
#include "kinetic/queue.h"
#include "kinetic/static_diagram.h"

namespace voroproof::internal {

namespace {

using HalfEdge = Diagram::HalfEdge;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Relative width below which a time needs no further refinement before it is compared
// and rounded: both nearly always succeed then.
constexpr double kFine = 1e-20;

// Adds the time spent in a scope to a sum, if there is one.
class Stopwatch {
 public:
  explicit Stopwatch(double* sum) : sum_(sum) {
    if (sum_ != nullptr) start_ = Clock::now();
  }
  ~Stopwatch() {
    if (sum_ != nullptr) *sum_ += std::chrono::duration<double>(Clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double* sum_;
  Clock::time_point start_{};
};

// Events of the present instant, kept back until all of the instant is decided.
struct PendingEvent {
  double t;
  GenId i = 0, j = 0;  // a maneuver has i = j
  RoundedState first{}, second{};
};
using Pending = std::variant<Quad, PendingEvent>;

}  // namespace

template <bool certified>
class Engine<certified>::Implementation {
 public:
  Implementation(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options)
      : options_(std::move(options)),
        motion_(std::move(input), options_.motion),
        maneuvers_(std::move(maneuvers)),
        diagram_(motion_.size()),
        collapses_(motion_, stats_.tiers),
        contacts_(motion_, stats_.tiers),
        queue_(1),
        horizon_(motion_.input().horizon),
        horizon_up_(round_up(horizon_)),
        collapse_watch_(motion_) {}

  Outcome run(EventSink& sink) {
    sink_ = &sink;
    Outcome outcome;
    std::optional<Patience> patience;
    if (options_.monitor) patience.emplace([this] { return options_.monitor(now_.lo, events_); });
    try {
      start();
      while (step()) {
        if (options_.monitor && (++steps_ & 0x0f) == 0 && !options_.monitor(now_.lo, events_)) {
          throw GivenUp();
        }
      }
      motion_.settle();
      outcome.t = round_nearest(horizon_);
    } catch (const GivenUp&) {
      if (!begun_) sink_->begin({});
      outcome.kind = Outcome::Kind::interrupted;
      outcome.t = written_t_;
      outcome.reason = "interrupted";
    } catch (const Undecided& u) {
      if (!begun_) sink_->begin({});
      outcome.kind = Outcome::Kind::stopped;
      // Of an instant that was begun the time is known, and is the same in whatever way it was
      // found: the history is right up to just before.
      outcome.t = std::max(written_t_, now_t_ > written_t_ ? next_below(now_t_) : frontier_);
      outcome.reason = u.what();
      if (u.flip) outcome.events.emplace_back(*u.flip);
      if (u.contact) outcome.events.emplace_back(*u.contact);
      settle_quietly();
    }
    stats_.end = outcome.t;
    stats_.replays = motion_.replays();
    stats_.highest_bits = motion_.highest_bits();
    stats_.goal_bits = motion_.goal_bits();
    return outcome;
  }

  // For the statistics of a run that has stopped, possibly for want of bits.
  void settle_quietly() {
    try {
      motion_.settle();
    } catch (const Undecided&) {
    } catch (const GivenUp&) {
    }
  }

  EngineStats stats_;
  EngineOptions options_;
  Motion motion_;
  std::vector<ManeuverInput> maneuvers_;
  Diagram diagram_;

 private:
  // ---- Items of the queue: two for each edge, then the next maneuver, the horizon. ----
  int flip_item(int edge) const { return 2 * edge; }
  int contact_item(int edge) const { return 2 * edge + 1; }
  int maneuver_item() const { return 2 * slots_; }
  int horizon_item() const { return 2 * slots_ + 1; }
  bool is_flip(int item) const { return item < maneuver_item() && (item & 1) == 0; }
  bool is_contact(int item) const { return item < maneuver_item() && (item & 1) == 1; }

  // What a search found out about an item: bits of found_. Without kEvent its key is only a bound.
  static constexpr std::uint8_t kEvent = 1;     // at a time that isolating_ isolates
  static constexpr std::uint8_t kPending = 2;   // a flip due at the present instant, see due_flips_
  static constexpr std::uint8_t kRational = 4;  // fine_ has the isolating interval
  struct Isolating {
    double lo = 0, hi = 0;
  };
  bool is(std::uint8_t bit, int item) const { return (found_[item] & bit) != 0; }

  std::pair<GenId, GenId> pair_of(int item) const {
    if (diagram_.edges() == 0) return {container_id, 0};  // a lone disk: see start()
    const HalfEdge h = item & ~1;
    return std::minmax(diagram_.org(h), diagram_.dest(h));
  }
  Quad quad_of(int edge) const { return diagram_.quad(2 * edge); }

  double* clock(double& sum) { return options_.profile ? &sum : nullptr; }

  void set_key(int item, double key) {
    const Stopwatch watch(clock(stats_.queue_seconds));
    queue_.set(item, key);
  }

  // ---- Searches. ----
  void record_collapse(int edge, const Collapse& c) {
    const int item = flip_item(edge);
    if (is(kRational, item)) fine_.erase(edge);
    found_[item] = 0;
    switch (c.kind) {
      case Collapse::Kind::none:
        set_key(item, c.lo >= horizon_up_ ? kInfinity : c.lo);
        break;
      case Collapse::Kind::root:
        ++stats_.predicted_flips;
        isolating_[item] = {c.lo, c.hi};
        found_[item] = c.fine ? kEvent | kRational : kEvent;
        if (c.fine) fine_[edge] = c.fine;
        set_key(item, c.lo);
        break;
      case Collapse::Kind::now:
        ++stats_.predicted_flips;
        found_[item] = kPending;
        due_flips_.insert({canonical(quad_of(edge)), edge});
        set_key(item, kInfinity);
        break;
    }
  }

  void drop_pending(int edge) {
    if (!is(kPending, flip_item(edge))) return;
    std::erase_if(due_flips_, [&](const auto& due) { return due.second == edge; });
    found_[flip_item(edge)] &= static_cast<std::uint8_t>(~kPending);
  }

  double window_end(double from) const {
    return std::min(std::max(from + window_, next_above(from)), horizon_up_);
  }

  void search_flip_from_now(int edge) {
    const Stopwatch watch(clock(stats_.flip_seconds));
    count_search();
    const Quad q = quad_of(edge);
    if constexpr (certified) {
      record_collapse(edge, collapses_.from(q, now_, window_end(now_.lo)));
    } else {
      record_collapse(edge, collapse_in_doubles(motion_, q, now_.lo, window_end(now_.lo)));
    }
  }

  void search_flip_after(int edge, double start, const RootInterval* fine) {
    const Stopwatch watch(clock(stats_.flip_seconds));
    count_search();
    const Quad q = quad_of(edge);
    if constexpr (certified) {
      record_collapse(edge, collapses_.after(q, start, window_end(start), fine));
    } else {
      record_collapse(edge, collapse_in_doubles(motion_, q, start, window_end(start)));
    }
  }

  void search_contact(int edge) {
    const Stopwatch watch(clock(stats_.collision_seconds));
    ++stats_.contact_searches;
    const int item = contact_item(edge);
    const auto [i, j] = pair_of(item);
    NextContact c;
    if constexpr (certified) {
      c = contacts_.from(i, j, now_, horizon_up_);
    } else {
      c = contact_in_doubles(motion_, i, j, now_.lo, horizon_up_);
    }
    found_[item] = 0;
    if (c.kind == NextContact::Kind::none) {
      set_key(item, kInfinity);
      return;
    }
    ++stats_.predicted_collisions;
    if (c.kind == NextContact::Kind::now) {
      due_contacts_.insert({i, j});
      set_key(item, kInfinity);
      return;
    }
    isolating_[item] = {c.lo, c.hi};
    found_[item] = kEvent;
    set_key(item, c.lo);
  }

  // The look-ahead follows the mean life of a search's result.
  void count_search() {
    ++stats_.flip_searches;
    if ((stats_.flip_searches & 0xfff) == 0 && now_.lo > 0) {
      const double life = now_.lo * diagram_.edges() / static_cast<double>(stats_.flip_searches);
      window_ = std::fmax(2 * life, 1e-9 * horizon_up_);
    }
  }

  // ---- Time of an item. ----
  struct Candidate {
    int item;
    double lo, hi;
    DdBall dd;
    bool tight;  // dd is as narrow as it gets without more precision
  };

  // What the search has found, and no more.
  Candidate rough_candidate(int item) {
    if (!certified || !is_contact(item)) return candidate(item);
    const Isolating& f = isolating_[item];
    const double middle = 0.5 * (f.lo + f.hi);
    return {item, f.lo, f.hi, DdBall(middle, 0, (f.hi - f.lo) * (1 + 0x1p-50)), false};
  }

  Candidate candidate(int item) {
    const Isolating& f = isolating_[item];
    if (item == maneuver_item() || item == horizon_item()) {
      const Instant t = instant_at(item == horizon_item() ? horizon_ : next_maneuver().t);
      return {item, t.lo, t.hi, t.dd, true};
    }
    if constexpr (!certified) {
      const double t = 0.5 * (f.lo + f.hi);
      return {item, t, t, DdBall(t), true};
    }
    const auto is_fine = [](const DdBall& t) {
      return t.rad <= kFine * (1 + t.hi) || rounds_to_leading(t);
    };
    DdBall dd(0, 0, kInfinity);
    if (!options_.motion.filters) {
      dd = ball_refined(item);
    } else if (is_flip(item)) {
      dd = collapses_.refine_until(quad_of(item / 2), f.lo, f.hi, is_fine);
    } else {
      const auto [i, j] = pair_of(item);
      dd = contacts_.refine(i, j, 0.5 * (f.lo + f.hi));
    }
    if (!is_fine(dd)) dd = ball_refined(item);
    Candidate c{item, 0, 0, dd, true};
    enclose(dd, c.lo, c.hi);
    // The isolating interval may be the tighter one.
    c.lo = std::max(f.lo, c.lo);
    c.hi = std::min(f.hi, c.hi);
    return c;
  }

  Ball ball_of(int item, int bits) {
    const Isolating& f = isolating_[item];
    if (is_flip(item)) {
      const Quad q = quad_of(item / 2);
      if (is(kRational, item)) {
        const RootInterval& root = *fine_.at(item / 2);
        return collapses_.refine(q, root.lo, root.hi, bits);
      }
      return collapses_.refine(q, to_rational(f.lo), to_rational(f.hi), bits);
    }
    if (is_contact(item)) {
      const auto [i, j] = pair_of(item);
      return contacts_.refine(i, j, to_rational(0.5 * (f.lo + f.hi)), bits);
    }
    return Ball(item == horizon_item() ? horizon_ : next_maneuver().t, bits);
  }

  DdBall ball_refined(int item) {
    DdBall dd;
    ball_of(item, motion_.goal_bits() + 32).to_double_double(dd.hi, dd.lo, dd.rad);
    return dd;
  }

  ExactTime exact_time(int item, ExactMotion& exact) {
    const Isolating& f = isolating_[item];
    if (is_flip(item)) {
      const Quad q = quad_of(item / 2);
      if (is(kRational, item)) {
        const RootInterval& root = *fine_.at(item / 2);
        return CollapseSearch::exact_root(q, root.lo, root.hi, exact);
      }
      return CollapseSearch::exact_root(q, to_rational(f.lo), to_rational(f.hi), exact);
    }
    if (is_contact(item)) {
      const auto [i, j] = pair_of(item);
      return ContactSearch::exact_time(i, j, to_rational(f.lo), exact);
    }
    return ExactTime(item == horizon_item() ? horizon_ : next_maneuver().t);
  }

  [[noreturn]] void give_up(const std::string& reason, int item) {
    if (is_flip(item)) throw Undecided(reason, quad_of(item / 2));
    if (is_contact(item)) {
      const auto [i, j] = pair_of(item);
      throw Undecided(reason, i, j);
    }
    throw Undecided(reason);
  }

  bool is_rational(int item) const {
    if (is_flip(item)) return collapses_.has_rational_motion(quad_of(item / 2));
    if (!is_contact(item)) return true;
    const auto [i, j] = pair_of(item);
    return motion_.is_rational(i) && motion_.is_rational(j);
  }

  // Whether the two are proved simultaneous by symmetry: tried where arithmetic is expensive.
  bool same_by_symmetry(int a, int b) {
    if (is_rational(a) && is_rational(b)) return false;
    const Symmetry symmetry(motion_);
    const auto pair = [&](int item) {
      const auto [i, j] = pair_of(item);
      return symmetry.states(i, j);
    };
    if (is_contact(a) && is_contact(b)) return symmetry.same_contact(pair(a), pair(b));
    if (!is_flip(a) || !is_flip(b)) return false;
    const auto same = [&](int x, int y) {
      const Isolating& f = isolating_[y];
      return symmetry.same_flip(
          symmetry.states(quad_of(x / 2)), ball_of(x, motion_.goal_bits() + 32),
          symmetry.states(quad_of(y / 2)),
          is(kRational, y) ? *fine_.at(y / 2) : RootInterval{to_rational(f.lo), to_rational(f.hi)});
    };
    return same(a, b) || same(b, a);
  }

  // The order of two events: negative, zero or positive.
  int order(const Candidate& a, const Candidate& b) {
    if constexpr (!certified) {
      return a.lo < b.lo ? -1 : a.lo > b.lo ? 1 : a.item < b.item ? -1 : 1;
    }
    if (is_contact(a.item) && is_contact(b.item) && pair_of(a.item) == pair_of(b.item)) return 0;
    if (options_.motion.filters) {
      const Sign s = sign(a.dd - b.dd);
      if (s == Sign::negative || s == Sign::positive) {
        stats_.tiers.count(Predicate::compare, Tier::dd);
        return static_cast<int>(s);
      }
    }
    const int bits_now = motion_.goal_bits() + 32;
    if (const Sign s = sign(ball_of(a.item, bits_now) - ball_of(b.item, bits_now));
        s == Sign::negative || s == Sign::positive) {
      stats_.tiers.count(Predicate::compare, Tier::ball);
      return static_cast<int>(s);
    }
    if (same_by_symmetry(a.item, b.item)) {
      stats_.tiers.count(Predicate::compare, Tier::symmetry);
      ++stats_.ties;
      return 0;
    }
    std::string budget;
    try {
      ExactMotion exact(motion_);
      const auto c = compare(exact_time(a.item, exact), exact_time(b.item, exact));
      stats_.tiers.count(Predicate::compare, Tier::exact);
      if (c == 0) ++stats_.ties;
      return c < 0 ? -1 : c > 0 ? 1 : 0;
    } catch (const BudgetExceeded& e) {
      budget = e.what();
    }
    for (;;) {
      const int bits = motion_.goal_bits() + 32;
      const Sign t = sign(ball_of(a.item, bits) - ball_of(b.item, bits));
      if (t == Sign::negative || t == Sign::positive) {
        stats_.tiers.count(Predicate::compare, Tier::ball);
        return static_cast<int>(t);
      }
      if (!motion_.raise_precision()) {
        give_up("two events may be simultaneous: " + budget, a.item);
      }
    }
  }

  // The candidate's time rounded to binary64.
  double rounded_time(const Candidate& c) {
    if constexpr (!certified) return c.lo;
    if (options_.motion.filters && rounds_to_leading(c.dd)) {
      stats_.tiers.count(Predicate::round_time, Tier::dd);
      return c.dd.hi;
    }
    double t = 0;
    if (ball_of(c.item, motion_.goal_bits() + 32).round_to_double(t)) {
      stats_.tiers.count(Predicate::round_time, Tier::ball);
      return t;
    }
    std::string budget;
    try {
      ExactMotion exact(motion_);
      t = round_nearest(exact_time(c.item, exact));
      stats_.tiers.count(Predicate::round_time, Tier::exact);
      return t;
    } catch (const BudgetExceeded& e) {
      budget = e.what();
    }
    for (;;) {
      if (!motion_.raise_precision()) {
        give_up("an event time may lie on a rounding boundary: " + budget, c.item);
      }
      if (ball_of(c.item, motion_.goal_bits() + 32).round_to_double(t)) return t;
    }
  }

  const ManeuverInput& next_maneuver() const { return maneuvers_[next_maneuver_]; }
  void queue_maneuver() {
    const bool more = next_maneuver_ < maneuvers_.size() && next_maneuver().t <= horizon_;
    found_[maneuver_item()] = more ? kEvent : 0;
    quiet_until_ = more ? round_down(next_maneuver().t) : kInfinity;
    set_key(maneuver_item(), quiet_until_);
  }

  // ---- The start: t = 0. ----
  void start() {
    const Stopwatch watch(clock(stats_.initial_seconds));
    set_now(0);
    now_t_ = 0;
    diagram_ = static_diagram(motion_, 0, stats_.tiers);
    const int edges = diagram_.edges();
    // A lone disk has no V-edge but meets the container all the same: one slot.
    slots_ = motion_.size() == 1 ? 1 : edges;
    queue_ = EventQueue(2 * slots_ + 2);
    found_.assign(2 * slots_ + 2, 0);
    isolating_.assign(2 * slots_ + 2, {});
    stamp_.assign(edges, 0);
    const double spacing =
        2 * round_nearest(motion_.input().container_radius) / std::sqrt(1.0 + motion_.size());
    double speed = 0;
    for (GenId g = 0; g < motion_.size(); ++g) {
      const DoubleMotion& m = motion_.doubles(g);
      speed = std::fmax(speed, std::hypot(m.vx, m.vy));
    }
    window_ = speed > 0 ? 0.25 * spacing / speed : horizon_up_;
    found_[horizon_item()] = kEvent;
    set_key(horizon_item(), round_down(horizon_));
    queue_maneuver();
    for (int e = 0; e < slots_; ++e) search_contact(e);
    // What happens to the motion at t = 0 comes before the diagram at 0+.
    due_maneuvers_ = next_maneuver_ < maneuvers_.size() && sgn(next_maneuver().t) == 0;
    process_motion_events(0);
    if constexpr (certified) {
      stats_.settling_flips = settle(diagram_, motion_, now_, stats_.tiers);
    }
    sink_->begin(diagram_.quads());
    begun_ = true;
    degree_.assign(motion_.size() + 1, 0);
    for (HalfEdge h = 0; h < 2 * edges; ++h) ++degree_[diagram_.org(h) + 1];
    due_flips_.clear();
    for (int e = 0; e < edges; ++e) search_flip_from_now(e);
    for (int e = 0; e < slots_; ++e) search_contact(e);
    flush();
  }

  // ---- One instant. ----
  bool step() {
    std::vector<Candidate>& ties = ties_;
    ties.clear();
    if (!next_instant(ties)) return false;
    if (diagram_.edges() > 0) {
      fetch_around(ties.front().item);
      fetch_ahead();
    }
    set_now(ties.front());
    if constexpr (certified) {
      coincidence_.flips.clear();
      coincidence_.contacts.clear();
      coincidence_.records = motion_.records();
      lone_flip_ = ties.size() == 1 && is_flip(ties.front().item);
      if (!lone_flip_) {
        for (const Candidate& c : ties) note(c);
      }
    }
    if (!ties.front().tight) {
      // A lone contact: now_t_ becomes known with its collision.
      const auto [i, j] = pair_of(ties.front().item);
      process_contact(i, j, std::nullopt);
      process_motion_events(now_t_);
      finish_instant();
      return true;
    }
    const double t = rounded_time(ties.front());
    now_t_ = t;
    bool horizon = false;
    if (ties.size() == 1) {
      if (ties.front().item == horizon_item()) return false;
      process_single(ties.front(), t);
    } else {
      for (const Candidate& c : ties) {
        if (is_flip(c.item)) {
          // Kept with its isolating interval: what follows the flip starts beyond it.
          found_[c.item] |= kPending;
          due_flips_.insert({canonical(quad_of(c.item / 2)), c.item / 2});
          queue_.set(c.item, kInfinity);
        } else if (is_contact(c.item)) {
          due_contacts_.insert(pair_of(c.item));
          queue_.set(c.item, kInfinity);
        } else if (c.item == horizon_item()) {
          horizon = true;
        } else {
          due_maneuvers_ = true;
        }
      }
    }
    process_motion_events(t);
    finish_instant();
    if (horizon) {
      // The horizon itself is over once its events are.
      set_key(horizon_item(), horizon_up_);
    }
    return true;
  }

  // The flips of the instant; then all of it is decided and can be told.
  void finish_instant() {
    while (!due_flips_.empty()) {
      const int edge = due_flips_.begin()->second;
      due_flips_.erase(due_flips_.begin());
      process_flip(edge);
    }
    flush();
  }

  // Collisions, then maneuvers, then collisions again.
  void process_motion_events(double t) {
    for (;;) {
      if (!due_contacts_.empty()) {
        const auto [i, j] = *due_contacts_.begin();
        due_contacts_.erase(due_contacts_.begin());
        process_contact(i, j, t);
      } else if (due_maneuvers_) {
        due_maneuvers_ = false;
        const Rational instant = next_maneuver().t;
        // A flip's root is no longer that of its generators once their motion changes.
        if constexpr (certified) set_now(instant);
        std::vector<ManeuverInput> together;
        while (next_maneuver_ < maneuvers_.size() && next_maneuver().t == instant) {
          together.push_back(maneuvers_[next_maneuver_++]);
        }
        std::sort(together.begin(), together.end(),
                  [](const auto& a, const auto& b) { return a.disk < b.disk; });
        process_maneuvers(together, t);
        queue_maneuver();
      } else {
        break;
      }
    }
    if constexpr (certified) note_relations(motion_, coincidence_.records, now_.lo, now_.hi);
    // Only now: with some of the instant's velocities most searches would be for nothing, and
    // harder than those that count.
    ++stamp_now_;
    for (const GenId g : changed_) recompute_around(g);
    changed_.clear();
  }

  void process_single(const Candidate& c, double t) {
    if (is_flip(c.item)) {
      process_flip(c.item / 2);
    } else if (is_contact(c.item)) {
      const auto [i, j] = pair_of(c.item);
      process_contact(i, j, t);
    } else {
      due_maneuvers_ = true;
    }
  }

  // The next event and all that are simultaneous with it.
  bool next_instant(std::vector<Candidate>& ties) {
    for (;;) {
      Patience::ask();
      const int item = queue_.top();
      if (queue_.key(item) == kInfinity) return false;
      frontier_ = queue_.key(item);
      if (is(kEvent, item)) break;
      extend(item);
    }
    // A contact that nothing is near needs no refinement: its collision computes it.
    Candidate first = rough_candidate(queue_.top());
    ties.push_back(first);
    queue_.set(first.item, kInfinity);
    near_.clear();
    for (;;) {
      Patience::ask();
      const int other = queue_.top();
      if (queue_.key(other) > first.hi) break;
      if (!first.tight) {
        first = candidate(first.item);
        ties.assign(1, first);
        continue;
      }
      if (!is(kEvent, other)) {
        extend(other);
        continue;
      }
      const Candidate c = candidate(other);
      if (c.lo > queue_.key(other)) {
        queue_.set(other, c.lo);
        continue;
      }
      queue_.set(other, kInfinity);
      const int o = order(first, c);
      if (o < 0) {
        near_.push_back(c);
      } else if (o > 0) {
        near_.insert(near_.end(), ties.begin(), ties.end());
        ties.assign(1, c);
        first = c;
      } else {
        ties.push_back(c);
      }
    }
    for (const Candidate& c : near_) queue_.set(c.item, c.lo);
    return true;
  }

  // Looks further ahead for an item of which only a bound is known.
  void extend(int item) {
    const double start = queue_.key(item);
    search_flip_after(item / 2, start, nullptr);
  }

  // ---- Memory. Nearly everything that an event needs is out of the fast caches in large scenes:
  // it is asked for in time, level by level, each reading what the one before it has asked for.
  // (All inlined: compilers leave out calls of functions that do nothing else.) ----

  // Of the flip or contact after the present event, its generators and the edges around it; of
  // those of which one comes after that, the edges.
  [[gnu::always_inline]] void fetch_ahead() const {
    for (const std::size_t place : {1, 2, 3, 4}) {
      const int item = queue_.near(place);
      if (item < 0 || item >= maneuver_item()) continue;
      diagram_.prefetch(item & ~1);
      __builtin_prefetch(&isolating_[item]);
    }
    const int item = queue_.near(0);
    if (item < 0 || item >= maneuver_item()) return;
    for (const HalfEdge h : {item & ~1, item | 1}) {
      const HalfEdge side = diagram_.previous(h);
      diagram_.prefetch(side);
      queue_.prefetch(side & ~1);
      for (const GenId g : {diagram_.org(h), diagram_.org(side)}) {
        __builtin_prefetch(&motion_.doubles(g));
        __builtin_prefetch(&motion_.seconds(g));
      }
      const HalfEdge other = diagram_.previous(side);
      diagram_.prefetch(other);
      queue_.prefetch(other & ~1);
    }
  }

  // Of a flip or contact that is about to be dealt with, the triangles beyond the edges around it.
  [[gnu::always_inline]] void fetch_around(int item) const {
    if (item >= maneuver_item()) return;
    for (const HalfEdge h : {item & ~1, item | 1}) {
      const HalfEdge side = diagram_.previous(h), other = diagram_.previous(side);
      diagram_.prefetch(diagram_.previous(side ^ 1));
      diagram_.prefetch(diagram_.previous(other ^ 1));
    }
  }

  // The generator beyond an edge that searches are about to be made for.
  [[gnu::always_inline]] void fetch_beyond(HalfEdge h) const {
    __builtin_prefetch(&motion_.doubles(diagram_.org(diagram_.previous(h ^ 1))));
  }

  void set_now(const Rational& t) {
    now_ = instant_at(t);
    now_.known = [this] {
      note_lone_flip();
      return coincidence_;
    };
  }

  // Of an instant that is one flip: noted when somebody asks, or before a state changes.
  void note_lone_flip() {
    if (!lone_flip_) return;
    lone_flip_ = false;
    coincidence_.flips.push_back(Symmetry(motion_).states(now_root_.q));
  }

  // States change within an instant: what happens at it is noted as they are before.
  void note(const Candidate& c) {
    const Symmetry symmetry(motion_);
    if (is_flip(c.item)) {
      coincidence_.flips.push_back(symmetry.states(quad_of(c.item / 2)));
    } else if (is_contact(c.item)) {
      const auto [i, j] = pair_of(c.item);
      coincidence_.contacts.push_back(symmetry.states(i, j));
    }
  }

  void set_now(const Candidate& c) {
    now_.lo = c.lo;
    now_.hi = c.hi;
    now_.dd = c.dd;
    if constexpr (certified) {
      if (is_flip(c.item)) {
        // Kept apart from the function: nothing is allocated, and no rational is made,
        // for an instant that nobody asks for exactly.
        const Isolating& f = isolating_[c.item];
        now_root_.q = quad_of(c.item / 2);
        now_root_.lo = f.lo;
        now_root_.hi = f.hi;
        if (is(kRational, c.item)) {
          now_root_.fine = fine_.at(c.item / 2);
        } else {
          now_root_.fine.reset();
        }
        now_.exact = [this](ExactMotion& exact) {
          const auto& [q, lo, hi, fine] = now_root_;
          if (fine) return CollapseSearch::exact_root(q, fine->lo, fine->hi, exact);
          return CollapseSearch::exact_root(q, to_rational(lo), to_rational(hi), exact);
        };
      } else if (is_contact(c.item)) {
        // Until the states change this is the pair's next contact; process_contact
        // replaces it by the start of the new state.
        const auto [i, j] = pair_of(c.item);
        now_contact_ = {i, j, isolating_[c.item].lo};
        now_.exact = [this](ExactMotion& exact) {
          const auto& [i, j, near] = now_contact_;
          return ContactSearch::exact_time(i, j, to_rational(near), exact);
        };
      } else {
        set_now(c.item == horizon_item() ? horizon_ : next_maneuver().t);
      }
    }
  }

  // ---- Events. ----
  FlipKind kind_of(const Quad& q) const {
    const auto degree = [&](GenId g) { return degree_[g + 1]; };
    const auto within = [&](GenId g) {
      // Whether all neighbours of g are generators of the quadruplet.
      const HalfEdge first = diagram_.anchor(g);
      HalfEdge h = first;
      do {
        const GenId n = diagram_.dest(h);
        if (n != q.l && n != q.r && n != q.s && n != q.e) return false;
        h = diagram_.rotate(h);
      } while (h != first);
      return true;
    };
    const bool l3 = degree(q.l) == 3, r3 = degree(q.r) == 3;
    if (l3 && r3) return FlipKind::threethree_to_twotwo;
    if (l3 || r3) {
      for (const GenId g : {q.s, q.e}) {
        if (degree(g) == 3 && within(g)) return FlipKind::threethree_to_twofour;
      }
      return FlipKind::three_to_two;
    }
    const bool s2 = degree(q.s) == 2, e2 = degree(q.e) == 2;
    if (s2 && e2) return FlipKind::twotwo_to_threethree;
    if (s2 || e2) {
      for (const GenId g : {q.l, q.r}) {
        if (degree(g) == 4 && within(g)) return FlipKind::twofour_to_threethree;
      }
      return FlipKind::two_to_three;
    }
    return FlipKind::ordinary;
  }

  void process_flip(int edge) {
    const HalfEdge h = 2 * edge;
    const Quad q = diagram_.quad(h);
    const bool isolated = is(kEvent, flip_item(edge));
    const double beyond = isolating_[flip_item(edge)].hi;
    if (certified && !isolated) coincidence_.flips.push_back(Symmetry(motion_).states(q));
    std::shared_ptr<const RootInterval> fine;
    if (is(kRational, flip_item(edge))) fine = fine_.at(edge);
    found_[flip_item(edge)] &= static_cast<std::uint8_t>(~kPending);
    ++stats_.flips[static_cast<int>(kind_of(q))];
    const HalfEdge sides[4] = {diagram_.next(h), diagram_.previous(h), diagram_.next(h ^ 1),
                               diagram_.previous(h ^ 1)};
    int around[4];
    for (int k = 0; k < 4; ++k) {
      around[k] = sides[k] / 2;
      fetch_beyond(sides[k]);
    }
    diagram_.flip(h);
    --degree_[q.l + 1];
    --degree_[q.r + 1];
    ++degree_[q.s + 1];
    ++degree_[q.e + 1];
    pending_.emplace_back(canonical(q));
    // Edges with the same four generators have the flip time as a root: they start
    // beyond its isolating interval, where they are legal by construction.
    const auto reschedule = [&](int e) {
      drop_pending(e);
      const bool same = e == edge || same_generators(quad_of(e), q);
      if (same && isolated) {
        search_flip_after(e, beyond, fine.get());
      } else {
        search_flip_from_now(e);
      }
    };
    reschedule(edge);
    for (int k = 0; k < 4; ++k) {
      // In small configurations one edge may appear twice.
      if (std::find(around, around + k, around[k]) == around + k && around[k] != edge) {
        reschedule(around[k]);
      }
    }
    search_contact(edge);
  }

  // A disk has a new velocity: which of its neighbours does it touch and approach now?
  void change(GenId g) {
    if (g == container_id) return;
    forget_contacts_of(g);
    if (std::find(changed_.begin(), changed_.end(), g) == changed_.end()) changed_.push_back(g);
    if constexpr (certified) {
      const HalfEdge first = diagram_.anchor(g);
      HalfEdge h = first;
      do {
        const auto [i, j] = first < 0 ? std::pair(container_id, g) : pair_of(contact_item(h / 2));
        if (!contacts_.certainly_apart(i, j, now_)) search_contact(first < 0 ? 0 : h / 2);
        if (first >= 0) h = diagram_.rotate(h);
      } while (h != first);
    }
  }

  void recompute_around(GenId g) {
    const HalfEdge first = diagram_.anchor(g);
    if (first < 0) {
      search_contact(0);
      return;
    }
    HalfEdge h = first;
    do {
      diagram_.prefetch(diagram_.previous(diagram_.next(h) ^ 1));
      h = diagram_.rotate(h);
    } while (h != first);
    do {
      fetch_beyond(diagram_.next(h));
      h = diagram_.rotate(h);
    } while (h != first);
    do {
      search_contact(h / 2);
      touch(h / 2);
      touch(diagram_.next(h) / 2);
      h = diagram_.rotate(h);
    } while (h != first);
  }
  // Searches an edge's next flip once per event.
  void touch(int edge) {
    if (stamp_[edge] == stamp_now_) return;
    stamp_[edge] = stamp_now_;
    drop_pending(edge);
    if (begun_) search_flip_from_now(edge);
  }

  // The time is that of the instant, or, for a lone contact, what the collision says.
  void process_contact(GenId i, GenId j, std::optional<double> t) {
    note_lone_flip();
    Impact impact;
    {
      const Stopwatch watch(clock(stats_.move_seconds));
      if constexpr (certified) {
        impact = motion_.collide(i, j, now_.dd.hi);
      } else {
        impact = motion_.collide_in_doubles(i, j, now_.lo);
      }
    }
    if constexpr (certified) {
      if (!t) {
        now_t_ = impact.t;
        now_.dd = impact.time_dd;
        enclose(now_.dd, now_.lo, now_.hi);
      }
      const int id = motion_.state_id(j);
      now_.exact = [id, j](ExactMotion& exact) { return time_of(exact.start(id, j)); };
    }
    pending_.emplace_back(PendingEvent{t.value_or(now_t_), i, j, impact.first, impact.second});
    ++(i == container_id ? stats_.wall_collisions : stats_.disk_collisions);
    collapse_watch_.after_collision(i, j, now_, quiet_until_);
    change(i);
    change(j);
  }

  void process_maneuvers(const std::vector<ManeuverInput>& together, double t) {
    note_lone_flip();
    for (const ManeuverInput& m : together) {
      const Stopwatch watch(clock(stats_.move_seconds));
      RoundedState state{};
      if constexpr (certified) {
        state = motion_.maneuver(m.disk, m.t, m.vx, m.vy);
      } else {
        state = motion_.maneuver_in_doubles(m.disk, t, m.vx.get_d(), m.vy.get_d());
      }
      pending_.emplace_back(PendingEvent{t, m.disk, m.disk, state, {}});
      ++stats_.maneuvers;
    }
    for (const ManeuverInput& m : together) change(m.disk);
  }

  // Contacts due now are looked for anew after every change of a velocity.
  void forget_contacts_of(GenId g) {
    if (g == container_id) return;
    std::erase_if(due_contacts_,
                  [g](const auto& pair) { return pair.first == g || pair.second == g; });
  }

  void flush() {
    if (options_.max_events > 0 && events_ + pending_.size() > options_.max_events) {
      throw Undecided("the history has more than " + std::to_string(options_.max_events) +
                      " events");
    }
    for (const Pending& p : pending_) {
      ++events_;
      if (const Quad* q = std::get_if<Quad>(&p)) {
        sink_->flip(now_t_, *q);
      } else {
        const PendingEvent& e = std::get<PendingEvent>(p);
        if (e.i == e.j) {
          sink_->maneuver(e.t, e.i, e.first);
        } else {
          sink_->collide(e.t, e.i, e.j, e.first, e.second);
        }
      }
    }
    if (!pending_.empty()) written_t_ = now_t_;
    pending_.clear();
  }

  CollapseSearch collapses_;
  ContactSearch contacts_;
  EventQueue queue_;
  Rational horizon_;
  double horizon_up_;
  InelasticCollapse collapse_watch_;
  EventSink* sink_ = nullptr;
  bool begun_ = false;
  int slots_ = 0;                     // V-edges, or 1 for a lone disk
  std::vector<std::uint8_t> found_;   // of each item
  std::vector<Isolating> isolating_;  // of those that are flips or contacts found
  std::unordered_map<int, std::shared_ptr<const RootInterval>> fine_;
  std::vector<int> degree_;
  std::vector<std::uint64_t> stamp_;
  std::uint64_t stamp_now_ = 0;
  std::size_t next_maneuver_ = 0;
  double quiet_until_ = 0;  // no maneuver to come is due before
  double window_ = 0;
  Instant now_;
  // What the exact time of the present instant is made of, where a flip or a contact began it.
  struct {
    Quad q;
    double lo = 0, hi = 0;
    std::shared_ptr<const RootInterval> fine;
  } now_root_;
  struct {
    GenId i = 0, j = 0;
    double near = 0;
  } now_contact_;
  Coincidence coincidence_;  // of the present instant
  bool lone_flip_ = false;   // which is the flip at now_root_, not noted in it yet
  double now_t_ = 0, written_t_ = 0;
  double frontier_ = 0;  // every event before this time is in the history
  std::set<std::pair<Quad, int>> due_flips_;
  std::set<std::pair<GenId, GenId>> due_contacts_;
  bool due_maneuvers_ = false;
  std::vector<GenId> changed_;  // disks with new velocities at the present instant
  std::vector<Candidate> near_, ties_;
  std::vector<Pending> pending_;
  std::uint64_t steps_ = 0, events_ = 0;
};

template <bool certified>
Engine<certified>::Engine(MotionInput input, std::vector<ManeuverInput> maneuvers,
                          EngineOptions options)
    : implementation_(std::make_unique<Implementation>(std::move(input), std::move(maneuvers),
                                                       std::move(options))) {}
template <bool certified>
Engine<certified>::~Engine() = default;
template <bool certified>
Outcome Engine<certified>::run(EventSink& sink) {
  return implementation_->run(sink);
}
template <bool certified>
const EngineStats& Engine<certified>::stats() const {
  return implementation_->stats_;
}
template <bool certified>
const Diagram& Engine<certified>::diagram() const {
  return implementation_->diagram_;
}
template <bool certified>
const Motion& Engine<certified>::motion() const {
  return implementation_->motion_;
}
template <bool certified>
Motion& Engine<certified>::motion() {
  return implementation_->motion_;
}

template class Engine<true>;
template class Engine<false>;

}  // namespace voroproof::internal
