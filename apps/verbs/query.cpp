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
#include "history/event_limit.h"

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
  require_order(request.scene, request.history);
  const Rational t = time_argument("--at", request.t);
  const EventLimit limit(request.options.max_events);
  const Scene scene = read_scene(request.scene);
  TrueMoment moment = true_moment(scene, request.history, t, request.options);
  const Answer given = answer({scene, t, moment}, request);
  const CooperativeInterruption interruption;
  give(given, request.output, words_beside({request.output}));
  return ExitCode::ok;
}

// A verb that asks about one instant; the caller adds what is its own.
Verb& add_instant(Verb& query, const std::shared_ptr<Request>& request, const std::string& name,
                  const std::string& description, InstantAnswer answer) {
  Verb& verb = query.add_verb(name, description);
  verb.input("scene", request->scene, "The scene.").required();
  verb.input("history", request->history,
             "A history of the scene, whose collisions save computing them again.");
  verb.text("--at", request->t, "TIME", "The time, as exact text: 12.5, 1/3.").required();
  verb.output(request->output, "Write the answer here, as JSON, besides the table.");
  add_computing_limits(verb, request->options);
  verb.does([request, answer = std::move(answer)] { return ask(*request, answer); });
  return verb;
}

void add_probe(Verb& verb, Request& request) {
  verb.text("--probe", request.probe, "RADIUS", "The probe's radius, as exact text.").required();
}

void add_nearest(Verb& query, const std::shared_ptr<Request>& request) {
  Verb& verb = add_instant(
      query, request, "nearest", "The disks nearest to a point",
      [](const InstantQuery& q, const Request& r) {
        return answer_nearest(
            q, {number_argument("--point", r.point[0]), number_argument("--point", r.point[1])},
            r.count);
      });
  verb.add({.names = {"--point"},
            .type = "X Y",
            .help = "The point, as exact text.",
            .values = 2,
            .take = [request](const std::vector<std::string>& xy) { request->point = xy; }})
      .required();
  verb.whole("--count", request->count, 1, 2'000'000, "How many disks.");
  verb.example("voroproof query nearest a.scene.json --at 12.5 --point 1 -2 --count 3");
}

void add_neighbours(Verb& query, const std::shared_ptr<Request>& request) {
  Verb& verb =
      add_instant(query, request, "neighbours",
                  "The generators whose cells share an edge with that of a disk, and the gaps",
                  [](const InstantQuery& q, const Request& r) {
                    return answer_neighbours(q, disk_of(q.scene, r.disk));
                  });
  verb.whole("--disk", request->disk, 0, max_disks, "The disk.").required();
  verb.example("voroproof query neighbours a.scene.json --at 12.5 --disk 7");
}

void add_closest(Verb& query, const std::shared_ptr<Request>& request) {
  Verb& verb =
      add_instant(query, request, "closest", "The closest pairs, of all generators and of disks",
                  [](const InstantQuery& q, const Request&) { return answer_closest(q); });
  verb.example("voroproof query closest a.scene.json --at 12.5");
}

void add_offset(Verb& query, const std::shared_ptr<Request>& request) {
  Verb& verb = add_instant(query, request, "offset",
                           "The boundary of the places where the centre of a probe fits",
                           [](const InstantQuery& q, const Request& r) {
                             return answer_offset(q, time_argument("--probe", r.probe));
                           });
  add_probe(verb, *request);
  verb.example("voroproof query offset a.scene.json --at 12.5 --probe 1/2 -o o.json");
}

void add_voids(Verb& query, const std::shared_ptr<Request>& request) {
  Verb& verb = add_instant(query, request, "voids",
                           "The voids in which a probe can move, and the tunnels it passes",
                           [](const InstantQuery& q, const Request& r) {
                             return answer_voids(q, time_argument("--probe", r.probe));
                           });
  add_probe(verb, *request);
  verb.example("voroproof query voids a.scene.json --at 12.5 --probe 1/2 -o v.json");
}

void add_critical(Verb& query, const std::shared_ptr<Request>& request) {
  Verb& verb =
      add_instant(query, request, "critical",
                  "The probe radii at which each tunnel closes and each void vanishes",
                  [](const InstantQuery& q, const Request&) { return answer_critical(q); });
  verb.example("voroproof query critical a.scene.json --at 12.5");
}

}  // namespace

void add_query(Verb& program) {
  Verb& query = program.add_verb("query", "Ask what holds of a scene, at an instant or over time");
  const auto request = std::make_shared<Request>();

  add_nearest(query, request);
  add_neighbours(query, request);
  add_closest(query, request);
  add_offset(query, request);
  add_voids(query, request);
  add_critical(query, request);
  add_queries_over_time(query);
  query
      .note(
          "Answers at an instant are about the true motion, if a given history lacks no collision. "
          "Answers over time (a window, not "
          "--at) are about the paths that the history records, which after collisions are "
          "rounded.")
      .note("Answers are JSON: docs/formats.md, section 12. What is exact: docs/queries.md.");
  query.example("voroproof query closest a.scene.json --at 12.5");
}

}  // namespace voroproof::internal
