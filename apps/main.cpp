// voroproof: exact event histories of the Voronoi diagram of moving disks.
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/memory.h"
#include "apps/cli/variant.h"
#include "apps/verbs/verbs.h"
#include "exact/rounding.h"
#include "exact/tower.h"
#include "filtered/motion/motion.h"
#include "history/error.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t longest_message = 2000;

ExitCode complain(ExitCode code, const std::string& message) {
  std::cerr << "voroproof: " << printable(message, longest_message) << '\n';
  return code;
}

void describe(CLI::App& app, Action& action) {
  app.name("voroproof");
  app.require_subcommand(1);
  app.set_version_flag("--version", producer());
  add_generate(app, action);
  add_simulate(app, action);
  add_snapshot(app, action);
  add_query(app, action);
  add_render(app, action);
  add_movie(app, action);
  add_validate(app, action);
  add_certify(app, action);
  add_explain(app, action);
  add_convert(app, action);
  add_corpus(app, action);
  add_plan(app, action);
  add_check72(app, action);
  add_experiment(app, action);
  add_process_limits(app);
  app.footer(
      "Exit codes: 0 done, 1 refuted, 2 bad input or usage, 3 undecided, 4 internal error, 5 out "
      "of\n"
      "memory, 6 interrupted.\n"
      "Example:\n  voroproof simulate a.scene.json -o a.history.jsonl");
}

// The message for a command line that does not parse.
std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* verb = &app;
  std::string name = app.get_name();
  while (!verb->get_subcommands().empty()) {
    verb = verb->get_subcommands().front();
    name += " " + verb->get_name();
  }
  std::string message = error.what();
  if (verb->get_require_subcommand_min() > 0) {
    const std::vector<std::string> unknown = app.remaining(true);
    message = unknown.empty() ? "no verb given" : "unknown verb or option " + unknown.front();
  }
  return message + " (see " + name + " --help)";
}

ExitCode run(int argc, const char* const* argv) {
  CLI::App app("Exact event histories of the Voronoi diagram of moving disks");
  Action action;
  describe(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help, std::cout, std::cerr);
  } catch (const CLI::ParseError& error) {
    return complain(ExitCode::bad_input, complaint(app, error));
  }
  start_process_limits();
  const ExitCode code = action ? action() : ExitCode::ok;
  std::cout.flush();
  if (!std::cout) return complain(ExitCode::bad_input, "standard output: cannot write");
  return code;
}

// Every way to end, and its exit code.
ExitCode guarded_run(int argc, const char* const* argv) {
  try {
    require_ieee_arithmetic();
    return run(argc, argv);
  } catch (const InputError& error) {
    return complain(ExitCode::bad_input, error.what());
  } catch (const OutputError& error) {
    return complain(ExitCode::bad_input, error.what());
  } catch (const UsageError& error) {
    return complain(ExitCode::bad_input, error.what());
  } catch (const Undecided& error) {
    return complain(ExitCode::undecided, error.what());
  } catch (const BudgetExceeded& error) {
    return complain(ExitCode::undecided, error.what());
  } catch (const Interrupted& error) {
    return complain(ExitCode::interrupted, error.what());
  } catch (const std::bad_alloc&) {
    lift_memory_limit();
    return has_memory_limit() ? complain(ExitCode::undecided, memory_limit_reason())
                              : complain(ExitCode::memory, "out of memory");
  } catch (const std::system_error& error) {
    // Threads and processes that are not to be had.
    return complain(ExitCode::memory, std::string("the system refuses: ") + error.what());
  } catch (const std::exception& error) {
    return complain(ExitCode::internal, std::string("internal error: ") + error.what());
  }
}

}  // namespace
}  // namespace voroproof::internal

int main(int argc, char** argv) {
  voroproof::internal::become_faster_variant(argv);
  voroproof::internal::install_memory_handlers();
  voroproof::internal::install_signal_handlers();
  return static_cast<int>(voroproof::internal::guarded_run(argc, argv));
}
