#include "corpus/truth/hardness.h"

#include <cmath>

namespace voroproof::truth {

Ingredients ingredients(Dice& dice, std::string_view name) {
  Ingredients with;
  with.equal_radii = name == "equal" || name == "close";
  with.points = name == "point";
  with.container = name == "container";
  with.walls = name == "wall" ? dice.whole(1, 2) : 0;
  with.wide = name == "wide";
  return with;
}

Distance distance_of(Dice& dice, std::string_view name) {
  if (name == "generic") return Distance::any;
  if (name == "near" || name == "close") return Distance::near;
  if (name == "tie") return Distance::tie;
  return static_cast<Distance>(dice.whole(0, 2));
}

void make_close(Dice& dice, Generators& all) {
  const int bits = dice.whole(8, 27);
  for (Generator& g : all) {
    g.r = std::fabs(g.r + std::ldexp(dice.whole(-4, 4), -bits));
  }
}

void put_at(Distance distance, Dice& dice, Generators& g) {
  if (distance == Distance::any) perturb(dice, g, std::ldexp(1.0, dice.whole(8, 20)));
  if (distance == Distance::near) nudge(dice, g.back(), dice.whole(30, 51));
}

void change_frame(Dice& dice, std::string_view name, Generators& g) {
  if (name == "far") {
    const int exponent = dice.whole(20, 36);
    const double y = std::ldexp(dice.whole(-99, 99), exponent);
    translate(g, std::ldexp(dice.whole(-99, 99), exponent), y);
  }
  if (name == "wide") scale(g, dice.whole(-100, 60));
}

bool keeps_promise(Distance distance, internal::Sign sign) {
  if (distance == Distance::any) return true;
  return (distance == Distance::tie) == (sign == internal::Sign::zero);
}

}  // namespace voroproof::truth
