#include "certify/world/world_certifier.h"

#include <utility>

#include "certify/world/world_replay.h"
#include "exact/patience.h"

namespace voroproof::internal {

WorldCertifier::WorldCertifier(const World& world, const std::vector<Quad>& initial,
                               Rational tolerance, std::function<bool()> go_on, bool filters)
    : horizon_(world.horizon), tolerance_(std::move(tolerance)), go_on_(std::move(go_on)) {
  if (!go_on_) go_on_ = [] { return true; };
  judge(1, [&] { replay_ = std::make_unique<WorldReplay>(world, initial, filters); });
}

WorldCertifier::~WorldCertifier() = default;

void WorldCertifier::conclude(Verdict kind, std::int64_t line, std::string reason) {
  verdict_.emplace();
  verdict_->kind = kind;
  verdict_->line = line;
  verdict_->t = last_;
  verdict_->reason = std::move(reason);
  if (replay_) verdict_->checked = replay_->checked();
  verdict_->tolerance = tolerance_.get_str();
}

template <class Work>
void WorldCertifier::judge(std::int64_t line, const Work& work) {
  if (verdict_) return;
  const auto see = [&] {
    if (replay_ && replay_->is_open()) last_ = replay_->at().nearest();
  };
  try {
    const Patience patience(go_on_);
    work();
  } catch (const WorldRefuted& e) {
    see();
    conclude(Verdict::refuted, line, e.reason);
  } catch (const WorldUndecided& e) {
    see();
    conclude(Verdict::undecided, line, e.reason);
  } catch (const GivenUp&) {
    see();
    conclude(Verdict::undecided, line, "given up");
  }
}

// An instant that is left with something missing is the more likely misunderstood where a claim
// was refused: both reasons are told.
void WorldCertifier::leave(const std::string& why_not) {
  try {
    replay_->close();
  } catch (WorldRefuted& e) {
    if (!why_not.empty()) e.reason += "; the claim is refused: " + why_not;
    throw;
  }
}

void WorldCertifier::take(const WorldEvent& event) {
  const Rational early = event.t - tolerance_, late = event.t + tolerance_;
  std::string why_not;
  for (;;) {
    if (replay_->is_open()) {
      if (compare(replay_->at(), early) >= 0 && compare(replay_->at(), late) <= 0) {
        if (replay_->take(event)) return;
        if (why_not.empty()) why_not = replay_->why_not();
      }
      leave(why_not);
    }
    const auto* next = replay_->next();
    if (next == nullptr || compare(*next, late) > 0) {
      throw WorldRefuted{"no such event then" + (why_not.empty() ? "" : ": " + why_not)};
    }
    replay_->open();
  }
}

void WorldCertifier::event(const WorldEvent& event, std::int64_t line) {
  judge(line, [&] {
    last_ = round_nearest(event.t);
    counts_.add(event);
    take(event);
  });
}

WorldVerdict WorldCertifier::finish(const WorldEnd& end, std::int64_t line) {
  judge(line, [&] {
    if (replay_->is_open()) replay_->close();
    while (replay_->next() != nullptr) {
      replay_->open();
      replay_->close();
    }
    last_ = round_nearest(horizon_);
    if (!(counts_ == end.counts)) throw WorldRefuted{"the counts are not those of the lines"};
    conclude(Verdict::certified, 0, "");
  });
  return *verdict_;
}

WorldVerdict WorldCertifier::finish(const WorldStop& stop, std::int64_t line) {
  judge(line, [&] {
    const Rational before = stop.t - tolerance_;
    if (replay_->is_open() && compare(replay_->at(), before) < 0) replay_->close();
    while (!replay_->is_open()) {
      const auto* next = replay_->next();
      if (next == nullptr || compare(*next, before) >= 0) break;
      replay_->open();
      replay_->close();
    }
    last_ = round_nearest(stop.t);
    throw WorldUndecided{"the history stops: " + stop.reason};
  });
  return *verdict_;
}

}  // namespace voroproof::internal
