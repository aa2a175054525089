// A library to be loaded before all others (LD_PRELOAD), in which one call to the system fails.
//
// FAILING=KIND:K:ERROR makes the K-th call of that kind fail with that number of errno, K from 1
// on, and FAILING=KIND:K:ERROR:on all from there on. Each process counts its own calls. Of `short`
// the call writes half of its bytes and is no failure. FAILING_COUNTS=FILE has the calls of each
// kind written there where the process ends by exit().
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>

extern "C" {
// By these names the C library has its own allocation.
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

enum Kind {
  memory,
  writing,
  part,
  opening,
  reading,
  renaming,
  syncing,
  closing,
  threads,
  forks,
  kinds
};
constexpr std::array<const char*, kinds> names{"memory", "write", "short", "open",   "read",
                                               "rename", "fsync", "close", "thread", "fork"};

std::array<std::atomic<long>, kinds> calls{};
Kind failing = kinds;
long at = 0;
int error = 0;
bool all_from_there = false;

// Whether this call is to fail.
bool fails(Kind kind) {
  const long number = ++calls[kind];
  if (kind != failing) return false;
  if (!(all_from_there ? number >= at : number == at)) return false;
  errno = error;
  return true;
}

void read_wish() {
  const char* wish = getenv("FAILING");
  if (wish == nullptr) return;
  for (int k = 0; k < kinds; ++k) {
    const size_t length = strlen(names[k]);
    if (strncmp(wish, names[k], length) != 0 || wish[length] != ':') continue;
    char* rest = nullptr;
    at = strtol(wish + length + 1, &rest, 10);
    if (*rest == ':') error = static_cast<int>(strtol(rest + 1, &rest, 10));
    all_from_there = strcmp(rest, ":on") == 0;
    failing = static_cast<Kind>(k);
  }
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

// Looked up in the C library when it is first called: dlsym() may ask for memory.
#define NEXT(name) static const auto real = next<decltype(::name)>(#name)

// Before the constructors of everything that comes later.
__attribute__((constructor(101))) void begin() {
  read_wish();
  for (auto& number : calls) number = 0;
}

__attribute__((destructor)) void end() {
  const char* file = getenv("FAILING_COUNTS");
  if (file == nullptr) return;
  failing = kinds;
  const std::array<std::atomic<long>, kinds>& counted = calls;
  long so_far[kinds];
  for (int k = 0; k < kinds; ++k) so_far[k] = counted[k].load();
  if (FILE* out = fopen(file, "w")) {
    for (int k = 0; k < kinds; ++k) fprintf(out, "%s %ld\n", names[k], so_far[k]);
    fclose(out);
  }
}

bool is_message(int descriptor) { return descriptor == STDERR_FILENO; }

}  // namespace

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED void* malloc(size_t size) { return fails(memory) ? nullptr : __libc_malloc(size); }
EXPORTED void* calloc(size_t count, size_t size) {
  return fails(memory) ? nullptr : __libc_calloc(count, size);
}
EXPORTED void* realloc(void* block, size_t size) {
  return fails(memory) ? nullptr : __libc_realloc(block, size);
}
EXPORTED void* aligned_alloc(size_t alignment, size_t size) {
  return fails(memory) ? nullptr : __libc_memalign(alignment, size);
}
EXPORTED int posix_memalign(void** block, size_t alignment, size_t size) {
  if (fails(memory)) return ENOMEM;
  *block = __libc_memalign(alignment, size);
  return *block != nullptr ? 0 : ENOMEM;
}

EXPORTED ssize_t write(int descriptor, const void* data, size_t size) {
  NEXT(write);
  if (is_message(descriptor)) return real(descriptor, data, size);
  if (fails(writing)) return -1;
  return real(descriptor, data, size > 1 && fails(part) ? size / 2 : size);
}
EXPORTED ssize_t pwrite(int descriptor, const void* data, size_t size, off_t place) {
  NEXT(pwrite);
  return fails(writing) ? -1 : real(descriptor, data, size, place);
}
EXPORTED ssize_t read(int descriptor, void* data, size_t size) {
  NEXT(read);
  return fails(reading) ? -1 : real(descriptor, data, size);
}
EXPORTED ssize_t pread(int descriptor, void* data, size_t size, off_t place) {
  NEXT(pread);
  return fails(reading) ? -1 : real(descriptor, data, size, place);
}
EXPORTED int open(const char* path, int flags, ...) {
  NEXT(open);
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return fails(opening) ? -1 : real(path, flags, mode);
}
EXPORTED FILE* fopen(const char* path, const char* mode) {
  NEXT(fopen);
  return fails(opening) ? nullptr : real(path, mode);
}
EXPORTED int close(int descriptor) {
  NEXT(close);
  if (!fails(closing)) return real(descriptor);
  real(descriptor);
  errno = error;
  return -1;
}
EXPORTED int rename(const char* from, const char* to) {
  NEXT(rename);
  return fails(renaming) ? -1 : real(from, to);
}
EXPORTED int fsync(int descriptor) {
  NEXT(fsync);
  return fails(syncing) ? -1 : real(descriptor);
}
EXPORTED int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                            void* (*start)(void*), void* argument) {
  NEXT(pthread_create);
  return fails(threads) ? error : real(thread, attributes, start, argument);
}
EXPORTED pid_t fork() {
  NEXT(fork);
  return fails(forks) ? -1 : real();
}
