// Maps worlds exactly, and says where an answer does not go with them.
//
// usage: metamorphic [--count N] [--minutes M] [--seed S] [--family NAME] [--relation NAME]
//                    [--out DIRECTORY]
//
// The seeds are S, S + 1, ...; everything is a function of them. Each makes a world and looks at it
// under one relation. Contradictions are written to DIRECTORY, shrunk. Interrupted, it prints the
// counts so far. Exit code 1 where there was a contradiction, and where one of 1000 seeds or more
// left a relation or a family without a world.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "tests/metamorphic/maps.h"
#include "tests/metamorphic/shrink.h"

namespace voroproof::internal::metamorphic {
namespace {

constexpr int most_saved_of_a_kind = 2;

struct Wishes {
  std::int64_t count = 1000;
  double minutes = 0;
  std::uint64_t seed = 1;
  std::string family, out;
  std::optional<Relation> relation;
};

Relation relation_named(const std::string& name) {
  const auto found = std::find(relation_names.begin(), relation_names.end(), name);
  if (found == relation_names.end()) throw std::invalid_argument("there is no relation " + name);
  return static_cast<Relation>(found - relation_names.begin());
}

Wishes parse(int argc, char** argv) {
  Wishes w;
  for (int k = 1; k + 1 < argc; k += 2) {
    const std::string option = argv[k], value = argv[k + 1];
    if (option == "--count") {
      w.count = std::stoll(value);
    } else if (option == "--minutes") {
      w.minutes = std::stod(value);
    } else if (option == "--seed") {
      w.seed = std::stoull(value);
    } else if (option == "--family") {
      const auto names = world_families();
      if (std::find(names.begin(), names.end(), value) == names.end()) {
        throw std::invalid_argument("there is no family " + value);
      }
      w.family = value;
    } else if (option == "--relation") {
      w.relation = relation_named(value);
    } else if (option == "--out") {
      w.out = value;
    } else {
      throw std::invalid_argument("unknown option " + option);
    }
  }
  if (argc % 2 == 0) throw std::invalid_argument("an option without its value");
  return w;
}

Relation relation_of(std::uint64_t seed) {
  adversary::Random random(seed * 0xc2b2ae3d27d4eb4fu + 3);
  const int last = static_cast<int>(Relation::count) - 1;
  // Most of what was ever found was found by other units.
  return random.chance(0.25) ? Relation::units : static_cast<Relation>(random.integer(0, last));
}

std::string told(Relation relation, const World& world, const Contradiction& c) {
  return std::string(name(relation)) + ", " + world.family + ", seed " +
         std::to_string(world.seed) + ": " + c.what +
         (c.ours.answer.empty() ? "" : "\n  " + c.ours.answer + "\n  " + c.theirs.answer) + "\n";
}

void save(const std::string& directory, Relation relation, const World& found) {
  const World world = shrunk(relation, found);
  const Contradiction c = *compare(relation, world).found;
  std::filesystem::create_directories(directory);
  std::string stem = directory + "/" + std::string(name(relation)) + "-" + world.family + "-" +
                     std::to_string(world.seed);
  std::replace(stem.begin() + static_cast<std::ptrdiff_t>(directory.size()), stem.end(), ' ', '-');
  std::ofstream note(stem + ".txt");
  note << told(relation, world, c);
  for (const auto& [side, of] : {std::pair("ours", &c.ours), std::pair("theirs", &c.theirs)}) {
    const std::string name = stem + "." + side, scene = name + ".scene.json";
    const std::string text = testing::text(of->scene);
    std::ofstream(scene) << text;
    note << side << ": " << of->answer << "\n  voroproof simulate " << scene << "\n";
    if (!of->claim) continue;
    const std::string history = name + ".history.jsonl";
    std::ofstream(history) << history_text(*of->claim, parse_scene(text, scene).sha256);
    note << "  voroproof certify " << scene << " " << history << " --tolerance "
         << of->tolerance.get_str() << "\n";
  }
}

struct Count {
  std::int64_t made = 0, contradictions = 0;
};
using Counts = std::map<std::string, Count>;

bool print(const char* title, const Counts& counts) {
  std::printf("%-18s %8s %15s\n", title, "made", "contradictions");
  bool all = true;
  for (const auto& [name, c] : counts) {
    std::printf("%-18s %8lld %15lld\n", name.c_str(), static_cast<long long>(c.made),
                static_cast<long long>(c.contradictions));
    all = all && c.made > 0;
  }
  return all;
}

volatile std::sig_atomic_t interrupted = 0;

int run(const Wishes& w) {
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) { interrupted = 1; });
  }
  Counts by_relation, by_family;
  for (const auto name : relation_names) by_relation[std::string(name)];
  for (const auto& name : world_families()) {
    if (name != adversary::family_names.back()) by_family[name];  // that is made on request alone
  }
  std::map<std::string, int> saved;
  std::int64_t found = 0, too_long = 0;
  const auto start = std::chrono::steady_clock::now();
  const auto minutes = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 60;
  };
  std::int64_t k = 0;
  for (; interrupted == 0 && (w.minutes > 0 ? minutes() < w.minutes : k < w.count); ++k) {
    const auto seed = w.seed + static_cast<std::uint64_t>(k);
    const auto world = world_of(seed, w.family);
    if (!world) continue;
    const Relation relation = w.relation.value_or(relation_of(seed));
    const Comparison comparison = compare(relation, *world);
    too_long += comparison.too_long;
    if (!comparison.made) continue;
    for (Count* count : {&by_relation[std::string(name(relation))], &by_family[world->family]}) {
      ++count->made;
      count->contradictions += comparison.found.has_value();
    }
    if (!comparison.found) continue;
    ++found;
    if (saved[std::string(name(relation)) + world->family]++ >= most_saved_of_a_kind) continue;
    std::cout << told(relation, *world, *comparison.found) << std::flush;
    if (!w.out.empty()) save(w.out, relation, *world);
  }
  const bool relations = print("relation", by_relation), families = print("family", by_family);
  std::printf("%lld seeds, %lld left out for their time, %lld contradictions\n",
              static_cast<long long>(k), static_cast<long long>(too_long),
              static_cast<long long>(found));
  const bool whole = k < 1000 || w.relation || !w.family.empty() || (relations && families);
  if (!whole) std::printf("a relation or a family has no world\n");
  return found == 0 && whole ? 0 : 1;
}

}  // namespace
}  // namespace voroproof::internal::metamorphic

int main(int argc, char** argv) {
  namespace m = voroproof::internal::metamorphic;
  try {
    return m::run(m::parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "metamorphic: %s\n", error.what());
    return 2;
  }
}
