#include "tests/metamorphic/relations.h"

namespace voroproof::internal::metamorphic {

adversary::Random random_for(const World& world, Relation relation) {
  return adversary::Random(world.seed * 0xda942042e4dd58b5u + 31 +
                           static_cast<std::uint64_t>(relation));
}

testing::ClaimedHistory claim_of(const World& world, const testing::RecordedRun& run) {
  if (world.claim) return *world.claim;
  testing::ClaimedHistory own = testing::claimed_history(world.scene, run);
  if (!world.mutation) return own;
  testing::Random random(world.seed);
  const double tolerance = world.tolerance.get_d();
  auto mutant = testing::mutate(world.scene, own, *world.mutation, tolerance, tolerance, random);
  return mutant ? std::move(*mutant) : own;
}

Contradiction told(const std::string& what, const Case& ours, const testing::RecordedRun& our_run,
                   const Case& theirs, const testing::RecordedRun& their_run) {
  Contradiction c{what, ours, theirs};
  c.ours.answer = our_run.outcome.reason;
  c.theirs.answer = their_run.outcome.reason;
  return c;
}

namespace {

Comparison compare_once(Relation relation, const World& world) {
  switch (relation) {
    case Relation::units:
    case Relation::relabelled:
    case Relation::mirrored:
    case Relation::quarter_turn:
    case Relation::pythagorean_turn:
    case Relation::translated:
      return compare_image(world, relation);
    case Relation::still_maneuvers:
      return compare_still_maneuvers(world);
    case Relation::earlier_horizon:
      return compare_earlier_horizon(world);
    case Relation::other_spelling:
      return compare_spelling(world);
    case Relation::side_by_side:
    case Relation::inert_disks:
      return compare_clusters(world, relation);
    case Relation::moment:
      return compare_moment(world);
    case Relation::other_ways:
      return compare_ways(world);
    case Relation::certified:
      return compare_certified(world);
    case Relation::kernel:
      return compare_kernel(world);
    case Relation::count:
      break;
  }
  return {};
}

// Whether one of the two is undecided although all the time and bits were there.
bool is_left_open_for_cost(const Contradiction& found) {
  const auto is = [](const std::string& answer) {
    return answer.find("the budget of exact arithmetic is exceeded") != std::string::npos ||
           answer.find("the state after the collision needs more than") != std::string::npos;
  };
  return is(found.ours.answer) || is(found.theirs.answer);
}

}  // namespace

Comparison compare(Relation relation, const World& world) {
  try {
    begin_comparison();
    const Comparison comparison = compare_once(relation, world);
    if (!comparison.found) return {comparison.made && !took_too_long(), {}, took_too_long()};
    // What is left open for its cost is no contradiction.
    const Generosity generosity;
    begin_comparison();
    const Comparison again = compare_once(relation, world);
    if (again.found && is_left_open_for_cost(*again.found)) return {false, {}, true};
    return again;
  } catch (const std::exception& error) {
    const Case asked{world.scene, world.claim, world.tolerance};
    return {true, Contradiction{std::string("an exception: ") + error.what(), asked, asked}};
  }
}

}  // namespace voroproof::internal::metamorphic
