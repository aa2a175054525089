// The movie as a file, without a browser.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class MovieFile : public Cli {};

TEST_F(MovieFile, IsOneFileThatNeedsNothingElse) {
  const std::string scene = reference(12, "30");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  must({"movie", scene, file("a.history.jsonl"), "-o", file("a.html")});
  const std::string page = directory_.read("a.html");
  for (const char* reference : {"http:", "https:", "src=", "@import", "url(", "fetch("}) {
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
  }
  for (const char* part : {"class Player", "class Diagram", "#picture", "id=\"movie-times\""}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  must({"movie", scene, file("a.history.jsonl"), "-o", file("b.html")});
  EXPECT_EQ(page, directory_.read("b.html"));
}

TEST_F(MovieFile, TextOfFilesCannotEndAnElement) {
  const std::string scene = directory_.write(
      "a.scene.json",
      R"({"format":"voroproof-scene","version":1,"name":"</script></title><b>","horizon":1,)"
      R"("container":{"center":[0,0],"radius":10},"disks":[]})");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  must({"movie", scene, file("a.history.jsonl"), "-o", file("a.html")});
  const std::string page = directory_.read("a.html");
  EXPECT_EQ(page.find("</script></title>"), std::string::npos);
  EXPECT_NE(page.find("<title>&lt;/script&gt;"), std::string::npos);
}

TEST_F(MovieFile, BadRequestsAreRefused) {
  const std::string scene = reference(5, "10");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  must({"certify", scene, file("a.history.jsonl"), "--report", file("a.report.json")});
  must({"generate", "reference", "--n", "5", "--seed", "9", "-o", file("b.scene.json")});
  must({"simulate", file("b.scene.json"), "-o", file("b.history.jsonl")});
  const std::string page = file("a.html");
  refused({"movie", scene, file("a.history.jsonl"), "-o", page, "--follow", "5"}, "--follow");
  refused({"movie", scene, file("b.history.jsonl"), "-o", page}, "scene_sha256");
  refused({"movie", file("b.scene.json"), file("b.history.jsonl"), "-o", page, "--report",
           file("a.report.json")},
          "another scene");
  refused({"movie", scene, file("a.history.jsonl"), "-o", scene}, "an input as well");
  refused({"movie", scene, file("a.history.jsonl"), "-o", page, "--horizon", "soon"}, "--horizon");
  refused({"movie", scene, file("a.history.jsonl"), "-o", page, "--from", "10.5"},
          "would begin after it");
  refused({"movie", scene, file("a.history.jsonl"), "-o", page, "--from", "5", "--horizon", "4"},
          "before --from");
  refused({"movie", scene, file("a.history.jsonl"), "-o", page, "--index", file("a.index")},
          "only with --from");
}

// A report is shown with the history that it is about, and with no other one.
TEST_F(MovieFile, AReportOfOtherBytesIsRefused) {
  const std::string scene = reference(5, "10"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  must({"certify", scene, history, "--report", file("a.report.json")});
  const Arguments words{"movie",    scene, history,    "--report",    file("a.report.json"),
                        "--follow", "1",   "--output", file("a.html")};
  must(words);
  std::filesystem::remove(file("a.html"));
  const std::string right = directory_.read("a.history.jsonl");
  std::string wrong = right;
  wrong.erase(wrong.find('\n'), wrong.find('\n', wrong.find('\n') + 1) - wrong.find('\n'));
  directory_.write("a.history.jsonl", wrong);
  refused(words, "history_sha256: the report is about another history");
  EXPECT_FALSE(std::filesystem::exists(file("a.html")));
  EXPECT_NE(must({"explain", file("a.report.json")}).out.find("has other bytes now"),
            std::string::npos);
  directory_.write("a.history.jsonl", right);
  EXPECT_EQ(must({"explain", file("a.report.json")}).out.find("has other bytes now"),
            std::string::npos);
  // By another version, or of bytes that it does not name.
  Json report = json("a.report.json");
  report["producer"] = "voroproof 9";
  directory_.write("a.report.json", report.dump());
  refused(words, "producer: the report is by voroproof 9");
  const auto explained = [&] { return must({"explain", file("a.report.json")}).out; };
  EXPECT_NE(explained().find("Note: the report is by voroproof 9"), std::string::npos);
  must({"certify", scene, history, "--report", file("a.report.json")});
  report = json("a.report.json");
  report.erase("history_sha256");
  directory_.write("a.report.json", report.dump());
  refused(words, "does not say which history");
  EXPECT_NE(explained().find("Note: the report does not say which history"), std::string::npos);
}

TEST_F(MovieFile, OfAReportOnCollisionsAloneHasNoFlips) {
  const std::string scene = reference(8, "20"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  must({"certify", scene, history, "--events", "collisions", "--report", file("a.report.json")});
  must({"movie", scene, history, "--report", file("a.report.json"), "-o", file("a.html")});
  const std::string page = directory_.read("a.html");
  EXPECT_NE(page.find("\"words\":\"CERTIFIED (collisions alone)\""), std::string::npos);
  EXPECT_NE(page.find("\"noDiagram\":"), std::string::npos);
  EXPECT_NE(page.find("id=\"movie-initial\"></script>"), std::string::npos);
  // A byte a kind, in base64: three collisions are "AQEB".
  const std::size_t kinds = page.find("id=\"movie-kinds\">") + 17;
  EXPECT_EQ(page.substr(kinds, 4), "AQEB");
}

}  // namespace
}  // namespace voroproof::internal
