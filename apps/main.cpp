// voroproof: exact event histories of the Voronoi diagram of moving disks.
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include "apps/cli/command_line.h"
#include "apps/cli/help.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/memory.h"
#include "apps/cli/parser.h"
#include "apps/cli/variant.h"
#include "apps/verbs/verbs.h"
#include "exact/rounding.h"
#include "exact/tower.h"
#include "filtered/motion/motion.h"
#include "history/error.h"
#include "history/event_limit.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t longest_message = 2000;

ExitCode complain(ExitCode code, const std::string& message) {
  std::cerr << "voroproof: " << printable(message, longest_message) << '\n';
  return code;
}

void describe(Verb& program) {
  add_generate(program);
  add_simulate(program);
  add_snapshot(program);
  add_diagram(program);
  add_query(program);
  add_render(program);
  add_movie(program);
  add_page(program);
  add_validate(program);
  add_certify(program);
  add_index(program);
  add_clearance(program);
  add_explain(program);
  add_convert(program);
  add_corpus(program);
  add_plan(program);
  add_minimize(program);
  add_truth(program);
  add_process_limits(program);
  add_help(program);
  program.note(
      "Exit codes: 0 done, 1 refuted, 2 bad input or usage, 3 undecided, 4 internal error, "
      "5 out of memory, 6 interrupted.");
  program.example("voroproof simulate a.scene.json -o a.history.jsonl");
}

ExitCode run(int argc, const char* const* argv) {
  Verb program("voroproof", "Exact event histories of the Voronoi diagram of moving disks");
  describe(program);
  const Verb* const verb = parse(program, argc, argv);
  ExitCode code = ExitCode::ok;
  if (verb != nullptr) {
    start_process_limits();
    code = verb->act();
  }
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
  } catch (const EventLimitReached& error) {
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
    if (is_refused_thread(error)) {
      return complain(ExitCode::memory, std::string("the system refuses: ") + error.what());
    }
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
