#include "voroproof/generators.h"

#include "corpus/generate.h"
#include "library/values.h"
#include "voroproof/error.h"

namespace voroproof {
namespace {

// Generators give scenes without a file: their identity is that of what would be written.
template <class Make>
Scene made(Make&& make) {
  return internal::with_public_errors([&] {
    try {
      return internal::scene_value(make());
    } catch (const std::invalid_argument&) {
      throw;
    } catch (const std::runtime_error& error) {
      throw Error(error.what());
    }
  });
}

}  // namespace

Scene reference_scene(const ReferenceOptions& options) {
  using Radii = internal::ReferenceOptions::Radii;
  return made([&] {
    return internal::generate_reference(
        {.n = options.n,
         .seed = options.seed,
         .radii = options.radii == ReferenceOptions::Radii::log     ? Radii::log
                  : options.radii == ReferenceOptions::Radii::equal ? Radii::equal
                                                                    : Radii::uniform,
         .rmin = options.rmin,
         .rmax = options.rmax,
         .density = options.density,
         .speed = options.speed,
         .restitution = options.restitution,
         .horizon = options.horizon});
  });
}

Scene grid_scene(const GridOptions& options) {
  using Motion = internal::GridOptions::Motion;
  const auto motion = [&] {
    switch (options.motion) {
      case GridOptions::Motion::rest:
        return Motion::rest;
      case GridOptions::Motion::common:
        return Motion::common;
      case GridOptions::Motion::shear:
        return Motion::shear;
      case GridOptions::Motion::random:
        break;
    }
    return Motion::random;
  };
  return made([&] {
    return internal::generate_grid({.n = options.n,
                                    .seed = options.seed,
                                    .motion = motion(),
                                    .spacing = options.spacing,
                                    .radius = options.radius,
                                    .speed = options.speed,
                                    .horizon = options.horizon});
  });
}

Scene swarm_scene(const SwarmOptions& options) {
  return made([&] {
    return internal::generate_swarm({.n = options.n,
                                     .seed = options.seed,
                                     .spacing = options.spacing,
                                     .radius = options.radius,
                                     .horizon = options.horizon});
  });
}

}  // namespace voroproof
