// What means the same as a right history is not refuted. (That keys may come in any order and edges
// be named either way is the reader's: tests/history/.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "certify/report.h"
#include "engine/static_diagram.h"
#include "library/maneuver_input.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

CertifyOptions options(Truth truth, double tolerance = 1e-6) {
  CertifyOptions o;
  o.truth = truth;
  o.tolerance = to_rational(tolerance);
  o.propose_initial = [](Motion& motion) {
    TierCounts counts;
    Diagram diagram = static_diagram(motion, 0, counts);
    settle(diagram, motion, Moment::at(0), counts);
    return diagram.quads();
  };
  return o;
}

double& time_of(voroproof::internal::Event& e) {
  return std::visit([](auto& x) -> double& { return x.t; }, e);
}

std::vector<GenId> generators_of(const voroproof::internal::Event& e) {
  if (const auto* f = std::get_if<FlipEvent>(&e))
    return {f->quad.l, f->quad.r, f->quad.s, f->quad.e};
  if (const auto* c = std::get_if<CollideEvent>(&e)) return {c->i, c->j};
  return {std::get<ManeuverEvent>(e).disk};
}

class Rewriting : public ::testing::Test {
 protected:
  // Puts right histories through `change`, which says whether it did anything.
  template <class Change>
  void expect_certified(Truth truth, double tolerance, Change&& change) {
    int changed = 0;
    for (int k = 0; k < 40; ++k) {
      const Scene scene = random_scene({.n = n_, .horizon = 15}, random_);
      const RecordedRun r = run(scene);
      ASSERT_TRUE(r.complete());
      ClaimedHistory h = claimed_history(scene, r);
      if (!change(h)) continue;
      ++changed;
      const Certificate c = certify(scene, h, options(truth, tolerance));
      EXPECT_EQ(c.verdict, Verdict::certified)
          << reason_line(c) << "\n"
          << voroproof::internal::testing::text(h) << voroproof::internal::testing::text(scene);
      last_ = c;
    }
    EXPECT_GT(changed, 3);
  }

  int n_ = 8;
  Random random_{9};
  Certificate last_;
};

TEST_F(Rewriting, WithoutAnInitialDiagram) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect_certified(truth, 1e-6, [](ClaimedHistory& h) {
      h.header.initial.reset();
      return true;
    });
  }
}

TEST_F(Rewriting, WithoutVelocities) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect_certified(truth, 1e-6, [](ClaimedHistory& h) {
      for (auto& e : h.events) {
        if (auto* c = std::get_if<CollideEvent>(&e)) c->v = {};
      }
      return true;
    });
  }
}

TEST_F(Rewriting, WithoutCentres) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect_certified(truth, 1e-6, [](ClaimedHistory& h) {
      for (auto& e : h.events) {
        if (auto* c = std::get_if<CollideEvent>(&e)) c->p = {};
      }
      return true;
    });
  }
}

TEST_F(Rewriting, TimesOfFlipsWithinTheTolerance) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect_certified(truth, 1e-4, [this](ClaimedHistory& h) {
      double last = 0;
      for (auto& e : h.events) {
        double& t = time_of(e);
        if (std::holds_alternative<FlipEvent>(e)) {
          t = std::clamp(t + uniform(random_, -0.9e-4, 0.9e-4), 0.0, 15.0);
        }
        last = t = std::max(t, last);
      }
      // Raising a collision's time to that of a flip before it would be another motion.
      return true;
    });
  }
}

// Every time is another within the tolerance, and the file in their order: under the recorded truth
// those of flips, as the collisions' times are the truth.
TEST_F(Rewriting, TimesWithinTheToleranceThatReorderTheFile) {
  constexpr double tolerance = 5e-3;
  n_ = 25;
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    std::int64_t swaps = 0;
    expect_certified(truth, tolerance, [&](ClaimedHistory& h) {
      std::vector<std::pair<double, voroproof::internal::Event>> events;
      for (auto& e : h.events) {
        const double t = time_of(e);
        if (truth == Truth::exact || std::holds_alternative<FlipEvent>(e)) {
          time_of(e) =
              std::clamp(t + uniform(random_, -0.9 * tolerance, 0.9 * tolerance), 0.0, 15.0);
        }
        events.emplace_back(t, std::move(e));
      }
      std::stable_sort(events.begin(), events.end(), [](const auto& a, const auto& b) {
        return time(a.second) < time(b.second);
      });
      h.events.clear();
      bool commute = true;
      for (std::size_t k = 0; k < events.size(); ++k) {
        const auto x = generators_of(events[k].second);
        for (std::size_t j = k; j-- > 0 && events[k].first - events[j].first < 2 * tolerance;) {
          if (events[j].first <= events[k].first) continue;
          ++swaps;
          const auto y = generators_of(events[j].second);
          if (std::find_first_of(x.begin(), x.end(), y.begin(), y.end()) != x.end())
            commute = false;
        }
        h.events.push_back(events[k].second);
      }
      return commute;
    });
    EXPECT_GT(swaps, 10);
  }
}

TEST_F(Rewriting, EventsThatCommuteSwappedWithinTheTolerance) {
  constexpr double tolerance = 1e-2;
  int swaps = 0;
  n_ = 25;
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect_certified(truth, tolerance, [&](ClaimedHistory& h) {
      bool changed = false;
      for (std::size_t k = 0; k + 1 < h.events.size(); ++k) {
        auto& a = h.events[k];
        auto& b = h.events[k + 1];
        if (!std::holds_alternative<FlipEvent>(a) || !std::holds_alternative<FlipEvent>(b) ||
            time_of(b) - time_of(a) > 0.4 * tolerance || time_of(a) == time_of(b)) {
          continue;
        }
        const auto x = generators_of(a), y = generators_of(b);
        if (std::find_first_of(x.begin(), x.end(), y.begin(), y.end()) != x.end()) continue;
        std::swap(time_of(a), time_of(b));
        std::swap(a, b);
        changed = true;
        ++k;
      }
      return changed;
    });
    swaps += static_cast<int>(last_.swaps);
  }
  EXPECT_GT(swaps, 0);
}

TEST_F(Rewriting, SwapsAreRefutedUnderStrict) {
  constexpr double tolerance = 1e-2;
  int refuted = 0;
  for (int round = 0; round < 40; ++round) {
    const Scene scene = random_scene({.n = 25, .horizon = 15}, random_);
    ClaimedHistory h = claimed_history(scene, run(scene));
    for (std::size_t k = 0; k + 1 < h.events.size(); ++k) {
      auto& a = h.events[k];
      auto& b = h.events[k + 1];
      const auto x = generators_of(a), y = generators_of(b);
      if (!std::holds_alternative<FlipEvent>(a) || !std::holds_alternative<FlipEvent>(b) ||
          time_of(b) - time_of(a) > 0.4 * tolerance || time_of(a) == time_of(b) ||
          std::find_first_of(x.begin(), x.end(), y.begin(), y.end()) != x.end()) {
        continue;
      }
      std::swap(time_of(a), time_of(b));
      std::swap(a, b);
      CertifyOptions o = options(Truth::exact, tolerance);
      o.strict = true;
      const Certificate c = certify(scene, h, o);
      EXPECT_EQ(c.verdict, Verdict::refuted);
      EXPECT_EQ(c.divergence->fault, Fault::wrong_order) << reason_line(c);
      ++refuted;
      break;
    }
  }
  EXPECT_GT(refuted, 3);
}

TEST_F(Rewriting, QuadrupletsWithoutOrientation) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect_certified(truth, 1e-6, [this](ClaimedHistory& h) {
      h.header.oriented = false;
      std::size_t mirrored = 0, flips = 0;
      for (auto& e : h.events) {
        auto* f = std::get_if<FlipEvent>(&e);
        if (f == nullptr) continue;
        ++flips;
        if (random_() % 2 == 0) continue;
        f->quad = canonical(Quad{f->quad.l, f->quad.r, f->quad.e, f->quad.s});
        ++mirrored;
      }
      return mirrored >= 2 && 4 * mirrored >= flips;
    });
    EXPECT_GT(last_.resolved, 0);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
