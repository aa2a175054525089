#include "certify/billiards/true_instant.h"

#include <algorithm>

#include "filtered/billiards/line_boxes.h"
#include "history/json_text.h"

namespace voroproof::internal {

TrueInstant::TrueInstant(const Billiard& billiard, const BilliardMotion& motion, const Rational& t,
                         const std::set<BilliardPair>& touching)
    : billiard_(billiard), motion_(motion), t_(t), touching_(touching) {
  for (const BilliardPair& pair : touching) {
    waiting_.push_back(pair.a);
    waiting_.push_back(pair.b);
  }
  for (; !waiting_.empty(); waiting_.pop_front()) add(waiting_.front());
}

// With those with which it collides then.
void TrueInstant::add(GenId disk) {
  if (disk < 0 || chains_.count(disk) != 0) return;
  Chain& chain = chains_[disk];
  const TrueLine* before = nullptr;
  for (const TrueLine& line : motion_.paths()[static_cast<std::size_t>(disk)]) {
    const Sign then = order(line.from, motion_.time(t_));
    if (then == Sign::unknown) throw TooCoarse("which of two events comes first is not told");
    if (then == Sign::negative || (then == Sign::zero && line.claim < 0)) {
      before = &line;
    } else if (then == Sign::zero) {
      chain.turns.push_back(&line);
      last_line_ = std::max(last_line_, line.line);
      if (!line.by) continue;
      touching_.insert(*line.by);
      waiting_.push_back(line.by->a);
      waiting_.push_back(line.by->b);
    }
  }
  if (before == nullptr || !before->exact)
    throw Undecided("the order of the turns at t = " + number_text(round_nearest(t_)) +
                        " is not told in fractions",
                    disk, disk);
  chain.place = motion_.exact().place(disk, *before->exact, t_);
  chain.velocity = motion_.exact().velocity(disk, *before->exact, t_);
}

bool TrueInstant::approach(const BilliardPair& pair) const {
  if (motion_.is_fixed(pair.a) && motion_.is_fixed(pair.b)) return false;
  const auto flight = [&](GenId disk) {
    const Chain& chain = chains_.at(disk);
    return Flight<Rational>{t_, chain.place, chain.velocity};
  };
  const Flight<Rational> b = flight(pair.b);
  return motion_.exact().form(pair, pair.a < 0 ? b : flight(pair.a), b, t_, 0)[1] < 0;
}

void TrueInstant::take(GenId disk) {
  if (motion_.is_fixed(disk)) return;
  Chain& chain = chains_.at(disk);
  const TrueLine& line = *chain.head();
  if (!line.exact)
    throw Undecided("the order of the turns at t = " + number_text(round_nearest(t_)) +
                        " is not told in fractions",
                    disk, disk);
  chain.velocity = line.exact->v;
  ++chain.taken;
}

BilliardFault TrueInstant::misplaced(std::int64_t line, const std::string& truth,
                                     const BilliardPair& pair) const {
  return {
      Fault::wrong_order, line, round_nearest(t_),
      truth + " at t = " + number_text(round_nearest(t_)) + ", which comes first at that instant",
      std::pair(pair.a, pair.b)};
}

// Collisions, the smallest pair first, while any touch and approach.
std::optional<BilliardFault> TrueInstant::collide() {
  for (;;) {
    const auto due = std::find_if(touching_.begin(), touching_.end(),
                                  [&](const BilliardPair& pair) { return approach(pair); });
    if (due == touching_.end()) return std::nullopt;
    const TrueLine *a = head(due->a), *b = head(due->b);
    if (!motion_.have_met(*due, a, b)) {
      const TrueLine* const instead = b != nullptr ? b : a;
      const std::string truth = name_of(billiard_, *due) + " touch and approach";
      if (instead != nullptr) return misplaced(instead->line, truth, *due);
      return BilliardFault{
          Fault::missing_event, last_line_ + 1, round_nearest(t_),
          truth + " at t = " + number_text(round_nearest(t_)) + "; no collision of them is claimed",
          std::pair(due->a, due->b)};
    }
    take(due->a);
    take(due->b);
  }
}

std::optional<BilliardFault> TrueInstant::maneuver() {
  for (const BilliardManeuver& maneuver : billiard_.maneuvers) {
    if (maneuver.t != t_ || chains_.count(maneuver.disk) == 0) continue;
    const TrueLine* const next = head(maneuver.disk);
    if (next == nullptr || next->by)
      return misplaced(next != nullptr ? next->line : last_line_,
                       "disk " + std::to_string(maneuver.disk) + " has a maneuver",
                       {maneuver.disk, maneuver.disk});
    take(maneuver.disk);
  }
  return std::nullopt;
}

std::optional<BilliardFault> TrueInstant::fault() {
  if (auto early = collide()) return early;
  if (auto early = maneuver()) return early;
  if (auto early = collide()) return early;
  for (const auto& [disk, chain] : chains_) {
    if (const TrueLine* const left = chain.head())
      return misplaced(left->line, "disk " + std::to_string(disk) + " has other turns",
                       {disk, disk});
  }
  return std::nullopt;
}

}  // namespace voroproof::internal
