// voroproof certify: is a history that of the scene?
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/run/kernel_verdict.h"
#include "apps/run/limited_history.h"
#include "apps/verbs/list.h"
#include "apps/verbs/verbs.h"
#include "certify/certifier.h"
#include "history/claim.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/json_text.h"
#include "library/certification.h"
#include "library/maneuver_input.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, report, truth = "exact", events = "all", tolerance = "1e-6",
                                      law_tolerance = "1e-9";
  CertifyOptions options;
  std::uint64_t max_events = 0;
  bool quiet = false, kernel = false;
};

ExitCode exit_code(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return ExitCode::ok;
    case Verdict::refuted:
      return ExitCode::refuted;
    case Verdict::undecided:
      break;
  }
  return ExitCode::undecided;
}

// The certificate of a history that a limit of the user's does not let be judged to its end.
Certificate undecided(const std::string& reason, std::int64_t prefix_events, double prefix_t) {
  Certificate certificate;
  certificate.verdict = Verdict::undecided;
  certificate.reason = reason;
  certificate.prefix_events = prefix_events;
  certificate.prefix_t = prefix_t;
  return certificate;
}

// Says what was found, the verdict last, and the reason of a verdict other than
// CERTIFIED to stderr.
void tell(const Request& request, const Certificate& certificate, const std::string& kernel,
          const std::string& evidence) {
  if (certificate.verdict != Verdict::certified) {
    std::cerr << "voroproof: " << printable(request.history, 4096) << ": "
              << printable(reason_line(certificate), 4096) << '\n';
  }
  std::ostream& out = words_beside({request.report});
  if (!request.quiet) {
    out << "c ";
    if (request.options.judges_flips()) out << certificate.flips << " flips, ";
    out << certificate.collisions << " collisions, " << certificate.maneuvers
        << " maneuvers proved; certified prefix " << certificate.prefix_events
        << " events, t = " << certificate.prefix_t << "; swaps " << certificate.swaps << '\n';
    for (const Leniency& l : leniencies(certificate)) {
      if (l.count > 0) out << "c leniency: " << l.count << " " << l.words << '\n';
    }
    for (const std::string& remark : certificate.remarks)
      out << "c " << printable(remark, 4096) << '\n';
    if (!kernel.empty()) out << "c kernel: " << printable(kernel, 4096) << '\n';
    if (!evidence.empty()) out << "c evidence: " << evidence << '\n';
  }
  if (const std::string line = horizon_line(certificate); !line.empty()) {
    out << "c " << line << '\n';
  }
  if (const std::string line = scope_line(request.options, certificate); !line.empty()) {
    out << "c " << line << '\n';
  }
  out << verdict_line(certificate.verdict) << '\n';
}

// The certificate of the claim, undecided where a limit is reached. Throws Interrupted.
Certificate certify_claim(Claim& claim, const CertifyOptions& options,
                          const CooperativeInterruption& interruption) {
  try {
    Certificate certificate = certify(claim.scene, *claim.history, options);
    certificate.remarks.insert(certificate.remarks.begin(), claim.remarks.begin(),
                               claim.remarks.end());
    return certificate;
  } catch (const CertificationInterrupted& at) {
    if (!interruption.late()) throw Interrupted();
    return undecided(time_limit_reason(), at.prefix_events, at.prefix_t);
  } catch (const std::bad_alloc&) {
    if (!has_memory_limit()) throw;
    lift_memory_limit();
    return undecided(memory_limit_reason(), 0, 0);
  }
}

ExitCode certify_files(Request& request) {
  if (request.kernel && request.events != "all") {
    throw UsageError("--kernel: the kernel judges all events (--events all)");
  }
  require_distinct({request.scene, request.history}, {request.report});
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
  CertifyOptions& options = request.options;
  options.truth = request.truth == "exact" ? Truth::exact : Truth::recorded;
  options.events = request.events == "all" ? EventKinds::all : EventKinds::collisions;
  options.tolerance = time_argument("--tolerance", request.tolerance);
  options.law_tolerance = time_argument("--law-tolerance", request.law_tolerance);
  try {
    require_meaningful(options, header);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(std::string("--") + fault.what());
  }
  options.propose_initial = construct_initial;
  std::optional<Progress> progress;
  progress.emplace(round_nearest(header.horizon), request.quiet);
  options.monitor = [&](double t, std::int64_t events) {
    progress->report(t, static_cast<std::uint64_t>(events));
    return !interruption.requested();
  };
  Certificate certificate = certify_claim(claim, options, interruption);
  progress.reset();
  std::string kernel;
  if (request.kernel) {
    kernel = judged_by_kernel(certificate, request.scene, request.history, options,
                              [&] { return !interruption.requested(); });
    if (kernel.empty()) {
      if (!interruption.late()) throw Interrupted();
      certificate = undecided(time_limit_reason() + " while the kernel judges",
                              certificate.prefix_events, certificate.prefix_t);
    }
  }
  interruption.wind_up();
  const std::string evidence = checked_evidence(certificate, request.scene, request.history);
  if (report_file) {
    CertificationRun run =
        certification_run(producer(), request.scene, request.history, claim, evidence);
    run.kernel = kernel;
    report_file->write(report_text(run, options, certificate));
    report_file->commit();
  }
  tell(request, certificate, kernel, evidence);
  return exit_code(certificate.verdict);
}

// What the report of a run says of how far the history is proved.
void read_report(const std::string& path, RunRow& row) {
  const nlohmann::json report = nlohmann::json::parse(file_bytes(path, std::size_t{1} << 28));
  row.events = report.at("certified_prefix").at("events").get<std::int64_t>();
  row.t = report.at("certified_prefix").at("t").get<double>();
}

const ListedVerb listed_certify{.name = "certify",
                                .arguments =
                                    [](const ListedRun& run, const std::string& report) {
                                      return std::vector<std::string>{
                                          "certify", "--report", report,     "--quiet",
                                          "--",      run.scene,  run.history};
                                    },
                                .read = read_report};

}  // namespace

void add_certify(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("certify", "Prove or refute a history of a scene");
  verb.input("scene", request->scene, "The scene.").required_unless("--list");
  verb.input("history", request->history, "The history, whoever wrote it.")
      .required_unless("--list");
  verb.choice(
      "--truth", {"exact", "recorded"}, request->truth,
      "Which motion the history must describe: the true motion of the scene, or the one that "
      "the history's own collision times and velocities define (for long floating-point "
      "runs).");
  verb.choice("--events", {"all", "collisions"}, request->events,
              "What to judge: all events, or collisions and maneuvers alone, of a program that "
              "knows no flips. Flips and the initial diagram are passed over then.");
  verb.text("--tolerance", request->tolerance, "TIME",
            "How far a claimed time may be from the exact one; at most the horizon, or 1e-6 where "
            "the horizon is less.");
  verb.text(
      "--law-tolerance", request->law_tolerance, "RATIO",
      "How far claimed velocities may be from the law's, relative to the speeds that meet; at "
      "most 1.");
  verb.flag("--strict", request->options.strict,
            "Refute claims that are out of order, however near they are, quadruplets without "
            "orientation, and a horizon other than the scene's.");
  verb.flag("--unoriented", request->options.unoriented,
            "Accept quadruplets whose third generators are exchanged, as in .evtsq files.");
  verb.flag(
      "--kernel", request->kernel,
      "Have the kernel (docs/kernel.md) judge the files, too. The history is certified only if "
      "both certify it.");
  verb.whole("--threads", request->options.threads, 1, 1024,
             "The number of threads for the recorded truth. The certificate is the same.");
  verb.output("--report", request->report, "Write everything that was found here, as JSON.");
  add_max_bits(verb, request->options.motion.max_bits);
  add_max_events(verb, request->max_events);
  verb.flag("--quiet", request->quiet,
            "Show no progress on the terminal, and write nothing but the verdict.");
  const auto list = add_list_options(verb, {"--report"});
  verb.note("What s CERTIFIED says is stated in docs/claim.md.")
      .note(
          "The last line of the output is s CERTIFIED (exit code 0), s REFUTED (1), s INVALID (2) "
          "or s UNDECIDED (3).");
  verb.example("voroproof certify a.scene.json a.history.jsonl --truth recorded --report r.json");
  verb.does([request, list, &verb] {
    if (!list->list.empty()) return run_listed(verb, *list, listed_certify);
    try {
      return certify_files(*request);
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
