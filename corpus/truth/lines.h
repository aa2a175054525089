// The lines of the truth set (README.md): line k of a file is a function of k.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voroproof::truth {

// A file of the set.
struct File {
  std::string name;
  std::string (*line)(std::uint64_t k);  // without its end
};

inline constexpr std::string_view version = "1.0.0";

const std::vector<File>& files();
// The first line.
std::string heading(const File& file);

std::string incircle_line(std::uint64_t k);
std::string exists_line(std::uint64_t k);
std::string contact_line(std::uint64_t k);
std::string collapse_line(std::uint64_t k);
std::string rootorder_line(std::uint64_t k);
std::string static_line(std::uint64_t k);

}  // namespace voroproof::truth
