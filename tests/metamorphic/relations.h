// What must not change, or change in a known way, when a world is looked at in another way.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "tests/adversary/families.h"
#include "tests/metamorphic/answers.h"
#include "tests/metamorphic/worlds.h"

namespace voroproof::internal::metamorphic {

enum class Relation {
  units,             // lengths and times multiplied by powers of two
  relabelled,        // other ids
  mirrored,          //
  quarter_turn,      //
  pythagorean_turn,  // by (3/5, 4/5)
  translated,        // by dyadic vectors, up to 2^100
  still_maneuvers,   // maneuvers to the velocity that the disk has
  earlier_horizon,   // a beginning of the history
  other_spelling,    // the same numbers, written otherwise
  side_by_side,      // two clusters far apart: collisions of each as alone
  inert_disks,       // disks at rest out of reach
  moment,            // the diagram at an instant, and what is asked of it
  other_ways,        // filters off, other precision, threads, a run that is resumed
  certified,         // the engine's history is certified
  kernel,            // the kernel does not contradict, and certifies no more
  count
};
inline constexpr std::array<std::string_view, static_cast<int>(Relation::count)> relation_names{
    "units",       "relabelled",      "mirrored",        "quarter turn",   "pythagorean turn",
    "translated",  "still maneuvers", "earlier horizon", "other spelling", "side by side",
    "inert disks", "moment",          "other ways",      "certified",      "kernel"};
inline std::string_view name(Relation r) { return relation_names[static_cast<std::size_t>(r)]; }

// An answer that differs, with what was asked and what was said.
struct Contradiction {
  std::string what;
  Case ours, theirs;
};

struct Comparison {
  bool made = false;  // whether the relation says anything of the world
  std::optional<Contradiction> found{};
  bool too_long = false;
};

// Two runs that differ, with how they ended.
Contradiction told(const std::string& what, const Case& ours, const testing::RecordedRun& our_run,
                   const Case& theirs, const testing::RecordedRun& their_run);

// A function of the world and its seed.
Comparison compare(Relation relation, const World& world);

// ---- For the files of relations. ----

adversary::Random random_for(const World& world, Relation relation);

// What is claimed of the world's scene, of which this is the engine's run.
testing::ClaimedHistory claim_of(const World& world, const testing::RecordedRun& run);

Comparison compare_image(const World& world, Relation relation);  // up to `translated`
Comparison compare_moment(const World& world);
Comparison compare_still_maneuvers(const World& world);
Comparison compare_earlier_horizon(const World& world);
Comparison compare_spelling(const World& world);
Comparison compare_clusters(const World& world, Relation relation);
Comparison compare_ways(const World& world);
Comparison compare_certified(const World& world);
Comparison compare_kernel(const World& world);

// Whether the engine's own history is refused because rounding has put a flip and a turn of its
// disk, one after the other, at one recorded time, at which disks turn first (docs/claim.md).
bool refused_for_rounding(const Answer& own, Truth truth, const testing::RecordedRun& run);

// Whether the engine's own histories of both scenes get one verdict under each truth.
std::optional<Contradiction> own_verdicts(const Case& ours, const testing::RecordedRun& our_run,
                                          const Case& theirs,
                                          const testing::RecordedRun& their_run);

}  // namespace voroproof::internal::metamorphic
