// Tables of disks at rest, and what is wrong with them.
#include "history/disk_table.h"

#include <gtest/gtest.h>

#include "history/error.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

using namespace std::string_literals;

class DiskTableFile : public ::testing::Test {
 protected:
  DiskTable read(const std::string& text) {
    directory_.write("a", text);
    return read_disk_table(directory_.file("a"));
  }
  void refused(const std::string& text, std::int64_t line, const std::string& field) {
    try {
      read(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& e) {
      EXPECT_EQ(e.line(), line) << e.what() << text;
      EXPECT_EQ(e.field(), field) << e.what() << text;
    }
  }
  TemporaryDirectory directory_;
};

TEST_F(DiskTableFile, IsReadWithAnyHeadingAndSeparator) {
  for (const char* text :
       {"x,y,r\n1,-2.5,0.5\n", "# towns\n\nWeight;Lat;Lon\n0.5;-2.5;1", "1 -2.5  5e-1\r\n",
        "1\t-2.5\t0.5\n", "longitude, latitude, w\n +1, -2.5, .5\n"}) {
    const DiskTable table = read(text);
    ASSERT_EQ(table.disks.size(), 1U) << text;
    EXPECT_EQ(table.disks[0].x, 1) << text;
    EXPECT_EQ(table.disks[0].y, -2.5) << text;
    EXPECT_EQ(table.disks[0].radius, 0.5) << text;
  }
}

TEST_F(DiskTableFile, KeepsOtherColumnsAndQuotes) {
  const DiskTable table = read("name,x,y,note\n\"Ada, \"\"B\"\"\",1,2,\nC,3,4,d\n");
  ASSERT_EQ(table.disks.size(), 2U);
  ASSERT_EQ(table.rest.size(), 2U);
  EXPECT_EQ(table.rest[0], std::pair("name"s, std::vector{"Ada, \"B\""s, "C"s}));
  EXPECT_EQ(table.rest[1], std::pair("note"s, std::vector{""s, "d"s}));
  EXPECT_EQ(table.disks[1].radius, 0);
}

TEST_F(DiskTableFile, MayBeEmpty) { EXPECT_TRUE(read("").disks.empty()); }

TEST_F(DiskTableFile, IsRefusedWithPlaceAndReason) {
  refused("1,2,3,4\n", 1, "");
  refused("x,y,lon\n", 1, "lon");
  refused("y,r\n", 1, "x");
  refused("x,r\n", 1, "y");
  refused("x,y\n1,2\n1,2,3\n", 3, "");
  refused("x,y\n1,nan\n", 2, "y");
  refused("x,y\n1,inf\n", 2, "y");
  refused("x,y\n1,0x1p3\n", 2, "y");
  refused("x,y,r\n1,2,1e101\n", 2, "radius");
  refused("x,y,r\n1e-101,2,1\n", 2, "x");
  refused("a,x,y\n\"b,1,2\n", 2, "");
  refused("a,x,y\n\"b\"c,1,2\n", 2, "");
}

}  // namespace
}  // namespace voroproof::internal
