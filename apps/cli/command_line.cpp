#include "apps/cli/command_line.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include "history/error.h"
#include "history/json_text.h"
#include "history/scene.h"

namespace voroproof::internal {
namespace {

bool same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  // Files that do not exist yet are compared by name.
  const fs::path first = fs::weakly_canonical(fs::absolute(a, error), error);
  if (error) return a == b;
  const fs::path second = fs::weakly_canonical(fs::absolute(b, error), error);
  return error ? a == b : first == second;
}

// The library of the command line would take 010 for eight, wrap -1 around and cut what is too
// large.
std::string fault_of_whole(const std::string& text) {
  const char* const end = text.data() + text.size();
  std::uint64_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || text != std::to_string(value)) {
    return text + " is not a whole number below 2^64";
  }
  return {};
}

}  // namespace

std::string producer() { return "voroproof " VOROPROOF_VERSION; }

CLI::Option* add_text(CLI::App& verb, const std::string& name, std::string& value,
                      const std::string& type, const std::string& description) {
  const auto fault = [](const std::string& text) { return text.empty() ? "is empty" : ""; };
  return verb.add_option(name, value, description)
      ->type_name(type)
      ->check(CLI::Validator(fault, ""));
}

CLI::Option* add_file(CLI::App& verb, const std::string& name, std::string& path,
                      const std::string& description) {
  return add_text(verb, name, path, "FILE", description);
}

CLI::Option* add_output(CLI::App& verb, std::string& path, const std::string& description) {
  return add_file(verb, "-o,--output", path, description)->required();
}

CLI::Option* add_real(CLI::App& verb, const std::string& name, double& value,
                      const std::string& description) {
  const auto read = [name, &value](const std::string& text) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) {
      throw CLI::ValidationError(name, text + " is not a finite binary64 number");
    }
  };
  return verb.add_option_function<std::string>(name, read, description)
      ->type_name("NUMBER")
      ->default_str(number_text(value));
}

CLI::Option* add_choice(CLI::App& verb, const std::string& name,
                        const std::vector<std::string>& choices, std::string& value,
                        const std::string& description) {
  return verb.add_option(name, value, description)
      ->check(CLI::IsMember(choices))
      ->type_name("NAME")
      ->capture_default_str();
}

CLI::Validator whole_number() { return CLI::Validator(fault_of_whole, ""); }

Rational number_argument(const std::string& option, const std::string& text) {
  const auto fail = [&](const std::string& reason) {
    throw UsageError(option + ": " + printable(text) + ": " + reason);
  };
  std::string reason;
  const std::optional<Rational> q = parse_rational(text, &reason);
  if (!q) fail(reason);
  const Rational magnitude = abs(*q);
  if (magnitude != 0 &&
      (magnitude > to_rational(max_scene_value) || magnitude < to_rational(min_scene_value))) {
    fail("beyond the limits of a scene: 0 or 1e-100 to 1e100");
  }
  // Files give it as "p/q".
  if (q->get_str().size() + 1 > max_number_text) {
    fail("a fraction of more than " + std::to_string(max_number_text) + " characters");
  }
  return *q;
}

Rational time_argument(const std::string& option, const std::string& text) {
  const Rational t = number_argument(option, text);
  if (t < 0) throw UsageError(option + ": " + printable(text) + ": negative");
  return t;
}

void require_distinct(const std::vector<std::string>& inputs,
                      const std::vector<std::string>& outputs) {
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    if (outputs[k].empty()) continue;
    for (const std::string& input : inputs) {
      if (!input.empty() && same_file(outputs[k], input)) {
        throw UsageError(printable(outputs[k]) + ": is an input as well as an output");
      }
    }
    for (std::size_t j = 0; j < k; ++j) {
      if (!outputs[j].empty() && same_file(outputs[k], outputs[j])) {
        throw UsageError(printable(outputs[k]) + ": is named for two outputs");
      }
    }
  }
}

void require_picture(const std::string& option, const std::string& path) {
  if (path.ends_with(".svg") || path.ends_with(".png")) return;
  throw UsageError(option + ": " + printable(path) + ": must end in .svg or .png");
}

}  // namespace voroproof::internal
