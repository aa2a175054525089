// The verb corpus as its users meet it: the corpus against itself, and programs of every kind
// against the corpus.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "tests/apps/verbs/corpus_cli.h"

namespace voroproof::internal {
namespace {

namespace fs = std::filesystem;

TEST_F(CorpusCli, ListsAndShows) {
  const std::string all = must({"corpus", "list", "--corpus", cases()}).out;
  EXPECT_EQ(lines_of(all).size(), 9u) << all;
  EXPECT_NE(all.find("stops/slide"), std::string::npos);
  EXPECT_NE(all.find("\n6 cases\n"), std::string::npos) << all;
  const std::string one =
      must({"corpus", "list", "--corpus", cases(), "--family", "ties", "--tag", "tag-formation"})
          .out;
  EXPECT_NE(one.find("ties/formation"), std::string::npos) << one;
  EXPECT_NE(one.find("\n1 case\n"), std::string::npos) << one;
  for (const char* name : {"eight", "generic/eight"}) {
    const std::string shown = must({"corpus", "show", name, "--corpus", cases()}).out;
    EXPECT_NE(shown.find("The story of eight"), std::string::npos) << shown;
    EXPECT_NE(shown.find("scene: 8 disks"), std::string::npos) << shown;
    EXPECT_NE(shown.find("refuted: missing event"), std::string::npos) << shown;
    EXPECT_NE(shown.find("diagram-0.diagram.json at t = \"1/3\""), std::string::npos) << shown;
  }
}

// For engines that read no exact text.
TEST_F(CorpusCli, ScenesInPlainDoubles) {
  const auto listed = [&](const std::string& numbers) {
    return must({"corpus", "list", "--corpus", VOROPROOF_CASES, "--numbers", numbers}).out;
  };
  const std::string all = listed("all"), doubles = listed("doubles");
  std::size_t exact = 0, plain = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(VOROPROOF_CASES)) {
    if (entry.path().filename() != "scene.scene.json") continue;
    const fs::path of = entry.path().parent_path();
    const std::string id = of.parent_path().filename().string() + "/" + of.filename().string();
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const bool is_plain = !std::regex_search(text, std::regex("\"[-+.0-9]"));
    EXPECT_NE(all.find(id), std::string::npos) << id;
    EXPECT_EQ((doubles + "\n").find(id + " ") != std::string::npos, is_plain) << id;
    ++(is_plain ? plain : exact);
  }
  EXPECT_GT(exact, 20u);
  EXPECT_GT(plain, 20u);
}

TEST_F(CorpusCli, ExamplesInHelpTextsNameCasesThatExist) {
  for (const char* verb : {"list", "show"}) {
    const std::string help = must({"corpus", verb, "--help"}).out;
    std::istringstream example(lines_of(help).back());
    std::string program;
    example >> program;
    Arguments words;
    for (std::string word; example >> word;) words.push_back(word);
    words.insert(words.end(), {"--corpus", VOROPROOF_CASES});
    must(words);
  }
}

TEST_F(CorpusCli, HoldsTheCorpusAgainstItself) {
  const Result result = run_corpus({"--jobs", "2"});
  EXPECT_EQ(result.code, 0) << result.out;
  EXPECT_NE(result.out.find("6 of 6 cases as expected"), std::string::npos) << result.out;
  EXPECT_EQ(json("report.json")["results"].size(), 6u);
}

TEST_F(CorpusCli, SeesWhatIsNotAsExpected) {
  const auto refused = [&](const std::string& message) {
    const Result result = run_corpus({"--case", "eight"});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.out.find(message), std::string::npos) << result.out;
    EXPECT_FALSE(json("report.json")["results"][0]["passed"].get<bool>());
  };
  const std::string folder = path("generic/eight/");
  const std::string description = read_bytes(folder + "case.json");
  const auto described = [&](const std::string& what, const std::string& by) {
    std::string text = description;
    text.replace(text.find(what), what.size(), by);
    std::ofstream(folder + "case.json", std::ios::binary) << text;
  };
  described("missing event", "wrong time");
  refused("expected refuted (exact): wrong time, found refuted (exact): missing event");
  described("\"certified\"", "\"undecided\"");
  refused("expected undecided (exact), found certified (exact)");
  described("\"1/3\"", "\"2/3\"");
  refused("expected same edges, found another instant");
  described("\"1/3\"", "\"1/3\"");
  const std::string later = file("later.diagram.json");
  must({"snapshot", folder + "scene.scene.json", "--at", "20", "-o", later});
  std::string diagram = read_bytes(later);
  diagram.replace(diagram.find("\"t\":20"), 6, "\"t\":\"1/3\"");
  std::ofstream(folder + "diagram-0.diagram.json", std::ios::binary) << diagram;
  refused("expected same edges, found other edges");
  fs::copy_file(folder + "wrong/dropped-flip.history.jsonl", folder + "exact.history.jsonl",
                fs::copy_options::overwrite_existing);
  refused("expected certified (exact), found refuted (exact): missing event: line ");
}

TEST_F(CorpusCli, CertificationHasALimitToo) {
  const Result result = run_corpus({"--case", "eight", "--timeout", "1e-9"});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.out.find("found undecided (exact): the certifier did not finish: time out"),
            std::string::npos)
      << result.out;
}

TEST_F(CorpusCli, CertifiesWhatTheEngineWrites) {
  const Result result = run_corpus({"--against", simulate()});
  EXPECT_EQ(result.code, 0) << result.out;
  EXPECT_EQ(count("all", "certified"), 5);
  EXPECT_EQ(count("stops", "undecided"), 1);
}

TEST_F(CorpusCli, TheExamplePassesGenericCasesAndFailsAtTies) {
  const Result generic = run_corpus({"--against", example(), "--family", "generic"});
  EXPECT_EQ(generic.code, 0) << generic.out;
  const Result ties = run_corpus({"--against", example()});
  EXPECT_EQ(ties.code, 1) << ties.out;
  EXPECT_EQ(count("generic", "certified"), 2);
  EXPECT_LT(count("ties", "certified"), 3);
  EXPECT_GE(count("ties", "refuted"), 1) << ties.out;
}

TEST_F(CorpusCli, EachWayToFailHasItsName) {
  EXPECT_EQ(against("kill -SEGV $$ # {scene} {history}", "three")["outcome"], "crashed");
  EXPECT_EQ(against(": {scene} {history}; exit 7", "three")["reason"], "exit code 7");
  EXPECT_EQ(against("echo oh >&2; exit 7 # {scene} {history}", "three")["reason"],
            "exit code 7: oh");
  const Json silent = against("true {scene} {history}", "three");
  EXPECT_EQ(silent["outcome"], "invalid");
  EXPECT_EQ(silent["reason"], "no history was written");
  EXPECT_EQ(against("cp {scene} {history}", "three")["outcome"], "invalid");
  EXPECT_EQ(against("head -c 200 {scene} > {history}", "three")["outcome"], "invalid");
  const Json wrong = against(
      "cp " + path("generic/eight/wrong/dropped-flip.history.jsonl") + " {history} # {scene}",
      "eight");
  ASSERT_EQ(wrong["outcome"], "refuted") << wrong;
  for (const char* truth : {"exact", "recorded"}) EXPECT_EQ(wrong[truth]["kind"], "missing event");
  EXPECT_EQ(count("generic", "refuted"), 1);
}

// A right history does not excuse a crash; one that stops early is as good as its verdict.
TEST_F(CorpusCli, ExitCodesCount) {
  EXPECT_EQ(against(simulate() + "; exit 1", "three")["outcome"], "crashed");
  const Json stops = against(simulate(), "slide");
  EXPECT_EQ(stops["outcome"], "undecided");
  EXPECT_EQ(stops["program"]["end"], "exit code 3");
  EXPECT_TRUE(stops["passed"].get<bool>());
}

TEST_F(CorpusCli, TruthsAreChosen) {
  for (const char* truth : {"exact", "recorded"}) {
    const Json found = against(simulate(), "three", {"--truth", truth});
    for (const char* other : {"exact", "recorded"}) {
      EXPECT_EQ(found.contains(other), std::string(truth) == other);
    }
  }
}

// An engine that knows no flips passes by its collisions, and the report says so.
TEST_F(CorpusCli, EventsAreChosen) {
  const std::string engine =
      simulate() + R"( && sed -i -e '/"flip"/d' -e 's/"flips":[0-9]*/"flips":0/' {history})";
  EXPECT_EQ(against(engine, "eight")["outcome"], "refuted");
  EXPECT_EQ(json("report.json")["events"], "all");
  EXPECT_EQ(against(engine, "eight", {"--events", "collisions"})["outcome"], "certified");
  EXPECT_EQ(json("report.json")["events"], "collisions");
}

// After some collisions no run in doubles follows the true motion; its history may be right of its
// own. The case passes, and the columns tell which.
TEST_F(CorpusCli, EitherTruthWillDo) {
  add("generic", "long",
      {"reference", "--n", "12", "--seed", "2", "--density", "0.3", "--horizon", "60"});
  const Json found = against(example(), "long");
  EXPECT_EQ(found["outcome"], "certified");
  EXPECT_EQ(found["exact"]["verdict"], "refuted");
  EXPECT_EQ(found["recorded"]["verdict"], "certified");
  const Json report = json("report.json");
  EXPECT_EQ(report["families"][0]["exact"], 0);
  EXPECT_EQ(report["families"][0]["recorded"], 1);
  EXPECT_EQ(against(example(), "long", {"--truth", "exact"})["outcome"], "refuted");
}

TEST_F(CorpusCli, EventSequencesAreHistoriesToo) {
  const std::string convert = std::string(VOROPROOF_PROGRAM) +
                              " convert {history} --scene {scene} -o {history}.evtsq && mv "
                              "{history}.evtsq {history}";
  const Json found = against(simulate() + " && " + convert, "eight");
  EXPECT_EQ(found["outcome"], "certified") << found;
}

TEST_F(CorpusCli, NamesAreQuotedForTheShell) {
  const TemporaryDirectory scratch;
  const std::string odd = scratch.file("it's $HOME; \"odd\"");
  fs::create_directory(odd);
  ASSERT_EQ(setenv("TMPDIR", odd.c_str(), 1), 0);
  const Json found = against(simulate(), "three");
  unsetenv("TMPDIR");
  EXPECT_EQ(found["outcome"], "certified") << found;
}

TEST_F(CorpusCli, BadUsageIsRefused) {
  const Arguments run_words{"corpus", "run", "--corpus", cases()};
  const auto with = [&](const Arguments& more) {
    Arguments words = run_words;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  refused(with({"--against", "mysim {scene}"}), "does not name {history}");
  refused(with({"--against", "mysim {history}"}), "does not name {scene}");
  refused(with({"--family", "none"}), "no case of the family none");
  refused(with({"--family", "ties", "--case", "three"}), "no case named three");
  refused(with({"--timeout", "0"}), "--timeout");
  refused(with({"--jobs", "0"}), "--jobs");
  refused(with({"--against", simulate(), "--truth", "mine"}), "--truth");
  refused(with({"--truth", "exact"}), "--truth requires --against");
  refused(with({"--events", "collisions"}), "--events requires --against");
  refused(with({"--against", simulate(), "--events", "flips"}), "--events");
  refused(with({"--json", file("a"), "--html", file("a")}), "named for two outputs");
  refused({"corpus", "show", "three", "--corpus", file("nowhere")}, "nowhere");
  refused({"corpus"}, "no verb given");
  describe("generic", "three", Json::array({-1}), Json::array());
  refused(run_words, "instants[0]: is negative");
  describe("generic", "three", Json::array(), Json::array(), "maybe");
  refused(run_words, "verdict");
  fs::remove(path("generic/three/case.json"));
  refused(run_words, "case.json");
}

}  // namespace
}  // namespace voroproof::internal
