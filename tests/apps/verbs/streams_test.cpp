// Standard input and output, pipes and devices in place of files, and compressed files.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <string>

#include "history/error.h"
#include "history/file_bytes.h"
#include "tests/apps/verbs/cli.h"
#include "tests/apps/verbs/small_scenes.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t enough = std::size_t{1} << 24;

class Streams : public Cli {
 protected:
  void SetUp() override {
    scene_ = reference(12, "40");
    history_ = file("a.history.jsonl");
    must({"simulate", scene_, "-o", history_, "--quiet"});
  }

  // Runs a command line of bash in the folder of the files; P is the program.
  Result shell(const std::string& command) const {
    const std::string out = streams_.file("out"), err = streams_.file("err");
    const std::string text =
        "cd '" + file("") + "' && P='" + VOROPROOF_PROGRAM + "' && { " + command + "\n}";
    const pid_t child = fork();
    if (child == 0) {
      constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
      dup2(open(out.c_str(), flags, 0600), STDOUT_FILENO);
      dup2(open(err.c_str(), flags, 0600), STDERR_FILENO);
      execl("/bin/bash", "bash", "-c", text.c_str(), nullptr);
      _exit(127);
    }
    return finish(child);
  }

  Result must_shell(const std::string& command) const {
    Result result = shell(command);
    EXPECT_EQ(result.code, 0) << command << '\n' << result.err;
    return result;
  }

  std::string scene_, history_;
};

TEST_F(Streams, OfSimulateAndCertifyMeetInAPipe) {
  const Result piped =
      must_shell("$P simulate - -o - < reference.scene.json | $P certify reference.scene.json -");
  EXPECT_EQ(lines_of(piped.out).back(), "s CERTIFIED");
  EXPECT_EQ(piped.err.rfind("flips ", 0), 0u) << piped.err;
  const Result both = must_shell(
      "$P simulate - -o - --quiet < reference.scene.json"
      " | $P certify reference.scene.json - --kernel --truth recorded");
  EXPECT_EQ(both.err, "");
  EXPECT_NE(both.out.find("c kernel: CERTIFIED"), std::string::npos) << both.out;
  EXPECT_EQ(must_shell("cat reference.scene.json | $P simulate - -o - --quiet").out,
            read_bytes(history_));
}

TEST_F(Streams, SeveralReadersOfAPipeSeeTheSameBytes) {
  const Result certified = must_shell(
      "$P certify <(cat reference.scene.json) <(cat a.history.jsonl) --kernel --truth recorded "
      "--quiet");
  EXPECT_EQ(lines_of(certified.out).back(), "s CERTIFIED");
  must_shell("mkfifo pipe && (cat a.history.jsonl > pipe &) && $P validate pipe");
  must_shell("$P movie reference.scene.json - -o a.html < a.history.jsonl");
  const std::string table = must_shell(
                                "$P query closest-over reference.scene.json"
                                " a.history.jsonl")
                                .out;
  EXPECT_EQ(must_shell("cat a.history.jsonl | $P query closest-over reference.scene.json -").out,
            table);
  EXPECT_EQ(must_shell("$P convert a.history.jsonl --scene reference.scene.json -o a.evtsq;"
                       "cat a.history.jsonl | $P convert - --scene reference.scene.json -o -"
                       " --format evtsq | tail -n +3 | cmp - <(tail -n +3 a.evtsq)")
                .out,
            "");
}

TEST_F(Streams, ResultsOnStandardOutputAreAlone) {
  const std::string diagram = must_shell("$P snapshot reference.scene.json --at 3 -o -").out;
  EXPECT_EQ(Json::parse(diagram)["format"], "voroproof-diagram");
  directory_.write("d.json", diagram);
  EXPECT_EQ(must_shell("$P render d.json -o -").out, [&] {
    must_shell("$P render d.json -o d.svg");
    return directory_.read("d.svg");
  }());
  const Result certified = must_shell("$P certify reference.scene.json a.history.jsonl --report -");
  EXPECT_EQ(Json::parse(certified.out)["verdict"], "CERTIFIED");
  EXPECT_EQ(lines_of(certified.err).back(), "s CERTIFIED");
  const Result answer = must_shell("$P query closest reference.scene.json --at 3 -o -");
  EXPECT_EQ(Json::parse(answer.out)["query"], "closest");
  EXPECT_NE(answer.err, "");
  const Result generated = must_shell("$P generate grid --n 4 -o - | $P validate -");
  EXPECT_EQ(generated.out.rfind("/dev/stdin: scene: 4 disks", 0), 0u) << generated.out;
}

TEST_F(Streams, DevicesAndWhatStandardOutputIsRedirectedToAreWrittenTo) {
  must_shell("$P simulate reference.scene.json -o /dev/null --stats /dev/null && [ -c /dev/null ]");
  const std::string history = read_bytes(history_);
  const Result both = must_shell(
      "{ echo before; $P simulate reference.scene.json -o /dev/stdout; echo after; } > b;"
      "cat b");
  EXPECT_EQ(both.out, "before\n" + history + "after\n");
  EXPECT_EQ(both.err.rfind("flips ", 0), 0u) << both.err;
  must_shell(
      "exec 5> c; $P simulate reference.scene.json -o c --quiet >&5; cmp c a.history.jsonl;"
      "[ c -ef /dev/fd/5 ]");
  must_shell(
      "mkfifo pipe; (cat pipe > d &); $P simulate reference.scene.json -o pipe --quiet;"
      "[ -p pipe ] && while ! cmp -s d a.history.jsonl; do sleep 0.1; done");
}

TEST_F(Streams, StandardInputIsOneInputAndStandardOutputOneOutput) {
  refused({"certify", "-", "-"}, "/dev/stdin: is named for two inputs");
  refused({"certify", "-", "/dev/stdin"}, "/dev/stdin: is named for two inputs");
  refused({"simulate", scene_, "-o", "-", "--stats", "-"}, "/dev/stdout: is named for two outputs");
  refused({"convert", scene_, "-o", "-"}, "no --format");
  // A file of this name is to be had all the same.
  must_shell("$P generate grid --n 3 -o ./- && $P validate ./-");
}

TEST_F(Streams, CompressedFilesAreWrittenByNameAndReadByContent) {
  for (const std::string ending : {".gz", ".zst"}) {
    const std::string scene = file("b.scene.json" + ending),
                      packed = file("b.history.jsonl" + ending);
    must({"generate", "reference", "--n", "12", "--seed", "3", "--horizon", "40", "--density",
          "0.2", "-o", scene});
    must({"simulate", scene, "-o", packed, "--quiet"});
    EXPECT_LT(read_bytes(packed).size(), read_bytes(history_).size() / 2);
    // The history of a scene does not depend on how the scene is stored.
    EXPECT_EQ(file_bytes(packed, enough), read_bytes(history_));
    must({"certify", scene_, packed, "--kernel", "--truth", "recorded", "--quiet"});
    const std::string other = directory_.write("x", read_bytes(packed));
    must({"validate", other});
    must_shell("$P certify - b.history.jsonl" + ending + " --quiet < b.scene.json" + ending);
    must({"snapshot", scene, "--at", "1", "-o", file("d.json" + ending)});
    must({"render", file("d.json" + ending), "-o", file("d.svg" + ending)});
    EXPECT_NE(file_bytes(file("d.svg" + ending), enough).find("<svg"), std::string::npos);
    // Several members are one text.
    directory_.write("twice" + ending, read_bytes(scene) + read_bytes(scene));
    EXPECT_EQ(file_bytes(file("twice" + ending), enough),
              file_bytes(scene, enough) + file_bytes(scene, enough));
  }
  EXPECT_EQ(must_shell("gzip -dc b.history.jsonl.gz").out, read_bytes(history_));
}

TEST_F(Streams, CutAndDamagedCompressionIsAnErrorOfTheFile) {
  for (const std::string ending : {".gz", ".zst"}) {
    const std::string packed = file("b.history.jsonl" + ending);
    must({"simulate", scene_, "-o", packed, "--quiet"});
    const std::string whole = read_bytes(packed);
    const auto refuse = [&](const std::string& bytes, const std::string& message) {
      const std::string bad = directory_.write("bad", bytes);
      const Result result = run({"certify", scene_, bad});
      EXPECT_EQ(result.code, 2) << ending;
      EXPECT_EQ(result.out, "s INVALID\n") << ending;
      EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    };
    for (const std::size_t cut : {std::size_t{4}, whole.size() / 2, whole.size() - 1}) {
      refuse(whole.substr(0, cut), "bad: ends within its");
    }
    std::string damaged = whole;
    damaged[whole.size() - 2] = static_cast<char>(damaged[whole.size() - 2] ^ 1);  // the checksum
    refuse(damaged, "bad: damaged");
    refuse(whole + "x", ending == ".gz" ? "bad: " : "bad: damaged");
  }
}

TEST_F(Streams, AShortFileThatExpandsToALongLineIsRefused) {
  const std::string header = lines_of(read_bytes(history_)).front();
  const std::string bomb = file("b.jsonl.gz");
  must_shell("{ head -n 1 a.history.jsonl; head -c 50000000 /dev/zero; } | gzip > b.jsonl.gz");
  EXPECT_LT(read_bytes(bomb).size(), 200'000u);
  const Result result = run({"certify", scene_, bomb, "--max-memory", "64"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("a line of more than 1048576 bytes"), std::string::npos) << result.err;
}

TEST_F(Streams, AStoppedHistoryDoesNotReplaceACompleteCompressedOne) {
  const std::string packed = file("b.history.jsonl.gz");
  must({"simulate", scene_, "-o", packed, "--quiet"});
  EXPECT_EQ(run({"simulate", scene_, "-o", packed, "--max-events", "3"}).code, 3);
  EXPECT_EQ(file_bytes(packed, enough), read_bytes(history_));
  must({"validate", packed + ".partial"});
}

TEST_F(Streams, AReaderThatGoesLeavesNoFile) {
  const std::size_t files = directory_.number_of_files();
  must_shell(
      "$P simulate reference.scene.json -o - --stats s --horizon 4000 2>&1"
      " | head -c 10 > /dev/null");
  EXPECT_EQ(directory_.number_of_files(), files);
}

TEST_F(Streams, ASignalEndsARunWhoseReaderDoesNotRead) {
  const std::string pipe = file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  for (const std::string horizon : {"1000", "100000"}) {
    const pid_t child = start({"simulate", scene_, "-o", pipe, "--horizon", horizon, "--quiet"});
    // Once something has come the run waits for room, at its end or within it.
    char byte = 0;
    while (read(reader, &byte, 1) != 1) usleep(1000);
    usleep(200'000);
    kill(child, SIGTERM);
    const Result result = finish(child);
    EXPECT_EQ(result.code, 6) << horizon << result.err;
    std::string rest(1 << 20, '\0');
    while (read(reader, rest.data(), rest.size()) > 0) {
    }
  }
  close(reader);
}

TEST_F(Streams, ExchangedArgumentsAreCalledSo) {
  const std::string message = "a.history.jsonl is a history and " + scene_ + " is a scene";
  for (const Arguments& verb : {Arguments{"certify"}, Arguments{"query", "closest-over"}}) {
    Arguments exchanged = verb;
    exchanged.insert(exchanged.end(), {history_, scene_});
    refused(exchanged, message);
  }
  refused({"snapshot", history_, scene_, "--at", "1", "-o", file("d")}, message);
  refused({"movie", history_, scene_, "-o", file("m")}, message);
}

TEST_F(Streams, ExplainDrawsOnlyWhereItIsAsked) {
  std::string text = read_bytes(history_);
  const std::size_t flip = text.find("\n", text.find("\"flip\""));
  const std::size_t begin = text.rfind('\n', flip - 1);
  directory_.write("bad.jsonl", text.erase(begin, flip - begin));
  EXPECT_EQ(run({"certify", scene_, file("bad.jsonl"), "--report", file("r.json")}).code, 1);
  const std::size_t files = directory_.number_of_files();
  EXPECT_NE(must({"explain", file("r.json")}).out.find("REFUTED"), std::string::npos);
  EXPECT_EQ(directory_.number_of_files(), files);
  must({"explain", file("r.json"), "-o", file("r.svg")});
  EXPECT_EQ(directory_.number_of_files(), files + 1);
}

}  // namespace
}  // namespace voroproof::internal
