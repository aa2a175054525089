#include "voroproof/certify.h"

#include <utility>

#include "certify/billiards/billiard_certifier.h"
#include "certify/certifier.h"
#include "certify/recorded_certifier.h"
#include "certify/report.h"
#include "history/claim.h"
#include "library/billiard_values.h"
#include "library/certification.h"
#include "library/explanation.h"
#include "library/values.h"
#include "voroproof/version.h"

namespace voroproof {
namespace internal {
namespace {

voroproof::Verdict verdict_value(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return voroproof::Verdict::certified;
    case Verdict::refuted:
      return voroproof::Verdict::refuted;
    case Verdict::undecided:
      break;
  }
  return voroproof::Verdict::undecided;
}

CertifyOptions options_of(const voroproof::CertifyOptions& asked) {
  if (asked.threads < 1) throw std::invalid_argument("threads: less than 1");
  CertifyOptions options;
  options.truth = asked.truth == voroproof::Truth::recorded ? Truth::recorded : Truth::exact;
  options.events =
      asked.events == voroproof::EventKinds::collisions ? EventKinds::collisions : EventKinds::all;
  options.tolerance = rational(asked.tolerance);
  options.law_tolerance = rational(asked.law_tolerance);
  if (options.tolerance < 0) throw std::invalid_argument("tolerance: negative");
  if (options.law_tolerance < 0) throw std::invalid_argument("law-tolerance: negative");
  options.strict = asked.strict;
  options.any_order = asked.any_order;
  options.threads = asked.threads;
  options.motion = motion_options(asked.max_bits);
  options.propose_initial = construct_initial;
  options.monitor = asked.monitor;
  return options;
}

voroproof::Divergence divergence_value(const Divergence& d) {
  voroproof::Divergence out;
  out.fault = fault_names[static_cast<std::size_t>(d.fault)];
  out.line = d.line;
  out.t = d.t;
  out.truth = d.truth;
  if (d.true_flip) out.edge = edge_value(*d.true_flip);
  if (d.true_contact) out.pair = {d.true_contact->first, d.true_contact->second};
  out.witness = witness_value(d.witness);
  return out;
}

voroproof::Report report_value(CertificationRun run, const CertifyOptions& options,
                               const Certificate& c) {
  voroproof::Report out;
  out.evidence = run.evidence = checked_evidence(c, run.scene_file, run.history_file);
  out.verdict = verdict_value(c.verdict);
  out.reason = reason_line(c);
  if (c.divergence) out.divergence = divergence_value(*c.divergence);
  out.prefix_events = c.prefix_events;
  out.prefix_t = c.prefix_t;
  out.flips = c.flips;
  out.collisions = c.collisions;
  out.maneuvers = c.maneuvers;
  out.flips_not_judged = c.flips_not_judged;
  for (const Leniency& l : leniencies(c)) {
    if (l.count > 0) out.leniency.push_back({std::string(l.name), std::string(l.words), l.count});
  }
  if (c.other_horizon) out.leniency.push_back({"other_horizon", horizon_line(c), 1});
  out.remarks = c.remarks;
  VerdictWords words = words_of(options, run.horizon, c);
  out.words = std::move(words.verdict);
  out.about = std::move(words.about);
  out.reservations = std::move(words.reservations);
  out.json = report_text(run, options, c);
  return out;
}

voroproof::Report judged(Claim&& claim, const std::string& scene_name,
                         const std::string& history_name, const voroproof::CertifyOptions& asked) {
  const CertifyOptions options = options_of(asked);
  require_meaningful(options, claim.history->header().horizon);
  claim.history->keep_digest();
  Certificate c = certify(claim.scene, *claim.history, options);
  claim.history->require_unchanged();
  c.remarks.insert(c.remarks.begin(), claim.remarks.begin(), claim.remarks.end());
  CertificationRun run =
      certification_run("voroproof " VOROPROOF_VERSION, scene_name, history_name, claim, {});
  run.history_sha256 = claim.history->content_sha256();
  return report_value(std::move(run), options, c);
}

// `text`: the history where no file holds it.
voroproof::Report judged(const Billiard& billiard, const std::string& scene_name,
                         const std::string& history_name, std::optional<std::string_view> text,
                         const voroproof::CertifyOptions& asked) {
  if (asked.strict) throw std::invalid_argument("strict: not for billiards");
  if (asked.any_order) throw std::invalid_argument("order: only \"format\" for billiards");
  CertifyOptions options = options_of(asked);
  options.events = EventKinds::collisions;
  BilliardHistoryReader history(history_name, &billiard, text);
  require_meaningful(options, history.header().horizon);
  Certificate c = certify_billiard(billiard, scene_name, history, options);
  c.other_horizon = other_horizon(billiard.horizon, history.header());
  CertificationRun run = certification_run("voroproof " VOROPROOF_VERSION, scene_name, history_name,
                                           billiard, history.header());
  run.history_sha256 = history.content_sha256();
  return report_value(std::move(run), options, c);
}

}  // namespace
}  // namespace internal

using internal::with_public_errors;

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return "certified";
    case Verdict::refuted:
      return "refuted";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

Report certify(const Scene& scene, const History& history, const CertifyOptions& options) {
  return with_public_errors([&] {
    return internal::judged(internal::memory_claim(scene, history), "scene", "history", options);
  });
}

Report certify_files(const std::string& scene_path, const std::string& history_path,
                     const CertifyOptions& options) {
  return with_public_errors([&] {
    if (internal::is_billiard_file(scene_path)) {
      return internal::judged(internal::read_billiard(scene_path), scene_path, history_path, {},
                              options);
    }
    return internal::judged(internal::open_claim(scene_path, history_path), scene_path,
                            history_path, options);
  });
}

Report certify(const Billiard& billiard, const BilliardHistory& history,
               const CertifyOptions& options) {
  return with_public_errors([&] {
    return internal::judged(billiard.read(), "scene", internal::history_in_memory,
                            internal::history_text(history), options);
  });
}

std::string explain(const Report& report) {
  return with_public_errors(
      [&] { return internal::explain_report_text(report.json, "report").words; });
}

}  // namespace voroproof
