// Makes one kind of error of any want of memory, whoever asked for the memory.
#pragma once

namespace voroproof::internal {

// Makes GMP and MPFR throw std::bad_alloc where they would end the process, and a failure inside a
// function that may not throw end it with the exit code that fits. To be called before any number
// is made.
void install_memory_handlers();

}  // namespace voroproof::internal
