// Finds made small: fewer disks, fewer lines, simpler faults, as long as they stay finds.
#include <cmath>

#include "tests/adversary/campaign.h"

namespace voroproof::internal::adversary {
namespace {

bool is_still(const Made& made, Truth truth, Find find) {
  const auto scene = read(made);
  return scene && find_of(judge_all(*scene, made, truth, true, true)) == find;
}

SceneData without(const SceneData& scene, int disk) {
  SceneData s = scene;
  s.disks.erase(s.disks.begin() + disk);
  s.maneuvers.clear();
  for (ManeuverData m : scene.maneuvers) {
    if (m.disk == disk) continue;
    if (m.disk > disk) --m.disk;
    s.maneuvers.push_back(m);
  }
  return s;
}

// Where the k-th event was meant, another may be now.
bool take_smaller(Made& made, const SceneData& scene, Truth truth, Find find) {
  for (int nth = 0; nth <= made.recipe.fault.nth; ++nth) {
    Recipe recipe = made.recipe;
    recipe.fault.nth = nth;
    const auto smaller = make(recipe, scene);
    if (!smaller || !is_still(*smaller, truth, find)) continue;
    made = *smaller;
    return true;
  }
  return false;
}

// Leaves nothing after line k, and puts the horizon between it and the next.
bool cut_after(Made& made, std::size_t k, Truth truth, Find find) {
  Made cut = made;
  const auto& lines = made.history.lines;
  const double last = k == 0 ? 0 : lines[k - 1].t;
  if (!(last < lines[k].t)) return false;
  cut.history.horizon = cut.scene.horizon = last + (lines[k].t - last) / 2;
  cut.history.lines.resize(k);
  if (!is_still(cut, truth, find)) return false;
  made = cut;
  return true;
}

}  // namespace

Made minimized(const Made& found, Truth truth, Find find) {
  Made made = found;
  // A fuzzed history is another one where the scene changes.
  if (!made.recipe.fuzzed) {
    for (int disk = 0; disk < made.scene.size();) {
      if (made.scene.size() > 2 && take_smaller(made, without(made.scene, disk), truth, find)) {
        disk = 0;
      } else {
        ++disk;
      }
    }
    for (std::size_t k = 0; k < made.scene.maneuvers.size();) {
      SceneData fewer = made.scene;
      fewer.maneuvers.erase(fewer.maneuvers.begin() + static_cast<std::ptrdiff_t>(k));
      if (!take_smaller(made, fewer, truth, find)) ++k;
    }
    Recipe simple = made.recipe;
    const double unit =
        std::pow(10, std::floor(std::log10(std::fabs(simple.fault.amount) + 1e-99)));
    simple.fault.amount = std::round(simple.fault.amount / unit) * unit;
    const auto simpler = make(simple, made.scene);
    if (simpler && is_still(*simpler, truth, find)) made = *simpler;
  }
  for (std::size_t k = 0; k < made.history.lines.size(); ++k) {
    if (cut_after(made, k, truth, find)) break;
  }
  return made;
}

}  // namespace voroproof::internal::adversary
