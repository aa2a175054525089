// A target for libFuzzer: the one that VOROPROOF_FUZZ_TARGET names.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "tests/fuzz/mutation.h"
#include "tests/fuzz/target.h"

namespace {

using namespace voroproof::internal::fuzz;

std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

std::size_t put(std::string_view text, std::uint8_t* data, std::size_t most) {
  const std::size_t size = std::min(text.size(), most);
  std::memcpy(data, text.data(), size);
  return size;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Target& asked = target(VOROPROOF_FUZZ_TARGET);
  asked.accepts(text_of(data, size));
  return 0;
}

// Half of the changes are those of the formats, half libFuzzer's own.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  Chance chance(seed);
  if (size == 0 || chance.below(2) == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string text(text_of(data, size));
  return put(mutated(text, text, chance), data, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size,
                                                 const std::uint8_t* other, std::size_t other_size,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  Chance chance(seed);
  return put(mutated(std::string(text_of(one, one_size)), text_of(other, other_size), chance), out,
             most);
}
