// voroproof generate: scenes of the corpus' families.
#include <charconv>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/verbs/verbs.h"
#include "corpus/generate.h"
#include "corpus/paper_sets.h"
#include "history/error.h"
#include "history/output_file.h"
#include "history/scene_writer.h"

namespace voroproof::internal {
namespace {

template <class Options>
struct Request {
  Options options;
  std::string output;
};

template <class Options>
ExitCode generate(const Request<Options>& request, Scene (*make)(const Options&)) {
  std::ostringstream text;
  try {
    write_scene(text, make(request.options));
    // Extreme options may lead beyond the limits of a scene or of binary64's precision.
    parse_scene(text.view(), request.output);
  } catch (const InputError& fault) {
    throw UsageError("generate: these options give no valid scene: " + fault.field() + ": " +
                     fault.reason());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& refusal) {
    throw UsageError(refusal.what());
  }
  const CooperativeInterruption interruption;
  OutputFile file(request.output);
  file.write(text.view());
  interruption.check();
  file.commit();
  return ExitCode::ok;
}

// A family with the options that all have; the caller adds its own.
template <class Options>
struct Family {
  Family(Verb& generate_verb, const std::string& name, const std::string& description,
         Scene (*make)(const Options&), int most = max_disks)
      : verb(generate_verb.add_verb(name, description)),
        request(std::make_shared<Request<Options>>()),
        options(request->options) {
    verb.whole("--n", options.n, 0, static_cast<std::uint64_t>(most), "The number of disks.");
    verb.real("--horizon", options.horizon, "The horizon of the scene.");
    verb.output(request->output, "The scene to write.").required();
    // The action keeps the options alive.
    verb.does([request = request, make] { return generate<Options>(*request, make); });
  }

  Verb& verb;
  std::shared_ptr<Request<Options>> request;
  Options& options;
};

template <class Options>
void add_seed(const Family<Options>& family) {
  family.verb.whole("--seed", family.options.seed, 0, most_whole,
                    "The seed of the random numbers.");
}

// An option whose value is an enumerator, chosen by its name.
template <class Enum>
void add_enum(Verb& verb, const std::string& name,
              const std::vector<std::pair<std::string, Enum>>& names, Enum& value,
              const std::string& help) {
  Option option{.names = {name}, .type = "NAME", .help = help};
  for (const auto& [text, enumerator] : names) {
    option.choices.push_back(text);
    if (enumerator == value) option.initial = text;
  }
  option.take = [names, &value](const std::vector<std::string>& values) {
    for (const auto& [text, enumerator] : names) {
      if (text == values[0]) value = enumerator;
    }
  };
  verb.add(std::move(option));
}

// Puts the member NAME:NUMBER of the paper's data sets in place of all options but seed and
// horizon.
void take_set(ReferenceOptions& options, const std::string& text) {
  const std::size_t colon = text.find(':');
  int k = 0;
  const char* const end = text.data() + text.size();
  if (colon == std::string::npos || std::from_chars(text.data() + colon + 1, end, k).ptr != end) {
    throw UsageError("--set: " + text + " is not of the form NAME:NUMBER");
  }
  const std::uint64_t seed = options.seed;
  const double horizon = options.horizon;
  try {
    options = paper_set_member(text.substr(0, colon), k);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(std::string("--set: ") + fault.what());
  }
  options.seed = seed;
  options.horizon = horizon;
}

void add_reference(Verb& generate_verb) {
  using Radii = ReferenceOptions::Radii;
  const Family<ReferenceOptions> family(
      generate_verb, "reference",
      "Disjoint disks of random radii at random places with random directions and one speed",
      &generate_reference);
  add_seed(family);
  Verb& verb = family.verb;
  ReferenceOptions& options = family.options;
  add_enum(verb, "--radii",
           {{"uniform", Radii::uniform}, {"log", Radii::log}, {"equal", Radii::equal}},
           options.radii,
           "The distribution of the radii; log: their logarithm is uniform; equal: all are rmax.");
  verb.real("--rmin", options.rmin, "The least radius.");
  verb.real("--rmax", options.rmax, "The largest radius.");
  verb.real("--density", options.density,
            "The area of the disks divided by the area of the container.");
  verb.real("--speed", options.speed, "The speed of every disk.");
  verb.real("--restitution", options.restitution, "The restitution between disks, 0 to 1.");
  verb.add({.names = {"--set"},
            .type = "NAME:NUMBER",
            .help = "A member of the paper's data sets, which replaces all options but seed and "
                    "horizon: reference, speed, size, density (:1 to :10), restitution (:1 to :5).",
            .take = [&options](const std::vector<std::string>& v) { take_set(options, v[0]); }})
      .excludes({"--n", "--radii", "--rmin", "--rmax", "--density", "--speed", "--restitution"});
  verb.example("voroproof generate reference --n 1000 --seed 7 -o a.scene.json");
}

void add_grid(Verb& generate_verb) {
  using Motion = GridOptions::Motion;
  const Family<GridOptions> family(generate_verb, "grid",
                                   "Equal disks on a square lattice: many ties", &generate_grid);
  add_seed(family);
  Verb& verb = family.verb;
  GridOptions& options = family.options;
  add_enum(verb, "--motion",
           {{"rest", Motion::rest},
            {"common", Motion::common},
            {"random", Motion::random},
            {"shear", Motion::shear}},
           options.motion, "The motion; common: one velocity; random: random directions.");
  verb.real("--spacing", options.spacing, "The spacing of the lattice, at least 2 radii.");
  verb.real("--radius", options.radius, "The radius of every disk.");
  verb.real("--speed", options.speed, "The largest speed of a disk.");
  verb.example("voroproof generate grid --n 100 --motion shear -o a.scene.json");
}

void add_swarm(Verb& generate_verb) {
  const Family<SwarmOptions> family(
      generate_verb, "swarm", "Equal disks fly from a square lattice to a circle and stop there",
      &generate_swarm);
  add_seed(family);
  Verb& verb = family.verb;
  SwarmOptions& options = family.options;
  verb.real("--spacing", options.spacing, "The spacing of the lattice, more than 2 radii.");
  verb.real("--radius", options.radius, "The radius of every disk.");
  verb.example("voroproof generate swarm --n 40 -o a.scene.json");
}

// Splits the text at its commas.
std::vector<std::string> parts(const std::string& text) {
  std::vector<std::string> result(1);
  for (const char c : text) {
    if (c == ',') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

void take_preset(FormationOptions& options, const std::string& name) {
  const FormationOptions preset = formation_preset(name);
  options.n = preset.n;
  options.flight = preset.flight;
  options.horizon = preset.horizon;
}

void add_formation(Verb& generate_verb) {
  const Family<FormationOptions> family(
      generate_verb, "formation", "Equal disks fly from formation to formation without collisions",
      &generate_formation, max_formation_disks);
  Verb& verb = family.verb;
  FormationOptions& options = family.options;
  verb.add(
      {.names = {"--flight"},
       .type = "NAME,...",
       .help = "A formation, then formations (square, staggered, frame, circle, rings, h, y) "
               "and moves (east, north, west, south, turn, shear, spread, rest).",
       .initial = "frame,circle",
       .take = [&options](const std::vector<std::string>& v) { options.flight = parts(v[0]); }});
  verb.real("--spacing", options.spacing, "The spacing of every formation, more than 2 radii.");
  verb.real("--radius", options.radius, "The radius of every disk.");
  verb.add({.names = {"--preset"},
            .type = "NAME",
            .help = "A swarm of the paper's: its number, flight and horizon.",
            .choices = {"figure24", "h-to-y", "segments58", "drones1218", "drones2018"},
            .take = [&options](const std::vector<std::string>& v) { take_preset(options, v[0]); }})
      .excludes({"--n", "--horizon", "--flight"});
  verb.example("voroproof generate formation --preset drones2018 -o a.scene.json");
}

}  // namespace

void add_generate(Verb& program) {
  Verb& verb = program.add_verb("generate", "Write a scene of one of four families");
  add_reference(verb);
  add_grid(verb);
  add_swarm(verb);
  add_formation(verb);
  verb.example("voroproof generate reference --n 1000 -o a.scene.json");
}

}  // namespace voroproof::internal
