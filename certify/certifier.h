// The certifier: proves a claimed history, refutes it with evidence, or says what it cannot decide.
//
// It does not simulate. It replays the claimed flips on the claimed initial diagram, moves the
// disks as the truth asked for says, and proves of every edge that it collapses where a flip is
// claimed and nowhere else in its life, and of every adjacent pair that it touches where a
// collision is claimed and nowhere else. docs/certificate.md proves that nothing can be missing
// then. It shares with the engine numbers, predicates, motion and, where doubles do not decide, the
// searches of filtered/search/; not the queue, nor the order of events, nor the first diagram.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "certify/certificate.h"
#include "certify/shard.h"
#include "filtered/motion/motion.h"
#include "history/history_source.h"
#include "history/scene.h"

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
  // For all events of the recorded truth, and for the initial diagram. The certificate is the same.
  int threads = 1;
  // Exact truth: whether the certificate tells how far the claimed times of flips are from the true
  // ones (Certificate::ulps_max).
  bool measures_times = true;
  bool judges_flips() const { return events == EventKinds::all; }
  bool accepts_other_orders() const { return any_order && !strict; }
  // Recorded truth, all events: the history is certified in parts of so many claims at least, and
  // of one in 512 of that for each disk.
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

// The history's horizon and the scene's, where they differ by more than the file can say: what a
// certificate tells of them (Certificate::other_horizon).
std::optional<std::array<Rational, 2>> other_horizon(const Scene& scene,
                                                     const HistoryHeader& header);

// Certifies the history against the scene. Throws InputError where the history is not one of its
// format or not of this scene.
Certificate certify(const Scene& scene, HistorySource& history, const CertifyOptions& options);

// The history read is not the one of which something is known already, or not with these options.
struct OtherHistory {};

// Certifies one shard of the history, under the recorded truth and of all events (else
// std::invalid_argument). What is before the shard is read and taken at its word. Put together in
// their order (append), the certificates of all shards, up to the first that is not `certified`,
// are that of certify(), if each shard begins at the cut at which the one before it ends. Throws as
// certify(), and OtherHistory where the history does not lead to task.from.
Shard certify_shard(const Scene& scene, HistorySource& history, const CertifyOptions& options,
                    const ShardTask& task);

}  // namespace voroproof::internal
