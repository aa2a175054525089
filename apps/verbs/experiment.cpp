// voroproof experiment: the paper's experiments (section 7) again.
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <iostream>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/paper/experiment_report.h"
#include "apps/run/partial_file.h"
#include "apps/verbs/verbs.h"
#include "corpus/paper_sets.h"
#include "history/descriptor.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/output_file.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

struct Request {
  std::string set, json, csv, predictions = "on";
  double scale = 0.1, horizon = 1000;
  std::uint64_t seed = 1, seeds = 1;
  int members = 0;  // 0: all
  std::size_t threads = 1;
  EngineOptions options;
  bool quiet = false, resume = false;
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

// The scenes of the experiment, in the order of the files.
std::vector<ReferenceOptions> scenes_of(const Request& request, std::vector<int>& numbers) {
  int members = 0;
  for (const PaperSet& set : paper_sets()) {
    if (set.name == request.set) members = set.members;
  }
  if (request.members > 0) members = std::min(members, request.members);
  std::vector<ReferenceOptions> scenes;
  for (int k = 1; k <= members; ++k) {
    for (std::uint64_t n = 0; n < request.seeds; ++n) {
      ReferenceOptions options = paper_set_member(request.set, k, request.scale);
      options.horizon = request.horizon;
      options.seed = request.seed + n;
      scenes.push_back(options);
      numbers.push_back(k);
    }
  }
  return scenes;
}

// How far all runs have come together, which several threads tell.
class SharedProgress {
 public:
  SharedProgress(double horizon, std::size_t runs, bool quiet)
      : progress_(horizon * static_cast<double>(runs), quiet), reached_(runs), events_(runs) {}

  void report(std::size_t run, double t, std::uint64_t events) {
    const std::lock_guard lock(mutex_);
    t_ += t - std::exchange(reached_[run], t);
    all_events_ += events - std::exchange(events_[run], events);
    progress_.report(t_, all_events_);
  }

 private:
  std::mutex mutex_;
  Progress progress_;
  std::vector<double> reached_;
  std::vector<std::uint64_t> events_;
  double t_ = 0;
  std::uint64_t all_events_ = 0;
};

bool is_complete(const Json& member) {
  return member.at("outcome") == name_of(Outcome::Kind::complete);
}

// The runs of one experiment, several at a time. Those that are complete are kept in a file beside
// the result until this is written: what they say depends on no limit.
class Runs {
 public:
  explicit Runs(const Request& request)
      : request_(request),
        scenes_(scenes_of(request, numbers_)),
        results_(scenes_.size()),
        progress_(request.horizon, scenes_.size(), request.quiet) {
    if (!is_stream(request.json) && !is_standard_output(request.json)) {
      partial_.emplace(request.json, "voroproof-experiment");
      partial_->require_replaceable("--output");
    }
  }

  // The runs that an earlier one of this experiment has left. Throws InputError where the file is
  // of another.
  void take_up() {
    if (!partial_->is_there()) return;
    const Experiment left = read_experiment(partial_->path());
    const auto require = [&](bool same, const char* what) {
      if (same) return;
      throw InputError(partial_->path(), 0, "",
                       std::string("is of another ") + what + " than the run asked for");
    };
    require(left.producer == producer(), "version of the program");
    require(left.set == request_.set, "set");
    require(left.scale == request_.scale, "scale");
    for (const Json& member : left.members) {
      require(member.at("horizon") == request_.horizon, "horizon");
      require(member.contains("predicted") == predictions(), "choice of predictions");
      for (std::size_t n = 0; n < scenes_.size(); ++n) {
        if (member.at("k") == numbers_[n] && member.at("seed") == scenes_[n].seed) {
          results_[n] = member;
        }
      }
    }
  }

  // Throws Interrupted or Undecided.
  void run(const CooperativeInterruption& interruption) {
    namespace tbb = oneapi::tbb;
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                      request_.threads);
    tbb::task_arena arena(static_cast<int>(request_.threads));
    std::size_t next = 0;
    arena.execute([&] {
      tbb::parallel_pipeline(
          request_.threads,
          tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                              [&](tbb::flow_control& flow) {
                                                if (next == scenes_.size()) flow.stop();
                                                return next++;
                                              }) &
              tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel,
                                                         [&](std::size_t n) {
                                                           if (!results_[n]) run(n, interruption);
                                                           return n;
                                                         }) &
              tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order,
                                                  [&](std::size_t n) { tell(n); }));
    });
  }

  // Those that have ended.
  Experiment experiment(bool complete_ones_only) const {
    Experiment all{producer(), request_.set, request_.scale, {}};
    for (const std::optional<Json>& result : results_) {
      if (result && (!complete_ones_only || is_complete(*result))) all.members.push_back(*result);
    }
    return all;
  }

  bool all_complete() const {
    return std::all_of(results_.begin(), results_.end(),
                       [](const auto& result) { return is_complete(*result); });
  }
  void forget() const {
    if (partial_) partial_->forget();
  }

 private:
  bool predictions() const { return request_.predictions == "on"; }

  void run(std::size_t n, const CooperativeInterruption& interruption) {
    EngineOptions options = request_.options;
    options.monitor = [&](double t, std::uint64_t events) {
      progress_.report(n, t, events);
      return !interruption.requested();
    };
    const ExperimentMember member{
        numbers_[n], scenes_[n],
        run_experiment(scene_of(scenes_[n]), predictions(), std::move(options))};
    interruption.check();
    const std::lock_guard lock(mutex_);
    results_[n] = member_json(member, predictions());
    if (partial_ && is_complete(*results_[n])) partial_->keep(experiment_json(experiment(true)));
  }

  // The summary of a run, and why it stopped.
  void tell(std::size_t n) {
    const std::lock_guard lock(mutex_);
    const Json& member = *results_[n];
    std::string name = request_.set + ' ' + std::to_string(numbers_[n]);
    if (request_.seeds > 1) name += ", seed " + std::to_string(scenes_[n].seed);
    const std::string t = number_text(member.at("t").get<double>());
    if (!request_.quiet) {
      const Json& collisions = member.at("collisions");
      words_beside({request_.json, request_.csv})
          << name << ": n " << member.at("n") << "; flips " << member.at("flips") << "; collisions "
          << collisions.at("disks").get<std::uint64_t>() +
                 collisions.at("container").get<std::uint64_t>()
          << "; t " << t << std::endl;
    }
    if (member.at("outcome") == name_of(Outcome::Kind::stopped)) {
      std::cerr << "voroproof: " << name << " stopped at t = " << t << ": "
                << printable(member.at("reason").get<std::string>(), 4096) << '\n';
    }
  }

  const Request& request_;
  std::vector<int> numbers_;
  std::vector<ReferenceOptions> scenes_;
  std::vector<std::optional<Json>> results_;
  SharedProgress progress_;
  std::optional<PartialFile> partial_;
  std::mutex mutex_;  // guards results_ and what is told
};

ExitCode experiment(const Request& request) {
  if (!(request.scale > 0) || request.scale > 100) throw UsageError("--scale: not in (0, 100]");
  if (!(request.horizon > 0)) throw UsageError("--horizon: not positive");
  // The frequencies of events have an entry for each 10 units.
  if (request.horizon > 1e9) throw UsageError("--horizon: more than 1e9");
  if (request.seed > most_whole - request.seeds) throw UsageError("--seed: too large");
  if (request.resume && (is_stream(request.json) || is_standard_output(request.json))) {
    throw UsageError("--resume: what was written into a stream cannot be taken up");
  }
  require_distinct({}, {request.json, request.csv});
  const CooperativeInterruption interruption;
  Runs runs(request);
  if (request.resume) runs.take_up();
  OutputFile json_file(request.json);
  std::optional<OutputFile> csv_file;
  if (!request.csv.empty()) csv_file.emplace(request.csv);
  runs.run(interruption);
  const Experiment all = runs.experiment(false);
  json_file.write(experiment_json(all));
  if (csv_file) csv_file->write(experiment_csv(all));
  json_file.commit();
  if (csv_file) csv_file->commit();
  if (!runs.all_complete()) return ExitCode::undecided;
  runs.forget();
  return ExitCode::ok;
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
  verb.whole("--seeds", request->seeds, 1, 1000,
             "Run every member for so many seeds, from --seed on.");
  verb.whole("--members", request->members, 0, 10, "Only so many members, the first; 0: all.");
  verb.choice(
      "--predictions", {"on", "off"}, request->predictions,
      "Whether the paper's predictions are counted, which takes much longer than the runs.");
  verb.whole("--threads", request->threads, 1, 1024,
             "So many runs side by side. What is counted is the same; the seconds are those of a "
             "machine that does other work.");
  verb.flag("--resume", request->resume,
            "Take over the runs that an experiment which was interrupted or killed, or which a "
            "limit ended, has left in FILE.partial.");
  add_computing_limits(verb, request->options);
  verb.flag("--quiet", request->quiet, "Show no progress on the terminal and no summaries.");
  verb.note("Exit code 3 where some run stopped early; the others are in the files.");
  verb.example("voroproof experiment speed -o speed.json --csv speed.csv");
  verb.example("voroproof experiment density --scale 1 --seeds 5 --threads 8 -o density.json");
  verb.does([request] { return experiment(*request); });
}

}  // namespace voroproof::internal
