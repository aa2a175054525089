// The command line as data: verbs with their arguments and options. How a command line is read is
// the parser's matter (apps/cli/parser.h); help, manual pages and completions are made from what
// stands here.
#pragma once

#include <charconv>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/command_line.h"

namespace voroproof::internal {

// An option, or an argument, which has a name without dashes and is told by its place.
struct Option {
  std::vector<std::string> names = {};  // "-o", "--output"; the last one is used in messages
  std::string type = {};                // the value's name in the help; empty: a flag
  std::string help = {};                // sentences
  std::string initial = {};  // the value where none is given, as it is shown; empty: none
  std::vector<std::string> choices = {};  // the only values there are; empty: any that `take` takes
  int values = 1;                         // number of values in one use
  bool is_required = false, repeats = false;
  std::vector<std::string> excluded = {};  // options that cannot be given as well
  std::vector<std::string> needed = {};    // options that must be given as well
  std::vector<std::string> unless = {};    // with one of these a required one is not to be given
  bool takes_rest = false;                 // all words that follow, up to the next option
  // Reads the values, with which the option was given. Throws UsageError.
  std::function<void(const std::vector<std::string>& values)> take = {};

  // Set by the parser.
  bool given = false;

  const std::string& name() const { return names.back(); }
  bool is_flag() const { return type.empty(); }
  bool is_argument() const { return !name().starts_with('-'); }

  Option& required() {
    is_required = true;
    initial.clear();
    return *this;
  }
  Option& required_unless(const std::string& other) {
    required();
    unless.push_back(other);
    excluded.push_back(other);
    return *this;
  }
  Option& excludes(const std::vector<std::string>& others) {
    excluded = others;
    return *this;
  }
  Option& with_all_that_follow() {
    takes_rest = true;
    return *this;
  }
  Option& needs(const std::string& other) {
    needed.push_back(other);
    return *this;
  }
};

// A verb, or the program itself: with verbs below it, or with an action.
class Verb {
 public:
  Verb(std::string name, std::string description)
      : name_(std::move(name)), description_(std::move(description)) {}
  Verb(const Verb&) = delete;
  Verb& operator=(const Verb&) = delete;

  // The references that these return hold as long as the verb. `names` is one name, or a short and
  // a long one separated by a comma; what is read goes to the variable, which must outlive the
  // verb.
  Verb& add_verb(const std::string& name, const std::string& description);
  Option& add(Option option);
  Option& flag(const std::string& names, bool& value, const std::string& help);
  // A text that is not empty; shown is its value so far.
  Option& text(const std::string& names, std::string& value, const std::string& type,
               const std::string& help);
  // The name of a file to read; - is standard input, whose name is then /dev/stdin.
  Option& input(const std::string& names, std::string& path, const std::string& help);
  Option& inputs(const std::string& names, std::vector<std::string>& paths,
                 const std::string& help);
  // The name of a file to write; - is standard output, whose name is then /dev/stdout.
  Option& output(const std::string& names, std::string& path, const std::string& help);
  // The option -o, --output.
  Option& output(std::string& path, const std::string& help);
  // A decimal number, which means the binary64 nearest to it.
  Option& real(const std::string& names, double& value, const std::string& help);
  // One of a few words.
  Option& choice(const std::string& names, const std::vector<std::string>& choices,
                 std::string& value, const std::string& help);
  // Any number of texts: an option that may be given several times, or the last argument.
  Option& list(const std::string& names, std::vector<std::string>& values, const std::string& type,
               const std::string& help);
  // A whole number from `least` to `most`. A value so far that is out of this range is not shown.
  template <class Integer>
  Option& whole(const std::string& names, Integer& value, std::uint64_t least, std::uint64_t most,
                const std::string& help) {
    return whole_number(names, static_cast<std::uint64_t>(value), least, most, help,
                        [&value](std::uint64_t given) { value = static_cast<Integer>(given); });
  }
  template <class Integer>
  Option& whole(const std::string& names, std::optional<Integer>& value, std::uint64_t least,
                std::uint64_t most, const std::string& help) {
    return whole_number(names, {}, least, most, help,
                        [&value](std::uint64_t given) { value = static_cast<Integer>(given); });
  }

  // Sentences that the help has after the options.
  Verb& note(const std::string& text);
  // A command line, which the help ends with.
  Verb& example(const std::string& command);
  // Sets the action of the verb.
  void does(std::function<ExitCode()> action) { action_ = std::move(action); }

  const std::string& name() const { return name_; }
  const std::string& description() const { return description_; }
  const std::string& notes() const { return notes_; }
  const std::vector<std::string>& examples() const { return examples_; }
  std::deque<Option>& options() { return options_; }
  const std::deque<Option>& options() const { return options_; }
  const std::deque<Verb>& verbs() const { return verbs_; }
  std::deque<Verb>& verbs() { return verbs_; }
  // Whether the option was given on the command line.
  bool given(const std::string& option) const;
  ExitCode act() const { return action_(); }

 private:
  Option& named_file(const std::string& names, std::string& path, const std::string& help,
                     const std::string& stream);
  Option& whole_number(const std::string& names, std::optional<std::uint64_t> initial,
                       std::uint64_t least, std::uint64_t most, const std::string& help,
                       std::function<void(std::uint64_t)> set);

  std::string name_, description_, notes_;
  std::vector<std::string> examples_;
  std::deque<Option> options_;
  std::deque<Verb> verbs_;
  std::function<ExitCode()> action_;
};

}  // namespace voroproof::internal
