#include "apps/certifier/certifier.h"

#include <nlohmann/json.hpp>

#include "apps/certifier/certifier_page.h"
#include "history/output_file.h"

namespace voroproof::internal {

void write_certifier(const std::string& path, const std::string& producer) {
  OutputFile file(path);
  file.write(page_begin(certifier_page, "Certify a history"));
  file.write(json_element("certifier-facts", {{"producer", producer}}));
  file.write(page_end(certifier_page));
  file.commit();
}

}  // namespace voroproof::internal
