// The limits that users set on a run. Each means the same wherever it is an option; a run that
// reaches one is undecided (exit code 3), and its result, or where it has none its message, names
// the limit.
#pragma once

#include <cstdint>
#include <string>

#include "apps/cli/verb.h"

namespace voroproof::internal {

struct EngineOptions;

// --time-limit and --max-memory, for every verb of the program.
void add_process_limits(Verb& program);
// Sets the limits that the command line names. To be called once it is parsed.
void start_process_limits();

// --max-bits: of the numbers from which decisions are taken.
void add_max_bits(Verb& verb, int& bits);

// --max-events: of the history that is computed, certified or read. 0 is no limit. What the engine
// computes is limited by EngineOptions, what is read by an EventLimit, both by the verb.
void add_max_events(Verb& verb, std::uint64_t& events);

// Both, for a verb that computes by these options.
void add_computing_limits(Verb& verb, EngineOptions& options);

// Why a run ended that reached a limit.
std::string time_limit_reason();
std::string memory_limit_reason();
std::string event_limit_reason(std::uint64_t events);

// Whether memory that is not to be had is the user's own limit.
bool has_memory_limit();
// Lets the process have the memory that the system gives: for writing the result when the user's
// limit has been reached.
void lift_memory_limit();

}  // namespace voroproof::internal
