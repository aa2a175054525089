#include "apps/corpus/html.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/corpus/corpus_page.h"
#include "history/file_bytes.h"
#include "library/html.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_picture_bytes = std::size_t{1} << 24;

// Adds the facts about a case that the report does not have.
void add_case(Json& result, const CorpusCase& c) {
  result["story"] = c.story;
  result["sources"] = c.sources;
  std::error_code error;
  if (std::filesystem::is_regular_file(c.picture(), error)) {
    result["picture"] =
        "data:image/svg+xml;base64," + base64(file_bytes(c.picture(), max_picture_bytes));
  }
}

template <class Result>
std::string page_text(const CorpusRunInfo& info, const std::vector<Result>& results,
                      const std::string& title) {
  Json data = report_data(info, results);
  for (std::size_t k = 0; k < results.size(); ++k) add_case(data["results"][k], *results[k].of);
  return page_begin(corpus_page, title) + json_element("report", data) + page_end(corpus_page);
}

}  // namespace

std::string report_html(const CorpusRunInfo& info, const std::vector<ProgramResult>& results) {
  return page_text(info, results, "Degenerate cases: " + info.command);
}

std::string report_html(const CorpusRunInfo& info, const std::vector<OwnResult>& results) {
  return page_text(info, results, "Degenerate cases");
}

}  // namespace voroproof::internal
