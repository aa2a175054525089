#include "tests/support/formation_scene.h"

#include "corpus/generate.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

Scene scene_of(const FormationScene& formation) {
  FormationOptions options;
  options.n = formation.n;
  options.flight = formation.flight;
  options.horizon = 8 * static_cast<double>(formation.flight.size());
  return generate_formation(options);
}

void showValue(const FormationScene& formation, std::ostream& out) {
  out << text(scene_of(formation));
}

rc::Gen<FormationScene> formation_scenes(int max_disks) {
  const auto formation =
      rc::gen::element<std::string>("square", "staggered", "frame", "circle", "rings", "h", "y");
  const auto step =
      rc::gen::element<std::string>("square", "staggered", "frame", "circle", "rings", "h", "y",
                                    "east", "north", "west", "turn", "shear", "spread", "rest");
  const auto flight = rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, 4), [=](std::size_t steps) {
    return rc::gen::map(
        rc::gen::pair(formation, rc::gen::container<std::vector<std::string>>(steps, step)),
        [](std::pair<std::string, std::vector<std::string>> parts) {
          parts.second.insert(parts.second.begin(), parts.first);
          return parts.second;
        });
  });
  return rc::gen::construct<FormationScene>(
      rc::gen::resize(rc::kNominalSize, rc::gen::inRange(2, max_disks + 1)), flight);
}

}  // namespace voroproof::internal::testing
