#include "apps/cli/memory.h"

#include <flint/flint.h>
#include <gmp.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "apps/cli/command_line.h"
#include "apps/cli/limits.h"
#include "history/atomic_file.h"

namespace voroproof::internal {
namespace {

// The exceptions pass through frames of GMP, MPFR and FLINT, which hold nothing but memory, and
// that is no longer of interest: the program reports the error and ends.
void* allocate(std::size_t size) {
  if (void* block = std::malloc(size)) return block;
  throw std::bad_alloc();
}

void* allocate_zeros(std::size_t count, std::size_t size) {
  if (void* block = std::calloc(count, size)) return block;
  throw std::bad_alloc();
}

void* reallocate(void* block, std::size_t size) {
  if (void* moved = std::realloc(block, size)) return moved;
  throw std::bad_alloc();
}

[[noreturn]] void end_with(ExitCode code, std::string_view message) {
  AtomicFile::remove_unfinished();
  // There may be no memory for a stream.
  if (write(STDERR_FILENO, message.data(), message.size()) < 0) _exit(static_cast<int>(code));
  _exit(static_cast<int>(code));
}

// Whether there was no memory for an object.
std::atomic<bool> refused{false};

[[noreturn]] void refuse() {
  refused.store(true);
  throw std::bad_alloc();
}

[[noreturn]] void end_without_memory() {
  if (has_memory_limit()) {
    end_with(ExitCode::undecided, "voroproof: the memory limit is reached (--max-memory)\n");
  }
  end_with(ExitCode::memory, "voroproof: out of memory\n");
}

[[noreturn]] void on_terminate() {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    // Thrown in a function of a library that may not throw: it cannot be told what.
    if (refused.load()) end_without_memory();
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::exception& error) {
    // Thrown in a thread of oneTBB's own, which wakes the next.
    if (is_refused_thread(error)) {
      end_with(ExitCode::memory, "voroproof: the system refuses: no thread\n");
    }
  } catch (...) {
  }
  end_with(ExitCode::internal, "voroproof: internal error: terminated\n");
}

// Objects outside of functions ask for memory before main(): this one is made before all others.
const struct EarlyHandler {
  EarlyHandler() {
    std::set_terminate(on_terminate);
    std::set_new_handler(refuse);
  }
} early_handler [[gnu::init_priority(101)]];

}  // namespace

bool is_refused_thread(const std::exception& error) {
  return std::string_view(error.what()).starts_with("pthread_create has failed");
}

void install_memory_handlers() {
  mp_set_memory_functions(
      allocate, [](void* block, std::size_t, std::size_t size) { return reallocate(block, size); },
      [](void* block, std::size_t) { std::free(block); });
  __flint_set_memory_functions(allocate, allocate_zeros, reallocate, std::free);
}

}  // namespace voroproof::internal
