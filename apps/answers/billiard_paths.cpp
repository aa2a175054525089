#include "apps/answers/billiard_paths.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "apps/answers/untold.h"
#include "certify/billiards/near_images.h"
#include "certify/billiards/recorded_billiard.h"
#include "exact/names.h"
#include "history/billiard_history.h"
#include "history/error.h"
#include "history/json_text.h"
#include "library/queries/paths.h"

namespace voroproof::internal {
namespace {

Rational taxicab(const Vec3& v) { return abs(v[0]) + abs(v[1]) + abs(v[2]); }

class RecordedPaths {
 public:
  // All outlive it.
  RecordedPaths(const Billiard& billiard, BilliardHistoryReader& history, const std::string& path)
      : billiard_(billiard),
        history_(history),
        history_path_(path),
        gaps_(billiard),
        images_(billiard, gaps_),
        extent_(extent_of(billiard)) {
    for (const BilliardDisk& disk : billiard.disks) {
      given_.paths.push_back(
          {std::to_string(given_.paths.size()), disk.radius, {{0, disk.center}}, {}, disk.growth});
      flights_.push_back({0, disk.center, disk.velocity});
    }
    roundings_.resize(flights_.size());
    told_.maneuvers.resize(flights_.size());
    scheduled_.resize(flights_.size());
    for (const BilliardManeuver& m : billiard.maneuvers)
      scheduled_[static_cast<std::size_t>(m.disk)].push_back(&m);
  }

  GivenPaths read() {
    told_.end = told_horizon(history_.header().horizon, billiard_.horizon);
    while (const auto event = history_.next()) {
      // Rounding may move an event beyond the horizon.
      const Rational t = std::min(event->t.value(), told_.end);
      if (const auto* collision = std::get_if<BilliardCollision>(&event->what))
        collide(*collision, t, event->line);
      else
        maneuver(std::get<BilliardTurn>(event->what), t, event->line);
    }
    if (const auto* stop = std::get_if<HistoryStop>(&history_.ending())) {
      told_.end = std::min(*stop->exact_t, told_.end);
      told_.stops = true;
    }
    told_.counts_match = history_.counts_match();
    for (GenId g = 0; g < static_cast<GenId>(flights_.size()); ++g) fly(g, told_.end);
    given_.missing = untold(told_, billiard_.horizon, billiard_.maneuvers);
    if (!apart_.empty())
      given_.missing.push_back(
          "the contact of a collision of two that do not touch on these paths: " + apart_);
    given_.meaning = "the paths that the history records";
    given_.remarks = {"the history is not judged: certify does that"};
    given_.container = billiard_.round;
    given_.walls = billiard_.walls;
    given_.in_space = billiard_.dimension == 3;
    given_.sides = billiard_.lattice.sides;
    return std::move(given_);
  }

 private:
  const BilliardDisk& disk(GenId g) const { return billiard_.disks[static_cast<std::size_t>(g)]; }
  Flight<Rational>& flight(GenId g) { return flights_[static_cast<std::size_t>(g)]; }

  // Tells the path up to a time.
  void fly(GenId g, const Rational& t) {
    Flight<Rational>& on = flight(g);
    if (t == on.t0) return;
    GivenPath& path = given_.paths[static_cast<std::size_t>(g)];
    if (!disk(g).fixed && billiard_.gravity != Vec3{})
      path.curves.push_back({on.x, on.v, billiard_.gravity * Rational(1, 2)});
    // As for library/queries/paths.h: what the rounding of a speed and of times may move it by.
    roundings_[static_cast<std::size_t>(g)] +=
        (taxicab(on.v) + taxicab(billiard_.gravity) * t + abs(disk(g).growth)) * t;
    on.x = gaps_.place(g, on, t);
    on.v = gaps_.velocity(g, on, t);
    on.t0 = t;
    path.waypoints.push_back({t, on.x});
  }

  void turn(GenId g, const Rational& t, const Vec3& velocity) {
    fly(g, t);
    flight(g).v = velocity;
    roundings_[static_cast<std::size_t>(g)] += extent_;
  }

  void collide(const BilliardCollision& claim, const Rational& t, std::int64_t line) {
    for (const int side : {0, 1}) {
      const GenId g = side == 0 ? claim.a : claim.b;
      if (g < 0 || disk(g).fixed) continue;
      const auto& v = claim.v[static_cast<std::size_t>(side)];
      if (!v) throw InputError(history_path_, line, "collide", "its v is needed");
      turn(g, t, value_of(*v));
    }
    BilliardPair pair{claim.a, claim.b, claim.image.value_or(LatticeImage{})};
    if (!claim.image && pair.a >= 0 && billiard_.lattice.is_periodic())
      pair.image = images_.nearest(pair, flight(pair.a), flight(pair.b), t);
    if (touch(pair, t)) {
      given_.contacts.insert({pair.a, pair.b, t, pair.image});
    } else if (apart_.empty()) {
      apart_ = text_of(pair.a, pair.b) + " at t = " + number_text(t);
    }
  }

  void maneuver(const BilliardTurn& claim, const Rational& t, std::int64_t line) {
    const auto index = static_cast<std::size_t>(claim.disk);
    auto& claims = told_.maneuvers[index];
    if (claims.size() == scheduled_[index].size())
      throw InputError(history_path_, line, "maneuver", "not one of the scene");
    const BilliardManeuver& due = *scheduled_[index][claims.size()];
    std::optional<Vec3> v;
    if (claim.v) v = value_of(*claim.v);
    turn(claim.disk, t, v.value_or(due.velocity));
    claims.push_back({t, std::move(v)});
  }

  // Whether the two touch at t, but for roundings.
  bool touch(const BilliardPair& pair, const Rational& t) {
    const auto place = [&](GenId g) { return gaps_.place(g, flight(g), t); };
    Rational rounding = roundings_[static_cast<std::size_t>(pair.b)];
    Vec3 apart = place(pair.b);
    if (pair.a >= 0) {
      rounding += roundings_[static_cast<std::size_t>(pair.a)];
      apart = apart + gaps_.offset(pair.image, t) - place(pair.a);
    } else if (billiard_.round) {
      apart = apart - billiard_.round->center;
    } else {
      const BilliardWall& wall = billiard_.walls[static_cast<std::size_t>(-1 - pair.a)];
      rounding = (rounding + abs(wall.speed) * t) / (Rational(1) << 51);
      const Rational gap =
          dot(wall.normal, apart) - wall.offset - wall.speed * t - gaps_.radius(pair.b, t);
      return may_explain(rounding, extent_, extent_) && abs(gap) <= rounding;
    }
    rounding /= Rational(1) << 51;
    const Rational reach = gaps_.reach(pair, t), low = std::max<Rational>(reach - rounding, 0),
                   high = reach + rounding, distance2 = dot(apart, apart);
    return may_explain(rounding, reach, extent_) && distance2 >= low * low &&
           distance2 <= high * high;
  }

  const Billiard& billiard_;
  BilliardHistoryReader& history_;
  const std::string& history_path_;
  BilliardGaps<Rational> gaps_;
  NearImages images_;
  Rational extent_;
  GivenPaths given_;
  std::vector<Flight<Rational>> flights_;  // from each disk's last waypoint on
  std::vector<Rational> roundings_;        // 2^51 times how far they may have moved each by now
  std::vector<std::vector<const BilliardManeuver*>> scheduled_;  // by disk
  ToldHistory told_;
  std::string apart_;  // the first collision of two that do not touch
};

}  // namespace

GivenPaths billiard_paths(const Billiard& billiard, const std::string& scene_path,
                          const std::string& history_path) {
  if (billiard.lattice.shear != 0)
    throw InputError(scene_path, 0, "frame.shear", "clearance knows no images that move");
  BilliardHistoryReader history(history_path, &billiard);
  if (told_horizon(history.header().horizon, billiard.horizon) > billiard.horizon)
    throw InputError(scene_path, 0, "horizon", "the history goes beyond it");
  return RecordedPaths(billiard, history, history_path).read();
}

}  // namespace voroproof::internal
