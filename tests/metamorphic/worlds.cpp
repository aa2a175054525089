#include "tests/metamorphic/worlds.h"

#include <algorithm>
#include <utility>

#include "history/error.h"
#include "tests/adversary/campaign.h"
#include "tests/metamorphic/scenes.h"

namespace voroproof::internal::metamorphic {
namespace {

using adversary::Random;
using testing::Mutation;

// Whether two things happen at one instant by design.
bool is_generic(adversary::Family family) {
  return adversary::in_general_position(family) && family != adversary::Family::touch_maneuver;
}

std::optional<World> wrong_world(std::uint64_t seed, adversary::Family family) {
  adversary::Recipe recipe = adversary::recipe_of(seed, family, {});
  recipe.units = {};
  const auto made = adversary::make(recipe);
  const auto scene = made ? adversary::read(*made) : std::nullopt;
  if (!scene) return std::nullopt;
  World world;
  world.generic = is_generic(family);
  world.scene = scene->scene;
  world.claim = adversary::claimed(*scene, made->history);
  return world;
}

// The scene with its maneuvers as scenes have them: in their order of time, and of a disk no more
// than one at a time.
Scene in_order(Scene scene) {
  auto& all = scene.maneuvers;
  const auto key = [](const Maneuver& m) { return std::pair(m.t, m.disk); };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Maneuver& a, const Maneuver& b) { return key(a) < key(b); });
  const auto same = [&](const Maneuver& a, const Maneuver& b) { return key(a) == key(b); };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return scene;
}

std::optional<World> rational_world(const SceneFamily& family, Random& random) {
  const Scene scene = in_order(family.make(random));
  auto read = scene.disks.size() < 2 ? std::nullopt : read_again(scene);
  if (!read) return std::nullopt;
  World world;
  world.generic = family.generic;
  world.scene = std::move(*read);
  // One that tells times apart.
  while (world.tolerance * 1000 > world.scene.horizon) world.tolerance /= 1024;
  if (random.chance(0.6)) {
    world.mutation =
        static_cast<Mutation>(random.integer(0, static_cast<int>(Mutation::count) - 1));
  }
  return world;
}

}  // namespace

std::vector<std::string> world_families() {
  std::vector<std::string> names;
  for (const auto name : adversary::family_names) names.emplace_back(name);
  for (const SceneFamily& family : scene_families()) names.emplace_back(family.name);
  return names;
}

std::optional<World> world_of(std::uint64_t seed, const std::string& wanted) {
  Random random(seed * 0x9e3779b97f4a7c15u + 5);
  const auto names = world_families();
  const auto wrong = adversary::family_names.size() - 1, all = names.size();
  // Half of them of each kind; the last family of wrong worlds has large scenes.
  const auto rational = static_cast<int>(all - adversary::family_names.size());
  std::size_t k = random.chance(0.5)
                      ? static_cast<std::size_t>(random.integer(0, static_cast<int>(wrong) - 1))
                      : all - static_cast<std::size_t>(random.integer(1, rational));
  if (!wanted.empty()) {
    k = static_cast<std::size_t>(std::find(names.begin(), names.end(), wanted) - names.begin());
  }
  auto world = k < adversary::family_names.size()
                   ? wrong_world(seed, static_cast<adversary::Family>(k))
                   : rational_world(scene_families()[k - adversary::family_names.size()], random);
  if (!world) return std::nullopt;
  world->family = names[k];
  world->seed = seed;
  return world;
}

testing::Image units_image(int length, int time) {
  testing::Image image;
  image.xx = image.yy = image.length = power_of_two(length);
  image.time = power_of_two(time);
  return image;
}

std::optional<Scene> read_again(const Scene& scene) {
  try {
    return parse_scene(testing::text(scene), "scene");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<testing::Image> random_units(const Scene& scene, std::uint64_t seed) {
  Random random(seed);
  auto [length, time] = adversary::random_units(random);
  for (; length != 0 || time != 0; length /= 2, time /= 2) {
    const auto image = units_image(length, time);
    if (read_again(testing::image_of(scene, image))) return image;
  }
  return std::nullopt;
}

}  // namespace voroproof::internal::metamorphic
