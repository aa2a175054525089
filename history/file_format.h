// Which of the project's formats a JSON file names.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace voroproof::internal {

// The format that a JSON file names in its field "format", on which line, and the text of the field
// "version", empty where the file is damaged before it.
struct FileFormat {
  std::string name;
  std::int64_t line = 0;
  std::string version{};
};

// Whether a scene or history of that format is one of a world (docs/formats.md, section 20).
bool is_of_worlds(const FileFormat& format);

// Nothing else of the file, or of its text, is checked. Throws InputError, also where there is no
// such field.
FileFormat format_of_file(const std::string& path);
FileFormat format_of_text(std::string_view text, const std::string& path);

// The same of what the first bytes say, as a rule both fields. The name is empty where they name
// none, or the file cannot be read.
FileFormat format_at_beginning(const std::string& path);

}  // namespace voroproof::internal
