#include "library/queries/replayed_motion.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>

#include "filtered/search/contact.h"
#include "history/error.h"
#include "history/scene_motion.h"
#include "library/queries/followed_history.h"

namespace voroproof::internal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Replay {
 public:
  Replay(const Scene& scene, const std::string& path, const Rational& t,
         const MotionOptions& options)
      : scene_(scene),
        path_(path),
        t_(t),
        out_{ComputedMotion(motion_input(scene), options), {}},
        contacts_(out_.motion, counts_),
        next_maneuver_(scene.disks.size(), 0) {}

  void follow(const Event& event, bool happened, std::int64_t line) {
    const double recorded = time(event);
    const bool near = to_rational(std::nextafter(recorded, -infinity)) < t_ &&
                      t_ < to_rational(std::nextafter(recorded, infinity));
    if (const auto* flip = std::get_if<FlipEvent>(&event)) {
      if (near) out_.near_flips.emplace_back(flip->quad, happened);
    } else if (!beyond_ && (happened || near)) {
      if (const auto* collision = std::get_if<CollideEvent>(&event)) {
        follow_collision(*collision, near, line);
      } else {
        follow_maneuver(std::get<ManeuverEvent>(event), line);
      }
    }
  }

  // Throws InputError where a maneuver of the scene was not among the events.
  ReplayedMotion take() {
    for (std::size_t k = 0; k < scene_.maneuvers.size() && !beyond_; ++k) {
      const Maneuver& due = scene_.maneuvers[k];
      if (due.t <= t_ && k >= next_maneuver_[static_cast<std::size_t>(due.disk)]) {
        throw InputError(path_, 0, "",
                         "lacks the maneuver of disk " + std::to_string(due.disk) +
                             " that the scene schedules at t = " + due.t.get_str());
      }
    }
    return std::move(out_);
  }

 private:
  void follow_collision(const CollideEvent& event, bool near_t, std::int64_t line) {
    const double t = event.t;
    // It tells the contact that is meant from the other one on the same lines.
    const double slack = 0x1p-30 * round_up(scene_.horizon);
    constexpr int attempts = 4;
    Ball contact(64);
    for (int attempt = 0;; ++attempt) {
      contact = contacts_.refine(event.i, event.j, to_rational(t), out_.motion.goal_bits() + 32);
      double lo = 0, hi = 0;
      contact.to_interval(lo, hi);
      if (t - slack <= lo && hi <= t + slack) break;
      if (lo > t + slack || hi < t - slack || attempt == attempts ||
          !out_.motion.raise_precision()) {
        throw InputError(path_, line, "collide",
                         "not seen to be a collision of the scene's true motion");
      }
    }
    if (near_t && !has_happened(contact, event)) {
      beyond_ = true;
      return;
    }
    out_.motion.collide(event.i, event.j, t);
  }

  // Whether the contact lies at t or before it, in truth.
  bool has_happened(const Ball& contact, const CollideEvent& event) {
    const Sign after = (contact - Ball(t_, contact.precision())).sign();
    if (after != Sign::unknown) return after != Sign::positive;
    try {
      ExactMotion exact(out_.motion);
      return compare(ContactSearch::exact_time(event.i, event.j, to_rational(event.t), exact),
                     ExactTime(t_)) <= 0;
    } catch (const BudgetExceeded& e) {
      throw Undecided(std::string("whether a collision is before an instant: ") + e.what(), event.i,
                      event.j);
    }
  }

  // The scene has the exact values of what the history rounds.
  void follow_maneuver(const ManeuverEvent& event, std::int64_t line) {
    std::size_t& k = next_maneuver_[event.disk];
    while (k < scene_.maneuvers.size() && scene_.maneuvers[k].disk != event.disk) ++k;
    if (k == scene_.maneuvers.size() || round_nearest(scene_.maneuvers[k].t) != event.t) {
      throw InputError(path_, line, "maneuver", "not one of the scene");
    }
    const Maneuver& given = scene_.maneuvers[k];
    if (given.t > t_) return;
    ++k;
    out_.motion.maneuver(event.disk, given.t, given.vx, given.vy);
  }

  const Scene& scene_;
  const std::string& path_;
  const Rational& t_;
  TierCounts counts_;
  ReplayedMotion out_;
  ContactSearch contacts_;
  bool beyond_ = false;  // the true motion is beyond t, even if recorded times are not
  std::vector<std::size_t> next_maneuver_;  // per disk, an index into the scene's
};

}  // namespace

ReplayedMotion replayed_motion(const Scene& scene, const std::string& history_path,
                               const Rational& t, const MotionOptions& options) {
  Replay replay(scene, history_path, t, options);
  HistoryFollower follower;
  follower.begin = [](const HistoryHeader&) {};
  follower.event = [&](const Event& event, bool happened, std::int64_t line) {
    replay.follow(event, happened, line);
  };
  follow_history(scene, history_path, t, follower);
  return replay.take();
}

}  // namespace voroproof::internal
