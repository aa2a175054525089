// Files that appear whole or not at all.
#include "history/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

class AtomicFiles : public ::testing::Test {
 protected:
  TemporaryDirectory directory_;
};

TEST_F(AtomicFiles, KeepThePermissionsOfWhatTheyReplace) {
  const std::string path = directory_.write("a", "old");
  ASSERT_EQ(chmod(path.c_str(), 0640), 0);
  AtomicFile file(path);
  file.write("new");
  file.commit();
  EXPECT_EQ(directory_.read("a"), "new");
  struct stat status {};
  ASSERT_EQ(stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(AtomicFiles, RemoveWhatKilledProcessesHadBegun) {
  directory_.write("a.123.0.tmp", "half");
  directory_.write("a.123.x.tmp", "another's");
  directory_.write("ab.123.0.tmp", "another's");
  {
    AtomicFile living(directory_.file("a"));
    living.write("whole");
    AtomicFile second(directory_.file("a"));
    EXPECT_EQ(directory_.number_of_files(), 4u);
    living.commit();
  }
  EXPECT_EQ(directory_.read("a"), "whole");
  EXPECT_EQ(directory_.number_of_files(), 3u);
}

TEST_F(AtomicFiles, AProcessThatEndsAtOnceCanRemoveItsOwn) {
  directory_.write("a", "old");
  const pid_t child = fork();
  if (child == 0) {
    AtomicFile committed(directory_.file("b"));
    committed.commit();
    AtomicFile file(directory_.file("a"));
    file.write("half");
    AtomicFile::remove_unfinished();
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  EXPECT_EQ(directory_.read("a"), "old");
  EXPECT_EQ(directory_.number_of_files(), 2u);
}

}  // namespace
}  // namespace voroproof::internal
