// What is read at a glance is what the strict reader reads; the rest is left to it.
#include "history/plain_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "history/error.h"
#include "history/history_file.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

constexpr int last_id = 12;

// The line alone.
std::optional<Event> plain_event(std::string_view line) {
  PlainLineReader reader;
  return reader.event(line, line, 0, last_id);
}

const std::vector<std::string> plain_lines = {
    R"({"t":1.25,"flip":[2,9,3,7]})",
    R"({"t":0,"flip":[-1,10,11,11]})",
    R"({"t":2.5e-7,"collide":[3,7],"v":[[0.5,-1],[2e300,0.25]],"p":[[1,2],[3,4]]})",
    R"({"t":12.5E+2,"collide":[-1,4],"v":[null,[1,0]],"p":[null,[5,6]]})",
    R"({"t":3,"collide":[-1,12]})",
    R"({"t":3.5,"collide":[0,1],"p":[[-0.125,6],[1,2]]})",
    R"({"t":4,"maneuver":0,"v":[1,0],"p":[7,8]})",
    R"({"t":4,"maneuver":5})",
};

// Two events have the same values.
std::string told(const Event& event) {
  std::string out;
  const auto add = [&out](double x) {
    char digits[40];
    std::snprintf(digits, sizeof digits, " %a", x);
    out += digits;
  };
  const auto add_vector = [&](const std::optional<Vec2>& v) {
    if (!v) {
      out += " none";
      return;
    }
    for (const double x : *v) add(x);
  };
  add(time(event));
  if (const auto* f = std::get_if<FlipEvent>(&event)) {
    for (const GenId g : {f->quad.l, f->quad.r, f->quad.s, f->quad.e}) add(g);
    out += f->exact ? " exact" : "";
  } else if (const auto* c = std::get_if<CollideEvent>(&event)) {
    add(c->i);
    add(c->j);
    for (const auto& v : {c->v[0], c->v[1], c->p[0], c->p[1]}) add_vector(v);
    out += c->exact ? " exact" : "";
  } else {
    const auto& m = std::get<ManeuverEvent>(event);
    add(m.disk);
    add_vector(m.v);
    add_vector(m.p);
    out += m.exact ? " exact" : "";
  }
  return std::to_string(event.index()) + out;
}

std::string told(const std::optional<Event>& event) { return event ? told(*event) : "nothing"; }

// The line as the strict reader takes it: an extension keeps it from being plain.
std::string strictly(const TemporaryDirectory& directory, std::string line) {
  const std::size_t object = line.find('{');
  if (object != std::string::npos) line.insert(object + 1, R"("x-strict":0,)");
  EXPECT_FALSE(plain_event(line)) << line;
  const std::string header = R"({"format":"voroproof-history","version":1,"scene_sha256":")" +
                             std::string(64, 'a') + R"(","horizon":1e300,"producer":""})";
  try {
    HistoryReader reader(directory.write("h", header + "\n" + line + "\n"), last_id + 1);
    const auto event = reader.next();
    return event ? told(*event) : "no event";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PlainLine, WhatTheWriterWritesIsPlain) {
  TemporaryDirectory directory;
  for (const std::string& line : plain_lines) {
    const auto event = plain_event(line);
    ASSERT_TRUE(event) << line;
    EXPECT_EQ(told(*event), strictly(directory, line)) << line;
  }
}

TEST(PlainLine, WhatIsAlmostPlainIsReadAlike) {
  TemporaryDirectory directory;
  std::mt19937_64 random(4);
  const std::string alphabet = "00123456789.-+eE,[]{}\":nulltflipcove ";
  int plain = 0, refused = 0;
  for (int k = 0; k < 20000; ++k) {
    std::string line = plain_lines[random() % plain_lines.size()];
    for (std::uint64_t edits = 1 + random() % 2; edits > 0; --edits) {
      const std::size_t at = random() % line.size();
      switch (random() % 3) {
        case 0:
          line[at] = alphabet[random() % alphabet.size()];
          break;
        case 1:
          line.insert(at, 1, alphabet[random() % alphabet.size()]);
          break;
        case 2:
          if (line.size() > 1) line.erase(at, 1);
          break;
      }
    }
    const auto event = plain_event(line);
    if (!event) {
      ++refused;
      continue;
    }
    ++plain;
    ASSERT_EQ(told(*event), strictly(directory, line)) << line;
  }
  EXPECT_GT(plain, 500);
  EXPECT_GT(refused, 1000);
}

// Lines are split many at once, and what one of them is does not depend on the others.
TEST(PlainLine, ALineIsWhatItIsAlone) {
  std::mt19937_64 random(6);
  const std::string alphabet = "0-.,[]{}\":\\x \n\n\r";
  int plain = 0, refused = 0;
  for (int file = 0; file < 400; ++file) {
    std::string text;
    const std::uint64_t lines = 1 + random() % 600, edits = random() % 4 == 0 ? 0 : random() % 20;
    for (std::uint64_t k = 0; k < lines; ++k) {
      text += plain_lines[random() % plain_lines.size()] + "\n";
    }
    for (std::uint64_t k = 0; k < edits; ++k) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) {
        text[at] = alphabet[random() % alphabet.size()];
      } else {
        text.insert(at, 1, alphabet[random() % alphabet.size()]);
      }
    }
    PlainLineReader reader;
    // What is at hand of the text ends somewhere, in the middle of a line or not.
    std::size_t at_hand = 0;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string_view line(text.data() + begin, end - begin);
      if (at_hand < end) at_hand = std::min(text.size(), end + random() % 60000);
      const std::string_view ahead(text.data() + begin, at_hand - begin);
      // Lines may be skipped.
      if (random() % 50 != 0) {
        const auto event = reader.event(line, ahead, static_cast<std::int64_t>(begin), last_id);
        ASSERT_EQ(told(event), told(plain_event(line))) << line;
        ++(event ? plain : refused);
      }
      begin = end + 1;
    }
  }
  EXPECT_GT(plain, 50000);
  EXPECT_GT(refused, 1000);
}

// simdjson 3.0 takes 0. and more than 19 digits for another number.
TEST(PlainLine, NumbersOfManyDigitsAreReadAlike) {
  TemporaryDirectory directory;
  std::mt19937_64 random(5);
  int plain = 0;
  for (int k = 0; k < 1500; ++k) {
    std::string number = random() % 2 == 0 ? "0" : std::to_string(1 + random() % 999);
    number += "." + std::string(random() % 8, '0');
    for (std::uint64_t digits = 1 + random() % 30; digits > 0; --digits) {
      number += static_cast<char>('0' + random() % 10);
    }
    if (random() % 4 == 0) number += "e" + std::to_string(static_cast<int>(random() % 40) - 20);
    const std::string line = R"({"t":)" + number + R"(,"flip":[2,9,3,7]})";
    const auto event = plain_event(line);
    if (!event) continue;
    ++plain;
    ASSERT_EQ(told(*event), strictly(directory, line)) << line;
  }
  EXPECT_GT(plain, 500);
}

TEST(PlainLine, NumbersThatTheStrictReaderJudges) {
  for (const char* number : {"-0", "0.0", "1e-400", "1e400", "01", "1.", ".5", "1.e5", "1e", "+1",
                             "inf", "nan", "0x1p3", "\"1/3\"", "-1", "1e5000", ""}) {
    const std::string line = R"({"t":)" + std::string(number) + R"(,"flip":[2,9,3,7]})";
    EXPECT_FALSE(plain_event(line)) << line;
  }
  for (const char* id : {"13", "-2", "-0", "007", "1.0", "1e0", "", "99999999999"}) {
    const std::string line = R"({"t":1,"collide":[-1,)" + std::string(id) + "]}";
    EXPECT_FALSE(plain_event(line)) << line;
  }
}

}  // namespace
}  // namespace voroproof::internal
