// The witnesses of the corpus's refuted histories.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "certify/certifier.h"
#include "history/claim.h"
#include "library/certification.h"
#include "library/maneuver_input.h"
#include "tests/evidence/tally.h"

namespace voroproof::internal::testing {
namespace {

namespace fs = std::filesystem;

const fs::path corpus{VOROPROOF_CORPUS};

std::string name_of(Truth truth) { return truth == Truth::exact ? "exact" : "recorded"; }

// Adds the witness of the history where it is refuted under this truth; says whether it is.
bool tally(Tally& t, const fs::path& scene, const fs::path& history, Truth truth) {
  const Claim claim = open_claim(scene, history);
  CertifyOptions options;
  options.truth = truth;
  options.propose_initial = construct_initial;
  const Certificate c = certify(claim.scene, *claim.history, options);
  if (c.divergence) t.add(*c.divergence, history.string() + " " + name_of(truth));
  return c.divergence.has_value();
}

// Under the truth that they are listed with they are refuted; the other one is tried as well.
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
      const fs::path history = c / wrong.at("file").get<std::string>();
      for (const Truth truth : {Truth::exact, Truth::recorded}) {
        const bool refuted = tally(t, c / "scene.scene.json", history, truth);
        EXPECT_TRUE(refuted || wrong.at("truth") != name_of(truth)) << history;
      }
    }
  }
  t.print();
  EXPECT_GE(t.count(Evidence::confirmed), 300);
}

TEST(CorpusEvidence, GenericCases) {
  std::ifstream cases(corpus / "cases.txt");
  Tally t;
  for (std::string line; std::getline(cases, line);) {
    std::istringstream fields(line);
    std::string file, scene, truth;
    if (!(fields >> file >> scene >> truth) || file.rfind("refuted/", 0) != 0) continue;
    EXPECT_TRUE(tally(t, corpus / "scenes" / (scene + ".scene.json"), corpus / file,
                      truth == "exact" ? Truth::exact : Truth::recorded))
        << file << " " << truth;
  }
  t.print();
  EXPECT_GE(t.count(Evidence::confirmed), 15);
}

}  // namespace
}  // namespace voroproof::internal::testing
