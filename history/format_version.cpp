#include "history/format_version.h"

#include <limits>

namespace voroproof::internal {
namespace {

constexpr std::int64_t any_version = std::numeric_limits<std::int64_t>::max();

}  // namespace

std::string newer_version(std::int64_t version, std::int64_t known) {
  return "the file is of version " + std::to_string(version) + "; this program reads version " +
         std::to_string(known);
}

void read_version(JsonReader& json, std::int64_t wanted) {
  const std::int64_t version = json.integer(-any_version, any_version);
  if (version > wanted) json.fail(newer_version(version, wanted));
  if (version < wanted) json.fail("not " + std::to_string(wanted));
}

void refuse_newer(std::string_view text, const std::string& file, std::string_view format,
                  std::int64_t known) {
  bool right = false;
  std::int64_t version = 0, line = 0;
  try {
    JsonReader json(text, file);
    json.any_object([&](std::string_view name) {
      if (name == "format") {
        right = json.text() == format;
      } else if (name == "version") {
        version = json.integer(0, any_version);
        line = json.line();
      } else {
        json.any();
      }
      return !right || version == 0;
    });
  } catch (const InputError&) {
    return;  // no such object: the caller's complaint says what is wrong
  }
  if (right && version > known)
    throw InputError(file, line, "version", newer_version(version, known));
}

}  // namespace voroproof::internal
