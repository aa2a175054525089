// Names that are not those of files on a disk: open descriptors, pipes, devices.
#pragma once

#include <optional>
#include <string>

namespace voroproof::internal {

// The descriptor that the path names: of /dev/stdin, /dev/stdout, /dev/stderr, and of numbers in
// /dev/fd and /proc/self/fd.
std::optional<int> named_descriptor(const std::string& path);

// Whether the path names something that bytes flow through: a descriptor, or what exists and is
// neither a regular file nor a folder.
bool is_stream(const std::string& path);

// Whether what is written to the path goes where standard output goes: it names that, or the pipe
// or the file to which standard output was redirected.
bool is_standard_output(const std::string& path);

// Whether reading the one and the other reads the same stream.
bool is_same_stream(const std::string& a, const std::string& b);

}  // namespace voroproof::internal
