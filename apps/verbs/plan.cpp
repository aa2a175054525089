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
#include "history/atomic_file.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/sha256.h"
#include "planning/assignment.h"
#include "planning/planner.h"

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

void print_summary(const PlanResult& result) {
  std::cout << "vehicles " << result.plan.task.vehicles.size() << "; conjunctions avoided "
            << result.avoided.size() << "; speed changes " << speed_changes(result.plan);
  if (result.nearest) std::cout << "; nearest " << described(*result.nearest);
  std::cout << '\n';
}

ExitCode report(const PlanResult& result) {
  if (result.impossible) {
    std::cerr << "voroproof: no plan exists: too near at the ends: "
              << described(*result.impossible) << '\n';
    return ExitCode::refuted;
  }
  if (result.unsolved) {
    std::cerr << "voroproof: no plan found: too near: " << described(*result.unsolved) << '\n';
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
  AtomicFile scene_file(request.scene);
  std::optional<AtomicFile> report_file;
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
  if (!request.quiet && result.found()) print_summary(result);
  return report(result);
}

}  // namespace

void add_plan(CLI::App& app, Action& action) {
  auto request = std::make_shared<Request>();
  CLI::App* verb =
      app.add_subcommand("plan", "Plan flights from starts to goals without collisions");
  add_file(*verb, "plan", request->task, "the plan file: who flies from where to where");
  verb->add_option("--preset", request->preset, "a swarm after the paper's in place of a file")
      ->check(CLI::IsMember(plan_preset_names()))
      ->type_name("NAME");
  add_output(*verb, request->scene, "the scene to write, with the changes of speed as maneuvers");
  add_file(*verb, "--report", request->report,
           "write the smallest gap, what was avoided, and all ways here, as JSON");
  add_file(*verb, "--picture", request->picture,
           "draw starts, goals and ways; the name ends in .svg or .png");
  verb->add_option("--size", request->size, "width and height of the picture in pixels")
      ->check(whole_number())
      ->check(CLI::Range(16, 20000))
      ->capture_default_str();
  add_text(*verb, "--clearance", request->clearance, "LENGTH",
           "that vehicles keep between them, exactly, in place of the file's");
  add_text(*verb, "--arrive", request->arrive, "TIME",
           "when all arrive, exactly, in place of the file's");
  add_choice(*verb, "--assignment", {"given", "optimal"}, request->assignment,
             "the goals as given, or exchanged among vehicles of one radius so that the sum\n"
             "of the squares of the ways is least");
  verb->add_flag("--quiet", request->quiet, "no summary");
  verb->footer(
      "Exit code 1: two starts or goals are too near, there is no plan; 3: none was found (the\n"
      "message names a pair and a time; no scene is written).\n"
      "Example:\n  voroproof plan --preset five -o a.scene.json --report a.report.json");
  verb->callback([request, &action] { action = [request] { return plan(*request); }; });
}

}  // namespace voroproof::internal
