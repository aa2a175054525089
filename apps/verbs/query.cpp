// voroproof query: what holds of a scene at an instant.
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/answers/query_instant.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, t, output;
  std::string probe;
  std::vector<std::string> point;
  std::size_t count = 1;
  int disk = 0;
  EngineOptions options;
};

using InstantAnswer = std::function<Answer(const InstantQuery&, const Request&)>;

GenId disk_of(const Scene& scene, int disk) {
  if (disk >= static_cast<int>(scene.disks.size())) {
    throw UsageError("--disk: the scene has no disk " + std::to_string(disk));
  }
  return disk;
}

ExitCode ask(const Request& request, const InstantAnswer& answer) {
  require_distinct({request.scene, request.history}, {request.output});
  const Rational t = time_argument("--at", request.t);
  const Scene scene = read_scene(request.scene);
  TrueMoment moment = true_moment(scene, request.history, t, request.options);
  const Answer given = answer({scene, t, moment}, request);
  const CooperativeInterruption interruption;
  give(given, request.output);
  return ExitCode::ok;
}

// A subcommand that asks about one instant; the caller adds what is its own.
CLI::App* add_instant(CLI::App& query, Action& action, const std::shared_ptr<Request>& request,
                      const std::string& name, const std::string& description,
                      InstantAnswer answer) {
  CLI::App* verb = query.add_subcommand(name, description);
  add_file(*verb, "scene", request->scene, "the scene")->required();
  add_file(*verb, "history", request->history,
           "a history of the scene, whose collisions save computing them again");
  add_text(*verb, "--at", request->t, "TIME", "the time, as exact text: 12.5, 1/3")->required();
  add_file(*verb, "-o,--output", request->output, "write the answer here, as JSON");
  add_max_bits(*verb, request->options.motion.max_bits);
  add_max_events(*verb, request->options.max_events);
  verb->callback([request, answer = std::move(answer), &action] {
    action = [request, answer] { return ask(*request, answer); };
  });
  return verb;
}

void add_probe(CLI::App& verb, Request& request) {
  add_text(verb, "--probe", request.probe, "RADIUS", "the probe's radius, as exact text")
      ->required();
}

void add_nearest(CLI::App& query, Action& action, const std::shared_ptr<Request>& request) {
  CLI::App* verb = add_instant(
      query, action, request, "nearest", "The disks nearest to a point",
      [](const InstantQuery& q, const Request& r) {
        return answer_nearest(
            q, {number_argument("--point", r.point[0]), number_argument("--point", r.point[1])},
            r.count);
      });
  verb->add_option("--point", request->point, "the point, as exact text")
      ->type_name("X Y")
      ->expected(2)
      ->allow_extra_args(false)
      ->required();
  verb->add_option("--count", request->count, "how many")
      ->check(whole_number())
      ->check(CLI::Range(1, 2'000'000))
      ->capture_default_str();
  verb->footer("Example:\n  voroproof query nearest a.scene.json --at 12.5 --point 1 -2 --count 3");
}

void add_neighbours(CLI::App& query, Action& action, const std::shared_ptr<Request>& request) {
  CLI::App* verb =
      add_instant(query, action, request, "neighbours",
                  "The generators whose cells share an edge with that of a disk, and the gaps",
                  [](const InstantQuery& q, const Request& r) {
                    return answer_neighbours(q, disk_of(q.scene, r.disk));
                  });
  verb->add_option("--disk", request->disk, "the disk")
      ->check(whole_number())
      ->check(CLI::Range(0, max_disks))
      ->required();
  verb->footer("Example:\n  voroproof query neighbours a.scene.json --at 12.5 --disk 7");
}

void add_closest(CLI::App& query, Action& action, const std::shared_ptr<Request>& request) {
  CLI::App* verb = add_instant(
      query, action, request, "closest", "The closest pairs, of all generators and of disks",
      [](const InstantQuery& q, const Request&) { return answer_closest(q); });
  verb->footer("Example:\n  voroproof query closest a.scene.json --at 12.5");
}

void add_offset(CLI::App& query, Action& action, const std::shared_ptr<Request>& request) {
  CLI::App* verb = add_instant(query, action, request, "offset",
                               "The boundary of the places where the centre of a probe fits",
                               [](const InstantQuery& q, const Request& r) {
                                 return answer_offset(q, time_argument("--probe", r.probe));
                               });
  add_probe(*verb, *request);
  verb->footer("Example:\n  voroproof query offset a.scene.json --at 12.5 --probe 1/2 -o o.json");
}

void add_voids(CLI::App& query, Action& action, const std::shared_ptr<Request>& request) {
  CLI::App* verb = add_instant(query, action, request, "voids",
                               "The voids in which a probe can move, and the tunnels it passes",
                               [](const InstantQuery& q, const Request& r) {
                                 return answer_voids(q, time_argument("--probe", r.probe));
                               });
  add_probe(*verb, *request);
  verb->footer("Example:\n  voroproof query voids a.scene.json --at 12.5 --probe 1/2 -o v.json");
}

void add_critical(CLI::App& query, Action& action, const std::shared_ptr<Request>& request) {
  CLI::App* verb =
      add_instant(query, action, request, "critical",
                  "The probe radii at which each tunnel closes and each void vanishes",
                  [](const InstantQuery& q, const Request&) { return answer_critical(q); });
  verb->footer("Example:\n  voroproof query critical a.scene.json --at 12.5");
}

}  // namespace

void add_query(CLI::App& app, Action& action) {
  CLI::App* query =
      app.add_subcommand("query", "Ask what holds of a scene, at an instant or over time");
  query->require_subcommand(1);
  const auto request = std::make_shared<Request>();

  add_nearest(*query, action, request);
  add_neighbours(*query, action, request);
  add_closest(*query, action, request);
  add_offset(*query, action, request);
  add_voids(*query, action, request);
  add_critical(*query, action, request);
  add_queries_over_time(*query, action);
  query->footer(
      "At an instant: of the true motion. Over time (a window, not --at): of the paths that the\n"
      "history records, which after collisions are rounded.\n"
      "Answers as JSON: docs/formats.md, section 12. What is exact: docs/queries.md.\n"
      "Example:\n  voroproof query closest a.scene.json --at 12.5");
}

}  // namespace voroproof::internal
