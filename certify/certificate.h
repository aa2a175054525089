// The result of a certification: a verdict, and what it rests on.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/generators.h"
#include "exact/rational.h"
#include "filtered/numbers/stats.h"
#include "history/events.h"

namespace voroproof::internal {

enum class Verdict { certified, refuted, undecided };

// The ways in which a history can be false.
enum class Fault {
  missing_event,    // something happens that is not claimed
  spurious_event,   // a claimed event does not happen
  wrong_quadruple,  // another edge flips here
  wrong_time,       // it happens at another time
  wrong_order,      // it happens after what is claimed later, or before what is claimed earlier
  other_order,  // collisions and maneuvers of one instant come in an order that is not the format's
  wrong_pair,   // other generators touch here
  wrong_image,  // another image of the disk touches here
  wrong_response,         // the velocities or centres claimed are not those of the event
  wrong_initial_diagram,  // the diagram claimed is not that at the start
  overlap,                // generators overlap and no collision is claimed
  bad_count,              // the counts of the last line are not those of the events
  edge_not_present,       // the edge claimed to flip is not in the diagram
  other_horizon,          // the history ends at another time than its scene asks for (--strict)
  count
};
inline constexpr std::array<std::string_view, static_cast<int>(Fault::count)> fault_names{
    "missing event",    "spurious event",
    "wrong quadruple",  "wrong time",
    "wrong order",      "another order of touching collisions",
    "wrong pair",       "wrong image",
    "wrong response",   "wrong initial diagram",
    "overlap",          "bad count",
    "edge not present", "other horizon"};

// A number as evidence: exact ("3/8") where it is rational and short enough, else an enclosure.
struct EvidenceNumber {
  std::string exact;         // empty where not known in this form
  std::string lower, upper;  // decimal bounds, where `exact` is empty
};

// A generator's motion near the event: centre x + vx (t - t0), signed radius.
struct EvidenceMotion {
  GenId id;
  Rational t0;
  EvidenceNumber x, y, vx, vy, radius;
};

// Evidence that anybody can check by hand or with a computer algebra system.
struct Witness {
  std::vector<EvidenceMotion> generators;  // in the order of the quadruplet, triple or pair
  // A polynomial in t (powers 0, 1, ...) whose only root in [lo, hi] is the time of the event:
  // the cotangency of four generators, the cocircularity of four of equal radii, or |offset|^2 -
  // reach^2 of two.
  std::string polynomial_is;
  std::vector<EvidenceNumber> polynomial;
  std::optional<std::array<Rational, 2>> root;  // [lo, hi]
  // Or: at this time the two overlap, or the circle of the vertex contains a point of the
  // generator.
  std::optional<Rational> t;
  std::optional<Triple> vertex;
  std::optional<GenId> conflict;
};

struct Divergence {
  Fault fault;
  std::int64_t line = 0;       // in the history: the claim, or the line before which one is missing
  double t = 0;                // time of the claim, or of the truth where no claim is at fault
  std::optional<Event> claim;  // as read
  std::string truth;           // one sentence
  std::optional<Quad> true_flip;
  std::optional<std::pair<GenId, GenId>> true_contact;
  std::optional<std::array<double, 2>> true_time;  // enclosure of its time
  Witness witness;
};

struct Certificate {
  Verdict verdict = Verdict::undecided;
  std::optional<Divergence> divergence;  // for a refutation
  std::string reason;                    // why it is undecided
  std::int64_t reason_line = 0;
  // The certified prefix: the first so many events are right, and nothing is missing before t.
  std::int64_t prefix_events = 0;
  double prefix_t = 0;
  // Counts of what was proved.
  std::int64_t flips = 0, collisions = 0, maneuvers = 0;
  std::int64_t edge_lives = 0, pair_lives = 0;  // intervals proved free of collapse, of contact
  std::int64_t simultaneous = 0;                // events proved simultaneous with the one before
  // Counts of leniencies used (docs/claim.md).
  std::int64_t swaps = 0;     // claims out of order within the tolerance, whose events commute
  std::int64_t resolved = 0;  // quadruplets without orientation that were resolved
  std::int64_t grazes = 0;    // collisions of two that come near, and touch but for roundings
  std::int64_t rounding_overlaps = 0;    // overlaps no deeper than roundings, without a collision
  std::int64_t at_horizon = 0;           // claims within the tolerance of the horizon
  std::int64_t left_out = 0;             // events there that are not claimed
  std::int64_t proved_anew = 0;          // pairs of which one lay inside the other for a moment
  std::int64_t computed_velocities = 0;  // collisions without velocities: by the law
  std::int64_t other_orders = 0;  // instants whose turns are not proved to be in the format's order
  // With EventKinds::collisions: flips of the history, which nobody has looked at.
  std::int64_t flips_not_judged = 0;
  // The history's horizon and the scene's, where they are not one.
  std::optional<std::array<Rational, 2>> other_horizon;
  // Errors of claimed times of flips, in units in the last place of the claim: the greatest, and
  // the sum of so many.
  double ulps_max = 0, ulps_sum = 0;
  std::int64_t ulps_max_line = 0, ulps_count = 0;
  // 0 where there are none.
  double ulps_mean() const {
    return ulps_count > 0 ? ulps_sum / static_cast<double>(ulps_count) : 0;
  }
  std::vector<std::string> remarks;
  int highest_bits = 0;
  TierCounts tiers;
};

}  // namespace voroproof::internal
