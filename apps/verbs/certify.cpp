// voroproof certify: is a history that of the scene?
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <tuple>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/run/begun_certificate.h"
#include "apps/run/checkpoints.h"
#include "apps/run/limited_history.h"
#include "apps/run/second_checker.h"
#include "apps/run/told_certificate.h"
#include "apps/verbs/certify_diagram.h"
#include "apps/verbs/certify_world.h"
#include "apps/verbs/verbs.h"
#include "certify/certifier.h"
#include "history/claim.h"
#include "history/descriptor.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "history/world.h"
#include "library/certification.h"
#include "library/history_index.h"
#include "library/maneuver_input.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, report, truth = "exact", events = "all", order = "format",
                                      tolerance = "1e-6", law_tolerance = "1e-9", part, index;
  std::vector<std::string> shards;  // to be merged
  DiagramRequest diagram;
  CertifyOptions options;
  std::uint64_t max_events = 0, checkpoint = 10;
  bool quiet = false, kernel = false, proved = false, resume = false;
};

// Makes it that of a history that is not judged to its end. What it says of the files stays.
void undecide(Certificate& certificate, const std::string& reason, std::int64_t prefix_events,
              double prefix_t) {
  Certificate at_limit;  // undecided
  at_limit.reason = reason;
  at_limit.prefix_events = prefix_events;
  at_limit.prefix_t = prefix_t;
  at_limit.other_horizon = certificate.other_horizon;
  at_limit.remarks = std::move(certificate.remarks);
  certificate = std::move(at_limit);
}

// The shard as its verdict names it: "SHARD 2/8 "; empty for the whole.
std::string name_of_shard(const Request& request, const ShardFile& file) {
  if (request.part.empty()) return {};
  return "SHARD " + std::to_string(file.number) + "/" + std::to_string(file.of) + " ";
}

void read_part(const Request& request, ShardFile& file) {
  if (request.part.empty()) return;
  const auto part = part_of(request.part);
  if (!part) {
    throw UsageError("--part: not I/N with 1 <= I <= N <= " + std::to_string(most_shards));
  }
  std::tie(file.number, file.of) = *part;
}

void require_shards(const Request& request) {
  const bool is_part = !request.part.empty();
  if ((is_part || request.resume) && (request.truth != "recorded" || request.events != "all")) {
    throw UsageError(std::string(is_part ? "--part" : "--resume") +
                     ": only with --truth recorded, of all events");
  }
  if (!request.index.empty() && !is_part && !request.resume) {
    throw UsageError("--index: only with --part or --resume, which begin in the middle");
  }
  if (request.resume && (is_stream(request.report) || is_standard_output(request.report))) {
    throw UsageError("--resume: what was written into a stream cannot be taken up");
  }
}

// Whether what has been proved is kept, for a later run to take it up.
bool can_be_resumed(const Request& request) {
  return request.truth == "recorded" && request.events == "all" && !request.report.empty() &&
         !is_stream(request.report) && !is_standard_output(request.report);
}

// The certificate that an earlier run of the same shard has made already.
std::optional<ShardFile> finished_certificate(const Request& request, const Claim& claim,
                                              const ShardFile& wanted) {
  if (!request.resume || request.part.empty()) return std::nullopt;
  ShardFile whole = wanted;
  whole.shard.certificate.other_horizon = other_horizon(claim.scene, claim.history->header());
  return finished_shard(request.report, whole, request.history);
}

// Certifies the shard from where an earlier run has left it.
void certify_shard_of(const Request& request, Claim& claim, const CertifyOptions& options,
                      std::optional<BegunCertificate>& begun, ShardFile& file) {
  ShardTask task{.number = file.number, .of = file.of};
  if (request.resume) {
    if (auto left = begun->find(file)) {
      file.shard = std::move(*left);
      task.from = file.shard.end;
      if (!request.quiet) {
        std::cerr << "voroproof: takes up " << printable(begun->path(), 4096)
                  << " at t = " << number_text(task.from->t) << ", after "
                  << task.from->claims.all() << " events\n";
      }
    }
  }
  if (!request.index.empty()) {
    task.start = find_start({request.index, producer()}, claim, request.history, options, task);
  }
  const auto joined = [&](Shard next) {
    Certificate& c = next.certificate;
    c.remarks.insert(c.remarks.begin(), claim.remarks.begin(), claim.remarks.end());
    ShardFile whole = file;
    if (task.from) {
      append(whole.shard, std::move(next));
    } else {
      whole.shard = std::move(next);
    }
    return whole;
  };
  Checkpoints checkpoints(request.checkpoint);
  if (begun) {
    task.is_due = [&] { return checkpoints.due(); };
    task.proved = [&](Shard so_far) { begun->keep(joined(std::move(so_far))); };
  }
  try {
    file = joined(certify_shard(claim.scene, *claim.history, options, task));
  } catch (const OtherHistory&) {
    throw InputError(begun->path(), 0, "", "is of another history than " + request.history);
  } catch (CertificationInterrupted& at) {
    at.prefix_events += file.shard.certificate.prefix_events;
    throw;
  }
}

// Certifies the claim, or its shard; undecided at a limit: then false. Throws Interrupted.
bool certify_claim(const Request& request, Claim& claim, const CertifyOptions& options,
                   const CooperativeInterruption& interruption,
                   std::optional<BegunCertificate>& begun, ShardFile& file) {
  Certificate& certificate = file.shard.certificate;
  certificate.other_horizon = other_horizon(claim.scene, claim.history->header());
  certificate.remarks = claim.remarks;
  try {
    if (begun || !request.part.empty()) {
      certify_shard_of(request, claim, options, begun, file);
      return request.max_events == 0 || certificate.verdict != Verdict::undecided;
    }
    certificate = certify(claim.scene, *claim.history, options);
    certificate.remarks.insert(certificate.remarks.begin(), claim.remarks.begin(),
                               claim.remarks.end());
    return true;
  } catch (const CertificationInterrupted& at) {
    if (!interruption.late()) throw Interrupted();
    undecide(certificate, time_limit_reason(), at.prefix_events, at.prefix_t);
  } catch (const std::bad_alloc&) {
    if (!has_memory_limit()) throw;
    lift_memory_limit();
    undecide(certificate, memory_limit_reason(), 0, 0);
  }
  if (!request.part.empty()) throw Undecided(certificate.reason);
  return false;
}

void write_result(const Request& request, OutputFile& output, const ShardFile& file) {
  output.write(request.part.empty() ? report_text(file.run, file.options, file.shard.certificate)
                                    : shard_text(file));
  output.commit();
}

// Makes the certificate that of all checkers, undecided at a limit. Throws Interrupted.
SecondWords ask(const std::vector<SecondChecker>& seconds, const Request& request,
                const CooperativeInterruption& interruption, ShardFile& file) {
  Certificate& certificate = file.shard.certificate;
  SecondWords words;
  for (const SecondChecker& checker : seconds) {
    const std::string said = judged_by(checker, certificate, file.run, request.options,
                                       [&] { return !interruption.requested(); });
    if (said.empty()) {
      if (!interruption.late()) throw Interrupted();
      undecide(certificate,
               time_limit_reason() + " while the " + std::string(checker.name) + " judges",
               certificate.prefix_events, certificate.prefix_t);
      break;
    }
    words.emplace_back(checker, said);
    file.run.second.emplace_back(checker.field, said);
  }
  return words;
}

void read_tolerances(const Request& request, const HistoryHeader& header, CertifyOptions& options) {
  options.tolerance = time_argument("--tolerance", request.tolerance);
  options.law_tolerance = time_argument("--law-tolerance", request.law_tolerance);
  try {
    require_meaningful(options, header.horizon);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(std::string("--") + fault.what());
  }
}

ExitCode certify_files_of_world(const Request& request) {
  if (request.events != "all" || request.order != "format" || request.kernel || request.proved ||
      request.resume || !request.report.empty() || request.options.unoriented ||
      request.options.strict) {
    throw UsageError("a world is certified with --tolerance, --max-events and --quiet only");
  }
  require_order(request.scene, request.history);
  return certify_world({request.scene, request.history,
                        time_argument("--tolerance", request.tolerance), request.max_events,
                        request.quiet});
}

ExitCode certify_files(Request& request) {
  CertifyOptions& options = request.options;
  options.truth = request.truth == "exact" ? Truth::exact : Truth::recorded;
  options.events = request.events == "all" ? EventKinds::all : EventKinds::collisions;
  options.any_order = request.order == "any";
  options.measures_times = !request.report.empty();
  const std::vector<SecondChecker> seconds =
      second_checkers(request.kernel, request.proved, options, request.part.empty());
  require_shards(request);
  ShardFile file;
  read_part(request, file);
  std::optional<BegunCertificate> begun;
  if (can_be_resumed(request)) begun.emplace(request.report);
  require_distinct({request.scene, request.history, request.index},
                   {request.report, begun ? begun->path() : std::string()});
  if (begun) begun->require_replaceable();
  require_order(request.scene, request.history);
  CooperativeInterruption interruption;
  std::optional<OutputFile> report_file;
  if (!request.report.empty()) report_file.emplace(request.report);
  Claim claim = open_claim(request.scene, request.history);
  if (request.max_events > 0) {
    claim.history = std::make_unique<LimitedHistory>(std::move(claim.history), request.max_events,
                                                     event_limit_reason(request.max_events));
  }
  const HistoryHeader& header = claim.history->header();
  read_tolerances(request, header, options);
  options.propose_initial = construct_initial;
  file.options = options;
  file.run = certification_run(producer(), request.scene, request.history, claim, {});
  if (const auto done = finished_certificate(request, claim, file)) {
    tell(words_beside({request.report}), *done, {}, name_of_shard(request, *done), request.quiet);
    return exit_code(done->shard.certificate.verdict);
  }
  const bool hashed = report_file || !seconds.empty();
  if (hashed) claim.history->keep_digest();
  std::optional<Progress> progress;
  progress.emplace(round_nearest(header.horizon), request.quiet);
  options.monitor = [&](double t, std::int64_t events) {
    progress->report(t, static_cast<std::uint64_t>(events));
    return !interruption.requested();
  };
  const bool judged = certify_claim(request, claim, options, interruption, begun, file);
  progress.reset();
  claim.history->require_unchanged();
  Certificate& certificate = file.shard.certificate;
  if (hashed && !file.shard.end) file.run.history_sha256 = claim.history->content_sha256();
  const SecondWords second = ask(seconds, request, interruption, file);
  interruption.wind_up();
  file.run.evidence = checked_evidence(certificate, request.scene, request.history);
  if (report_file) write_result(request, *report_file, file);
  // Where a limit has ended the run, or that of a second checker, it may be taken up.
  if (begun && judged && second.size() == seconds.size()) begun->forget();
  tell(words_beside({request.report}), file, second, name_of_shard(request, file), request.quiet);
  return exit_code(certificate.verdict);
}

// The report and the verdict of the whole from the certificates of its shards.
ExitCode merge_files(Request& request) {
  require_distinct(request.shards, {request.report});
  std::optional<OutputFile> report_file;
  if (!request.report.empty()) report_file.emplace(request.report);
  ShardFile whole = merge_shards(request.shards);
  if (whole.run.producer != producer()) {
    throw InputError(request.shards.front(), 0, "report.producer",
                     "is of " + printable(whole.run.producer) + ", and this is " + producer());
  }
  for (const auto& [path, sha256] : {std::pair(whole.run.scene_file, whole.run.scene_sha256),
                                     std::pair(whole.run.history_file, whole.run.history_sha256)}) {
    if (has_other_bytes(path, sha256)) {
      throw InputError(path, 0, "", "has other bytes than those of which the certificates are");
    }
  }
  const Certificate& certificate = whole.shard.certificate;
  whole.run.evidence = checked_evidence(certificate, whole.run.scene_file, whole.run.history_file);
  if (report_file) write_result(request, *report_file, whole);
  tell(words_beside({request.report}), whole, {}, {}, request.quiet);
  return exit_code(certificate.verdict);
}

}  // namespace

void add_certify(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("certify", "Prove or refute a history of a scene");
  verb.input("scene", request->scene, "The scene.")
      .required_unless("--merge")
      .required_unless("--diagram");
  verb.input("history", request->history, "The history, whoever wrote it.")
      .required_unless("--merge")
      .required_unless("--diagram");
  verb.choice(
      "--truth", {"exact", "recorded"}, request->truth,
      "Which motion the history must describe: the true motion of the scene, or the one that "
      "the history's own collision times and velocities define (for long floating-point "
      "runs).");
  verb.choice("--events", {"all", "collisions"}, request->events,
              "What to judge: all events, or collisions and maneuvers alone, of a program that "
              "knows no flips. Flips and the initial diagram are passed over then.");
  verb.choice("--order", {"format", "any"}, request->order,
              "Exact truth: the order of what one instant turns, as docs/formats.md has it, or any "
              "in which every collision is of two that touch and approach (not with --strict).");
  verb.text("--tolerance", request->tolerance, "TIME",
            "How far a claimed time may be from the exact one; at most the horizon, or 1e-6 where "
            "the horizon is less.");
  verb.text("--law-tolerance", request->law_tolerance, "RATIO",
            "How far claimed velocities may be off, relative to the speeds that meet; at most 1.");
  verb.flag("--strict", request->options.strict,
            "Refute claims that are out of order, however near they are, quadruplets without "
            "orientation, and a horizon other than the scene's.");
  verb.flag("--unoriented", request->options.unoriented,
            "Accept quadruplets whose third generators are exchanged, as in .evtsq files.");
  verb.flag(
      "--kernel", request->kernel,
      "Have the kernel (docs/kernel.md) judge the files, too: both must certify the history.");
  verb.flag("--proved", request->proved,
            "Have the proved checker (the program voroproof-proved, docs/proved.md) judge the "
            "files, too, under the recorded truth: both must certify the history.");
  verb.whole("--threads", request->options.threads, 1, 1024,
             "The number of threads for the recorded truth, and for the initial diagram of both "
             "truths. The certificate is the same.");
  verb.output("--report", request->report, "Write everything that was found here, as JSON.");
  verb.text("--part", request->part, "I/N",
            "Certify the I-th of N shards of a history, under the recorded truth, and write its "
            "certificate as the report.")
      .needs("--report");
  verb.input(
          "--index", request->index,
          "An index of the history (voroproof index): a shard, or what --resume takes up, is read "
          "from the last place before it that the index names. Nothing in it is believed: --merge "
          "refuses shards that do not fit together.")
      .excludes({"--max-events"});
  verb.inputs("--merge", request->shards,
              "Join the certificates of all shards of a history to the verdict and the report of "
              "the whole.")
      .with_all_that_follow()
      .excludes({"--truth", "--events", "--order", "--tolerance", "--law-tolerance", "--strict",
                 "--unoriented", "--kernel", "--proved", "--threads", "--part", "--index",
                 "--resume", "--checkpoint", "--max-bits", "--max-events"});
  add_diagram_options(verb, request->diagram);
  verb.flag("--resume", request->resume,
            "Take up what a run that was interrupted or killed, or that a limit ended, has left "
            "beside this report; the report is the same as without the break. With --part, nothing "
            "is done where the report is that of this shard already: of these bytes, these options "
            "and this version.")
      .needs("--report");
  verb.whole("--checkpoint", request->checkpoint, 0, 1'000'000,
             "Under the recorded truth, keep what is proved every so many seconds in a file of the "
             "report's name with .partial at its end; 0: as often as can be.");
  add_max_bits(verb, request->options.motion.max_bits);
  add_max_events(verb, request->max_events);
  verb.flag("--quiet", request->quiet,
            "Show no progress on the terminal, and write nothing but the verdict, what it is about "
            "and what it leaves open.");
  verb.note(
      "What s CERTIFIED says is stated in docs/claim.md. The last line of the output is s "
      "CERTIFIED (exit code 0), s REFUTED (1), s INVALID (2) or s UNDECIDED (3).");
  verb.example("voroproof certify a.scene.json a.history.jsonl --truth recorded --report r.json");
  verb.does([request] {
    try {
      if (!request->diagram.files.empty()) {
        request->diagram.threads = request->options.threads;
        request->diagram.quiet = request->quiet;
        return certify_diagram_files(request->diagram);
      }
      if (!request->shards.empty()) return merge_files(*request);
      return is_world_file(request->scene) ? certify_files_of_world(*request)
                                           : certify_files(*request);
    } catch (const InputError& error) {
      std::cerr << "voroproof: " << printable(error.what(), 4096) << '\n';
    } catch (const UsageError& error) {
      std::cerr << "voroproof: " << error.what() << '\n';
      return ExitCode::bad_input;
    }
    words_beside({request->report}) << "s INVALID\n";
    return ExitCode::bad_input;
  });
}

}  // namespace voroproof::internal
