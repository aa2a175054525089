#include "certify/recorded_certifier.h"

#include <algorithm>
#include <stdexcept>

#include "certify/checker.h"
#include "certify/parts.h"
#include "history/error.h"
#include "history/scene_motion.h"

namespace voroproof::internal {

namespace {

// With --strict a horizon other than the scene's is a fault.
Certificate refuted_for(const std::array<Rational, 2>& horizons) {
  Certificate c;
  c.verdict = Verdict::refuted;
  c.divergence.emplace();
  c.divergence->fault = Fault::other_horizon;
  c.divergence->line = 1;
  c.divergence->truth = "the horizon of the scene is " + horizons[1].get_str();
  c.other_horizon = horizons;
  return c;
}

// A missing flip may be claimed, as one that is none.
void name_shadow(Certificate& c, HistorySource& history, double tolerance) {
  if (!c.divergence || c.divergence->fault != Fault::missing_event || !c.divergence->true_flip) {
    return;
  }
  Divergence& d = *c.divergence;
  const double far = mistimed_tolerances * tolerance;
  // The file has been read as far as the checkers came: on to the end of what is asked for.
  try {
    while (const auto event = history.next()) {
      if (time(*event) > (*d.true_time)[1] + far) break;
    }
  } catch (const InputError&) {
    // Where it cannot be read it says nothing.
  }
  const auto line =
      history.shadow_line(*d.true_flip, (*d.true_time)[0] - far, (*d.true_time)[1] + far);
  if (!line) return;
  d.line = *line;
  d.truth += ", which the file takes for a shadow flip";
}

CertifyOptions options_for(const HistorySource& history, const CertifyOptions& asked) {
  CertifyOptions options = asked;
  options.unoriented = !asked.strict && (asked.unoriented || !history.header().oriented);
  return options;
}

// Adds what is not known from the claims alone.
void complete(Certificate& c, const std::optional<std::array<Rational, 2>>& other,
              HistorySource& history, const CertifyOptions& options) {
  c.other_horizon = other;
  const auto told = history.remarks();
  c.remarks.insert(c.remarks.begin(), told.begin(), told.end());
  name_shadow(c, history, round_up(options.tolerance));
  const bool knows_no_flips = !history.header().initial && history.counts().flips == 0;
  if (knows_no_flips && c.divergence && c.divergence->true_flip) {
    c.remarks.push_back(
        "the history tells of no flips: --events collisions judges its collisions alone");
  }
}

}  // namespace

std::optional<std::array<Rational, 2>> other_horizon(const Rational& of_scene,
                                                     const HistoryHeader& header) {
  if (abs(Rational(header.horizon - of_scene)) <= header.horizon_error) return std::nullopt;
  return std::array{header.horizon, of_scene};
}

Certificate certify_by(
    const Scene& scene, HistorySource& history, const CertifyOptions& asked,
    const std::function<Certificate(const MotionInput&, const CertifyOptions&)>& prove) {
  const CertifyOptions options = options_for(history, asked);
  const std::optional<std::array<Rational, 2>> other =
      other_horizon(scene.horizon, history.header());
  if (other && asked.strict) return refuted_for(*other);
  Certificate c = prove(motion_input(scene), options);
  complete(c, other, history, options);
  return c;
}

Certificate certify_recorded(const Scene& scene, HistorySource& history,
                             const CertifyOptions& asked) {
  return certify_by(scene, history, asked,
                    [&](const MotionInput& input, const CertifyOptions& options) {
                      if (options.judges_flips()) {
                        return certify_in_parts(scene, input, history, options);
                      }
                      GivenMotion motion(checked_input(input, history.header()), options.motion);
                      return Checker(scene, motion, history, options, Replay(scene, options)).run();
                    });
}

Shard certify_shard(const Scene& scene, HistorySource& history, const CertifyOptions& asked,
                    const ShardTask& asked_task) {
  if (asked.truth != Truth::recorded || !asked.judges_flips()) {
    throw std::invalid_argument("shards are of the recorded truth, and of all events");
  }
  const CertifyOptions options = options_for(history, asked);
  const std::optional<std::array<Rational, 2>> other =
      other_horizon(scene.horizon, history.header());
  const MotionInput input = motion_input(scene);
  if (other && asked.strict) {
    return {start_of(scene, input, history, options), std::nullopt, refuted_for(*other)};
  }
  ShardTask task = asked_task;
  if (asked_task.proved) {
    task.proved = [&](Shard so_far) {
      complete(so_far.certificate, other, history, options);
      asked_task.proved(std::move(so_far));
    };
  }
  Shard shard = certify_in_parts(scene, input, history, options, task);
  complete(shard.certificate, other, history, options);
  return shard;
}

}  // namespace voroproof::internal
