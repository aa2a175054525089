#include "corpus/truth/lines.h"

namespace voroproof::truth {

const std::vector<File>& files() {
  static const std::vector<File> all{{"incircle", incircle_line},   {"exists", exists_line},
                                     {"contact", contact_line},     {"collapse", collapse_line},
                                     {"rootorder", rootorder_line}, {"static", static_line}};
  return all;
}

std::string heading(const File& file) {
  return "# voroproof-truth " + file.name + ' ' + std::string(version);
}

}  // namespace voroproof::truth
