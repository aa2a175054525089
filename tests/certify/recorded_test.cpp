// The recorded truth where it is most easily deceived.
#include <gtest/gtest.h>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

Certificate certify_recorded(const Scene& scene, const ClaimedHistory& h) {
  CertifyOptions options;
  options.truth = Truth::recorded;
  return certify(scene, h, options);
}

DiskInput disk(const Rational& x, const Rational& y, const Rational& vx, const Rational& vy) {
  return {x, y, 1, vx, vy, 1};
}

// Two disks side by side, one nearly at rest relative to the other.
struct Creeping {
  Scene scene;
  ClaimedHistory history;
};
Creeping creeping(const Rational& horizon) {
  Creeping c;
  const Rational slow(1, 10'000'000'000);
  c.scene = scene_of(1'000'000, horizon, {disk(0, 0, 0, 1), disk(2 + 10 * slow, 0, -slow, 1)});
  c.history = claimed_history(c.scene, run(c.scene));
  return c;
}

// The law allows a part in 10^9 of the speeds, and so no response at all; but two that have
// collided may not overlap for longer than the tolerance after it, however slowly they creep.
TEST(Recorded, VelocitiesThatDoNotPart) {
  for (const bool responds : {true, false}) {
    for (const int horizon : {100, 100'000}) {
      Creeping c = creeping(horizon);
      ASSERT_EQ(c.history.events.size(), 1u);
      auto& hit = std::get<CollideEvent>(c.history.events[0]);
      if (!responds) std::swap(hit.v[0], hit.v[1]);  // equal masses: as before
      const Certificate result = certify_recorded(c.scene, c.history);
      if (responds) {
        EXPECT_EQ(result.verdict, Verdict::certified) << reason_line(result);
      } else {
        EXPECT_EQ(result.verdict, Verdict::refuted);
        EXPECT_EQ(result.divergence->fault, Fault::overlap);
      }
    }
  }
}

// Four disks meet in the middle of a square, all at once. Without one of the collisions two of them
// pass through each other, and four generators stay cotangent where nothing decides an edge.
TEST(Refuted, DroppedCollisionAmongFourSymmetricDisks) {
  const Scene scene = scene_of(
      50, 60, {disk(5, 5, -1, -1), disk(-5, 5, 1, -1), disk(-5, -5, 1, 1), disk(5, -5, -1, 1)});
  const ClaimedHistory right = claimed_history(scene, run(scene));
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    EXPECT_EQ(certify(scene, right, options).verdict, Verdict::certified);
    for (int k = 0; k < 4; ++k) {
      ClaimedHistory wrong = right;
      ASSERT_TRUE(std::holds_alternative<CollideEvent>(wrong.events[k]));
      wrong.events.erase(wrong.events.begin() + k);
      wrong.count();
      const Certificate result = certify(scene, wrong, options);
      EXPECT_EQ(result.verdict, Verdict::refuted) << reason_line(result);
    }
  }
}

CertifyOptions recorded() {
  CertifyOptions options;
  options.truth = Truth::recorded;
  return options;
}

// A disk that a maneuver turns back after it has left the container, so slowly that it is outside
// for long; or so fast that it is not.
TEST(Recorded, OutsideTheContainer) {
  for (const bool slow : {true, false}) {
    Scene scene = scene_of(10, 1000, {testing::disk(0, 0, 1, 1, 0)});
    scene.maneuvers.push_back({9.0000009, 0, Rational(slow ? -1e-9 : -1e-3), 0});
    ClaimedHistory h = claimed_history(scene, run(scene));
    const Certificate right = certify(scene, h, recorded());
    EXPECT_EQ(right.verdict, Verdict::certified) << reason_line(right);
    ASSERT_TRUE(std::holds_alternative<CollideEvent>(h.events.front()));
    h.events.erase(h.events.begin());
    std::get<ManeuverEvent>(h.events.front()).p = Vec2{9.0000009, 0};
    h.count();
    EXPECT_EQ(certify(scene, h, recorded()).verdict, Verdict::refuted);
  }
}

// Two in contact that leave each other sideways, one of which turns meanwhile to move almost as the
// other: rounded centres overlap, by less than a rounding and for long.
TEST(Recorded, LeavingSideways) {
  Scene scene =
      scene_of(12, 5,
               {testing::disk(3, 0, Rational(1, 2), -1, 0, 1),
                testing::disk(0, 3, Rational(1, 2), 0, Rational("-9999999999/10000000000"), 1),
                testing::disk(-3, 0, Rational(1, 2), 1, 0, 1),
                testing::disk(0, -3, Rational(1, 2), 0, 1, 1)});
  scene.maneuvers.push_back({2.2928932188134525, 3, -1, 0});
  const ClaimedHistory h = claimed_history(scene, run(scene));
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    const Certificate c = certify(scene, h, options);
    EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c);
  }
}

// Collisions of two that stay in contact without approaching each other.
TEST(Recorded, CollisionsAtRest) {
  Scene scene = scene_of(10, 5, {testing::disk(-2, 0, 1, 1, 0), testing::disk(2, 0, 1, -1, 0)});
  scene.restitution = 0;
  ClaimedHistory h = claimed_history(scene, run(scene));
  EXPECT_EQ(certify(scene, h, recorded()).verdict, Verdict::certified);
  ASSERT_EQ(h.events.size(), 1u);
  auto again = std::get<CollideEvent>(h.events.front());
  again.t = 2;
  h.events.emplace_back(again);
  h.count();
  EXPECT_EQ(certify(scene, h, recorded()).verdict, Verdict::refuted);
}

// Two so small that their centres are rounded to one: any normal will do, but no other law. What
// the engine writes of them is right under both truths.
TEST(Recorded, CentresThatCoincide) {
  const Scene scene = scene_of(
      2000, 1, {testing::disk(1000, 0, 1e-14, 1, 0, 1), testing::disk(1001, 0, 1e-14, -1, 0, 1)});
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ASSERT_EQ(right.events.size(), 1u);
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    const Certificate c = certify(scene, right, options);
    EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c);
    for (const auto& v :
         {std::array{Vec2{-50, 3}, Vec2{70, 9}}, std::array{Vec2{-1, 0}, Vec2{2, 0}},
          std::array{Vec2{1, 0}, Vec2{1, 0}}}) {
      ClaimedHistory wrong = right;
      std::get<CollideEvent>(wrong.events.front()).v = {v[0], v[1]};
      EXPECT_EQ(certify(scene, wrong, options).verdict, Verdict::refuted);
    }
  }
}

// Each thread takes the parts as they come; nothing of that is in the certificate.
TEST(Recorded, AnyNumberOfThreads) {
  Random random(11);
  const Scene scene = random_scene({.n = 30, .horizon = 60}, random);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ASSERT_GT(right.events.size(), 300u);
  ClaimedHistory wrong = right;
  wrong.events.erase(wrong.events.begin() + 200);
  wrong.count();
  for (const ClaimedHistory& history : {right, wrong}) {
    std::string first;
    for (const int threads : {1, 2, 3, 8}) {
      CertifyOptions options;
      options.truth = Truth::recorded;
      options.least_part = 20;
      options.threads = threads;
      const std::string report = report_text({}, options, certify(scene, history, options));
      if (first.empty()) first = report;
      EXPECT_EQ(report, first) << threads << " threads";
    }
  }
}

// Two edges of the same four generators: the name of the other one, claimed at the flip of the one,
// leads the reader of parts to another diagram than the checker. Each part alone would be right.
TEST(Recorded, AnotherEdgeOfTheSameFourBetweenParts) {
  Scene scene = scene_of(100, 10,
                         {testing::disk(50.38131249313908, 58.222689997368285, 46.43941306946387,
                                        -2.0680486515527354, 1.1339237005733944),
                          testing::disk(54.800421202096395, 113.58396980058205, 3.0337252484489112,
                                        2.2703157136306307, 5.222349678364295),
                          testing::disk(-35.18708866854996, 45.3763023255911, 18.560478041500453,
                                        3.141087019698466, 2.187632242310349),
                          testing::disk(-28.984064422029128, -24.553704818111584, 20.14595901579846,
                                        -1.9613944740496103, -2.093787000058063),
                          testing::disk(-5.2104527165097245, 7.9005553466611005, 5.957491809569453,
                                        -4.220412152736369, -2.0163639921145564),
                          testing::disk(-68.79773554987969, 110.36513176299924, 3.2973022541334847,
                                        1.019412064417026, -1.4427283867095444),
                          testing::disk(5.603384992494127, -39.96425840957161, 4.869779088737463,
                                        3.9803571291012725, -2.574797223705676),
                          testing::disk(44.15447774226692, 131.65510503061176, 1.6919319123462637,
                                        -1.531308470197203, -2.9658545418756668),
                          testing::disk(75.68123664853928, -10.088004637862618, 0.6872748746706234,
                                        4.421250774231884, -0.7394690904490173),
                          testing::disk(-53.78645372963205, 30.41967593206547, 3.2268832558222886,
                                        0.30262193037037793, -0.3613504337973092)});
  scene.cx = -1.1715675123866944;
  scene.cy = 45.24493898786352;
  ClaimedHistory history = claimed_history(scene, run(scene));
  int changed = 0;
  for (auto& event : history.events) {
    auto* flip = std::get_if<FlipEvent>(&event);
    if (flip == nullptr || canonical(flip->quad) != Quad{0, 1, 7, -1}) continue;
    flip->quad = {0, 1, -1, 7};
    ++changed;
  }
  ASSERT_EQ(changed, 1);
  for (const std::size_t least : {std::size_t{1}, std::size_t{16384}}) {
    CertifyOptions options;
    options.truth = Truth::recorded;
    options.least_part = least;
    const Certificate one = certify(scene, history, options);
    EXPECT_EQ(one.verdict, Verdict::refuted) << least;
    EXPECT_EQ(one.divergence->fault, Fault::spurious_event) << least;
    // Nothing false is claimed where no quadruplet is oriented.
    ClaimedHistory stripped = history;
    stripped.header.oriented = false;
    for (auto& event : stripped.events) {
      auto* flip = std::get_if<FlipEvent>(&event);
      if (flip == nullptr) continue;
      const Quad& q = flip->quad;
      flip->quad = {std::min(q.l, q.r), std::max(q.l, q.r), std::min(q.s, q.e), std::max(q.s, q.e)};
    }
    const Certificate all = certify(scene, stripped, options);
    EXPECT_EQ(all.verdict, Verdict::certified) << least << " " << reason_line(all);
    EXPECT_GT(all.resolved, 1) << least;
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
