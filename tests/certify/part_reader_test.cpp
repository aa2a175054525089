// A history dealt out in parts: nothing is lost, parts end where they may and nowhere else, and
// depend on the file alone.
#include "certify/part_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "history/error.h"
#include "history/scene_motion.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/lattice_scene.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

using Claim = voroproof::internal::Event;

template <class T>
bool same_exact(const T& a, const T& b) {
  if (!a.exact || !b.exact) return !a.exact && !b.exact;
  return a.exact->t == b.exact->t && a.exact->v == b.exact->v && a.exact->p == b.exact->p;
}

bool same(const Claim& a, const Claim& b) {
  if (a.index() != b.index()) return false;
  if (const auto* f = std::get_if<FlipEvent>(&a)) {
    const auto& g = std::get<FlipEvent>(b);
    return f->t == g.t && f->quad == g.quad && same_exact(*f, g);
  }
  if (const auto* c = std::get_if<CollideEvent>(&a)) {
    const auto& d = std::get<CollideEvent>(b);
    return c->t == d.t && c->i == d.i && c->j == d.j && c->v == d.v && c->p == d.p &&
           same_exact(*c, d);
  }
  const auto& m = std::get<ManeuverEvent>(a);
  const auto& n = std::get<ManeuverEvent>(b);
  return m.t == n.t && m.disk == n.disk && m.v == n.v && m.p == n.p && same_exact(m, n);
}

CollideEvent hit(double t, const Vec2& v = {1, 0}) {
  CollideEvent claim{.t = t, .i = container_id, .j = 0};
  claim.v[1] = v;
  return claim;
}

// ---- ClaimList ----

TEST(ClaimList, Empty) {
  ClaimList list;
  EXPECT_EQ(list.size(), 0u);
  list.reserve(100);
  EXPECT_EQ(list.size(), 0u);
}

Claim any_claim() {
  const double t = *rc::gen::element(0.0, 0.1, 1e-300, 7.5, 1e17);
  const auto id = [] { return *rc::gen::element<GenId>(-1, 0, 1, 2, 5, 1999999); };
  std::shared_ptr<ExactValues> exact;
  if (*rc::gen::element(false, false, true)) {
    exact = std::make_shared<ExactValues>();
    exact->t = to_rational(t) + Rational(1, 3);
    exact->v[1] = ExactVec2{Rational(1, 7), 2};
  }
  switch (*rc::gen::element(0, 0, 0, 1, 2)) {
    case 0:
      return FlipEvent{t, {id(), id(), id(), id()}, exact};
    case 1: {
      CollideEvent c{.t = t, .i = id(), .j = id()};
      if (*rc::gen::arbitrary<bool>()) c.v = {Vec2{1, t}, Vec2{2, 3}};
      if (*rc::gen::arbitrary<bool>()) c.p[1] = Vec2{t, 5};
      c.exact = exact;
      return c;
    }
    default: {
      ManeuverEvent m{.t = t, .disk = id()};
      if (*rc::gen::arbitrary<bool>()) m.v = Vec2{t, 1};
      m.exact = exact;
      return m;
    }
  }
}

RC_GTEST_PROP(ClaimList, GivesBackWhatItWasGiven, ()) {
  std::vector<std::pair<Claim, std::int64_t>> claims;
  const int size = *rc::gen::inRange(0, 30);
  std::int64_t line = *rc::gen::element<std::int64_t>(1, 2, std::int64_t{1} << 40);
  for (int k = 0; k < size; ++k) claims.emplace_back(any_claim(), line += *rc::gen::inRange(1, 4));
  ClaimList list;
  if (*rc::gen::arbitrary<bool>()) list.reserve(claims.size());
  for (const auto& [claim, at] : claims) list.add(Claim(claim), at);
  RC_ASSERT(list.size() == claims.size());
  ClaimList moved = std::move(list);
  // Each once, in any order.
  const bool backwards = *rc::gen::arbitrary<bool>();
  for (std::size_t n = 0; n < claims.size(); ++n) {
    const std::size_t k = backwards ? claims.size() - 1 - n : n;
    RC_ASSERT(moved.line(k) == claims[k].second);
    RC_ASSERT(same(moved.take(k), claims[k].first));
    RC_ASSERT(moved.line(k) == claims[k].second);
  }
  RC_ASSERT(moved.size() == claims.size());
}

// ---- PartReader ----

// A history that cannot be read beyond so many claims.
class BrokenHistory : public MemoryHistory {
 public:
  BrokenHistory(const ClaimedHistory& history, std::size_t readable)
      : MemoryHistory(history), left_(readable) {}
  std::optional<Claim> next() override {
    if (left_ == 0) throw InputError("broken", line() + 1, "", "cannot be read");
    --left_;
    return MemoryHistory::next();
  }

 private:
  std::size_t left_;
};

CertifyOptions in_parts_of(std::size_t least, const Rational& tolerance = Rational(1, 1000000)) {
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

ReadPart told(Part part) {
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

bool same(const Replay::Place& a, const Replay::Place& b) {
  return a.half == b.half && a.turns == b.turns;
}

struct Dealt {
  std::vector<ReadPart> parts;
  std::vector<std::string> remarks;
  HistoryHeader header;
};

Dealt deal(const Scene& scene, HistorySource& source, const CertifyOptions& options) {
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

Dealt deal(const Scene& scene, const ClaimedHistory& history, const CertifyOptions& options) {
  MemoryHistory source(history);
  return deal(scene, source, options);
}

// What holds of every history, in whatever parts.
void expect_all(const Dealt& dealt, const Scene& scene, const ClaimedHistory& history,
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
      ASSERT_TRUE(place.has_value());
      EXPECT_TRUE(same(*place, part.places[c]) || (k == 0 && part.places[c].half < 0));
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

std::vector<std::size_t> sizes(const Dealt& dealt) {
  std::vector<std::size_t> out;
  for (const ReadPart& part : dealt.parts) out.push_back(part.claims.size());
  return out;
}

// One disk, whose collisions with the container may be claimed at any times.
Scene lone() { return scene_of(10, 100, {disk(0, 0, 1, 1, 0)}); }

ClaimedHistory hits(const std::vector<double>& times) {
  ClaimedHistory h;
  h.header.horizon = 100;
  for (const double t : times) h.events.emplace_back(hit(t));
  h.count();
  return h;
}

TEST(PartReader, ShortHistoriesAreOnePart) {
  const CertifyOptions options = in_parts_of(CertifyOptions{}.least_part);
  for (const std::vector<double>& times : {std::vector<double>{}, std::vector{0.0},
                                           std::vector{50.0}, std::vector{0.0, 0.0, 1.0, 99.0}}) {
    const ClaimedHistory h = hits(times);
    const Dealt dealt = deal(lone(), h, options);
    EXPECT_EQ(sizes(dealt), std::vector{times.size()});
    expect_all(dealt, lone(), h, options);
  }
  const Scene none = scene_of(10, 1, {});
  EXPECT_EQ(sizes(deal(none, hits({}), options)), std::vector<std::size_t>{0});
}

TEST(PartReader, EmptyHistoriesAreOnePartHoweverSmall) {
  EXPECT_EQ(sizes(deal(lone(), hits({}), in_parts_of(1))), std::vector<std::size_t>{0});
  const Scene scene = scene_of(10, 1, {disk(-3, 0, 1, 0, 0), disk(3, 0, 1, 0, 0)});
  const ClaimedHistory h = claimed_history(scene, run(scene));
  ASSERT_TRUE(h.events.empty());
  const Dealt dealt = deal(scene, h, in_parts_of(1));
  EXPECT_EQ(sizes(dealt), std::vector<std::size_t>{0});
  EXPECT_EQ(dealt.parts[0].replay.diagram().quads(), *h.header.initial);
}

// The smallest parts end wherever they may: where the gap is wider than eight tolerances, and not
// where it is just that.
TEST(PartReader, PartsEndInGapsWiderThanEightTolerances) {
  const Rational tolerance = Rational(1) >> 20;
  const double eight = 0x1p-17;
  const double wider = std::nextafter(1 + eight, 2), b = 2, c = 3 + eight;
  const ClaimedHistory h =
      hits({1, 1, 1 + eight, b, std::nextafter(b, 3), b + 0.5 * eight, 3, c, c + 2 * eight});
  const CertifyOptions options = in_parts_of(1, tolerance);
  const Dealt dealt = deal(lone(), h, options);
  expect_all(dealt, lone(), h, options);
  // The first has none: what it proves is the diagram at the beginning.
  EXPECT_EQ(sizes(dealt), (std::vector<std::size_t>{0, 3, 3, 2, 1}));
  const ClaimedHistory just = hits({1, 1 + eight}), more = hits({1, wider});
  EXPECT_EQ(sizes(deal(lone(), just, options)), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(sizes(deal(lone(), more, options)), (std::vector<std::size_t>{0, 1, 1}));
  // With a tolerance that is no binary64 the gap is no smaller than eight of it.
  const CertifyOptions odd = in_parts_of(1, Rational(1, 3));
  for (const double t : {1 + 8.0 / 3, 1 + 8.0 / 3 - 1e-9, 1 + 8.0 / 3 + 1e-9}) {
    const ClaimedHistory two = hits({1, t});
    const Dealt parts = deal(lone(), two, odd);
    expect_all(parts, lone(), two, odd);
    EXPECT_EQ(parts.parts.size(), t - 1 > 8.0 / 3 + 1e-10 ? 2u : 1u);
  }
}

// Claims at t = 0 and near it belong to the first part.
TEST(PartReader, NothingEndsAtTheBeginning) {
  const CertifyOptions options = in_parts_of(1);
  const ClaimedHistory h = hits({0, 0, 1e-6, 5e-6, 1});
  const Dealt dealt = deal(lone(), h, options);
  expect_all(dealt, lone(), h, options);
  EXPECT_EQ(sizes(dealt), (std::vector<std::size_t>{4, 1}));
}

// Collisions at t = 0 have happened when the initial diagram is taken.
TEST(PartReader, CollisionsBeforeTheInitialDiagram) {
  const Scene scene =
      scene_of(20, 30, {disk(-1, 0, 1, 1, 0), disk(1, 0, 1, -1, 0), disk(0, 5, 1, 0, 1)});
  const ClaimedHistory h = claimed_history(scene, run(scene));
  ASSERT_FALSE(h.events.empty());
  ASSERT_EQ(time(h.events[0]), 0);
  const CertifyOptions options = in_parts_of(1);
  const Dealt dealt = deal(scene, h, options);
  expect_all(dealt, scene, h, options);
  EXPECT_GT(dealt.parts.size(), 1u);
  EXPECT_EQ(dealt.parts[0].replay.diagram().quads(), *h.header.initial);
  EXPECT_EQ(dealt.parts[0].replay.changes(), 0);
}

// Where the file gives no initial diagram it is asked for, once, with what has moved at t = 0.
TEST(PartReader, ProposedInitialDiagram) {
  const Scene scene =
      scene_of(20, 30, {disk(-1, 0, 1, 1, 0), disk(1, 0, 1, -1, 0), disk(0, 5, 1, 0, 1)});
  const ClaimedHistory with = claimed_history(scene, run(scene));
  ClaimedHistory h = with;
  h.header.initial.reset();
  CertifyOptions options = in_parts_of(1);
  int asked = 0;
  options.propose_initial = [&](Motion& motion) {
    ++asked;
    // The two have exchanged their velocities.
    EXPECT_EQ(motion.doubles(0).vx, -1);
    EXPECT_EQ(motion.doubles(1).vx, 1);
    return *with.header.initial;
  };
  const Dealt dealt = deal(scene, h, options);
  expect_all(dealt, scene, h, options);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(dealt.header.initial, with.header.initial);
  EXPECT_EQ(dealt.remarks, std::vector<std::string>{constructed_initial_remark});
  EXPECT_EQ(sizes(dealt), sizes(deal(scene, with, options)));
  // That of the file goes before it.
  EXPECT_TRUE(deal(scene, with, options).remarks.empty());
  EXPECT_EQ(asked, 1);
  // None, or none that is one, is left to the one part to say.
  options.propose_initial = nullptr;
  EXPECT_EQ(sizes(deal(scene, h, options)), std::vector{h.events.size()});
  h.header.initial = std::vector<Quad>{{0, 1, 2, 2}};
  const Dealt wrong = deal(scene, h, options);
  EXPECT_EQ(sizes(wrong), std::vector{h.events.size()});
  EXPECT_EQ(wrong.header.initial, h.header.initial);
}

// What comes after a claim that makes no sense is in the part that begins before it.
TEST(PartReader, ClaimsThatMakeNoSenseAreInTheLastPart) {
  ClaimedHistory h = hits({10, 20, 30, 40, 50});
  h.events.insert(h.events.begin() + 3, ManeuverEvent{35, 0});  // none is scheduled
  h.count();
  const CertifyOptions options = in_parts_of(1);
  const Dealt dealt = deal(lone(), h, options);
  expect_all(dealt, lone(), h, options);
  EXPECT_EQ(sizes(dealt), (std::vector<std::size_t>{0, 1, 1, 1, 3}));
  // At the very beginning: then there is one.
  ClaimedHistory at_once = hits({10, 20});
  at_once.events.insert(at_once.events.begin(), ManeuverEvent{0, 0});
  at_once.count();
  EXPECT_EQ(sizes(deal(lone(), at_once, options)), (std::vector<std::size_t>{3}));
}

// So many claims at least, but an eighth of it in the first part, and fewer towards the end.
TEST(PartReader, PartsAreOfTheSizeAskedFor) {
  std::vector<double> times;
  for (int k = 1; k <= 2000; ++k) times.push_back(0.05 * k);
  const ClaimedHistory h = hits(times);
  for (const std::size_t least : {std::size_t{8}, std::size_t{80}, std::size_t{400}}) {
    const CertifyOptions options = in_parts_of(least);
    const Dealt dealt = deal(lone(), h, options);
    expect_all(dealt, lone(), h, options);
    const std::vector<std::size_t> parts = sizes(dealt);
    ASSERT_GT(parts.size(), 2u);
    EXPECT_EQ(parts[0], least / 8);
    EXPECT_EQ(parts[1], least);
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
      EXPECT_GE(parts[k], least / 8);
      EXPECT_LE(parts[k], least);
      if (k > 1) {
        EXPECT_LE(parts[k], parts[k - 1]);
      }
    }
    EXPECT_LT(parts[parts.size() - 2], least);
  }
}

// Many disks make for larger parts: for each one in 512 of what is asked for.
TEST(PartReader, PartsGrowWithTheDisks) {
  Scene scene = scene_of(100'000, 1000, {});
  for (int k = 0; k < 1024; ++k) {
    scene.disks.push_back(disk(100 * (k % 32), 100 * (k / 32), 1, 0, 0));
  }
  for (int k = 1; k < 500; ++k) scene.maneuvers.push_back({Rational(k), k, 0, 0});
  ClaimedHistory h;
  h.header.horizon = 1000;
  for (int k = 1; k < 500; ++k) h.events.emplace_back(ManeuverEvent{double(k), k});
  h.count();
  // Any diagram: it is taken for what it is.
  scene.horizon = 0;
  Scene still = scene;
  still.maneuvers.clear();
  h.header.initial = run(still).initial;
  scene.horizon = 1000;
  const CertifyOptions options = in_parts_of(40);
  const std::vector<std::size_t> parts = sizes(deal(scene, h, options));
  ASSERT_GT(parts.size(), 2u);
  EXPECT_EQ(parts[0], 10u);
  EXPECT_EQ(parts[1], 80u);
}

RC_GTEST_PROP(PartReader, PartsOfTheEnginesHistoriesAreThese, ()) {
  const Scene scene = scene_of(*lattice_scenes({.maneuvers = true, .elastic = false}));
  const RecordedRun r = run(scene);
  RC_PRE(r.complete() && scene.disks.size() >= 1);
  const ClaimedHistory h = claimed_history(scene, r);
  const CertifyOptions options =
      in_parts_of(*rc::gen::element<std::size_t>(1, 2, 9),
                  *rc::gen::element(Rational(1, 1000000), Rational(1, 100), Rational(0)));
  const Dealt dealt = deal(scene, h, options);
  RC_CLASSIFY(dealt.parts.size() > 3, "some parts");
  expect_all(dealt, scene, h, options);
  RC_ASSERT(!::testing::Test::HasFailure());
}

// The same file gives the same parts, whoever proves them.
TEST(PartReader, PartsDependOnTheFileOnly) {
  Random random(2);
  const Scene scene = random_scene({.n = 8, .horizon = 60}, random);
  const ClaimedHistory h = claimed_history(scene, run(scene));
  CertifyOptions options = in_parts_of(5);
  const Dealt first = deal(scene, h, options);
  EXPECT_GT(first.parts.size(), 3u);
  expect_all(first, scene, h, options);
  options.threads = 7;
  options.strict = true;
  options.motion.filters = false;
  const Dealt second = deal(scene, h, options);
  ASSERT_EQ(second.parts.size(), first.parts.size());
  EXPECT_EQ(sizes(second), sizes(first));
  for (std::size_t k = 0; k < first.parts.size(); ++k) {
    EXPECT_EQ(second.parts[k].begin, first.parts[k].begin);
    EXPECT_TRUE(std::equal(second.parts[k].places.begin(), second.parts[k].places.end(),
                           first.parts[k].places.begin(), first.parts[k].places.end(),
                           [](const auto& a, const auto& b) { return same(a, b); }));
    EXPECT_EQ(second.parts[k].line_after, first.parts[k].line_after);
  }
  // Also where they are asked for while those before are still held.
  MemoryHistory source(h);
  const MotionInput input = checked_input(motion_input(scene), h.header);
  std::vector<std::string> remarks;
  PartReader reader(scene, input, source, options, remarks);
  std::vector<Part> held;
  while (auto part = reader.next()) held.push_back(std::move(*part));
  ASSERT_EQ(held.size(), first.parts.size());
  for (std::size_t k = held.size(); k-- > 0;) {
    const ReadPart part = told(std::move(held[k]));
    EXPECT_EQ(part.claims.size(), first.parts[k].claims.size());
    EXPECT_EQ(part.lines, first.parts[k].lines);
  }
}

// What the last part says of the file's end, others do not.
TEST(PartReader, TheLastPartEndsAsTheFile) {
  ClaimedHistory h = hits({10, 20, 30});
  h.claimed_counts.collisions = 4;
  MemoryHistory source(h);
  const CertifyOptions options = in_parts_of(1);
  const MotionInput input = checked_input(motion_input(lone()), h.header);
  const Scene scene = lone();
  std::vector<std::string> remarks;
  PartReader reader(scene, input, source, options, remarks);
  EXPECT_EQ(reader.header().horizon, 100);
  std::optional<Part> part;
  while ((part = reader.next()) && part->end) {
    EXPECT_EQ(part->claims->header().horizon, 100);
    EXPECT_EQ(part->claims->shadow_line({0, 1, 2, 3}, 0, 1), std::nullopt);
    while (part->claims->next()) {
    }
    EXPECT_TRUE(std::holds_alternative<HistoryEnd>(part->claims->ending()));
  }
  ASSERT_TRUE(part.has_value());
  EXPECT_EQ(part->claims->line(), 1);
  while (part->claims->next()) {
  }
  EXPECT_EQ(std::get<HistoryEnd>(part->claims->ending()).counts.collisions, 4);
  EXPECT_EQ(part->claims->counts().collisions, 3);
  EXPECT_FALSE(part->claims->counts_match());
}

// A line that cannot be read: what is before is dealt out as far as parts have ended; the rest of
// it is lost.
TEST(PartReader, InputErrorInTheMiddle) {
  std::vector<double> times;
  for (int k = 1; k <= 40; ++k) times.push_back(k);
  const ClaimedHistory h = hits(times);
  const CertifyOptions options = in_parts_of(1);
  const Scene scene = lone();
  const MotionInput input = checked_input(motion_input(scene), h.header);
  for (const std::size_t readable : {0u, 1u, 4u, 17u, 39u, 40u}) {
    BrokenHistory source(h, readable);
    std::vector<std::string> remarks;
    PartReader reader(scene, input, source, options, remarks);
    std::size_t claims = 0, parts = 0;
    try {
      while (auto part = reader.next()) {
        ASSERT_TRUE(part->end.has_value()) << "the last part, though the history goes on";
        const ReadPart read = told(std::move(*part));
        EXPECT_EQ(read.number, parts++);
        for (const Claim& claim : read.claims) EXPECT_TRUE(same(claim, h.events[claims++]));
      }
      ADD_FAILURE() << "all could be read";
    } catch (const InputError& e) {
      EXPECT_EQ(e.line(), static_cast<std::int64_t>(readable) + 2);
    }
    // A few are read ahead.
    EXPECT_LE(claims, readable);
    EXPECT_GE(claims + 5, readable);
  }
}

// A claim that makes no sense is before the line that cannot be read: then the part that it is in
// is there, and reading it on throws.
TEST(PartReader, InputErrorAfterNonsense) {
  ClaimedHistory h = hits({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  h.events[2] = ManeuverEvent{3, 0};
  const CertifyOptions options = in_parts_of(1);
  const Scene scene = lone();
  const MotionInput input = checked_input(motion_input(scene), h.header);
  BrokenHistory source(h, 10);
  std::vector<std::string> remarks;
  PartReader reader(scene, input, source, options, remarks);
  std::optional<Part> part;
  while ((part = reader.next()) && part->end) {
  }
  ASSERT_TRUE(part.has_value());
  int claims = 0;
  try {
    while (part->claims->next()) ++claims;
    ADD_FAILURE() << "all could be read";
  } catch (const InputError&) {
  }
  EXPECT_EQ(claims, 8);  // all but the two of parts before
}

}  // namespace
}  // namespace voroproof::internal::testing
