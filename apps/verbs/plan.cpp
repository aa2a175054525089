// voroproof plan: collision-free flights from starts to goals.
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "apps/answers/plan_report.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/draw/plan_picture.h"
#include "apps/verbs/verbs.h"
#include "corpus/plan_presets.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "history/scene_writer.h"
#include "history/sha256.h"
#include "library/planning/assignment.h"
#include "library/planning/planner.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string task, preset, scene, report, picture, clearance, arrive;
  std::string assignment = "given";
  int size = 1000;
  bool quiet = false;
};

PlanTask requested_task(const Request& request) {
  if (request.task.empty() == request.preset.empty())
    throw UsageError("plan: either a plan file or --preset");
  PlanTask task = request.preset.empty() ? read_plan(request.task) : plan_preset(request.preset);
  if (!request.clearance.empty()) task.clearance = time_argument("--clearance", request.clearance);
  if (!request.arrive.empty()) {
    task.arrive = time_argument("--arrive", request.arrive);
    if (task.arrive == 0) throw UsageError("--arrive: 0: not positive");
  }
  if (request.assignment == "optimal") assign_nearest_goals(task);
  return task;
}

std::string described(const Approach& approach) {
  const Enclosure enclosed = gap(approach);
  return "vehicles " + std::to_string(approach.i) + " and " + std::to_string(approach.j) +
         " at t = " + number_text(round_nearest(approach.t)) + ", gap " + number_text(enclosed.lo) +
         " to " + number_text(enclosed.hi);
}

void print_summary(std::ostream& out, const PlanResult& result) {
  out << "vehicles " << result.plan.task.vehicles.size() << "; conjunctions avoided "
      << result.avoided.size() << "; speed changes " << speed_changes(result.plan);
  if (result.nearest) out << "; nearest " << described(*result.nearest);
  out << '\n';
}

ExitCode report(const Request& request, const PlanResult& result) {
  if (result.impossible) {
    std::cerr << "voroproof: no plan exists: too near at the ends: "
              << described(*result.impossible) << '\n';
    return ExitCode::refuted;
  }
  if (result.unsolved) {
    std::cerr << "voroproof: no plan found: too near: " << described(*result.unsolved)
              << (request.assignment == "given"
                      ? "; the goals are as given, and --assignment optimal exchanges them\n"
                      : "\n");
    return ExitCode::undecided;
  }
  return ExitCode::ok;
}

// Extreme ways and times may lead beyond the limits of a scene.
void require_scene(const std::string& text, const std::string& path) {
  try {
    parse_scene(text, path);
  } catch (const InputError& fault) {
    throw UsageError("plan: gives no valid scene: " + fault.field() + ": " + fault.reason());
  }
}

ExitCode plan(const Request& request) {
  require_distinct({request.task}, {request.scene, request.report, request.picture});
  if (!request.picture.empty()) require_picture("--picture", request.picture);
  const CooperativeInterruption interruption;
  PlanTask task = requested_task(request);
  // Begun first, so that a path that cannot be written is known before the search.
  OutputFile scene_file(request.scene);
  std::optional<OutputFile> report_file;
  if (!request.report.empty()) report_file.emplace(request.report);

  const PlanResult result =
      make_plan(std::move(task), [&](std::size_t) { return !interruption.requested(); });
  interruption.check();
  PlanRun run{producer(), request.assignment, {}};
  std::string scene;
  if (result.found()) {
    std::ostringstream text;
    write_scene(text, scene_of(result.plan));
    scene = std::move(text).str();
    require_scene(scene, request.scene);
    run.scene_sha256 = sha256_hex(scene);
  }
  if (report_file) report_file->write(plan_report_text(run, result));
  if (!request.picture.empty()) draw_plan(drawing_of(result), request.picture, request.size);
  if (result.found()) {
    scene_file.write(scene);
    scene_file.commit();
  }
  if (report_file) report_file->commit();
  if (!request.quiet && result.found()) {
    print_summary(words_beside({request.scene, request.report, request.picture}), result);
  }
  return report(request, result);
}

}  // namespace

void add_plan(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("plan", "Plan flights from starts to goals without collisions");
  verb.input("plan", request->task, "The plan file: who flies from where to where.");
  verb.choice("--preset", plan_preset_names(), request->preset,
              "A swarm after the paper's in place of a file.");
  verb.output(request->scene, "The scene to write, with the changes of speed as maneuvers.")
      .required();
  verb.output("--report", request->report,
              "Write the smallest gap, what was avoided, and all ways here, as JSON.");
  verb.output("--picture", request->picture,
              "Draw starts, goals and ways here; the name ends in .svg, .png or .pdf.");
  verb.whole("--size", request->size, 16, 20000,
             "The width and the height of the picture, in pixels.");
  verb.text("--clearance", request->clearance, "LENGTH",
            "The gap that vehicles keep between them, exactly, in place of the file's.");
  verb.text("--arrive", request->arrive, "TIME",
            "The time at which all arrive, exactly, in place of the file's.");
  verb.choice(
      "--assignment", {"given", "optimal"}, request->assignment,
      "The goals as given, or exchanged among vehicles of one radius so that the sum of the "
      "squares of the ways is least.");
  verb.flag("--quiet", request->quiet, "Write no summary.");
  verb.note(
      "Exit code 1: two starts or goals are too near, there is no plan; 3: none was found (the "
      "message names a pair and a time; no scene is written).");
  verb.example("voroproof plan --preset five -o a.scene.json --report a.report.json");
  verb.does([request] { return plan(*request); });
}

}  // namespace voroproof::internal
