#include "apps/verbs/listed_certify.h"

#include <nlohmann/json.hpp>

#include "history/file_bytes.h"

namespace voroproof::internal {
namespace {

// Takes from a run's report how far the history is proved, and the hashes of the bytes it is about.
void read_report(const std::string& path, RunRow& row) {
  const nlohmann::json report = nlohmann::json::parse(file_bytes(path, std::size_t{1} << 28));
  row.events = report.at("certified_prefix").at("events").get<std::int64_t>();
  row.t = report.at("certified_prefix").at("t").get<double>();
  const nlohmann::json& words = report.at("words");
  row.words = words.at("verdict");
  row.says = words.at("reservations").get<std::vector<std::string>>();
  row.says.insert(row.says.begin(), words.at("about").get<std::string>());
  row.scene_sha256 = report.at("scene_sha256");
  row.history_sha256 = report.value("history_sha256", "");
}

}  // namespace

const ListedVerb listed_certify{.name = "certify",
                                .arguments =
                                    [](const ListedRun& run, const std::string& report) {
                                      return std::vector<std::string>{
                                          "certify", "--report", report,     "--quiet",
                                          "--",      run.scene,  run.history};
                                    },
                                .read = read_report};

}  // namespace voroproof::internal
