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
  // The other program lies beside this one, wherever it was installed to.
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return;
  const std::filesystem::path faster = self.parent_path() / VOROPROOF_FASTER_VARIANT;
  // Returns only where there is no such program.
  execv(faster.c_str(), argv);
#endif
}

}  // namespace voroproof::internal
