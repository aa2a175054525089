#include "tests/adversary/campaign.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/adversary/wrong_world.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::adversary {
namespace {

constexpr std::size_t most_lines = 60, most_lines_of_large = 300;

// What a family is for, besides all faults.
std::optional<FaultKind> favourite(Family family, Random& random) {
  const auto one_of = [&](std::initializer_list<FaultKind> kinds) {
    return *(kinds.begin() + random.integer(0, static_cast<int>(kinds.size()) - 1));
  };
  switch (family) {
    case Family::tiny:
    case Family::tiny_fast:
      return one_of({FaultKind::miss_collision, FaultKind::miss_several, FaultKind::late_collision,
                     FaultKind::early_collision, FaultKind::false_collision});
    case Family::near_miss:
      return FaultKind::false_collision;
    case Family::stranger:
      return one_of({FaultKind::stranger_velocity, FaultKind::restitution, FaultKind::old_normal,
                     FaultKind::masses_exchanged});
    case Family::lattice:
    case Family::touching:
      return one_of({FaultKind::miss_at_start, FaultKind::late_at_start, FaultKind::miss_collision,
                     FaultKind::twice_collision});
    case Family::mirror:
      return one_of({FaultKind::miss_collision, FaultKind::other_edge, FaultKind::shadow_flip});
    case Family::touch_maneuver:
      return one_of({FaultKind::miss_at_maneuver, FaultKind::late_maneuver,
                     FaultKind::forget_maneuver, FaultKind::silent_maneuver});
    case Family::maneuvers:
      return one_of({FaultKind::forget_maneuver, FaultKind::silent_maneuver,
                     FaultKind::late_maneuver, FaultKind::early_maneuver,
                     FaultKind::twice_maneuver});
    case Family::horizon_touch:
      return one_of({FaultKind::collision_at_end, FaultKind::miss_collision});
    case Family::inelastic:
      return one_of({FaultKind::twice_collision, FaultKind::restitution, FaultKind::mass});
    case Family::round:
      return one_of({FaultKind::miss_flip, FaultKind::silent_maneuver, FaultKind::early_maneuver});
    default:
      return std::nullopt;
  }
}

Fault fault_of(FaultKind kind, Random& random) {
  Fault f{.kind = kind, .nth = random.integer(0, random.chance(0.5) ? 1 : 6)};
  switch (kind) {
    case FaultKind::restitution:
    case FaultKind::mass:
    case FaultKind::radius:
      f.amount = random.log_uniform(1e-10, 0.3) * (random.chance(0.5) ? 1 : -1);
      break;
    case FaultKind::stranger_velocity:
      f.amount = random.log_uniform(1e-8, 3);
      break;
    case FaultKind::false_collision:
      f.amount = random.log_uniform(1e-8, 1);
      break;
    case FaultKind::miss_at_start:
    case FaultKind::miss_at_maneuver:
      f.nth = random.integer(0, 1);
      break;
    case FaultKind::late_at_start:
      f.amount = random.uniform(0.01, 1.2) * tolerance;
      break;
    case FaultKind::wrong_initial:
      f.nth = random.integer(0, 1000);
      f.amount = random.integer(0, 2);
      break;
    case FaultKind::miss_several:
      f.nth = random.integer(0, 30);
      break;
    case FaultKind::all_late:
    case FaultKind::all_flips_late:
      f.amount = random.chance(0.7) ? random.uniform(0.3, 0.99) * tolerance
                                    : random.log_uniform(tolerance, 1e-3);
      break;
    default:
      f.amount = random.chance(0.3) ? random.log_uniform(1e-9, 1.2 * tolerance)
                                    : random.log_uniform(1.2 * tolerance, 0.3);
      break;
  }
  return f;
}

// Nearer to the usual units until all values are in range.
void fit(Made& made) {
  Units& units = made.recipe.units;
  // A tolerance beyond the horizon is refused, but for the usual one.
  if (made.history.horizon < tolerance) units = {};
  while ((units.length != 0 || units.time != 0) && !read(made)) {
    units = {units.length / 2, units.time / 2};
  }
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// What the exact engine writes; nothing where it stops early.
std::optional<History> engine_history(const SceneData& scene) {
  const auto input = read(scene);
  if (!input) return std::nullopt;
  const testing::RecordedRun r = testing::run(input->scene);
  if (!r.complete()) return std::nullopt;
  History h;
  h.horizon = scene.horizon;
  const auto edge = [](const Quad& q) { return Edge{q.l, q.r, q.s, q.e}; };
  for (const Quad& q : r.initial) h.initial.push_back(edge(q));
  for (const testing::Event& e : r.events) {
    using From = testing::Event::Kind;
    const auto kind = e.kind == From::flip        ? Line::Kind::flip
                      : e.kind == From::collision ? Line::Kind::collide
                                                  : Line::Kind::maneuver;
    const RoundedState& last = kind == Line::Kind::maneuver ? e.first : e.second;
    h.lines.push_back({.kind = kind,
                       .t = e.t,
                       .edge = edge(e.edge),
                       .i = e.i,
                       .j = e.j,
                       .v = {Pair2{e.first.vx, e.first.vy}, Pair2{last.vx, last.vy}},
                       .p = {Pair2{e.first.px, e.first.py}, Pair2{last.px, last.py}}});
  }
  return h;
}

// A kind of reason: without its numbers.
std::string words(const std::string& reason) {
  std::string w;
  for (const char c : reason) {
    if (c >= '0' && c <= '9') {
      if (w.empty() || w.back() != '#') w += '#';
    } else {
      w += c;
    }
  }
  return w.substr(0, 90);
}

// Whether all velocities and centres are numbers: two points that collide have no normal.
bool has_numbers(const History& h) {
  return std::all_of(h.lines.begin(), h.lines.end(), [](const Line& line) {
    double sum = 0;
    for (const std::size_t side : {0, 1}) {
      sum += line.v[side][0] + line.v[side][1] + line.p[side][0] + line.p[side][1];
    }
    return std::isfinite(sum);
  });
}

void count(Count& c, const Judgement& j) {
  ++c.certifier[static_cast<std::size_t>(j.certifier.verdict)];
  ++c.kernel[static_cast<std::size_t>(j.kernel.verdict)];
  if (j.opinion) {
    c.oracle_right += j.opinion->finding == Finding::right;
    c.oracle_wrong += j.opinion->finding == Finding::wrong;
    c.oracle_unclear += j.opinion->finding == Finding::unclear;
  }
  ++c.finds[static_cast<std::size_t>(find_of(j))];
  ++c.made;
}

}  // namespace

Units random_units(Random& random) {
  const int most = std::ilogb(max_scene_value);
  if (random.chance(0.5)) return {-random.integer(most / 3, most), -random.integer(most / 3, most)};
  const int length = random.integer(-most, most), time = random.integer(-most, most);
  const Units units[] = {{length, time}, {length, length}, {length, 0}, {0, time}};
  return units[random.integer(0, 3)];
}

Recipe recipe_of(std::uint64_t seed, std::optional<Family> family, std::optional<FaultKind> fault) {
  Random random(seed * 0x9e3779b97f4a7c15u + 1);
  Recipe r{.seed = seed};
  const int families = static_cast<int>(Family::count);
  // A large scene, the last family, now and then.
  r.family = static_cast<Family>(random.integer(0, families - 2));
  if (random.chance(0.003)) r.family = Family::large;
  if (family) r.family = *family;
  FaultKind kind = FaultKind::none;
  if (random.chance(0.7)) {
    kind = static_cast<FaultKind>(random.integer(1, static_cast<int>(FaultKind::count) - 1));
    const auto other = favourite(r.family, random);
    if (other && random.chance(0.5)) kind = *other;
  }
  if (fault) kind = *fault;
  r.fault = fault_of(kind, random);
  r.fuzzed = !fault && random.chance(kind == FaultKind::none ? 0.4 : 0.1);
  if (!r.fuzzed && random.chance(kind == FaultKind::none ? 0.5 : 0.1)) {
    r.rewriting = static_cast<Rewriting>(random.integer(1, static_cast<int>(Rewriting::count) - 1));
  }
  r.long_decimals = random.chance(0.2);
  r.centres = random.chance(0.75);
  r.velocities = random.chance(0.9);
  r.by_engine =
      kind == FaultKind::none && random.chance(in_general_position(r.family) ? 0.05 : 0.7);
  if (random.chance(0.25)) r.units = random_units(random);
  return r;
}

std::optional<Made> make(const Recipe& recipe) {
  Random random(recipe.seed * 0xda942042e4dd58b5u + 7);
  return make(recipe, scene_of(recipe.family, random));
}

std::optional<Made> make(const Recipe& recipe, SceneData scene) {
  if (scene.size() < 2) return std::nullopt;
  Made made{recipe, std::move(scene), {}, {}, false};
  auto result = live(made.scene, recipe.fault,
                     recipe.family == Family::large ? most_lines_of_large : most_lines);
  if (!result) return std::nullopt;
  made.struck = result->struck;
  if (recipe.fault.kind != FaultKind::none && !made.struck) return std::nullopt;
  if (!has_numbers(result->history)) return std::nullopt;
  made.history = std::move(result->history);
  made.hints = std::move(result->hints);
  if (recipe.by_engine) {
    auto written = engine_history(made.scene);
    if (!written) return std::nullopt;
    made.history = std::move(*written);
  }
  made.history.centres = recipe.centres;
  made.history.velocities = recipe.velocities;
  Random random(recipe.seed * 0xc2b2ae3d27d4eb4fu + 11);
  rewrite(made.history, recipe.rewriting, random);
  if (recipe.fuzzed) fuzz(made.history, random);
  fit(made);
  return made;
}

std::optional<ReadScene> read(const Made& made) {
  return read(in_units(made.scene, made.recipe.units));
}

std::string kind_of(const Recipe& recipe) {
  if (recipe.fuzzed) return "fuzzed";
  if (recipe.fault.kind == FaultKind::none && recipe.rewriting != Rewriting::none) {
    return "rewritten";
  }
  return std::string(name(recipe.fault.kind));
}

Judgement judge_all(const ReadScene& scene, const Made& made, Truth truth, bool always_oracle,
                    bool with_kernel) {
  const Units& units = made.recipe.units;
  Judgement j = judge(scene, in_units(made.history, units), truth,
                      {made.recipe.long_decimals, with_kernel, tolerance_in(units)});
  if (j.certifier.when) j.certifier.when = std::ldexp(*j.certifier.when, -units.time);
  const bool meant_right = made.recipe.fault.kind == FaultKind::none && !made.recipe.fuzzed;
  const Verdict c = j.certifier.verdict, k = j.kernel.verdict;
  const bool stands = c != Verdict::refuted || k == Verdict::certified;
  if (always_oracle || meant_right || stands) {
    ask_oracle(j, made.scene, made.history, truth, made.hints);
    // Where ties last or rounding breaks them, flips may be due and undone between all samples.
    const bool by_engine = made.recipe.by_engine && truth == Truth::exact;
    if (j.opinion->finding == Finding::right && !in_general_position(made.recipe.family) &&
        !by_engine) {
      j.opinion = {Finding::unclear, "a scene with ties"};
    }
  }
  return j;
}

void Campaign::run(std::uint64_t seed, std::optional<Family> family, std::optional<FaultKind> fault,
                   const std::function<void(const Made&, Truth, const Judgement&)>& judged) {
  const double start = now();
  const auto made = make(recipe_of(seed, family, fault));
  const auto scene = made ? read(*made) : std::nullopt;
  seconds_[0] += now() - start;
  if (!scene) return;
  ++histories_;
  for (const Truth truth : truths) {
    const double before = now();
    const Judgement j = judge_all(*scene, *made, truth, all_, seed % kernel_every_ == 0);
    seconds_[1] += now() - before;
    count(by_kind_[{kind_of(made->recipe), static_cast<int>(truth)}], j);
    count(by_family_[{std::string(name(made->recipe.family)), static_cast<int>(truth)}], j);
    if (j.certifier.verdict == Verdict::undecided) {
      ++undecided_["certifier, " + std::string(name(truth)) + ": " + words(j.certifier.reason)];
    }
    if (j.kernel.verdict == Verdict::undecided) {
      ++undecided_["kernel, " + std::string(name(truth)) + ": " + words(j.kernel.reason)];
    }
    judged(*made, truth, j);
  }
}

}  // namespace voroproof::internal::adversary
