#include "apps/certifier/certifier.h"

#include <nlohmann/json.hpp>

#include "apps/certifier/certifier_page.h"
#include "history/error.h"
#include "history/output_file.h"

namespace voroproof::internal {

void write_certifier(const std::string& path, [[maybe_unused]] const std::string& producer) {
#ifdef VOROPROOF_HAS_PAGE
  OutputFile file(path);
  file.write(page_begin(certifier_page, "Certify a history"));
  file.write(json_element("certifier-facts", {{"producer", producer}}));
  file.write(page_end(certifier_page));
  file.commit();
#else
  throw OutputError(path, "this build has no page, as Emscripten was not there when it was made");
#endif
}

}  // namespace voroproof::internal
