// The movie as a file, without a browser.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace voroproof::internal
