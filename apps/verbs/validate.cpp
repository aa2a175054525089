// voroproof validate: is a file of one of the project's formats?
#include <iostream>
#include <memory>
#include <vector>

#include "apps/cli/command_line.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"
#include "history/validate.h"

namespace voroproof::internal {
namespace {

ExitCode validate(const std::vector<std::string>& files) {
  constexpr std::size_t longest_name = 4096;
  for (const std::string& file : files) {
    const std::string description = validate_file(file);
    std::cout << printable(file, longest_name) << ": " << description << '\n' << std::flush;
  }
  return ExitCode::ok;
}

}  // namespace

void add_validate(CLI::App& app, Action& action) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* verb =
      app.add_subcommand("validate", "Check that files are scenes, histories or diagrams");
  verb->add_option("files", *files, "the files; checking ends at the first that is not valid")
      ->type_name("FILE")
      ->required();
  verb->footer("Example:\n  voroproof validate a.scene.json a.history.jsonl");
  verb->callback([files, &action] { action = [files] { return validate(*files); }; });
}

}  // namespace voroproof::internal
