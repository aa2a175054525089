// A history dealt out in parts, and what holds of every such history.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/part_reader.h"
#include "history/scene_motion.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/same_claim.h"

namespace voroproof::internal::testing {

inline CollideEvent hit(double t, const Vec2& v = {1, 0}) {
  CollideEvent claim{.t = t, .i = container_id, .j = 0};
  claim.v[1] = v;
  return claim;
}

inline CertifyOptions in_parts_of(std::size_t least,
                                  const Rational& tolerance = Rational(1, 1000000)) {
  CertifyOptions options;
  options.truth = Truth::recorded;
  options.tolerance = tolerance;
  options.least_part = least;
  return options;
}

// A part and what its history has told.
struct ReadPart {
  std::size_t number;
  std::vector<Claim> claims;
  std::vector<std::int64_t> lines;
  std::int64_t line_after;
  std::vector<Replay::Place> places;
  Replay replay;
  std::optional<double> begin;
  std::optional<PartEnd> end;

  bool is_last() const { return !end; }
};

inline ReadPart told(Part part) {
  ReadPart out{
      part.number,        {}, {}, 0, std::move(part.places), std::move(part.replay), part.begin,
      std::move(part.end)};
  while (auto claim = part.claims->next()) {
    out.claims.push_back(std::move(*claim));
    out.lines.push_back(part.claims->line());
  }
  EXPECT_EQ(part.claims->next(), std::nullopt);
  out.line_after = part.claims->line();
  return out;
}

inline bool same(const Replay::Place& a, const Replay::Place& b) {
  return a.half == b.half && a.turns == b.turns;
}

struct Dealt {
  std::vector<ReadPart> parts;
  std::vector<std::string> remarks;
  HistoryHeader header;
};

inline Dealt deal(const Scene& scene, HistorySource& source, const CertifyOptions& options) {
  Dealt out;
  const MotionInput input = checked_input(motion_input(scene), source.header());
  PartReader reader(scene, input, source, options, out.remarks);
  while (auto part = reader.next()) out.parts.push_back(told(std::move(*part)));
  // There is no more after the last.
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.next());
  out.header = reader.header();
  return out;
}

inline Dealt deal(const Scene& scene, const ClaimedHistory& history,
                  const CertifyOptions& options) {
  MemoryHistory source(history);
  return deal(scene, source, options);
}

// What holds of every history, in whatever parts.
inline void expect_all(const Dealt& dealt, const Scene& scene, const ClaimedHistory& history,
                       const CertifyOptions& options) {
  const auto& parts = dealt.parts;
  ASSERT_FALSE(parts.empty());
  std::size_t next = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const ReadPart& part = parts[k];
    EXPECT_EQ(part.number, k);
    // Put together the parts are the history, with its lines.
    for (std::size_t c = 0; c < part.claims.size(); ++c, ++next) {
      ASSERT_LT(next, history.events.size());
      EXPECT_TRUE(same(part.claims[c], history.events[next]));
      EXPECT_EQ(part.lines[c], static_cast<std::int64_t>(next) + 2);
    }
    EXPECT_EQ(part.line_after, static_cast<std::int64_t>(next) + 2);
    EXPECT_EQ(part.is_last(), k + 1 == parts.size());
    EXPECT_EQ(part.begin.has_value(), k > 0);
    if (k > 0) {
      ASSERT_TRUE(part.begin && parts[k - 1].end);
      EXPECT_EQ(*part.begin, parts[k - 1].end->t);
      EXPECT_EQ(part.replay.diagram(), parts[k - 1].end->diagram);
    }
    if (part.is_last()) continue;
    // It ends between two claims that are so far from each other that they do not swap.
    ASSERT_LT(next, history.events.size());
    const double before = next == 0 ? 0 : time(history.events[next - 1]);
    const double after = time(history.events[next]);
    EXPECT_GT(to_rational(after) - to_rational(before), 8 * options.tolerance);
    EXPECT_GT(part.end->t - before, 0.49 * (after - before));
    EXPECT_GT(after - part.end->t, 0.49 * (after - before));
    // The claims lead from its beginning to its end, by their places.
    Replay replay = part.replay;
    ASSERT_EQ(part.places.size(), part.claims.size());
    for (std::size_t c = 0; c < part.claims.size(); ++c) {
      const auto place = replay.take(part.claims[c]);
      ASSERT_FALSE(place.is_none());
      EXPECT_TRUE(same(place, part.places[c]) || (k == 0 && part.places[c].half < 0));
    }
    EXPECT_EQ(replay.diagram(), part.end->diagram);
    const Replay& after_it = parts[k + 1].replay;
    EXPECT_EQ(replay.changes(), after_it.changes());
    EXPECT_EQ(replay.next_maneuver(), after_it.next_maneuver());
    for (GenId g = 0; g < replay.disks(); ++g) {
      EXPECT_EQ(replay.path(g).at(scene.horizon), after_it.path(g).at(scene.horizon));
    }
  }
  EXPECT_EQ(next, history.events.size());
}

inline std::vector<std::size_t> sizes(const Dealt& dealt) {
  std::vector<std::size_t> out;
  for (const ReadPart& part : dealt.parts) out.push_back(part.claims.size());
  return out;
}

// One disk, whose collisions with the container may be claimed at any times.
inline Scene lone() { return scene_of(10, 100, {disk(0, 0, 1, 1, 0)}); }

inline ClaimedHistory hits(const std::vector<double>& times) {
  ClaimedHistory h;
  h.header.horizon = 100;
  for (const double t : times) h.events.emplace_back(hit(t));
  h.count();
  return h;
}

}  // namespace voroproof::internal::testing
