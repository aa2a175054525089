#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <array>

namespace voroproof::internal::fuzz {
namespace {

constexpr std::size_t most_changes = 5;

// Numbers, right and wrong, at which readers and arithmetic turn.
constexpr std::array<std::string_view, 40> numbers{"0",
                                                   "-0",
                                                   "1",
                                                   "-1",
                                                   "2",
                                                   "0.5",
                                                   "1e-6",
                                                   "1e-9",
                                                   "1e-100",
                                                   "1e100",
                                                   "1e-101",
                                                   "1e101",
                                                   "1e308",
                                                   "1e-308",
                                                   "5e-324",
                                                   "1.7976931348623157e308",
                                                   "1e999",
                                                   "1e-999",
                                                   "1e99999999999",
                                                   "9007199254740993",
                                                   "2147483647",
                                                   "2147483648",
                                                   "-2147483649",
                                                   "4294967296",
                                                   "9223372036854775807",
                                                   "9223372036854775808",
                                                   "18446744073709551616",
                                                   "1999999",
                                                   "2000001",
                                                   "\"1/3\"",
                                                   "\"-1/3\"",
                                                   "\"1/0\"",
                                                   "\"0x1p-1074\"",
                                                   "\"0x1.8p1\"",
                                                   "\"1e-4000\"",
                                                   "NaN",
                                                   "Infinity",
                                                   "01",
                                                   "1.",
                                                   "0000000000000000"};

constexpr std::string_view telling =
    "\"{}[],:\\ \n\t\r#-+.eExXpP/0123456789untrfals<>&;=\x7f\xc2\xff";

struct Piece {
  std::size_t begin = 0, size = 0;
};

bool in_number(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}
bool in_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// The first run of such characters from a random place on; empty where there is none.
template <class Belongs>
Piece piece_of(std::string_view text, Chance& chance, Belongs&& belongs) {
  std::size_t begin = chance.below(text.size());
  while (begin > 0 && belongs(text[begin - 1])) --begin;
  while (begin < text.size() && !belongs(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && belongs(text[end])) ++end;
  return {begin, end - begin};
}

Piece number_in(std::string_view text, Chance& chance) { return piece_of(text, chance, in_number); }
Piece word_in(std::string_view text, Chance& chance) { return piece_of(text, chance, in_word); }
// With its end.
Piece line_in(std::string_view text, Chance& chance) {
  Piece line = piece_of(text, chance, [](char c) { return c != '\n'; });
  if (line.begin + line.size < text.size()) ++line.size;
  return line;
}
Piece range_in(std::string_view text, Chance& chance) {
  constexpr std::array<std::size_t, 4> longest{1, 4, 32, 512};
  const std::size_t begin = chance.below(text.size() + 1);
  const std::size_t size = 1 + chance.below(longest[chance.below(longest.size())]);
  return {begin, std::min(size, text.size() - begin)};
}

std::string_view view(std::string_view text, Piece piece) {
  return text.substr(piece.begin, piece.size);
}

void change_number(std::string& text, Chance& chance) {
  const Piece at = number_in(text, chance);
  if (at.size == 0) return;
  switch (chance.below(3)) {
    case 0:
      text.replace(at.begin, at.size, numbers[chance.below(numbers.size())]);
      break;
    case 1:
      text[at.begin + chance.below(at.size)] = static_cast<char>('0' + chance.below(10));
      break;
    default: {
      const Piece from = number_in(text, chance);
      text.replace(at.begin, at.size, std::string(view(text, from)));
    }
  }
}

void change_line(std::string& text, Chance& chance) {
  const Piece line = line_in(text, chance);
  const std::string copy(view(text, line));
  const std::size_t kind = chance.below(3);
  if (kind != 1) text.erase(line.begin, line.size);
  if (kind != 0) text.insert(line_in(text, chance).begin, copy);
}

void change_bytes(std::string& text, Chance& chance) {
  const Piece range = range_in(text, chance);
  const std::string copy(view(text, range));
  switch (chance.below(5)) {
    case 0:
      text.erase(range.begin, range.size);
      break;
    case 1:
      text.insert(chance.below(text.size() + 1), copy);
      break;
    case 2:
      if (range.size > 0) text[range.begin] = telling[chance.below(telling.size())];
      break;
    case 3:
      if (range.size > 0) text[range.begin] = static_cast<char>(chance.below(256));
      break;
    default:
      for (std::size_t k = 0; k < 16; ++k) text.insert(range.begin, copy.substr(0, 16));
  }
}

void take_from(std::string& text, std::string_view other, Chance& chance) {
  if (other.empty()) return;
  if (chance.below(2) == 0) {
    const Piece at = word_in(text, chance);
    text.replace(at.begin, at.size, view(other, word_in(other, chance)));
  } else {
    const Piece at = range_in(text, chance);
    text.replace(at.begin, at.size, view(other, range_in(other, chance)));
  }
}

}  // namespace

std::string mutated(std::string text, std::string_view other, Chance& chance) {
  for (std::size_t left = 1 + chance.below(most_changes); left > 0; --left) {
    switch (chance.below(8)) {
      case 0:
      case 1:
      case 2:
        change_number(text, chance);
        break;
      case 3:
        change_line(text, chance);
        break;
      case 4:
      case 5:
        change_bytes(text, chance);
        break;
      case 6:
        take_from(text, other, chance);
        break;
      default:
        if (chance.below(8) == 0) text.resize(chance.below(text.size() + 1));
    }
  }
  if (text.size() > longest_input) text.resize(longest_input);
  return text;
}

}  // namespace voroproof::internal::fuzz
