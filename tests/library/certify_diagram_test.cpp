// Claims about diagrams at rest: the parts of ours are certified, and each fault is named.
#include "voroproof/certify_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "tests/support/dice.h"

namespace voroproof {
namespace {

using internal::testing::Dice;
using Pairs = std::vector<std::array<int, 2>>;

std::vector<Circle> some_disks(Dice& dice, int n, int fine) {
  std::vector<Circle> disks;
  for (int k = 0; k < n; ++k) {
    const auto part = [&](int most) { return dice(0, most * fine) / static_cast<double>(fine); };
    const double x = part(8) - 4, y = part(8) - 4;
    disks.push_back({{x, y}, part(2)});
  }
  return disks;
}

Pairs neighbours_of(const StaticDiagram& diagram, bool with_frame) {
  std::set<std::array<int, 2>> pairs;
  for (const Edge& e : diagram.edges()) {
    const auto [i, j] = std::minmax(e.l, e.r);
    if (i >= 0 || with_frame) pairs.insert({i, j});
  }
  return {pairs.begin(), pairs.end()};
}

DiagramClaim claim_of(const StaticDiagram& d) {
  return {d.disks(), d.frame(), d.hosts(), d.edges(), neighbours_of(d, true), d.vertices()};
}

std::string reason_of(const DiagramClaim& claim) { return certify_diagram(claim).reason; }

TEST(CertifyDiagram, OurDiagramsAreCertified) {
  Dice dice(1);
  for (int round = 0; round < 150; ++round) {
    const std::vector<Circle> disks = some_disks(dice, dice(0, 20), dice(0, 1) == 0 ? 1 : 1 << 20);
    for (const std::optional<Circle> frame : {std::optional<Circle>(), {Circle{{0, 0}, 9}}}) {
      const StaticDiagram d(disks, frame);
      DiagramClaim claim = claim_of(d);
      DiagramReport report = certify_diagram(claim);
      EXPECT_EQ(report.verdict, Verdict::certified) << report.reason;
      // Without edges, or with pairs alone.
      claim.edges.reset();
      EXPECT_EQ(certify_diagram(claim).verdict, Verdict::certified);
      claim = {disks, frame, {}, {}, neighbours_of(d, false), {}};
      report = certify_diagram(claim);
      EXPECT_EQ(report.verdict, Verdict::certified) << report.reason;
    }
    if (HasFailure()) return;
  }
}

TEST(CertifyDiagram, PairsThatAreNoneAreRefuted) {
  const StaticDiagram d({{{0, 0}, 1}, {{10, -1}, 1}, {{20, 0}, 1}, {{10, 8}, 1}}, std::nullopt);
  DiagramClaim claim{d.disks(), {}, {}, {}, neighbours_of(d, false), {}};
  claim.neighbours->push_back({0, 2});
  EXPECT_EQ(reason_of(claim), "the cells of [0,2] have no edge in common");
  claim.neighbours = Pairs{{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  EXPECT_EQ(reason_of(claim), "the cells of [1,3] have an edge in common");
  claim.neighbours->push_back({3, 1});
  EXPECT_EQ(reason_of(claim), "");
  // One pair with infinity, and all are asked for.
  claim.neighbours->push_back({-1, 0});
  EXPECT_EQ(reason_of(claim), "the cells of [-1,1] have an edge in common");
}

TEST(CertifyDiagram, PairsThatMeetInAVertexMayBeClaimed) {
  const StaticDiagram d({{{0, 0}, 1}, {{4, 0}, 1}, {{0, 4}, 1}, {{4, 4}, 1}}, std::nullopt);
  DiagramClaim claim{d.disks(), {}, {}, {}, Pairs{{0, 1}, {1, 3}, {3, 2}, {2, 0}}, {}};
  EXPECT_EQ(certify_diagram(claim).verdict, Verdict::certified);
  claim.neighbours->push_back({0, 3});
  claim.neighbours->push_back({1, 2});
  const DiagramReport report = certify_diagram(claim);
  EXPECT_EQ(report.verdict, Verdict::certified);
  EXPECT_EQ(report.reservations.front(), "2 pairs of neighbours meet in a vertex only");
  // The other diagonal as an edge.
  claim.neighbours.reset();
  claim.edges = d.edges();
  for (Edge& e : *claim.edges) {
    const auto turned = [](int g) { return g < 0 ? g : 3 - g; };
    e = {turned(e.l), turned(e.r), turned(e.s), turned(e.e)};
  }
  EXPECT_EQ(certify_diagram(claim).verdict, Verdict::certified);
}

TEST(CertifyDiagram, VerticesAreJudged) {
  Dice dice(2);
  const StaticDiagram d(some_disks(dice, 12, 1 << 20), std::nullopt);
  const DiagramClaim right = claim_of(d);
  ASSERT_GT(right.vertices->size(), 4U);
  DiagramClaim claim = right;
  (*claim.vertices)[2].center[0] += 1e-10;
  EXPECT_EQ(certify_diagram(claim).verdict, Verdict::certified);
  EXPECT_EQ(certify_diagram(claim, 0).verdict, Verdict::refuted);
  EXPECT_EQ(certify_diagram(right, 0).verdict, Verdict::certified);
  (*claim.vertices)[2].center[0] += 1e-3;
  EXPECT_EQ(reason_of(claim).substr(0, 22), "the circle of vertex [");
  claim = right;
  std::swap((*claim.vertices)[1].generators[1], (*claim.vertices)[1].generators[2]);
  EXPECT_EQ(reason_of(claim).substr(0, 21), "there is no vertex [0");
  claim = right;
  (*claim.vertices)[1].radius = std::nan("");
  EXPECT_EQ(certify_diagram(claim).verdict, Verdict::refuted);
  claim = right;
  claim.vertices->pop_back();
  EXPECT_NE(reason_of(claim).find("is missing"), std::string::npos);
}

// Of the two circles that touch three disks at a place one is the vertex's.
TEST(CertifyDiagram, AVertexWithoutEdgesIsJudgedByItsOrder) {
  const StaticDiagram three({{{0, 0}, 1}, {{4, 0}, 1}, {{1, 3}, 1}}, std::nullopt);
  DiagramClaim claim{three.disks(), {}, {}, {}, {}, three.vertices()};
  EXPECT_EQ(certify_diagram(claim).verdict, Verdict::certified);
  claim.vertices = {{{0, 2, 1}, {2, 1}, -3.23606797749979}};
  EXPECT_EQ(reason_of(claim), "there is no vertex [0,2,1]");
  // The circle of [0,1,2] exists, and contains disk 3.
  claim = {{{{-5, 0}, 1}, {{0, 0}, 0.5}, {{5, 0}, 1}, {{0, 6}, 1}}, {}, {}, {}, {}, {}};
  claim.vertices = {{{0, 1, 2}, {0, 24.75}, 24.25}};
  EXPECT_EQ(reason_of(claim), "there is no vertex [0,1,2]");
  // Of a tie each three in their order name it.
  const StaticDiagram tie({{{1, 0}, 0}, {{0, 1}, 0}, {{-1, 0}, 0}, {{0, -1}, 0}}, std::nullopt);
  claim = {tie.disks(), {}, {}, {}, {}, {}};
  for (const std::array<int, 3> name : {std::array{0, 1, 2}, {1, 2, 3}, {0, 2, 3}, {0, 1, 3}}) {
    claim.vertices = {{name, {0, 0}, 1}};
    EXPECT_EQ(reason_of(claim), "");
    claim.vertices = {{{name[0], name[2], name[1]}, {0, 0}, 1}};
    EXPECT_NE(reason_of(claim), "");
  }
  claim.vertices = {{{0, 0, 1}, {0, 0}, 1}};
  EXPECT_EQ(reason_of(claim), "there is no vertex [0,0,1]");
  claim.vertices = {{{0, 1, 2}, {0, 0}, 1}, {{0, 1, 2}, {0, 0}, 1}};
  EXPECT_EQ(reason_of(claim), "vertex [0,1,2] is named twice");
}

TEST(CertifyDiagram, ALoneDiskIsANeighbourOfTheFrame) {
  DiagramClaim claim{{{{0, 0}, 1}, {{0, 0}, 0.5}}, Circle{{0, 0}, 5}, {}, {}, Pairs{{0, -1}}, {}};
  EXPECT_EQ(reason_of(claim), "");
  claim.neighbours = Pairs{{1, -1}};
  EXPECT_NE(reason_of(claim), "");
  claim.neighbours = Pairs{};
  EXPECT_EQ(certify_diagram(claim).reservations.front(),
            "1 neighbours of the frame are not claimed");
}

TEST(CertifyDiagram, SaysWhatWasJudged) {
  const StaticDiagram d({{{0, 0}, 1}, {{4, 0}, 1}, {{4, 0}, 0.5}}, std::nullopt);
  EXPECT_EQ(certify_diagram({d.disks(), {}, d.hosts(), d.edges(), {}, {}}).about,
            "about the diagram of 3 disks in the plane: edges, hidden disks");
  EXPECT_EQ(certify_diagram({{}, Circle{{0, 0}, 1}, {}, std::vector<Edge>(), {}, {}}).about,
            "about the diagram of 0 disks in a circle: edges");
}

TEST(CertifyDiagram, RefusesClaimsThatAreNone) {
  const std::vector<Circle> two{{{0, 0}, 1}, {{4, 0}, 1}};
  EXPECT_THROW(certify_diagram({two, {}, {}, {}, {}, {}}), std::invalid_argument);
  EXPECT_THROW(certify_diagram({two, {}, std::vector{-2}, {}, {}, {}}), std::invalid_argument);
  EXPECT_THROW(certify_diagram({two, {}, std::vector{-2, 1}, {}, {}, {}}), std::invalid_argument);
  EXPECT_THROW(certify_diagram({two, {}, {}, {}, Pairs{{0, 2}}, {}}), std::invalid_argument);
  EXPECT_THROW(certify_diagram({two, {}, {}, {}, Pairs{{0, 1}}, {}}, 2), std::invalid_argument);
  EXPECT_THROW(certify_diagram({two, {}, {}, std::vector<Edge>{{0, 7, 1, -1}}, {}, {}}),
               std::invalid_argument);
  EXPECT_THROW(certify_diagram({two, {}, {}, {}, Pairs{{0, 1}}, {}}, 0, 0), std::invalid_argument);
  EXPECT_THROW(certify_diagram({two, Circle{{0, 0}, 0}, {}, {}, Pairs{}, {}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace voroproof
