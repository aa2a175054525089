#include "apps/run/run_table.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/json_text.h"
#include "history/line_source.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_line = 1 << 16;
constexpr std::int64_t longest_list = std::int64_t{1} << 28;
constexpr std::size_t longest_table = std::size_t{1} << 28;
constexpr std::size_t longest_shown = 4096;
constexpr const char* format_name = "voroproof-table";

// The names of a line: what stands before and behind its one tab or, without a tab, two words.
std::vector<std::string> names_in(std::string_view line) {
  std::vector<std::string> names;
  const char* separators = line.find('\t') != std::string_view::npos ? "\t" : " ";
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(separators), line.size());
    if (end > 0) names.emplace_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return names;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    result += c;
    if (c == '"') result += c;
  }
  return result + '"';
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line;
  return text;
}

Json json_of(const RunTable& table, const RunRow& row) {
  Json json = {{"scene", row.run.scene}, {"history", row.run.history}};
  json["verdict"] = verdict_of(table.verb, row);
  if (!row.says.empty()) json["says"] = row.says;
  if (row.code) json["exit_code"] = static_cast<int>(*row.code);
  if (!row.reason.empty()) json["reason"] = row.reason;
  if (row.events) json["events"] = *row.events;
  if (row.t) json["t"] = *row.t;
  if (!row.scene_sha256.empty()) json["scene_sha256"] = row.scene_sha256;
  if (!row.history_sha256.empty()) json["history_sha256"] = row.history_sha256;
  json["options"] = row.options;
  return json;
}

RunRow row_of(const Json& json) {
  RunRow row;
  row.run = {json.at("scene"), json.at("history")};
  if (json.contains("exit_code")) row.code = static_cast<ExitCode>(json.at("exit_code").get<int>());
  row.says = json.value("says", std::vector<std::string>());
  if (!row.says.empty()) row.words = json.at("verdict");
  row.reason = json.value("reason", "");
  row.scene_sha256 = json.value("scene_sha256", "");
  row.history_sha256 = json.value("history_sha256", "");
  row.options = json.at("options").get<std::vector<std::string>>();
  if (json.contains("events")) row.events = json.at("events").get<std::int64_t>();
  if (json.contains("t")) row.t = json.at("t").get<double>();
  return row;
}

}  // namespace

std::vector<ListedRun> read_run_list(const std::string& path) {
  std::vector<ListedRun> runs;
  LineSource lines(path);
  while (auto line = lines.next(longest_line)) {
    if (lines.offset() > longest_list) {
      throw InputError(path, lines.number(), "", "a list has 256 MB at most");
    }
    while (!line->empty() && std::string_view(" \t\r").find(line->back()) != std::string_view::npos)
      line->remove_suffix(1);
    if (line->empty() || line->front() == '#') continue;
    const std::vector<std::string> names = names_in(*line);
    if (names.size() != 2) {
      throw InputError(path, lines.number(), "",
                       "not the names of a scene and of a history, with a tab between them");
    }
    runs.push_back({names[0], names[1]});
  }
  if (runs.empty()) throw InputError(path, 0, "", "names no scene and history");
  return runs;
}

std::string verdict_of(const std::string& verb, const RunRow& row) {
  if (!row.code) return "NOT RUN";
  if (!row.words.empty()) return row.words;
  const bool simulated = verb == "simulate";
  switch (*row.code) {
    case ExitCode::ok:
      return simulated ? "COMPLETE" : "CERTIFIED";
    case ExitCode::refuted:
      return "REFUTED";
    case ExitCode::bad_input:
      return "INVALID";
    case ExitCode::undecided:
      return simulated ? "STOPPED" : "UNDECIDED";
    case ExitCode::memory:
      return "OUT OF MEMORY";
    case ExitCode::interrupted:
      return "INTERRUPTED";
    case ExitCode::internal:
      break;
  }
  return "INTERNAL ERROR";
}

ExitCode worst_of(const RunTable& table) {
  for (const ExitCode bad : {ExitCode::interrupted, ExitCode::internal, ExitCode::memory,
                             ExitCode::refuted, ExitCode::bad_input, ExitCode::undecided}) {
    for (const RunRow& row : table.rows) {
      if (row.code.value_or(ExitCode::interrupted) == bad) return bad;
    }
  }
  return ExitCode::ok;
}

std::string table_csv(const RunTable& table) {
  std::string text = "scene,history,verdict,exit_code,events,t,reason,says\r\n";
  for (const RunRow& row : table.rows) {
    text +=
        quoted(row.run.scene) + ',' + quoted(row.run.history) + ',' + verdict_of(table.verb, row) +
        ',' + (row.code ? std::to_string(static_cast<int>(*row.code)) : "") + ',' +
        (row.events ? std::to_string(*row.events) : "") + ',' + (row.t ? number_text(*row.t) : "") +
        ',' + quoted(row.reason) + ',' + quoted(joined(row.says)) + "\r\n";
  }
  return text;
}

std::string table_json(const RunTable& table) {
  Json json = {{"format", format_name},
               {"version", 1},
               {"producer", table.producer},
               {"verb", table.verb},
               {"rows", Json::array()}};
  for (const RunRow& row : table.rows) json["rows"].push_back(json_of(table, row));
  // Names of files may be other text than UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string table_words(const RunTable& table) {
  std::string text;
  std::map<std::string, std::size_t> counts;
  for (const RunRow& row : table.rows) {
    const std::string verdict = verdict_of(table.verb, row);
    ++counts[verdict];
    text += verdict + ' ' + printable(row.run.scene, longest_shown) + ' ' +
            printable(row.run.history, longest_shown);
    if (!row.reason.empty()) text += ": " + printable(row.reason, longest_shown);
    if (!row.says.empty()) text += "; " + joined(row.says);
    text += '\n';
  }
  text += "c " + std::to_string(table.rows.size()) + " scenes";
  const char* separator = ": ";
  for (const auto& [verdict, count] : counts) {
    text += separator + std::to_string(count) + ' ' + verdict;
    separator = ", ";
  }
  return text + '\n';
}

RunTable read_run_table(const std::string& path, const std::string& verb) {
  RunTable table;
  try {
    const Json json = Json::parse(file_bytes(path, longest_table));
    if (json.at("format") != format_name || json.at("version") != 1 || json.at("verb") != verb) {
      throw InputError(path, 0, "format", "not a table of " + verb + ": give another name");
    }
    table.verb = verb;
    table.producer = json.at("producer");
    for (const Json& row : json.at("rows")) table.rows.push_back(row_of(row));
  } catch (const nlohmann::json::exception&) {
    throw InputError(path, 0, "", "not a table of " + verb + ": give another name");
  }
  return table;
}

}  // namespace voroproof::internal
