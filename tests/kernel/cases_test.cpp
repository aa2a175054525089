// Histories that the kernel once judged wrongly, or that tell a faulty kernel from a right one:
// cases/NAME.scene.json, NAME.history.jsonl and NAME.verdict, lines "truth tolerance verdict
// [unoriented]".
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "tests/kernel/histories.h"

namespace voroproof_kernel {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

TEST(KernelCases, HaveTheirVerdicts) {
  const std::map<std::string, Verdict> verdicts{{"certified", Verdict::certified},
                                                {"refuted", Verdict::refuted},
                                                {"undecided", Verdict::undecided}};
  const std::filesystem::path folder(VOROPROOF_KERNEL_CASES);
  int judged = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".verdict") continue;
    const std::string stem = (folder / entry.path().stem()).string();
    std::ifstream expected(entry.path());
    for (std::string line; std::getline(expected, line);) {
      std::istringstream words(line);
      std::string truth, verdict, unoriented;
      Options options;
      words >> truth >> options.tolerance >> verdict >> unoriented;
      options.unoriented = !unoriented.empty();
      options.truth = truth == "exact" ? Truth::exact : Truth::recorded;
      const Result r =
          check(text_of(stem + ".scene.json"), text_of(stem + ".history.jsonl"), options);
      EXPECT_EQ(r.verdict, verdicts.at(verdict)) << stem << ", " << truth << ": " << r.reason;
      ++judged;
    }
  }
  EXPECT_GT(judged, 0);
}

}  // namespace
}  // namespace voroproof_kernel
