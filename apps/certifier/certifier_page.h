// The certifier's page: the files of apps/certifier/page/.
#pragma once

#include "library/html.h"

namespace voroproof::internal {

extern const PageTemplate certifier_page;

}  // namespace voroproof::internal
