// Histories written otherwise: with the same meaning, or with several faults at once.
#pragma once

#include "tests/adversary/claims.h"
#include "tests/adversary/families.h"

namespace voroproof::internal::adversary {

// What means the same under one truth at least: times of flips (or of all lines) within the
// tolerance, an earlier horizon, the order of neighbours within the tolerance.
enum class Rewriting { none, flips_shifted, all_shifted, neighbours_exchanged, horizon_cut, count };
void rewrite(History& history, Rewriting how, Random& random);

// One to four changes of lines at random places: drop, repeat, exchange, shift in time within and
// beyond the tolerance, other ends, changed velocities, a claim in two, pairs of changes that fit.
void fuzz(History& history, Random& random);

}  // namespace voroproof::internal::adversary
