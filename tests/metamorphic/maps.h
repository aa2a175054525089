// Histories under exact maps of scenes (tests/support/correspondence.h).
#pragma once

#include <string>

#include "tests/certify/claimed_history.h"
#include "tests/support/correspondence.h"

namespace voroproof::internal::metamorphic {

// What is claimed of the image: numbers exactly mapped, as text where they are no binary64.
testing::ClaimedHistory image_of(const testing::ClaimedHistory& history,
                                 const testing::Image& image);

// The run of the image, where the map commutes with roundings: powers of two, new ids.
testing::RecordedRun image_of(const testing::RecordedRun& run, const testing::Image& image);

// The file of the history for a scene of this hash, numbers exact.
std::string history_text(const testing::ClaimedHistory& history, const std::string& scene_sha256);

}  // namespace voroproof::internal::metamorphic
