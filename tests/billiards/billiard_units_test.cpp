// Verdicts do not depend on the units of length and time, nor on names, places and mirrors.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "history/json_text.h"
#include "tests/billiards/billiard_cases.h"

namespace voroproof::internal::testing {
namespace {

// Lengths are multiplied by 2^length, times by 2^time; then places are moved, and axes mirrored.
struct Frame {
  int length = 0, time = 0;
  double shift = 0;
  int mirror = 1;

  std::string number(double x, int exponent) const { return number_text(std::ldexp(x, exponent)); }
  std::string t(double x) const { return number(x, time); }
  std::string size(double x) const { return number(x, length); }
  std::string place(double x, double y) const {
    return "[" + size(mirror * x + shift) + "," + size(y - 2 * shift) + "]";
  }
  std::string speed(double x, double y) const {
    return "[" + number(mirror * x, length - time) + "," + number(y, length - time) + "]";
  }
};

// A box with a floor, two disks that meet through the side, and one that falls on the floor: with
// that gravity, 1 or 0, in 2 units of time.
BilliardCase sample(const Frame& f, int gravity) {
  const auto disk = [&](double x, double y, double vx, double vy) {
    return R"({"center":)" + f.place(x, y) + R"(,"radius":)" + f.size(0.5) + R"(,"velocity":)" +
           f.speed(vx, vy) + "}";
  };
  const std::string fall = f.number(-gravity, f.length - 2 * f.time);
  BilliardCase c;
  c.members = R"("gravity":[0,)" + fall + R"(],"frame":{"periodic":[)" + f.size(8) +
              R"(,null],"walls":[{"normal":[0,1],"offset":)" + f.size(-2 * f.shift) +
              R"(}]},"disks":[)" + disk(1, 20, -1, 0) + "," + disk(6, 20, 1, 0) + "," +
              disk(3.5, 2.5, 0, gravity - 1) + "]";
  c.horizon = f.t(3);
  c.tolerance = to_rational(std::ldexp(1, f.time - 20));
  const double y = 20 - gravity / 2.0;
  c.events = {
      R"({"t":)" + f.t(1) + R"(,"collide":[0,1],"image":[)" + std::to_string(-f.mirror) +
          R"(,0],"v":[)" + f.speed(1, -gravity) + "," + f.speed(-1, -gravity) + R"(],"p":[)" +
          f.place(0, y) + "," + f.place(7, y) + "]}",
      R"({"t":)" + f.t(2) + R"(,"collide":[-1,2],"v":[null,)" + f.speed(0, 1 + gravity) + "]}"};
  c.collisions = 2;
  return c;
}

void expect_same(const Frame& f) {
  const auto is = [&](const BilliardCase& c, Verdict verdict, const char* what) {
    const Certificate found = c.judge();
    EXPECT_EQ(found.verdict, verdict)
        << what << ", length 2^" << f.length << ", time 2^" << f.time << ", shift " << f.shift
        << ": " << (found.divergence ? found.divergence->truth : found.reason);
  };
  for (const int gravity : {0, 1}) {
    const BilliardCase right = sample(f, gravity);
    is(right, Verdict::certified, "right");
    for (const std::size_t k : {0U, 1U}) {
      BilliardCase wrong = right;
      wrong.events.erase(wrong.events.begin() + static_cast<std::ptrdiff_t>(k));
      wrong.collisions = 1;
      is(wrong, Verdict::refuted, "missing");
    }
  }
  // Within the tolerance, and not.
  const auto late = [&](double by, std::size_t k) {
    BilliardCase c = sample(f, 0);
    const double t = k == 0 ? 1 : 2;
    const std::string from = R"({"t":)" + f.t(t) + ",", to = R"({"t":)" + f.t(t + by) + ",";
    c.events[k].replace(0, from.size(), to);
    return c;
  };
  for (const double sign : {-1.0, 1.0}) {
    is(late(sign * 0x1p-21, 0), Verdict::certified, "nearly in time");
    is(late(sign * 0x1p-19, 0), Verdict::refuted, "out of time");
    is(late(sign * 0x1p-19, 1), Verdict::refuted, "out of time at the floor");
  }
}

TEST(BilliardUnits, AnyUnit) {
  for (const int length : {-120, -60, -20, 0, 20, 60, 120}) {
    for (const int time : {-100, -50, -20, 0, 20, 50, 100}) expect_same({length, time, 0, 1});
  }
}

TEST(BilliardUnits, AnyPlaceAndTheMirror) {
  for (const double shift : {0x1p10, -0x1p20, 0x1p27}) {
    for (const int mirror : {-1, 1}) expect_same({0, 0, shift, mirror});
  }
}

// Which of the two is told first does not matter, nor which image of a disk the scene has.
TEST(BilliardUnits, OtherNamesAndImages) {
  BilliardCase c = sample({}, 1);
  const auto exchange = [&](const std::string& from, const std::string& to) {
    const std::size_t at = c.members.find(from);
    ASSERT_NE(at, std::string::npos);
    c.members.replace(at, from.size(), to);
  };
  exchange("\"center\":[6,20]", "\"center\":[-10,20]");
  c.events[0] =
      R"({"t":1,"collide":[0,1],"image":[1,0],"v":[[1,-1],[-1,-1]],"p":[[0,19.5],[-9,19.5]]})";
  EXPECT_EQ(c.judge().verdict, Verdict::certified);
  exchange("{\"center\":[1,20],\"radius\":0.5,\"velocity\":[-1,0]}", "HERE");
  exchange("{\"center\":[-10,20],\"radius\":0.5,\"velocity\":[1,0]}",
           "{\"center\":[1,20],\"radius\":0.5,\"velocity\":[-1,0]}");
  exchange("HERE", "{\"center\":[-10,20],\"radius\":0.5,\"velocity\":[1,0]}");
  c.events[0] =
      R"({"t":1,"collide":[0,1],"image":[-1,0],"v":[[-1,-1],[1,-1]],"p":[[-9,19.5],[0,19.5]]})";
  EXPECT_EQ(c.judge().verdict, Verdict::certified);
}

}  // namespace
}  // namespace voroproof::internal::testing
