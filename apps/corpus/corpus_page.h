// The page of a run over the corpus: the file of apps/corpus/page/.
#pragma once

#include "library/html.h"

namespace voroproof::internal {

extern const PageTemplate corpus_page;

}  // namespace voroproof::internal
