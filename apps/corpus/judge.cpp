#include "apps/corpus/judge.h"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "history/error.h"
#include "history/file_bytes.h"
#include "library/certification.h"
#include "library/maneuver_input.h"

namespace voroproof::internal {
namespace {

// How the certifying process ends: with a report in the file, with a message there, or without.
constexpr int reported = 0, refused = 2, out_of_memory = 5;
constexpr std::size_t longest_reason = 600;
constexpr std::size_t max_report_bytes = std::size_t{1} << 28;

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

int certify_into(const std::string& scene, const std::string& history, Truth truth,
                 EventKinds events, const std::string& report) {
  try {
    const Claim claim = open_claim(scene, history);
    CertifyOptions options;
    options.truth = truth;
    options.events = events;
    options.propose_initial = construct_initial;
    const Certificate certificate = certify(claim.scene, *claim.history, options);
    claim.history->require_unchanged();
    const std::string evidence = checked_evidence(certificate, scene, history);
    write_text(report, report_text(certification_run("", scene, history, claim, evidence), options,
                                   certificate));
    return reported;
  } catch (const InputError& error) {
    // The name of the file is left out: it is a scratch file's.
    const std::string line =
        error.line() > 0 ? "line " + std::to_string(error.line()) + ": " : std::string();
    const std::string field = error.field().empty() ? std::string() : error.field() + ": ";
    write_text(report, line + field + error.reason());
    return refused;
  } catch (const std::bad_alloc&) {
    return out_of_memory;
  }
}

CaseJudgement from_report(const std::string& path) {
  using Json = nlohmann::json;
  const Json report = Json::parse(file_bytes(path, max_report_bytes));
  CaseJudgement j;
  const std::string verdict = report.at("verdict");
  j.verdict = verdict == "CERTIFIED" ? CaseJudgement::Verdict::certified
              : verdict == "REFUTED" ? CaseJudgement::Verdict::refuted
                                     : CaseJudgement::Verdict::undecided;
  j.reason = printable(report.at("reason").get<std::string>(), longest_reason);
  const std::string other = report.at("leniency").at("other_horizon");
  if (j.verdict == CaseJudgement::Verdict::certified && !other.empty()) {
    j.verdict = CaseJudgement::Verdict::undecided;
    j.reason = other;
  }
  j.prefix_events = report.at("certified_prefix").at("events");
  j.prefix_t = report.at("certified_prefix").at("t");
  if (const auto divergence = report.find("divergence"); divergence != report.end()) {
    j.kind = divergence->at("kind");
    j.line = divergence->at("line");
    j.t = divergence->at("t");
  }
  return j;
}

CaseJudgement judgement_of(const ProcessEnd& end, const std::string& report) {
  if (end.success()) return from_report(report);
  CaseJudgement j;
  if (end.kind == ProcessEnd::Kind::exited && end.code == refused) {
    j.verdict = CaseJudgement::Verdict::invalid;
    j.reason = printable(file_bytes(report, longest_reason, true), longest_reason);
  } else if (end.kind == ProcessEnd::Kind::exited && end.code == out_of_memory) {
    j.reason = "the certifier ran out of memory";
  } else {
    j.reason = "the certifier did not finish: " + description(end);
  }
  return j;
}

}  // namespace

std::string_view name_of(CaseJudgement::Verdict verdict) {
  static constexpr std::array<std::string_view, 4> names{"certified", "refuted", "undecided",
                                                         "invalid"};
  return names[static_cast<std::size_t>(verdict)];
}

ProcessStep judging(const std::string& scene, const std::string& history, Truth truth,
                    EventKinds events, const std::string& report, const ProcessLimits& limits,
                    std::function<void(const CaseJudgement&)> on_judgement) {
  return {.work = [=] { return certify_into(scene, history, truth, events, report); },
          .limits = limits,
          .on_end =
              [report, on_judgement = std::move(on_judgement)](const ProcessEnd& end) {
                CaseJudgement j = judgement_of(end, report);
                j.seconds = end.seconds;
                on_judgement(j);
              }};
}

}  // namespace voroproof::internal
