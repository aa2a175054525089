#include "history/extensions.h"

#include "history/error.h"
#include "history/json_reader.h"
#include "history/json_text.h"

namespace voroproof::internal {

std::string compact_json(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  bool within_string = false, escaped = false;
  for (const char c : json) {
    if (!within_string && (c == ' ' || c == '\t' || c == '\n' || c == '\r')) continue;
    text += c;
    if (!escaped && c == '"') within_string = !within_string;
    escaped = within_string && !escaped && c == '\\';
  }
  return text;
}

std::string members_text(const Extensions& extensions, bool spaced) {
  const std::string comma = spaced ? ", " : ",", colon = spaced ? ": " : ":";
  std::string text;
  for (const auto& [name, value] : extensions) {
    // Values may have been made in memory: whatever they are, they stay inside their field.
    const std::string file = "extensions";
    if (!is_extension(name)) throw InputError(file, 0, name, "no name that begins with x-");
    JsonReader json(value, file);
    const std::string_view whole = json.any();
    json.finish();
    text += comma + string_text(name) + colon + compact_json(whole);
  }
  return text;
}

}  // namespace voroproof::internal
