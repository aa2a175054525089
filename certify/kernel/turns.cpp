#include "certify/kernel/turns.h"

namespace voroproof_kernel {

namespace {

std::string name(Two two) {
  if (two.first == two.second) return "the maneuver of disk " + std::to_string(two.first);
  return "generators " + std::to_string(two.first) + " and " + std::to_string(two.second);
}

}  // namespace

// The turns, taken one after the other.
class Turns::Replay {
 public:
  Replay(const Turns& of, const Rat& t) : of_(of), t_(t) {
    for (const auto& [g, touching] : of.touching_) look_at(g);
  }

  std::optional<Fault> fault() {
    if (const auto early = collide()) return early;
    for (const Turn& turn : of_.turns_) {
      if (turn.is_maneuver() && head(turn.two.first) == &turn) ++taken_[turn.two.first];
    }
    for (const Turn& turn : of_.turns_) {
      if (turn.is_maneuver()) look_at(turn.two.first);
    }
    if (const auto early = collide()) return early;
    for (const Turn& turn : of_.turns_) {
      if (head(turn.two.second) == &turn)
        return Fault{turn.line, name(turn.two) + " belongs earlier in that instant"};
    }
    return std::nullopt;
  }

 private:
  // Takes collisions, the smallest pair first, while any is due.
  std::optional<Fault> collide() {
    while (!due_.empty()) {
      const Two two = *due_.begin();
      if (!take(two)) return early(two);
      look_at(two.first);
      look_at(two.second);
    }
    return std::nullopt;
  }
  // The next turn of a generator, or null.
  const Turn* head(int g) const {
    const auto chain = of_.chains_.find(g);
    if (chain == of_.chains_.end()) return nullptr;
    const std::size_t taken = taken_of(g);
    return taken < chain->second.turns.size() ? &of_.turns_[chain->second.turns[taken]] : nullptr;
  }
  std::size_t taken_of(int g) const {
    const auto it = taken_.find(g);
    return it == taken_.end() ? 0 : it->second;
  }
  const Leg& leg(int g) const {
    const auto chain = of_.chains_.find(g);
    return chain == of_.chains_.end() ? *of_.standing_.at(g) : *chain->second.legs[taken_of(g)];
  }
  // Which pairs of the disk approach as they are now.
  void look_at(int g) {
    const auto touching = of_.touching_.find(g);
    if (touching == of_.touching_.end()) return;
    for (const Two& two : touching->second) {
      if (sgn(Gap(leg(two.first), leg(two.second)).slope(t_)) == inwards(two)) {
        due_.insert(two);
      } else {
        due_.erase(two);
      }
    }
  }
  // Takes the collision of these two if it is the next turn of both.
  bool take(Two two) {
    const Turn* const next = head(two.second);
    if (next == nullptr || next->two != two) return false;
    if (two.first != container && head(two.first) != next) return false;
    if (two.first != container) ++taken_[two.first];
    ++taken_[two.second];
    return true;
  }
  Fault early(Two two) const {
    const Turn *first = head(two.first), *second = head(two.second);
    const Turn* const at = first != nullptr ? first : second;
    return {at != nullptr ? at->line : of_.turns_.back().line,
            name(two) + " collide before that at the same instant"};
  }

  const Turns& of_;
  const Rat& t_;
  std::map<int, std::size_t> taken_;
  std::set<Two> due_;
};

void Turns::begin(const Claim& c, const std::set<Two>& of, const Walk& before) {
  for (const Two& two : of) {
    for (const int g : {two.first, two.second}) standing_.emplace(g, &before.leg(g));
    if (Gap(before.leg(two.first), before.leg(two.second)).value(c.t) != 0) continue;
    if (two.first != container) touching_[two.first].insert(two);
    touching_[two.second].insert(two);
  }
  for (int k = c.first; k < 2; ++k) {
    Chain& chain = chains_[c.id[k]];
    if (chain.legs.empty()) chain.legs.push_back(&before.leg(c.id[k]));
  }
}

void Turns::end(const Claim& c, const Walk& after) {
  for (int k = c.first; k < 2; ++k) {
    Chain& chain = chains_[c.id[k]];
    chain.turns.push_back(turns_.size());
    chain.legs.push_back(&after.leg(c.id[k]));
  }
  const bool collision = c.kind == Claim::Kind::collision;
  turns_.push_back({{collision ? c.id[0] : c.id[1], c.id[1]}, c.line});
}

std::optional<Turns::Fault> Turns::fault(const Rat& t) const { return Replay(*this, t).fault(); }

}  // namespace voroproof_kernel
