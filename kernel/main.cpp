// voroproof-kernel SCENE HISTORY [options]: the verdict of the kernel on a history.
#include <fstream>
#include <iostream>
#include <sstream>

#include "kernel/kernel.h"

namespace {

using namespace voroproof_kernel;

constexpr const char* kUsage =
    "usage: voroproof-kernel SCENE HISTORY [--truth recorded|exact] [--tolerance T]\n"
    "       [--law-tolerance R] [--strict] [--unoriented] [--jobs P]\n";

bool read(const std::string& path, std::string& text) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream all;
  all << file.rdbuf();
  text = all.str();
  return file.good();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  std::string files[2];
  int given = 0;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const auto value = [&] { return std::string(k + 1 < argc ? argv[++k] : ""); };
    if (word == "--strict")
      options.strict = true;
    else if (word == "--unoriented")
      options.unoriented = true;
    else if (word == "--tolerance")
      options.tolerance = value();
    else if (word == "--law-tolerance")
      options.law_tolerance = value();
    else if (word == "--jobs")
      options.jobs = std::max(1, std::atoi(value().c_str()));
    else if (word == "--truth") {
      const std::string truth = value();
      if (truth == "exact") options.truth = Truth::exact;
      if (truth != "exact" && truth != "recorded") given = 3;
    } else if (given < 2 && word.substr(0, 2) != "--")
      files[given++] = word;
    else
      given = 3;
  }
  if (given != 2) {
    std::cerr << kUsage;
    return 2;
  }
  std::string scene, history;
  if (!read(files[0], scene) || !read(files[1], history)) {
    std::cerr << "cannot read the files\n";
    return 2;
  }
  const Result r = check(scene, history, options);
  const Counts& c = r.counts;
  std::cout << "c " << c.flips << " flips, " << c.collisions << " collisions, " << c.maneuvers
            << " maneuvers; " << c.lives << " lives of edges, " << c.pair_lives << " of pairs, "
            << c.fresh_proofs << " fresh proofs\n"
            << "c " << c.swaps << " swaps, " << c.grazes << " grazes, " << c.rounding_overlaps
            << " overlaps by rounding, " << c.horizon_events << " events at the horizon, "
            << c.unoriented << " quadruplets without orientation\n";
  if (!r.horizon_note.empty()) std::cout << "c " << r.horizon_note << "\n";
  if (!r.reason.empty()) {
    std::cout << "c ";
    if (r.line > 0) std::cout << "line " << r.line << ": ";
    std::cout << r.reason << "\n";
  }
  const char* words[] = {"CERTIFIED", "REFUTED", "UNDECIDED", "INVALID"};
  const int codes[] = {0, 1, 3, 2};
  std::cout << "s " << words[static_cast<int>(r.verdict)] << "\n";
  return codes[static_cast<int>(r.verdict)];
}
