// The certifier's page: the files of apps/certifier/page/.
#pragma once

#include "apps/draw/html.h"

namespace voroproof::internal {

extern const PageTemplate certifier_page;

}  // namespace voroproof::internal
