#include "apps/corpus/html.h"

#include <algorithm>

#include "apps/draw/html.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

// What the page says of one case.
struct CaseEntry {
  const CorpusCase* of = nullptr;
  bool passed = false;
  std::string style, verdict, reason;  // of the line that is always seen
  double seconds = 0;
  std::string findings;  // HTML below the story
};

// The class of the style, which is also the colour of the bars.
std::string style_of(CaseOutcome outcome) {
  return outcome == CaseOutcome::timed_out
             ? "timed-out"
             : std::string(outcome_names[static_cast<std::size_t>(outcome)]);
}

std::string number(int count) {
  return count == 0 ? "<td class=\"n zero\">0</td>"
                    : "<td class=\"n\">" + std::to_string(count) + "</td>";
}

std::string number(int count, const std::string& style) {
  return count == 0 ? number(0)
                    : "<td class=\"n " + style + "\"><b>" + std::to_string(count) + "</b></td>";
}

// One segment of a bar, `count` of `all` long.
std::string segment(int count, int all, const std::string& style) {
  if (count == 0) return {};
  return "<i class=\"" + style + "\" style=\"width:" + std::to_string(100.0 * count / all) +
         "%\"></i>";
}

std::string bar(const FamilyTally& tally) {
  std::string out = "<div class=\"bar\">";
  for (std::size_t k = 0; k < tally.outcomes.size(); ++k) {
    out += segment(tally.outcomes[k], tally.cases, style_of(static_cast<CaseOutcome>(k)));
  }
  return out + "</div>";
}

std::string legend() {
  std::string out = "<div class=\"legend\">";
  for (std::size_t k = 0; k < outcome_names.size(); ++k) {
    out += "<span><i class=\"" + style_of(static_cast<CaseOutcome>(k)) + "\"></i>" +
           std::string(outcome_names[k]) + "</span>";
  }
  return out + "</div>\n";
}

std::string head(const std::vector<std::string>& names, std::size_t first_number,
                 std::size_t last_number) {
  std::string out = "<thead><tr>";
  for (std::size_t k = 0; k < names.size(); ++k) {
    out += (k >= first_number && k <= last_number ? "<th class=\"n\">" : "<th>") +
           html_text(names[k]) + "</th>";
  }
  return out + "</tr></thead>\n";
}

std::string tags(const CorpusCase& c) {
  std::string out;
  for (const std::string& tag : c.tags) out += "<span class=\"tag\">" + html_text(tag) + "</span>";
  return out.empty() ? out : "<div>" + out + "</div>\n";
}

std::string entry_text(const CaseEntry& e) {
  const CorpusCase& c = *e.of;
  const std::string picture = html_picture(c.picture(), c.id());
  return "<details class=\"" + std::string(e.passed ? "passed" : "failed") +
         "\"><summary><b class=\"" + e.style + "\">" + html_text(e.verdict) + "</b><span>" +
         html_text(c.name) + "</span><span class=\"reason\">" + html_text(e.reason) +
         "</span><span class=\"n\">" + seconds_text(e.seconds) +
         " s</span></summary>\n<div class=\"case" + (picture.empty() ? " bare" : "") + "\">" +
         (picture.empty() ? "" : "<div>" + picture + "</div>") + "<div><p>" + html_text(c.story) +
         "</p>\n" + tags(c) + e.findings + "<div class=\"mono faint\">" +
         html_text("voroproof corpus show " + c.id()) + "</div></div></div></details>\n";
}

std::string entries_text(const std::vector<CaseEntry>& entries) {
  std::string out =
      "<div class=\"buttons\"><button onclick=\"document.body.classList.toggle('failed')\">"
      "Show or hide the cases that passed</button></div>\n";
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k == 0 || entries[k].of->family != entries[k - 1].of->family) {
      out += (k == 0 ? "<section>" : "</section>\n<section>") + std::string("<h2>") +
             html_text(entries[k].of->family) + "</h2>\n";
    }
    out += entry_text(entries[k]);
  }
  return out + (entries.empty() ? "" : "</section>\n");
}

std::string score(int passed, int cases, const std::string& words) {
  return "<div class=\"score\"><b>" + std::to_string(passed) + "</b><span>of " +
         std::to_string(cases) + " cases " + words + "</span></div>\n";
}

std::string limits_text(const CorpusRunInfo& info) {
  std::string out = "Limits for each process: " + number_text(info.limits.seconds) + " s";
  if (info.limits.bytes > 0) out += ", " + std::to_string(info.limits.bytes >> 20) + " MB";
  return out + ".";
}

std::string family_table(const std::vector<FamilyTally>& families) {
  std::string out = "<div class=\"scroll\"><table>\n";
  out += head({"family", "", "cases", "exact", "recorded", "refuted", "undecided", "invalid",
               "crashed", "timed out", "seconds", "refuted for"},
              2, 10);
  for (const FamilyTally& f : families) {
    const bool last = &f == &families.back();
    out += (last ? "<tr class=\"all\">" : "<tr>") + std::string("<td class=\"word\">") +
           html_text(f.family) + "</td><td class=\"share\">" + bar(f) + "</td>" + number(f.cases) +
           number(f.exact, "certified") + number(f.recorded, "certified");
    for (std::size_t k = 1; k < f.outcomes.size(); ++k) {
      out += number(f.outcomes[k], style_of(static_cast<CaseOutcome>(k)));
    }
    out += "<td class=\"n\">" + seconds_text(f.seconds) + "</td><td>";
    for (const std::string& kind : kind_counts(f)) {
      out += "<span class=\"kind\">" + html_text(kind) + "</span>";
    }
    out += "</td></tr>\n";
  }
  return out + "</table></div>\n";
}

std::string judgement_row(const char* truth, const std::optional<CaseJudgement>& judgement) {
  if (!judgement) return {};
  const std::string verdict(name_of(judgement->verdict));
  std::string prefix;
  if (judgement->verdict != CaseJudgement::Verdict::invalid) {
    prefix = std::to_string(judgement->prefix_events) +
             " events, up to t = " + number_text(judgement->prefix_t);
  }
  return std::string("<tr><td class=\"word\">") + truth + "</td><td class=\"word " + verdict +
         "\"><b>" + verdict + "</b></td><td>" + html_text(judgement->reason) + "</td><td>" +
         prefix + "</td><td class=\"n\">" + seconds_text(judgement->seconds) + "</td></tr>\n";
}

CaseEntry entry(const ProgramResult& r) {
  CaseEntry e{.of = r.of,
              .passed = r.passed(),
              .style = style_of(r.outcome),
              .verdict = std::string(outcome_names[static_cast<std::size_t>(r.outcome)]),
              .reason = r.reason,
              .seconds = r.end.seconds,
              .findings = {}};
  if (r.exact || r.recorded) {
    e.findings = "<table>\n" +
                 head({"truth", "verdict", "first divergence", "right so far", "seconds"}, 4, 4) +
                 judgement_row("exact", r.exact) + judgement_row("recorded", r.recorded) +
                 "</table>\n";
  }
  if (r.outcome != CaseOutcome::certified && r.outcome != CaseOutcome::refuted) {
    e.findings += "<p class=\"" + e.style + "\">" + html_text(r.reason) + "</p>\n";
  }
  if (!r.message.empty()) {
    e.findings +=
        "<p class=\"faint\">Last line on stderr: <code>" + html_text(r.message) + "</code></p>\n";
  }
  return e;
}

CaseEntry entry(const OwnResult& r) {
  CaseEntry e{.of = r.of,
              .passed = r.passed(),
              .style = r.passed() ? "certified" : "refuted",
              .verdict = r.passed() ? "as expected" : "not so",
              .reason = {},
              .seconds = 0,
              .findings = {}};
  e.findings = "<table>\n" + head({"file", "expected", "found", "evidence", "seconds"}, 4, 4);
  for (const OwnCheck& c : r.checks) {
    e.seconds += c.seconds;
    e.findings += "<tr><td class=\"word\">" + html_text(c.file) + "</td><td>" +
                  html_text(c.expected) + "</td><td class=\"" +
                  (c.passed() ? "certified" : "refuted") + "\">" + html_text(c.found) +
                  "</td><td>" + html_text(c.reason) + "</td><td class=\"n\">" +
                  seconds_text(c.seconds) + "</td></tr>\n";
    if (!c.passed() && e.reason.empty()) {
      e.reason = c.file + ": expected " + c.expected + ", found " + c.found;
    }
  }
  e.findings += "</table>\n";
  e.findings += "<p class=\"faint\">The exact history was established by:</p><ul class=\"faint\">";
  for (const std::string& source : r.of->sources) {
    e.findings += "<li>" + html_text(source) + "</li>";
  }
  e.findings += "</ul>\n";
  return e;
}

template <class Result>
std::string all_entries(const std::vector<Result>& results) {
  std::vector<CaseEntry> entries;
  for (const Result& r : results) entries.push_back(entry(r));
  return entries_text(entries);
}

}  // namespace

std::string report_html(const CorpusRunInfo& info, const std::vector<ProgramResult>& results) {
  const std::vector<FamilyTally> families = tallies(results);
  const FamilyTally& all = families.back();
  std::string truths;
  for (const Truth truth : info.truths) {
    truths += truths.empty() ? "" : " or against ";
    truths += truth == Truth::exact ? "the true motion (exact)"
                                    : "the motion that it records itself (recorded)";
  }
  std::string body =
      "<h1>The corpus of degenerate cases</h1>\n<div class=\"faint\">A program run on the corpus; "
      "its histories certified by " +
      html_text(info.producer) + "</div>\n<code class=\"command\">" + html_text(info.command) +
      "</code>\n" + score(all.passed, all.cases, "passed") + bar(all) + legend() +
      "<p class=\"faint\">A history is certified if every event in it is proved, and "
      "proved that none is missing, against " +
      truths + ". " + limits_text(info) + " The seconds are the program's.</p>\n" +
      family_table(families) + all_entries(results);
  return html_page("Degenerate cases: " + info.command, body);
}

std::string report_html(const CorpusRunInfo& info, const std::vector<OwnResult>& results) {
  const int passed = static_cast<int>(
      std::count_if(results.begin(), results.end(), [](const OwnResult& r) { return r.passed(); }));
  const int cases = static_cast<int>(results.size());
  std::string body =
      "<h1>The corpus of degenerate cases</h1>\n<div class=\"faint\">The corpus held against "
      "itself by " +
      html_text(info.producer) + "</div>\n" + score(passed, cases, "as expected") +
      "<div class=\"bar\">" + segment(passed, cases, "certified") +
      segment(cases - passed, cases, "refuted") +
      "</div>\n<p class=\"faint\">Every exact history is certified against the true "
      "motion, every expected diagram compared with that of the history, every wrong "
      "history refuted for its fault. " +
      limits_text(info) + "</p>\n" + all_entries(results);
  return html_page("Degenerate cases", body);
}

}  // namespace voroproof::internal
