// Makes one kind of error of any want of memory and of threads, whoever asked for them.
#pragma once

#include <exception>

namespace voroproof::internal {

// Makes GMP and MPFR throw std::bad_alloc where they would end the process. To be called before any
// number is made. That a failure before main(), or inside a function that may not throw, ends the
// process with the exit code that fits is seen to by this room being linked.
void install_memory_handlers();

// Whether it is what oneTBB throws where the system gives no thread: a std::runtime_error that only
// its words tell from others.
bool is_refused_thread(const std::exception& error);

}  // namespace voroproof::internal
