// Gives a target its kept cases, and changed ones, as often as asked: the same each time.
//
// usage: fuzz TARGET SEEDS... [--runs N] [--seed S] [--out FOLDER]
//
// SEEDS are folders with files, and files. Exit code 1 where there is a find: something thrown that
// is no verdict, a crash, more than a gigabyte of memory, or ten seconds of the processor. The
// bytes are then in FOLDER/find-TARGET. `fuzz --targets` lists the targets, with the runs of the
// tests.
//
// For checkers that are other programs `fuzz --changed FOLDER SEEDS... [--runs N] [--seed S]`
// writes changed pairs of files, FOLDER/0.scene.json, FOLDER/0.history.jsonl and so on.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tests/fuzz/mutation.h"
#include "tests/fuzz/pieces.h"
#include "tests/fuzz/target.h"

namespace voroproof::internal::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_memory = std::size_t{1} << 30;
constexpr int most_seconds = 10;  // of the processor, for one input
constexpr std::size_t most_taken = 512;

// What a handler of signals needs, and what outlives an exception.
std::string find_path, at_hand;

void keep_find() {
  const int file = open(find_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0) return;
  [[maybe_unused]] const ssize_t written = write(file, at_hand.data(), at_hand.size());
  close(file);
}

extern "C" void on_signal(int number) {
  keep_find();
  const char* const what =
      number == SIGPROF ? "fuzz: ten seconds of the processor\n" : "fuzz: a crash\n";
  for (const char* c = what; *c != '\0'; ++c) {
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, c, 1);
  }
  _exit(1);
}

void start_clock() {
  itimerval timer{};
  timer.it_value.tv_sec = most_seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

struct Arguments {
  std::string target, out = ".", changed;
  std::vector<std::string> seeds;
  std::uint64_t runs = 0, seed = 1;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool option = word.starts_with("--");
    if (option && k + 1 == argc) throw std::invalid_argument(word + " needs a value");
    if (word == "--runs") {
      a.runs = std::stoull(argv[++k]);
    } else if (word == "--seed") {
      a.seed = std::stoull(argv[++k]);
    } else if (word == "--out") {
      a.out = argv[++k];
    } else if (word == "--changed") {
      a.changed = argv[++k];
    } else if (option) {
      throw std::invalid_argument("unknown option " + word);
    } else if (a.target.empty() && a.changed.empty()) {
      a.target = word;
    } else {
      a.seeds.push_back(word);
    }
  }
  if (a.target.empty() == a.changed.empty() || a.seeds.empty()) {
    throw std::invalid_argument("a target or --changed, and seeds");
  }
  return a;
}

std::vector<std::string> texts_of(const std::vector<std::string>& places) {
  std::vector<fs::path> files;
  for (const fs::path place : places) {
    if (!fs::is_directory(place)) {
      files.push_back(place);
      continue;
    }
    for (const auto& entry : fs::directory_iterator(place)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::invalid_argument("cannot read " + file.string());
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  if (texts.empty()) throw std::invalid_argument("there are no seeds");
  return texts;
}

int write_changed(const Arguments& arguments) {
  const std::vector<std::string> seeds = texts_of(arguments.seeds);
  Chance chance(arguments.seed);
  for (std::uint64_t k = 0; k < arguments.runs; ++k) {
    const std::string& from = seeds[chance.below(seeds.size())];
    auto pieces = pieces_of(mutated(from, seeds[chance.below(seeds.size())], chance), 2);
    name_scene(pieces[1], pieces[0]);
    const fs::path to = fs::path(arguments.changed) / std::to_string(k);
    for (const auto& [ending, piece] :
         {std::pair(".scene.json", pieces[0]), std::pair(".history.jsonl", pieces[1])}) {
      std::ofstream out(to.string() + ending, std::ios::binary);
      out << piece;
      out.close();
      if (!out) throw std::invalid_argument("cannot write " + to.string() + ending);
    }
  }
  return 0;
}

int run(const Arguments& arguments) {
  const Target& asked = target(arguments.target);
  find_path = (fs::path(arguments.out) / ("find-" + arguments.target)).string();
  const std::vector<std::string> seeds = texts_of(arguments.seeds);
  // What is accepted though it was changed: where further changes are most likely to get far.
  std::vector<std::string> taken;
  std::uint64_t accepted = 0, refused = 0;
  const auto ask = [&](std::string input) {
    at_hand = std::move(input);
    start_clock();
    const bool good = asked.accepts(at_hand);
    ++(good ? accepted : refused);
    return good;
  };
  try {
    for (const std::string& seed : seeds) ask(seed);
    Chance chance(arguments.seed);
    for (std::uint64_t k = 0; k < arguments.runs; ++k) {
      const bool further = !taken.empty() && chance.below(3) == 0;
      const std::string& from =
          further ? taken[chance.below(taken.size())] : seeds[chance.below(seeds.size())];
      if (!ask(mutated(from, seeds[chance.below(seeds.size())], chance))) continue;
      if (taken.size() < most_taken) {
        taken.push_back(at_hand);
      } else {
        taken[chance.below(taken.size())] = at_hand;
      }
    }
  } catch (const std::exception& find) {
    keep_find();
    std::fprintf(stderr, "fuzz: %s: %s\n", find_path.c_str(), find.what());
    return 1;
  }
  std::printf("%-14s %8zu seeds %10llu runs %10llu accepted %10llu refused\n",
              arguments.target.c_str(), seeds.size(),
              static_cast<unsigned long long>(arguments.runs),
              static_cast<unsigned long long>(accepted), static_cast<unsigned long long>(refused));
  return 0;
}

void prepare() {
#if !defined(__SANITIZE_ADDRESS__)
  const rlimit memory{most_memory, most_memory};
  setrlimit(RLIMIT_DATA, &memory);
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) signal(number, on_signal);
#endif
  for (const int number : {SIGABRT, SIGPROF}) signal(number, on_signal);
}

}  // namespace
}  // namespace voroproof::internal::fuzz

int main(int argc, char** argv) {
  using namespace voroproof::internal::fuzz;
  if (argc == 2 && std::string(argv[1]) == "--targets") {
    for (const Target& t : targets()) {
      std::printf("%.*s %d\n", static_cast<int>(t.name.size()), t.name.data(), t.runs);
    }
    return 0;
  }
  try {
    prepare();
    const Arguments arguments = parse(argc, argv);
    return arguments.changed.empty() ? run(arguments) : write_changed(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz: %s\n", error.what());
    return 2;
  }
}
