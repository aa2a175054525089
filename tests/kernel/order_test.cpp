// The order in which a file tells flips and turns (docs/kernel.md, section 7). The scenes have four
// disks around a circle, the last of which moves outwards through it: the edge in it flips.
#include "tests/kernel/histories.h"

namespace voroproof_kernel {
namespace {

std::string square(const std::string& y, const std::string& vy) {
  return disk("0", "5", "1", "0", "0") + "," + disk("5", "0", "1", "0", "0") + "," +
         disk("-5", "0", "1", "0", "0") + "," + disk("0", y, "1", "0", vy);
}

// A maneuver starts the last disk, and 1e-7 later the edge flips. Told in the reverse order this is
// a swap: counted, and refuted under strict.
TEST(KernelOrder, AFlipToldBeforeItsTurnIsASwap) {
  const std::string horizon = "1.0000005";
  const std::string scene = scene_of(square("-4.9", "0"), horizon,
                                     R"(,"maneuvers":[{"t":1,"disk":3,"velocity":[0,-1e6]}])");
  const std::string initial =
      "[[-1,0,2,1],[-1,1,0,3],[-1,2,3,0],[-1,3,1,2],[0,1,3,-1],[0,2,-1,3],[0,3,2,1],[1,3,0,-1],"
      "[2,3,-1,0]]";
  const std::string turn = R"({"t":1,"maneuver":3})";
  for (const bool swapped : {false, true}) {
    const std::string flip =
        swapped ? R"({"t":1,"flip":[0,3,2,1]})" : R"({"t":1.0000001,"flip":[0,3,2,1]})";
    const std::vector<std::string> claims =
        swapped ? std::vector{flip, turn} : std::vector{turn, flip};
    const std::string history = history_of(scene, claims, horizon, initial);
    const Result r = check(scene, history, {});
    EXPECT_EQ(r.verdict, Verdict::certified) << r.reason;
    EXPECT_EQ(r.counts.swaps, swapped ? 1 : 0);
    Options strict;
    strict.strict = true;
    EXPECT_EQ(check(scene, history, strict).verdict,
              swapped ? Verdict::refuted : Verdict::certified);
  }
}

// The last disk touches the circle at t = 1 and is hit back at that instant: nothing flips. Whoever
// claims a flip before the blow, and the flip back after it, is refuted.
TEST(KernelOrder, NoTurnAfterAFlipOfTheSameInstant) {
  const std::string scene =
      scene_of(square("-4", "-1") + "," + disk("0", "-7", "1", "0", "0"), "1.5");
  const std::string initial =
      "[[-1,0,2,1],[-1,1,0,4],[-1,2,4,0],[-1,4,1,2],[0,1,3,-1],[0,2,-1,3],[0,3,2,1],[1,3,0,4],"
      "[1,4,3,-1],[2,3,4,0],[2,4,-1,3],[3,4,2,1]]";
  const std::string hit = R"({"t":1,"collide":[3,4],"v":[[0,0],[0,-1]]})";
  const std::vector<std::string> wrong = {R"({"t":1,"flip":[0,3,2,1]})", hit,
                                          R"({"t":1,"flip":[1,2,0,3]})"};
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    EXPECT_EQ(verdict(scene, {hit}, truth, "1.5", initial), Verdict::certified);
    EXPECT_EQ(verdict(scene, wrong, truth, "1.5", initial), Verdict::refuted);
  }
}

// Two such circles far from each other, whose edges flip one shortly after the other, and both
// within the tolerance of the horizon. The last one may be left out. After the first one the
// diagram is another than the claimed one, so that a flip which is told without it is not proved.
TEST(KernelOrder, NoFlipAfterOneThatIsLeftOut) {
  const auto four = [](const std::string& west, const std::string& middle, const std::string& east,
                       const std::string& y) {
    return disk(middle, "5", "1", "0", "0") + "," + disk(east, "0", "1", "0", "0") + "," +
           disk(west, "0", "1", "0", "0") + "," + disk(middle, y, "1", "0", "-1");
  };
  const std::string horizon = "1.0000005";
  const std::string scene = scene_of(
      four("-25", "-20", "-15", "-4") + "," + four("15.5", "20.5", "25.5", "-3.9999999"), horizon);
  const std::string initial =
      "[[-1,0,2,4],[-1,1,6,3],[-1,2,3,0],[-1,3,1,2],[-1,4,0,5],[-1,5,4,7],[-1,6,7,1],[-1,7,5,6],"
      "[0,1,3,6],[0,2,-1,3],[0,3,2,1],[0,4,6,-1],[0,6,1,4],[1,3,0,-1],[1,6,-1,0],[2,3,-1,0],"
      "[4,5,7,-1],[4,6,0,7],[4,7,6,5],[5,7,4,-1],[6,7,-1,4]]";
  const std::vector<std::string> before = {R"({"t":0.20258607730012068,"flip":[-1,1,6,3]})",
                                           R"({"t":0.20258616191226472,"flip":[-1,6,7,3]})"};
  const std::string first = R"({"t":1,"flip":[0,3,2,1]})";
  const std::string second = R"({"t":1.0000000999999998,"flip":[4,7,6,5]})";
  const auto judged = [&](const std::vector<std::string>& last) {
    std::vector<std::string> claims = before;
    claims.insert(claims.end(), last.begin(), last.end());
    return verdict(scene, claims, Truth::recorded, horizon, initial);
  };
  EXPECT_EQ(judged({first, second}), Verdict::certified);
  EXPECT_EQ(judged({first}), Verdict::certified);
  EXPECT_EQ(judged({}), Verdict::certified);
  EXPECT_EQ(judged({second}), Verdict::undecided);
}

}  // namespace
}  // namespace voroproof_kernel
