// voroproof experiment: the paper's experiments (section 7) again.
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/paper/experiment_report.h"
#include "apps/verbs/verbs.h"
#include "corpus/paper_sets.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/output_file.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string set, json, csv, predictions = "on";
  double scale = 0.1, horizon = 1000;
  std::uint64_t seed = 1;
  int members = 0;  // 0: all
  EngineOptions options;
  bool quiet = false;
};

Scene scene_of(const ReferenceOptions& options) {
  // The scene is written and read again, so that it goes the way of any scene.
  std::ostringstream text;
  try {
    write_scene(text, generate_reference(options));
  } catch (const std::runtime_error& refusal) {
    throw UsageError(std::string("experiment: ") + refusal.what());
  }
  return parse_scene(text.view(), "experiment");
}

void print_member(std::ostream& out, const std::string& set, const ExperimentMember& member) {
  const EngineStats& stats = member.run.stats;
  out << set << ' ' << member.k << ": n " << member.run.disks << "; flips " << stats.flip_count()
      << "; collisions " << stats.disk_collisions + stats.wall_collisions << "; t "
      << number_text(member.run.outcome.t) << std::endl;
}

ExitCode experiment(const Request& request) {
  require_distinct({}, {request.json, request.csv});
  if (!(request.scale > 0) || request.scale > 100) throw UsageError("--scale: not in (0, 100]");
  if (!(request.horizon > 0)) throw UsageError("--horizon: not positive");
  // The frequencies of events have an entry for each 10 units.
  if (request.horizon > 1e9) throw UsageError("--horizon: more than 1e9");
  const CooperativeInterruption interruption;
  OutputFile json_file(request.json);
  std::optional<OutputFile> csv_file;
  if (!request.csv.empty()) csv_file.emplace(request.csv);

  Experiment all;
  all.producer = producer();
  all.set = request.set;
  all.scale = request.scale;
  all.predictions = request.predictions == "on";
  bool stopped = false;
  int members = request.members;
  for (const PaperSet& set : paper_sets())
    if (set.name == request.set)
      members = members == 0 ? set.members : std::min(members, set.members);
  for (int k = 1; k <= members; ++k) {
    ExperimentMember member{k, paper_set_member(request.set, k, request.scale), {}};
    member.options.horizon = request.horizon;
    member.options.seed = request.seed;
    const Scene scene = scene_of(member.options);
    {
      Progress progress(request.horizon, request.quiet);
      EngineOptions options = request.options;
      options.monitor = [&](double t, std::uint64_t events) {
        progress.report(t, events);
        return !interruption.requested();
      };
      member.run = run_experiment(scene, all.predictions, std::move(options));
    }
    interruption.check();
    if (!request.quiet)
      print_member(words_beside({request.json, request.csv}), request.set, member);
    if (member.run.outcome.kind == Outcome::Kind::stopped) {
      stopped = true;
      std::cerr << "voroproof: " << request.set << ' ' << k
                << " stopped at t = " << number_text(member.run.outcome.t) << ": "
                << printable(member.run.outcome.reason, 4096) << '\n';
    }
    all.members.push_back(std::move(member));
  }
  json_file.write(experiment_json(all));
  if (csv_file) csv_file->write(experiment_csv(all));
  json_file.commit();
  if (csv_file) csv_file->commit();
  return stopped ? ExitCode::undecided : ExitCode::ok;
}

}  // namespace

void add_experiment(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("experiment", "Run an experiment of the paper's again");
  std::vector<std::string> names;
  for (const PaperSet& set : paper_sets()) names.push_back(set.name);
  verb.choice("set", names, request->set,
              "The experiment; they are those of the paper's figures 18 to 22, in this order.")
      .required();
  verb.output(request->json, "Write all results here, as JSON, for scripts/plot-experiments.py.")
      .required();
  verb.output("--csv", request->csv, "Write a table of the counts here.");
  verb.real("--scale", request->scale,
            "What the numbers of disks are multiplied by; 1 gives the paper's.");
  verb.real("--horizon", request->horizon, "The horizon of every scene.");
  verb.whole("--seed", request->seed, 0, most_whole,
             "The seed of the random numbers, the same for all members.");
  verb.whole("--members", request->members, 0, 10, "Only so many members, the first; 0: all.");
  verb.choice(
      "--predictions", {"on", "off"}, request->predictions,
      "Whether the paper's predictions are counted, which takes much longer than the runs.");
  add_computing_limits(verb, request->options);
  verb.flag("--quiet", request->quiet, "Show no progress on the terminal and no summaries.");
  verb.note("Exit code 3 where some run stopped early; the others are in the files.");
  verb.example("voroproof experiment speed -o speed.json --csv speed.csv");
  verb.does([request] { return experiment(*request); });
}

}  // namespace voroproof::internal
