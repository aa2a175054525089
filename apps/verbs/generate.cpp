// voroproof generate: scenes of the corpus' families.
#include <charconv>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/verbs/verbs.h"
#include "corpus/generate.h"
#include "corpus/paper_sets.h"
#include "history/atomic_file.h"
#include "history/error.h"

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
  AtomicFile file(request.output);
  file.write(text.view());
  interruption.check();
  file.commit();
  return ExitCode::ok;
}

// A family with the options that all have; the caller adds its own.
template <class Options>
struct Family {
  Family(CLI::App& generate_verb, Action& action, const std::string& name,
         const std::string& description, Scene (*make)(const Options&), int most = max_disks)
      : verb(*generate_verb.add_subcommand(name, description)),
        request(std::make_shared<Request<Options>>()),
        options(request->options) {
    verb.add_option("--n", options.n, "number of disks")
        ->check(whole_number())
        ->check(CLI::Range(0, most))
        ->capture_default_str();
    add_real(verb, "--horizon", options.horizon, "of the scene");
    add_output(verb, request->output, "the scene to write");
    // The action keeps the options alive.
    verb.callback([request = request, make, &action] {
      action = [request, make] { return generate<Options>(*request, make); };
    });
  }

  CLI::App& verb;
  std::shared_ptr<Request<Options>> request;
  Options& options;
};

template <class Options>
void add_seed(const Family<Options>& family) {
  family.verb.add_option("--seed", family.options.seed, "of the random numbers")
      ->check(whole_number())
      ->capture_default_str();
}

// An option whose value is an enumerator, chosen by its name.
template <class Enum>
void add_enum(CLI::App& verb, const std::string& name, const std::map<std::string, Enum>& names,
              Enum& value, const std::string& description) {
  std::string initial;
  for (const auto& [text, enumerator] : names) {
    if (enumerator == value) initial = text;
  }
  verb.add_option_function<std::string>(
          name, [&names, &value](const std::string& text) { value = names.at(text); }, description)
      ->check(CLI::IsMember(&names))
      ->type_name("NAME")
      ->default_str(initial);
}

void add_reference(CLI::App& generate_verb, Action& action) {
  using Radii = ReferenceOptions::Radii;
  static const std::map<std::string, Radii> names{
      {"uniform", Radii::uniform}, {"log", Radii::log}, {"equal", Radii::equal}};
  const Family<ReferenceOptions> family(
      generate_verb, action, "reference",
      "Disjoint disks of random radii at random places with random directions and one speed",
      &generate_reference);
  add_seed(family);
  CLI::App& verb = family.verb;
  ReferenceOptions& options = family.options;
  add_enum(verb, "--radii", names, options.radii,
           "distribution: uniform, log (of the logarithm) or equal (all rmax)");
  add_real(verb, "--rmin", options.rmin, "least radius");
  add_real(verb, "--rmax", options.rmax, "largest radius");
  add_real(verb, "--density", options.density, "area of the disks / area of the container");
  add_real(verb, "--speed", options.speed, "of every disk");
  add_real(verb, "--restitution", options.restitution, "between disks, 0 to 1");
  verb.add_option_function<std::string>(
          "--set",
          [&options](const std::string& text) {
            const std::size_t colon = text.find(':');
            int k = 0;
            const char* const end = text.data() + text.size();
            if (colon == std::string::npos ||
                std::from_chars(text.data() + colon + 1, end, k).ptr != end)
              throw CLI::ValidationError("--set", text + " is not of the form NAME:NUMBER");
            const std::uint64_t seed = options.seed;
            const double horizon = options.horizon;
            try {
              options = paper_set_member(text.substr(0, colon), k);
            } catch (const std::invalid_argument& fault) {
              throw CLI::ValidationError("--set", fault.what());
            }
            options.seed = seed;
            options.horizon = horizon;
          },
          "a member of the paper's data sets in place of the options but seed and horizon:\n"
          "reference, speed, size, density (:1 to :10), restitution (:1 to :5)")
      ->excludes(verb.get_option("--n"), verb.get_option("--radii"), verb.get_option("--rmin"),
                 verb.get_option("--rmax"), verb.get_option("--density"),
                 verb.get_option("--speed"), verb.get_option("--restitution"))
      ->type_name("NAME:NUMBER");
  verb.footer("Example:\n  voroproof generate reference --n 1000 --seed 7 -o a.scene.json");
}

void add_grid(CLI::App& generate_verb, Action& action) {
  using Motion = GridOptions::Motion;
  static const std::map<std::string, Motion> names{{"rest", Motion::rest},
                                                   {"common", Motion::common},
                                                   {"random", Motion::random},
                                                   {"shear", Motion::shear}};
  const Family<GridOptions> family(generate_verb, action, "grid",
                                   "Equal disks on a square lattice: many ties", &generate_grid);
  add_seed(family);
  CLI::App& verb = family.verb;
  GridOptions& options = family.options;
  add_enum(verb, "--motion", names, options.motion,
           "rest, common (one velocity), random (directions) or shear");
  add_real(verb, "--spacing", options.spacing, "of the lattice, at least 2 radii");
  add_real(verb, "--radius", options.radius, "of every disk");
  add_real(verb, "--speed", options.speed, "the largest of a disk");
  verb.footer("Example:\n  voroproof generate grid --n 100 --motion shear -o a.scene.json");
}

void add_swarm(CLI::App& generate_verb, Action& action) {
  const Family<SwarmOptions> family(
      generate_verb, action, "swarm",
      "Equal disks fly from a square lattice to a circle and stop there", &generate_swarm);
  add_seed(family);
  CLI::App& verb = family.verb;
  SwarmOptions& options = family.options;
  add_real(verb, "--spacing", options.spacing, "of the lattice, more than 2 radii");
  add_real(verb, "--radius", options.radius, "of every disk");
  verb.footer("Example:\n  voroproof generate swarm --n 40 -o a.scene.json");
}

// What stands between the commas.
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

void add_formation(CLI::App& generate_verb, Action& action) {
  const Family<FormationOptions> family(
      generate_verb, action, "formation",
      "Equal disks fly from formation to formation without collisions", &generate_formation,
      max_formation_disks);
  CLI::App& verb = family.verb;
  FormationOptions& options = family.options;
  CLI::Option* flight =
      verb.add_option_function<std::string>(
              "--flight", [&options](const std::string& names) { options.flight = parts(names); },
              "a formation, then formations (square, staggered, frame, circle, rings, h, y) and "
              "moves (east, north, west, south, turn, shear, spread, rest)")
          ->type_name("NAME,...")
          ->default_str("frame,circle");
  add_real(verb, "--spacing", options.spacing, "of every formation, more than 2 radii");
  add_real(verb, "--radius", options.radius, "of every disk");
  verb.add_option_function<std::string>(
          "--preset",
          [&options](const std::string& name) {
            const FormationOptions preset = formation_preset(name);
            options.n = preset.n;
            options.flight = preset.flight;
            options.horizon = preset.horizon;
          },
          "number, flight and horizon of a swarm of the paper's")
      ->check(CLI::IsMember({"figure24", "h-to-y", "segments58", "drones1218", "drones2018"}))
      ->excludes(verb.get_option("--n"), verb.get_option("--horizon"), flight)
      ->type_name("NAME");
  verb.footer("Example:\n  voroproof generate formation --preset drones2018 -o a.scene.json");
}

}  // namespace

void add_generate(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("generate", "Write a scene of one of four families");
  verb->require_subcommand(1);
  add_reference(*verb, action);
  add_grid(*verb, action);
  add_swarm(*verb, action);
  add_formation(*verb, action);
  verb->footer("Example:\n  voroproof generate reference --n 1000 -o a.scene.json");
}

}  // namespace voroproof::internal
