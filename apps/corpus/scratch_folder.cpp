#include "apps/corpus/scratch_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "history/error.h"

namespace voroproof::internal {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view beginning = "voroproof-corpus-";

// An open descriptor of the folder with its lock; -1 where a living process has that, or the folder
// is none, is a link, or is another user's.
int locked(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return -1;
  struct stat status {};
  const bool own = fstat(descriptor, &status) == 0 && status.st_uid == geteuid();
  if (own && flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  close(descriptor);
  return -1;
}

void remove_abandoned(const fs::path& parent) {
  std::error_code error;
  for (fs::directory_iterator entry(parent, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!entry->path().filename().string().starts_with(beginning)) continue;
    const int descriptor = locked(entry->path());
    if (descriptor < 0) continue;
    std::error_code ignored;
    fs::remove_all(entry->path(), ignored);
    close(descriptor);
  }
}

// Where this process has no memory left to look into the folder. Takes none.
void remove_by_another_process(const char* path) {
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/rm", "rm", "-rf", "--", path, static_cast<char*>(nullptr));
    _exit(1);
  }
  if (child > 0) waitpid(child, nullptr, 0);
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  const auto fail = [&] { throw OutputError((parent / beginning).string(), "cannot be made"); };
  if (error) fail();
  remove_abandoned(parent);
  // It gets its name once it is locked: no other process takes it for abandoned meanwhile.
  std::string name = (parent / ("." + std::string(beginning) + "XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) fail();
  path_ = name;
  lock_ = locked(path_);
  const fs::path visible = parent / path_.filename().string().substr(1);
  fs::rename(path_, visible, error);
  if (!error) path_ = visible;
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  try {
    fs::remove_all(path_, error);
  } catch (const std::bad_alloc&) {
    error = std::make_error_code(std::errc::not_enough_memory);
  }
  if (error) remove_by_another_process(path_.c_str());
  if (lock_ >= 0) close(lock_);
}

fs::path ScratchFolder::folder(std::size_t number) const {
  fs::path made = path_ / std::to_string(number);
  fs::create_directory(made);
  return made;
}

}  // namespace voroproof::internal
