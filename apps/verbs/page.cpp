// voroproof page: the certifier as a page for browsers.
#include <memory>

#include "apps/certifier/certifier.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/verbs/verbs.h"

namespace voroproof::internal {

void add_page(Verb& program) {
  auto output = std::make_shared<std::string>();
  Verb& verb = program.add_verb("page", "Make a page that certifies histories in a browser");
  verb.output(*output, "The page to write: HTML that needs no other file and no network.")
      .required();
  verb.example("voroproof page -o certifier.html");
  verb.does([output] {
    const CooperativeInterruption interruption;
    write_certifier(*output, producer());
    return ExitCode::ok;
  });
}

}  // namespace voroproof::internal
