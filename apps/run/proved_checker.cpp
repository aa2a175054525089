// The program voroproof-proved as a second checker.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include "apps/cli/command_line.h"
#include "apps/run/second_checker.h"

namespace voroproof::internal {

namespace {

constexpr const char* program_name = "voroproof-proved";
constexpr int cannot_run = 127;  // as shells have it

std::optional<std::string> installed() {
  const auto runs = [](const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
  };
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const auto& folder : {self, self / "proofs"}) {
    if (!error && runs(folder / program_name)) return folder / program_name;
  }
  const char* folders = std::getenv("PATH");
  std::istringstream path(folders == nullptr ? "" : folders);
  for (std::string folder; std::getline(path, folder, ':');) {
    if (!folder.empty() && runs(std::filesystem::path(folder) / program_name)) {
      return std::filesystem::path(folder) / program_name;
    }
  }
  return std::nullopt;
}

std::string refusal(const CertifyOptions& options) {
  if (!options.judges_flips()) return "the proved checker judges all events (--events all)";
  if (options.truth != Truth::recorded) {
    return "the proved checker judges the recorded truth (--truth recorded)";
  }
  if (options.strict) return "the proved checker knows no --strict";
  if (installed()) return {};
  return std::string("the program ") + program_name +
         " is not installed: neither beside voroproof nor in a folder of PATH (docs/proved.md, "
         "section 8)";
}

// The bytes as a file without a name, as far as this process and what it becomes are concerned.
std::string file_with(const std::string& bytes) {
  std::FILE* file = std::tmpfile();
  if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() ||
      std::fflush(file) != 0) {
    std::printf("no room for a temporary file\n");
    _exit(static_cast<int>(ExitCode::bad_input));
  }
  return "/proc/self/fd/" + std::to_string(dup(fileno(file)));
}

// In the checker's process: becomes the program.
int judge(const std::string& scene, const std::string& history, const CertifyOptions& options) {
  const std::optional<std::string> program = installed();
  const std::string first = file_with(scene), second = file_with(history);
  const std::string tolerance = options.tolerance.get_str(),
                    law_tolerance = options.law_tolerance.get_str();
  if (program) {
    execl(program->c_str(), program_name, first.c_str(), second.c_str(), "--tolerance",
          tolerance.c_str(), "--law-tolerance", law_tolerance.c_str(), static_cast<char*>(nullptr));
  }
  return cannot_run;
}

}  // namespace

SecondChecker proved_checker() {
  return {.option = "--proved",
          .name = "proved checker",
          .field = "proved_checker",
          .refusal = refusal,
          .work = judge};
}

}  // namespace voroproof::internal
