// voroproof convert: between this project's formats and those of other programs.
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "apps/answers/query_answer.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"
#include "history/claim.h"
#include "history/compressor.h"
#include "history/disk_file.h"
#include "history/disk_writer.h"
#include "history/error.h"
#include "history/event_limit.h"
#include "history/evtsq_writer.h"
#include "history/history_writer.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "history/paths_scene.h"
#include "history/paths_world.h"
#include "history/scene_writer.h"
#include "history/world_writer.h"
#include "library/planning/given_clearance.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string input, output, scene, horizon, restitution, format, radius, growth;
  std::string contacts = "bounce";
  std::string numbers = "hexadecimal", version = "1.1";
  std::uint64_t max_events = 0;
  bool stay = false;
};

// The format to write: an option names it, or else the output's name does.
std::string format_to_write(const Request& request) {
  if (!request.format.empty()) return request.format;
  constexpr std::pair<std::string_view, const char*> endings[] = {
      {".json", "scene"}, {".txt", "disks"}, {".jsonl", "history"}, {".evtsq", "evtsq"}};
  const std::string_view name = without_compression(request.output);
  for (const auto& [ending, format] : endings) {
    if (name.size() > ending.size() && name.ends_with(ending)) return format;
  }
  throw UsageError(
      "--output: none of .scene.json, .disks.txt, .history.jsonl and .evtsq (and no --format)");
}

// A disk file has no horizon and no restitution: they come from the command line.
void disks_to_scene(const Request& request) {
  if (!is_disk_file(request.input)) {
    throw UsageError(
        printable(request.input) +
        ": neither a disk file nor paths (.csv, .xml): only these are made into scenes");
  }
  if (!request.radius.empty() || request.stay || request.contacts == "pass") {
    throw UsageError("--radius, --stay, --contacts: a disk file gives radii, and no paths");
  }
  DiskFile disks = read_disk_file(request.input);
  if (request.horizon.empty()) {
    throw UsageError("a disk file has no horizon: give --horizon");
  }
  Scene& scene = disks.scene;
  scene.horizon = time_argument("--horizon", request.horizon);
  if (!request.restitution.empty()) {
    scene.restitution = time_argument("--restitution", request.restitution);
    if (scene.restitution > 1 || scene.restitution == 0) {
      throw UsageError("--restitution: not in (0, 1]");
    }
    scene.container_restitution = scene.restitution;
  }
  for (std::size_t k = 0; k < scene.disks.size(); ++k) {
    if (scene.disks[k].mass == 0 && scene.disks.size() > 1) {
      throw InputError(request.input, 0, "disk " + std::to_string(disks.ids[k]),
                       "a point has no mass there, and a scene must give it one");
    }
  }
  std::ostringstream text;
  write_scene(text, scene);
  write_output(request.output, text.str());
  if (!disks.ids.empty() && disks.ids.back() != static_cast<std::int64_t>(disks.ids.size()) - 1) {
    words_beside({request.output}) << "the disks are renumbered from 0 in the order of their ids\n";
  }
}

// Given paths keep to themselves: where two touch, the disks of a scene would bounce.
void require_apart(const Request& request, const GivenPaths& given) {
  const CooperativeInterruption interruption;
  const GivenClearance clearance(given, [&] { return !interruption.requested(); });
  const auto least = clearance.least();
  if (!least || keeps_clear(*least, 0)) return;
  const auto name = [&](int g) { return printable(given.paths[static_cast<std::size_t>(g)].name); };
  throw InputError(request.input, 0, "disks " + name(least->i) + " and " + name(least->j),
                   (least->distance2 == least->reach * least->reach
                        ? std::string("touch")
                        : "overlap by " + short_text({-gap(*least).hi, -gap(*least).lo})) +
                       " at t = " + number_text(round_nearest(least->t)) +
                       ": the disks of a scene would collide");
}

// Scenes count time from 0.
void tell_start(std::ostream& out, const GivenPaths& given) {
  if (given.paths.empty()) return;
  const Rational start = time_of(given.paths).first;
  if (start != 0) out << "time is counted from t = " << number_text(start) << " of the file\n";
}

// They may touch, overlap, come and go.
void paths_to_world(const Request& request, const GivenPaths& given) {
  const Rational growth =
      request.growth.empty() ? Rational(0) : time_argument("--growth", request.growth);
  const World world = world_of_paths(given, growth, request.input);
  std::ostringstream text;
  write_world(text, world);
  parse_world(text.str(), request.output);  // within the limits of scenes
  write_output(request.output, text.str());
  std::ostream& out = words_beside({request.output});
  out << "the disks follow the piecewise linear paths between the waypoints exactly, each from its "
         "first to its last, and pass through each other\n"
      << "disk k is the k-th of the file that has two waypoints, from 0\n";
  tell_start(out, given);
  for (const std::string& missing : world.missing) out << "missing: " << printable(missing) << '\n';
  for (const std::string& remark : given.remarks) out << remark << '\n';
}

void paths_to_scene(const Request& request) {
  if (!request.horizon.empty() || !request.restitution.empty()) {
    throw UsageError("paths have their own horizon, and no collisions");
  }
  std::optional<Rational> radius;
  if (!request.radius.empty()) radius = time_argument("--radius", request.radius);
  const GivenPaths given =
      read_paths(request.input, radius, request.stay ? Beyond::stays : Beyond::vanishes);
  if (request.contacts == "pass") return paths_to_world(request, given);
  if (!request.growth.empty()) throw UsageError("--growth: only with --contacts pass");
  if (!given.missing.empty()) {
    throw InputError(request.input, given.missing_line, "missing",
                     given.missing.front() + ": a scene cannot say that somebody is missing");
  }
  const Scene scene = scene_of_paths(given, request.input);
  require_apart(request, given);
  std::ostringstream text;
  write_scene(text, scene);
  parse_scene(text.str(), request.output);  // within the limits of scenes
  write_output(request.output, text.str());
  std::ostream& out = words_beside({request.output});
  out << "the disks follow the piecewise linear paths between the waypoints exactly, and "
         "touch nothing\n"
         "disk k is the k-th of the file, from 0; the container is made up\n";
  tell_start(out, given);
  for (const std::string& remark : given.remarks) out << remark << '\n';
}

void scene_to_disks(const Request& request) {
  const Scene scene = read_scene(request.input);
  std::ostringstream text;
  try {
    write_disk_file(text, scene);
  } catch (const UnsuitableScene& e) {
    throw InputError(request.input, 0, "", std::string(e.what()) + ": a disk file cannot say it");
  }
  write_output(request.output, text.str());
  if (!scene.maneuvers.empty()) {
    words_beside({request.output}) << "the maneuvers are left out: a disk file has none\n";
  }
  if (!(scene.extensions.empty() && scene.disk_extensions.empty())) {
    words_beside({request.output}) << "the extensions are left out: a disk file has none\n";
  }
}

void require_scene(const Request& request) {
  if (request.scene.empty()) {
    throw UsageError("the history is to be read with its scene: give --scene");
  }
}

// Writes the history as the file has it: without an initial diagram and velocities.
void sequence_to_history(const Request& request) {
  require_scene(request);
  if (is_disk_file(request.scene)) {
    throw UsageError("--scene: a history names its scene file; convert " +
                     printable(request.scene) + " to a scene first");
  }
  const Claim claim = open_claim(request.scene, request.input);
  HistoryHeader header = claim.history->header();
  header.scene_sha256 = claim.scene.sha256;
  const CooperativeInterruption interruption;
  HistoryWriter writer(request.output);
  writer.header(header);
  while (const auto event = claim.history->next()) {
    interruption.check();
    writer.write(*event);
  }
  if (!claim.history->counts_match()) {
    throw InputError(request.input, claim.history->line(), "number of events",
                     "is not that of the file");
  }
  writer.end();
  writer.close();
  for (const std::string& remark : claim.history->remarks())
    words_beside({request.output}) << printable(remark, 4096) << '\n';
}

void history_to_sequence(const Request& request) {
  require_scene(request);
  Claim counted = open_claim(request.scene, request.input);
  while (counted.history->next()) {
  }
  Claim claim = open_claim(request.scene, request.input);
  const Scene& scene = claim.scene;
  if (scene.container_restitution != scene.restitution ||
      (scene.law == ContainerLaw::normal && scene.restitution != 1)) {
    words_beside({request.output})
        << "the scene's law at the container is not that of an event sequence\n";
  }
  OutputFile file(request.output);
  const EvtsqSource source{.name = std::filesystem::path(request.scene).filename().string(),
                           .history = request.input,
                           .restitution = scene.restitution,
                           .container_center = {round_nearest(scene.cx), round_nearest(scene.cy)}};
  write_evtsq(file, *claim.history, counted.history->counts(), source,
              {.centers = request.version == "1.1", .hexadecimal = request.numbers != "decimal"});
  if (claim.history->counts() != counted.history->counts()) {
    throw InputError(request.input, 0, "", "has other events than when they were counted");
  }
  file.commit();
}

// An option that the file to be written has no use for would be passed over in silence.
void require_use(const Verb& verb, const std::string& option, bool used, const char* written) {
  if (!used && verb.given(option)) {
    throw UsageError(option + ": only where " + written + " is written");
  }
}

ExitCode convert(const Verb& verb, const Request& request) {
  require_distinct({request.input, request.scene}, {request.output});
  const std::string format = format_to_write(request);
  const bool to_json = format == "scene", to_disks = format == "disks";
  const bool to_history = format == "history", to_sequence = format == "evtsq";
  require_use(verb, "--scene", to_history || to_sequence, "a history or event sequence");
  require_use(verb, "--horizon", to_json, "a scene");
  require_use(verb, "--restitution", to_json, "a scene");
  require_use(verb, "--radius", to_json, "a scene");
  require_use(verb, "--stay", to_json, "a scene");
  require_use(verb, "--contacts", to_json, "a scene");
  require_use(verb, "--growth", to_json, "a scene");
  require_use(verb, "--numbers", to_sequence, "an event sequence");
  require_use(verb, "--evtsq-version", to_sequence, "an event sequence");
  const EventLimit limit(request.max_events);
  const std::string_view input = without_compression(request.input);
  if (to_json && (input.ends_with(".csv") || input.ends_with(".xml"))) {
    paths_to_scene(request);
  } else if (to_json) {
    disks_to_scene(request);
  } else if (to_disks) {
    scene_to_disks(request);
  } else if (to_history) {
    sequence_to_history(request);
  } else {
    history_to_sequence(request);
  }
  return ExitCode::ok;
}

}  // namespace

void add_convert(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb(
      "convert", "Translate between this project's formats and those of other programs");
  verb.input(
          "input", request->input,
          "A scene, disk file, history or event sequence, or paths (.csv, .xml: docs/others.md).")
      .required();
  verb.output(request->output,
              "The file to write. Its ending says what it is: .scene.json, .disks.txt, "
              ".history.jsonl or .evtsq.")
      .required();
  verb.choice("--format", {"scene", "disks", "history", "evtsq"}, request->format,
              "What to write, where the name of the output does not say it.");
  verb.input("--scene", request->scene, "The scene of the history or event sequence.");
  verb.text("--horizon", request->horizon, "TIME", "The horizon of the scene that is written.");
  verb.text("--restitution", request->restitution, "E",
            "The restitution of the scene that is written; 1 where it is not given.");
  verb.text("--radius", request->radius, "LENGTH",
            "The radius of every disk, where a file of paths does not give it.");
  verb.flag("--stay", request->stay,
            "Before its first waypoint and after its last a disk of a file of paths stays where it "
            "is.");
  verb.choice("--contacts", {"bounce", "pass"}, request->contacts,
              "Whether the disks of a file of paths may touch: with pass they pass through each "
              "other, come and go, and the scene is of version 2.");
  verb.text("--growth", request->growth, "RATE",
            "By how much a disk that passes grows in a unit of time from each waypoint to the "
            "next, where it has its own radius again.");
  verb.choice(
      "--numbers", {"hexadecimal", "decimal"}, request->numbers,
      "How an .evtsq has its numbers: with all 64 bits, or with 15 digits after the point.");
  verb.choice("--evtsq-version", {"1.0", "1.1"}, request->version,
              "The version of an .evtsq; 1.0 has no centres at collisions.");
  add_max_events(verb, request->max_events);
  verb.example("voroproof convert a.disks.txt --horizon 1000 -o a.scene.json")
      .example("voroproof convert plan_log.xml --radius 0.25 --stay -o a.scene.json")
      .example("voroproof convert tracks.csv --contacts pass --growth 1/2 -o a.scene.json")
      .example("voroproof convert a.evtsq --scene a.scene.json -o a.history.jsonl");
  verb.does([request, &verb] { return convert(verb, *request); });
}

}  // namespace voroproof::internal
