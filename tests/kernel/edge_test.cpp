// In-circle signs, existence and collapses against circles that are known beforehand: generators
// are put around a given circle at rational directions, so that geometry needs no approximation.
#include "certify/kernel/edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace voroproof_kernel {
namespace {

// The direction of parameter m, increasing counterclockwise for m in (-oo, oo).
Vec direction(const Rat& m) {
  const Rat d = 1 + m * m;
  return {Rat((1 - m * m) / d), Rat(2 * m / d)};
}

// A generator whose boundary is `away` from the circle about (3, -2) of radius `rho`.
Leg placed(const Rat& m, const Rat& r, const Rat& rho, const Rat& away, const Vec& v = {0, 0},
           bool wall = false) {
  const Vec u = direction(m);
  const Rat far = wall ? Rat(-(r - rho - away)) : Rat(rho + r + away);
  return Leg(0, {Rat(3 + far * u[0]), Rat(far * u[1] - 2)}, v, wall ? Rat(-r) : r);
}

struct Placed {
  std::vector<Leg> legs;
  Quad quad;
  Four four() const { return {quad, {&legs[0], &legs[1], &legs[2], &legs[3]}}; }
  std::optional<Collapse> first_collapse(const Rat& a, const Rat& b) const {
    Notes notes;
    return voroproof_kernel::first_collapse(four(), a, b, notes);
  }
};

// Contacts in the order l, s, r, e; `wall`: which of l, r, s, e is the container.
Placed around_circle(std::mt19937& rng, const Rat& away, int wall, bool equal) {
  std::vector<Rat> m;
  while (m.size() < 4) {
    const Rat next(static_cast<int>(rng() % 4001) - 2000, 300);
    if (std::find(m.begin(), m.end(), next) == m.end()) m.push_back(next);
  }
  std::sort(m.begin(), m.end());
  const int order[4] = {0, 2, 1, 3};  // of l, r, s, e by their contacts
  const Rat rho(static_cast<int>(1 + rng() % 50), 7);
  Placed four{{}, {0, 1, 2, 3}};
  int* ids[4] = {&four.quad.l, &four.quad.r, &four.quad.s, &four.quad.e};
  if (wall >= 0) *ids[wall] = container;
  for (int k = 0; k < 4; ++k) {
    const Rat r = k == wall ? Rat(100) : equal ? Rat(1, 3) : Rat(static_cast<int>(rng() % 40), 9);
    four.legs.push_back(placed(m[order[k]], r, rho, k == 3 ? away : Rat(0), {0, 0}, k == wall));
  }
  return four;
}

TEST(KernelEdge, InCircleIsWhereTheFourthLies) {
  std::mt19937 rng(1);
  Rat tiny = 1;
  for (int k = 0; k < 40; ++k) tiny /= 10;
  for (int n = 0; n < 400; ++n) {
    const int wall = n % 5 - 1;
    const bool equal = n % 3 == 0;
    for (const Rat& away : {Rat(1, 1000), tiny, Rat(0), Rat(-tiny), Rat(-1, 1000)}) {
      Placed four = around_circle(rng, away, wall, equal);
      EXPECT_EQ(four.four().incircle(0, true), sgn(away)) << n;
      EXPECT_EQ(four.four().exists(0, true), 1) << n;
      // The circle (l,r,e) is the same but for `away`.
      if (away == 0) {
        EXPECT_EQ(four.four().incircle(0, false), 0) << n;
      }
    }
  }
}

TEST(KernelEdge, TheOtherOrientationIsAnotherCircle) {
  // Three equal disks in a row, far from the wall: no circle touches them clockwise and
  // counterclockwise at once.
  std::mt19937 rng(2);
  for (int n = 0; n < 100; ++n) {
    Placed four = around_circle(rng, 0, -1, true);
    std::swap(four.quad.l, four.quad.r);
    std::swap(four.legs[0], four.legs[1]);
    EXPECT_LT(four.four().exists(0, true), 1) << n;
  }
}

// Whether the fourth is apart from the others at t.
bool apart(const Placed& four, const Rat& t) {
  for (int k = 0; k < 3; ++k) {
    const Leg &a = four.legs[k], &e = four.legs[3];
    const Rat gap = norm2(minus(a.at(t), e.at(t))) - square(Rat(a.radius + e.radius));
    if (a.radius < 0 || e.radius < 0 ? gap >= 0 : gap <= 0) return false;
  }
  return true;
}

TEST(KernelEdge, AFourthThatComesCollapsesTheEdgeOnce) {
  std::mt19937 rng(3);
  int tried = 0;
  for (int n = 0; n < 400; ++n) {
    const int wall = n % 4 - 1;
    Placed four = around_circle(rng, 0, wall, n % 3 == 0);
    Leg& e = four.legs[3];
    // e moves towards the circle's centre and touches at t = 2/3.
    const Rat when(2, 3);
    const Vec v{Rat((3 - e.from[0]) / 50), Rat((-2 - e.from[1]) / 50)};
    e = Leg(0, {Rat(e.from[0] - v[0] * when), Rat(e.from[1] - v[1] * when)}, v, e.radius);
    if (!apart(four, 0) || !apart(four, when) || !apart(four, 1)) continue;
    ++tried;
    auto found = four.first_collapse(0, 1);
    ASSERT_TRUE(found) << n;
    EXPECT_EQ(compare(found->at, when), 0) << n;
    EXPECT_FALSE(four.first_collapse(0, Rat(66, 100))) << n;
    EXPECT_FALSE(four.first_collapse(0, when)) << n;  // the open interval
    auto near = collapse_near(four.four(), 0, when);
    if (near) {
      EXPECT_EQ(compare(near->at, when), 0) << n;
    }
    auto later = four.first_collapse(Rat(67, 100), 1);
    ASSERT_TRUE(later) << n;
    EXPECT_TRUE(later->at.is_point());
  }
  EXPECT_GT(tried, 50);
}

// The fourth is on the circle at the beginning and enters it: whatever roots follow, also of the
// other circle, the collapse is at the beginning. It leaves again.
TEST(KernelEdge, ACollapseAtTheBeginning) {
  std::mt19937 rng(5);
  int tried = 0;
  for (int n = 0; n < 1000; ++n) {
    Placed four = around_circle(rng, 0, n % 4 - 1, n % 3 == 0);
    Leg& e = four.legs[3];
    const Vec in = minus({3, -2}, e.from);
    const Rat side(static_cast<int>(rng() % 401) - 200, 100);
    const Vec v{Rat(in[0] - side * in[1]), Rat(in[1] + side * in[0])};
    const Rat speed = n % 2 == 0 ? Rat(1, 4) : Rat(1, 40);
    e = Leg(0, e.from, {Rat(v[0] * speed), Rat(v[1] * speed)}, e.radius);
    const Rat soon(1, 1000), end(3);
    bool valid = e.radius >= 0 && apart(four, 0) && apart(four, soon) && apart(four, end);
    for (int k = 1; valid && k < 30; ++k) valid = apart(four, Rat(k, 10));
    if (!valid || four.four().incircle(soon, true) >= 0) continue;
    ++tried;
    for (const Rat& b : {soon, Rat(1, 2), Rat(1), Rat(2), end}) {
      auto found = four.first_collapse(0, b);
      ASSERT_TRUE(found) << n;
      EXPECT_EQ(compare(found->at, Rat(0)), 0) << n;
    }
  }
  EXPECT_GT(tried, 100);
}

// The fourth comes to the circle between l and s: the circle of the end is another, which it need
// not touch, and an edge does not collapse at one end only.
TEST(KernelEdge, NoQuickCollapseOfOneEnd) {
  std::mt19937 rng(6);
  int tried = 0;
  for (int n = 0; n < 400; ++n) {
    Placed four = around_circle(rng, 0, n % 4 - 1, n % 3 == 0);
    std::swap(four.legs[1], four.legs[3]);
    std::swap(four.quad.r, four.quad.e);
    std::swap(four.legs[2], four.legs[3]);
    std::swap(four.quad.s, four.quad.e);
    Leg& e = four.legs[3];
    const Rat when(2, 3);
    const Vec v{Rat((3 - e.from[0]) / 50), Rat((-2 - e.from[1]) / 50)};
    e = Leg(0, {Rat(e.from[0] - v[0] * when), Rat(e.from[1] - v[1] * when)}, v, e.radius);
    const Four at = four.four();
    const Rat lo(66, 100), hi(67, 100);
    if (e.radius < 0 || at.incircle(lo, true) <= 0 || at.incircle(hi, true) >= 0) continue;
    if (at.incircle(hi, false) <= 0) continue;
    ++tried;
    EXPECT_FALSE(collapse_near(at, lo, when)) << n;
  }
  EXPECT_GT(tried, 20);
}

// Equal points, the fourth turns around on the circle: contact of even order, no collapse.
TEST(KernelEdge, AContactOfEvenOrderIsNoCollapse) {
  Placed four{{Leg(0, {1, 0}, {0, 0}, 0), Leg(0, {-1, 0}, {0, 0}, 0), Leg(0, {0, 1}, {0, 0}, 0),
               Leg(0, {-1, -1}, {1, 0}, 0)},
              {0, 1, 2, 3}};
  // e passes along the tangent at (0, -1)
  EXPECT_FALSE(four.first_collapse(0, 2));
  four.legs[3] = Leg(0, {-1, Rat(-999, 1000)}, {1, 0}, 0);
  EXPECT_TRUE(four.first_collapse(0, 2));
}

// Four cocircular points at rest: the dual of the edge joins the largest id to its opposite.
TEST(KernelEdge, TheRuleOfTheLargestId) {
  Placed four{{Leg(0, {1, 0}, {0, 0}, 0), Leg(0, {-1, 0}, {0, 0}, 0), Leg(0, {0, 1}, {0, 0}, 0),
               Leg(0, {0, -1}, {0, 0}, 0)},
              {3, 1, 2, 0}};
  EXPECT_FALSE(four.first_collapse(0, 1));
  four.quad = {0, 1, 2, 3};
  EXPECT_TRUE(four.first_collapse(0, 1));
}

TEST(KernelEdge, TheCirclesAreOneWhereTheyAre) {
  std::mt19937 rng(4);
  for (int n = 0; n < 200; ++n) {
    Placed four = around_circle(rng, 0, n % 5 - 1, n % 3 == 0);
    Instant now = at(0);
    EXPECT_TRUE(one_circle(four.four(), now)) << n;
  }
}

// All centres on the axis: two circles, mirror images, touch the four, and the edge leads from the
// one to the other.
TEST(KernelEdge, TwoCirclesTouchTheSameFour) {
  Placed four{
      {Leg(0, {-3, 0}, {0, 0}, 1), Leg(0, {3, 0}, {0, 0}, 1),
       Leg(0, {Rat(-7, 6), 0}, {0, 0}, Rat(1, 6)), Leg(0, {Rat(7, 6), 0}, {0, 0}, Rat(1, 6))},
      {0, 1, 2, 3}};
  for (const bool start : {true, false}) {
    EXPECT_EQ(four.four().exists(0, start), 1);
    EXPECT_EQ(four.four().incircle(0, start), 0);
  }
  Instant now = at(0);
  EXPECT_FALSE(one_circle(four.four(), now));
}

TEST(KernelEdge, SignWithRoot) {
  EXPECT_EQ(sign_with_root(3, -2, 2), 1);  // 3 - 2 sqrt 2
  EXPECT_EQ(sign_with_root(-3, 2, 2), -1);
  EXPECT_EQ(sign_with_root(-2, 2, 2), 1);
  EXPECT_EQ(sign_with_root(-4, 2, 4), 0);
  EXPECT_EQ(sign_with_root(0, -1, 5), -1);
  EXPECT_EQ(sign_with_root(0, -1, 0), 0);
}

}  // namespace
}  // namespace voroproof_kernel
