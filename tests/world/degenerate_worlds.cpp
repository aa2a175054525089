#include "tests/world/degenerate_worlds.h"

#include <array>
#include <utility>
#include <variant>

#include "tests/world/scene_list.h"

namespace voroproof::internal::testing {

namespace {

class Scenes : private SceneList {
 public:
  std::vector<DegenerateWorld> all() {
    touches();
    hosts();
    vertices();
    few();
    circles();
    jumps();
    jumps_of_special_kinds();
    rates();
    hulls();
    const std::vector<DegenerateWorld> more = coincidences();
    all_.insert(all_.end(), more.begin(), more.end());
    return std::move(all_);
  }

 private:
  void touches() {
    const GrowingDisk large = disk(0, 0, 5), passing = disk(3, -2, 2, 0, 2);
    const World world = world_of(3, among_others({large, passing}));
    add_in_both("internal touch, double root", world, Lines{});
    // At the touch its cell is a ray to the end of the edge between the two others.
    add_in_both("internal touch, towards a vertex",
                world_of(2, {disk(0, 0, 1), disk(5, 0, 1), disk(1, -3, 0), disk(-1, 1, 0, 1)}),
                Lines{});
    // At the touch the ray leads to the vertex at infinity of the two others: their hull has two
    // edges between the same disks, and one has no length then.
    for (const int radius : {6, 8, 11}) {
      add("internal touch at a line of three, plane",
          world_of(8, {disk(0, 16, 0, 1, -1), disk(8, 8, 8, -1, -1),
                       disk(24, 8 - radius, radius, 1, 1)}),
          Lines{}, 2);
    }
    add_in_both("internal touch for a while", with(world, {turn(1, 1, 0, 0), turn(2, 1, 1, 0)}),
                Lines{{1, "turn 1"}, {1, "hide [1,0]"}, {2, "turn 1"}, {2, "appear [1,0]"}});
  }

  void hosts() {
    add_in_both(
        "handover between hosts",
        world_of(4, among_others({disk(-2, 0, 5), disk(0, 0, 2, Rational(1, 2)), disk(5, 0, 8)})),
        Lines{});
    add_in_both(
        "a host jumps away",
        with(world_of(2, among_others({disk(0, 0, 5), disk(1, 0, 1)})), {jump(1, 0, 15, 0)}),
        Lines{{1, "jump 0"}});
    add_in_both("a host is hidden itself",
                world_of(4, among_others({disk(0, 0, 5), disk(1, 0, 2), disk(1, 0, 1, 1)})),
                Lines{{3, "appear [2,0]"}});
    add_in_both("two hide at one instant",
                world_of(2, among_others({disk(0, 0, 3, 0, 0, 1), disk(3, 0, 1), disk(-3, 0, 1)})),
                Lines{{1, "hide [1,0]"}, {1, "hide [2,0]"}});
    add_in_both("two appear at one instant",
                world_of(2, among_others({disk(0, 0, 5, 0, 0, -1), disk(3, 0, 1), disk(-3, 0, 1)})),
                Lines{{1, "appear [1,0]"}, {1, "appear [2,0]"}});
    add_in_both("out of one and into another at one instant",
                world_of(2, among_others({disk(-2, 0, 3), disk(-1, 0, 1, 1), disk(2, 0, 3)})),
                Lines{});
  }

  void vertices() {
    const std::vector<GrowingDisk> still{disk(0, 0, 5), disk(14, 6, 1), disk(14, -6, 1),
                                         disk(-12, 0, 1)};
    const auto scene = [&](const GrowingDisk& moving) {
      std::vector<GrowingDisk> disks = still;
      disks.insert(disks.begin() + 1, moving);
      return world_of(2, disks);
    };
    add_in_both("hide towards a vertex", scene(disk(4, 0, 2, -1)), Lines{{1, "hide [1,0]"}});
    add_in_both("appear towards a vertex", scene(disk(2, 0, 2, 1)), Lines{{1, "appear [1,0]"}});
    // The edge of 0 and 2, in which the cell of 1 lies, has no length then.
    add_in_both("a hide where the edge collapses",
                world_of(2, {disk(0, 0, 5), disk(5, 0, 1, -1), disk(14, 0, 0, 1), disk(10, 5, 0),
                             disk(10, -5, 0), disk(-12, 3, 1)}),
                Lines{{1, "hide [1,0]"}});
  }

  void few() {
    const World through = world_of(8, {disk(0, 0, 3), disk(-4, 0, 1, 1)});
    const Lines two_one_two{{2, "hide [1,0]"}, {6, "appear [1,0]"}};
    add("from two to one and back, plane", through, two_one_two, 0);
    World framed = through;
    framed.circle = circle_of(15);
    add("from two to one and back, circle", framed, two_one_two, 0);
    const World out_and_in = with(
        world_of(12, {disk(10, 0, 3, 1), disk(9, 0, 1, 1)}, circle_of(15)), {turn(9, 0, -1, 0)});
    add("from one to none and back", out_and_in,
        Lines{{8, "hide [0,-1]"}, {9, "turn 0"}, {10, "appear [0,-1]"}}, 0);
    add("nothing, plane", world_of(1, {}), Lines{}, 0);
    add("nothing, circle", world_of(1, {}, circle_of(1)), Lines{}, 0);
    World visits = world_of(8, {disk(0, 0, 1), disk(3, 0, 1), disk(0, 0, 2)});
    visits.disks[0].enter = 1;
    visits.disks[0].leave = 6;
    visits.disks[1].enter = 2;
    visits.disks[1].leave = 5;
    visits.disks[2].enter = 3;
    visits.disks[2].leave = 4;
    const Lines visiting{{1, "jump 0"}, {2, "jump 1"}, {3, "jump 2"},
                         {4, "jump 2"}, {5, "jump 1"}, {6, "jump 0"}};
    add("one after the other comes and goes, plane", visits, visiting, 0);
    visits.circle = circle_of(9);
    add("one after the other comes and goes, circle", visits, visiting, 0);
  }

  void circles() {
    add("a disk leaves the circle wholly",
        world_of(2, {disk(0, 0, 3), disk(15, 0, 1, 1), disk(-9, 5, 1), disk(3, -11, 1)},
                 circle_of(15)),
        Lines{{1, "hide [1,-1]"}});
    add("a disk crosses the circle",
        world_of(2, {disk(0, 0, 3), disk(13, 0, 1, 1), disk(-9, 5, 1), disk(3, -11, 1)},
                 circle_of(15)),
        Lines{});
    add("a disk outgrows the circle",
        world_of(Rational(6, 5),
                 {disk(0, 0, 4, 0, 0, 1), disk(3, 3, 1), disk(-2, 3, Rational(1, 2))},
                 circle_of(5)),
        std::nullopt);
    add("a point on the circle rests there",
        world_of(2, {disk(0, 0, 1), disk(5, 0, 0), disk(0, 2, 1, 1)}, circle_of(5)), Lines{});
  }

  // 1 hides in 0 at 1.
  World hiding() const {
    return world_of(2, among_others({disk(0, 0, 3, 0, 0, 1), disk(3, 0, 1)}));
  }

  void jumps() {
    // Points: the last one comes to the circle of the others at 1.
    const World flipping = world_of(
        Rational(5, 2), {disk(-2, 0, 0), disk(2, 0, 0), disk(0, -2, 0), disk(0, 3, 0, 0, -1)});
    add("a flip at 1", flipping, Lines{}, 1);
    add("the fourth jumps at the instant of a flip", with(flipping, {jump(1, 3, 0, 3)}),
        Lines{{1, "jump 3"}}, 1);
    World fifth = with(flipping, {jump(1, 4, 40, 5)});
    fifth.disks.push_back({0, {}, disk(40, 0, 0)});
    add("another jumps at the instant of a flip", fifth, Lines{{1, "jump 4"}});
    add_in_both("who would hide jumps away", with(hiding(), {jump(1, 1, 0, 8)}),
                Lines{{1, "jump 1"}});
    add_in_both("in whom it would hide jumps away", with(hiding(), {jump(1, 0, 1, -9)}),
                Lines{{1, "jump 0"}});
    add_in_both("another jumps at the instant of a hide", with(hiding(), {jump(1, 2, -12, 6)}),
                Lines{{1, "jump 2"}, {1, "hide [1,0]"}});
    add_in_both("a place that is free since then",
                with(hiding(), {jump(1, 0, 9, -5), jump(1, 2, 0, 0)}),
                Lines{{1, "jump 0"}, {1, "jump 2"}});
    add_in_both("two change places", with(hiding(), {jump(1, 2, -7, -9), jump(1, 5, -12, 5)}),
                std::nullopt);
    World lives = hiding();
    lives.disks[2].leave = lives.disks[1].leave = 1;
    lives.disks[3].enter = 1;
    add_in_both("two go and one comes at the instant of a hide", lives,
                Lines{{1, "jump 1"}, {1, "jump 2"}, {1, "jump 3"}});
  }

  void jumps_of_special_kinds() {
    const World two = world_of(2, among_others({disk(0, 0, 1), disk(1, 0, 1)}));
    const auto resized = [](const Rational& t, int g, const Rational& radius) {
      return WorldManeuver{t, g, {}, {}, radius, {}};
    };
    add_in_both("larger at the same place", with(two, {resized(1, 0, 3)}), Lines{{1, "jump 0"}});
    add_in_both("nothing changes", with(two, {resized(1, 0, 1), jump(1, 1, 1, 0)}),
                Lines{{1, "jump 0"}, {1, "jump 1"}});
    add_in_both("jumps at 0 and at the horizon",
                with(two, {jump(0, 0, 0, 5), jump(2, 0, 5, 0), jump(2, 1, 5, 0)}), std::nullopt);
    const World point = world_of(2, among_others({disk(0, 0, 5), disk(8, 0, 0)}));
    add_in_both("a point jumps onto a boundary", with(point, {jump(1, 1, 3, 4)}),
                Lines{{1, "jump 1"}});
    World away = with(point, {jump(1, 1, 3, 4)});
    away.maneuvers[0].velocity = Point2{3, 4};
    add_in_both("a point jumps onto a boundary and leaves", away, std::nullopt);
    away.maneuvers[0].velocity = Point2{4, -3};
    add_in_both("a point jumps onto a boundary and leaves along it", away, std::nullopt);
    add("a point jumps onto the circle",
        with(world_of(2, {disk(0, 0, 1), disk(2, 2, 0), disk(-2, 2, 1)}, circle_of(5)),
             {jump(1, 1, 3, 4)}),
        Lines{{1, "jump 1"}});
  }

  void rates() {
    const auto beside = [](const Rational& radius, const Rational& growth) {
      return among_others({disk(0, 0, radius, 0, 0, growth), disk(4, 0, 1, 0, 1)});
    };
    add_in_both("radii are equal for one instant",
                world_of(3, among_others({disk(0, 0, 1, 0, 0, 1), disk(6, 0, 3)})), Lines{});
    add_in_both("a radius becomes 0 at a maneuver",
                with(world_of(4, among_others({disk(0, 0, 2, 0, 0, -1), disk(4, 0, 1)})),
                     {{2, 0, {}, {}, {}, Rational(1)}}),
                Lines{{2, "turn 0"}});
    // The distance squared is 16 + t^2; the difference of radii 2 + t, or 1 + 2t.
    add_in_both("a hide of the first degree", world_of(4, beside(3, 1)), Lines{{3, "hide [1,0]"}});
    add_in_both("growth is faster", world_of(2, beside(2, 2)),
                Lines{{Rational(5, 3), "hide [1,0]"}});
    // The distance is 4 + t, and the difference of radii 3 + t.
    add_in_both(
        "growth as fast as the flight",
        world_of(3, {disk(0, 0, 4, 0, 0, 1), disk(4, 0, 1, 1), disk(-8, 3, 1), disk(-2, -11, 2)}),
        Lines{});
  }

  void hulls() {
    add("three disks on one tangent line for an instant, plane",
        world_of(2, {disk(-4, 0, 1), disk(4, 0, 1), disk(0, 1, 1, 0, -1), disk(0, -9, 1)}), Lines{},
        1);
    const std::vector<GrowingDisk> row{disk(-5, 0, 1), disk(0, 0, 1, 2), disk(5, 0, 1)};
    add("centres on one line for ever, plane", world_of(2, row), Lines{}, 0);
    add("they pass each other on it, plane", world_of(4, row),
        Lines{{Rational(5, 2), "swap [1,2]"}});
    add("two disks only, plane", world_of(4, {disk(-3, 0, 1, 2), disk(1, 0, 1)}),
        Lines{{2, "swap [0,1]"}}, 0);
    add("two disks only, circle", world_of(4, {disk(-3, 0, 1, 2), disk(1, 0, 1)}, circle_of(20)),
        Lines{{2, "swap [0,1]"}}, 0);
  }
};

}  // namespace

std::vector<DegenerateWorld> degenerate_worlds() { return Scenes().all(); }

std::optional<ExpectedLine> line_of(const WorldEvent& event) {
  const Rational t = to_rational(round_nearest(event.t));
  const auto pair = [](GenId g, GenId j) {
    return " [" + std::to_string(g) + "," + std::to_string(j) + "]";
  };
  if (const auto* h = std::get_if<Hide>(&event.what)) return {{t, "hide" + pair(h->g, h->j)}};
  if (const auto* a = std::get_if<Appear>(&event.what)) return {{t, "appear" + pair(a->g, a->j)}};
  if (const auto* s = std::get_if<Swap>(&event.what)) return {{t, "swap" + pair(s->i, s->j)}};
  if (const auto* u = std::get_if<PathTurn>(&event.what))
    return {{t, "turn " + std::to_string(u->g)}};
  if (const auto* j = std::get_if<Jump>(&event.what)) return {{t, "jump " + std::to_string(j->g)}};
  return std::nullopt;
}

}  // namespace voroproof::internal::testing
