// Scenes of disks that are one at an instant.
#include "tests/world/scene_list.h"

namespace voroproof::internal::testing {

namespace {

class Coincidences : private SceneList {
 public:
  std::vector<DegenerateWorld> all() {
    coincidences();
    coincidences_of_comers();
    coincidences_at_turns();
    within_others();
    lattice();
    return std::move(all_);
  }

 private:
  void coincidences() {
    const Lines swap{{1, "swap [0,1]"}};
    const auto meet = [&](const std::string& name, const GrowingDisk& a, const GrowingDisk& b) {
      add_in_both(name, world_of(2, among_others({a, b})), swap);
    };
    meet("two equal disks coincide", disk(-2, 0, 1, 2), disk(2, 0, 1, -2));
    meet("radii cross, slowly", disk(-2, 0, 1, 2, 0, Rational(1, 5)),
         disk(2, 0, Rational(6, 5), -2));
    // The smaller is in the larger but at the instant itself.
    meet("radii cross, fast", disk(-2, 0, 1, 2, 0, Rational(9, 2)),
         disk(2, 0, Rational(11, 2), -2));
    meet("radii cross as fast as the disks move", disk(-2, 0, 1, 2, 0, 4), disk(2, 0, 5, -2));
    add_in_both("three coincide",
                world_of(2, among_others(
                                {disk(-2, 0, 1, 2), disk(1, -2, 1, -1, 2), disk(1, 3, 1, -1, -3)})),
                {}, 1);
    const World alone = world_of(2, {disk(-2, 0, 1, 2), disk(2, 0, 1, -2), disk(-2, 0, 0, 2)});
    add_in_both("two that meet hide one that jumps", with(alone, {jump(1, 2, 0, 0)}),
                Lines{{1, "jump 2"}, {1, "swap [0,1]"}});
    const World identical = world_of(
        2, among_others({disk(1, 2, 1, 0, Rational(1, 3)), disk(1, 2, 1, 0, Rational(1, 3))}));
    add_in_both("identical for ever", identical, Lines{});
    add_in_both("identical until one turns", with(identical, {turn(1, 0, 1, 0)}),
                Lines{{1, "turn 0"}, {1, "appear [1,0]"}});
  }

  // One comes to where others are: it meets nobody before, so that nothing is to be told of it but
  // that it comes.
  void coincidences_of_comers() {
    const Lines jump_1{{1, "jump 1"}};
    for (const int vx : {-1, 1, -3}) {
      const World there = with(world_of(2, among_others({disk(-2, 0, 1, 1), disk(2, 0, 1, vx)})),
                               {jump(1, 1, -1, 0)});
      add_in_both("one jumps to where another is", there, jump_1);
    }
    const Lines comes{{1, "jump 2"}, {1, "swap [0,1]"}};
    const auto meet = [&](const GrowingDisk& third) {
      World world = world_of(2, among_others({disk(-2, 0, 1, 2), disk(2, 0, 1, -2, 1), third}));
      world.disks[1].state.y = -1;
      return world;
    };
    World three = meet(disk(0, 0, 1, 1, 3));
    three.disks[2].enter = 1;
    add_in_both("one comes to where two change places", three, comes);
    add_in_both("one jumps to where two change places",
                with(meet(disk(4, 7, 1, 1, 3)), {jump(1, 2, 0, 0)}), comes);
    World two_come = three;
    two_come.disks[3] = {1, {}, disk(0, 0, 1, -3, 1)};
    add_in_both("two come to where two change places", two_come,
                Lines{{1, "jump 2"}, {1, "jump 3"}, {1, "swap [0,1]"}});
    World same = three;
    same.disks[1].state = same.disks[0].state;
    add_in_both("one comes to where two are that are the same for ever", same,
                Lines{{1, "jump 2"}});
    World turning = three;
    turning.disks[1].enter = 3;
    add_in_both("one comes to where another turns", with(turning, {turn(1, 0, 1, -1)}),
                Lines{{1, "jump 2"}, {1, "turn 0"}});
    World leaving = meet(disk(3, 3, 1, -3, -3));
    leaving.disks[2].leave = 1;
    add_in_both("of three that meet one goes", leaving, comes);
    World two_left = leaving;
    two_left.disks[1].leave = 1;
    add_in_both("of three that meet two go", two_left, Lines{{1, "jump 1"}, {1, "jump 2"}});
    // Two meet in one that comes, or in one that goes.
    World in_one = meet(disk(1, 0, 6));
    in_one.disks[2].enter = 1;
    add_in_both("one that comes hides two that meet", in_one, Lines{{1, "jump 2"}});
    in_one = meet(disk(1, 0, 6));
    in_one.disks[2].leave = 1;
    add_in_both("one that goes hid two that meet", in_one, comes);
  }

  // Two are the same when one of them turns.
  void coincidences_at_turns() {
    const World meeting = world_of(2, among_others({disk(-2, 0, 1, 2), disk(2, 0, 1, -2)}));
    add_in_both("two are one when one turns, and part", with(meeting, {turn(1, 0, 1, 1)}), {}, 1);
    add_in_both("two become the same for ever", with(meeting, {turn(1, 1, 2, 0)}),
                Lines{{1, "turn 1"}, {1, "hide [1,0]"}});
    // The radii cross while one is in the other.
    const World nested =
        world_of(2, among_others({disk(-2, 0, 1, 2, 0, 5), disk(0, 0, 7, 0, 0, -1)}));
    add_in_both("one in another becomes the one around it at a turn",
                with(nested, {turn(1, 1, 1, 0)}), Lines{{1, "turn 1"}, {1, "swap [0,1]"}});
    const World back = with(nested, {{1, 0, {}, {}, {}, Rational(-3)}});
    add_in_both("one in another stays there by a turn", back, Lines{{1, "turn 0"}});
    const World out = with(nested, {{1, 0, {}, Point2{3, 0}, {}, Rational(-1)}});
    add_in_both("one in another leaves it by a turn", out,
                Lines{{1, "turn 0"}, {1, "appear [0,1]"}});
  }

  // Where more than two are tangent at one place nothing is undecided: the diagram just after
  // tells.
  void within_others() {
    add_in_both("two leave another at one place",
                world_of(2, among_others({disk(0, 0, 5), disk(3, 0, 1, 1), disk(4, -3, 1, 1, 3)})),
                {});
    add_in_both("one leaves two that change places",
                world_of(2, among_others({disk(-1, 0, 3, 1), disk(1, 0, 3, -1),
                                          disk(Rational(-1, 2), 1, 1, Rational(1, 2), 1)})),
                {});
    add_in_both(
        "one leaves another for one that leaves it, too",
        world_of(2, {disk(-1, 3, 1, 1, -1), disk(3, -3, 0, -1), disk(1, -1, 1, 1, -1),
                     disk(3, 1, 0, 1, 1), disk(1, -2, 2, 1, 1)}),
        Lines{
            {Rational(1, 5), "hide [1,4]"}, {1, "appear [2,4]"}, {Rational(7, 5), "appear [1,2]"}});
    add_in_both("two that change places hide in a third",
                world_of(2, {disk(0, 2, 1, 0, 1), disk(1, 0, 0), disk(0, 0, 0, 1),
                             disk(-3, 1, 1, 1, -1), disk(3, 1, 1, -1, -1)}),
                {});
    World leaving = world_of(2, among_others({disk(0, 0, 5), disk(1, 0, 1)}));
    leaving.disks[0].leave = leaving.disks[1].leave = 1;
    add_in_both("one goes, and another that it hides", leaving,
                Lines{{1, "jump 0"}, {1, "jump 1"}});
  }

  // Every other column goes to the right, the others to the left: half of the disks change places
  // with the other half at one instant.
  void lattice() {
    std::vector<GrowingDisk> disks;
    Lines swaps;
    for (int k = 0; k < 64; ++k) {
      disks.push_back(disk(4 * (k % 8), 4 * (k / 8), 1, k % 2 == 0 ? 2 : -2));
      if (k % 2 == 0) {
        swaps.push_back({1, "swap [" + std::to_string(k) + "," + std::to_string(k + 1) + "]"});
      }
    }
    add("a lattice changes places, plane", world_of(2, disks), swaps);
  }
};

}  // namespace

std::vector<DegenerateWorld> coincidences() { return Coincidences().all(); }

}  // namespace voroproof::internal::testing
