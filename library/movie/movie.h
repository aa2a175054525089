// A history as one HTML page that plays it and needs no other file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "library/explanation.h"
#include "library/movie/movie_data.h"

namespace voroproof::internal {

struct MovieOptions {
  std::string producer;         // maker of the page: name and version
  std::optional<GenId> follow;  // the disk that is followed to begin with
};

// Hands out the page, piece by piece. `report`, if given, is the one of a certification of this
// history: its verdict colours the time line and its evidence is drawn. The sources of the page are
// in library/movie/page/; the page computes positions and the diagram from the data alone.
void make_movie(const Claim& claim, const MovieData& data, const Explanation* report,
                const MovieOptions& options, const std::function<void(std::string_view)>& take);

}  // namespace voroproof::internal
