#include "apps/cli/variant.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace voroproof::internal {

void become_faster_variant([[maybe_unused]] char** argv) {
#if defined(VOROPROOF_FASTER_VARIANT)
  const char* wanted = std::getenv("VOROPROOF_VARIANT");
  if (wanted != nullptr && std::string_view(wanted) == "baseline") return;
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") ||
      !__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2")) {
    return;
  }
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return;
  // The other program lies near this one, wherever the tree was installed to, or in the build
  // directory. execv returns only where there is no such program.
  for (const char* place : {VOROPROOF_FASTER_VARIANT, "variant-avx2/voroproof"}) {
    execv((self.parent_path() / place).c_str(), argv);
  }
#endif
}

}  // namespace voroproof::internal
