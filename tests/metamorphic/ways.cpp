// The same question by another way: other spelling, other precision, other programs.
#include <cstdio>

#include "history/error.h"
#include "tests/fuzz/memory_file.h"
#include "tests/metamorphic/maps.h"
#include "tests/metamorphic/relations.h"

namespace voroproof::internal::metamorphic {
namespace {

using adversary::Random;
using testing::RecordedRun;

std::string hexadecimal(double x) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%a", x);
  return text.data();
}

// The decimal that denotes p / q; empty where it has too many digits.
std::string decimal(const Rational& x) {
  Integer q = x.get_den();
  int places = 0;
  for (; q != 1 && places < 300; ++places) {
    const Integer divisor = gcd(q, Integer(10));
    if (divisor == 1) return "";
    q /= divisor;
  }
  if (q != 1) return "";
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(places));
  return Rational(x * power).get_str() + (places == 0 ? "" : "e-" + std::to_string(places));
}

// One of the ways in which the number may be written (docs/formats.md, section 1).
std::string spelled(const Rational& x, Random& random) {
  const double nearest = round_nearest(x);
  const bool is_double = to_rational(nearest) == x;
  const auto quoted = [](const std::string& s) { return '"' + s + '"'; };
  switch (random.integer(0, 3)) {
    case 0:
      if (is_double) return quoted(hexadecimal(nearest));
      break;
    case 1:
      if (const std::string text = decimal(x); !text.empty()) return quoted(text);
      break;
    case 2:
      if (is_double && nearest != 0) {
        std::array<char, 64> text;
        std::snprintf(text.data(), text.size(), "%.20e", nearest);
        return text.data();
      }
      break;
    default:
      break;
  }
  const int factor = random.integer(1, 9);
  const Integer p = x.get_num() * factor, q = x.get_den() * factor;
  return quoted(p.get_str() + "/" + q.get_str());
}

std::string spelled(const Rational& x, const Rational& y, Random& random) {
  const std::string first = spelled(x, random);
  return "[" + first + ", " + spelled(y, random) + "]";
}

std::string spelled(const Scene& s, Random& random) {
  std::string out = "{\"disks\": [";
  const char* separator = "";
  for (const DiskInput& d : s.disks) {
    out += separator + ("{\"mass\": " + spelled(d.mass, random));
    out += ", \"velocity\": " + spelled(d.vx, d.vy, random);
    out += ", \"radius\": " + spelled(d.radius, random);
    out += ", \"center\": " + spelled(d.x, d.y, random) + "}";
    separator = ",\n";
  }
  out += "], \"maneuvers\": [";
  separator = "";
  for (const Maneuver& m : s.maneuvers) {
    out += separator + ("{\"velocity\": " + spelled(m.vx, m.vy, random));
    out += ", \"disk\": " + std::to_string(m.disk) + ", \"t\": " + spelled(m.t, random) + "}";
    separator = ",\n";
  }
  out += "], \"horizon\": " + spelled(s.horizon, random);
  out += ", \"restitution\": " + spelled(s.restitution, random);
  out += s.law == ContainerLaw::whole ? ", \"container_law\": \"whole\"" : "";
  out += ", \"container\": {\"center\": " + spelled(s.cx, s.cy, random);
  out += ", \"restitution\": " + spelled(s.container_restitution, random);
  out += ", \"radius\": " + spelled(s.container_radius, random);
  return out + "}, \"version\": 1, \"format\": \"voroproof-scene\"}\n";
}

// The engine's options for one of its other ways.
std::pair<std::string, EngineOptions> other_options(Random& random) {
  EngineOptions options;
  switch (random.integer(0, 2)) {
    case 0:
      options.motion.filters = false;
      return {"without filters", options};
    case 1:
      options.motion.start_bits = random.chance(0.5) ? 64 : 1024;
      return {std::to_string(options.motion.start_bits) + " bits to begin with", options};
    default:
      options.threads = 2;
      options.least_sliced = 1;
      options.slice_hooks.work = [](int) { return std::uint64_t{16}; };
      return {"two threads", options};
  }
}

Contradiction told(const std::string& what, const Case& ours, const std::string& a,
                   const std::string& b) {
  Case first = ours, second = ours;
  first.answer = a;
  second.answer = b;
  return {what, first, second};
}

}  // namespace

Comparison compare_spelling(const World& world) {
  Random random = random_for(world, Relation::other_spelling);
  const std::string text = spelled(world.scene, random);
  const Case ours{world.scene, {}, world.tolerance};
  try {
    Scene read = parse_scene(text, "scene");
    read.name = world.scene.name;
    read.comment = world.scene.comment;
    read.seed = world.scene.seed;
    if (testing::text(read) == testing::text(world.scene)) return {true};
    return {true, Contradiction{"the scene that is read", ours, Case{read, {}, world.tolerance}}};
  } catch (const InputError& error) {
    return {true, told("the scene is refused: " + text, ours, "", error.what())};
  }
}

Comparison compare_ways(const World& world) {
  Random random = random_for(world, Relation::other_ways);
  Case ours{world.scene, {}, world.tolerance};
  const RecordedRun run = simulated(ours.scene);
  const auto [way, options] = other_options(random);
  const Run other = simulated(ours.scene, options);
  // Other ways may take longer, and have no limit of their own.
  if (!run.complete() || other.endless()) return {};
  std::string difference = testing::difference(run, other);
  if (!difference.empty()) {
    return {true, told("simulate, " + way + ": " + difference, ours, run.outcome.reason,
                       other.outcome.reason)};
  }
  if (!run.events.empty()) {
    const auto last = static_cast<int>(run.events.size()) - 1;
    const auto begun = static_cast<std::size_t>(random.integer(0, last));
    std::size_t kept = 0;
    EngineOptions bounded;
    bounded.motion.max_bits = budget().bits;
    bounded.motion.max_radicals = budget().radicals;
    const auto keeping = begun % 2 == 0 ? testing::Keeping::asked_for : testing::Keeping::at_end;
    difference =
        testing::difference(run, testing::resume(ours.scene, begun, bounded, keeping, kept));
    if (!difference.empty()) {
      return {true, told("resumed: " + difference, ours, "", "after " + std::to_string(kept))};
    }
  }
  ours.claim = claim_of(world, run);
  CertifyOptions judged;
  judged.motion.filters = random.chance(0.5);
  judged.motion.start_bits = random.chance(0.5) ? 64 : 512;
  judged.threads = random.integer(1, 2);
  // Where a part ends everything is proved up to there, and the first fault may be seen so.
  const bool in_parts = random.chance(0.5);
  if (in_parts) judged.least_part = 2;
  for (const Truth truth : both_truths) {
    const Answer a = certified(ours, truth), b = certified(ours, truth, judged);
    if (a.verdict == "endless" || b.verdict == "endless") continue;
    const bool same_fault = a.line == b.line && a.fault == b.fault;
    if (a.verdict == b.verdict && (in_parts || same_fault)) continue;
    return {true,
            told("certify another way, " + std::string(name_of(truth)), ours, text(a), text(b))};
  }
  return {true};
}

Comparison compare_certified(const World& world) {
  Case ours{world.scene, {}, world.tolerance};
  const RecordedRun run = simulated(ours.scene);
  if (!run.complete()) return {};
  ours.claim = testing::claimed_history(ours.scene, run);
  for (const Truth truth : both_truths) {
    const Answer a = certified(ours, truth);
    if (refused_for_rounding(a, truth, run)) continue;
    if (a.verdict == "certified" || a.verdict == "endless") continue;
    return {true, told("the engine's own history, " + std::string(name_of(truth)), ours,
                       "certified", text(a))};
  }
  return {true};
}

Comparison compare_kernel(const World& world) {
  Case ours{world.scene, {}, world.tolerance};
  const RecordedRun run = simulated(ours.scene);
  if (!run.complete() && !world.claim) return {};
  ours.claim = claim_of(world, run);
  for (const Truth truth : both_truths) {
    const std::string theirs = kernel_verdict(ours, truth);
    if (theirs == "absent") return {};
    // The kernel leaves open what takes irrational numbers.
    if (theirs == "undecided") continue;
    const Answer a = certified(ours, truth);
    if (a.verdict == theirs || a.verdict == "endless") continue;
    // It may see a fault beyond the place where the other stops, and knows another proof after a
    // hidden moment.
    if (a.verdict == "undecided" && (theirs == "refuted" || a.hidden)) continue;
    return {true, told("kernel, " + std::string(name_of(truth)), ours, text(a), theirs)};
  }
  return {true};
}

}  // namespace voroproof::internal::metamorphic
