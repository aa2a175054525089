// Asks the proved checker (docs/proved.md) of worlds under the recorded truth, and says which it
// accepts.
//
// usage: proved_worlds PROVED [--count N] [--seed S] [--right-every R] [--out DIRECTORY]
//
// PROVED is the program voroproof-proved. The seeds from S on make worlds until N wrong ones have
// been judged: those that the kernel refutes. Of those that it certifies one seed in R is asked of,
// to see that the checker accepts right ones at all. A find is a world that the checker accepts and
// the kernel or the certifier refutes, or of which it says anything but CERTIFIED
// and UNDECIDED (INVALID, where the kernel does not);
// its files are written to DIRECTORY. Interrupted, it prints the counts so far. Exit code 1 where
// there was a find.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/adversary/campaign.h"

namespace voroproof::internal::adversary {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string program, out;
  std::int64_t count = 1000;
  std::uint64_t seed = 1, right_every = 10;
};

Arguments parse(int argc, char** argv) {
  if (argc < 2 || argc % 2 != 0) {
    throw std::invalid_argument(
        "usage: proved_worlds PROVED [--count N] [--seed S] [--right-every R] [--out DIRECTORY]");
  }
  Arguments a{.program = argv[1], .out = {}};
  for (int k = 2; k < argc; k += 2) {
    const std::string option = argv[k], value = argv[k + 1];
    if (option == "--count") {
      a.count = std::stoll(value);
    } else if (option == "--seed") {
      a.seed = std::stoull(value);
    } else if (option == "--right-every") {
      a.right_every = std::max<std::uint64_t>(1, std::stoull(value));
    } else if (option == "--out") {
      a.out = value;
    } else {
      throw std::invalid_argument("unknown option " + option);
    }
  }
  return a;
}

// A folder that is gone with this object.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "proved-worlds-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

// What a program prints, and its exit code; -1 where it could not be run or ended otherwise.
std::pair<std::string, int> output_of(std::string program, std::string scene, std::string history) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  std::array<char*, 4> words{program.data(), scene.data(), history.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t n = 1; failed == 0 && n > 0;) {
    n = ::read(ends[0], part.data(), part.size());
    if (n > 0) text.append(part.data(), static_cast<std::size_t>(n));
  }
  close(ends[0]);
  int status = 0;
  if (failed != 0 || waitpid(child, &status, 0) != child) return {text, -1};
  return {text, WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

// The verdict by the last line and the exit code, the reason by the line before.
Answer ask_proved(const std::string& program, const fs::path& scene, const fs::path& history) {
  auto [text, code] = output_of(program, scene.string(), history.string());
  if (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t last = text.rfind('\n');
  const std::string verdict = text.substr(last == std::string::npos ? 0 : last + 1);
  std::string reason = last == std::string::npos ? "" : text.substr(0, last);
  reason = reason.substr(reason.rfind('\n') + 1);
  if (verdict == "s CERTIFIED" && code == 0) return {Verdict::certified, {}};
  if (verdict == "s UNDECIDED" && code == 3) return {Verdict::undecided, reason};
  if (verdict == "s INVALID" && code == 2) return {Verdict::invalid, reason};
  return {Verdict::failed, text + " (exit code " + std::to_string(code) + ")"};
}

// The kind of a reason: "c line 12: " is left out.
std::string words(const std::string& reason) {
  const std::size_t colon = reason.starts_with("c line ") ? reason.find(": ") : std::string::npos;
  return colon == std::string::npos ? reason.substr(std::min<std::size_t>(2, reason.size()))
                                    : reason.substr(colon + 2);
}

// How many of a kind were asked of, by the kernel's verdict and that of the proved checker.
using Table = std::map<std::string, std::map<std::pair<Verdict, Verdict>, std::int64_t>>;

void print(const char* title, const Table& table) {
  std::printf("%-18s |%8s %8s %8s |%8s %8s |%8s %8s\n", title, "wrong", "accepted", "undec.",
              "open", "accepted", "right", "accepted");
  for (const auto& row : table) {
    const auto& counts = row.second;  // clang++ 14 captures no structured binding
    const auto at = [&](Verdict kernel, Verdict proved) {
      const auto found = counts.find({kernel, proved});
      return static_cast<long long>(found == counts.end() ? 0 : found->second);
    };
    const auto both = [&](Verdict kernel) {
      return at(kernel, Verdict::certified) + at(kernel, Verdict::undecided);
    };
    std::printf("%-18s |%8lld %8lld %8lld |%8lld %8lld |%8lld %8lld\n", row.first.c_str(),
                both(Verdict::refuted), at(Verdict::refuted, Verdict::certified),
                at(Verdict::refuted, Verdict::undecided), both(Verdict::undecided),
                at(Verdict::undecided, Verdict::certified), both(Verdict::certified),
                at(Verdict::certified, Verdict::certified));
  }
}

volatile std::sig_atomic_t interrupted = 0;

class ProvedCampaign {
 public:
  explicit ProvedCampaign(Arguments arguments) : a_(std::move(arguments)) {}

  int run() {
    std::uint64_t seed = a_.seed;
    for (; wrong_ < a_.count && interrupted == 0; ++seed) judge_seed(seed);
    print("fault", by_kind_);
    print("family", by_family_);
    print("", all_);
    for (const auto& [reason, times] : undecided_) {
      std::printf("%8lld  %s\n", static_cast<long long>(times), reason.c_str());
    }
    std::printf("seeds %llu to %llu: %lld wrong worlds, %lld finds\n",
                static_cast<unsigned long long>(a_.seed), static_cast<unsigned long long>(seed - 1),
                static_cast<long long>(wrong_), static_cast<long long>(finds_));
    return finds_ > 0 ? 1 : 0;
  }

 private:
  void judge_seed(std::uint64_t seed) {
    Recipe recipe = recipe_of(seed, {}, {});
    recipe.units = {};  // with the usual tolerance
    const auto made = make(recipe);
    const auto scene = made ? read(*made) : std::nullopt;
    if (!scene) return;
    const bool long_decimals = made->recipe.long_decimals;
    const Judgement j =
        judge(*scene, made->history, Truth::recorded, {.long_decimals = long_decimals});
    if (j.kernel.verdict == Verdict::absent) {
      throw std::runtime_error("this build has no kernel");
    }
    if (j.kernel.verdict == Verdict::certified && seed % a_.right_every != 0) return;
    std::ofstream(scratch_ / "scene") << scene->text;
    std::ofstream(scratch_ / "history")
        << history_text(made->history, scene->scene.sha256, long_decimals);
    const Answer proved = ask_proved(a_.program, scratch_ / "scene", scratch_ / "history");
    if (interrupted != 0) return;  // the checker was, too
    const std::pair verdicts{j.kernel.verdict, proved.verdict};
    ++by_kind_[kind_of(made->recipe)][verdicts];
    ++by_family_[std::string(name(made->recipe.family))][verdicts];
    ++all_["all"][verdicts];
    wrong_ += j.kernel.verdict == Verdict::refuted;
    const bool right = j.kernel.verdict == Verdict::certified;
    if (right && proved.verdict == Verdict::undecided) ++undecided_[words(proved.reason)];
    const bool denied =
        j.kernel.verdict == Verdict::refuted || j.certifier.verdict == Verdict::refuted;
    const bool known = proved.verdict == Verdict::certified ||
                       proved.verdict == Verdict::undecided ||
                       (proved.verdict == Verdict::invalid && j.kernel.verdict == Verdict::invalid);
    if (!known || (denied && proved.verdict == Verdict::certified)) save(*made, j, proved);
  }

  void save(const Made& made, const Judgement& j, const Answer& proved) {
    ++finds_;
    std::printf("seed %llu, family %s, %s: proved checker %s (%s), kernel %s (%s), certifier %s\n",
                static_cast<unsigned long long>(made.recipe.seed),
                std::string(name(made.recipe.family)).c_str(), kind_of(made.recipe).c_str(),
                name(proved.verdict), proved.reason.c_str(), name(j.kernel.verdict),
                j.kernel.reason.c_str(), name(j.certifier.verdict));
    std::fflush(stdout);
    if (a_.out.empty()) return;
    fs::create_directories(a_.out);
    const std::string stem = (fs::path(a_.out) / std::to_string(made.recipe.seed)).string();
    const auto replace = fs::copy_options::overwrite_existing;
    fs::copy_file(scratch_ / "scene", stem + ".scene.json", replace);
    fs::copy_file(scratch_ / "history", stem + ".history.jsonl", replace);
  }

  Arguments a_;
  Scratch scratch_;
  Table by_kind_, by_family_, all_;
  std::map<std::string, std::int64_t> undecided_;  // why right worlds are
  std::int64_t wrong_ = 0, finds_ = 0;
};

}  // namespace
}  // namespace voroproof::internal::adversary

int main(int argc, char** argv) {
  using namespace voroproof::internal::adversary;
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) { interrupted = 1; });
  }
  try {
    return ProvedCampaign(parse(argc, argv)).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "proved_worlds: %s\n", error.what());
    return 2;
  }
}
