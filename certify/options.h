// The options of the certifier.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "filtered/motion/motion.h"

namespace voroproof::internal {

enum class Truth {
  exact,     // the true motion of the scene
  recorded,  // the motion that the claimed collision times and velocities define
};

// Which events of a history are judged.
enum class EventKinds {
  all,
  collisions,  // with the maneuvers: flips and diagrams are passed over
};

struct CertifyOptions {
  Truth truth = Truth::exact;
  EventKinds events = EventKinds::all;
  Rational tolerance{1, 1000000};         // for times
  Rational law_tolerance{1, 1000000000};  // for velocities, relative to the speeds involved
  bool strict = false;  // swaps, unoriented quadruplets and another horizon are refuted
  // Exact truth: collisions and maneuvers of one instant may come in any order in which every
  // collision is of two that touch and approach then, and none such is left (docs/claim.md).
  bool any_order = false;
  bool unoriented = false;  // quadruplets may exchange their third generators, as in .evtsq files
  // Where all events are judged, and for the initial diagram. The certificate is the same.
  int threads = 1;
  // Exact truth: whether the certificate tells how far the claimed times of flips are from the true
  // ones (Certificate::ulps_max).
  bool measures_times = true;
  bool judges_flips() const { return events == EventKinds::all; }
  bool accepts_other_orders() const { return any_order && !strict; }
  // All events: the history is certified in parts of so many claims at least, and of one in 512 of
  // that for each disk.
  std::size_t least_part = 4096;
  // How many of the claims within twice the tolerance are looked at together, to find their order.
  std::size_t most_near = 16384;
  MotionOptions motion;
  // Where the history gives no initial diagram: one to be proved in its place. Nothing is
  // believed of it.
  std::function<std::vector<Quad>(Motion&)> propose_initial;
  // Called now and then with the time and the number of claims checked; false interrupts.
  std::function<bool(double t, std::int64_t events)> monitor;
};

// Thrown when `monitor` asks to stop; what was certified by then.
struct CertificationInterrupted {
  std::int64_t prefix_events = 0;
  double prefix_t = 0;
};

}  // namespace voroproof::internal
