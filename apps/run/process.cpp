#include "apps/run/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <system_error>

#include "apps/run/descendants.h"

namespace voroproof::internal {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t max_file_bytes = std::uint64_t{1} << 32;
constexpr int poll_milliseconds = 100;
constexpr int exit_cannot_run = 127;  // as shells have it

void limit(int resource, std::uint64_t value) {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

[[noreturn]] void work_within(const ProcessStep& step) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGXFSZ, SIGPIPE}) {
    signal(number, SIG_DFL);
  }
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, max_file_bytes);
  if (step.limits.bytes > 0) limit(RLIMIT_DATA, step.limits.bytes);
  int code = exit_cannot_run;
  try {
    code = step.work();
  } catch (...) {
    std::terminate();
  }
  // _exit() does not flush what the parent's streams hold.
  _exit(code);
}

// The new process: never returns to the caller's code.
[[noreturn]] void work_apart(const ProcessStep& step, pid_t parent) {
  setpgid(0, 0);
  if (step.foreign) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM}) signal(number, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    work_without_survivors([&step] { work_within(step); }, parent);
  }
  // If this program is killed outright its processes go with it.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(exit_cannot_run);
  work_within(step);
}

class Child {
 public:
  explicit Child(const ProcessStep& step) : foreign_(step.foreign), start_(Clock::now()) {
    deadline_ = start_ + std::chrono::duration_cast<Clock::duration>(
                             std::chrono::duration<double>(step.limits.seconds));
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (pid_ == 0) work_apart(step, parent);
    setpgid(pid_, pid_);  // here too: whichever of the two comes first
    descriptor_ = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
    if (descriptor_ < 0) {
      const int error = errno;
      end();
      throw std::system_error(error, std::generic_category(), "pidfd_open");
    }
    fcntl(descriptor_, F_SETFD, FD_CLOEXEC);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (pid_ > 0) end();
    if (descriptor_ >= 0) close(descriptor_);
  }

  int descriptor() const { return descriptor_; }  // readable once the process has ended
  bool late(Clock::time_point now) const { return now >= deadline_; }
  Clock::time_point deadline() const { return deadline_; }

  // Kills what is left of the group and takes leave of its leader. The number of the group is
  // still its own: the leader, dead or alive, has not been waited for.
  ProcessEnd end(bool timed_out = false) {
    if (foreign_) {
      kill(pid_, SIGTERM);  // it ends the others and then itself (descendants.h)
    } else {
      kill(-pid_, SIGKILL);
    }
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    ProcessEnd ended;
    ended.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (timed_out) {
      ended.kind = ProcessEnd::Kind::timed_out;
    } else if (WIFSIGNALED(status)) {
      ended.kind = ProcessEnd::Kind::signalled;
      ended.code = WTERMSIG(status);
    } else {
      ended.code = WEXITSTATUS(status);
    }
    return ended;
  }

 private:
  bool foreign_;
  pid_t pid_ = -1;
  int descriptor_ = -1;
  Clock::time_point start_, deadline_;
};

struct Running {
  std::shared_ptr<ProcessJob> job;
  std::unique_ptr<Child> child;
};

// Waits until a process ends, or a deadline comes, or it is time to report.
void wait_for(const std::vector<Running>& running, std::vector<pollfd>& descriptors) {
  descriptors.clear();
  Clock::time_point until = Clock::now() + std::chrono::milliseconds(poll_milliseconds);
  for (const Running& r : running) {
    descriptors.push_back({r.child->descriptor(), POLLIN, 0});
    until = std::min(until, r.child->deadline());
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
  const int ready =
      poll(descriptors.data(), descriptors.size(), static_cast<int>(std::max<long>(left, 0)));
  if (ready < 0) {
    for (pollfd& d : descriptors) d.revents = 0;
  }
}

}  // namespace

std::string description(const ProcessEnd& end) {
  constexpr int shell_signals = 128;  // a shell's exit code for a signal is that much more
  const auto signal_text = [](int number) {
    return "signal " + std::to_string(number) + " (" + strsignal(number) + ")";
  };
  switch (end.kind) {
    case ProcessEnd::Kind::timed_out:
      return "time out";
    case ProcessEnd::Kind::signalled:
      return signal_text(end.code);
    case ProcessEnd::Kind::exited:
      break;
  }
  const std::string text = "exit code " + std::to_string(end.code);
  const int number = end.code - shell_signals;
  return number > 0 && number < SIGRTMIN ? text + ", " + signal_text(number) : text;
}

bool run_jobs(std::vector<std::shared_ptr<ProcessJob>> jobs, std::size_t at_once,
              const std::function<bool(std::size_t finished)>& progress) {
  std::size_t next = 0, finished = 0;
  std::vector<Running> running;
  std::vector<pollfd> descriptors;
  const auto start_step = [](Running& r) {
    r.child = r.job->empty() ? nullptr : std::make_unique<Child>(r.job->front());
  };
  while (finished < jobs.size()) {
    if (!progress(finished)) return false;
    while (next < jobs.size() && running.size() < at_once) {
      running.push_back({jobs[next++], nullptr});
      start_step(running.back());
    }
    std::erase_if(running, [&](const Running& r) {
      if (!r.child) ++finished;
      return !r.child;
    });
    if (running.empty()) continue;
    wait_for(running, descriptors);
    const Clock::time_point now = Clock::now();
    for (std::size_t k = 0; k < running.size(); ++k) {
      Running& r = running[k];
      const bool ended = descriptors[k].revents != 0;
      if (!ended && !r.child->late(now)) continue;
      const ProcessEnd end = r.child->end(!ended);
      const ProcessStep step = std::move(r.job->front());
      r.job->pop_front();
      step.on_end(end);
      start_step(r);
    }
  }
  return progress(finished);
}

int become_shell(const std::string& command, const std::string& out, const std::string& err) {
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  const int in = open("/dev/null", O_RDONLY);
  const int out_file = open(out.c_str(), flags, 0600), err_file = open(err.c_str(), flags, 0600);
  if (in < 0 || out_file < 0 || err_file < 0) return exit_cannot_run;
  dup2(in, STDIN_FILENO);
  dup2(out_file, STDOUT_FILENO);
  dup2(err_file, STDERR_FILENO);
  execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
  return exit_cannot_run;
}

std::string shell_word(const std::string& text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+:=@%-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
  }
  return word + "'";
}

}  // namespace voroproof::internal
