#include "apps/cli/verb.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "apps/cli/suggestion.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

// The name that stands for standard input and output.
constexpr const char* stream_name = "-";

// "-o,--output" as its parts.
std::vector<std::string> split(const std::string& names) {
  const std::size_t comma = names.find(',');
  if (comma == std::string::npos) return {names};
  return {names.substr(0, comma), names.substr(comma + 1)};
}

[[noreturn]] void refuse(const std::string& option, const std::string& reason) {
  throw UsageError(option + ": " + reason);
}

void require_text(const std::string& option, const std::string& text) {
  if (text.empty()) refuse(option, "is empty");
}

// The value of a decimal number without leading zeros, sign or exponent.
std::uint64_t whole_value(const std::string& option, const std::string& text) {
  const char* const end = text.data() + text.size();
  std::uint64_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || text != std::to_string(value)) {
    refuse(option, text + " is not a whole number below 2^64");
  }
  return value;
}

}  // namespace

Verb& Verb::add_verb(const std::string& name, const std::string& description) {
  return verbs_.emplace_back(name, description);
}

Option& Verb::add(Option option) {
  options_.push_back(std::move(option));
  return options_.back();
}

Option& Verb::flag(const std::string& names, bool& value, const std::string& help) {
  Option& option = add({.names = split(names), .help = help});
  option.take = [&value](const std::vector<std::string>&) { value = true; };
  return option;
}

Option& Verb::text(const std::string& names, std::string& value, const std::string& type,
                   const std::string& help) {
  Option& option = add({.names = split(names), .type = type, .help = help, .initial = value});
  option.take = [&option, &value](const std::vector<std::string>& values) {
    require_text(option.name(), values[0]);
    value = values[0];
  };
  return option;
}

Option& Verb::input(const std::string& names, std::string& path, const std::string& help) {
  return named_file(names, path, help, "/dev/stdin");
}

Option& Verb::inputs(const std::string& names, std::vector<std::string>& paths,
                     const std::string& help) {
  Option& option = list(names, paths, "FILE", help);
  option.take = [take = option.take, &paths](const std::vector<std::string>& given) {
    take(given);
    std::replace(paths.begin(), paths.end(), std::string(stream_name), std::string("/dev/stdin"));
  };
  return option;
}

Option& Verb::output(const std::string& names, std::string& path, const std::string& help) {
  return named_file(names, path, help, "/dev/stdout");
}

Option& Verb::output(std::string& path, const std::string& help) {
  return output("-o,--output", path, help);
}

Option& Verb::named_file(const std::string& names, std::string& path, const std::string& help,
                         const std::string& stream) {
  Option& option = text(names, path, "FILE", help);
  option.take = [take = option.take, &path, stream](const std::vector<std::string>& values) {
    take(values);
    if (path == stream_name) path = stream;
  };
  return option;
}

Option& Verb::real(const std::string& names, double& value, const std::string& help) {
  Option& option =
      add({.names = split(names), .type = "NUMBER", .help = help, .initial = number_text(value)});
  option.take = [&option, &value](const std::vector<std::string>& values) {
    const std::string& text = values[0];
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) {
      refuse(option.name(), text + " is not a finite binary64 number");
    }
  };
  return option;
}

Option& Verb::choice(const std::string& names, const std::vector<std::string>& choices,
                     std::string& value, const std::string& help) {
  Option& option = add({.names = split(names), .type = "NAME", .help = help, .initial = value});
  option.choices = choices;
  option.take = [&value](const std::vector<std::string>& values) { value = values[0]; };
  return option;
}

Option& Verb::list(const std::string& names, std::vector<std::string>& values,
                   const std::string& type, const std::string& help) {
  Option& option = add({.names = split(names), .type = type, .help = help});
  option.repeats = true;
  option.take = [&option, &values](const std::vector<std::string>& given) {
    for (const std::string& text : given) require_text(option.name(), text);
    values = given;
  };
  return option;
}

Option& Verb::whole_number(const std::string& names, std::optional<std::uint64_t> initial,
                           std::uint64_t least, std::uint64_t most, const std::string& help,
                           std::function<void(std::uint64_t)> set) {
  Option& option = add({.names = split(names), .type = "N", .help = help});
  if (initial && *initial >= least && *initial <= most) option.initial = std::to_string(*initial);
  option.take = [&option, least, most,
                 set = std::move(set)](const std::vector<std::string>& values) {
    const std::uint64_t value = whole_value(option.name(), values[0]);
    if (value < least || value > most) {
      refuse(option.name(),
             values[0] + " is not in " + std::to_string(least) + " to " + std::to_string(most));
    }
    set(value);
  };
  return option;
}

Verb& Verb::note(const std::string& text) {
  notes_ += notes_.empty() ? text : " " + text;
  return *this;
}

Verb& Verb::example(const std::string& command) {
  examples_.push_back(command);
  return *this;
}

bool Verb::given(const std::string& option) const {
  for (const Option& o : options_) {
    if (o.name() == option) return o.given;
  }
  throw std::logic_error("no such option: " + option);
}

}  // namespace voroproof::internal
