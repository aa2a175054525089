// The sources of the movie's page, the files of apps/movie/: the build makes strings of them.
#pragma once

#include <span>
#include <string_view>

namespace voroproof::internal {

extern const std::string_view movie_style;
extern const std::string_view movie_body;
extern const std::span<const std::string_view> movie_scripts;  // in the order to be loaded

}  // namespace voroproof::internal
