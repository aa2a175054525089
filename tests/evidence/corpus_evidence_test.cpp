// The witnesses of the corpus's refuted histories.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "apps/certification.h"
#include "apps/scene_motion.h"
#include "history/claim.h"
#include "tests/evidence/tally.h"

namespace voroproof::testing {
namespace {

namespace fs = std::filesystem;

const fs::path corpus{VOROPROOF_CORPUS};

// Adds the witness of the history, which the corpus says is refuted.
void tally(Tally& t, const fs::path& scene, const fs::path& history, const std::string& truth) {
  const Claim claim = open_claim(scene, history);
  CertifyOptions options;
  options.truth = truth == "exact" ? Truth::exact : Truth::recorded;
  options.propose_initial = construct_initial;
  const Certificate c = certify(claim.scene, motion_input(claim.scene), *claim.history, options);
  ASSERT_EQ(c.verdict, Verdict::refuted) << history;
  t.add(*c.divergence, history.string() + " " + truth);
}

TEST(CorpusEvidence, DegenerateCases) {
  std::vector<fs::path> cases;
  for (const auto& entry : fs::recursive_directory_iterator(corpus / "cases")) {
    if (entry.path().filename() == "case.json") cases.push_back(entry.path().parent_path());
  }
  std::sort(cases.begin(), cases.end());
  Tally t;
  for (const fs::path& c : cases) {
    const auto described = nlohmann::json::parse(std::ifstream(c / "case.json"));
    for (const auto& wrong : described.value("wrong", nlohmann::json::array())) {
      tally(t, c / "scene.scene.json", c / wrong.at("file").get<std::string>(), wrong.at("truth"));
    }
  }
  t.print();
}

TEST(CorpusEvidence, GenericCases) {
  std::ifstream cases(corpus / "cases.txt");
  Tally t;
  for (std::string line; std::getline(cases, line);) {
    std::istringstream fields(line);
    std::string file, scene, truth;
    if (!(fields >> file >> scene >> truth) || file.rfind("refuted/", 0) != 0) continue;
    tally(t, corpus / "scenes" / (scene + ".scene.json"), corpus / file, truth);
  }
  t.print();
}

}  // namespace
}  // namespace voroproof::testing
