// A process of which no descendant survives.
#pragma once

#include <sys/types.h>

#include <functional>

namespace voroproof::internal {

// In a process that `parent` has forked, the first thing there: forks another, which does the work
// and ends with its exit code, and sees to it that nothing is left of it. What has left the process
// group or the session, or lost its parent, becomes a child of this process
// (PR_SET_CHILD_SUBREAPER) and is killed when the work has ended, when SIGTERM comes, and when the
// parent of this process ends, however. Ends as the work did; where it was SIGTERM, when nothing is
// left.
[[noreturn]] void work_without_survivors(const std::function<void()>& work, pid_t parent);

}  // namespace voroproof::internal
