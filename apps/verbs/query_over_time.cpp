// voroproof query: what holds of a scene over a window of time.
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "apps/answers/query_over_time.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"
#include "history/history_file.h"
#include "library/true_moment.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, from = "0", to, output;
  std::string probe;
  std::vector<int> generators;
  EngineOptions options;
};

using TimeAnswer = std::function<Answer(const TimeQuery&, const Request&)>;

void check_generators(const Scene& scene, const std::string& option,
                      const std::vector<int>& generators) {
  for (const int g : generators) {
    if (g < container_id || g >= static_cast<int>(scene.disks.size())) {
      throw UsageError(option + ": the scene has no generator " + std::to_string(g));
    }
  }
  if (std::set<int>(generators.begin(), generators.end()).size() < generators.size()) {
    throw UsageError(option + ": a generator is named twice");
  }
}

// What opens and closes does so between two times.
void require_length(const Window& window) {
  if (window.from == window.to) throw UsageError("--to: not after --from");
}

// Where one of the paths leads into another disk or out of the container, the circles that the
// claimed diagram speaks of need not exist: the history is no history of the scene.
Answer answered(const TimeAnswer& answer, const TimeQuery& query, const Request& request) {
  try {
    return answer(query, request);
  } catch (const std::domain_error&) {
    throw InputError(request.history, 0, "",
                     "the recorded paths do not fit the claimed diagram (certify tells where)");
  }
}

ExitCode ask(const Request& request, const std::string& option, const TimeAnswer& answer) {
  require_distinct({request.scene, request.history}, {request.output});
  Window window{time_argument("--from", request.from), 0};
  const Scene scene = read_scene(request.scene);
  const int disks = static_cast<int>(scene.disks.size());
  window.to = request.to.empty()
                  ? HistoryReader(request.history, disks, scene.sha256).header().horizon
                  : time_argument("--to", request.to);
  if (window.to < window.from) throw UsageError("--to: before --from");
  check_generators(scene, option, request.generators);
  HistoryCursor history(
      scene, request.history,
      [&] { return diagram_at(run_to(scene, 0, request.options)->motion(), 0); }, window.to);
  const Paths paths(scene, history, request.history);
  const Answer given = answered(answer, {scene, history, paths, window}, request);
  const CooperativeInterruption interruption;
  give(given, request.output);
  return ExitCode::ok;
}

// How the help of these queries ends; `arguments` are those of the example after its two files.
std::string footer(const std::string& name, const std::string& arguments) {
  return "About the paths that the history records: those of the true motion up to a disk's first\n"
         "collision; from then on those from its recorded, rounded places and velocities.\n"
         "Example:\n  voroproof query " +
         name + " a.scene.json a.history.jsonl" + arguments;
}

// `option` names the generators that the query is about.
CLI::App* add_over_time(CLI::App& query, Action& action, const std::shared_ptr<Request>& request,
                        const std::string& name, const std::string& description,
                        const std::string& option, int generators, TimeAnswer answer) {
  CLI::App* verb = query.add_subcommand(name, description);
  add_file(*verb, "scene", request->scene, "the scene")->required();
  add_file(*verb, "history", request->history, "a history of the scene")->required();
  add_text(*verb, "--from", request->from, "TIME", "from then on, as exact text")
      ->capture_default_str();
  add_text(*verb, "--to", request->to, "TIME", "up to then (default: the history's horizon)");
  add_file(*verb, "-o,--output", request->output, "write the answer here, as JSON");
  add_max_bits(*verb, request->options.motion.max_bits);
  if (generators > 0) {
    verb->add_option(option, request->generators, "their ids; -1 is the container")
        ->type_name("ID")
        ->expected(generators)
        ->allow_extra_args(false)
        ->required();
  }
  verb->callback([request, option, answer = std::move(answer), &action] {
    action = [request, option, answer] { return ask(*request, option, answer); };
  });
  return verb;
}

void add_probe(CLI::App& verb, Request& request) {
  add_text(verb, "--probe", request.probe, "RADIUS", "the probe's radius, as exact text")
      ->required();
}

}  // namespace

void add_queries_over_time(CLI::App& query, Action& action) {
  const auto request = std::make_shared<Request>();
  CLI::App* verb = add_over_time(query, action, request, "neighbours-over",
                                 "When which cells share an edge with that of a disk", "--disk", 1,
                                 [](const TimeQuery& q, const Request& r) {
                                   if (r.generators[0] == container_id)
                                     throw UsageError("--disk: the container is none");
                                   return answer_neighbours_over(q, r.generators[0]);
                                 });
  verb->footer(footer("neighbours-over", " --disk 7 --to 20"));

  verb =
      add_over_time(query, action, request, "gap-over", "The least gap of two generators, and when",
                    "--pair", 2, [](const TimeQuery& q, const Request& r) {
                      return answer_gap_over(q, r.generators[0], r.generators[1]);
                    });
  verb->footer(footer("gap-over", " --pair 3 7 --to 20"));

  verb = add_over_time(query, action, request, "closest-over",
                       "The least gap of any two disks, which two, and when", "", 0,
                       [](const TimeQuery& q, const Request&) { return answer_closest_over(q); });
  verb->footer(footer("closest-over", ""));

  verb = add_over_time(query, action, request, "tunnel",
                       "When a probe passes between two generators along a V-edge of theirs",
                       "--pair", 2, [](const TimeQuery& q, const Request& r) {
                         require_length(q.window);
                         return answer_tunnel(q, r.generators[0], r.generators[1],
                                              time_argument("--probe", r.probe));
                       });
  add_probe(*verb, *request);
  verb->footer(footer("tunnel", " --pair 3 7 --probe 1/2"));

  verb =
      add_over_time(query, action, request, "void", "When a probe fits at a V-vertex that is there",
                    "--vertex", 3, [](const TimeQuery& q, const Request& r) {
                      require_length(q.window);
                      return answer_void(q, {r.generators[0], r.generators[1], r.generators[2]},
                                         time_argument("--probe", r.probe));
                    });
  add_probe(*verb, *request);
  verb->footer(footer("void", " --vertex 1 2 3 --probe 1/2"));

  verb = add_over_time(query, action, request, "voids-over",
                       "All voids: when they come about, part, join and vanish", "", 0,
                       [](const TimeQuery& q, const Request& r) {
                         require_length(q.window);
                         return answer_voids_over(q, time_argument("--probe", r.probe));
                       });
  add_probe(*verb, *request);
  verb->footer(footer("voids-over", " --probe 1/2"));
}

}  // namespace voroproof::internal
