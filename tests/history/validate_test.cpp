// What is said of files of any format, and which are refused.
#include "history/validate.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "history/error.h"
#include "tests/history/example_history.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {
namespace {

TEST(Validate, FindsTheFormat) {
  TemporaryDirectory directory;
  EXPECT_EQ(validate_file(directory.write("h", joined(good_lines))),
            "history: 1 flip, 2 collisions, 1 maneuver, complete to t = 1000");
  const std::string scene =
      R"("version":1,"container":{"center":[0,0],"radius":1},"horizon":"1/3","disks":[]})";
  EXPECT_EQ(validate_file(directory.write("s", "{\"format\":\"voroproof-scene\"," + scene)),
            "scene: 0 disks, 0 maneuvers, horizon \"1/3\"");
  // The field may be far from the beginning.
  EXPECT_EQ(validate_file(directory.write("s", "{\"comment\":\"" + std::string(100'000, 'x') +
                                                   "\",\n\"format\":\"voroproof-scene\"," + scene)),
            "scene: 0 disks, 0 maneuvers, horizon \"1/3\"");
  EXPECT_EQ(
      validate_file(directory.write(
          "h", good_lines[0] + "\n{\"stopped\":{\"t\":5,\"reason\":\"r\",\"events\":[[1]]}}")),
      "history: 0 flips, 0 collisions, 0 maneuvers, stopped at t = 5: r");
}

TEST(Validate, RefusesOtherFiles) {
  TemporaryDirectory directory;
  const auto message = [&](const std::string& text) -> std::string {
    const std::string path = directory.write("f", text);
    try {
      validate_file(path);
      return "";
    } catch (const InputError& e) {
      return std::string(e.what()).substr(path.size() + 1);
    }
  };
  EXPECT_EQ(message(""), "1: unexpected end of input, expected an object");
  EXPECT_EQ(message("{\"a\":1}"), "1: format: missing");
  EXPECT_EQ(message("{\"a\":1,\n\"format\":\"x\"}"), "2: format: none that can be validated: x");
  EXPECT_EQ(message("{\"a\":[" + std::string(100'000, '1') + "]}"),
            "1: [0]: a number of more than 4096 characters");
  std::vector<std::string> lines = good_lines;
  lines[4] = R"({"t":4,"flip":[1,2,3,4]})";
  EXPECT_EQ(message(joined(lines)),
            "6: end: wrong counts: the file has 2 flips, 2 collisions, "
            "0 maneuvers");
  EXPECT_NE(message("\x1f\x8b garbage"), "");
}

}  // namespace
}  // namespace voroproof::internal::testing
