#include "apps/corpus/report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "history/error.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

constexpr std::size_t longest_reason = 160;

const char* name_of(Truth truth) { return truth == Truth::exact ? "exact" : "recorded"; }

void add(FamilyTally& tally, const ProgramResult& r) {
  const auto certified = [](const std::optional<CaseJudgement>& j) {
    return j && j->verdict == CaseJudgement::Verdict::certified ? 1 : 0;
  };
  const bool counts = r.outcome == CaseOutcome::certified;
  ++tally.cases;
  tally.passed += r.passed() ? 1 : 0;
  tally.exact += counts ? certified(r.exact) : 0;
  tally.recorded += counts ? certified(r.recorded) : 0;
  ++tally.outcomes[static_cast<std::size_t>(r.outcome)];
  if (r.outcome == CaseOutcome::refuted) ++tally.kinds[r.decisive()->kind];
  tally.seconds += r.end.seconds;
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.") == std::string::npos;
}

std::string count_text(int count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

// "3" or, where there is nothing to see, nothing.
std::string cell(int count) { return count == 0 ? "." : std::to_string(count); }

Json json(const CorpusRunInfo& info) {
  Json j = Json::object();
  j["format"] = "voroproof-corpus-report";
  j["version"] = 1;
  j["producer"] = info.producer;
  j["command"] = info.command.empty() ? Json() : Json(info.command);
  j["time_limit"] = info.limits.seconds;
  j["memory_limit"] = info.limits.bytes == 0 ? Json() : Json(info.limits.bytes);
  return j;
}

Json json(const CaseJudgement& judgement) {
  Json j = Json::object();
  j["verdict"] = name_of(judgement.verdict);
  j["reason"] = judgement.reason;
  if (judgement.verdict == CaseJudgement::Verdict::refuted) {
    j["kind"] = judgement.kind;
    j["line"] = judgement.line;
    j["t"] = judgement.t;
  }
  if (judgement.verdict != CaseJudgement::Verdict::invalid) {
    j["certified_prefix"] = {{"events", judgement.prefix_events}, {"t", judgement.prefix_t}};
  }
  j["seconds"] = judgement.seconds;
  return j;
}

std::string text(const Json& j) {
  return j.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::vector<FamilyTally> tallies(const std::vector<ProgramResult>& results) {
  std::vector<FamilyTally> families;
  FamilyTally all;
  all.family = "all";
  for (const ProgramResult& r : results) {
    if (families.empty() || families.back().family != r.of->family) {
      families.emplace_back().family = r.of->family;
    }
    add(families.back(), r);
    add(all, r);
  }
  families.push_back(std::move(all));
  return families;
}

std::vector<std::string> kind_counts(const FamilyTally& tally) {
  std::vector<std::pair<std::string, int>> kinds(tally.kinds.begin(), tally.kinds.end());
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<std::string> texts;
  for (const auto& [kind, count] : kinds) texts.push_back(kind + " " + std::to_string(count));
  return texts;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", seconds < 10 ? 3 : 1, seconds);
  return text;
}

std::string table_text(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line;
    for (std::size_t k = 0; k < rows[r].size(); ++k) {
      const std::string& word = rows[r][k];
      const std::string blanks(widths[k] - word.size(), ' ');
      // A head stands over its column as the numbers below it do.
      const std::string& below = r == 0 && rows.size() > 1 ? rows[1][k] : word;
      if (k > 0) line += "  ";
      line += is_number(below) || below == "." ? blanks + word : word + blanks;
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

std::string report_for_terminal(const CorpusRunInfo& info,
                                const std::vector<ProgramResult>& results) {
  std::string out;
  for (const ProgramResult& r : results) {
    if (r.passed()) continue;
    out += r.of->id() + ": " + std::string(outcome_names[static_cast<std::size_t>(r.outcome)]) +
           ": " + printable(r.reason, longest_reason) + '\n';
  }
  if (!out.empty()) out += '\n';
  const auto asked = [&](Truth truth) {
    return std::find(info.truths.begin(), info.truths.end(), truth) != info.truths.end();
  };
  std::vector<Row> rows;
  Row head{"family", "cases"};
  if (asked(Truth::exact)) head.push_back("exact");
  if (asked(Truth::recorded)) head.push_back("recorded");
  for (std::size_t k = 1; k < outcome_names.size(); ++k) head.emplace_back(outcome_names[k]);
  head.insert(head.end(), {"seconds", "refuted for"});
  rows.push_back(std::move(head));
  const std::vector<FamilyTally> families = tallies(results);
  for (const FamilyTally& f : families) {
    Row row{f.family, std::to_string(f.cases)};
    if (asked(Truth::exact)) row.push_back(cell(f.exact));
    if (asked(Truth::recorded)) row.push_back(cell(f.recorded));
    for (std::size_t k = 1; k < f.outcomes.size(); ++k) row.push_back(cell(f.outcomes[k]));
    row.insert(row.end(), {seconds_text(f.seconds), joined(kind_counts(f))});
    rows.push_back(std::move(row));
  }
  out += table_text(rows);
  const FamilyTally& all = families.back();
  out += "\n" + std::to_string(all.passed) + " of " + count_text(all.cases, "case") + " passed" +
         (info.events == EventKinds::all ? "" : ", by collisions and maneuvers alone") + "\n";
  return out;
}

std::string report_for_terminal(const CorpusRunInfo&, const std::vector<OwnResult>& results) {
  std::string out;
  std::map<std::string, std::array<int, 3>> families;  // cases, checks, cases that passed
  int cases = 0, checks = 0, passed = 0;
  for (const OwnResult& r : results) {
    auto& tally = families[r.of->family];
    ++cases, ++tally[0];
    if (r.passed()) ++passed, ++tally[2];
    for (const OwnCheck& c : r.checks) {
      ++checks, ++tally[1];
      if (c.passed()) continue;
      out += r.of->id() + "/" + c.file + ": expected " + c.expected + ", found " + c.found;
      if (!c.reason.empty()) out += ": " + printable(c.reason, longest_reason);
      out += '\n';
    }
  }
  if (!out.empty()) out += '\n';
  std::vector<Row> rows{{"family", "cases", "checks", "as expected"}};
  for (const auto& [family, t] : families) {
    rows.push_back({family, std::to_string(t[0]), std::to_string(t[1]), std::to_string(t[2])});
  }
  rows.push_back({"all", std::to_string(cases), std::to_string(checks), std::to_string(passed)});
  out += table_text(rows);
  out += "\n" + std::to_string(passed) + " of " + count_text(cases, "case") + " as expected\n";
  return out;
}

Json report_data(const CorpusRunInfo& info, const std::vector<ProgramResult>& results) {
  Json j = json(info);
  j["truths"] = Json::array();
  for (const Truth truth : info.truths) j["truths"].push_back(name_of(truth));
  j["events"] = info.events == EventKinds::all ? "all" : "collisions";
  Json families = Json::array();
  for (const FamilyTally& f : tallies(results)) {
    Json family = {{"family", f.family}, {"cases", f.cases},       {"passed", f.passed},
                   {"exact", f.exact},   {"recorded", f.recorded}, {"seconds", f.seconds}};
    for (std::size_t k = 0; k < f.outcomes.size(); ++k) {
      family["outcomes"][std::string(outcome_names[k])] = f.outcomes[k];
    }
    family["refuted_for"] = Json::object();
    for (const auto& [kind, count] : f.kinds) family["refuted_for"][kind] = count;
    families.push_back(std::move(family));
  }
  j["families"] = std::move(families);
  Json cases = Json::array();
  for (const ProgramResult& r : results) {
    Json c = {{"family", r.of->family}, {"name", r.of->name}, {"tags", r.of->tags}};
    c["outcome"] = outcome_names[static_cast<std::size_t>(r.outcome)];
    c["passed"] = r.passed();
    c["reason"] = r.reason;
    c["program"] = {{"end", description(r.end)}, {"seconds", r.end.seconds}};
    if (!r.message.empty()) c["program"]["message"] = r.message;
    if (r.exact) c["exact"] = json(*r.exact);
    if (r.recorded) c["recorded"] = json(*r.recorded);
    cases.push_back(std::move(c));
  }
  j["results"] = std::move(cases);
  return j;
}

Json report_data(const CorpusRunInfo& info, const std::vector<OwnResult>& results) {
  Json j = json(info);
  Json cases = Json::array();
  for (const OwnResult& r : results) {
    Json checks = Json::array();
    for (const OwnCheck& c : r.checks) {
      checks.push_back({{"file", c.file},
                        {"expected", c.expected},
                        {"found", c.found},
                        {"reason", c.reason},
                        {"passed", c.passed()},
                        {"seconds", c.seconds}});
    }
    cases.push_back({{"family", r.of->family},
                     {"name", r.of->name},
                     {"tags", r.of->tags},
                     {"passed", r.passed()},
                     {"checks", std::move(checks)}});
  }
  j["results"] = std::move(cases);
  return j;
}

std::string report_json(const CorpusRunInfo& info, const std::vector<ProgramResult>& results) {
  return text(report_data(info, results));
}

std::string report_json(const CorpusRunInfo& info, const std::vector<OwnResult>& results) {
  return text(report_data(info, results));
}

}  // namespace voroproof::internal
