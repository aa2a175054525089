// Hard cases of the predicates: which number type is the first to decide them.
#include "exact/predicates.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "exact/rational.h"
#include "tests/exact/fraction.h"
#include "tests/exact/powers.h"
#include "tests/exact/predicate_sites.h"
#include "tests/exact/predicate_tiers.h"

namespace voroproof::internal::testing {
namespace {

struct HardCase {
  std::string name;
  Four four;
  Question question;
  Decision expected;
  bool turned = false;
};

void expect_decided(const std::vector<HardCase>& cases) {
  for (const HardCase& c : cases) {
    EXPECT_EQ(first_decision(c.question, c.four, c.turned), c.expected) << c.name;
  }
}

// Counterclockwise on the unit circle, the last moved out by `gap`.
Four points_on_circle(const Rational& gap, const Rational& scale = 1) {
  const Rational s = scale;
  return {{{{s, 0, 0}, {0, s, 0}, {-s, 0, 0}, {0, -s * (1 + gap), 0}}}};
}

// Radii 1, 2, 3 and 5 or, in the place `wall`, the container of radius 10. Around the unit circle,
// which all touch; the last moved out by `gap`.
Four disks_on_circle(const Rational& gap, int wall = -1) {
  const Site<Rational> circle{0, 0, 1};
  const Unit to[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const int radii[4] = {1, 2, 3, 5};
  Four four{{}, wall};
  for (int k = 0; k < 4; ++k) {
    four.at[k] = set_on(circle, to[k], k == wall ? -10 : radii[k]);
  }
  four.at[3].y += wall == 3 ? gap : Rational(-gap);
  return four;
}

constexpr auto plus = Sign::positive, minus = Sign::negative, none = Sign::zero;

// f is minus the square of C for points, so that it takes twice the bits; the in-circle function
// of equal radii waits for it.
TEST(HardCase, NearlyCocircularPoints) {
  std::vector<HardCase> cases;
  struct Row {
    int bits, by_c, by_f;
  };
  for (const auto& [bits, by_c, by_f] :
       {Row{20, in_doubles, in_doubles}, Row{30, in_doubles, in_double_doubles},
        Row{60, in_double_doubles, 144}, Row{120, 144, 256}, Row{400, 480, 928}}) {
    for (const bool turned : {false, true}) {
      const std::string name = std::to_string(bits) + (turned ? " turned" : "");
      const Four out = points_on_circle(hair(bits)), in = points_on_circle(-hair(bits));
      cases.push_back({"outside " + name, out, Question::cocircularity, {plus, by_c}, turned});
      cases.push_back({"inside " + name, in, Question::cocircularity, {minus, by_c}, turned});
      cases.push_back({"outside, f " + name, out, Question::cotangency, {minus, by_f}, turned});
      cases.push_back({"inside, f " + name, in, Question::cotangency, {minus, by_f}, turned});
      cases.push_back({"outside, q " + name, out, Question::in_circle, {plus, by_f}, turned});
      cases.push_back({"inside, q " + name, in, Question::in_circle, {minus, by_f}, turned});
    }
  }
  expect_decided(cases);
}

// Disks of different radii: f has a simple zero and changes its sign with q.
TEST(HardCase, NearlyCotangentDisks) {
  std::vector<HardCase> cases;
  struct Row {
    int bits, tier;
  };
  for (const auto& [bits, tier] : {Row{30, in_doubles}, Row{60, in_double_doubles}, Row{120, 144},
                                   Row{200, 256}, Row{400, 480}}) {
    for (int wall = -1; wall < 4; ++wall) {
      const std::string name = std::to_string(bits) + " wall " + std::to_string(wall);
      const Sign outside = wall == 3 ? minus : plus;
      const Four out = disks_on_circle(hair(bits), wall), in = disks_on_circle(-hair(bits), wall);
      cases.push_back({"outside " + name, out, Question::in_circle, {outside, tier}});
      cases.push_back({"inside " + name, in, Question::in_circle, {-outside, tier}});
    }
  }
  expect_decided(cases);
}

// Nothing is called zero for being small: doubles and double-doubles cannot tell, balls only where
// nothing was rounded.
TEST(HardCase, Ties) {
  const Four points = points_on_circle(0);
  Four fractions = points;
  const Rational tangents[] = {fraction(1, 3), fraction(2, 5), 3, -7};
  for (int k = 0; k < 4; ++k) {
    fractions.at[k] = set_on({fraction(1, 3), 2, fraction(5, 7)}, unit(tangents[k]), 0);
  }
  // Of 301 bits. C has four times as many, f eight times. Where both parts of q vanish f is not
  // asked.
  const Four large = points_on_circle(0, 1 + hair(300));
  std::vector<HardCase> cases = {
      {"C of 301 bits", large, Question::cocircularity, {none, 1824}},
      {"f of 301 bits", large, Question::cotangency, {none, exactly}},
      {"q of 301 bits", large, Question::in_circle, {none, 1824}},
  };
  for (const Question question :
       {Question::cotangency, Question::cocircularity, Question::in_circle}) {
    cases.push_back({"integers", points, question, {none, 144}});
    cases.push_back({"fractions", fractions, question, {none, exactly}});
    cases.push_back({"irrational", points, question, {none, exactly}, true});
  }
  for (int wall = -1; wall < 4; ++wall) {
    const std::string name = "disks, wall " + std::to_string(wall);
    for (const Question question : {Question::cotangency, Question::in_circle}) {
      cases.push_back({name, disks_on_circle(0, wall), question, {none, 144}});
      cases.push_back({name, disks_on_circle(0, wall), question, {none, exactly}, true});
    }
  }
  expect_decided(cases);
}

// Two circles touch three disks in a row, one above and one below. A fourth that touches the upper
// makes f vanish, and is certainly outside of the lower.
TEST(HardCase, TieWithTheOtherCircle) {
  const Site<Rational> left{-5, 0, 2}, middle{0, 0, 1}, right{5, 0, 2}, top{0, 24, 1};
  const Four upper{{left, middle, right, top}}, lower{{right, middle, left, top}};
  expect_decided({
      {"f", lower, Question::cotangency, {none, 144}},
      {"f, irrational", lower, Question::cotangency, {none, exactly}, true},
      {"q of the upper", upper, Question::in_circle, {none, 144}},
      {"q of the lower", lower, Question::in_circle, {plus, in_doubles}},
      {"q of the lower, irrational", lower, Question::in_circle, {plus, in_doubles}, true},
      {"the upper exists", upper, Question::exists, {plus, in_doubles}},
      {"the lower exists", lower, Question::exists, {plus, in_doubles}},
  });
}

// A radius that is more than that of the others by a hair: f is no square any more, but hardly.
TEST(HardCase, NearlyEqualRadii) {
  std::vector<HardCase> cases;
  struct Row {
    int bits, tier;
  };
  for (const auto& [bits, tier] : {Row{20, in_doubles}, Row{30, in_double_doubles}, Row{60, 144},
                                   Row{120, 256}, Row{400, 928}}) {
    Four four = points_on_circle(0);
    four.at[3].r = hair(bits);
    cases.push_back({std::to_string(bits), four, Question::in_circle, {minus, tier}});
    four.at[3].y -= 2 * hair(bits);
    cases.push_back({std::to_string(bits) + " out", four, Question::in_circle, {plus, tier}});
  }
  expect_decided(cases);
}

// Far from the origin integers lose nothing, for their differences are exact; fractions do.
TEST(HardCase, FarFromTheOrigin) {
  const auto moved = [](const Four& four, const Rational& x, const Rational& y) {
    return changed(four, [&](const Site<Rational>& s) -> Site<Rational> {
      return {s.x + x, s.y + y, s.r};
    });
  };
  const Rational far = power_of_two(22), third = power_of_two(30) / 3,
                 seventh = power_of_two(30) / 7;
  const Four points = points_on_circle(hair(30)), disks = disks_on_circle(hair(30));
  constexpr int first = in_doubles, second = in_double_doubles;
  expect_decided({
      {"C, integers", moved(points, far, -far), Question::cocircularity, {plus, first}},
      {"C, fractions", moved(points, third, seventh), Question::cocircularity, {plus, second}},
      {"q, integers", moved(disks, far, -far), Question::in_circle, {plus, first}},
      {"q, fractions", moved(disks, third, seventh), Question::in_circle, {plus, second}},
      {"f, integers", moved(points, far, -far), Question::cotangency, {minus, second}},
      {"f, fractions", moved(points, third, seventh), Question::cotangency, {minus, second}},
  });
}

// f has the eighth power of the scale, which leaves the range of doubles long before C does.
TEST(HardCase, LargeAndSmallScales) {
  std::vector<HardCase> cases;
  for (const int bits : {-200, 200}) {
    const std::string name = "scale " + std::to_string(bits);
    const Four four = points_on_circle(hair(10), power_of_two(bits));
    cases.push_back({name + ", C", four, Question::cocircularity, {plus, in_doubles}});
    cases.push_back({name + ", f", four, Question::cotangency, {minus, 144}});
    cases.push_back({name + ", q", four, Question::in_circle, {plus, 144}});
  }
  for (const int bits : {-300, 300}) {
    const std::string name = "scale " + std::to_string(bits);
    const Four four = points_on_circle(hair(10), power_of_two(bits));
    cases.push_back({name + ", C", four, Question::cocircularity, {plus, 144}});
  }
  expect_decided(cases);
}

// Three in a row, and three disks on one line: where a circle begins to exist.
TEST(HardCase, CirclesThatNearlyExist) {
  std::vector<HardCase> cases;
  struct Row {
    int bits, tier;
  };
  for (const auto& [bits, tier] : {Row{20, in_doubles}, Row{60, in_double_doubles}, Row{120, 144},
                                   Row{200, 256}, Row{400, 480}}) {
    for (const Sign side : {plus, minus}) {
      const Rational off = side == plus ? hair(bits) : Rational(-hair(bits));
      const std::string name = std::to_string(bits) + (side == plus ? "+" : "-");
      // A turn to the left makes them counterclockwise.
      const Four row{{{{-3, -2, 1}, {0, 0, 1}, {3, 2 + off, 1}, {}}}};
      cases.push_back({"row " + name, row, Question::exists, {side, tier}});
      // On the line y = 0, seen from below: the one in the middle has to be above it.
      const Four line{{{{9, 3, 3}, {4, 2 + off, 2}, {0, 1, 1}, {}}}};
      cases.push_back({"line " + name, line, Question::exists, {side, tier}});
    }
  }
  const Four row{{{{-3, -2, 1}, {0, 0, 1}, {3, 2, 1}, {}}}};
  const Four line{{{{9, 3, 3}, {4, 2, 2}, {0, 1, 1}, {}}}};
  for (const Four& four : {row, line}) {
    cases.push_back({"tie", four, Question::exists, {none, 144}});
    cases.push_back({"tie, irrational", four, Question::exists, {none, exactly}, true});
  }
  expect_decided(cases);
}

}  // namespace
}  // namespace voroproof::internal::testing
