// voroproof-kernel SCENE HISTORY [options]: the verdict of the kernel on a history.
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "certify/kernel/kernel.h"

int main(int argc, char** argv) {
  using namespace voroproof_kernel;
  Options options;
  std::vector<std::string> files;
  bool good = true;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const auto value = [&] { return std::string(k + 1 < argc ? argv[++k] : ""); };
    if (word == "--strict") {
      options.strict = true;
    } else if (word == "--unoriented") {
      options.unoriented = true;
    } else if (word == "--tolerance") {
      options.tolerance = value();
    } else if (word == "--law-tolerance") {
      options.law_tolerance = value();
    } else if (word == "--jobs") {
      options.jobs = std::max(1, std::atoi(value().c_str()));
    } else if (word == "--truth") {
      const std::string truth = value();
      options.truth = truth == "exact" ? Truth::exact : Truth::recorded;
      good = good && (truth == "exact" || truth == "recorded");
    } else {
      good = good && word.substr(0, 2) != "--";
      files.push_back(word);
    }
  }
  if (!good || files.size() != 2) {
    std::cerr << "usage: voroproof-kernel SCENE HISTORY [--truth recorded|exact] [--tolerance T]\n"
                 "       [--law-tolerance R] [--strict] [--unoriented] [--jobs P]\n";
    return 2;
  }
  std::string texts[2];
  for (int k = 0; k < 2; ++k) {
    std::ifstream file(files[k], std::ios::binary);
    texts[k].assign(std::istreambuf_iterator<char>(file), {});
    if (!file) {
      std::cerr << "cannot read " << files[k] << "\n";
      return 2;
    }
  }
  const Result r = check(texts[0], texts[1], options);
  std::cout << lines_of(r);
  const int codes[] = {0, 1, 3, 2};
  return codes[static_cast<int>(r.verdict)];
}
