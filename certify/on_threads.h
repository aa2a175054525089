// Work of several parts on several threads.
#pragma once

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>

namespace voroproof::internal {

// Calls work(k) for each k < parts, once, on so many threads; one thread does them in order. As
// many threads are allowed as are asked for, also more than the machine has. An exception ends all.
template <class Work>
void on_threads(std::size_t parts, int threads, const Work& work) {
  namespace tbb = oneapi::tbb;
  if (threads == 1 || parts < 2) {
    for (std::size_t k = 0; k < parts; ++k) work(k);
    return;
  }
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena(threads).execute([&] { tbb::parallel_for(std::size_t{0}, parts, work); });
}

}  // namespace voroproof::internal
