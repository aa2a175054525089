#include "history/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "history/error.h"

namespace voroproof::internal {

// A handler of signals may find these at any time: they are only ever added.
struct AtomicFile::Unfinished {
  std::string name;
  std::atomic<bool> exists = true;
  Unfinished* next = nullptr;

  static std::atomic<Unfinished*> first;
};
std::atomic<AtomicFile::Unfinished*> AtomicFile::Unfinished::first{nullptr};

namespace {

constexpr mode_t permissions = S_IRWXU | S_IRWXG | S_IRWXO;

// Whether the name is "TARGET.<process>.<number>.tmp".
bool is_temporary_of(std::string_view name, std::string_view target) {
  constexpr std::string_view ending = ".tmp", digits = "0123456789";
  if (!name.starts_with(target) || !name.ends_with(ending)) return false;
  name.remove_prefix(target.size());
  for (int part = 0; part < 2; ++part) {
    if (!name.starts_with('.')) return false;
    name.remove_prefix(1);
    const std::size_t length = std::min(name.find_first_not_of(digits), name.size());
    if (length == 0) return false;
    name.remove_prefix(length);
  }
  return name == ending;
}

// Files that cannot be synced (EINVAL) are those of systems that keep nothing.
bool synced(int descriptor) { return fsync(descriptor) == 0 || errno == EINVAL; }

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(path) {
  std::error_code error;
  if (std::filesystem::is_symlink(path, error)) {
    target_ = std::filesystem::canonical(path, error).string();
    if (error) throw OutputError(path, "cannot follow the link: " + error.message());
  }
  struct stat status {};
  const bool replaces = stat(target_.c_str(), &status) == 0;
  if (replaces && !S_ISREG(status.st_mode)) throw OutputError(path, "is not a regular file");
  each_abandoned(target_, [](const std::string& abandoned) { unlink(abandoned.c_str()); });

  // Once the file is there, nothing may be wanting that its removal takes: memory comes first.
  auto unfinished = std::make_unique<Unfinished>();
  static std::atomic<unsigned> counter{0};
  do {
    temporary_ =
        target_ + "." + std::to_string(getpid()) + "." + std::to_string(counter++) + ".tmp";
    unfinished->name = temporary_;
    descriptor_ = open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) fail("cannot write");
  unfinished_ = unfinished.release();
  unfinished_->next = Unfinished::first.load();
  while (!Unfinished::first.compare_exchange_weak(unfinished_->next, unfinished_)) {
  }
  flock(descriptor_, LOCK_EX | LOCK_NB);  // where there are no locks, nothing is removed either
  if (replaces) fchmod(descriptor_, status.st_mode & permissions);
}

AtomicFile::~AtomicFile() {
  if (!outlives_) discard();
  if (descriptor_ >= 0) close(descriptor_);
}

void AtomicFile::outlive() {
  outlives_ = true;
  if (unfinished_ != nullptr) unfinished_->exists.store(false);
}

void AtomicFile::discard() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  if (temporary_.empty()) return;
  unlink(temporary_.c_str());
  forget_temporary();
}

void AtomicFile::remove_unfinished() noexcept {
  for (const Unfinished* u = Unfinished::first.load(); u != nullptr; u = u->next) {
    if (u->exists.load()) unlink(u->name.c_str());
  }
}

void AtomicFile::forget_temporary() {
  if (unfinished_ != nullptr) unfinished_->exists.store(false);
  temporary_.clear();
}

void each_abandoned(const std::string& target,
                    const std::function<void(const std::string& path)>& visit) {
  namespace fs = std::filesystem;
  const fs::path path(target);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const std::string name = path.filename().string();
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& found = entry->path();
    if (!is_temporary_of(found.filename().string(), name)) continue;
    const int descriptor = open(found.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) continue;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) visit(found.string());
    close(descriptor);
  }
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      full_ = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
      fail("cannot write");
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool AtomicFile::end_early(
    std::size_t room,
    const std::function<std::optional<std::string>(std::string_view line)>& ending) {
  if (!full_) return false;
  const off_t size = lseek(descriptor_, 0, SEEK_END);
  // More than the lines that are looked for are long.
  std::string tail(
      std::min(static_cast<std::size_t>(std::max<off_t>(size, 0)), room + (std::size_t{1} << 16)),
      '\0');
  const off_t from = size - static_cast<off_t>(tail.size());
  if (pread(descriptor_, tail.data(), tail.size(), from) != static_cast<ssize_t>(tail.size())) {
    return false;
  }
  if (tail.size() <= room) return false;
  const std::size_t last = tail.rfind('\n', tail.size() - room - 1);
  if (last == std::string::npos || last == 0) return false;
  const std::size_t before = tail.rfind('\n', last - 1);
  if (before == std::string::npos) return false;
  const auto text = ending(std::string_view(tail).substr(before + 1, last - before - 1));
  if (!text || text->size() > room) return false;
  const off_t end = from + static_cast<off_t>(last) + 1;
  const auto written = pwrite(descriptor_, text->data(), text->size(), end);
  return written == static_cast<ssize_t>(text->size()) &&
         ftruncate(descriptor_, end + static_cast<off_t>(text->size())) == 0;
}

void AtomicFile::commit() {
  if (!synced(descriptor_)) fail("cannot write");
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot rename onto");
  forget_temporary();
  // The lock goes with the descriptor: not before the name for the time being is gone.
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0) fail("cannot write");
  const std::filesystem::path folder = std::filesystem::path(target_).parent_path();
  const int folder_descriptor =
      open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_descriptor < 0) return;  // one that may not be read
  const bool kept = synced(folder_descriptor);
  close(folder_descriptor);
  if (!kept) fail("cannot write");
}

std::string AtomicFile::commit_beside(const std::string& suffix) {
  target_ += suffix;
  commit();
  return target_;
}

void AtomicFile::fail(const char* action) const {
  throw OutputError(path_, std::string(action) + ": " + std::strerror(errno));
}

}  // namespace voroproof::internal
