// Generators that touch one circle exactly, from which the hard questions are made.
#pragma once

#include "corpus/truth/dice.h"
#include "corpus/truth/generators.h"

namespace voroproof::truth {

// The kinds of generators beside plain disks.
struct Ingredients {
  bool equal_radii = false;
  bool points = false;
  bool container = false;
  int walls = 0;
  bool wide = false;  // radii and distances of many magnitudes
  int bits = 13;      // a factor of all numbers has so many: with a few doubles would be exact
};

// A unit vector with rational coordinates.
struct Direction {
  int a, b, h;  // (a, b) / h
};

// Draws one at random.
Direction any_direction(Dice& dice);

// `count` >= 3 generators that do not overlap and touch one circle about the origin. The contacts
// of the first three run counterclockwise, one of these is a disk. All numbers are whole and less
// than 2^30, or 2^50 where they are wide.
Generators touching(Dice& dice, int count, const Ingredients& with);

// Three that touch a line from one side, which is the circle [1, 2, 3] in the limit.
Generators touching_line(Dice& dice, const Ingredients& with);

// Moves centres and radii of disks and the container at random, by up to `size`.
void perturb(Dice& dice, Generators& g, double size);
// Moves its radius, offset or place by about 2^-bits of its size, one way or the other.
void nudge(Dice& dice, Generator& g, int bits);
// Multiplies all lengths by 2^exponent.
void scale(Generators& g, int exponent);
void translate(Generators& g, double x, double y);

}  // namespace voroproof::truth
