// Event sequences of the paper's authors: both ways to write numbers, both versions, every kind of
// line.
#include "history/evtsq_reader.h"
#include "history/evtsq_writer.h"

#include <gtest/gtest.h>

#include "history/error.h"
#include "history/output_file.h"
#include "history/sha256.h"
#include "history/validate.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

std::string sequence(const std::string& count, const std::string& lines,
                     const std::string& version = "1.10") {
  return "#SOURCE:\tsome disks.txt\n#DVD_GENERATOR:\tENGINE_1.0\n"
         "#EVENT_SEQUENCE_FILE_FORMAT_VERSION:\t" +
         version +
         "\n#TIME:\tFri Nov 20 18:42:00 2026\n#SIMULATION_TIME:\t10.00\n"
         "#RESTITUTION_COEFFICIENT:\t0.80\n" +
         count + "\n" + lines;
}

// 0.5, 1, 2 and -3 in hexadecimal.
const std::string kHalf = "000000000000e03f", kOne = "000000000000f03f", kTwo = "0000000000000040",
                  kMinusThree = "00000000000008c0";

class EvtsqTest : public ::testing::Test {
 protected:
  std::unique_ptr<HistorySource> open(const std::string& text) {
    directory_.write("a.evtsq", text);
    return open_evtsq(directory_.file("a.evtsq"), ids_, horizon_).history;
  }

  std::vector<Event> read(const std::string& text) {
    const auto history = open(text);
    std::vector<Event> events;
    while (auto event = history->next()) events.push_back(std::move(*event));
    EXPECT_TRUE(history->counts_match());
    return events;
  }

  void refused(const std::string& text, const std::string& message) {
    try {
      read(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
    }
  }

  TemporaryDirectory directory_;
  std::vector<std::int64_t> ids_{0, 1, 2, 30};
  std::optional<Rational> horizon_;
};

TEST_F(EvtsqTest, HexadecimalIsTheBytesOfABinary64) {
  EXPECT_EQ(hexadecimal_text(1), kOne);
  EXPECT_EQ(hexadecimal_text(-3), kMinusThree);
  EXPECT_TRUE(is_hexadecimal(kHalf));
  EXPECT_FALSE(is_hexadecimal("000000000000F03F"));
  EXPECT_FALSE(is_hexadecimal("0.12345678901234"));
}

TEST_F(EvtsqTest, EveryKindOfLine) {
  const auto events =
      read(sequence("5", "E\t" + kHalf + "\t0\t1\t2\t30\t\n" +    //
                             "S\t" + kHalf + "\t0\t-1\t2\t1\n" +  //
                             "C\t" + kOne + "\t30\t-1\t" + kOne + "\t" + kTwo + "\t" + kHalf +
                             "\t" + kHalf + "\n" +  //
                             "C\t" + kOne + "\t2\t1\t" + kOne + "\t" + kTwo + "\t" + kHalf + "\t" +
                             kMinusThree + "\n" +  //
                             "V\t" + kTwo + "\t30\t" + kOne + "\t" + kMinusThree + "\n"));
  ASSERT_EQ(events.size(), 4u);
  const auto& flip = std::get<FlipEvent>(events[0]);
  EXPECT_EQ(flip.t, 0.5);
  // Head 2 is the third generator of the end, tail 30 (disk 3) that of the start.
  EXPECT_EQ(flip.quad, canonical(Quad{0, 1, 3, 2}));
  const auto& wall = std::get<CollideEvent>(events[1]);
  EXPECT_EQ(wall.i, container_id);
  EXPECT_EQ(wall.j, 3);
  EXPECT_FALSE(wall.p[0]);
  EXPECT_EQ(*wall.p[1], (Vec2{1, 2}));
  const auto& pair = std::get<CollideEvent>(events[2]);
  EXPECT_EQ(pair.i, 1);
  EXPECT_EQ(*pair.p[0], (Vec2{0.5, -3}));
  EXPECT_EQ(*pair.p[1], (Vec2{1, 2}));
  EXPECT_FALSE(pair.v[1]);
  const auto& turn = std::get<ManeuverEvent>(events[3]);
  EXPECT_EQ(turn.disk, 3);
  EXPECT_EQ(*turn.v, (Vec2{1, -3}));
  const auto maneuvers = read_evtsq_setting(directory_.file("a.evtsq"), ids_).maneuvers;
  ASSERT_EQ(maneuvers.size(), 1u);
  EXPECT_EQ(maneuvers[0].t, 2);
}

// The maneuvers of a scene are from one reading, the events from the next.
TEST_F(EvtsqTest, IsTheOneThatItsManeuversAreFrom) {
  const std::string turn = "V\t" + kHalf + "\t30\t" + kOne + "\t" + kOne + "\n",
                    one = sequence("1", turn), other = sequence("2", turn + turn);
  const std::string path = directory_.write("a.evtsq", one);
  const EvtsqSetting setting = read_evtsq_setting(path, ids_);
  EXPECT_EQ(setting.sha256, sha256_hex(one));
  for (const bool to_its_end : {true, false}) {
    for (const std::string& now : {one, other}) {
      directory_.write("a.evtsq", now);
      const auto history = open_evtsq(path, ids_, horizon_, setting.sha256).history;
      while (to_its_end && history->next()) {
      }
      if (now == one) {
        EXPECT_NO_THROW(history->require_unchanged());
        EXPECT_EQ(history->content_sha256(), sha256_hex(one));
      } else {
        EXPECT_THROW(history->require_unchanged(), InputError);
      }
    }
  }
}

TEST_F(EvtsqTest, DecimalNumbersAndTheFirstVersion) {
  const auto events = read(sequence("2",
                                    "E\t0.500000000000000\t0\t1\t2\t30\n"
                                    "C\t1.000000000000000\t1\t2\n",
                                    "1.0"));
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(time(events[0]), 0.5);
  EXPECT_FALSE(std::get<CollideEvent>(events[1]).p[1]);
}

TEST_F(EvtsqTest, ShadowFlipsAreNoEventsButAreFound) {
  const auto history = open(sequence("1", "S\t" + kHalf + "\t0\t1\t2\t30\n"));
  EXPECT_FALSE(history->next());
  EXPECT_EQ(history->shadow_line(Quad{0, 1, 3, 2}, 0.4, 0.6), 8);
  EXPECT_EQ(history->shadow_line(Quad{1, 0, 2, 3}, 0.4, 0.6), 8);
  EXPECT_EQ(history->shadow_line(Quad{0, 1, 2, 3}, 0.4, 0.6), 8);  // not oriented
  EXPECT_EQ(history->shadow_line(Quad{0, 2, 3, 1}, 0.4, 0.6), std::nullopt);
  EXPECT_EQ(history->shadow_line(Quad{0, 1, 3, 2}, 0.6, 0.7), std::nullopt);
}

TEST_F(EvtsqTest, TheHorizonIsThatOfTheSceneWhereItRoundsToTheHeaders) {
  const std::string text = sequence("0", "");
  EXPECT_EQ(open(text)->header().horizon, 10);
  EXPECT_EQ(open(text)->header().horizon_error, evtsq_rounding());
  horizon_ = Rational(10001, 1000);
  EXPECT_EQ(open(text)->header().horizon, *horizon_);
  EXPECT_EQ(open(text)->header().horizon_error, 0);
  horizon_ = 20;
  EXPECT_EQ(open(text)->header().horizon, 10);
  EXPECT_EQ(open(text)->header().certain_horizon(), Rational(10) - evtsq_rounding());
}

// Of a horizon that is told as 0.00 only the instant 0 is certain.
TEST_F(EvtsqTest, NoCertainHorizonIsBeforeZero) {
  HistoryHeader header;
  header.horizon_error = evtsq_rounding();
  EXPECT_EQ(header.certain_horizon(), 0);
}

TEST_F(EvtsqTest, FaultsAreNamed) {
  const std::string good = "E\t" + kHalf + "\t0\t1\t2\t30\n";
  refused(sequence("2", good), "incomplete: the file ends after 1 of 2 events");
  refused(sequence("1", "X\t" + kHalf + "\t0\t1\t2\t30\n"), "none of E, S, C and V");
  refused(sequence("1", "T\t" + kHalf + "\t0\t-1\t-2\n"), "hops between containers");
  refused(sequence("1", "E\t" + kHalf + "\t0\t1\t2\n"), "too few or too many");
  refused(sequence("1", "E\t" + kHalf + "\t0\t1\t2\t3\n"), ":8: k: no such disk");
  refused(sequence("1", "E\t" + kHalf + "\t0\t0\t2\t30\n"), "twice");
  refused(sequence("2", good + "E\t0.6\t0\t1\t2\t30\n"), ":9: t: not the 16 hexadecimal digits");
  refused(sequence("1", "E\t000000000000f07f\t0\t1\t2\t30\n"), "not a finite number");
  refused(sequence("2", "E\t" + kOne + "\t0\t1\t2\t30\n" + good), "earlier than the event before");
  refused(sequence("1", "E\t0000000000004940\t0\t1\t2\t30\n"), "beyond the horizon");
  refused(sequence("1", good, "2.0"), "neither 1.0 nor 1.1");
  refused("#SOURCE:\tx\n3\n", "EVENT_SEQUENCE_FILE_FORMAT_VERSION: missing");
  refused(sequence("-1", good), "number of events");
  // More lines than announced is for the certifier to say.
  const auto history = open(sequence("0", good));
  while (history->next()) {
  }
  EXPECT_FALSE(history->counts_match());
}

TEST_F(EvtsqTest, WhatIsWrittenReadsBack) {
  const std::string lines = "E\t" + kHalf + "\t0\t1\t2\t30\n" + "C\t" + kOne + "\t1\t2\t" + kOne +
                            "\t" + kTwo + "\t" + kHalf + "\t" + kMinusThree + "\n" + "V\t" + kTwo +
                            "\t30\t" + kOne + "\t" + kMinusThree + "\t" + kOne + "\t" + kOne + "\n";
  const auto events = read(sequence("3", lines));
  ids_ = {0, 1, 2, 3};  // as they are written
  for (const bool hexadecimal : {true, false}) {
    for (const bool centers : {true, false}) {
      directory_.write("b.evtsq", sequence("3", lines));
      const auto history = open_evtsq(directory_.file("b.evtsq"),
                                      EvtsqIds(std::vector<std::int64_t>{0, 1, 2, 30}), horizon_)
                               .history;
      {
        OutputFile file(directory_.file("c.evtsq"));
        write_evtsq(file, *history, {1, 1, 1}, {"disks", "b.evtsq", Rational(4, 5), {0, 0}},
                    {centers, hexadecimal});
        file.commit();
      }
      const auto again = read(directory_.read("c.evtsq"));
      ASSERT_EQ(again.size(), 3u);
      EXPECT_EQ(std::get<FlipEvent>(again[0]).quad, std::get<FlipEvent>(events[0]).quad);
      EXPECT_EQ(std::get<CollideEvent>(again[1]).p[1].has_value(), centers);
      EXPECT_EQ(std::get<ManeuverEvent>(again[2]).v, std::get<ManeuverEvent>(events[2]).v);
      EXPECT_EQ(open_evtsq(directory_.file("c.evtsq"), ids_, horizon_).header.restitution,
                Rational(4, 5));
    }
  }
}

// Without its disks all of it is read but which ids there are.
TEST_F(EvtsqTest, IsValidatedToItsEnd) {
  const std::string good = "E 0.5 0 1 2 30\nC 1.5 1000 -1\nS 2 0 1 2 30\nV 3 7 1 2\n";
  const auto validated = [&](const std::string& count, const std::string& lines) {
    return validate_file(directory_.write("v.evtsq", sequence(count, lines)));
  };
  EXPECT_EQ(validated("4", good),
            "event sequence: 1 flip, 1 collision, 1 maneuver, complete to t = 10 (its disks are in "
            "another file)");
  EXPECT_EQ(validated("0", ""),
            "event sequence: 0 flips, 0 collisions, 0 maneuvers, complete to t = 10 (its disks are "
            "in another file)");
  for (const auto& [count, lines] : {std::pair<std::string, std::string>{"5", good},
                                     {"3", good},
                                     {"1", "E 0.5 0 1 2\n"},
                                     {"1", "E 0.5 0 1 2 x\n"},
                                     {"1", "E 0.5 0 0 2 3\n"},
                                     {"1", "E 11 0 1 2 3\n"},
                                     {"2", "C 2 0 1\nC 1 0 1\n"}}) {
    EXPECT_THROW(validated(count, lines), InputError) << count << " " << lines;
  }
}

}  // namespace
}  // namespace voroproof::internal
