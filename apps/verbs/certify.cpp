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
#include "apps/run/least_tolerances.h"
#include "apps/run/limited_history.h"
#include "apps/run/second_words.h"
#include "apps/run/told_certificate.h"
#include "apps/verbs/certify_billiard.h"
#include "apps/verbs/certify_request.h"
#include "apps/verbs/certify_world.h"
#include "apps/verbs/verbs.h"
#include "certify/certifier.h"
#include "history/billiard.h"
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

// The shard as its verdict names it: "SHARD 2/8 "; empty for the whole.
std::string name_of_shard(const CertifyRequest& request, const ShardFile& file) {
  if (request.part.empty()) return {};
  return "SHARD " + std::to_string(file.number) + "/" + std::to_string(file.of) + " ";
}

void read_part(const CertifyRequest& request, ShardFile& file) {
  if (request.part.empty()) return;
  const auto part = part_of(request.part);
  if (!part) {
    throw UsageError("--part: not I/N with 1 <= I <= N <= " + std::to_string(most_shards));
  }
  std::tie(file.number, file.of) = *part;
}

void require_shards(const CertifyRequest& request) {
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
bool can_be_resumed(const CertifyRequest& request) {
  return request.truth == "recorded" && request.events == "all" && !request.report.empty() &&
         !is_stream(request.report) && !is_standard_output(request.report);
}

// The certificate that an earlier run of the same shard has made already.
std::optional<ShardFile> finished_certificate(const CertifyRequest& request, const Claim& claim,
                                              const ShardFile& wanted) {
  if (!request.resume || request.part.empty()) return std::nullopt;
  ShardFile whole = wanted;
  whole.shard.certificate.other_horizon =
      other_horizon(claim.scene.horizon, claim.history->header());
  return finished_shard(request.report, whole, request.history);
}

// Certifies the shard from where an earlier run has left it.
void certify_shard_of(const CertifyRequest& request, Claim& claim, const CertifyOptions& options,
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
bool certify_claim(const CertifyRequest& request, Claim& claim, const CertifyOptions& options,
                   const CooperativeInterruption& interruption,
                   std::optional<BegunCertificate>& begun, ShardFile& file) {
  Certificate& certificate = file.shard.certificate;
  certificate.other_horizon = other_horizon(claim.scene.horizon, claim.history->header());
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

void write_result(const CertifyRequest& request, OutputFile& output, const ShardFile& file) {
  output.write(request.part.empty() ? report_text(file.run, file.options, file.shard.certificate)
                                    : shard_text(file));
  output.commit();
}

// The least tolerances are found by reading the history several times.
void require_whole_file(const CertifyRequest& request) {
  if (request.least_tolerances && (is_stream(request.history) || request.max_events > 0))
    throw UsageError("--least-tolerances: only of a whole file, which is read several times");
}

// Scenes of version 2 are certified whole, in their own ways.
void require_plain(const CertifyRequest& request, const std::string& known) {
  if (request.order != "format" || request.proved || request.resume || !request.part.empty() ||
      !request.index.empty() || request.options.unoriented || request.options.strict) {
    throw UsageError(known + " only");
  }
  require_order(request.scene, request.history);
}

ExitCode certify_files_of_world(const CertifyRequest& request) {
  const std::string known = "a world is certified with --tolerance, --max-events and --quiet";
  require_plain(request, known);
  if (request.events != "all" || !request.report.empty() || request.least_tolerances ||
      request.kernel)
    throw UsageError(known + " only");
  return certify_world(request);
}

ExitCode certify_files_of_billiard(const CertifyRequest& request) {
  const std::string known =
      "a billiard is certified with --truth, --events, --tolerance, --law-tolerance, --max-bits, "
      "--max-events, --threads, --report, --least-tolerances, --kernel and --quiet";
  require_plain(request, known);
  return certify_billiard(request);
}

// The certificate of the same bytes under other options.
Certificate judge_anew(const CertifyRequest& request, const CertificationRun& run,
                       const CertifyOptions& options) {
  Claim claim = open_claim(request.scene, request.history);
  claim.history->keep_digest();
  Certificate certificate = certify(claim.scene, *claim.history, options);
  claim.history->require_unchanged();
  if (claim.scene.sha256 != run.scene_sha256 ||
      claim.history->content_sha256() != run.history_sha256)
    throw InputError(request.history, 0, "", "changes while it is read");
  return certificate;
}

ExitCode certify_files(CertifyRequest& request) {
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
  read_tolerances(request, header.horizon, options);
  options.propose_initial = construct_initial;
  file.options = options;
  file.run = certification_run(producer(), request.scene, request.history, claim, {});
  if (const auto done = finished_certificate(request, claim, file)) {
    tell(words_beside({request.report}), *done, {}, name_of_shard(request, *done), request.quiet);
    return exit_code(done->shard.certificate.verdict);
  }
  const bool hashed = report_file || !seconds.empty() || request.least_tolerances;
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
  if (request.least_tolerances && judged) {
    add_least_tolerances(file, interruption, [&](const CertifyOptions& other) {
      return judge_anew(request, file.run, other);
    });
  }
  const SecondWords second = second_words(seconds, options, interruption, file);
  interruption.wind_up();
  file.run.evidence = checked_evidence(certificate, request.scene, request.history);
  if (report_file) write_result(request, *report_file, file);
  // Where a limit has ended the run, or that of a second checker, it may be taken up.
  if (begun && judged && second.size() == seconds.size()) begun->forget();
  tell(words_beside({request.report}), file, second, name_of_shard(request, file), request.quiet);
  return exit_code(certificate.verdict);
}

// The report and the verdict of the whole from the certificates of its shards.
ExitCode merge_files(CertifyRequest& request) {
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
  auto request = std::make_shared<CertifyRequest>();
  Verb& verb = add_certify_options(program, request);
  verb.does([request] {
    try {
      if (!request->diagram.files.empty()) {
        request->diagram.threads = request->options.threads;
        request->diagram.quiet = request->quiet;
        return certify_diagram_files(request->diagram);
      }
      if (!request->shards.empty()) return merge_files(*request);
      require_whole_file(*request);
      if (is_billiard_file(request->scene)) return certify_files_of_billiard(*request);
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
