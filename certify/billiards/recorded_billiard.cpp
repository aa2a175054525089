#include "certify/billiards/recorded_billiard.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "certify/billiards/billiard_window.h"
#include "certify/billiards/bounce_law.h"
#include "certify/billiards/pair_watch.h"
#include "certify/on_threads.h"
#include "exact/patience.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {
namespace {

CompactVec3 compact(const Vec3& v) { return {v[0], v[1], v[2]}; }

class RecordedBilliard final : public BilliardTruth {
 public:
  RecordedBilliard(const Billiard& billiard, const Rational& horizon, const CertifyOptions& options)
      : billiard_(billiard),
        near_horizon_(Rational(horizon - options.tolerance)),
        threads_(options.threads),
        extent_(extent_of(billiard)),
        watch_(billiard, horizon, options.tolerance, extent_, options.motion.filters),
        law_(billiard, watch_.exact(), watch_.near(), options.tolerance, options.law_tolerance,
             extent_, options.motion.filters),
        meeting_(billiard, watch_.near()) {
    for (const BilliardDisk& disk : billiard.disks) paths_.emplace_back(disk, billiard.gravity);
  }

  Rational lag() const override { return 0; }
  void begin() override {
    const BilliardTime start(0);
    meeting_.in(paths_, start, start);  // for the length of the first window
  }
  double good_length() const override { return meeting_.good_length(); }
  BilliardFindings& found() override { return found_; }

  void maneuver(const BilliardTurn& claimed, const BilliardManeuver& due,
                const BilliardClaim& at) override {
    const Vec3 v = claimed.v ? value_of(*claimed.v) : due.velocity;
    if (claimed.p) {
      const std::string fault =
          law_.fault_of_place(claimed.disk, paths_[static_cast<std::size_t>(claimed.disk)], at.t,
                              value_of(*claimed.p), v);
      if (!fault.empty()) blame(Fault::wrong_response, at, fault);
    }
    turn(claimed.disk, at, compact(v), std::nullopt);
  }

  void collide(const BilliardCollision& claimed, const BilliardClaim& at) override {
    const BilliardTime& t = at.t;
    BilliardPair pair{claimed.a, claimed.b, claimed.image ? *claimed.image : LatticeImage{}};
    const BilliardPath& b = paths_[static_cast<std::size_t>(pair.b)];
    const BilliardPath& a = pair.a < 0 ? b : paths_[static_cast<std::size_t>(pair.a)];
    if (!claimed.image && billiard_.lattice.is_periodic())
      pair.image = watch_.images().nearest(pair, a.exact_last(), b.exact_last(), t.value());
    claims_.emplace_back(pair, at);
    const BounceLaw::Meeting meeting{pair, a, b, t};
    if (const std::string fault = law_.fault(meeting, claimed); !fault.empty())
      blame(Fault::wrong_response, at, fault, std::pair(pair.a, pair.b));
    std::array<std::optional<CompactVec3>, 2> v = claimed.v;
    const auto has_none = [&](int side) {
      const GenId disk = side == 0 ? pair.a : pair.b;
      return disk >= 0 && !billiard_.disks[static_cast<std::size_t>(disk)].fixed && !v[side];
    };
    if (has_none(0) || has_none(1)) {
      ++found_.computed_velocities;
      const std::array<Vec3, 2> law = law_.after(meeting);
      for (const int side : {0, 1}) {
        if (!has_none(side)) continue;
        v[side].emplace();
        for (std::size_t k = 0; k < 3; ++k)
          (*v[side])[k] = round_nearest(law[static_cast<std::size_t>(side)][k]);
      }
    }
    if (!(t.exact < near_horizon_)) ++found_.at_horizon;
    if (pair.a >= 0) turn(pair.a, at, v[0] ? *v[0] : CompactVec3{}, pair);
    turn(pair.b, at, v[1] ? *v[1] : CompactVec3{}, pair);
  }

  void follow(const BilliardWindow& window) override {
    std::stable_sort(claims_.begin(), claims_.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    std::vector<BilliardPair> pairs = meeting_.in(paths_, window.from, window.to);
    meeting_.adapt(pairs.size());
    const std::size_t meeting = pairs.size();
    for (const auto& [pair, claim] : claims_) pairs.push_back(pair);
    for (const auto& [pair, state] : states_) pairs.push_back(pair);
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(meeting), pairs.end());
    std::inplace_merge(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(meeting),
                       pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    follow(pairs, window);
    claims_.clear();
    for (BilliardPath& path : paths_) path.forget_all_but_last();
  }

 private:
  void turn(GenId disk, const BilliardClaim& at, const CompactVec3& v,
            const std::optional<BilliardPair>& by) {
    if (!billiard_.disks[static_cast<std::size_t>(disk)].fixed)
      paths_[static_cast<std::size_t>(disk)].turn(at.t, v, at.number, by);
  }

  void blame(Fault kind, const BilliardClaim& at, std::string truth,
             std::optional<std::pair<GenId, GenId>> contact = {}) {
    found_.faults.push_back({kind, at.line, at.t.near.mid, std::move(truth), contact});
  }

  // Pairs that one thread follows, and what it finds.
  struct Block {
    BilliardFindings found;
    std::vector<std::pair<BilliardPair, PairState>> states;  // as they are now, where they changed
    std::optional<Undecided> undecided;                      // the first pair's that is
  };

  // Finds the same as one pair after another would, whatever the number of threads.
  void follow(const std::vector<BilliardPair>& pairs, const BilliardWindow& window) {
    constexpr std::size_t least = 256;
    const std::size_t most = threads_ == 1 ? 1 : 4 * static_cast<std::size_t>(threads_);
    std::vector<Block> blocks(std::clamp<std::size_t>(pairs.size() / least, 1, most));
    on_threads(blocks.size(), threads_, [&](std::size_t b) {
      const auto at = [&](std::size_t k) {
        return pairs.data() + pairs.size() * k / blocks.size();
      };
      follow({at(b), at(b + 1)}, window, blocks[b]);
    });
    std::optional<Undecided> undecided;  // a fault of another pair is one nevertheless
    for (Block& block : blocks) {
      found_.add(block.found);
      if (!undecided && block.undecided) undecided.emplace(*block.undecided);
      for (auto& [pair, state] : block.states) {
        if (state.is_empty())
          states_.erase(pair);
        else
          states_[pair] = std::move(state);
      }
    }
    if (undecided && found_.faults.empty()) throw Undecided(*undecided);
  }

  void follow(std::span<const BilliardPair> pairs, const BilliardWindow& window,
              Block& block) const {
    if (pairs.empty()) return;
    auto claim = std::lower_bound(claims_.begin(), claims_.end(), pairs.front(),
                                  [](const auto& x, const BilliardPair& y) { return x.first < y; });
    std::vector<BilliardClaim> own;
    for (const BilliardPair& pair : pairs) {
      Patience::ask();
      own.clear();
      for (; claim != claims_.end() && claim->first == pair; ++claim) own.push_back(claim->second);
      const auto known = states_.empty() ? states_.end() : states_.find(pair);
      PairState state = known == states_.end() ? PairState{} : known->second;
      const BilliardPath& b = paths_[static_cast<std::size_t>(pair.b)];
      try {
        watch_.follow(pair, pair.a < 0 ? b : paths_[static_cast<std::size_t>(pair.a)], b, own,
                      window, meeting_, state, block.found);
      } catch (const Undecided& why) {
        if (!block.undecided) block.undecided.emplace(why);
      }
      if (known != states_.end() || !state.is_empty())
        block.states.emplace_back(pair, std::move(state));
    }
  }

  const Billiard& billiard_;
  CompactRational near_horizon_;  // by the tolerance
  int threads_;
  Rational extent_;
  PairWatch watch_;
  BounceLaw law_;
  MeetingPairs meeting_;
  // The claims of the window, by pair.
  std::vector<std::pair<BilliardPair, BilliardClaim>> claims_;
  std::vector<BilliardPath> paths_;
  std::map<BilliardPair, PairState> states_;
  BilliardFindings found_;
};

}  // namespace

Rational extent_of(const Billiard& billiard) {
  Rational extent;
  for (const BilliardDisk& disk : billiard.disks) {
    for (const Rational& x : disk.center) {
      extent = std::max<Rational>(extent, abs(x) + disk.radius);
    }
  }
  Rational frame;
  if (billiard.round) {
    for (const Rational& x : billiard.round->center) frame = std::max<Rational>(frame, abs(x));
    frame += billiard.round->radius;
  }
  for (const BilliardWall& wall : billiard.walls)
    frame = std::max<Rational>(frame, abs(wall.offset));
  for (const Rational& side : billiard.lattice.sides) extent += side;
  return extent + frame;
}

std::unique_ptr<BilliardTruth> recorded_billiard(const Billiard& billiard, const Rational& horizon,
                                                 const CertifyOptions& options) {
  return std::make_unique<RecordedBilliard>(billiard, horizon, options);
}

}  // namespace voroproof::internal
