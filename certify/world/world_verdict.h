// How the certification of a world's history ends.
#pragma once

#include <cstdint>
#include <string>

#include "certify/certificate.h"

namespace voroproof::internal {

struct WorldVerdict {
  Verdict kind = Verdict::undecided;
  std::int64_t line = 0;  // where it lies in the history, from 1 on; 0 if nowhere
  double t = 0;           // the exact instant, rounded
  std::string reason;
  // The decisions that were taken, by kind.
  struct Counts {
    std::int64_t edge_lives = 0;    // edges proved legal just after an instant, and followed
    std::int64_t pair_lives = 0;    // pairs of neighbours followed
    std::int64_t hidden_lives = 0;  // hidden disks with a host, followed
    std::int64_t cells = 0;         // cells proved to wind once
    std::int64_t instants = 0;      // instants entered, with events or without
    std::int64_t jumps = 0;
  } checked{};
  std::string tolerance{};  // the one of claimed times, as it was used
};

// Thrown where the verdict is known.
struct WorldRefuted {
  std::string reason;
};
struct WorldUndecided {
  std::string reason;
};

}  // namespace voroproof::internal
