// Small worlds with histories, and what is to be expected of their verdicts.
#pragma once

#include "certify/world/world_certifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace voroproof::internal {
using Kind = Verdict;

struct WorldCase {
  World world;
  std::vector<Quad> initial;
  std::vector<WorldEvent> events;
};

inline WorldDisk disk(Rational x, Rational y, Rational r, Rational vx = 0, Rational vy = 0,
                      Rational growth = 0) {
  return {0, std::nullopt, {x, y, r, vx, vy, growth}};
}

inline World plane(Rational horizon, std::vector<WorldDisk> disks) {
  World world;
  world.horizon = std::move(horizon);
  world.disks = std::move(disks);
  return world;
}

inline World circle(Rational radius, Rational horizon, std::vector<WorldDisk> disks) {
  World world = plane(std::move(horizon), std::move(disks));
  world.circle = WorldCircle{{0, 0}, std::move(radius), 0};
  return world;
}

// The edges between these vertices, each of which has its generators counterclockwise; no two edges
// have the same pair.
inline std::vector<Quad> edges_of(const std::vector<Triple>& vertices) {
  std::map<std::pair<GenId, GenId>, GenId> apex;
  for (const Triple& v : vertices) {
    for (int k = 0; k < 3; ++k) apex[{v[k], v[(k + 1) % 3]}] = v[(k + 2) % 3];
  }
  std::vector<Quad> all;
  for (const auto& [pair, e] : apex) {
    const auto [l, r] = pair;
    if (l < r) all.push_back({l, r, apex.at({r, l}), e});
  }
  std::sort(all.begin(), all.end());
  return all;
}

// Of two disks alone.
inline std::vector<Quad> edges_of_two(GenId a, GenId b) {
  return {{-1, a, b, b}, {-1, b, a, a}, {a, b, -1, -1}};
}

inline WorldVerdict judge(const WorldCase& c) {
  WorldCertifier certifier(c.world, c.initial, WorldCertifier::default_tolerance(), {});
  WorldCounts counts;
  std::int64_t line = 1;
  for (const WorldEvent& e : c.events) {
    counts.add(e);
    certifier.event(e, ++line);
  }
  return certifier.finish(WorldEnd{counts}, ++line);
}

inline void expect_right(const WorldCase& c) {
  const WorldVerdict v = judge(c);
  EXPECT_EQ(v.kind, Verdict::certified) << "line " << v.line << ", t " << v.t << ": " << v.reason;
}

inline void expect_wrong(WorldCase c, const std::function<void(WorldCase&)>& change,
                         const std::string& reason) {
  change(c);
  const WorldVerdict v = judge(c);
  EXPECT_EQ(v.kind, Verdict::refuted) << reason << " line " << v.line << ": " << v.reason;
  EXPECT_NE(v.reason.find(reason), std::string::npos) << v.reason;
}

// Faults that any history may have: none of them is certified.
inline void expect_no_fault_certified(const WorldCase& right) {
  for (std::size_t k = 0; k < right.events.size(); ++k) {
    WorldCase c = right;
    c.events.erase(c.events.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_NE(judge(c).kind, Verdict::certified) << "without event " << k;
    for (const Rational& by : {Rational(1, 100000), Rational(-1, 100000), Rational(1)}) {
      c = right;
      c.events[k].t += by;
      std::stable_sort(c.events.begin(), c.events.end(),
                       [](const WorldEvent& a, const WorldEvent& b) { return a.t < b.t; });
      EXPECT_NE(judge(c).kind, Verdict::certified) << "event " << k << " at " << c.events[k].t;
    }
    c = right;
    c.events.insert(c.events.begin() + static_cast<std::ptrdiff_t>(k), right.events[k]);
    EXPECT_NE(judge(c).kind, Verdict::certified) << "event " << k << " twice";
    c = right;
    c.events[k].t += Rational(1, 2000000);
    EXPECT_EQ(judge(c).kind, Verdict::certified) << "event " << k << " within the tolerance";
  }
  for (std::size_t k = 0; k < right.initial.size(); ++k) {
    WorldCase c = right;
    c.initial.erase(c.initial.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_NE(judge(c).kind, Verdict::certified) << "without edge " << k;
  }
}

}  // namespace voroproof::internal
