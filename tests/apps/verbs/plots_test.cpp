// The scripts that plot experiments and plans, where matplotlib is installed
// (scripts/install-deps.sh plots).
#include <cstdlib>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class Plots : public Cli {
 protected:
  void SetUp() override {
    if (std::system("/usr/bin/python3 -c 'import matplotlib' 2>/dev/null") != 0) {
      GTEST_SKIP() << "matplotlib is not installed: scripts/install-deps.sh plots";
    }
  }

  int script(const std::string& name, const std::string& arguments) const {
    const std::string command =
        "/usr/bin/python3 '" VOROPROOF_SOURCE "/scripts/" + name + "' " + arguments;
    return std::system(command.c_str());
  }

  // Runs a script that must fail with one line, `message` among it.
  void fails(const std::string& name, const std::string& arguments,
             const std::string& message) const {
    EXPECT_NE(script(name, arguments + " 2> " + file("fault")), 0) << arguments;
    const std::string fault = directory_.read("fault");
    EXPECT_EQ(count(fault, "\n"), 1u) << fault;
    EXPECT_NE(fault.find(message), std::string::npos) << fault;
  }

  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  }
};

TEST_F(Plots, OfExperimentsHaveThePanelsOfThePapersFigures) {
  struct Figure {
    std::string set;
    std::size_t panels;
  };
  const std::vector<Figure> figures{
      {"reference", 2}, {"speed", 3}, {"size", 3}, {"density", 3}, {"restitution", 2}};
  std::string files;
  for (const auto& [set, panels] : figures) {
    must({"experiment", set, "--scale", "0.02", "--horizon", "20", "--members", "2",
          "--predictions", set == "speed" ? "on" : "off", "-o", file(set + ".json"), "--quiet"});
    files += file(set + ".json") + " ";
  }
  ASSERT_EQ(script("plot-experiments.py", files + "-o " + file("")), 0);
  for (const auto& [set, panels] : figures) {
    EXPECT_EQ(directory_.read(set + ".png").substr(1, 3), "PNG");
    EXPECT_EQ(count(directory_.read(set + ".svg"), "<g id=\"axes_"), panels) << set;
  }
  // The same numbers give the same bytes.
  const std::string svg = directory_.read("restitution.svg");
  ASSERT_EQ(script("plot-experiments.py", file("restitution.json") + " -o " + file("")), 0);
  EXPECT_EQ(directory_.read("restitution.svg"), svg);
  // Of several seeds there are bars, or bands.
  for (const std::string set : {"density", "restitution"}) {
    must({"experiment", set, "--scale", "0.02", "--horizon", "20", "--members", "2",
          "--predictions", "off", "--seeds", "3", "-o", file("seeds.json"), "--quiet"});
    const std::string one = directory_.read(set + ".svg");
    ASSERT_EQ(script("plot-experiments.py", file("seeds.json") + " -o " + file("")), 0);
    EXPECT_GT(count(directory_.read(set + ".svg"), "PolyCollection_") +
                  count(directory_.read(set + ".svg"), "LineCollection_"),
              count(one, "PolyCollection_") + count(one, "LineCollection_"))
        << set;
  }
  fails("plot-experiments.py", file("no.json"), "no.json: ");
  fails("plot-experiments.py", file("size.json") + " -o " + file("size.json"), "size.json: ");
}

TEST_F(Plots, OfPlansHaveAPanelForEachTime) {
  must({"plan", "--preset", "square-to-circle", "-o", file("p.scene.json"), "--report",
        file("p.json"), "--quiet"});
  ASSERT_EQ(script("plot-plan.py", "--times 0,30,60 " + file("p.json") + " " + file("p.svg")), 0);
  EXPECT_EQ(count(directory_.read("p.svg"), "<g id=\"axes_"), 3u);
  fails("plot-plan.py", file("p.scene.json") + " " + file("q.svg"), "not of voroproof plan");
  fails("plot-plan.py", file("p.json") + " " + file("no/q.svg"), "no/q.svg: ");
  fails("plot-plan.py", file("p.json") + " " + file("q.gif"), "q.gif: ");
}

}  // namespace
}  // namespace voroproof::internal
