// True witnesses are confirmed, and false ones are seen.
#include "certify/evidence/evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "library/certification.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

using Wanted = std::function<bool(const Divergence&)>;

// The refutation of a history of a random scene without its k-th event, for the first scene and k
// for which it is of the kind wanted and has a polynomial.
Divergence missing_event(const RandomScene& family, const Wanted& wanted) {
  Random random(5);
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Scene scene = random_scene(family, random);
    const ClaimedHistory right = claimed_history(scene, run(scene));
    for (std::size_t k = 0; k < std::min<std::size_t>(right.events.size(), 10); ++k) {
      ClaimedHistory wrong = right;
      wrong.events.erase(wrong.events.begin() + k);
      wrong.count();
      const Certificate c = certify(scene, wrong);
      if (c.divergence && !c.divergence->witness.polynomial.empty() && wanted(*c.divergence)) {
        return *c.divergence;
      }
    }
  }
  throw std::logic_error("no such refutation");
}

// The place of the container among the generators of the witness, -1 if it is none of them.
int place_of_container(const Divergence& d) {
  const auto& all = d.witness.generators;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].id == container_id) return static_cast<int>(k);
  }
  return -1;
}

enum class Container { absent, crossing, traversing };  // in l or r, in s or e

Divergence missing_flip(Container container) {
  return missing_event({.n = 8, .horizon = 15}, [=](const Divergence& d) {
    const int place = place_of_container(d);
    const Container is = place < 0   ? Container::absent
                         : place < 2 ? Container::crossing
                                     : Container::traversing;
    return d.true_flip && is == container;
  });
}
Divergence missing_flip_of_equal_radii() {
  return missing_event({.n = 8, .rmin = 5, .rmax = 5, .horizon = 15}, [](const Divergence& d) {
    return d.witness.polynomial_is == "cocircularity";
  });
}
Divergence missing_contact(bool with_container) {
  return missing_event({.n = 8, .horizon = 15}, [=](const Divergence& d) {
    return d.true_contact && (place_of_container(d) >= 0) == with_container;
  });
}

// Four disks at rest around a fifth generator's place: the vertex [0, 1, 2] and disk 3.
Divergence conflict(int x, int y) {
  Divergence d;
  d.fault = Fault::wrong_initial_diagram;
  const auto disk = [](GenId id, int cx, int cy, const std::string& vx) {
    const auto n = [](int value) { return EvidenceNumber{std::to_string(value), {}, {}}; };
    return EvidenceMotion{id, 0, n(cx), n(cy), {vx, {}, {}}, n(0), n(1)};
  };
  // The circle around the origin of radius 9.
  d.witness.generators = {disk(0, 10, 0, "0"), disk(1, 0, 10, "0"), disk(2, -10, 0, "0"),
                          disk(3, x, y, "-1/4")};
  d.witness.t = 4;
  d.witness.vertex = Triple{0, 1, 2};
  d.witness.conflict = 3;
  return d;
}

// Refutations of all kinds that have something to check.
std::vector<std::pair<std::string, Divergence>> true_witnesses() {
  return {{"flip of disks", missing_flip(Container::absent)},
          {"flip of an edge of the container", missing_flip(Container::crossing)},
          {"flip at the container", missing_flip(Container::traversing)},
          {"flip of equal disks", missing_flip_of_equal_radii()},
          {"contact of disks", missing_contact(false)},
          {"contact with the container", missing_contact(true)},
          {"conflict", conflict(1, -9)}};
}

// The true witnesses that have a root.
std::vector<std::pair<std::string, Divergence>> true_roots() {
  auto all = true_witnesses();
  all.pop_back();
  return all;
}

Evidence evidence_of(const Divergence& d) { return check_evidence(d).evidence; }

TEST(Evidence, TrueWitnessesAreConfirmed) {
  for (const auto& [name, d] : true_witnesses()) {
    const EvidenceCheck check = check_evidence(d);
    EXPECT_EQ(check.evidence, Evidence::confirmed) << name << ": " << check.sentence;
  }
}

TEST(Evidence, ShiftedIntervalIsSeen) {
  for (auto [name, d] : true_roots()) {
    auto& [lo, hi] = *d.witness.root;
    const Rational shift = hi - lo + Rational(1, 1 << 20);
    lo += shift;
    hi += shift;
    EXPECT_EQ(check_evidence(d).sentence, "the polynomial has 0 roots in the isolating interval")
        << name;
  }
}

TEST(Evidence, IntervalWithTwoRootsIsSeen) {
  for (auto [name, d] : true_roots()) {
    d.witness.root = {Rational(-1'000'000), Rational(1'000'000)};
    EXPECT_EQ(evidence_of(d), Evidence::contradicted) << name;
  }
}

TEST(Evidence, RootAtAnotherTimeIsSeen) {
  for (auto [name, d] : true_roots()) {
    for (double& t : *d.true_time) t += 0x1p-20;
    EXPECT_EQ(check_evidence(d).sentence, "the root is not at the time of the event") << name;
  }
}

TEST(Evidence, ChangedCoefficientIsSeen) {
  for (const auto& [name, d] : true_roots()) {
    for (std::size_t k = 0; k < d.witness.polynomial.size(); ++k) {
      Divergence wrong = d;
      std::string& c = wrong.witness.polynomial[k].exact;
      c = Rational(Rational(c) * (1 + Rational(1, 1 << 30)) + Rational(1, 1 << 30)).get_str();
      EXPECT_EQ(check_evidence(wrong).sentence, "the polynomial is not that of the motions")
          << name << ", power " << k;
    }
  }
}

TEST(Evidence, NegatedPolynomialIsSeen) {
  for (auto [name, d] : true_roots()) {
    for (EvidenceNumber& c : d.witness.polynomial) c.exact = Rational(-Rational(c.exact)).get_str();
    EXPECT_EQ(evidence_of(d), Evidence::contradicted) << name;
  }
}

TEST(Evidence, WrongMotionIsSeen) {
  for (const auto& [name, d] : true_roots()) {
    for (std::size_t g = 0; g < d.witness.generators.size(); ++g) {
      Divergence wrong = d;
      std::string& x = wrong.witness.generators[g].x.exact;
      x = Rational(Rational(x) + Rational(1, 1 << 30)).get_str();
      EXPECT_EQ(evidence_of(wrong), Evidence::contradicted) << name << ", generator " << g;
    }
  }
}

TEST(Evidence, WrongGeneratorIsSeen) {
  for (const auto& [name, d] : true_witnesses()) {
    for (std::size_t g = 0; g < d.witness.generators.size(); ++g) {
      Divergence wrong = d;
      wrong.witness.generators[g].id += 100;
      EXPECT_EQ(evidence_of(wrong), Evidence::contradicted) << name << ", generator " << g;
    }
  }
}

// The witness has the same polynomial and root, but is of an edge in whose place another flips.
TEST(Evidence, FlipOfAnotherEdgeIsSeen) {
  for (const Divergence& d : {missing_flip(Container::absent), missing_flip(Container::crossing),
                              missing_flip(Container::traversing), missing_flip_of_equal_radii()}) {
    std::array<int, 4> order{0, 1, 2, 3};
    int confirmed = 0;
    do {
      Divergence other = d;
      for (int k = 0; k < 4; ++k) other.witness.generators[k] = d.witness.generators[order[k]];
      const auto& g = other.witness.generators;
      other.true_flip = canonical(Quad{g[0].id, g[1].id, g[2].id, g[3].id});
      if (d.witness.polynomial_is == "cocircularity" &&
          evidence_of(other) == Evidence::contradicted) {
        // An odd permutation has changed the sign of the determinant.
        for (EvidenceNumber& c : other.witness.polynomial) {
          c.exact = Rational(-Rational(c.exact)).get_str();
        }
      }
      confirmed += evidence_of(other) == Evidence::confirmed;
    } while (std::next_permutation(order.begin(), order.end()));
    // The edge by both its names.
    EXPECT_EQ(confirmed, 2) << d.truth;
  }
}

TEST(Evidence, PartingIsNoContact) {
  for (const bool wall : {false, true}) {
    Divergence d = missing_contact(wall);
    const auto& p = d.witness.polynomial;
    const double c = Rational(p[0].exact).get_d(), b = Rational(p[1].exact).get_d(),
                 a = Rational(p[2].exact).get_d();
    const double root = std::sqrt(b * b - 4 * a * c);
    const double parting = (wall ? -b - root : -b + root) / (2 * a);
    d.witness.root = {to_rational(parting - 1e-6), to_rational(parting + 1e-6)};
    d.true_time = {parting - 1e-6, parting + 1e-6};
    EXPECT_EQ(check_evidence(d).sentence, "the generators do not approach at the root");
  }
}

TEST(Evidence, OverlapWhereThereIsNoneIsSeen) {
  for (const bool wall : {false, true}) {
    Divergence d = missing_contact(wall);
    const auto [lo, hi] = *d.witness.root;
    d.witness.root.reset();
    d.witness.t = hi + Rational(1, 1 << 20);
    EXPECT_EQ(check_evidence(d).sentence, "confirmed by CGAL's exact numbers");
    d.witness.t = lo - Rational(1, 1 << 20);
    EXPECT_EQ(check_evidence(d).sentence, "the generators do not overlap at the time given");
  }
}

TEST(Evidence, ConflictWhereThereIsNoneIsSeen) {
  // Disk 3 lies at (x - 1, y) then; the circle reaches to 9, so that one at 10 touches it.
  EXPECT_EQ(evidence_of(conflict(1, -9)), Evidence::confirmed);
  EXPECT_EQ(evidence_of(conflict(1, -10)), Evidence::contradicted);
  EXPECT_EQ(evidence_of(conflict(1, -11)), Evidence::contradicted);
  // At another time it is elsewhere.
  Divergence later = conflict(1, -9);
  later.witness.t = 40;
  EXPECT_EQ(evidence_of(later), Evidence::contradicted);
  // The vertex of the other orientation has no circle.
  Divergence mirrored = conflict(1, -9);
  mirrored.witness.vertex = Triple{0, 2, 1};
  std::swap(mirrored.witness.generators[1], mirrored.witness.generators[2]);
  EXPECT_EQ(check_evidence(mirrored).sentence, "the circle of the vertex does not exist");
}

TEST(Evidence, BoundsAreNotChecked) {
  for (auto [name, d] : true_witnesses()) {
    for (EvidenceNumber* n : {&d.witness.generators[1].x, &d.witness.generators[1].vy}) {
      *n = {{}, "0", "1"};
    }
    d.witness.polynomial.clear();
    EXPECT_EQ(evidence_of(d), Evidence::not_checkable) << name;
  }
}

TEST(Evidence, MotionsAloneAreNone) {
  for (auto [name, d] : true_witnesses()) {
    d.witness.root.reset();
    d.witness.t.reset();
    EXPECT_EQ(evidence_of(d), Evidence::none) << name;
  }
}

// The motions are rational, so the polynomial must be there.
TEST(Evidence, RootWithoutPolynomialIsSeen) {
  for (auto [name, d] : true_roots()) {
    d.witness.polynomial.clear();
    EXPECT_EQ(evidence_of(d), Evidence::contradicted) << name;
  }
}

// A disk passes through another, and turns before the tolerance is over: the overlap is one of the
// lines before. With `claimed` the two have a line there for another entry.
TEST(Evidence, OverlapsBeforeATurnAreConfirmed) {
  const Scene scene =
      scene_of(10, to_rational(1.2e-6), {disk(0, 0, 1, 0, 0), disk(4, 0, 1, -2e7, 0)});
  for (const bool claimed : {false, true}) {
    ClaimedHistory wrong = claimed_history(scene, run(scene));
    wrong.events = {
        CollideEvent{.t = 6.5e-7, .i = container_id, .j = 1, .v = {std::nullopt, Vec2{2e7, 0}}}};
    if (claimed) {
      wrong.events.emplace_back(
          CollideEvent{.t = 7.5e-7, .i = 0, .j = 1, .v = {Vec2{2e7, 0}, Vec2{0, 0}}});
    }
    wrong.count();
    for (const EventKinds events : {EventKinds::all, EventKinds::collisions}) {
      CertifyOptions options;
      options.truth = Truth::recorded;
      options.events = events;
      const Certificate c = certify(scene, wrong, options);
      ASSERT_EQ(c.verdict, Verdict::refuted);
      const EvidenceCheck check = check_evidence(*c.divergence);
      EXPECT_EQ(check.evidence, Evidence::confirmed) << c.divergence->truth << check.sentence;
    }
  }
}

// An internal error of the program, which names the files to report.
TEST(Evidence, ContradictionIsAnError) {
  Certificate c;
  EXPECT_EQ(checked_evidence(c, "a.scene.json", "a.history.jsonl"), "");
  c.verdict = Verdict::refuted;
  c.divergence = conflict(1, -9);
  EXPECT_EQ(checked_evidence(c, "a.scene.json", "a.history.jsonl"),
            "confirmed by CGAL's exact circles");
  c.divergence = conflict(1, -10);
  try {
    checked_evidence(c, "a.scene.json", "a.history.jsonl");
    FAIL();
  } catch (const std::logic_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("a.scene.json and a.history.jsonl"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
