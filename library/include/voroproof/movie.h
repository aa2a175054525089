// A history as a page that plays it.
#pragma once

#include <optional>
#include <string>

#include "voroproof/certify.h"
#include "voroproof/export.h"
#include "voroproof/history.h"
#include "voroproof/scene.h"

namespace voroproof {

struct MovieOptions {
  std::optional<int> follow;       // the disk that is followed to begin with
  const Report* report = nullptr;  // report on this history: what it found is shown
};

// The page that `voroproof movie` writes: HTML that needs no other file and no network. The history
// may be right or wrong. An event takes some 30 bytes of it, a disk 100, the player itself 110,000
// (docs/design/movie.md). Throws InputError, also where the scene has more than 65,534 disks, the
// history more than 4,000,000 events, or the report is by another version or about another scene or
// history; and std::invalid_argument for a disk that there is not.
VOROPROOF_API std::string movie_page(const Scene& scene, const History& history,
                                     const MovieOptions& options = {});

}  // namespace voroproof
