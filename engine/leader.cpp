#include "engine/leader.h"

#include <algorithm>
#include <limits>

#include "exact/patience.h"

namespace voroproof::internal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Where between two instants a slice ends: at no place that symmetry might prefer.
constexpr double kPart = 0.6180339887;
// The items of events.
constexpr int kContact = 0, kManeuver = 1, kHorizon = 2;

}  // namespace

Leader::Leader(MotionInput input, std::vector<ManeuverInput> maneuvers,
               const MotionOptions& options)
    : motion_(std::move(input), options),
      arithmetic_(motion_, stats_),
      maneuvers_(std::move(maneuvers), motion_.input().horizon),
      horizon_(motion_.input().horizon),
      horizon_up_(round_up(horizon_)),
      collapse_watch_(motion_),
      cells_(motion_),
      stays_(motion_.size(), 0) {}

std::optional<double> Leader::lead(LedTurns& turns, std::uint64_t work,
                                   const std::function<double(double, double)>& border) {
  turns_ = &turns;
  const std::uint64_t end = work_ + work;
  if (!std::exchange(started_, true)) start();
  while (step()) {
    if (work_ < end) continue;
    const double hi = arithmetic_.now().hi, lo = next_key();
    const double between = border ? border(hi, lo) : hi + (lo - hi) * kPart;
    if (hi < between && between < lo) return between;
  }
  return std::nullopt;
}

double Leader::work_ahead() const {
  if (!started_) return cells_.rate_of_leaving() * horizon_up_;
  return static_cast<double>(work_) * (horizon_up_ / arithmetic_.now().hi - 1);
}

// Events at t = 0 belong to the first instant.
void Leader::start() {
  arithmetic_.is_at(Moment::at(0));
  for (GenId g = 0; g < motion_.size(); ++g) cells_.place(g, 0);
  turns_->begin_instant();
  turns_->set_exactly(0);
  for (GenId g = 0; g < motion_.size(); ++g) renew(g, 0);
  due_maneuvers_ = maneuvers_.has_next() && sgn(maneuvers_.next_time()) == 0;
  process_due();
}

// ---- The next instant, as Schedule::next_instant() finds it. ----

bool Leader::is_stale(const Entry& e) const {
  if (e.j == kLeaves) return stays_[e.i] != e.state_j;
  return motion_.state_id(e.i) != e.state_i || motion_.state_id(e.j) != e.state_j;
}

const Leader::Entry* Leader::head() {
  return queue_.top([this](const Entry& e) { return is_stale(e); });
}

// Nothing happens before this time.
double Leader::next_key() {
  const Entry* const next = head();
  const double key = next == nullptr ? kInfinity : next->key;
  return std::min({key, maneuvers_.next_down(), round_down(horizon_)});
}

// The next event that may be at the bound or before, which is looked for no more.
std::optional<FoundEvent> Leader::take(double bound) {
  const double maneuvers = has_maneuvers_ ? kInfinity : maneuvers_.next_down();
  const double horizon = has_horizon_ ? kInfinity : round_down(horizon_);
  const double exact = std::min(maneuvers, horizon);
  while (const Entry* const next = head()) {
    if (!(next->key <= std::min(bound, exact))) break;
    Patience::ask();
    const Entry e = *next;
    queue_.pop();
    if (is_stale(e)) continue;
    if (e.j == kLeaves) {
      leave(e.i, e.key);
      ++work_;
      continue;
    }
    return FoundEvent(Moment::of(e.i, e.j, e.lo, e.hi), kContact);
  }
  if (!(exact <= bound) || exact == kInfinity) return std::nullopt;
  const bool maneuver = maneuvers <= horizon;
  (maneuver ? has_maneuvers_ : has_horizon_) = true;
  return maneuver ? FoundEvent(Moment::at(maneuvers_.next_time()), kManeuver)
                  : FoundEvent(Moment::at(horizon_), kHorizon);
}

void Leader::put_back(const FoundEvent& e) {
  if (e.item == kManeuver) has_maneuvers_ = false;
  if (e.item == kHorizon) has_horizon_ = false;
  if (!e.is_contact()) return;
  queue_.push({e.lo, e.lo, e.hi, e.i, e.j, motion_.state_id(e.i), motion_.state_id(e.j)});
}

bool Leader::is_tied(const FoundEvent& event) const {
  return event.is_contact() && std::any_of(ties_.begin(), ties_.end(), [&](const FoundEvent& e) {
           return e.is_contact() && e.i == event.i && e.j == event.j;
         });
}

bool Leader::next_instant() {
  ties_.clear();
  near_.clear();
  has_maneuvers_ = has_horizon_ = false;
  const std::optional<FoundEvent> next = take(kInfinity);
  if (!next) return false;
  FoundEvent first = *next;
  ties_.push_back(first);
  while (std::optional<FoundEvent> other = take(first.hi)) {
    if (is_tied(*other)) continue;
    if (!first.tight) {
      arithmetic_.tighten(first);
      ties_.assign(1, first);
      put_back(*other);
      continue;
    }
    arithmetic_.tighten(*other);
    const int order = other->lo > first.hi ? -1 : arithmetic_.order(first, *other);
    if (order < 0) {
      near_.push_back(*other);
    } else if (order > 0) {
      near_.insert(near_.end(), ties_.begin(), ties_.end());
      ties_.assign(1, *other);
      first = *other;
    } else {
      ties_.push_back(*other);
    }
  }
  for (const FoundEvent& event : near_) put_back(event);
  return true;
}

// ---- One instant; false if it is the horizon. ----
bool Leader::step() {
  if (!next_instant()) return false;
  const FoundEvent first = ties_.front();
  arithmetic_.begin(ties_);
  is_settled_ = false;
  bool horizon = false, turns = false;
  for (const FoundEvent& e : ties_) (e.item == kHorizon ? horizon : turns) = true;
  if (!turns) return false;
  turns_->begin_instant();
  for (const FoundEvent& e : ties_) {
    if (e.is_contact()) {
      turns_->add(LedTurns::Contact{e.i, e.j, {e.lo, e.hi}});
    } else {
      turns_->set_exactly(e.rational());
    }
  }
  if (!first.tight) {
    process_contact(first.i, first.j, true);
  } else {
    turns_->last().t = arithmetic_.rounded(first);
    for (const FoundEvent& e : ties_) {
      if (e.is_contact()) due_.insert({e.i, e.j});
      due_maneuvers_ |= e.item == kManeuver;
    }
  }
  process_due();
  return !horizon;
}

// Collisions, then maneuvers, then collisions again.
void Leader::process_due() {
  for (;;) {
    if (!due_.empty()) {
      const auto [i, j] = due_.extract(due_.begin()).value();
      process_contact(i, j, false);
      continue;
    }
    if (!std::exchange(due_maneuvers_, false)) break;
    process_maneuvers(maneuvers_.take());
  }
  arithmetic_.after_changes();
  is_settled_ = true;
  for (const GenId g : changed_) renew(g, arithmetic_.now().lo);
  changed_.clear();
}

void Leader::process_contact(GenId i, GenId j, bool lone) {
  const Impact impact = arithmetic_.collide(i, j, lone);
  if (lone) {
    turns_->last().t = impact.t;
    turns_->last().time = impact.time_dd;
    turns_->last().tells_time = true;
  }
  turns_->add(LedTurn{i, j, motion_.turned(i), motion_.turned(j), impact.first, impact.second,
                      motion_.v_scale()});
  ++work_;
  collapse_watch_.after_collision(i, j, arithmetic_.now(), maneuvers_.next_down());
  change(i);
  change(j);
}

void Leader::process_maneuvers(const std::vector<ManeuverInput>& together) {
  arithmetic_.is_at(Moment::at(together.front().t));
  for (const ManeuverInput& m : together) {
    const RoundedState rounded = arithmetic_.maneuver(m.disk, m.t, m.vx, m.vy);
    const TurnedState state = motion_.turned(m.disk);
    turns_->add(LedTurn{m.disk, m.disk, state, state, rounded, rounded, motion_.v_scale()});
    ++work_;
  }
  for (const ManeuverInput& m : together) change(m.disk);
}

// A disk has a new velocity. Where nothing else is at the instant it is searched for at once; else
// what it touches and approaches now is, and all else when the instant's velocities are settled:
// with some of them most searches would be for nothing, and harder than those that count.
void Leader::change(GenId g) {
  if (g == container_id) return;
  std::erase_if(due_, [g](const auto& pair) { return pair.first == g || pair.second == g; });
  if (ties_.size() == 1 && ties_.front().is_contact()) {
    renew(g, arithmetic_.now().lo);
    return;
  }
  if (std::find(changed_.begin(), changed_.end(), g) == changed_.end()) changed_.push_back(g);
  const auto look = [&](GenId other) {
    const auto [i, j] = std::minmax(g, other);
    if (arithmetic_.certainly_apart(i, j)) return;
    ++stats_.contact_searches;
    if (arithmetic_.contact_from_now(i, j, horizon_up_).kind == NextContact::Kind::now) {
      due_.insert({i, j});
    }
  };
  if (cells_.is_near_wall(g)) look(container_id);
  cells_.each_near(g, look);
}

// The disk has another motion since t: searches for its contacts with all that it may touch.
void Leader::renew(GenId g, double t) {
  await_leaving(g, t);
  if (cells_.is_near_wall(g)) search(g, container_id);
  search_near(g, -1);
}

// The disk leaves its square at t: searches for its contacts with those that come to be near. Of
// the others their next contact is known, wherever it is.
void Leader::leave(GenId g, double t) {
  const int before = cells_.place(g, t);
  await_leaving(g, t);
  if (cells_.is_near_wall(g) && !cells_.was_near_wall(before)) search(g, container_id);
  search_near(g, before);
}

// Those that NearCells::each_near() visits.
void Leader::search_near(GenId g, int before) {
  near_disks_.clear();
  cells_.each_near(
      g,
      [&](GenId other) {
        __builtin_prefetch(&motion_.doubles(other));
        near_disks_.push_back(other);
      },
      before);
  for (const GenId other : near_disks_) search(g, other);
}

void Leader::await_leaving(GenId g, double t) {
  const double end = cells_.leaves(g, t);
  ++stays_[g];
  if (end < horizon_up_) queue_.push({end, end, end, g, kLeaves, 0, stays_[g]});
}

void Leader::search(GenId g, GenId other) {
  const auto [i, j] = std::minmax(g, other);
  ++stats_.contact_searches;
  const NextContact c = arithmetic_.contact_from_now(i, j, horizon_up_);
  if (c.kind == NextContact::Kind::none) return;
  ++stats_.predicted_collisions;
  if (c.kind == NextContact::Kind::at) {
    queue_.push({c.lo, c.lo, c.hi, i, j, motion_.state_id(i), motion_.state_id(j)});
  } else if (is_settled_) {
    throw Undecided("a contact was not foreseen", i, j);
  } else {
    due_.insert({i, j});
  }
}

}  // namespace voroproof::internal
