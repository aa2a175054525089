// Out of memory as one kind of error, whoever asked for it.
#pragma once

namespace voroproof::internal {

// Makes GMP and MPFR throw std::bad_alloc where they would end the process, and a failure inside a
// function that may not throw end it with the exit code that fits. To be called before any number
// is made.
void install_memory_handlers();

}  // namespace voroproof::internal
