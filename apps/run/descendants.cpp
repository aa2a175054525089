#include "apps/run/descendants.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>

namespace voroproof::internal {

namespace {

constexpr int exit_cannot_run = 127;  // as shells have it

// Kills until no child is left. Children of a killed child become children of this process in turn.
void kill_all(pid_t leader) {
  const std::string self = std::to_string(getpid());
  const std::string list = "/proc/" + self + "/task/" + self + "/children";
  for (;;) {
    if (leader > 0) kill(-leader, SIGKILL);
    std::ifstream children(list);
    for (pid_t child = 0; children >> child;) kill(child, SIGKILL);
    const pid_t ended = waitpid(-1, nullptr, 0);
    if (ended == leader) leader = 0;  // its number may be another's from here on
    if (ended < 0 && errno != EINTR) return;
  }
}

[[noreturn]] void end_like(int status) {
  if (WIFSIGNALED(status)) {
    signal(WTERMSIG(status), SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    raise(WTERMSIG(status));
  }
  _exit(WIFEXITED(status) ? WEXITSTATUS(status) : exit_cannot_run);
}

}  // namespace

void work_without_survivors(const std::function<void()>& work, pid_t parent) {
  sigset_t awaited, before;
  sigemptyset(&awaited);
  for (const int number : {SIGCHLD, SIGTERM}) sigaddset(&awaited, number);
  sigprocmask(SIG_BLOCK, &awaited, &before);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(exit_cannot_run);
  const pid_t self = getpid(), leader = fork();
  if (leader < 0) _exit(exit_cannot_run);
  if (leader == 0) {
    sigprocmask(SIG_SETMASK, &before, nullptr);
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != self) _exit(exit_cannot_run);
    work();
    _exit(exit_cannot_run);
  }
  setpgid(leader, leader);
  for (;;) {
    int number = 0, status = 0;
    sigwait(&awaited, &number);
    if (number == SIGTERM) break;
    for (pid_t ended = 0; (ended = waitpid(-1, &status, WNOHANG)) > 0;) {
      if (ended != leader) continue;
      kill_all(0);
      end_like(status);
    }
  }
  kill_all(leader);
  _exit(exit_cannot_run);
}

}  // namespace voroproof::internal
