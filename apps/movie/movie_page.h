// The movie's page: the files of apps/movie/page/.
#pragma once

#include "apps/draw/html.h"

namespace voroproof::internal {

extern const PageTemplate movie_page;

}  // namespace voroproof::internal
