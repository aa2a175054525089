// A run that is held against the oracles, for the parts of that check.
#pragma once

#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/oracle/motion.h"
#include "tests/support/history_check.h"

namespace voroproof::internal::testing {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Found by a check; the message is the fault.
struct Fault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A run with its motion by the oracle, in so many decimal digits.
template <unsigned Digits>
struct CheckedRun {
  using Motion = oracle::BasicMotionOracle<Digits>;
  using Number = typename Motion::Number;

  CheckedRun(const Scene& of, const RecordedRun& recorded, const HistoryCheck& asked,
             CheckCounts& seen)
      : scene(of),
        run(recorded),
        check(asked),
        counts(seen),
        motion_scene(oracle_scene(of)),
        records(motion_records(of, recorded)),
        motion(motion_scene, records) {}

  const Scene& scene;
  const RecordedRun& run;
  const HistoryCheck& check;
  CheckCounts& counts;
  oracle::MotionScene motion_scene;
  std::vector<oracle::MotionRecord> records;
  Motion motion;
};

}  // namespace voroproof::internal::testing
