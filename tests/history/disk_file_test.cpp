// Disk files of the paper's authors: what is read, what is refused, and that writing loses nothing.
#include "history/disk_file.h"
#include "history/disk_writer.h"

#include <gtest/gtest.h>

#include <sstream>

#include "history/error.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

constexpr const char* kGood =
    "# BCF Ver 2.1\n"
    "# a comment\n"
    "4\n"
    "7\t1.5\t-2\t0.25\t0.5\t0.5\t0.5\t1\t0\t0.1\t0.2\n"
    "-1 0.5 0.0 100 1 1 1 0 0\n"
    "3\t10\t10\t2\t0\t0\t0\t-0.5\t0.125\n"
    "\n"
    "12 -10 10 0 0 0 0 0 -0\n";

class DiskFileTest : public ::testing::Test {
 protected:
  DiskFile read(const std::string& text) {
    directory_.write("a.disks.txt", text);
    return read_disk_file(directory_.file("a.disks.txt"));
  }

  void refused(const std::string& text, const std::string& message) {
    try {
      read(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
    }
  }

  // kGood with one piece of it replaced.
  static std::string edited(const std::string& from, const std::string& to) {
    std::string text = kGood;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }

  TemporaryDirectory directory_;
};

TEST_F(DiskFileTest, IdsInAnyOrderBecomeDisksInTheirOrder) {
  const DiskFile file = read(kGood);
  EXPECT_EQ(file.ids, (std::vector<std::int64_t>{3, 7, 12}));
  const Scene& s = file.scene;
  EXPECT_EQ(s.container_radius, 100);
  EXPECT_EQ(s.cx, Rational(1, 2));
  EXPECT_EQ(s.law, ContainerLaw::whole);
  ASSERT_EQ(s.disks.size(), 3u);
  EXPECT_EQ(s.disks[0].x, 10);
  EXPECT_EQ(s.disks[0].vy, Rational(1, 8));
  EXPECT_EQ(s.disks[0].mass, 4);
  EXPECT_EQ(s.disks[1].radius, Rational(1, 4));
  EXPECT_EQ(s.disks[2].mass, 0);
}

TEST_F(DiskFileTest, TheEndOfTheLastLineMayBeMissing) {
  // The last line longer than all before it.
  const std::string container = "-1\t0.125\t0\t123.11962644730795\t0.5\t0.5\t0.5\t0\t0";
  const DiskFile file = read("1\n" + container);
  EXPECT_TRUE(file.ids.empty());
  EXPECT_EQ(file.scene.cx, Rational(1, 8));
  EXPECT_EQ(read("2\n" + container + "\n0 1 2 3 0 0 0 4 5" + std::string(500, ' ') + "a").ids,
            std::vector<std::int64_t>{0});
}

TEST_F(DiskFileTest, FaultsAreNamed) {
  refused(edited("4\n", "5\n"), "the file ends after 4 of 5 circles");
  refused(edited("4\n", "3\n"), "text after the last circle");
  refused(edited("4\n", "four\n"), ":3: number of circles: not a whole number");
  refused(edited("7\t1.5", "3\t1.5"), "given to two disks");
  refused(edited("3\t10", "-2\t10"), ":6: id: a second container");
  refused(edited("-1 0.5", "8 0.5"), "no container");
  refused(edited("100 1 1 1 0 0", "100 1 1 1 0 1"), "a container that moves");
  refused(edited("1.5\t-2", "nan\t-2"), ":4: x: not a number");
  refused(edited("1.5\t-2", "1e999\t-2"), ":4: x: beyond the range");
  refused(edited("\t-0.5\t0.125", "\t-0.5"), ":6: vy: missing");
  refused(edited("10\t10\t2", "10\t10\t-2"), ":6: r: negative");
  refused(edited("10\t10\t2", "1.5\t-2\t1"), "overlap");
  refused(edited("10\t10\t2", "98\t10\t2"), "disk 3");
  refused("", "number of circles");
  refused("# only a comment\n", "number of circles");
}

TEST_F(DiskFileTest, WhatIsWrittenReadsBack) {
  Scene scene = read(kGood).scene;
  std::ostringstream out;
  scene.disks[2].radius = 0;
  write_disk_file(out, scene);
  const Scene again = read(out.str()).scene;
  ASSERT_EQ(again.disks.size(), scene.disks.size());
  for (std::size_t k = 0; k < scene.disks.size(); ++k) {
    EXPECT_EQ(again.disks[k].x, scene.disks[k].x);
    EXPECT_EQ(again.disks[k].vy, scene.disks[k].vy);
    EXPECT_EQ(again.disks[k].mass, scene.disks[k].mass);
  }
  scene.disks[0].mass = 5;
  EXPECT_THROW(write_disk_file(out, scene), UnsuitableScene);
  scene.disks[0].mass = 4;
  scene.disks[0].x = Rational(1, 3);
  EXPECT_THROW(write_disk_file(out, scene), UnsuitableScene);
}

}  // namespace
}  // namespace voroproof::internal
