// voroproof query: what holds of a scene over a window of time.
#include <charconv>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/answers/query_over_time.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"
#include "history/event_limit.h"
#include "history/history_reader.h"
#include "library/true_moment.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, from = "0", horizon, output;
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

// Requires a window with a length: openings and closings happen between two times.
void require_length(const Window& window) {
  if (window.from == window.to) throw UsageError("--horizon: not after --from");
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
  require_order(request.scene, request.history);
  Window window{time_argument("--from", request.from), 0};
  const EventLimit limit(request.options.max_events);
  const Scene scene = read_scene(request.scene);
  const int disks = static_cast<int>(scene.disks.size());
  window.to = request.horizon.empty()
                  ? HistoryReader(request.history, disks, scene.sha256).header().horizon
                  : time_argument("--horizon", request.horizon);
  if (window.to < window.from) throw UsageError("--horizon: before --from");
  check_generators(scene, option, request.generators);
  HistoryCursor history(
      scene, request.history,
      [&] { return diagram_at(run_to(scene, 0, request.options)->motion(), 0); }, window.to);
  const Paths paths(scene, history, request.history);
  const Answer given = answered(answer, {scene, history, paths, window}, request);
  const CooperativeInterruption interruption;
  give(given, request.output, words_beside({request.output}));
  return ExitCode::ok;
}

// How the help of these queries ends; `arguments` are those of the example after its two files.
void add_end(Verb& verb, const std::string& arguments) {
  verb.note(
      "The answer is about the paths that the history records: those of the true motion up to a "
      "disk's first collision; from then on those from its recorded, rounded places and "
      "velocities.");
  verb.example("voroproof query " + verb.name() + " a.scene.json a.history.jsonl" + arguments);
}

GenId generator_argument(const std::string& option, const std::string& text) {
  const char* const end = text.data() + text.size();
  GenId id = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, id);
  if (error != std::errc() || rest != end) {
    throw UsageError(option + ": " + text + " is not the id of a generator");
  }
  return id;
}

// The generators that a query is about: how many, by which option, and what the help says of it.
struct Subject {
  std::string option;
  int generators = 0;  // 0: the query is about all, and has no such option
  std::string help;
};

void add_subject(Verb& verb, Request& request, const Subject& subject) {
  if (subject.generators == 0) return;
  std::string type = "ID";
  for (int k = 1; k < subject.generators; ++k) type += " ID";
  verb.add({.names = {subject.option},
            .type = type,
            .help = subject.help,
            .values = subject.generators,
            .take =
                [&request, option = subject.option](const std::vector<std::string>& values) {
                  request.generators.clear();
                  for (const std::string& text : values) {
                    request.generators.push_back(generator_argument(option, text));
                  }
                }})
      .required();
}

Verb& add_over_time(Verb& query, const std::shared_ptr<Request>& request, const std::string& name,
                    const std::string& description, const Subject& subject, TimeAnswer answer) {
  Verb& verb = query.add_verb(name, description);
  verb.input("scene", request->scene, "The scene.").required();
  verb.input("history", request->history, "A history of the scene.").required();
  verb.text("--from", request->from, "TIME", "The beginning of the window, as exact text.");
  verb.text("--horizon", request->horizon, "TIME",
            "The end of the window; the history's horizon where it is not given.");
  verb.output(request->output, "Write the answer here, as JSON, besides the table.");
  add_computing_limits(verb, request->options);
  add_subject(verb, *request, subject);
  verb.does([request, option = subject.option, answer = std::move(answer)] {
    return ask(*request, option, answer);
  });
  return verb;
}

void add_probe(Verb& verb, Request& request) {
  verb.text("--probe", request.probe, "RADIUS", "The probe's radius, as exact text.").required();
}

const Subject all{}, pair{"--pair", 2, "The ids of the two generators; -1 is the container."};

void add_gaps(Verb& query, const std::shared_ptr<Request>& request) {
  add_end(add_over_time(query, request, "neighbours-over",
                        "When which cells share an edge with that of a disk",
                        {"--disk", 1, "The id of the disk."},
                        [](const TimeQuery& q, const Request& r) {
                          if (r.generators[0] == container_id)
                            throw UsageError("--disk: the container is none");
                          return answer_neighbours_over(q, r.generators[0]);
                        }),
          " --disk 7 --horizon 20");
  add_end(
      add_over_time(query, request, "gap-over", "The least gap of two generators, and when", pair,
                    [](const TimeQuery& q, const Request& r) {
                      return answer_gap_over(q, r.generators[0], r.generators[1]);
                    }),
      " --pair 3 7 --horizon 20");
  add_end(add_over_time(query, request, "closest-over",
                        "The least gap of any two disks, which two, and when", all,
                        [](const TimeQuery& q, const Request&) { return answer_closest_over(q); }),
          "");
}

void add_probes(Verb& query, const std::shared_ptr<Request>& request) {
  Verb& tunnel =
      add_over_time(query, request, "tunnel",
                    "When a probe passes between two generators along a V-edge of theirs", pair,
                    [](const TimeQuery& q, const Request& r) {
                      require_length(q.window);
                      return answer_tunnel(q, r.generators[0], r.generators[1],
                                           time_argument("--probe", r.probe));
                    });
  add_probe(tunnel, *request);
  add_end(tunnel, " --pair 3 7 --probe 1/2");

  Verb& place = add_over_time(
      query, request, "void", "When a probe fits at a V-vertex that is there",
      {"--vertex", 3, "The ids of the vertex's three generators; -1 is the container."},
      [](const TimeQuery& q, const Request& r) {
        require_length(q.window);
        return answer_void(q, {r.generators[0], r.generators[1], r.generators[2]},
                           time_argument("--probe", r.probe));
      });
  add_probe(place, *request);
  add_end(place, " --vertex 1 2 3 --probe 1/2");

  Verb& voids = add_over_time(query, request, "voids-over",
                              "All voids: when they come about, part, join and vanish", all,
                              [](const TimeQuery& q, const Request& r) {
                                require_length(q.window);
                                return answer_voids_over(q, time_argument("--probe", r.probe));
                              });
  add_probe(voids, *request);
  add_end(voids, " --probe 1/2");
}

}  // namespace

void add_queries_over_time(Verb& query) {
  const auto request = std::make_shared<Request>();
  add_gaps(query, request);
  add_probes(query, request);
}

}  // namespace voroproof::internal
