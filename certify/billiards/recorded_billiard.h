// The recorded truth of billiards: every disk turns at the claimed times to the velocities claimed
// there (docs/claim.md, section 9).
//
// So the files determine all paths exactly. Each claim is held against the law of collision. Then
// each pair that may meet, images and walls included, is followed from turn to turn:
//
//  1. Who may meet. In a window of time the boxes that contain two disks of a pair at all times do
//     not meet: then the two do not touch, and no entry nor episode of theirs begins, goes on or
//     ends in it. All other pairs are followed, and those with a claim in the window, and those
//     with an overlap in progress.
//  2. Life of a pair. On lines that both keep the sign of the gap is that of a polynomial of degree
//     at most 4 (filtered/billiards/billiard_gaps.h). Where it is certainly positive in doubles,
//     nothing happens. Else its real roots are isolated, and its signs around them are exact, so
//     that all entries and exits are found, and which overlaps are deeper than the rounding.
//  3. A claim is answered by exactly one entry, or near approach (PairWatch::answers).
//  4. An episode that is deeper than the rounding is answered in time, and ends in time, or the
//     history is refuted for it (PairWatch::expire, PairWatch::close).
//
// Gaps are continuous in time, paths being so: an episode that is in progress at the end of a life
// or window is in progress at the beginning of the next. Windows and doubles change no verdict.
#pragma once

#include <memory>

#include "certify/billiards/billiard_truth.h"
#include "certify/options.h"

namespace voroproof::internal {

// The size of the scene at time 0, to which roundings of coordinates are in proportion.
Rational extent_of(const Billiard& billiard);

// Both must outlive it. `horizon`: the history's.
std::unique_ptr<BilliardTruth> recorded_billiard(const Billiard& billiard, const Rational& horizon,
                                                 const CertifyOptions& options);

}  // namespace voroproof::internal
