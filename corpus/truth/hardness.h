// The classes of questions, and what is common to the places of their generators.
#pragma once

#include <string_view>

#include "corpus/truth/placement.h"

namespace voroproof::truth {

// How near to a tie: anywhere, a little beside it, on it.
enum class Distance { any, near, tie };

// The places of a class are made from these, by its name.
Ingredients ingredients(Dice& dice, std::string_view name);
// That which the name says, else one at random.
Distance distance_of(Dice& dice, std::string_view name);

// Disks of the class `close`: their radii differ by little.
void make_close(Dice& dice, Generators& g);
// Puts generators that touch a common circle or line at that distance from doing so.
void put_at(Distance distance, Dice& dice, Generators& g);
// Far from the origin, or of a size far from 1, as the name says.
void change_frame(Dice& dice, std::string_view name, Generators& g);

// Whether an answer is what the distance promises: zero on a tie alone.
bool keeps_promise(Distance distance, internal::Sign sign);

}  // namespace voroproof::truth
