#include "certify/exact_parts.h"

#include <optional>
#include <utility>

#include "certify/exact_turns.h"
#include "exact/patience.h"

namespace voroproof::internal {

namespace {

Certificate checked(const Scene& scene, ComputedMotion& motion, TrueTurns& turns, Births births,
                    Part& part, Replay replay, const CertifyOptions& options) {
  const auto make = [&](const ExactTruth::Parts& parts) {
    return std::make_unique<ExactTurns>(parts, turns, std::move(births));
  };
  return Checker(scene, motion, *part.claims, options, std::move(replay), part.begin,
                 std::move(part.places), make)
      .run(part.end ? &*part.end : nullptr);
}

}  // namespace

PartTruth ExactParts::truth() {
  return {.prove = [this](Part& part, const CertifyOptions& o) { return prove(part, o); },
          .lead = [this](Part& part, HistorySource& turns,
                         const CertifyOptions& o) { return lead(part, turns, o); },
          .rest = [this](Part& part, const CertifyOptions& o) { return rest(part, o); }};
}

bool ExactParts::lead(Part& part, HistorySource& turns, const CertifyOptions& options) {
  if (part.number == 0 && !part.end) return false;
  if (!leader_) leader_.emplace(scene_, input_, header_, options_);
  const std::shared_ptr<LedPart> led = leader_->begin(part);
  part.led = led;
  if (!part.end) return false;
  const double begin = part.begin.value_or(0);
  const Patience patience([&] { return options.monitor(begin, 0); });
  led->turns.reserve(part.list->turns());
  try {
    return leader_->lead(part, turns, led->turns);
  } catch (const GivenUp&) {
    throw CertificationInterrupted{0, begin};
  }
}

Certificate ExactParts::prove(Part& part, const CertifyOptions& options) const {
  const LedPart& led = *part.led;
  ComputedMotion motion(input_, options.motion, led.log);
  motion.follow(led.motion);
  motion.believe(led.facts);
  FollowedTurns turns(motion, led.turns);
  // The part keeps its replay: it may be judged again.
  Certificate c = checked(scene_, motion, turns, led.births, part, part.replay, options);
  if (!turns.all_taken()) c.verdict = Verdict::undecided;
  return c;
}

Certificate ExactParts::rest(Part& part, const CertifyOptions& options) const {
  part.places.clear();
  part.end.reset();
  if (part.number == 0) {
    ComputedMotion motion(input_, options.motion);
    ComputedTurns turns(scene_, motion);
    return checked(scene_, motion, turns, Births(scene_.disks.size()), part,
                   Replay(scene_, options), options);
  }
  const LedPart& led = *part.led;
  // Before this part the turns are proved. It goes on with a log of its own.
  const std::size_t turns_before = led.motion.full.records;
  ComputedMotion motion(input_, options.motion,
                        std::make_shared<MotionLog>(*led.log, turns_before));
  motion.follow(led.motion);
  motion.believe(led.facts);
  ComputedTurns turns(scene_, motion);
  return checked(scene_, motion, turns, led.births, part, std::move(part.replay), options);
}

}  // namespace voroproof::internal
