// Generators in motion that touch one circle at one time, or nearly, and the window around it in
// which that is a plain question.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "corpus/truth/hardness.h"
#include "corpus/truth/times.h"

namespace voroproof::truth {

struct Encounter {
  Generators generators;
  double time = 0;  // near which, or at which, they touch one circle
  // How long motions of the class take.
  double span = 1;
};

// `count` generators. The class `double` has the last one touch the circle of the first three
// without entering it.
Encounter encounter(Dice& dice, std::string_view name, int count, Distance distance);

// Four of them as functions of time.
using Moving = std::array<Numbers<Polynomial<Rational>>, 4>;
Moving moving(const Generators& g, const std::array<int, 4>& ids);

// Whether it is plain that in all of [from, to] no two of the four touch or overlap and the circle
// of the first three exists.
bool is_plain(const Moving& g, const Rational& from, const Rational& to);

std::array<Numbers<Rational>, 4> at(const Moving& g, const Rational& t);

}  // namespace voroproof::truth
