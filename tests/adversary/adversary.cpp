// Runs wrong worlds against the certifier and the kernel, and says where they fail.
//
// usage: adversary [--count N] [--minutes M] [--seed S] [--family NAME] [--fault NAME]
//                  [--out DIRECTORY] [--kernel-every N] [--all] [--quiet] [--slips]
//
// The seeds are S, S + 1, ...; everything is a function of them. Finds are written to DIRECTORY,
// minimized. The kernel, which takes most of the time, is asked of one seed in N. --all asks the
// oracle of all histories. --slips also tells of histories that were meant right and are not.
// Interrupted, it prints the counts so far. Exit code 1 where there was a find.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

#include "tests/adversary/campaign.h"

namespace voroproof::internal::adversary {
namespace {

constexpr int most_saved_of_a_kind = 3;

struct Arguments {
  std::int64_t count = 1000;
  double minutes = 0;
  std::uint64_t seed = 1, kernel_every = 1;
  std::optional<Family> family;
  std::optional<FaultKind> fault;
  std::string out;
  bool all = false, quiet = false, slips = false;
};

template <class Kind, std::size_t N>
Kind named(const std::array<std::string_view, N>& names, const std::string& name) {
  for (std::size_t k = 0; k < N; ++k) {
    if (names[k] == name) return static_cast<Kind>(k);
  }
  throw std::invalid_argument("there is no " + name);
}

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int k = 1; k < argc; ++k) {
    const std::string option = argv[k];
    if (option == "--all" || option == "--quiet" || option == "--slips") {
      (option == "--all" ? a.all : option == "--quiet" ? a.quiet : a.slips) = true;
      continue;
    }
    if (k + 1 == argc) throw std::invalid_argument(option + " needs a value, or is unknown");
    const std::string value = argv[++k];
    if (option == "--count") {
      a.count = std::stoll(value);
    } else if (option == "--minutes") {
      a.minutes = std::stod(value);
    } else if (option == "--seed") {
      a.seed = std::stoull(value);
    } else if (option == "--kernel-every") {
      a.kernel_every = std::max<std::uint64_t>(1, std::stoull(value));
    } else if (option == "--family") {
      a.family = named<Family>(family_names, value);
    } else if (option == "--fault") {
      a.fault = named<FaultKind>(fault_names, value);
    } else if (option == "--out") {
      a.out = value;
    } else {
      throw std::invalid_argument("unknown option " + option);
    }
  }
  return a;
}

void describe(std::ostream& out, const Made& m, Truth truth, const Judgement& j) {
  out << "# " << name(find_of(j)) << ": seed " << m.recipe.seed << ", family "
      << name(m.recipe.family) << ", fault " << name(m.recipe.fault.kind) << " (nth "
      << m.recipe.fault.nth << ", amount " << m.recipe.fault.amount << ")"
      << (m.recipe.fuzzed ? ", fuzzed" : "") << ", rewriting "
      << static_cast<int>(m.recipe.rewriting) << ", n " << m.scene.size() << ", lines "
      << m.history.lines.size() << ", truth " << name(truth) << "\n#   certifier "
      << name(j.certifier.verdict) << " " << j.certifier.reason << "\n";
  if (m.recipe.units.length != 0 || m.recipe.units.time != 0) {
    out << "#   lengths times 2^" << m.recipe.units.length << ", times times 2^"
        << m.recipe.units.time << ": --tolerance " << tolerance_in(m.recipe.units) << "\n";
  }
  if (j.kernel.verdict != Verdict::absent) {
    out << "#   kernel " << name(j.kernel.verdict) << " " << j.kernel.reason << "\n";
  }
  if (j.opinion) {
    out << "#   oracle " << static_cast<int>(j.opinion->finding) << " " << j.opinion->why << "\n";
  }
}

void save(const std::string& directory, const Made& found, Truth truth, Find find) {
  const Made m = minimized(found, truth, find);
  const auto scene = read(m);
  if (!scene) return;
  std::filesystem::create_directories(directory);
  std::string stem =
      directory + "/" + kind_of(m.recipe) + "-" + std::to_string(m.recipe.seed) + "-" + name(truth);
  std::replace(stem.begin(), stem.end(), ' ', '-');
  std::ofstream(stem + ".scene.json") << scene->text;
  std::ofstream(stem + ".history.jsonl") << history_text(
      in_units(m.history, m.recipe.units), scene->scene.sha256, m.recipe.long_decimals);
  std::ofstream note(stem + ".txt");
  describe(note, m, truth, judge_all(*scene, m, truth, true, true));
}

void print(const char* title, const std::map<std::pair<std::string, int>, Count>& counts) {
  std::printf("%-18s %-8s %8s |%8s %8s %6s |%8s %8s %6s |%8s %8s %6s |%6s %6s %6s %6s %6s\n", title,
              "truth", "made", "c:cert", "c:ref", "c:und", "k:cert", "k:ref", "k:und", "right",
              "wrong", "uncl", "cC-W", "kC-W", "cR-R", "kR-R", "C-K");
  for (const auto& [key, c] : counts) {
    const auto at = [](const auto& a, auto k) {
      return static_cast<long long>(a[static_cast<std::size_t>(k)]);
    };
    std::printf(
        "%-18s %-8s %8lld |%8lld %8lld %6lld |%8lld %8lld %6lld |%8lld %8lld %6lld |%6lld %6lld "
        "%6lld %6lld %6lld\n",
        key.first.c_str(), name(static_cast<Truth>(key.second)), static_cast<long long>(c.made),
        at(c.certifier, Verdict::certified), at(c.certifier, Verdict::refuted),
        at(c.certifier, Verdict::undecided), at(c.kernel, Verdict::certified),
        at(c.kernel, Verdict::refuted), at(c.kernel, Verdict::undecided),
        static_cast<long long>(c.oracle_right), static_cast<long long>(c.oracle_wrong),
        static_cast<long long>(c.oracle_unclear), at(c.finds, Find::certifier_lax),
        at(c.finds, Find::kernel_lax), at(c.finds, Find::certifier_strict),
        at(c.finds, Find::kernel_strict), at(c.finds, Find::disagreement));
  }
}

volatile std::sig_atomic_t interrupted = 0;

int run(const Arguments& a) {
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) { interrupted = 1; });
  }
  Campaign campaign(a.all, a.kernel_every);
  std::map<std::string, int> saved;
  std::array<std::int64_t, static_cast<std::size_t>(Find::count)> finds{};
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (std::uint64_t k = 0; interrupted == 0; ++k) {
    if (a.minutes > 0 ? seconds() > 60 * a.minutes : static_cast<std::int64_t>(k) >= a.count) break;
    campaign.run(
        a.seed + k, a.family, a.fault, [&](const Made& made, Truth truth, const Judgement& j) {
          const Find find = find_of(j);
          if (find == Find::none) {
            const bool slip = made.recipe.fault.kind == FaultKind::none && !made.recipe.fuzzed &&
                              j.opinion && j.opinion->finding == Finding::wrong;
            if (slip && a.slips) describe(std::cout, made, truth, j);
            return;
          }
          ++finds[static_cast<std::size_t>(find)];
          const std::string kind = std::string(name(find)) + kind_of(made.recipe) +
                                   std::string(name(made.recipe.family)) + name(truth);
          if (saved[kind]++ >= most_saved_of_a_kind) return;
          if (!a.quiet) describe(std::cout, made, truth, j);
          if (!a.out.empty()) save(a.out, made, truth, find);
        });
  }
  print("fault", campaign.by_kind());
  print("family", campaign.by_family());
  for (const auto& [reason, times] : campaign.undecided()) {
    std::printf("undecided %8lld  %s\n", static_cast<long long>(times), reason.c_str());
  }
  const double total = seconds();
  std::printf("%lld histories, each under two truths, in %.1f s (%.0f per second): %.1f s making\n",
              static_cast<long long>(campaign.histories()), total,
              static_cast<double>(campaign.histories()) / total, campaign.seconds_making());
  bool bad = false;
  for (std::size_t f = 1; f < finds.size(); ++f) {
    std::printf("%s: %lld\n", name(static_cast<Find>(f)), static_cast<long long>(finds[f]));
    bad = bad || finds[f] > 0;
  }
  return bad ? 1 : 0;
}

}  // namespace
}  // namespace voroproof::internal::adversary

int main(int argc, char** argv) {
  try {
    return voroproof::internal::adversary::run(voroproof::internal::adversary::parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "adversary: %s\n", error.what());
    return 2;
  }
}
