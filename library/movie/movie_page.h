// The movie's page: the files of library/movie/page/.
#pragma once

#include "library/html.h"

namespace voroproof::internal {

extern const PageTemplate movie_page;

}  // namespace voroproof::internal
