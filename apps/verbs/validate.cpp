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
  ExitCode code = ExitCode::ok;
  for (const std::string& file : files) {
    try {
      const std::string description = validate_file(file);
      std::cout << printable(file, longest_name) << ": " << description << '\n' << std::flush;
    } catch (const InputError& error) {
      std::cerr << "voroproof: " << printable(error.what(), longest_name) << '\n';
      code = ExitCode::bad_input;
    }
  }
  return code;
}

}  // namespace

void add_validate(Verb& program) {
  auto files = std::make_shared<std::vector<std::string>>();
  Verb& verb = program.add_verb("validate", "Check that files are of the formats");
  verb.inputs("files", *files, "The files. Each that is not valid gets a line of its own.")
      .required();
  verb.example("voroproof validate a.scene.json a.history.jsonl");
  verb.does([files] { return validate(*files); });
}

}  // namespace voroproof::internal
