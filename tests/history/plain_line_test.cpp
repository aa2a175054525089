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
#include "history/history_reader.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

constexpr int last_id = 12;

const std::vector<std::string> plain_lines = {
    R"({"t":1.25,"flip":[2,9,3,7]})",
    R"({"t":0,"flip":[-1,10,11,11]})",
    R"({"t":2.5e-7,"collide":[3,7],"v":[[0.5,-1],[2e300,0.25]],"p":[[1,2],[3,4]]})",
    R"({"t":12.5E+2,"collide":[-1,4],"v":[null,[1,0]],"p":[null,[5,6]]})",
    R"({"t":3,"collide":[-1,12]})",
    R"({"t":3.5,"collide":[0,1],"p":[[-0.125,6],[1,2]]})",
    R"({"t":4,"maneuver":0,"v":[1,0],"p":[7,8]})",
    R"({"t":4,"maneuver":5})",
    R"({"t": 0.5, "flip": [2, 9, 3, 7]})",
    R"({ "t" : 3, "collide" : [ -1, 12 ], "v" : [ null, [ 1, 0 ] ] } )",
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

// The line as the strict reader takes it: an extension keeps it from being plain.
std::string strictly(const TemporaryDirectory& directory, std::string line) {
  const std::size_t object = line.find('{');
  if (object != std::string::npos) line.insert(object + 1, R"("x-strict":0,)");
  EXPECT_FALSE(plain_event(line, last_id)) << line;
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
    const auto event = plain_event(line, last_id);
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
    const auto event = plain_event(line, last_id);
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

// In memory of its own, so that sanitizers see what is read beyond the end.
TEST(PlainLine, ALineCutOffIsNone) {
  for (const std::string& line : plain_lines) {
    for (std::size_t size = 0; size < line.find_last_of('}'); ++size) {
      const std::vector<char> beginning(line.begin(), line.begin() + static_cast<long>(size));
      EXPECT_FALSE(plain_event({beginning.data(), size}, last_id)) << line << ", " << size;
    }
  }
}

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
    const auto event = plain_event(line, last_id);
    if (!event) continue;
    ++plain;
    ASSERT_EQ(told(*event), strictly(directory, line)) << line;
  }
  EXPECT_GT(plain, 500);
}

// Ids are read eight characters at a time.
TEST(PlainLine, IdsOfAnyNumberOfDigits) {
  constexpr int most = 2000000000;
  std::mt19937_64 random(6);
  for (int below = 10; below < most; below = below < most / 10 ? 10 * below : most) {
    for (int k = 0; k < 200; ++k) {
      std::vector<int> ids(4);
      for (int& id : ids) id = static_cast<int>(random() % static_cast<unsigned>(below));
      std::string line = R"({"t":1,"flip":[)";
      for (const int id : ids) line += std::to_string(id) + ",";
      line.back() = ']';
      line += '}';
      const auto event = plain_event(line, most);
      if (*std::max_element(ids.begin(), ids.end()) >= 10000000) {
        EXPECT_FALSE(event) << line;
        continue;
      }
      if (!names_an_edge({ids[0], ids[1], ids[2], ids[3]})) continue;
      ASSERT_TRUE(event) << line;
      const Quad quad = std::get<FlipEvent>(*event).quad;
      EXPECT_EQ(quad, canonical({ids[0], ids[1], ids[2], ids[3]})) << line;
    }
  }
}

TEST(PlainLine, NoOtherCharacterIsADigit) {
  for (int c = 0; c < 256; ++c) {
    const auto character = static_cast<char>(c);
    for (const std::string before : {"", "1", "123456"}) {
      const std::string id = before + character, line = R"({"t":1,"collide":[-1,)" + id + "]}";
      const auto event = plain_event(line, 99999999);
      const bool digit = '0' <= character && character <= '9';
      ASSERT_EQ(event.has_value(), digit || (character == ' ' && !before.empty())) << line;
      if (event) {
        EXPECT_EQ(std::get<CollideEvent>(*event).j, std::stoi(id)) << line;
      }
    }
  }
}

TEST(PlainLine, NumbersThatTheStrictReaderJudges) {
  for (const char* number : {"-0", "0.0", "1e-400", "1e400", "01", "1.", ".5", "1.e5", "1e", "+1",
                             "inf", "nan", "0x1p3", "\"1/3\"", "-1", "1e5000", ""}) {
    const std::string line = R"({"t":)" + std::string(number) + R"(,"flip":[2,9,3,7]})";
    EXPECT_FALSE(plain_event(line, last_id)) << line;
  }
  for (const char* id : {"13", "-2", "-0", "007", "1.0", "1e0", "", "99999999999"}) {
    const std::string line = R"({"t":1,"collide":[-1,)" + std::string(id) + "]}";
    EXPECT_FALSE(plain_event(line, last_id)) << line;
  }
}

}  // namespace
}  // namespace voroproof::internal
