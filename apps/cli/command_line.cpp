#include "apps/cli/command_line.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "history/compressor.h"
#include "history/descriptor.h"
#include "history/error.h"
#include "history/scene.h"
#include "history/validate.h"

namespace voroproof::internal {
namespace {

bool same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  if (is_stream(a) || is_stream(b)) return a != "/dev/null" && is_same_stream(a, b);
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  // Files that do not exist yet are compared by name.
  const fs::path first = fs::weakly_canonical(fs::absolute(a, error), error);
  if (error) return a == b;
  const fs::path second = fs::weakly_canonical(fs::absolute(b, error), error);
  return error ? a == b : first == second;
}

}  // namespace

std::string producer() { return "voroproof " VOROPROOF_VERSION; }

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
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      if (!is_same_stream(inputs[j], inputs[k])) continue;
      throw UsageError(printable(inputs[k]) + ": is named for two inputs, and can be read as one");
    }
  }
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

void require_order(const std::string& scene, const std::string& history) {
  if (history.empty() || !is_history_file(scene) || !is_scene_file(history)) return;
  throw UsageError(printable(scene) + " is a history and " + printable(history) +
                   " is a scene: the scene comes first");
}

void require_picture(const std::string& option, const std::string& path) {
  const std::string_view name = without_compression(path);
  if (is_stream(path)) return;
  for (const char* end : {".svg", ".png", ".pdf"}) {
    if (name.ends_with(end)) return;
  }
  throw UsageError(option + ": " + printable(path) + ": must end in .svg, .png or .pdf");
}

std::ostream& words_beside(const std::vector<std::string>& outputs) {
  for (const std::string& output : outputs) {
    if (!output.empty() && is_standard_output(output)) return std::cerr;
  }
  return std::cout;
}

bool filters_wanted() {
  const char* filters = std::getenv("VOROPROOF_FILTERS");
  return filters == nullptr || std::string_view(filters) != "off";
}

}  // namespace voroproof::internal
