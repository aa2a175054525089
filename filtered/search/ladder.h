// How a question is decided by tiers: the cheapest first, each asked in its turn until one answers.
#pragma once

#include <optional>
#include <string>

#include "exact/tower.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/stats.h"

namespace voroproof::internal {

// One tier of a ladder. attempt() gives an optional answer; nothing where the tier cannot tell. It
// may throw BudgetExceeded, which says that it cannot tell either, and why.
template <class Attempt>
struct Rung {
  Tier tier;
  Attempt attempt;
};
template <class Attempt>
Rung(Tier, Attempt) -> Rung<Attempt>;

// Asks for an answer about `predicate` and counts the tier that gave it.
template <class Answer>
class Ladder {
 public:
  Ladder(TierCounts& counts, Predicate predicate) : counts_(counts), predicate_(predicate) {}

  // The first answer of the rungs, in their order; nothing where none has one.
  template <class... Attempts>
  std::optional<Answer> climb(const Rung<Attempts>&... rungs) {
    std::optional<Answer> answer;
    static_cast<void>(((answer = ask(rungs)).has_value() || ...));
    return answer;
  }

  // The answer of a rung that gets better as the motion is computed with more bits; nothing where
  // the most that `motion` may have do not do.
  template <class Attempt>
  std::optional<Answer> with_more_bits(Motion& motion, const Rung<Attempt>& rung) {
    while (motion.raise_precision()) {
      if (std::optional<Answer> answer = ask(rung)) return answer;
    }
    return std::nullopt;
  }

  // Why exact arithmetic did not answer; empty where it was not asked.
  const std::string& budget() const { return budget_; }

 private:
  template <class Attempt>
  std::optional<Answer> ask(const Rung<Attempt>& rung) {
    try {
      std::optional<Answer> answer = rung.attempt();
      if (answer) counts_.count(predicate_, rung.tier);
      return answer;
    } catch (const BudgetExceeded& e) {
      budget_ = e.what();
      return std::nullopt;
    }
  }

  TierCounts& counts_;
  Predicate predicate_;
  std::string budget_;
};

// A sign as an answer: nothing where it is zero or unknown.
inline std::optional<int> told(Sign s) {
  return s == Sign::positive || s == Sign::negative ? std::optional<int>(static_cast<int>(s))
                                                    : std::nullopt;
}

}  // namespace voroproof::internal
