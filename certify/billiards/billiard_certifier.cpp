#include "certify/billiards/billiard_certifier.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <utility>

#include "certify/billiards/billiard_window.h"
#include "certify/billiards/bounce_law.h"
#include "certify/billiards/pair_watch.h"
#include "certify/vectors.h"
#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

CompactVec3 compact(const Vec3& v) { return {v[0], v[1], v[2]}; }

// The size of the scene at time 0, to which roundings of coordinates are in proportion.
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

class BilliardCertification {
 public:
  BilliardCertification(const Billiard& billiard, const std::string& scene_file,
                        BilliardHistoryReader& history, const CertifyOptions& options)
      : billiard_(billiard),
        scene_file_(scene_file),
        history_(history),
        options_(options),
        horizon_(history.header().horizon),
        near_horizon_(horizon_ - options.tolerance),
        extent_(extent_of(billiard)),
        watch_(billiard, horizon_, options.tolerance, extent_, options.motion.filters),
        law_(billiard, watch_.exact(), watch_.near(), options.tolerance, options.law_tolerance,
             extent_, options.motion.filters),
        meeting_(billiard, watch_.near()),
        next_maneuver_(billiard.disks.size()) {}

  Certificate run() {
    start();
    try {
      require_placement();
      now_ = BilliardTime(0);
      meeting_.in(paths_, now_, now_);  // for the length of the first window
      bool more = true;
      while (more && found_.faults.empty()) more = window();
      if (found_.faults.empty()) finish();
    } catch (const Undecided& at) {
      // A refutation stays one.
      if (found_.faults.empty()) {
        certificate_.reason = at.what();
        certificate_.reason_line = line_;
      }
    }
    // The rest is read for its form.
    while (history_.next()) {
    }
    conclude();
    return std::move(certificate_);
  }

 private:
  void start() {
    for (const BilliardDisk& disk : billiard_.disks) paths_.emplace_back(disk, billiard_.gravity);
    for (std::size_t m = 0; m < billiard_.maneuvers.size(); ++m) {
      const BilliardManeuver& maneuver = billiard_.maneuvers[m];
      if (maneuver.t <= horizon_)
        next_maneuver_[static_cast<std::size_t>(maneuver.disk)].push_back(m);
    }
    undone_line_.assign(billiard_.maneuvers.size(), 0);
    if (horizon_ > billiard_.horizon)
      throw InputError(scene_file_, 0, "horizon", "the history goes beyond it");
  }

  // No two overlap at the start, and all are in the frame.
  void require_placement() const {
    const auto pair = find_overlap_at_start(billiard_);
    if (!pair) return;
    const auto [field, why] = placement_fault(billiard_, *pair);
    throw InputError(scene_file_, 0, field, why);
  }

  std::optional<BilliardEvent> take() {
    if (ahead_) return std::exchange(ahead_, std::nullopt);
    return history_.next();
  }

  // Reads and judges the claims of one window; false after the last.
  bool window() {
    const BilliardTime from = now_;
    claims_.clear();
    times_.clear();
    const std::int64_t first_line = line_ + 1;
    const std::size_t most = std::max<std::size_t>(2 * paths_.size(), 256);
    const Rational end = end_of_window();
    const bool ends_early = end < horizon_;
    const CompactRational compact_end = end;
    Rational until = horizon_;
    bool last = false;
    BilliardTime to = from;
    for (;;) {
      std::optional<BilliardEvent> event = take();
      if (!event) {
        if (const HistoryStop* at = stop()) until = std::min(horizon_, *at->exact_t);
        last = end >= until;
        to = BilliardTime(std::max<Rational>(last ? until : end, from.value()));
        break;
      }
      if (ends_early && compact_end < event->t) {
        to = BilliardTime(end);
        ahead_ = std::move(event);
        break;
      }
      if (times_.size() >= most) {
        to = BilliardTime(event->t);
        ahead_ = std::move(event);
        break;
      }
      line_ = event->line;
      claim(*event);
      if (!found_.faults.empty()) {
        to = times_.back();
        break;
      }
    }
    if (!times_.empty() && to.exact < times_.back().exact) to = times_.back();
    follow({from, to, until, last, &times_, first_line});
    if (!found_.faults.empty()) miss_maneuvers(to.value() - options_.tolerance);
    now_ = to;
    for (BilliardPath& path : paths_) path.forget_all_but_last();
    if (options_.monitor && !options_.monitor(now_.near.mid, number_))
      throw CertificationInterrupted{number_, now_.near.mid};
    return !last;
  }

  // Where the history stops, once it has been read; null where it does not.
  const HistoryStop* stop() const { return std::get_if<HistoryStop>(&history_.ending()); }

  Rational end_of_window() const {
    const double length = meeting_.good_length();
    if (!std::isfinite(length)) return horizon_;
    const Rational now = now_.value(), end = now + to_rational(length);
    return end > now ? std::min(end, horizon_) : horizon_;
  }

  void claim(const BilliardEvent& event) {
    const BilliardTime t(event.t);
    times_.push_back(t);
    for (; later_ < billiard_.maneuvers.size() && billiard_.maneuvers[later_].t < t.value();
         ++later_)
      undone_line_[later_] = event.line;
    if (const auto* turn = std::get_if<BilliardTurn>(&event.what))
      maneuver(*turn, t, event.line);
    else
      collide(std::get<BilliardCollision>(event.what), t, event.line);
    ++number_;
  }

  void turn(GenId disk, const BilliardTime& t, const CompactVec3& v,
            const std::optional<BilliardPair>& by) {
    if (!billiard_.disks[static_cast<std::size_t>(disk)].fixed)
      paths_[static_cast<std::size_t>(disk)].turn(t, v, number_, by);
  }

  void blame(Fault kind, std::int64_t line, const BilliardTime& t, std::string truth,
             std::optional<std::pair<GenId, GenId>> contact = {}) {
    found_.faults.push_back({kind, line, t.near.mid, std::move(truth), contact});
  }

  void maneuver(const BilliardTurn& claimed, const BilliardTime& t, std::int64_t line) {
    ++certificate_.maneuvers;
    auto& scheduled = next_maneuver_[static_cast<std::size_t>(claimed.disk)];
    const auto off = [&](std::size_t m) {
      return Rational(abs(billiard_.maneuvers[m].t - t.value()));
    };
    if (scheduled.empty() || off(scheduled.front()) > options_.tolerance) {
      blame(Fault::spurious_event, line, t,
            "no maneuver of disk " + std::to_string(claimed.disk) + " is scheduled then");
      return;
    }
    const BilliardManeuver& maneuver = billiard_.maneuvers[scheduled.front()];
    scheduled.pop_front();
    const Vec3 v = claimed.v ? value_of(*claimed.v) : maneuver.velocity;
    const Vec3 difference = v - maneuver.velocity;
    const Rational speed2 = dot(maneuver.velocity, maneuver.velocity);
    if (dot(difference, difference) > options_.law_tolerance * options_.law_tolerance * speed2)
      blame(Fault::wrong_response, line, t, "the velocity is not the one that is scheduled");
    if (claimed.p) {
      const std::string fault = law_.fault_of_place(
          claimed.disk, paths_[static_cast<std::size_t>(claimed.disk)], t, value_of(*claimed.p), v);
      if (!fault.empty()) blame(Fault::wrong_response, line, t, fault);
    }
    turn(claimed.disk, t, compact(v), std::nullopt);
  }

  void collide(const BilliardCollision& claimed, const BilliardTime& t, std::int64_t line) {
    ++certificate_.collisions;
    BilliardPair pair{claimed.a, claimed.b, claimed.image ? *claimed.image : LatticeImage{}};
    const BilliardPath& b = paths_[static_cast<std::size_t>(pair.b)];
    const BilliardPath& a = pair.a < 0 ? b : paths_[static_cast<std::size_t>(pair.a)];
    if (!claimed.image && billiard_.lattice.is_periodic())
      pair.image = watch_.nearest_image(pair, a.exact_last(), b.exact_last(), t.value());
    claims_.emplace_back(pair, BilliardClaim{number_, line, t});
    const auto is_fixed = [&](GenId g) {
      return g < 0 || billiard_.disks[static_cast<std::size_t>(g)].fixed;
    };
    if (is_fixed(pair.a) && is_fixed(pair.b))
      blame(Fault::spurious_event, line, t, watch_.name(pair) + " cannot move",
            std::pair(pair.a, pair.b));
    const BounceLaw::Meeting meeting{pair, a, b, t};
    if (const std::string fault = law_.fault(meeting, claimed); !fault.empty())
      blame(Fault::wrong_response, line, t, fault, std::pair(pair.a, pair.b));
    std::array<std::optional<CompactVec3>, 2> v = claimed.v;
    const auto has_none = [&](int side) {
      const GenId disk = side == 0 ? pair.a : pair.b;
      return disk >= 0 && !billiard_.disks[static_cast<std::size_t>(disk)].fixed && !v[side];
    };
    if (has_none(0) || has_none(1)) {
      ++certificate_.computed_velocities;
      const std::array<Vec3, 2> law = law_.after(meeting);
      for (const int side : {0, 1}) {
        if (!has_none(side)) continue;
        v[side].emplace();
        for (std::size_t k = 0; k < 3; ++k)
          (*v[side])[k] = round_nearest(law[static_cast<std::size_t>(side)][k]);
      }
    }
    if (!(t.exact < near_horizon_)) ++certificate_.at_horizon;
    if (pair.a >= 0) turn(pair.a, t, v[0] ? *v[0] : CompactVec3{}, pair);
    turn(pair.b, t, v[1] ? *v[1] : CompactVec3{}, pair);
  }

  void follow(const PairWatch::Window& window) {
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
    std::vector<BilliardClaim> own;
    std::size_t next = 0;
    for (const BilliardPair& pair : pairs) {
      own.clear();
      for (; next < claims_.size() && claims_[next].first == pair; ++next)
        own.push_back(claims_[next].second);
      follow(pair, own, window);
    }
  }

  void follow(const BilliardPair& pair, const std::vector<BilliardClaim>& claims,
              const PairWatch::Window& window) {
    const auto known = states_.empty() ? states_.end() : states_.find(pair);
    PairState state = known == states_.end() ? PairState{} : std::move(known->second);
    const BilliardPath& b = paths_[static_cast<std::size_t>(pair.b)];
    watch_.follow(pair, pair.a < 0 ? b : paths_[static_cast<std::size_t>(pair.a)], b, claims,
                  window, state, found_);
    if (!state.is_empty())
      states_[pair] = std::move(state);
    else if (known != states_.end())
      states_.erase(known);
  }

  // Maneuvers that were to be claimed before that time, or at all, and are not.
  void miss_maneuvers(const std::optional<Rational>& before) {
    for (const auto& scheduled : next_maneuver_) {
      if (scheduled.empty()) continue;
      const std::size_t m = scheduled.front();
      const BilliardManeuver& maneuver = billiard_.maneuvers[m];
      if (before && maneuver.t >= *before) continue;
      const std::int64_t line = undone_line_[m] != 0 ? undone_line_[m] : line_ + 1;
      blame(Fault::missing_event, line, BilliardTime(maneuver.t),
            "the maneuver of disk " + std::to_string(maneuver.disk) +
                " at t = " + number_text(round_nearest(maneuver.t)) + " is not claimed");
    }
  }

  void finish() {
    const HistoryStop* at = stop();
    miss_maneuvers(at ? std::optional(Rational(*at->exact_t - options_.tolerance)) : std::nullopt);
    if (!found_.faults.empty()) return;
    if (at != nullptr) {
      certificate_.reason = "the history stops: " + at->reason;
      certificate_.reason_line = history_.line();
    } else if (!history_.counts_match()) {
      blame(Fault::bad_count, history_.line(), BilliardTime(horizon_),
            "the counts of the last line are not those of the events");
    } else {
      certificate_.verdict = Verdict::certified;
    }
  }

  void conclude() {
    certificate_.pair_lives = found_.pair_lives;
    certificate_.grazes = found_.grazes;
    certificate_.rounding_overlaps = found_.rounding_overlaps;
    certificate_.left_out = found_.left_out;
    certificate_.prefix_events = number_;
    certificate_.prefix_t = now_.near.mid;
    if (found_.faults.empty()) return;
    const BilliardFault& first = *std::min_element(
        found_.faults.begin(), found_.faults.end(), [](const auto& a, const auto& b) {
          return std::pair(a.line, a.t) < std::pair(b.line, b.t);
        });
    certificate_.verdict = Verdict::refuted;
    certificate_.prefix_events = std::max<std::int64_t>(0, first.line - 2);
    certificate_.prefix_t = first.t;
    Divergence& divergence = certificate_.divergence.emplace();
    divergence.fault = first.kind;
    divergence.line = first.line;
    divergence.t = first.t;
    divergence.truth = first.truth;
    divergence.true_contact = first.contact;
  }

  const Billiard& billiard_;
  const std::string& scene_file_;
  BilliardHistoryReader& history_;
  const CertifyOptions& options_;
  Rational horizon_;
  CompactRational near_horizon_;  // by the tolerance
  Rational extent_;
  PairWatch watch_;
  BounceLaw law_;
  MeetingPairs meeting_;
  BilliardTime now_{Rational(0)};
  std::optional<BilliardEvent> ahead_;
  std::int64_t line_ = 1, number_ = 0;  // the claim's that was read last; how many were read
  // The claims of the window by pair, and the times of all of them.
  std::vector<std::pair<BilliardPair, BilliardClaim>> claims_;
  std::vector<BilliardTime> times_;
  std::vector<BilliardPath> paths_;
  std::map<BilliardPair, PairState> states_;
  // By disk: those that are not claimed yet.
  std::vector<std::deque<std::size_t>> next_maneuver_;
  std::vector<std::int64_t> undone_line_;  // by maneuver: the first claim's after it; 0: none yet
  std::size_t later_ = 0;
  BilliardFindings found_;
  Certificate certificate_;
};

}  // namespace

Certificate certify_billiard(const Billiard& billiard, const std::string& scene_file,
                             BilliardHistoryReader& history, const CertifyOptions& options) {
  return BilliardCertification(billiard, scene_file, history, options).run();
}

}  // namespace voroproof::internal
