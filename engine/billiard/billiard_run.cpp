#include "engine/billiard/billiard_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "engine/billiard/meeting_queue.h"
#include "engine/billiard/meeting_time.h"
#include "engine/billiard/told_value.h"
#include "engine/collapse_rule.h"
#include "exact/patience.h"
#include "filtered/billiards/line_boxes.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {
namespace {

// Whether something takes or gives energy: then collisions may have no end.
bool may_collapse(const Billiard& billiard) {
  bool may = billiard.restitution < 1 || (billiard.round && billiard.round->restitution < 1);
  for (const BilliardWall& wall : billiard.walls) may |= wall.restitution < 1 || wall.speed != 0;
  for (const BilliardDisk& disk : billiard.disks) may |= disk.growth != 0;
  return may;
}

template <class T>
class BilliardEngine {
 public:
  BilliardEngine(const Billiard& billiard, int bits, const BilliardOptions& options,
                 std::uint64_t& told, const std::function<void(const BilliardEvent&)>& tell)
      : billiard_(billiard),
        bits_(bits),
        options_(options),
        told_(told),
        tell_(tell),
        gaps_(billiard, bits),
        near_gaps_(billiard),
        lines_(billiard, near_gaps_),
        near_(billiard),
        now_(of_kind<T>(0, bits)) {
    if (may_collapse(billiard)) times_.resize(billiard.disks.size());
    for (const BilliardDisk& d : billiard.disks) {
      Body body{{now_, of_kind<T>(d.center, bits), of_kind<T>(d.velocity, bits)}, {}, {}};
      bodies_.push_back(std::move(body));
      refresh(bodies_.back());
    }
  }

  void run() {
    length_ = billiard_.horizon.get_d() * 0x1p-30;  // it grows soon
    Rational from = 0;
    do {
      const auto [pairs, to] = next_window(from);
      window(pairs, from, to);
      from = to;
    } while (from < billiard_.horizon);
  }

  double time() const { return enclosed(now_).mid; }
  std::uint64_t events() const { return events_; }

 private:
  struct Body {
    Flight<T> flight;
    Flight<DoubleBall> near;
    SweptBox box;
  };
  Body& body(GenId i) { return bodies_[static_cast<std::size_t>(i)]; }
  bool fixed(GenId i) const { return billiard_.disks[static_cast<std::size_t>(i)].fixed; }

  static void refresh(Body& body) {
    body.near = {enclosed(body.flight.t0), enclosed(body.flight.x), enclosed(body.flight.v)};
  }

  void box(GenId i, const DoubleBall& from, const DoubleBall& to) {
    body(i).box = empty_box();
    lines_.extend(body(i).box, i, body(i).near, from, to);
    lines_.require_near(i, body(i).box, to.mid);
  }

  static double speed(const Body& body) {
    const auto& v = body.near.v;
    return std::hypot(v[0].mid, v[1].mid, v[2].mid);
  }

  // The pairs of the window that begins then, and its end. It is halved while too many pairs are in
  // it and that spares any: some may meet however short it is.
  std::pair<std::vector<BilliardPair>, Rational> next_window(const Rational& from) {
    const std::size_t n = bodies_.size();
    constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
    for (std::size_t before = unknown;; length_ /= 2) {
      Rational to = from + to_rational(length_);
      if (to > billiard_.horizon || to <= from) to = billiard_.horizon;
      auto pairs = pairs_in(from, to);
      const std::size_t count = pairs ? pairs->size() : unknown;
      const bool spares = before == unknown || count < before / 4 * 3;
      if (count <= 8 * n + 64 || (pairs && !spares)) {
        if (count < 2 * n + 16 || !spares) length_ *= 2;
        return {*std::move(pairs), std::move(to)};
      }
      if (!(length_ > 0)) throw BilliardStop("a disk runs past too many images of others");
      before = count;
    }
  }

  std::optional<std::vector<BilliardPair>> pairs_in(const Rational& from, const Rational& to) {
    const DoubleBall begin = enclosed(from), end = enclosed(to);
    boxes_.clear();
    double all = 0;  // the sum of the speeds
    for (const Body& body : bodies_) all += speed(body);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      box(static_cast<GenId>(i), begin, end);
      // After a collision it will hardly be faster than this.
      const double fast = 2 * speed(bodies_[i]) + all / static_cast<double>(bodies_.size());
      SweptBox reserved = bodies_[i].box;
      widen(reserved, fixed(static_cast<GenId>(i)) ? 0 : fast * (end.mid - begin.mid));
      boxes_.push_back(is_bounded(reserved) ? reserved : bodies_[i].box);
    }
    auto pairs = near_.pairs(boxes_, begin.mid - begin.rad, end.mid + end.rad);
    if (!pairs) return pairs;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      add_walls(static_cast<GenId>(i), begin, end, *pairs);
    }
    return pairs;
  }

  void add_walls(GenId i, const DoubleBall& from, const DoubleBall& to,
                 std::vector<BilliardPair>& pairs) {
    for (GenId wall = billiard_.last_wall(); wall < 0; ++wall) {
      if (lines_.may_meet_wall(wall, body(i).box, from.mid - from.rad, to.mid + to.rad))
        pairs.push_back({wall, i});
    }
  }

  void predict(const BilliardPair& pair) {
    Patience::ask();
    Body& b = body(pair.b);
    Body& a = pair.a < 0 ? b : body(pair.a);
    const bool parting = parting_ == pair;
    const int degree = gaps_.degree(pair);
    const DoubleBall near_now = enclosed(now_), length = near_end_ - near_now;
    if (!parting) {
      const auto rough = near_gaps_.form(pair, a.near, b.near, near_now, DoubleBall(0));
      if (certainly_positive(rough, degree, 0,
                             std::max(0.0, (length.mid + length.rad) * (1 + 0x1p-50))))
        return;
    }
    if (degree > 2)
      throw BilliardStop("gravity with fixed disks, or in a round frame, is not simulated");
    const auto u =
        meeting_time<T>(gaps_.form(pair, a.flight, b.flight, now_, of_kind<T>(0, bits_)), parting);
    if (!u) return;
    T t = now_ + *u;
    const DoubleBall near = enclosed(t);
    if (sign(near - near_end_) == Sign::positive) return;
    meetings_.add({std::move(t), near, pair});
  }

  // The next meeting in the window, which stays the first one.
  const Meeting<T>* next_meeting() const {
    const Meeting<T>* first = meetings_.first();
    if (first == nullptr) return nullptr;
    const int order = time_order(first->t, first->near, end_, near_end_);
    return order < 0 || (order == 0 && is_last_) ? first : nullptr;
  }

  void window(const std::vector<BilliardPair>& pairs, const Rational& from, const Rational& to) {
    now_ = of_kind<T>(from, bits_);
    end_ = of_kind<T>(to, bits_);
    near_end_ = enclosed(end_);
    is_last_ = to == billiard_.horizon;
    meetings_.clear(bodies_.size());
    near_pairs_.assign(bodies_.size(), {});
    for (const BilliardPair& pair : pairs) {
      if (pair.a >= 0) add_near(pair);
      predict(pair);
    }
    for (;;) {
      const Meeting<T>* meeting = next_meeting();
      const BilliardManeuver* maneuver = next_maneuver(to);
      if (meeting == nullptr && maneuver == nullptr) return;
      Patience::ask_now();
      if (maneuver != nullptr) {
        const T t = of_kind<T>(maneuver->t, bits_);
        // Collisions come first, and then all maneuvers of that time.
        if (meeting == nullptr || turned_ == maneuver->t ||
            time_order(t, enclosed(t), meeting->t, meeting->near) < 0) {
          turn(*maneuver, t);
          continue;
        }
      }
      const Meeting<T> due = *meeting;
      collide(due);
    }
  }

  const BilliardManeuver* next_maneuver(const Rational& to) const {
    if (maneuvers_ == billiard_.maneuvers.size()) return nullptr;
    const BilliardManeuver& next = billiard_.maneuvers[maneuvers_];
    return next.t < to || (is_last_ && next.t == to) ? &next : nullptr;
  }

  // Tells what has not been told by a run with fewer bits.
  void tell(BilliardEvent event) {
    ++events_;
    if (events_ <= told_) return;
    if (options_.max_events > 0 && events_ > options_.max_events)
      throw BilliardStop("the history has more than " + std::to_string(options_.max_events) +
                         " events");
    tell_(event);
    told_ = events_;
  }

  void set(GenId i, const T& t, const Vector3<T>& x, const Vector3<T>& v) {
    Body& body = this->body(i);
    body.flight = {t, x, v};
    refresh(body);
  }

  void add_near(const BilliardPair& pair) {
    for (const GenId i : {pair.a, pair.b}) near_pairs_[static_cast<std::size_t>(i)].push_back(pair);
  }

  // All that a disk may meet in the rest of the window. One that leaves the place that was reserved
  // for it gets more, and is looked for among all.
  void predict_all(GenId i) {
    const DoubleBall from = enclosed(now_);
    box(i, from, near_end_);
    SweptBox& reserved = boxes_[static_cast<std::size_t>(i)];
    auto& near = near_pairs_[static_cast<std::size_t>(i)];
    if (!contains(reserved, body(i).box)) {
      extend(reserved, body(i).box);
      for (const BilliardPair& pair :
           near_.partners(i, boxes_, from.mid - from.rad, near_end_.mid + near_end_.rad)) {
        if (std::find(near.begin(), near.end(), pair) == near.end()) add_near(pair);
      }
    }
    for (const BilliardPair& pair : near) predict(pair);
    std::vector<BilliardPair> walls;
    add_walls(i, from, near_end_, walls);
    for (const BilliardPair& pair : walls) predict(pair);
  }

  void turn(const BilliardManeuver& maneuver, const T& t) {
    const GenId i = maneuver.disk;
    now_ = t;
    const Vector3<T> x = gaps_.place(i, body(i).flight, t),
                     v = of_kind<T>(maneuver.velocity, bits_);
    tell({CompactRational(told_value(t, std::fabs(enclosed(t).mid))), 0,
          BilliardTurn{i, told_value(v), told_value(x)}});
    set(i, t, x, v);
    meetings_.drop(i);
    ++maneuvers_;
    turned_ = maneuver.t;
    predict_all(i);
  }

  void require_way_out(const BilliardPair& pair, double t) {
    const auto moves = [&](GenId i) { return i >= 0 && !fixed(i); };
    if (!moves(pair.a) && !moves(pair.b))
      throw BilliardStop(name_of(billiard_, pair) + " touch, and cannot move");
    constexpr int most = 100'000;
    if (t != instant_) meetings_then_.clear();
    instant_ = t;
    if (++meetings_then_[pair] > most)
      throw BilliardStop(name_of(billiard_, pair) + " collide more than " + std::to_string(most) +
                         " times at one instant: they are pressed together");
  }

  // No instants at which one of the two collides seem to have no end.
  void require_an_end(const BilliardPair& pair, double t) {
    for (const GenId i : {pair.a, pair.b}) {
      if (i < 0 || fixed(i) || times_.empty()) continue;
      auto& times = times_[static_cast<std::size_t>(i)];
      if (!times.empty() && times.back() == t) continue;
      const std::string why = seeming_collapse(i, t, t, times);
      if (!why.empty()) throw BilliardStop(why);
    }
  }

  void collide(const Meeting<T>& due) {
    const auto& [t, near, pair] = due;
    now_ = t;
    require_way_out(pair, near.mid);
    require_an_end(pair, near.mid);
    std::array<Vector3<T>, 2> x, v;
    for (const int side : {0, 1}) {
      const GenId i = side == 0 ? pair.a : pair.b;
      if (i < 0) continue;
      x[side] = gaps_.place(i, body(i).flight, t);
      v[side] = gaps_.velocity(i, body(i).flight, t);
    }
    const auto law = gaps_.response(pair, x, v, t);
    v[0] = v[0] + law.normal * law.factor_a;
    v[1] = v[1] + law.normal * law.factor_b;
    BilliardCollision told{pair.a, pair.b, {}, {}, {}};
    if (pair.a >= 0 && billiard_.lattice.is_periodic()) told.image = pair.image;
    for (const int side : {0, 1}) {
      const GenId i = side == 0 ? pair.a : pair.b;
      if (i < 0) continue;
      told.p[side] = told_value(x[side]);
      if (!fixed(i)) told.v[side] = told_value(v[side]);
    }
    tell({CompactRational(told_value(t, std::fabs(near.mid))), 0, std::move(told)});
    for (const int side : {0, 1}) {
      const GenId i = side == 0 ? pair.a : pair.b;
      if (i < 0 || fixed(i)) continue;
      set(i, t, x[side], v[side]);
      meetings_.drop(i);
    }
    parting_ = pair;
    for (const GenId i : {pair.a, pair.b}) {
      if (i >= 0 && !fixed(i)) predict_all(i);
    }
    parting_.reset();
  }

  const Billiard& billiard_;
  int bits_;
  const BilliardOptions& options_;
  std::uint64_t& told_;
  const std::function<void(const BilliardEvent&)>& tell_;
  BilliardGaps<T> gaps_;
  BilliardGaps<DoubleBall> near_gaps_;
  LineBoxes lines_;
  NearBoxes near_;
  std::vector<Body> bodies_;
  // The places that are reserved for the disks in the window, and by disk all pairs of these that
  // meet.
  std::vector<SweptBox> boxes_;
  std::vector<std::vector<BilliardPair>> near_pairs_;
  MeetingQueue<T> meetings_;
  T now_, end_{};
  DoubleBall near_end_;
  std::optional<BilliardPair> parting_;  // the two that have just collided
  double instant_ = -1;                  // rounded, and how often pairs have collided then
  std::map<BilliardPair, int> meetings_then_;
  std::vector<std::vector<double>> times_;  // the last collisions', by disk; empty: they all end
  double length_ = 0;                       // a window's
  bool is_last_ = false;
  std::size_t maneuvers_ = 0;       // that have taken place
  std::optional<Rational> turned_;  // when the last one did
  std::uint64_t events_ = 0;
};

// Runs once; false where it is to be repeated with more bits.
template <class T>
bool run_once(const Billiard& billiard, int bits, const BilliardOptions& options,
              std::uint64_t& told, const std::function<void(const BilliardEvent&)>& tell,
              BilliardOutcome& outcome) {
  outcome.bits = bits;
  BilliardEngine<T> engine(billiard, bits, options, told, tell);
  std::optional<Patience> patience;
  if (options.monitor)
    patience.emplace([&] { return options.monitor(engine.time(), engine.events()); });
  try {
    engine.run();
    outcome.kind = BilliardOutcome::Kind::complete;
    outcome.t = round_nearest(billiard.horizon);
  } catch (const GivenUp&) {
    outcome = {BilliardOutcome::Kind::interrupted, engine.time(), "interrupted", bits};
  } catch (const MoreBits& at) {
    if (bits >= options.max_bits) {
      outcome = {BilliardOutcome::Kind::stopped, engine.time(), at.what(), bits};
      return true;
    }
    return false;
  } catch (const NoFraction&) {
    return false;
  } catch (const std::runtime_error& at) {  // BilliardStop, Undecided
    outcome = {BilliardOutcome::Kind::stopped, engine.time(), at.what(), bits};
  }
  return true;
}

}  // namespace

BilliardOutcome run_billiard(const Billiard& billiard, const BilliardOptions& options,
                             const std::function<void(const BilliardEvent&)>& tell) {
  BilliardOutcome outcome;
  std::uint64_t told = 0;
  double last = 0;  // the rounded time of the last event, which an enclosure's middle may precede
  const auto tell_on = [&](const BilliardEvent& event) {
    last = round_nearest(Rational(event.t));
    tell(event);
  };
  bool ended = run_once<Rational>(billiard, 0, options, told, tell_on, outcome);
  for (int bits = std::min(options.start_bits, options.max_bits); !ended; bits *= 2)
    ended = run_once<Ball>(billiard, bits, options, told, tell_on, outcome);
  outcome.t = std::max(outcome.t, last);
  return outcome;
}

}  // namespace voroproof::internal
