// Isometries, units and new ids.
#include <algorithm>
#include <numeric>

#include "library/snapshot.h"
#include "tests/metamorphic/maps.h"
#include "tests/metamorphic/relations.h"
#include "voroproof/error.h"
#include "voroproof/queries.h"

namespace voroproof::internal::metamorphic {
namespace {

using adversary::Random;
using testing::Image;
using testing::RecordedRun;

Image linear(const Rational& xx, const Rational& xy, const Rational& yx, const Rational& yy) {
  Image image;
  image.xx = xx;
  image.xy = xy;
  image.yx = yx;
  image.yy = yy;
  return image;
}

std::optional<Image> random_image(const World& world, Relation relation, Random& random) {
  switch (relation) {
    case Relation::units:
      return random_units(world.scene, static_cast<std::uint64_t>(random.integer(1, 1 << 30)));
    case Relation::relabelled: {
      Image image;
      image.ids.resize(world.scene.disks.size());
      std::iota(image.ids.begin(), image.ids.end(), 0);
      for (int k = static_cast<int>(image.ids.size()) - 1; k > 0; --k) {
        std::swap(image.ids[static_cast<std::size_t>(k)],
                  image.ids[static_cast<std::size_t>(random.integer(0, k))]);
      }
      return image;
    }
    case Relation::mirrored:
      return random.chance(0.5) ? linear(-1, 0, 0, 1) : linear(0, 1, 1, 0);
    case Relation::quarter_turn:
      return random.chance(0.5) ? linear(0, -1, 1, 0) : linear(-1, 0, 0, -1);
    case Relation::pythagorean_turn:
      return linear({3, 5}, {-4, 5}, {4, 5}, {3, 5});
    case Relation::translated: {
      Image image;
      const int far = random.chance(0.3) ? random.integer(60, 100) : random.integer(0, 60);
      const Rational unit = units_image(far - 20, 0).length;
      image.dx = random.integer(-(1 << 20), 1 << 20) * unit;
      image.dy = random.integer(-(1 << 20), 1 << 20) * unit;
      return image;
    }
    default:
      return std::nullopt;
  }
}

bool has_distinct_times(const RecordedRun& run) {
  double last = 0;
  for (const testing::Event& e : run.events) {
    if (!(e.t > last)) return false;
    last = e.t;
  }
  return true;
}

// Whether nothing depends on how ties are broken.
bool is_generic(const World& world, const RecordedRun& run) {
  return world.generic && has_distinct_times(run);
}

std::string run_difference(const World& world, const Run& run, const Image& image,
                           const Run& image_run) {
  if (run.outcome.kind != image_run.outcome.kind) {
    return std::string(name_of(run.outcome.kind)) + " (" + run.outcome.reason + ") and " +
           name_of(image_run.outcome.kind) + " (" + image_run.outcome.reason + ")";
  }
  if (!run.complete()) return "";
  const bool isometry = image.length == 1 && image.time == 1 && image.ids.empty();
  if (isometry) return testing::difference_from_image(world.scene, run, image, image_run);
  if (!image.ids.empty() && !is_generic(world, run)) return "";
  return testing::difference(image_of(run, image), image_run);
}

std::pair<GenId, GenId> contact_image(const std::pair<GenId, GenId>& pair, const Image& image) {
  return std::minmax({image.id(pair.first), image.id(pair.second)});
}

// How much of two refutations must be the same where ties may be broken otherwise: in other units
// the line, as which of several missing events of an instant is named depends on enclosures.
enum class Same { all, line, verdict };

bool are_same(const Answer& ours, const Image& image, const Answer& theirs, Same same) {
  if (ours.verdict == "endless" || theirs.verdict == "endless") {
    return true;  // one takes too long: nothing is known
  }
  if (ours.verdict != theirs.verdict) return false;
  if (same == Same::verdict || ours.verdict != "refuted") return true;
  if (ours.line != theirs.line) return false;
  // An order within the tolerance that enclosures leave open is the file's. So it depends on them
  // which claim is judged first, and which of two faults of one line is met.
  if (ours.fault != theirs.fault) return ours.swapped && theirs.swapped;
  if (same == Same::line) return true;
  if (ours.flip.has_value() != theirs.flip.has_value() ||
      ours.contact.has_value() != theirs.contact.has_value()) {
    return false;
  }
  return (!ours.flip || image.edge(*ours.flip) == canonical(*theirs.flip)) &&
         (!ours.contact ||
          contact_image(*ours.contact, image) == contact_image(*theirs.contact, {}));
}

// Whether roundings may tell the two apart, which do not go with the map. A pair's rounding grows
// with the distance of the scene from its origin (docs/claim.md). Velocities that a history lacks
// are rounded along the axes, so a rotation may break ties.
bool are_excused(Relation relation, const Answer& a, const Answer& b) {
  const auto any = [&](auto&& is) { return is(a) || is(b); };
  if (relation == Relation::pythagorean_turn) {
    return any([](const Answer& x) { return x.velocities_by_law; });
  }
  return relation == Relation::translated && any([](const Answer& x) {
           return x.fault == Fault::wrong_response || x.fault == Fault::overlap ||
                  x.contacts_by_rounding || x.reason.starts_with("a generator lay inside another");
         });
}

// The pairs of generators and of disks that are nearest to each other.
std::vector<std::pair<int, int>> nearest_pairs(const Scene& scene, const Rational& t) {
  voroproof::Instant instant(voroproof::parse_scene(testing::text(scene)),
                             voroproof::Number(t.get_str()), budget().bits);
  auto pairs = instant.closest_generators().pairs;
  const auto disks = instant.closest_disks().pairs;
  pairs.insert(pairs.end(), disks.begin(), disks.end());
  return pairs;
}

// All coordinates in their order.
std::vector<double> coordinates(const DiagramFile& d) {
  std::vector<double> all{d.container_center[0], d.container_center[1], d.container_radius};
  for (const DiagramDisk& disk : d.disks) {
    all.insert(all.end(), {disk.center[0], disk.center[1], disk.radius});
  }
  for (const DiagramVertex& v : d.vertices) {
    all.insert(all.end(), {v.center[0], v.center[1], v.radius});
  }
  return all;
}

std::string diagram_difference(const DiagramFile& ours, const Image& image,
                               const DiagramFile& theirs) {
  std::vector<Quad> edges;
  for (const Quad& q : ours.edges) edges.push_back(image.edge(q));
  std::sort(edges.begin(), edges.end());
  if (edges != theirs.edges) return "edges";
  if (image.length == 1) return "";
  const auto a = coordinates(ours), b = coordinates(theirs);
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (round_nearest(to_rational(a[k]) * image.length) != b[k]) return "coordinates";
  }
  return "";
}

// What is asked of a moment.
struct MomentAnswer {
  DiagramFile diagram;
  std::vector<std::pair<int, int>> nearest;
  std::string left_open{};  // which predicate, where one is
};

MomentAnswer at_moment(const Scene& scene, const Rational& t) {
  EngineOptions options;
  options.motion.max_bits = budget().bits;
  try {
    return MomentAnswer{snapshot(scene, t, options), nearest_pairs(scene, t)};
  } catch (const voroproof::Undecided& e) {  // of the library
    return {{}, {}, e.what()};
  } catch (const internal::Undecided& e) {
    return {{}, {}, e.what()};
  }
}

std::string moment_difference(const MomentAnswer& ours, const Image& image,
                              const MomentAnswer& theirs) {
  if (ours.left_open.empty() != theirs.left_open.empty()) return "one is left open";
  if (!ours.left_open.empty()) return "";
  const std::string difference = diagram_difference(ours.diagram, image, theirs.diagram);
  if (!difference.empty()) return difference;
  return ours.nearest == theirs.nearest ? "" : "nearest pairs";
}

}  // namespace

Comparison compare_image(const World& world, Relation relation) {
  Random random = random_for(world, relation);
  const auto image = random_image(world, relation, random);
  auto scene = image ? read_again(testing::image_of(world.scene, *image)) : std::nullopt;
  if (!scene) return {};
  Case ours{world.scene, {}, world.tolerance};
  Case theirs{std::move(*scene), {}, world.tolerance * image->time};
  const Run run = simulated(ours.scene), image_run = simulated(theirs.scene);
  if (run.endless() || image_run.endless()) return {};
  const std::string difference = run_difference(world, run, *image, image_run);
  if (!difference.empty()) {
    return {true, told("simulate: " + difference, ours, run, theirs, image_run)};
  }
  if (!run.complete() && !world.claim) return {true};
  ours.claim = claim_of(world, run);
  theirs.claim = image_of(*ours.claim, *image);
  const Same same = is_generic(world, run)        ? Same::all
                    : relation == Relation::units ? Same::line
                                                  : Same::verdict;
  // The order of ids decides what comes of collisions of one instant.
  if (!image->ids.empty() && !is_generic(world, run)) {
    if (!run.complete() || !image_run.complete()) return {true};
    return {true, own_verdicts(ours, run, theirs, image_run)};
  }
  for (const Truth truth : both_truths) {
    const Answer a = certified(ours, truth), b = certified(theirs, truth);
    if (are_same(a, *image, b, same) || are_excused(relation, a, b)) continue;
    // Where the scene itself comes to an end, one may see a fault that the other does not come to.
    if (!run.complete() && (a.verdict == "undecided" || b.verdict == "undecided")) continue;
    ours.answer = text(a);
    theirs.answer = text(b);
    return {true, Contradiction{"certify, " + std::string(name_of(truth)), ours, theirs}};
  }
  return {true};
}

Comparison compare_moment(const World& world) {
  Random random = random_for(world, Relation::moment);
  const Relation maps[] = {Relation::units, Relation::mirrored, Relation::quarter_turn,
                           Relation::translated};
  const Relation relation = maps[random.integer(0, 3)];
  const auto image = random_image(world, relation, random);
  auto scene = image ? read_again(testing::image_of(world.scene, *image)) : std::nullopt;
  if (!scene) return {};
  Case ours{world.scene, {}, world.tolerance}, theirs{std::move(*scene), {}, {}};
  const RecordedRun run = simulated(ours.scene);
  if (!run.complete()) return {};
  Rational t = world.scene.horizon * Rational(random.integer(0, 64), 64);
  if (!run.events.empty() && random.chance(0.5)) {
    const auto last = static_cast<int>(run.events.size()) - 1;
    t = to_rational(run.events[static_cast<std::size_t>(random.integer(0, last))].t);
  }
  const MomentAnswer answer = at_moment(ours.scene, t);
  const MomentAnswer image_answer = at_moment(theirs.scene, t * image->time);
  const std::string difference = moment_difference(answer, *image, image_answer);
  if (difference.empty()) return {answer.left_open.empty()};
  ours.answer = answer.left_open;
  theirs.answer = image_answer.left_open;
  return {true, Contradiction{"the diagram at " + t.get_str() + ": " + difference, ours, theirs}};
}

}  // namespace voroproof::internal::metamorphic
