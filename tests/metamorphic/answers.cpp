#include "tests/metamorphic/answers.h"

#include <ctime>
#include <exception>

#include "certify/evidence/evidence.h"
#include "history/error.h"
#include "tests/metamorphic/maps.h"
#ifdef VOROPROOF_KERNEL
#include "certify/kernel/kernel.h"
#endif

namespace voroproof::internal::metamorphic {
namespace {

double seconds() { return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC); }

struct Stopwatch {
  double begin = 0;
  bool late = false;

  bool in_time() {
    late = late || seconds() - begin > budget().seconds;
    return !late;
  }
};
Stopwatch stopwatch;

void bound(MotionOptions& motion) {
  motion.max_bits = budget().bits;
  motion.max_radicals = budget().radicals;
}

Answer answer_of(const Certificate& c) {
  Answer answer;
  answer.contacts_by_rounding = c.grazes + c.rounding_overlaps > 0;
  answer.velocities_by_law = c.computed_velocities > 0;
  answer.swapped = c.swaps > 0;
  if (c.verdict != Verdict::refuted) {
    answer.verdict = c.verdict == Verdict::certified ? "certified" : "undecided";
    answer.reason = c.reason;
    answer.hidden = c.reason.find("inside another") != std::string::npos;
    return answer;
  }
  const Divergence& d = *c.divergence;
  const EvidenceCheck evidence = check_evidence(d);
  if (evidence.evidence == Evidence::contradicted) return {"failed", evidence.sentence};
  answer.verdict = "refuted";
  answer.reason = d.truth;
  answer.line = d.line;
  answer.fault = d.fault;
  answer.flip = d.true_flip;
  answer.contact = d.true_contact;
  return answer;
}

}  // namespace

Budget& budget() {
  static Budget current;
  return current;
}

void begin_comparison() { stopwatch = {seconds()}; }
bool took_too_long() { return stopwatch.late; }

const char* name_of(Truth truth) { return truth == Truth::exact ? "exact" : "recorded"; }

Run simulated(const Scene& scene, EngineOptions options) {
  bound(options.motion);
  options.monitor = [](double, std::uint64_t) { return stopwatch.in_time(); };
  return {testing::run_with(scene, options)};
}

std::string text(const Answer& a) {
  std::string out = a.verdict;
  if (a.fault) out += ", " + std::string(fault_names[static_cast<std::size_t>(*a.fault)]);
  if (a.line > 0) out += ", line " + std::to_string(a.line);
  return out + (a.reason.empty() ? "" : ": " + a.reason);
}

Answer certified(const Case& of, Truth truth, CertifyOptions options) {
  options.truth = truth;
  options.tolerance = of.tolerance;
  bound(options.motion);
  options.monitor = [](double, std::int64_t) { return stopwatch.in_time(); };
  try {
    return answer_of(testing::certify(of.scene, *of.claim, options));
  } catch (const CertificationInterrupted&) {
    return {"endless"};
  } catch (const InputError& error) {
    return {"invalid", error.what()};
  } catch (const std::exception& error) {
    return {"failed", error.what()};
  }
}

#ifdef VOROPROOF_KERNEL
std::string kernel_verdict(const Case& of, Truth truth) {
  namespace k = voroproof_kernel;
  k::Options options;
  options.truth = truth == Truth::exact ? k::Truth::exact : k::Truth::recorded;
  options.tolerance = of.tolerance.get_str();
  const Scene read = parse_scene(testing::text(of.scene), "scene");
  const k::Result r =
      k::check(testing::text(of.scene), history_text(*of.claim, read.sha256), options);
  switch (r.verdict) {
    case k::Verdict::certified:
      return "certified";
    case k::Verdict::refuted:
      return "refuted";
    case k::Verdict::undecided:
      return "undecided";
    case k::Verdict::invalid:
      break;
  }
  return "invalid: " + r.reason;
}
#else
std::string kernel_verdict(const Case&, Truth) { return "absent"; }
#endif

}  // namespace voroproof::internal::metamorphic
