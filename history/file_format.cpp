#include "history/file_format.h"

#include <optional>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/scene.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t beginning = 4096;  // bytes, in which the two fields are as a rule

// The members "format" and "version" of the object that the text starts with. What comes after them
// may be anything; so may what comes after "format", which is found even if the other is not.
std::optional<FileFormat> format_of(std::string_view text, const std::string& path) {
  std::optional<FileFormat> format;
  std::string version;
  try {
    JsonReader json(text, path);
    json.any_object([&](std::string_view name) {
      if (name == "format") {
        format = {std::string(json.text()), json.line()};
      } else if (name == "version") {
        version = json.any();
      } else {
        json.any();
      }
      return !format || version.empty();
    });
  } catch (const InputError&) {
    if (!format) throw;
  }
  if (format) format->version = version;
  return format;
}

}  // namespace

bool is_of_worlds(const FileFormat& format) {
  return format.version == std::to_string(world_version);
}

FileFormat format_of_text(std::string_view text, const std::string& path) {
  if (const auto format = format_of(text, path)) return *format;
  throw InputError(path, 1, "format", "missing");
}

// As a rule the fields come first. Only if they do not, more than the beginning is looked at.
FileFormat format_of_file(const std::string& path) {
  const std::string bytes = file_bytes(path, beginning, true);
  if (bytes.size() < beginning) return format_of_text(bytes, path);
  try {
    if (const auto format = format_of(bytes, path); format && !format->version.empty())
      return *format;
  } catch (const InputError&) {
    // The fault may be the cut.
  }
  return format_of_text(file_bytes(path, max_scene_bytes, true), path);
}

FileFormat format_at_beginning(const std::string& path) {
  try {
    return format_of(file_bytes(path, beginning, true), path).value_or(FileFormat{});
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace voroproof::internal
