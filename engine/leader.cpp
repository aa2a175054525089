#include "engine/leader.h"

#include <algorithm>

#include "exact/patience.h"

namespace voroproof::internal {

namespace {

// Where between two instants a slice ends: at no place that symmetry might prefer.
constexpr double kPart = 0.6180339887;

}  // namespace

Leader::Leader(MotionInput input, std::vector<ManeuverInput> maneuvers,
               const MotionOptions& options)
    : OwnMotion{ComputedMotion(std::move(input), options)},
      Turning(motion_, arithmetic_, due_, stats_, false),
      arithmetic_(motion_, stats_),
      maneuvers_(std::move(maneuvers), motion_.input().horizon),
      horizon_(motion_.input().horizon),
      horizon_up_(round_up(horizon_)),
      cells_(motion_),
      stays_(motion_.size(), 0) {}

std::optional<double> Leader::lead(LedTurns& turns, std::uint64_t work,
                                   const std::function<double(double, double)>& border) {
  turns_ = &turns;
  const std::uint64_t end = work_ + work;
  if (!std::exchange(started_, true)) start();
  while (step()) {
    if (work_ < end) continue;
    const double hi = arithmetic_.now().hi, lo = head()->key;
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
  due_.maneuvers = maneuvers_.has_next() && sgn(maneuvers_.next_time()) == 0;
  if (!due_.maneuvers) await_maneuvers();
  put_back({Moment::at(horizon_), kHorizon});
  process_turns();
}

// ---- What next_instant() asks of a source. ----

bool Leader::is_stale(const Entry& e) const {
  if (e.j < kLeaves) return false;
  if (e.j == kLeaves) return stays_[e.i] != e.state_j;
  return motion_.state_id(e.i) != e.state_i || motion_.state_id(e.j) != e.state_j;
}

const Leader::Entry* Leader::head() {
  for (;;) {
    const Entry* const e = queue_.top([this](const Entry& entry) { return is_stale(entry); });
    if (e == nullptr || !is_stale(*e)) return e;
    queue_.pop();
  }
}

bool Leader::is_near(double bound) {
  for (;;) {
    const Entry* const next = head();
    if (next == nullptr || next->key > bound) return false;
    Patience::ask();
    if (next->j != kLeaves && !is_tied(*next)) return true;
    const Entry e = *next;
    queue_.pop();
    if (e.j != kLeaves) continue;
    leave(e.i, e.key);
    ++work_;
  }
}

std::optional<FoundEvent> Leader::take() {
  const Entry e = *head();
  queue_.pop();
  return FoundEvent(e.j == kManeuvers ? Moment::at(maneuvers_.next_time())
                    : e.j == kHorizon ? Moment::at(horizon_)
                                      : Moment::of(e.i, e.j, e.lo, e.hi),
                    e.j);
}

void Leader::put_back(const FoundEvent& e) {
  const bool contact = e.is_contact();
  queue_.push({e.lo, e.lo, e.hi, e.i, e.item, contact ? motion_.state_id(e.i) : 0,
               contact ? motion_.state_id(e.j) : 0});
}

void Leader::await_maneuvers() {
  if (maneuvers_.has_next()) put_back({Moment::at(maneuvers_.next_time()), kManeuvers});
}

std::vector<ManeuverInput> Leader::take_maneuvers() {
  const std::vector<ManeuverInput> together = maneuvers_.take();
  await_maneuvers();
  return together;
}

bool Leader::is_tied(const Entry& entry) const {
  return std::any_of(ties_.begin(), ties_.end(), [&](const FoundEvent& e) {
    return e.is_contact() && e.i == entry.i && e.j == entry.j;
  });
}

// ---- One instant; false if it is the horizon. ----
bool Leader::step() {
  if (!next_instant(arithmetic_, *this, ties_, near_)) return false;
  const FoundEvent& first = ties_.front();
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
  tells_time_ = !first.tight;
  if (first.tight) turns_->last().t = arithmetic_.rounded(first);
  for (const FoundEvent& e : ties_) {
    if (e.is_contact()) due_.contacts.insert({e.i, e.j});
    due_.maneuvers |= e.item == kManeuvers;
  }
  process_turns();
  return !horizon;
}

void Leader::process_turns() {
  process_due();
  arithmetic_.after_changes();
  is_settled_ = true;
  for (const GenId g : changed_) renew(g, arithmetic_.now().lo);
  changed_.clear();
}

void Leader::tell_collision(GenId i, GenId j, const Impact& impact, bool lone) {
  if (lone) {
    turns_->last().t = impact.t;
    turns_->last().time = impact.time_dd;
    turns_->last().tells_time = true;
  }
  turns_->add(motion_.led(i, j, impact.first, impact.second));
  ++work_;
}

void Leader::tell_maneuver(GenId disk, const RoundedState& rounded) {
  turns_->add(motion_.led(disk, disk, rounded, rounded));
  ++work_;
}

// Where nothing else is at the instant, the disk is searched for at once; else what it touches and
// approaches now is, and all else when the instant's velocities are settled: with some of them most
// searches would be for nothing, and harder than those that count.
void Leader::look_around(GenId g) {
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
      due_.contacts.insert({i, j});
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
    due_.contacts.insert({i, j});
  }
}

}  // namespace voroproof::internal
