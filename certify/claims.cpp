#include "certify/claims.h"

#include <algorithm>

#include "history/error.h"

namespace voroproof::internal {

std::array<GenId, 2> turned_by(const Event& event) {
  if (const auto* c = std::get_if<CollideEvent>(&event)) return {c->i, c->j};
  if (const auto* m = std::get_if<ManeuverEvent>(&event)) return {m->disk, container_id};
  return {container_id, container_id};
}

bool turn_one_disk(const Event& a, const Event& b) {
  for (const GenId g : turned_by(a)) {
    for (const GenId h : turned_by(b)) {
      if (g != container_id && g == h) return true;
    }
  }
  return false;
}

bool Claims::wants_more() {
  if (ended_ || near_.empty()) return !ended_;
  if (near_.size() >= most_near_) return false;
  const ReadAhead::Claim* const claim = next_of_kinds();
  return claim != nullptr && time(claim->event()) <= time(near_.front().event) + 2 * tolerance_;
}

ReadAhead::Claim* Claims::next() {
  ReadAhead::Claim* const claim = ahead_.first();
  read_to_ = claim != nullptr ? claim->line : history().line();
  return claim;
}

ReadAhead::Claim* Claims::next_of_kinds() {
  ReadAhead::Claim* claim = next();
  while (claim != nullptr && kinds_ == EventKinds::collisions &&
         std::holds_alternative<FlipEvent>(claim->event())) {
    ++passed_over_;
    ahead_.drop_first();
    claim = next();
  }
  return claim;
}

bool Claims::read() {
  ReadAhead::Claim* const claim = next_of_kinds();
  if (claim == nullptr) {
    ended_ = true;
    return false;
  }
  const double t = time(claim->event());
  const bool overlooked = full_ && t <= taken_ + 2 * tolerance_;
  near_.emplace_back(std::move(claim->event()), claim->line, place_ahead(0).half, overlooked);
  times_.push_back(t);
  lines_.push_back(claim->line);
  ahead_.drop_first();
  // The places were written by whoever dealt out the part, perhaps another processor.
  const std::size_t soon = times_.size() + 16;
  if (soon < places_.size()) __builtin_prefetch(&places_[soon]);
  return true;
}

void Claims::take(std::size_t k) {
  full_ = near_.size() == most_near_;
  taken_ = time(near_.front().event);
  current_ = std::move(near_[k].event);
  line_ = near_[k].line;
  place_ = near_[k].place;
  tie_ = near_[k].tie;
  placed_ = near_[k].placed;
  overlooked_ = near_[k].overlooked;
  near_.erase(near_.begin() + static_cast<std::ptrdiff_t>(k));
}

void Claims::end_at(double t) {
  stand_at(read_to_);
  taken_ = std::max(taken_, t);
}

bool Claims::may_depend_on_others() {
  const auto undecided = [](const Claim& c) { return c.placed && !c.moment; };
  if (std::any_of(near_.begin(), near_.end(), undecided)) return true;
  if (!full_) return false;
  try {
    return !ended_ && read() && near_.back().overlooked;
  } catch (const InputError&) {
    return true;
  }
}

bool Claims::has_unchecked(const Rational& until, const std::function<bool(const Event&)>& is_it) {
  if (current_ && is_it(*current_)) return true;
  for (const Claim& c : near_) {
    if (is_it(c.event)) return true;
  }
  const double latest = round_up(until);
  try {
    while (near_.empty() || time(near_.back().event) <= latest) {
      ReadAhead::Claim* const claim = next();
      if (claim == nullptr) {
        // A file that stops early may stop before it.
        const auto* stop = std::get_if<HistoryStop>(&history().ending());
        return stop != nullptr && stop->t <= latest;
      }
      near_.emplace_back(std::move(claim->event()), claim->line, -1, false);
      times_.push_back(time(near_.back().event));
      lines_.push_back(claim->line);
      ahead_.drop_first();
      if (is_it(near_.back().event)) return true;
    }
    return false;
  } catch (const InputError&) {
    return true;
  }
}

std::int64_t Claims::line_at(double t) const {
  const auto it = std::upper_bound(times_.begin(), times_.end(), t);
  return it == times_.end() ? read_to_ : lines_[it - times_.begin()];
}

std::int64_t Claims::proved_before(double t) const {
  const auto it = std::lower_bound(times_.begin(), times_.end(), t);
  return std::min<std::int64_t>(it - times_.begin(), processed_);
}

}  // namespace voroproof::internal
