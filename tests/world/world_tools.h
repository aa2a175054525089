// Helpers for worlds in tests.
#pragma once

#include <optional>
#include <string>

#include "exact/rational.h"
#include "history/world.h"

namespace voroproof::internal::testing {

// Lengths and times are so many times as large.
World in_units(const World& world, const Rational& length, const Rational& time);

// Keeps maneuvers in order, and radii from becoming negative: a rate that would make one negative
// before it changes lets it become 0 just then.
void make_valid(World& world);

// The earliest time of the world at which nobody decides what follows: three of its disks that stay
// come to have one centre and one radius, or two that have a cell before and after do, one of which
// turns then. Disks that come there do not count.
std::optional<Rational> first_undecided(const World& world);

// The world as a scene of version 2.
std::string text(const World& world);

}  // namespace voroproof::internal::testing
