// The version of a file's format (docs/formats.md, section 13).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "history/error.h"
#include "history/json_reader.h"

namespace voroproof::internal {

// The version that this program reads and writes, of every format; of scenes and histories there is
// a second one, that of worlds.
inline constexpr std::int64_t format_version = 1;
inline constexpr std::int64_t world_version = 2;

// "the file is of version 2; this program reads version 1"
std::string newer_version(std::int64_t version, std::int64_t known = format_version);

// Reads the value of "version". Throws InputError for any but the wanted one.
void read_version(JsonReader& json, std::int64_t wanted = format_version);

// Throws the InputError that says so where the text begins with a JSON object of this format and of
// a newer version than the known one; what else is wrong with it does not matter then.
void refuse_newer(std::string_view text, const std::string& file, std::string_view format,
                  std::int64_t known = format_version);

// Calls read(), which reads that text, of the version `known`. A newer version may have fields that
// this program does not know, before the one that tells the version, too: the version is what is
// reported.
template <class Read>
auto of_this_version(std::string_view text, const std::string& file, std::string_view format,
                     Read&& read, std::int64_t known = format_version) {
  try {
    return read();
  } catch (const InputError&) {
    refuse_newer(text, file, format, known);
    throw;
  }
}

}  // namespace voroproof::internal
