// An output file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace voroproof::internal {

// Writes to a temporary file beside the target and renames it onto the target on commit(), once its
// bytes are on the disk. A file destroyed before that leaves no trace, and a target that existed
// stays as it was; one that is replaced hands on its permissions. A process that is killed outright
// leaves a file named TARGET.<process>.<number>.tmp, which the next writer of the target removes;
// what a living process writes is locked (flock) and stays. A symbolic link stays and the file it
// names is replaced. Targets other than regular files (devices, pipes, directories) are refused:
// OutputFile writes to such, and gathers small pieces. Every member throws OutputError naming the
// target when the system refuses.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  void write(std::string_view bytes);

  // For a text of lines to whose end there was no room (a full disk, a limit on files): ends it
  // after the last line behind which `room` bytes are written, with what `ending` makes of that
  // line, a text no longer than these. So no new room is taken. False, and nothing is done, where
  // a write failed for another reason, and where there is no such line but the first.
  bool end_early(std::size_t room,
                 const std::function<std::optional<std::string>(std::string_view line)>& ending);

  // From here on what is written stays where it is not committed, as that of a process that is
  // killed outright: there is something to go on with. discard() removes it all the same.
  void outlive();
  void discard();

  // Removes what is not committed and does not outlive its process, of all files of the process,
  // which is about to end. For handlers of signals.
  static void remove_unfinished() noexcept;

  // Gives the file its name. Nothing may be written afterwards.
  void commit();
  // Gives it that name with `suffix` at its end instead, and returns it; beside the file itself
  // where the name was a link.
  std::string commit_beside(const std::string& suffix);

 private:
  [[noreturn]] void fail(const char* action) const;

  struct Unfinished;

  void forget_temporary();

  std::string path_;
  std::string target_;
  std::string temporary_;
  Unfinished* unfinished_ = nullptr;  // temporary_, for remove_unfinished()
  int descriptor_ = -1;
  bool full_ = false;  // no room was left for a write
  bool outlives_ = false;
};

// Visits the files that killed processes had begun to write in place of the target, which no living
// process writes to. A file is locked while it is visited.
void each_abandoned(const std::string& target,
                    const std::function<void(const std::string& path)>& visit);

}  // namespace voroproof::internal
