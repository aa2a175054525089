// Memory asked for before it is needed. Nothing is decided by it.
#pragma once

#include <cstddef>

namespace voroproof::internal {

// Asks the processor for the memory of an object. The pointer is not followed, so that it may be
// any address. (Always inline: g++ leaves out calls of functions that do nothing else.)
template <class T>
[[gnu::always_inline]] inline void prefetch(const T* object) {
  const char* const begin = reinterpret_cast<const char*>(object);
  for (std::size_t byte = 0; byte < sizeof(T); byte += 64) __builtin_prefetch(begin + byte);
  if constexpr (sizeof(T) > alignof(T)) __builtin_prefetch(begin + sizeof(T) - 1);
}

}  // namespace voroproof::internal
