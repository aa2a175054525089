// The script that plots plans, where matplotlib is installed (scripts/install-deps.sh plots).
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
