#include "certify/turn_order.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "certify/wording.h"

namespace voroproof::internal {

namespace {

using Pair = std::pair<GenId, GenId>;
using States = DuePairs::States;

// The number of pairs due at one instant that keep the witness of it.
constexpr std::size_t kMostWitnesses = 256;

bool is_maneuver(const Turn& t) { return t.i == t.j; }

std::string text_of(const Turn& t) {
  if (is_maneuver(t)) return "the maneuver of disk " + std::to_string(t.i);
  return "the collision of generators " + voroproof::internal::text_of(t.i, t.j);
}

// Takes the turns of one instant again, in the order that the format gives them. What happens to
// each disk has to be what the claims say of it, one after the other: then the claims are the true
// ones, perhaps with some exchanged that share no disk.
class InstantReplay {
 public:
  // `near`: all pairs that touch, perhaps with others; `due`: those that are known to be due.
  // `complete`: no other turns are claimed; else `untold` are the disks of maneuvers that are not.
  InstantReplay(Setting& s, const Front& front, const std::vector<Turn>& turns,
                const std::vector<Pair>& near, const std::vector<DuePair>& due, bool complete,
                std::vector<GenId> untold)
      : s_(s),
        turns_(turns),
        complete_(complete),
        untold_(std::move(untold)),
        pairs_(s, front, turns) {
    std::set<Pair> pairs(near.begin(), near.end());
    for (const Turn& t : turns) {
      for (const GenId g : {t.i, t.j}) {
        if (g == container_id) continue;
        std::vector<const Turn*>& of = chains_[g].turns;
        if (of.empty() || of.back() != &t) of.push_back(&t);
      }
      if (!is_maneuver(t)) pairs.emplace(t.i, t.j);
    }
    for (const auto& [i, j] : pairs) {
      near_[i].push_back(j);
      near_[j].push_back(i);
    }
    for (const DuePair& d : due) known_due_.emplace(States{d.i, d.j, d.state_i, d.state_j}, &d);
    for (const auto& [g, chain] : chains_) find_due(g);
  }

  // The first turn that is missing or in a wrong place; nothing where all are right. Throws
  // Undecided.
  std::optional<Divergence> fault() {
    if (auto early = collide()) return early;
    for (const Turn& t : turns_) {
      if (is_maneuver(t) && head(t.i) == &t) ++chains_.at(t.i).taken;
    }
    for (const Turn& t : turns_) {
      if (is_maneuver(t)) find_due(t.i);
    }
    for (const GenId g : untold_) stand(g);
    if (auto early = collide()) return early;
    for (const Turn& t : turns_) {
      if (head(t.j) == &t) return misplaced(t, text_of(t) + " at the same instant comes earlier");
    }
    return std::nullopt;
  }

  // The first turn that is missing or in a wrong place before the last claim. Throws Undecided.
  std::optional<Divergence> fault_before_last() {
    last_ = &turns_.back();
    return collide();
  }

 private:
  // Takes collisions, the smallest pair first, while any is due, and until the last is.
  std::optional<Divergence> collide() {
    while (!due_.empty()) {
      const Pair pair = *due_.begin();
      if (last_ != nullptr && is_next(pair) && head(pair.second) == last_) break;
      if (is_next(pair)) {
        take(*head(pair.second));
      } else if (complete_ || !stand(pair)) {
        return early(pair);
      }
    }
    return std::nullopt;
  }

  // The turns of a disk.
  struct Chain {
    std::vector<const Turn*> turns;
    std::size_t taken = 0;
  };

  // The next turn of a generator, or null.
  const Turn* head(GenId g) const {
    const auto it = chains_.find(g);
    if (it == chains_.end() || it->second.taken == it->second.turns.size()) return nullptr;
    return it->second.turns[it->second.taken];
  }
  // The present state of a generator.
  int state(GenId g) const {
    const Turn* const next = head(g);
    if (next == nullptr) return s_.motion.state_id(g);
    return g == next->i ? next->state_i : next->state_j;
  }
  States states(const Pair& pair) const {
    return {pair.first, pair.second, state(pair.first), state(pair.second)};
  }
  // The collision of the pair is the next turn of both.
  bool is_next(const Pair& pair) const {
    const Turn* const next = head(pair.second);
    return next != nullptr && Pair(next->i, next->j) == pair &&
           (pair.first == container_id || head(pair.first) == next);
  }
  // The pair is due, and one of its disks turns in another way first, or not at all.
  Divergence early(const Pair& pair) const {
    const auto [i, j] = pair;
    const auto is_of_pair = [&](const Turn& t) { return Pair(t.i, t.j) == pair; };
    const auto known = known_due_.find(states(pair));
    // Before a claim that is false it is missing, whether it is claimed at another place or not.
    const bool missing = last_ != nullptr || std::none_of(turns_.begin(), turns_.end(), is_of_pair);
    if (known != known_due_.end() && missing) return known->second->missing;
    const Turn* const next = head(j) != nullptr ? head(j) : head(i);
    Divergence d = misplaced(next != nullptr ? *next : turns_.back(),
                             "generators " + voroproof::internal::text_of(i, j) +
                                 " touch and approach at the same instant and come first");
    d.true_contact = pair;
    if (last_ != nullptr) d.fault = Fault::missing_event;
    return d;
  }
  Divergence misplaced(const Turn& t, std::string truth) const {
    Divergence d;
    d.fault = Fault::wrong_order;
    d.line = t.line;
    d.t = time(t.claim);
    d.claim = t.claim;
    d.truth = std::move(truth);
    return d;
  }
  void take(const Turn& turn) {
    for (const GenId g : {turn.i, turn.j}) {
      if (g != container_id) ++chains_.at(g).taken;
    }
    for (const GenId g : {turn.i, turn.j}) {
      if (g != container_id) find_due(g);
    }
  }

  // One of the two disks, at least, has no further claim: it may have turned before, untold.
  bool stand(const Pair& pair) {
    bool any = false;
    for (const GenId g : {pair.first, pair.second}) {
      if (g == container_id || head(g) != nullptr) continue;
      stand(g);
      any = true;
    }
    return any;
  }
  // Nothing more is known of the disk.
  void stand(GenId g) {
    if (g == container_id) return;
    standing_.insert(g);
    find_due(g);
  }

  void find_due(GenId g) {
    const auto it = near_.find(g);
    if (it == near_.end()) return;
    for (const GenId other : it->second) {
      const Pair pair = std::minmax(g, other);
      if (!standing_.contains(g) && !standing_.contains(other) && is_due(pair)) {
        due_.insert(pair);
      } else {
        due_.erase(pair);
      }
    }
  }
  // Whether the two touch and approach as they are now. Of states that they were in between two of
  // the claims this is known: they collided next, or their life told of it when it ended.
  bool is_due(const Pair& pair) {
    const auto [i, j] = pair;
    if (is_next(pair) || known_due_.contains(states(pair))) return true;
    return !were_claimed(i, j) && pairs_.is_due(states(pair));
  }
  // Whether the two are in their present states at one time between claims, or before or after all.
  bool were_claimed(GenId i, GenId j) const {
    return std::max(begin(i), begin(j)) <= std::min(end(i), end(j));
  }
  // The present state of a generator holds after `begin` claims of the instant, up to `end`.
  std::ptrdiff_t begin(GenId g) const {
    const auto it = chains_.find(g);
    if (it == chains_.end() || it->second.taken == 0) return 0;
    return it->second.turns[it->second.taken - 1] - turns_.data() + 1;
  }
  std::ptrdiff_t end(GenId g) const {
    const Turn* const next = head(g);
    return next == nullptr ? std::ssize(turns_) : next - turns_.data();
  }
  const Setting& s_;
  const std::vector<Turn>& turns_;
  const bool complete_;
  const Turn* last_ = nullptr;  // is not taken
  const std::vector<GenId> untold_;
  DuePairs pairs_;
  std::map<GenId, Chain> chains_;  // by disk that turns
  std::map<GenId, std::vector<GenId>> near_;
  std::map<States, const DuePair*> known_due_;
  std::set<GenId> standing_;
  std::set<Pair> due_;
};

}  // namespace

void TurnOrder::note_due(GenId i, GenId j, Divergence missing) {
  // A lattice that touches everywhere at once would fill the memory with witnesses.
  if (due_.size() >= kMostWitnesses) missing.witness = {};
  due_.push_back({i, j, s_.motion.state_id(i), s_.motion.state_id(j), std::move(missing)});
}

void TurnOrder::note_at_start(GenId i, GenId j) {
  const Moment now = s_.chronology.present(Moment::at(Rational(0)));
  for (const GenId g : {i, j}) {
    if (g == container_id) continue;
    for (GenId other = container_id; other < s_.motion.size(); ++other) {
      const auto [a, b] = std::minmax(g, other);
      if (a == b || Pair(a, b) == Pair(i, j) || s_.contacts.certainly_apart(a, b, now)) continue;
      note_near(a, b);
      if (s_.replay.partners(a, b)) continue;
      if (s_.contacts.from(a, b, now, 0).kind == NextContact::Kind::now) {
        note_due(a, b, refuter_.missing_contact(a, b, 0, 0));
      }
    }
    if (i == j) break;
  }
}

void TurnOrder::begin(GenId i, GenId j, std::int64_t line, Event claim) {
  const auto velocity = [this](GenId g) {
    const DdMotion m = s_.motion.double_doubles(g);
    return std::array{m.vx, m.vy};
  };
  begun_ = Turn{i,
                j,
                s_.motion.state_id(i),
                s_.motion.state_id(j),
                {velocity(i), velocity(j)},
                line,
                std::move(claim)};
}

std::optional<Divergence> TurnOrder::due_before() const {
  if (!begun_) return std::nullopt;
  std::vector<Turn> turns = turns_;
  turns.push_back(*begun_);
  try {
    auto due = InstantReplay(s_, front_, turns, near_, due_, false, {}).fault_before_last();
    if (due) due->line = begun_->line;
    return due;
  } catch (const Undecided&) {
    return std::nullopt;
  }
}

void TurnOrder::require_order(bool complete) {
  if (turns_.size() > 1 || (turns_.size() == 1 && !due_.empty())) {
    if (s_.options.accepts_other_orders()) {
      try {
        if (fault(complete)) ++s_.certificate.other_orders;
      } catch (const Undecided&) {
        ++s_.certificate.other_orders;
      }
    } else if (auto wrong = fault(complete)) {
      if (complete && wrong->fault == Fault::wrong_order) throw Refuted{named(*std::move(wrong))};
      throw Refuted{*std::move(wrong)};
    }
  }
  turns_.clear();
  near_.clear();
  due_.clear();
}

// The first turn that is not in the format's order.
std::optional<Divergence> TurnOrder::fault(bool complete) const {
  std::vector<GenId> untold = complete ? std::vector<GenId>() : untold_maneuvers();
  return InstantReplay(s_, front_, turns_, near_, due_, complete, std::move(untold)).fault();
}

// A wrong order by its right name: nothing but that, where no pair is left that still approaches.
Divergence TurnOrder::named(Divergence wrong_order) const {
  try {
    if (auto left = left_due()) return *std::move(left);
  } catch (const Undecided&) {
    return wrong_order;
  }
  wrong_order.fault = Fault::other_order;
  return wrong_order;
}

// A pair that touches and approaches after all turns of the present instant.
std::optional<Divergence> TurnOrder::left_due() const {
  std::vector<Pair> pairs = near_;
  for (const Turn& t : turns_) {
    if (t.i != t.j) pairs.emplace_back(t.i, t.j);
  }
  const Moment now = s_.chronology.present(front_.moment);
  for (const auto& [i, j] : pairs) {
    if (s_.replay.partners(i, j) || s_.contacts.certainly_apart(i, j, now)) continue;
    if (s_.contacts.from(i, j, now, now.hi).kind == NextContact::Kind::now) {
      return refuter_.missing_contact(i, j, now.lo, now.hi);
    }
  }
  return std::nullopt;
}

// The disks that have a maneuver at the present instant which is not claimed.
std::vector<GenId> TurnOrder::untold_maneuvers() const {
  std::vector<GenId> untold;
  for (std::size_t k = s_.replay.next_maneuver(); k < s_.scene.maneuvers.size(); ++k) {
    const Maneuver& m = s_.scene.maneuvers[k];
    if (s_.replay.maneuver_done(k)) continue;
    const int order = s_.chronology.compare(Moment::at(m.t), front_.moment);
    if (order > 0) break;
    if (order == 0) untold.push_back(m.disk);
  }
  return untold;
}

}  // namespace voroproof::internal
