// What the program says of itself, and of words it does not know.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>

#include "tests/apps/verbs/cli.h"
#include "tests/apps/verbs/small_scenes.h"

namespace voroproof::internal {
namespace {

class Help : public Cli {
 protected:
  Json described() const { return Json::parse(must({"help", "--json"}).out); }
};

// Visits every verb with the words that name it.
void visit(const Json& verb, const Arguments& words,
           const std::function<void(const Json&, const Arguments&)>& see) {
  see(verb, words);
  for (const Json& below : verb["verbs"]) {
    Arguments longer = words;
    longer.push_back(below["name"]);
    visit(below, longer, see);
  }
}

TEST_F(Help, HelpOfAVerbIsThatOfItsOption) {
  int verbs = 0;
  visit(described(), {}, [&](const Json&, const Arguments& words) {
    Arguments by_verb{"help"}, by_option = words;
    by_verb.insert(by_verb.end(), words.begin(), words.end());
    by_option.push_back("--help");
    EXPECT_EQ(must(by_verb).out, must(by_option).out);
    ++verbs;
  });
  EXPECT_GT(verbs, 30);
}

TEST_F(Help, AllOptionsAndExamplesAreDescribed) {
  const std::set<std::string> kinds{"arguments", "options"};
  visit(described(), {}, [&](const Json& verb, const Arguments& words) {
    const std::string shown = ::testing::PrintToString(words);
    EXPECT_FALSE(verb["description"].get<std::string>().empty()) << shown;
    EXPECT_FALSE(verb["examples"].empty()) << shown;
    Arguments asked = words;
    asked.push_back("--help");
    const std::string help = must(asked).out;
    for (const std::string& kind : kinds) {
      for (const Json& option : verb[kind]) {
        const std::string name = option["names"].back(), sentences = option["help"];
        EXPECT_NE(help.find(name), std::string::npos) << shown << name;
        EXPECT_TRUE(std::isupper(static_cast<unsigned char>(sentences.front()))) << shown << name;
        EXPECT_EQ(sentences.back(), '.') << shown << name;
        EXPECT_EQ(name.starts_with('-'), kind == "options") << shown << name;
      }
    }
  });
}

TEST_F(Help, DescriptionsHaveWhatCompletionsNeed) {
  const Json all = described();
  EXPECT_EQ(all["format"], "voroproof-help");
  Json certify;
  for (const Json& verb : all["verbs"]) {
    if (verb["name"] == "certify") certify = verb;
  }
  ASSERT_EQ(certify["arguments"].size(), 2u);
  EXPECT_EQ(certify["arguments"][0]["names"], Json::array({"scene"}));
  EXPECT_EQ(certify["arguments"][0]["type"], "FILE");
  EXPECT_EQ(certify["arguments"][0]["required"], true);
  for (const Json& option : certify["options"]) {
    if (option["names"].back() == "--truth") {
      EXPECT_EQ(option["choices"], Json::array({"exact", "recorded"}));
      EXPECT_EQ(option["default"], "exact");
      EXPECT_EQ(option["values"], 1);
    }
    if (option["names"].back() == "--strict") {
      EXPECT_EQ(option["values"], 0);
    }
  }
}

TEST_F(Help, WordsThatAreNotKnownHaveTheNearestKnownNextToThem) {
  const std::string out = file("out");
  refused({"certfy"}, "unknown verb certfy; did you mean certify?");
  refused({"query", "neighbors"}, "did you mean neighbours?");
  refused({"simulate", "a", "--outptu", "b"}, "unknown option --outptu; did you mean --output?");
  refused({"simulate", "a", "--stat=b", "-o", "c"}, "unknown option --stat; did you mean --stats?");
  refused({"generate", "grid", "-o", out, "--motion", "sheer"}, "did you mean shear?");
  refused({"help", "qurey"}, "voroproof has no verb qurey; did you mean query?");
  refused({"help", "query", "void", "x"}, "voroproof query void has no verb x");
  refused({"help", "simulate", "--json"}, "--json: describes all verbs");
  for (const char* far : {"fly", "--loudness", "x"}) {
    EXPECT_EQ(run({far}).err.find("did you mean"), std::string::npos) << far;
  }
}

}  // namespace
}  // namespace voroproof::internal
