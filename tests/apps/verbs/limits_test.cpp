// What ends a run early, and what is there afterwards: signals, the user's limits, faults of the
// system.
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

void nap() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

class Limits : public Cli {
 protected:
  // Rational numbers that grow by some hundred digits a collision: hours of exact arithmetic.
  std::string endless() const {
    return directory_.write("endless.scene.json", R"({"format":"voroproof-scene","version":1,
"container":{"center":[0,0],"radius":100},"horizon":1e6,"disks":[
{"center":[0,0],"radius":1,"velocity":[1,0],"mass":1e90},
{"center":[5,0],"radius":1,"velocity":[-1,0],"mass":1e-90}]})");
  }

  // Waits until the running process has begun a file besides so many.
  void await_file(pid_t child, std::size_t files) const {
    while (directory_.number_of_files() <= files) {
      ASSERT_EQ(waitpid(child, nullptr, WNOHANG), 0);
      nap();
    }
  }

  // Runs the program in a process that `prepare` has changed.
  Result run_in(const std::function<void()>& prepare, const Arguments& arguments) const {
    const pid_t child = fork();
    if (child == 0) {
      prepare();
      const Result result = run(arguments);
      streams_.write("inner", result.err);
      _exit(result.code);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), "",
            streams_.read("inner")};
  }

  Json last_line(const std::string& name) const {
    return Json::parse(lines_of(directory_.read(name)).back());
  }
};

TEST_F(Limits, EverySignalEndsARunWithinItsArithmetic) {
  const std::string scene = endless(), history = file("a.history.jsonl");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    const pid_t child = start({"simulate", scene, "-o", history, "--quiet"});
    await_file(child, 1);
    kill(child, signal);
    const Result result = finish(child);
    EXPECT_EQ(result.code, 6) << signal;
    // What it takes to go on is kept where the signal comes between two instants.
    std::filesystem::remove(history + ".kept");
    EXPECT_EQ(directory_.number_of_files(), 2u) << signal;
    EXPECT_EQ(last_line("a.history.jsonl")["stopped"]["reason"], "interrupted");
    std::filesystem::remove(history);
  }
}

// The work cannot be asked there.
TEST_F(Limits, ASignalEndsARunThatWaitsForItsInput) {
  const std::string pipe = file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string scene = endless();
  for (const Arguments& arguments :
       {Arguments{"simulate", pipe, "-o", file("out")},
        Arguments{"certify", scene, pipe, "--report", file("out")}, Arguments{"validate", pipe},
        Arguments{"snapshot", pipe, "--at", "1", "-o", file("out")}}) {
    const pid_t child = start(arguments);
    const int writer = open(pipe.c_str(), O_WRONLY);  // waits for the reader
    ASSERT_GE(writer, 0);
    kill(child, SIGTERM);
    const Result result = finish(child);
    close(writer);
    EXPECT_EQ(result.code, 6) << arguments.front();
    EXPECT_EQ(result.err, "voroproof: interrupted\n");
    EXPECT_EQ(directory_.number_of_files(), 2u) << arguments.front();
  }
}

TEST_F(Limits, ASignalEndsTheKernel) {
  const std::string scene = reference(300, "40"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history, "--quiet"});
  const pid_t child =
      start({"certify", scene, history, "--truth", "recorded", "--kernel", "--report", file("r")});
  const std::string process = std::to_string(child);
  const std::string children = "/proc/" + process + "/task/" + process + "/children";
  std::string kernel;
  while (kernel.empty()) {
    ASSERT_EQ(waitpid(child, nullptr, WNOHANG), 0);
    std::ifstream(children) >> kernel;
    nap();
  }
  kill(child, SIGINT);
  const Result result = finish(child);
  EXPECT_EQ(result.code, 6);
  EXPECT_EQ(result.err, "voroproof: interrupted\n");
  EXPECT_EQ(directory_.number_of_files(), 2u);
  EXPECT_EQ(kill(std::stoi(kernel), 0), -1);
}

TEST_F(Limits, OfASimulation) {
  const std::string scene = endless(), history = file("a.history.jsonl");
  const auto stopped = [&](const Arguments& limit) {
    Arguments arguments{"simulate", scene, "-o", history, "--stats", file("s.json"), "--quiet"};
    arguments.insert(arguments.end(), limit.begin(), limit.end());
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 3) << limit.front();
    must({"validate", history});
    const std::string reason = last_line("a.history.jsonl")["stopped"]["reason"];
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    EXPECT_EQ(json("s.json")["reason"], reason);
    return reason;
  };
  EXPECT_EQ(stopped({"--time-limit", "0.5"}), "the time limit of 0.5 s is reached (--time-limit)");
  EXPECT_EQ(stopped({"--max-events", "3"}), "the history has more than 3 events");
  EXPECT_NE(stopped({"--max-bits", "256"}).find(" bits"), std::string::npos);
}

TEST_F(Limits, OfMemory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more memory than the test leaves";
#endif
  const std::string scene = reference(100, "30"), history = file("a.history.jsonl");
  const Environment bits("VOROPROOF_START_BITS", "16000000");
  const Result result = run({"simulate", scene, "-o", history, "--max-bits", "16000000",
                             "--max-memory", "64", "--quiet"});
  EXPECT_EQ(result.code, 3) << result.err;
  EXPECT_EQ(last_line("a.history.jsonl")["stopped"]["reason"],
            "the memory limit of 64 MB is reached (--max-memory)");
  must({"validate", history});
  const Result generated =
      run({"generate", "grid", "--n", "2000000", "-o", file("b"), "--max-memory", "64"});
  EXPECT_EQ(generated.code, 3);
  EXPECT_EQ(generated.err, "voroproof: the memory limit of 64 MB is reached (--max-memory)\n");
}

TEST_F(Limits, OfACertification) {
  const std::string scene = reference(30, "60"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history, "--quiet"});
  for (const std::string truth : {"exact", "recorded"}) {
    const Result cut = run({"certify", scene, history, "--truth", truth, "--max-events", "20",
                            "--report", file("r.json")});
    EXPECT_EQ(cut.code, 3);
    EXPECT_EQ(lines_of(cut.out).back(), "s UNDECIDED");
    const Json report = json("r.json");
    EXPECT_NE(report["reason"].get<std::string>().find(
                  "the limit of 20 events is reached (--max-events)"),
              std::string::npos);
    EXPECT_GT(report["certified_prefix"]["events"], 10);
    EXPECT_LE(report["certified_prefix"]["events"], 20);
  }
  const Result late = run({"certify", endless(), history, "--time-limit", "1e-6"});
  EXPECT_EQ(late.code, 3);
}

// What a certificate says of horizons is known before anything is certified. A limit that is too
// short for opening the files is doubled, until there is a verdict; certifying takes many times as
// long as opening, whatever the machine.
TEST_F(Limits, OfCertifyForAnotherHorizon) {
  const std::string scene = reference(30, "2000"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history, "--quiet"});
  std::string text = read_bytes(history);
  const std::string horizon = "\"horizon\":2000";
  text.replace(text.find(horizon), horizon.size(), "\"horizon\":1999");
  directory_.write("a.history.jsonl", text);
  for (const Arguments& with :
       {Arguments{"--truth", "exact"}, Arguments{"--truth", "recorded", "--report", file("r.json")},
        Arguments{"--truth", "recorded", "--kernel"}}) {
    std::vector<std::string> told;
    for (int limit = 1; told.empty() && limit < 1 << 26; limit *= 2) {
      Arguments arguments{"certify", scene, history, "--time-limit",
                          std::to_string(limit) + "/65536"};
      arguments.insert(arguments.end(), with.begin(), with.end());
      const std::string out = run(arguments).out;
      if (!out.empty()) told = lines_of(out);
    }
    ASSERT_FALSE(told.empty()) << with.back();
    EXPECT_EQ(told.back(), "s UNDECIDED") << with.back();
    EXPECT_NE(std::find(told.begin(), told.end(), "c horizon 1999 of the scene's 2000"), told.end())
        << with.back();
  }
}

TEST_F(Limits, OfAQuery) {
  const std::string scene = endless();
  const Result late = run(
      {"query", "nearest", scene, "--at", "900000", "--point", "1", "2", "--time-limit", "1/2"});
  EXPECT_EQ(late.code, 3);
  EXPECT_EQ(late.err, "voroproof: the time limit is reached\n");
  const Result many =
      run({"snapshot", scene, "--at", "900000", "--max-events", "3", "-o", file("d.json")});
  EXPECT_EQ(many.code, 3);
  EXPECT_NE(many.err.find("more than 3 events"), std::string::npos) << many.err;
  EXPECT_EQ(directory_.number_of_files(), 1u);
  refused({"snapshot", scene, "--at", "1", "-o", file("d"), "--time-limit", "0"}, "--time-limit");
}

TEST_F(Limits, ADiagramFarBeyondItsContainerIsNotDrawn) {
  const std::string scene = reference(5, "10"), path = file("a.diagram.json");
  must({"snapshot", scene, "--at", "1", "-o", path});
  const Json whole = json("a.diagram.json");
  const auto refuse = [&](const Json& changed, const std::string& message) {
    directory_.write("a.diagram.json", changed.dump());
    for (const std::string picture : {"p.svg", "p.png", "p.pdf"})
      refused({"render", path, "-o", file(picture), "--time-limit", "60"}, message);
  };
  Json changed = whole;
  changed["container"]["radius"] = 1e-200;
  refuse(changed, "disk 0 lies far beyond the container");
  changed = whole;
  changed["disks"][2]["radius"] = 1e9;
  refuse(changed, "disk 2 lies far beyond the container");
  changed = whole;
  changed["vertices"][0]["center"] = {1e30, 0};
  refuse(changed, "vertex ");
}

TEST_F(Limits, AReportWithANumberOutOfRangeIsAnErrorOfTheFile) {
  const std::string report =
      directory_.write("r.json", R"({"format":"voroproof-report","version":1,"verdict":1e999})");
  refused({"explain", report}, "r.json: a number out of range");
}

// Escape sequences, C1 controls and marks that turn the direction of writing.
TEST_F(Limits, TextOfStrangersDoesNotControlTheTerminal) {
  const std::string evil = R"(x\u001b]0;x\u0007\u009b31m\u202e\ny)";
  const std::string scene = reference(3, "5"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  must({"certify", scene, history, "--report", file("r.json")});
  Json told = json("r.json");
  for (const char* field : {"history", "reason"}) told[field] = Json::parse('"' + evil + '"');
  told["remarks"] = {told["reason"]};
  told["scene"] = "s";
  const std::string report = directory_.write("r.json", told.dump());
  const Result explained = must({"explain", report});
  const std::string shown = "x\\x1b]0;x\\x07\\xc2\\x9b31m\\xe2\\x80\\xae\\x0ay";
  EXPECT_EQ(lines_of(explained.out).front(), shown + " against s: CERTIFIED.");
  EXPECT_EQ(lines_of(explained.out).back(), "Note: " + shown + ".");
  for (const char c : explained.out) {
    const auto byte = static_cast<unsigned char>(c);
    EXPECT_TRUE(c == '\n' || (byte >= 0x20 && byte < 0x7f)) << int{byte};
  }
}

TEST_F(Limits, AProducerCannotForgeTheHeaderOfAnEventSequence) {
  const std::string scene = reference(3, "1"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history, "--quiet"});
  std::string text = directory_.read("a.history.jsonl");
  const std::size_t at = text.find("\"producer\":\"") + 12;
  text.insert(at, "x\\n#SIMULATION_TIME:\\t7.00\\n");
  directory_.write("a.history.jsonl", text);
  must({"convert", history, "--scene", scene, "-o", file("a.evtsq")});
  const std::vector<std::string> lines = lines_of(directory_.read("a.evtsq"));
  EXPECT_EQ(lines[1].rfind("#DVD_GENERATOR:\tx\\x0a#SIMULATION_TIME:\\x097.00\\x0a", 0), 0u)
      << lines[1];
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [](const std::string& line) { return line.starts_with("#SIM"); }),
            1);
}

TEST_F(Limits, AFileLargerThanAllowedIsAnError) {
  const auto small_files = [] {
    const rlimit limit{1 << 12, 1 << 12};
    setrlimit(RLIMIT_FSIZE, &limit);
  };
  const Result result =
      run_in(small_files, {"generate", "grid", "--n", "10000", "-o", file("a.scene.json")});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("a.scene.json: cannot write: "), std::string::npos) << result.err;
  EXPECT_EQ(directory_.number_of_files(), 0u);
}

// What there was room for is a history that stopped, right as far as it goes; it takes the place of
// nothing that is complete.
TEST_F(Limits, AHistoryWithoutRoomIsKeptAsFarAsItGoes) {
  const std::string scene = reference(40, "60"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history, "--quiet"});
  const std::string complete = directory_.read("a.history.jsonl");
  const std::vector<std::string> all = lines_of(complete);
  ASSERT_GT(complete.size(), 1u << 14);
  const auto simulate = [&](rlim_t bytes, const std::string& threads, const std::string& to) {
    const auto small_files = [bytes] {
      const rlimit limit{bytes, bytes};
      setrlimit(RLIMIT_FSIZE, &limit);
    };
    return run_in(small_files, {"simulate", scene, "-o", to, "--threads", threads, "--quiet"});
  };
  for (const std::string threads : {"1", "2"}) {
    for (const rlim_t bytes : {rlim_t{10'000}, rlim_t{12'345}, rlim_t{complete.size() - 1}}) {
      const Result result = simulate(bytes, threads, history);
      EXPECT_EQ(result.code, 2);
      EXPECT_NE(result.err.find("a.history.jsonl: cannot write: "), std::string::npos);
      EXPECT_NE(result.err.find("is in " + history + ".partial"), std::string::npos) << result.err;
      EXPECT_EQ(directory_.read("a.history.jsonl"), complete);
      std::vector<std::string> begun = lines_of(directory_.read("a.history.jsonl.partial"));
      ASSERT_GT(begun.size(), 2u);
      EXPECT_NE(begun.back().find("\"reason\":\"cannot write: "), std::string::npos);
      begun.pop_back();
      EXPECT_TRUE(std::equal(begun.begin(), begun.end(), all.begin()));
      EXPECT_EQ(run({"certify", scene, history + ".partial"}).code, 3);
      must({"validate", history + ".partial"});
      std::filesystem::remove(history + ".partial");
    }
  }
  // Not even one event has room: nothing is left.
  EXPECT_EQ(simulate(1000, "1", file("b.history.jsonl")).code, 2);
  EXPECT_EQ(directory_.number_of_files(), 2u);
}

// Refuses threads, as where a user has as many processes as the system allows.
void refuse_threads() {
  constexpr unsigned error = SECCOMP_RET_ERRNO | EAGAIN;
  sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone3, 3, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 2, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_fork, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      BPF_STMT(BPF_RET | BPF_K, error),
  };
  const sock_fprog program{std::size(filter), filter};
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) _exit(126);
}

TEST_F(Limits, RefusedThreadsAndProcessesAreErrors) {
  const std::string scene = reference(10, "10"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history, "--quiet"});
  const auto refused_by_system = [&](const Arguments& arguments) {
    // The program takes the place of the process: nothing can be forked any more.
    const std::string err = streams_.file("inner");
    const pid_t child = fork();
    if (child == 0) {
      std::vector<char*> words{const_cast<char*>(VOROPROOF_PROGRAM)};
      for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
      words.push_back(nullptr);
      dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
      dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
      refuse_threads();
      execv(VOROPROOF_PROGRAM, words.data());
      _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status)) << arguments.front();
    EXPECT_EQ(WEXITSTATUS(status), 5) << arguments.front() << streams_.read("inner");
    EXPECT_EQ(lines_of(streams_.read("inner")).size(), 1u) << streams_.read("inner");
    EXPECT_EQ(directory_.number_of_files(), 2u);
  };
  refused_by_system({"simulate", scene, "-o", file("b"), "--threads", "2"});
  refused_by_system({"certify", scene, history, "--kernel", "--report", file("b")});
  refused_by_system({"corpus", "run", "--json", file("b")});
}

}  // namespace
}  // namespace voroproof::internal
