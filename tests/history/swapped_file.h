// A file that is swapped while it is read.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace voroproof::internal {

// A name under which each opening finds other bytes, whenever it comes: the first ones find pipes,
// each of which makes way for the next as soon as it is open, and all others find a file.
class SwappedFile {
 public:
  // The pipes hold what is given for them as a whole: a few lines.
  SwappedFile(std::string path, std::vector<std::string> pipes, const std::string& last)
      : path_(std::move(path)), pipes_(std::move(pipes)) {
    for (std::size_t k = 0; k < pipes_.size(); ++k) {
      if (mkfifo(name(k).c_str(), 0600) != 0) throw std::runtime_error("no pipe");
    }
    std::ofstream(name(pipes_.size()), std::ios::binary) << last;
    server_ = std::thread([this] { serve(); });
  }
  SwappedFile(const SwappedFile&) = delete;
  SwappedFile& operator=(const SwappedFile&) = delete;
  ~SwappedFile() {
    stopped_ = true;
    // A pipe that nobody has opened is opened here.
    while (!ended_) {
      close(open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
      std::this_thread::yield();
    }
    server_.join();
  }

 private:
  // The first has the name from the beginning on.
  std::string name(std::size_t k) const { return k == 0 ? path_ : path_ + '.' + std::to_string(k); }

  void serve() {
    // Readers may close a pipe before they have all of it.
    sigset_t broken_pipe;
    sigemptyset(&broken_pipe);
    sigaddset(&broken_pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);
    for (std::size_t k = 0; k < pipes_.size() && !stopped_; ++k) {
      const int pipe = open(path_.c_str(), O_WRONLY | O_CLOEXEC);  // waits for a reader
      std::filesystem::rename(name(k + 1), path_);
      if (write(pipe, pipes_[k].data(), pipes_[k].size()) < 0) stopped_ = true;
      close(pipe);
    }
    ended_ = true;
  }

  std::string path_;
  std::vector<std::string> pipes_;
  std::atomic<bool> stopped_ = false, ended_ = false;
  std::thread server_;
};

}  // namespace voroproof::internal
