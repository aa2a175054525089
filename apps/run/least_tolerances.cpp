#include "apps/run/least_tolerances.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "apps/cli/limits.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

constexpr int least_law = -16, most_law = -1;

// The power of ten.
Rational ten_to(int exponent) {
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? Rational(1) / power : Rational(power);
}

// The exponent of the least power of ten that is no less.
int exponent_above(const Rational& x) {
  int exponent = static_cast<int>(std::floor(std::log10(round_nearest(x)))) - 1;
  while (ten_to(exponent) < x) ++exponent;
  return exponent;
}

// Whether wider velocities may mend it.
bool is_of_velocities(const Certificate& c) {
  return c.divergence && c.divergence->fault == Fault::wrong_response;
}

class Search {
 public:
  Search(CertifyOptions options, const Rational& horizon, const JudgeAnew& judge)
      : options_(std::move(options)),
        judge_(judge),
        times_(exponent_above(options_.tolerance)),
        velocities_(options_.law_tolerance == 0 ? least_law
                                                : exponent_above(options_.law_tolerance)),
        least_times_(horizon == 0 ? times_ : exponent_above(horizon) - 17),
        most_times_(horizon == 0 ? times_ : exponent_above(horizon) - 2) {}

  // Widens what the fault is of until the history is not refuted, or no more is tried: the verdict.
  Verdict widen(const Certificate& first) {
    Certificate c = first;
    while (c.verdict == Verdict::refuted) {
      // A response is wrong by its velocities, or by its centres, for which times count.
      const bool widens_law = is_of_velocities(c) && velocities_ < most_law;
      if (!widens_law && times_ >= most_times_) break;
      ++(widens_law ? velocities_ : times_);
      c = at(times_, velocities_);
    }
    return c.verdict;
  }

  void narrow() {
    while (times_ > least_times_ && certifies(times_ - 1, velocities_)) --times_;
    while (velocities_ > least_law && certifies(times_, velocities_ - 1)) --velocities_;
  }

  // The last ones that were tried.
  LeastTolerances tolerances() const { return {ten_to(times_), ten_to(velocities_)}; }

 private:
  Certificate at(int times, int velocities) {
    options_.tolerance = ten_to(times);
    options_.law_tolerance = ten_to(velocities);
    return judge_(options_);
  }
  bool certifies(int times, int velocities) {
    return at(times, velocities).verdict == Verdict::certified;
  }

  CertifyOptions options_;
  const JudgeAnew& judge_;
  int times_, velocities_;  // exponents of ten
  int least_times_, most_times_;
};

// Says in one line how good a history with that certificate is: with these tolerances, the last
// that were tried, it has the verdict `last`.
std::string line_of(const LeastTolerances& tried, Verdict last, const Certificate& certificate) {
  const std::string tolerances = "times within " + number_text(round_nearest(tried.times)) +
                                 " and velocities within " +
                                 number_text(round_nearest(tried.velocities));
  if (last == Verdict::undecided) return "the least tolerances are not known";
  if (last == Verdict::refuted)
    return "an event is wrong with " + tolerances + ", too, the widest that were tried";
  if (certificate.verdict != Verdict::refuted)
    return "the least powers of ten that certify the history are " + tolerances;
  return "all events are right, and numbers leave the tolerances from t = " +
         number_text(certificate.divergence->t) + " on: with " + tolerances +
         " the history is certified";
}

}  // namespace

void add_least_tolerances(ShardFile& file, const CooperativeInterruption& interruption,
                          const JudgeAnew& judge) {
  Certificate& certificate = file.shard.certificate;
  CertifyOptions options = file.options;
  options.monitor = [&](double, std::int64_t) { return !interruption.requested(); };
  try {
    Search search(std::move(options), file.run.horizon, judge);
    const Verdict last = search.widen(certificate);
    if (last == Verdict::certified) {
      search.narrow();
      file.run.least = search.tolerances();
    }
    certificate.remarks.push_back(line_of(search.tolerances(), last, certificate));
  } catch (const CertificationInterrupted&) {
    if (!interruption.late()) throw Interrupted();
    certificate.remarks.push_back("the least tolerances are not known: " + time_limit_reason());
  }
}

}  // namespace voroproof::internal
