// A history as one HTML page that plays it and needs no other file.
#pragma once

#include <optional>
#include <string>

#include "apps/movie/movie_data.h"
#include "library/explanation.h"

namespace voroproof::internal {

struct MovieOptions {
  std::string producer;         // of the page: name and version
  std::optional<GenId> follow;  // the disk that is followed to begin with
};

// Writes the page. `report`, if given, is the one of a certification of this history: its verdict
// colours the time line and its evidence is drawn. The sources of the page are in apps/movie/page/;
// the page computes positions and the diagram from the data alone. The file appears whole or not at
// all. Throws OutputError.
void write_movie(const std::string& path, const Claim& claim, const MovieData& data,
                 const Explanation* report, const MovieOptions& options);

}  // namespace voroproof::internal
