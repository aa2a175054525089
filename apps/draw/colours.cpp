#include "apps/draw/colours.h"

#include <array>
#include <cmath>

namespace voroproof::internal {
namespace {

// By colour of the palette, the next one in hue.
constexpr std::array<std::size_t, palette.size()> next_hue{6, 3, 5, 7, 0, 1, 2, 4};

// Its multiples leave no two close to each other.
constexpr double golden_section = 0.6180339887498949;

Colour mixed(const Colour& a, const Colour& b, double share) {
  const auto between = [share](double x, double y) { return x + share * (y - x); };
  return {between(a.red, b.red), between(a.green, b.green), between(a.blue, b.blue)};
}

}  // namespace

Colour disk_colour(std::size_t disk) {
  const std::size_t hue = disk % palette.size();
  const double step = golden_section * static_cast<double>(disk / palette.size());
  return mixed(palette[hue], palette[next_hue[hue]], step - std::floor(step));
}

Colour pale(const Colour& colour, double share) { return mixed(white, colour, share); }

}  // namespace voroproof::internal
