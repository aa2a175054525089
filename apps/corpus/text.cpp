#include "apps/corpus/text.h"

#include <sstream>

#include "apps/corpus/report.h"
#include "history/claim.h"
#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t line_width = 96;
constexpr int most_events = 24;  // that are listed

// Text of a case's files, fit for the terminal.
std::string shown(const std::string& text) { return printable(text, text.size()); }

// The text in lines of at most line_width, each after the indent.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::istringstream words(text);
  std::string out, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && indent.size() + line.size() + 1 + word.size() > line_width) {
      out += indent + line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + shown(word);
  }
  return line.empty() ? out : out + indent + line + '\n';
}

std::string quoted(const std::array<GenId, 4>& ids) {
  std::string text;
  for (const GenId id : ids) text += (text.empty() ? "[" : ",") + std::to_string(id);
  return text + "]";
}

std::string event_text(const Event& event) {
  std::string text = "t = " + number_text(time(event)) + "  ";
  if (const auto* f = std::get_if<FlipEvent>(&event)) {
    return text + "flip " + quoted({f->quad.l, f->quad.r, f->quad.s, f->quad.e});
  }
  if (const auto* c = std::get_if<CollideEvent>(&event)) {
    return text + "collide " + (c->i < 0 ? "container" : std::to_string(c->i)) + " and " +
           std::to_string(c->j);
  }
  return text + "maneuver of " + std::to_string(std::get<ManeuverEvent>(event).disk);
}

std::string events_text(HistorySource& history) {
  std::string text;
  int events = 0;
  while (const std::optional<Event> event = history.next()) {
    if (++events <= most_events) text += "  " + event_text(*event) + '\n';
  }
  if (events > most_events) {
    text += "  ... and " + std::to_string(events - most_events) + " more\n";
  }
  if (const auto* stop = std::get_if<HistoryStop>(&history.ending())) {
    text += wrapped("stops at t = " + number_text(stop->t) + ": " + stop->reason, "  ");
  }
  const HistoryCounts& counts = history.counts();
  return "events: " + std::to_string(counts.flips) + " flips, " +
         std::to_string(counts.collisions) + " collisions, " + std::to_string(counts.maneuvers) +
         " maneuvers\n" + text;
}

std::string scene_text(const Scene& scene) {
  std::string text = "scene: " + std::to_string(scene.disks.size()) +
                     " disks in a container of radius " + number_text(scene.container_radius) +
                     ", horizon " + number_text(scene.horizon) + ", restitution " +
                     number_text(scene.restitution);
  if (scene.container_restitution != 1) {
    text += ", at the container " + number_text(scene.container_restitution);
  }
  if (!scene.maneuvers.empty()) {
    text += ", " + std::to_string(scene.maneuvers.size()) + " maneuvers";
  }
  return text + "\n";
}

const char* verdict(const CorpusCase& c) { return c.decided ? "certified" : "undecided"; }

}  // namespace

std::string list_text(const std::vector<CorpusCase>& cases) {
  std::vector<std::vector<std::string>> rows{
      {"case", "disks", "horizon", "verdict", "wrong", "tags"}};
  for (const CorpusCase& c : cases) {
    const Scene scene = read_scene(c.scene());
    rows.push_back({shown(c.id()), std::to_string(scene.disks.size()), number_text(scene.horizon),
                    verdict(c), std::to_string(c.wrong.size()), shown(joined(c.tags))});
  }
  const std::string count = std::to_string(cases.size());
  return table_text(rows) + "\n" + count + (cases.size() == 1 ? " case\n" : " cases\n");
}

std::string case_text(const CorpusCase& c) {
  const Claim claim = open_claim(c.scene(), c.history());
  std::string text = shown(c.id()) + "\n\n" + wrapped(c.story, "") + "\n";
  if (!c.tags.empty()) text += "tags: " + shown(joined(c.tags)) + "\n";
  text += scene_text(claim.scene) + events_text(*claim.history);
  text += "established by:\n";
  for (const std::string& source : c.sources) text += wrapped(source, "  ");
  text += "expected verdicts:\n";
  std::vector<std::vector<std::string>> rows{{"  exact.history.jsonl", verdict(c), "exact truth"}};
  for (const WrongHistory& w : c.wrong) {
    rows.push_back({"  " + shown(w.file), "refuted: " + shown(w.kind), shown(w.truth) + " truth"});
  }
  text += table_text(rows);
  if (!c.instants.empty()) {
    text += "expected diagrams:\n";
    for (std::size_t k = 0; k < c.instants.size(); ++k) {
      text += "  diagram-" + std::to_string(k) +
              ".diagram.json at t = " + number_text(c.instants[k]) + "\n";
    }
  }
  return text + "files: " + shown(c.folder.string()) + "\n";
}

}  // namespace voroproof::internal
