// The second way in which the truth of corpus/cases/ is established: motion replayed in high
// precision from the order of the collisions alone, and diagrams straight from their definition,
// at every midpoint between events (at some where disks are many) and at the instants that the case
// names. Nothing of the engine or of the certifier takes part; the record in case.json must say
// what is seen here.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "exact/topology/diagram.h"
#include "history/diagram_file.h"
#include "history/history_reader.h"
#include "history/scene.h"
#include "tests/support/history_check.h"

namespace voroproof::internal::testing {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> all_cases() {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(VOROPROOF_CASES)) {
    if (entry.path().filename() == "case.json") {
      found.push_back(fs::relative(entry.path().parent_path(), VOROPROOF_CASES).string());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

RoundedState state(const std::optional<Vec2>& p, const std::optional<Vec2>& v) {
  if (!p || !v) return {};
  return {(*p)[0], (*p)[1], (*v)[0], (*v)[1]};
}

// The history as if the engine had just given it. A history that stops is taken up to there: the
// horizon of `scene` becomes the time of the stop.
RecordedRun read_run(const std::string& path, Scene& scene) {
  HistoryReader reader(path, static_cast<int>(scene.disks.size()));
  RecordedRun run;
  run.begins = 1;
  run.initial = reader.header().initial.value_or(std::vector<Quad>{});
  while (const auto event = reader.next()) {
    if (const auto* f = std::get_if<FlipEvent>(&*event)) {
      run.events.push_back({.kind = Event::Kind::flip, .t = f->t, .edge = f->quad});
    } else if (const auto* c = std::get_if<CollideEvent>(&*event)) {
      run.events.push_back({.kind = Event::Kind::collision,
                            .t = c->t,
                            .i = c->i,
                            .j = c->j,
                            .first = state(c->p[0], c->v[0]),
                            .second = state(c->p[1], c->v[1])});
    } else {
      const auto& m = std::get<ManeuverEvent>(*event);
      run.events.push_back({.kind = Event::Kind::maneuver,
                            .t = m.t,
                            .i = m.disk,
                            .j = m.disk,
                            .first = state(m.p, m.v)});
    }
  }
  if (const auto* stop = std::get_if<HistoryStop>(&reader.ending())) {
    scene.horizon = to_rational(stop->t);
  }
  return run;
}

// The diagrams that the history passes through: the initial one, then one after each event.
std::vector<std::vector<Quad>> replayed(const Scene& scene, const RecordedRun& run) {
  std::vector<std::vector<Quad>> states{run.initial};
  if (run.initial.empty()) {
    states.resize(run.events.size() + 1);
    return states;
  }
  Diagram diagram = diagram_of(static_cast<int>(scene.disks.size()), run.initial);
  for (const Event& e : run.events) {
    if (e.kind == Event::Kind::flip) {
      Diagram::HalfEdge h = 0;
      while (h < 2 * diagram.edges() && diagram.quad(h) != e.edge) ++h;
      if (h == 2 * diagram.edges()) throw std::runtime_error("there is no such edge: " + text(e));
      diagram.flip(h);
    }
    states.push_back(diagram.quads());
  }
  return states;
}

// Whether the history passes through `edges` at t. Its times are rounded: where events are nearer
// to t than that, any of the diagrams between them may be meant.
bool passes_through(const std::vector<std::vector<Quad>>& states, const RecordedRun& run, double t,
                    const std::vector<Quad>& edges) {
  const double slack = 4 * std::numeric_limits<double>::epsilon() * t;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const bool begun = k == 0 || run.events[k - 1].t <= t + slack;
    const bool over = k < run.events.size() && run.events[k].t < t - slack;
    if (begun && !over && states[k] == edges) return true;
  }
  return false;
}

class CorpusTruth : public ::testing::TestWithParam<std::string> {};

TEST_P(CorpusTruth, BruteForceAgrees) {
  const fs::path folder = fs::path(VOROPROOF_CASES) / GetParam();
  std::ifstream file(folder / "case.json");
  const nlohmann::json head = nlohmann::json::parse(file);
  const Scene asked = read_scene((folder / "scene.scene.json").string());
  Scene scene = asked;
  RecordedRun run = read_run((folder / "exact.history.jsonl").string(), scene);
  ASSERT_EQ(head.at("verdict") == "undecided", scene.horizon != asked.horizon);
  const std::vector<std::vector<Quad>> states = replayed(scene, run);
  run.final_diagram = states.back();

  // Tags say where two instants have one binary64; their order is seen at the case's instants.
  const auto& tags = head.at("tags");
  const bool distinct = std::find(tags.begin(), tags.end(), "one-time-two-instants") == tags.end();
  CheckCounts seen;
  const int all = std::numeric_limits<int>::max();
  // As in corpus/degenerate/build.py: with more disks brute force takes seconds a diagram.
  const int midpoints = scene.disks.size() > 32 ? 4 : all;
  // A run that stops at once has not even an initial diagram, and nothing to be held against.
  const bool begun = !run.initial.empty() || scene.disks.size() < 2;
  EXPECT_TRUE(begun || (run.events.empty() && head.at("verdict") == "undecided"));
  if (begun) {
    EXPECT_EQ(check_history(scene, run,
                            {.brute_force_instants = midpoints,
                             .legality_instants = all,
                             .one_time_is_one_instant = distinct},
                            &seen),
              "");
  }

  const oracle::MotionScene motion_scene = oracle_scene(scene);
  const oracle::BasicMotionOracle<1000> motion(motion_scene, motion_records(scene, run));
  int instants = 0;
  for (const nlohmann::json& at : head.at("instants")) {
    const std::string name = "diagram-" + std::to_string(instants++) + ".diagram.json";
    const DiagramFile diagram = read_diagram((folder / name).string());
    // What stands in the diagram file is what case.json asks for.
    ASSERT_EQ(at.is_string() ? nlohmann::json(diagram.t_text) == at : diagram.t == at, true)
        << name;
    const Rational t = at.is_string() ? Rational(at.get<std::string>()) : to_rational(diagram.t);
    const auto disks = motion.disks_at(oracle::rounded<decltype(motion)::Number>(t));
    for (std::size_t i = 0; i < disks.size(); ++i) {
      EXPECT_EQ(static_cast<double>(disks[i].x), diagram.disks[i].center[0])
          << name << " disk " << i;
      EXPECT_EQ(static_cast<double>(disks[i].y), diagram.disks[i].center[1])
          << name << " disk " << i;
    }
    EXPECT_TRUE(passes_through(states, run, t.get_d(), diagram.edges)) << name;
    const oracle::BruteDiagram truth =
        oracle::brute_force_diagram(disks, oracle::rounded(motion_scene.container));
    std::string why;
    EXPECT_TRUE(oracle::agrees(truth, quadruples(diagram.edges), &why)) << name << ": " << why;
  }
  std::ostringstream record;
  record << "tests/corpus/truth_test.cpp: motion replayed in 300 digits or more; brute force "
            "agrees at "
         << seen.brute_force << " midpoints and " << instants << " instants";
  const auto& truths = head.at("truth");
  EXPECT_NE(std::find(truths.begin(), truths.end(), record.str()), truths.end())
      << "case.json does not say: " << record.str();
}

INSTANTIATE_TEST_SUITE_P(Case, CorpusTruth, ::testing::ValuesIn(all_cases()), [](const auto& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '/'; }, '_');
  return name;
});

}  // namespace
}  // namespace voroproof::internal::testing
