// What makes edges the diagram of disks at rest: right ones pass, and each that is wrong is found.
#include "certify/resting_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "engine/resting_diagram.h"
#include "exact/names.h"
#include "filtered/motion/given_motion.h"
#include "filtered/search/hidden_disks.h"
#include "filtered/search/resting_ties.h"
#include "tests/support/resting_disks.h"

namespace voroproof::internal::testing {
namespace {

RestingClaim claim_of(const Disks& disks, Frame frame) {
  const bool has_walls = frame == Frame::box;
  RestingClaim claim{
      has_walls ? input_between(disks, {-5, -4, 5, 6}) : input_of(disks, 9), frame, {}, {}};
  TierCounts counts;
  const RestingDiagram d = resting_diagram(claim.input, frame, {}, counts);
  claim.hosts = d.host;
  claim.edges = d.edges;
  return claim;
}

RestingProof proof_of(const RestingClaim& claim, bool filters = true) {
  MotionOptions options;
  options.filters = filters;
  TierCounts counts;
  return resting_proof(claim, options, counts, 1);
}

std::string fault_of(const RestingClaim& claim) {
  const RestingProof proof = proof_of(claim);
  return proof.fault ? proof.fault->truth : "none";
}

// Disks of many kinds: in general position, or on a lattice, where they tie, touch and coincide.
Disks some_disks(Dice& dice, int most = 14) {
  if (dice(0, 1) == 0) return lattice_disks(dice, dice(0, most), dice(1, 4));
  return random_disks(dice, dice(0, most), dice(0, 1) == 0 ? Rational(3, 2) : Rational(5));
}

// VOROPROOF_SETS asks for more.
TEST(RestingProof, RightDiagramsAreProved) {
  Dice dice(11);
  const char* const given = std::getenv("VOROPROOF_SETS");
  const int sets = given == nullptr ? 400 : std::atoi(given);
  for (int round = 0; round < sets; ++round) {
    const Disks disks = some_disks(dice, dice(0, 9) == 0 ? 200 : 14);
    for (const Frame frame : {Frame::plane, Frame::circle, Frame::box}) {
      const RestingClaim claim = claim_of(disks, frame);
      for (const bool filters : {true, false}) {
        SCOPED_TRACE(std::to_string(static_cast<int>(frame)) + text(disks));
        RestingProof proof;
        ASSERT_NO_THROW(proof = proof_of(claim, filters));
        EXPECT_EQ(proof.fault ? proof.fault->truth : "none", "none");
        EXPECT_EQ(proof.chosen_otherwise, 0);
      }
    }
    if (HasFailure()) return;
  }
}

// An edge that is flipped is wrong, unless it has no length. Then other edges are as right.
TEST(RestingProof, AFlippedEdgeIsWrongIfItHasALength) {
  Dice dice(12);
  int wrong = 0, other = 0;
  for (int round = 0; round < 3000; ++round) {
    const Disks disks = some_disks(dice);
    const Frame frame = std::array{Frame::plane, Frame::circle, Frame::box}[dice(0, 2)];
    RestingClaim claim = claim_of(disks, frame);
    std::vector<bool> hidden;
    for (const GenId host : claim.hosts) hidden.push_back(host != visible_disk);
    Diagram diagram = diagram_of(static_cast<int>(hidden.size()), claim.edges, hidden);
    if (diagram.edges() == 0) continue;
    const Diagram::HalfEdge h = 2 * dice(0, diagram.edges() - 1);
    const Quad q = diagram.quad(h);
    if (q.s == q.e) continue;
    const GivenMotion motion(claim.input, {});
    const bool is_point = RestingTies(motion, frame).is_point(q);
    diagram.flip(h);
    claim.edges = diagram.quads();
    const RestingProof proof = proof_of(claim);
    EXPECT_EQ(proof.fault.has_value(), !is_point) << text_of(q) << text(disks);
    EXPECT_EQ(proof.chosen_otherwise > 0, is_point) << text_of(q) << text(disks);
    ++(is_point ? other : wrong);
    if (HasFailure()) return;
  }
  EXPECT_GT(wrong, 100);
  EXPECT_GT(other, 10);
}

// The verdict on a right or wrong claim is that of its image under exact maps: other units, another
// origin, a reflection, other ids, and in the plane one number added to all radii.
TEST(RestingProof, ExactMapsKeepTheVerdict) {
  Dice dice(15);
  int wrong = 0;
  for (int round = 0; round < 600; ++round) {
    const Disks disks = some_disks(dice);
    const Frame frame = dice(0, 1) == 0 ? Frame::plane : Frame::circle;
    RestingClaim claim = claim_of(disks, frame);
    const auto n = static_cast<GenId>(disks.size());
    std::vector<bool> hidden;
    for (const GenId host : claim.hosts) hidden.push_back(host != visible_disk);
    Diagram diagram = diagram_of(n, claim.edges, hidden);
    const Diagram::HalfEdge h = diagram.edges() == 0 ? -1 : 2 * dice(0, diagram.edges() - 1);
    if (h >= 0 && dice(0, 1) == 0 && diagram.quad(h).s != diagram.quad(h).e) diagram.flip(h);
    claim.edges = diagram.quads();
    claim.hosts.clear();
    const bool is_right = fault_of(claim) == "none";
    wrong += is_right ? 0 : 1;

    RestingClaim image = claim;
    const Rational scale = to_rational(dice(0, 1) == 0 ? 0x1p-80 : 0x1p80), shift = dice(-9, 9);
    const Rational more = frame == Frame::plane ? dice(0, 3) : 0;
    image.input.container_x += shift;
    image.input.container_x *= -scale;
    image.input.container_radius *= scale;
    for (GenId g = 0; g < n; ++g) {
      const Disk& d = disks[g];
      image.input.disks[n - 1 - g] = {Rational(-scale * (d.x + shift)),
                                      Rational(scale * d.y),
                                      Rational(scale * (d.r + more)),
                                      0,
                                      0,
                                      1};
    }
    for (Quad& q : image.edges) {
      const auto name = [&](GenId g) { return g < 0 ? g : n - 1 - g; };
      q = {name(q.r), name(q.l), name(q.s), name(q.e)};
    }
    // Of disks that are equal another one is hidden then.
    const bool same_hidden = [&] {
      const std::vector<GenId> hosts = hosts_of(image.input, frame);
      for (GenId g = 0; g < n; ++g) {
        if ((hosts[n - 1 - g] != visible_disk) != hidden[g]) return false;
      }
      return true;
    }();
    if (!same_hidden) continue;
    EXPECT_EQ(fault_of(image) == "none", is_right) << text(disks);
    if (HasFailure()) return;
  }
  EXPECT_GT(wrong, 100);
}

// The other orientation everywhere: every cell winds the wrong way.
TEST(RestingProof, AMirrorImageIsWrong) {
  Dice dice(13);
  for (int round = 0; round < 60; ++round) {
    const Disks disks = random_disks(dice, 8, 1);
    for (const Frame frame : {Frame::plane, Frame::circle}) {
      RestingClaim claim = claim_of(disks, frame);
      if (claim.edges.size() <= 3) continue;  // two disks are their own image
      for (Quad& q : claim.edges) q = canonical(Quad{q.r, q.l, q.s, q.e});
      EXPECT_NE(fault_of(claim), "none") << text(disks);
    }
  }
}

// Five disks around a sixth, told in the order of a pentagram: all circles exist, all edges are
// legal, and the cells of the sixth and of the frame wind twice.
TEST(RestingProof, ACellThatWindsTwiceIsWrong) {
  const int corner[5][2] = {{5, 0}, {2, 5}, {-4, 3}, {-4, -3}, {2, -5}};
  for (const int step : {1, 2}) {
    Disks disks;
    std::vector<Quad> quads;
    for (int k = 0; k < 5; ++k) {
      const auto& [x, y] = corner[k * step % 5];
      disks.push_back({x, y, 1});
      const int before = (k + 4) % 5, after = (k + 1) % 5;
      for (const Quad& q : {Quad{5, k, before, after}, {k, after, -1, 5}, {-1, k, after, before}}) {
        quads.push_back(canonical(q));
      }
    }
    disks.push_back({0, 0, 1});
    for (const Frame frame : {Frame::plane, Frame::circle}) {
      for (const bool filters : {true, false}) {
        const RestingProof proof = proof_of({input_of(disks, 50), frame, {}, quads}, filters);
        EXPECT_EQ(proof.fault ? proof.fault->truth.substr(0, 31) : "none",
                  step == 1 ? "none" : "the vertices around generator -");
      }
    }
  }
}

TEST(RestingProof, HiddenDisksAreJudged) {
  const Disks disks{{0, 0, 4}, {1, 0, 1}, {6, 0, 1}, {0, 0, 4}, {0, 6, 2}};
  const RestingClaim right = claim_of(disks, Frame::plane);
  ASSERT_EQ(right.hosts, (std::vector<GenId>{-2, 0, -2, 0, -2}));
  const auto with = [&](GenId g, GenId host) {
    RestingClaim claim = right;
    claim.hosts[g] = host;
    return fault_of(claim);
  };
  EXPECT_EQ(fault_of(right), "none");
  EXPECT_EQ(with(1, -2), "disk 1 is hidden by disk 0");
  EXPECT_EQ(with(2, 0), "disk 2 is not hidden");
  EXPECT_EQ(with(1, 2), "disk 1 does not lie in disk 2");
  EXPECT_EQ(with(1, 3), "disk 3 is hidden by disk 0, and hides nobody");
  EXPECT_EQ(with(1, -1), "disk 1 does not lie outside of a frame");
  // Edges may name hidden disks no more than they may leave out others.
  RestingClaim claim = right;
  claim.hosts.clear();
  EXPECT_EQ(fault_of(claim), "none");
  for (Quad& q : claim.edges) {
    for (GenId* g : {&q.l, &q.r, &q.s, &q.e}) *g = *g == 0 ? 3 : *g;
  }
  EXPECT_EQ(fault_of(claim).substr(0, 33), "disk 3 is hidden by disk 0, and e");
}

TEST(RestingProof, DisksBehindWallsAreHidden) {
  // The second touches the left wall from outside, the third is beyond a corner.
  const Disks disks{{0, 0, 4}, {-6, 0, 1}, {-6, -5, Rational(5, 4)}};
  RestingClaim claim = claim_of(disks, Frame::box);
  EXPECT_EQ(claim.hosts, (std::vector<GenId>{-2, 3, -2, -2, -2, -2, -2}));
  EXPECT_EQ(fault_of(claim), "none");
  claim.hosts[1] = 4;
  EXPECT_EQ(fault_of(claim), "disk 1 does not lie behind wall 4");
  claim.hosts[1] = -1;
  EXPECT_EQ(fault_of(claim), "disk 1 does not lie outside of a frame");
  claim.hosts = {-2, -2, -2};
  EXPECT_EQ(fault_of(claim), "disk 1 lies behind wall 3");
}

// Without disks, too, there are edges, and no other ones.
TEST(RestingProof, WallsAreJudged) {
  for (const Disks& disks : {Disks{}, Disks{{0, 0, 1}}, Disks{{0, 0, 1}, {1, 3, 2}}}) {
    const RestingClaim right = claim_of(disks, Frame::box);
    EXPECT_EQ(fault_of(right), "none");
    RestingClaim claim = right;
    for (Quad& q : claim.edges) q = canonical(Quad{q.r, q.l, q.s, q.e});
    EXPECT_NE(fault_of(claim), "none");
    // The walls in another order.
    claim = right;
    const auto n = static_cast<GenId>(disks.size());
    for (Quad& q : claim.edges) {
      for (GenId* g : {&q.l, &q.r, &q.s, &q.e}) *g = *g == n ? n + 1 : *g == n + 1 ? n : *g;
    }
    EXPECT_NE(fault_of(claim), "none");
    claim.edges.clear();
    EXPECT_NE(fault_of(claim), "none");
  }
}

TEST(RestingProof, DisksOutsideOfTheFrameAreHidden) {
  // The second touches the frame from outside, the third from inside.
  const Disks disks{{0, 0, 4}, {0, 10, 1}, {0, 8, 1}};
  const RestingClaim right = claim_of(disks, Frame::circle);
  EXPECT_EQ(right.hosts, (std::vector<GenId>{-2, -1, -2}));
  EXPECT_EQ(fault_of(right), "none");
  // In the plane nobody is outside.
  RestingClaim claim = right;
  claim.frame = Frame::plane;
  EXPECT_EQ(fault_of(claim), "disk 1 is not hidden");
}

// The edges of the circle's diagram are not those of the plane, though both are triangulations.
TEST(RestingProof, AnotherFrameIsAnotherDiagram) {
  Dice dice(14);
  int others = 0;
  for (int round = 0; round < 50; ++round) {
    const Disks disks = random_disks(dice, 12, 1);
    RestingClaim plane = claim_of(disks, Frame::plane);
    const RestingClaim circle = claim_of(disks, Frame::circle);
    if (plane.edges == circle.edges) continue;
    ++others;
    plane.edges = circle.edges;
    EXPECT_NE(fault_of(plane), "none") << text(disks);
  }
  EXPECT_GT(others, 20);
}

TEST(RestingProof, EdgesThatAreNoTriangulationAreWrong) {
  const Disks disks{{0, 0, 1}, {5, 0, 1}, {0, 5, 2}, {4, 4, 1}};
  RestingClaim claim = claim_of(disks, Frame::plane);
  claim.edges.pop_back();
  EXPECT_NE(fault_of(claim), "none");
  claim.edges.clear();
  EXPECT_NE(fault_of(claim), "none");
  // Fewer than two disks have no edge.
  claim = claim_of({{0, 0, 1}}, Frame::plane);
  EXPECT_EQ(fault_of(claim), "none");
  claim.edges.push_back({-1, 0, 0, 0});
  EXPECT_NE(fault_of(claim), "none");
}

}  // namespace
}  // namespace voroproof::internal::testing
