// The common parts of the command line's verbs: exit codes, the errors of usage, and arguments that
// are exact numbers.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact/rational.h"

namespace voroproof::internal {

// One code for each kind of outcome.
enum class ExitCode {
  ok = 0,
  refuted = 1,      // a history was disproved; there is no such plan
  bad_input = 2,    // a bad command line or input, an output that cannot be written
  undecided = 3,    // the run stopped: a decision beyond the budget, an inelastic collapse
  internal = 4,     // a fault of the program
  memory = 5,       // out of memory
  interrupted = 6,  // SIGINT, SIGTERM, SIGHUP or SIGQUIT
};

// A command line that asks for what is not possible; what() is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// "voroproof VERSION", as histories name their producer.
std::string producer();

// The least and the greatest value of an option that is a precision, in bits.
inline constexpr int least_bits = 64, most_bits = 1 << 24;

// The greatest value of a whole number.
inline constexpr std::uint64_t most_whole = std::numeric_limits<std::uint64_t>::max();

// A number from its exact text: a decimal, a fraction or a hexadecimal float, within the limits of
// a scene's values. Throws UsageError, naming the option.
Rational number_argument(const std::string& option, const std::string& text);

// A time (or a radius) >= 0 from its exact text: a decimal, a fraction or a hexadecimal float,
// within the limits of a scene's values. Throws UsageError, naming the option.
Rational time_argument(const std::string& option, const std::string& text);

// Throws UsageError where one of the output files is another of them or one of the inputs, or two
// inputs are one stream. Empty names are passed over.
void require_distinct(const std::vector<std::string>& inputs,
                      const std::vector<std::string>& outputs);

// Throws UsageError where the two files are exchanged: a history for the scene and a scene for the
// history. An empty name of a history is none.
void require_order(const std::string& scene, const std::string& history);

// Throws UsageError where a picture of this name could not be drawn: it must end in .svg, .png
// or .pdf, compressed or not, or be a stream, into which an SVG is drawn.
void require_picture(const std::string& option, const std::string& path);

// Where a verb with these outputs says what it did: standard output, or standard error where one of
// the outputs goes to standard output. Empty names are passed over.
std::ostream& words_beside(const std::vector<std::string>& outputs);

// Whether doubles may decide. Tests set VOROPROOF_FILTERS=off in the environment, where nothing
// else changes (CONTRIBUTING.md).
bool filters_wanted();

}  // namespace voroproof::internal
