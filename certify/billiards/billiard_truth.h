// The truth against which the claims of a billiard are held: the recorded paths
// (recorded_billiard.h) or the true motion (exact_billiard.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/billiards/billiard_path.h"
#include "certify/certificate.h"
#include "exact/billiard_events.h"

namespace voroproof::internal {

// A fault of the history. The one of the smallest line is told, of one line the earliest.
struct BilliardFault {
  Fault kind;
  std::int64_t line;
  double t;
  std::string truth;
  std::optional<std::pair<GenId, GenId>> contact{};  // which two touch, or are said to
};

// The faults found so far, and the counts.
struct BilliardFindings {
  std::vector<BilliardFault> faults;
  std::int64_t pair_lives = 0, grazes = 0, rounding_overlaps = 0, left_out = 0;
  std::int64_t computed_velocities = 0, at_horizon = 0, swaps = 0;
  int highest_bits = 0;

  // Those that come after these.
  void add(const BilliardFindings& later) {
    faults.insert(faults.end(), later.faults.begin(), later.faults.end());
    pair_lives += later.pair_lives;
    grazes += later.grazes;
    rounding_overlaps += later.rounding_overlaps;
    left_out += later.left_out;
    computed_velocities += later.computed_velocities;
    at_horizon += later.at_horizon;
    swaps += later.swaps;
    highest_bits = std::max(highest_bits, later.highest_bits);
  }
};

struct BilliardClaim {
  std::int64_t number, line;  // counted from 0 in the history
  BilliardTime t;
};

// The window [from, to] of time, at whose end all claims have been read whose truth may lie in it.
// The history tells what happens up to `until`: the horizon, or where it stops. `last`: no claim
// comes any more.
struct BilliardWindow {
  BilliardTime from, to;
  Rational until;
  bool last;
  const std::vector<BilliardTime>* times;  // the claims' whose truth may be after `from`, in order
  std::int64_t first_line;                 // the first one's, or that of what follows them

  // The line of the first claim for which `is_later` holds.
  template <class IsLater>
  std::int64_t line_after(IsLater&& is_later) const {
    std::int64_t line = first_line;
    for (const BilliardTime& t : *times) {
      if (is_later(t)) break;
      ++line;
    }
    return line;
  }
};

class BilliardTruth {
 public:
  virtual ~BilliardTruth() = default;

  // How much later than its truth a claim may come. Claims up to that after the end of a window are
  // read before the window is followed.
  virtual Rational lag() const = 0;

  // Before the first window, and once the disks are known to be in their places.
  virtual void begin() = 0;
  // How long the next window is to be; infinite where nothing moves, or nothing can meet.
  virtual double good_length() const = 0;

  // Hold a claim against the truth, and let its disks turn. `due`: the maneuver that is meant.
  virtual void collide(const BilliardCollision& claim, const BilliardClaim& at) = 0;
  virtual void maneuver(const BilliardTurn& claim, const BilliardManeuver& due,
                        const BilliardClaim& at) = 0;
  // Follows all pairs through the window, so that no collision is missing.
  virtual void follow(const BilliardWindow& window) = 0;

  // Faults and counts so far. All but this one throw Undecided where the truth is not told.
  virtual BilliardFindings& found() = 0;
};

}  // namespace voroproof::internal
