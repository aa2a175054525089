#include "certify/billiards/billiard_certifier.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <utility>

#include "certify/billiards/exact_billiard.h"
#include "certify/billiards/recorded_billiard.h"
#include "exact/patience.h"
#include "filtered/billiards/line_boxes.h"
#include "filtered/motion/options.h"
#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

std::unique_ptr<BilliardTruth> truth_of(const Billiard& billiard, const Rational& horizon,
                                        const CertifyOptions& options) {
  return options.truth == Truth::exact ? exact_billiard(billiard, horizon, options)
                                       : recorded_billiard(billiard, horizon, options);
}

class BilliardCertification {
 public:
  BilliardCertification(const Billiard& billiard, const std::string& scene_file,
                        BilliardHistoryReader& history, const CertifyOptions& options)
      : billiard_(billiard),
        scene_file_(scene_file),
        history_(history),
        options_(options),
        horizon_(told_horizon(history.header().horizon, billiard.horizon)),
        truth_(truth_of(billiard, horizon_, options)),
        found_(truth_->found()),
        lag_(truth_->lag()),
        next_maneuver_(billiard.disks.size()) {}

  Certificate run() {
    std::optional<Patience> patience;
    if (options_.monitor)
      patience.emplace([this] { return options_.monitor(now_.near.mid, number_); });
    try {
      judge();
    } catch (const GivenUp&) {
      throw CertificationInterrupted{proved_, now_.near.mid};
    }
    conclude();
    return std::move(certificate_);
  }

 private:
  void judge() {
    start();
    try {
      require_placement(billiard_, scene_file_);
      truth_->begin();
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
    while (history_.next()) Patience::ask();
  }

  void start() {
    for (std::size_t m = 0; m < billiard_.maneuvers.size(); ++m) {
      const BilliardManeuver& maneuver = billiard_.maneuvers[m];
      if (maneuver.t <= horizon_)
        next_maneuver_[static_cast<std::size_t>(maneuver.disk)].push_back(m);
    }
    undone_line_.assign(billiard_.maneuvers.size(), 0);
    if (horizon_ > billiard_.horizon)
      throw InputError(scene_file_, 0, "horizon", "the history goes beyond it");
  }

  std::optional<BilliardEvent> take() {
    if (ahead_) return std::exchange(ahead_, std::nullopt);
    return history_.next();
  }

  // Reads and judges the claims of one window; false after the last.
  bool window() {
    require_progress();
    const BilliardTime from = now_;
    const std::int64_t first_line = line_ + 1 - static_cast<std::int64_t>(times_.size());
    const std::int64_t most =
        std::max<std::int64_t>(2 * static_cast<std::int64_t>(billiard_.disks.size()), 256);
    const std::int64_t before = number_;
    const Rational end = end_of_window();
    const bool ends_early = end < horizon_;
    const CompactRational last_claim = Rational(end + lag_);
    Rational until = horizon_;
    bool last = false;
    BilliardTime to = from;
    std::optional<Undecided> untold;  // a fault before it is told first
    for (;;) {
      std::optional<BilliardEvent> event = take();
      if (!event) {
        if (const HistoryStop* at = stop())
          until = std::min(horizon_, Rational(*at->exact_t - lag_));
        last = end >= until;
        to = BilliardTime(std::max<Rational>(last ? until : end, from.value()));
        break;
      }
      if (ends_early && last_claim < event->t) {
        to = BilliardTime(end);
        ahead_ = std::move(event);
        break;
      }
      if (number_ - before >= most) {
        const BilliardTime settled = settled_at(BilliardTime(event->t));
        if (!(settled.exact < from.exact)) {
          to = settled;
          ahead_ = std::move(event);
          break;
        }
      }
      line_ = event->line;
      try {
        claim(*event);
      } catch (const Undecided& at) {
        untold = at;
      }
      if (untold || !found_.faults.empty()) break;
    }
    if (!times_.empty()) {
      const BilliardTime settled = settled_at(times_.back());
      if (to.exact < settled.exact) to = settled;
    }
    truth_->follow({from, to, until, last, &times_, first_line});
    if (untold && found_.faults.empty()) throw Undecided(*untold);
    if (!found_.faults.empty()) miss_maneuvers(to.value() - options_.tolerance);
    now_ = to;
    const BilliardTime settled = settled_at(now_);
    const auto is_past = [&](const BilliardTime& t) { return !(settled.exact < t.exact); };
    times_.erase(times_.begin(), std::find_if_not(times_.begin(), times_.end(), is_past));
    proved_ = number_ - static_cast<std::int64_t>(times_.size());
    Patience::ask_now();
    return !last;
  }

  // Windows are short where disks run past many images.
  void require_progress() {
    const auto disks = static_cast<std::int64_t>(billiard_.disks.size());
    if (++windows_ > 10'000 + (std::int64_t{1} << 17) / (disks + 1) + 16 * number_)
      throw Undecided("a disk runs past more images of others than are looked at");
  }

  // All claims have been read whose truth lies before that time, once those up to t have been.
  BilliardTime settled_at(const BilliardTime& t) const {
    return lag_ == 0 ? t : BilliardTime(Rational(t.value() - lag_));
  }

  // Where the history stops, once it has been read; null where it does not.
  const HistoryStop* stop() const { return std::get_if<HistoryStop>(&history_.ending()); }

  Rational end_of_window() const {
    const double length = truth_->good_length();
    if (!std::isfinite(length)) return horizon_;
    const Rational now = now_.value(), end = now + to_rational(length);
    return end > now ? std::min(end, horizon_) : horizon_;
  }

  void claim(const BilliardEvent& event) {
    Patience::ask();
    const BilliardTime t(event.t);
    times_.push_back(t);
    for (; later_ < billiard_.maneuvers.size() && billiard_.maneuvers[later_].t < t.value();
         ++later_)
      undone_line_[later_] = event.line;
    const BilliardClaim at{number_, event.line, t};
    if (const auto* turn = std::get_if<BilliardTurn>(&event.what)) {
      maneuver(*turn, at);
    } else {
      ++certificate_.collisions;
      truth_->collide(std::get<BilliardCollision>(event.what), at);
    }
    ++number_;
  }

  void blame(Fault kind, std::int64_t line, const BilliardTime& t, std::string truth) {
    found_.faults.push_back({kind, line, t.near.mid, std::move(truth)});
  }

  void maneuver(const BilliardTurn& claimed, const BilliardClaim& at) {
    ++certificate_.maneuvers;
    auto& scheduled = next_maneuver_[static_cast<std::size_t>(claimed.disk)];
    const auto off = [&](std::size_t m) {
      return Rational(abs(billiard_.maneuvers[m].t - at.t.value()));
    };
    if (scheduled.empty() || off(scheduled.front()) > options_.tolerance) {
      blame(Fault::spurious_event, at.line, at.t,
            "no maneuver of disk " + std::to_string(claimed.disk) + " is scheduled then");
      return;
    }
    const BilliardManeuver& maneuver = billiard_.maneuvers[scheduled.front()];
    scheduled.pop_front();
    const Vec3 v = claimed.v ? value_of(*claimed.v) : maneuver.velocity;
    const Vec3 difference = v - maneuver.velocity;
    const Rational speed2 = dot(maneuver.velocity, maneuver.velocity);
    if (dot(difference, difference) > options_.law_tolerance * options_.law_tolerance * speed2)
      blame(Fault::wrong_response, at.line, at.t, "the velocity is not the one that is scheduled");
    truth_->maneuver(claimed, maneuver, at);
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
    certificate_.computed_velocities = found_.computed_velocities;
    certificate_.at_horizon = found_.at_horizon;
    certificate_.swaps = found_.swaps;
    certificate_.highest_bits = found_.highest_bits;
    certificate_.prefix_events = certificate_.verdict == Verdict::certified ? number_ : proved_;
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
  std::unique_ptr<BilliardTruth> truth_;
  BilliardFindings& found_;
  Rational lag_;
  BilliardTime now_{Rational(0)};
  std::optional<BilliardEvent> ahead_;
  std::int64_t line_ = 1, number_ = 0;  // the claim's that was read last; how many were read
  std::int64_t windows_ = 0;
  std::int64_t proved_ = 0;  // how many of them have their truth before now
  // The claims' that have been read and whose truth may be later than now.
  std::vector<BilliardTime> times_;
  // By disk: those that are not claimed yet.
  std::vector<std::deque<std::size_t>> next_maneuver_;
  std::vector<std::int64_t> undone_line_;  // by maneuver: the first claim's after it; 0: none yet
  std::size_t later_ = 0;
  Certificate certificate_;
};

}  // namespace

void require_placement(const Billiard& billiard, const std::string& scene_file) {
  const auto pair = find_overlap_at_start(billiard);
  if (!pair) return;
  const auto [field, why] = placement_fault(billiard, *pair);
  throw InputError(scene_file, 0, field, why);
}

Certificate certify_billiard(const Billiard& billiard, const std::string& scene_file,
                             BilliardHistoryReader& history, const CertifyOptions& options) {
  return BilliardCertification(billiard, scene_file, history, options).run();
}

}  // namespace voroproof::internal
