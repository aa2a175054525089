#include "kernel/kernel.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "kernel/lives.h"

namespace voroproof_kernel {
namespace {

std::int64_t Counts::*const kCounts[] = {
    &Counts::flips,          &Counts::collisions, &Counts::maneuvers,
    &Counts::lives,          &Counts::pair_lives, &Counts::fresh_proofs,
    &Counts::swaps,          &Counts::grazes,     &Counts::rounding_overlaps,
    &Counts::horizon_events, &Counts::unoriented};

// The verdict of one task: 0 checks the contacts, k the lives of part k - 1.
Result work(const Problem& p, const std::vector<Part>& parts, std::size_t task) {
  Result r;
  r.verdict = Verdict::certified;
  try {
    if (task == 0) {
      check_contacts(p, r.counts, r.line);
    } else {
      check_lives(p, parts[task - 1], r.counts, r.line);
    }
    r.line = 0;
  } catch (const Stop& stop) {
    r.verdict = stop.verdict;
    r.reason = stop.reason;
    if (stop.line != 0) r.line = stop.line;
  }
  return r;
}

// Adds what one task found. The first refuted claim counts, else the first that is undecided.
void add(Result& all, const Result& r) {
  for (const auto count : kCounts) all.counts.*count += r.counts.*count;
  const auto rank = [](const Result& x) {
    return std::pair(x.verdict == Verdict::refuted     ? 0
                     : x.verdict == Verdict::undecided ? 1
                                                       : 2,
                     x.line);
  };
  if (rank(r) >= rank(all)) return;
  all.verdict = r.verdict;
  all.reason = r.reason;
  all.line = r.line;
}

// The tasks k, k + jobs, ... in each of several processes, which write what they find to pipes.
void work_in_processes(const Problem& p, const std::vector<Part>& parts, int jobs, Result& all) {
  std::vector<std::FILE*> pipes;
  std::vector<pid_t> children;
  for (int k = 0; k < jobs; ++k) {
    int ends[2];
    if (pipe(ends) != 0) undecided("no pipe to another process");
    const pid_t child = fork();
    if (child < 0) undecided("no other process");
    if (child == 0) {
      std::ostringstream text;
      for (std::size_t task = k; task <= parts.size(); task += jobs) {
        const Result r = work(p, parts, task);
        text << static_cast<int>(r.verdict) << ' ' << r.line;
        for (const auto count : kCounts) text << ' ' << r.counts.*count;
        text << ' ' << r.reason << '\n';
      }
      const std::string found = text.str();
      std::FILE* to = fdopen(ends[1], "w");
      const bool good = std::fwrite(found.data(), 1, found.size(), to) == found.size();
      _exit(std::fclose(to) == 0 && good ? 0 : 1);
    }
    close(ends[1]);
    pipes.push_back(fdopen(ends[0], "r"));
    children.push_back(child);
  }
  std::size_t tasks = 0;
  bool good = true;
  for (int k = 0; k < jobs; ++k) {
    std::string text;
    for (int c; (c = std::fgetc(pipes[k])) != EOF;) text += static_cast<char>(c);
    std::fclose(pipes[k]);
    int status = 0;
    good = waitpid(children[k], &status, 0) == children[k] && status == 0 && good;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line); ++tasks) {
      std::istringstream words(line);
      Result r;
      int verdict;
      words >> verdict >> r.line;
      for (const auto count : kCounts) words >> r.counts.*count;
      std::getline(words >> std::ws, r.reason);
      r.verdict = static_cast<Verdict>(verdict);
      add(all, r);
    }
  }
  if (!good || tasks != parts.size() + 1) undecided("a process ended early");
}

void judge(Problem& p, Result& result) {
  const History& h = p.history;
  if (!h.stopped && h.horizon != p.scene.horizon) {
    if (p.options.strict) refute("the history has another horizon than its scene");
    result.horizon_note = "horizon " + h.horizon.str() + " of the scene's " + p.scene.horizon.str();
  }
  trace_paths(p, result.counts);
  if (!h.initial && p.disks() >= 2) undecided("the history has no initial diagram");
  if (h.initial && p.disks() < 2 && !h.initial->empty()) refute("wrong initial diagram");
  const std::vector<Part> parts = p.disks() >= 2 ? parts_of(p) : std::vector<Part>{};
  result.verdict = Verdict::certified;
  if (p.options.jobs > 1) {
    work_in_processes(p, parts, p.options.jobs, result);
  } else {
    for (std::size_t task = 0; task <= parts.size(); ++task) add(result, work(p, parts, task));
  }
  if (result.verdict == Verdict::refuted) return;
  const Counts& c = result.counts;
  const std::int64_t claimed[] = {c.flips, c.collisions, c.maneuvers};
  for (int k = 0; k < 3 && !h.stopped; ++k) {
    if (h.ended[k] != claimed[k]) throw Stop{Verdict::refuted, "bad count", h.last_line};
  }
  if (h.stopped && result.verdict == Verdict::certified) {
    undecided("the history stops before its horizon");
  }
}

}  // namespace

Result check(const std::string& scene_text, const std::string& history_text,
             const Options& options) {
  Result result;
  try {
    Problem p;
    p.options = options;
    p.tolerance = exact_string(options.tolerance);
    p.law_tolerance = exact_string(options.law_tolerance);
    if (p.tolerance <= 0 || p.law_tolerance < 0 || p.law_tolerance > 1) invalid("a bad tolerance");
    p.scene = read_scene(scene_text);
    p.history = read_history(history_text, p.disks());
    p.horizon = p.history.horizon;
    // A tolerance of times beyond that would accept any.
    if (p.tolerance > std::max(p.horizon, Rat(1, 1000000)))
      invalid("a tolerance beyond the horizon");
    if (p.history.scene_sha256 != sha256(scene_text)) invalid("another scene's history", 1);
    judge(p, result);
  } catch (const Stop& stop) {
    result.verdict = stop.verdict;
    result.reason = stop.reason;
    result.line = stop.line;
  }
  return result;
}

}  // namespace voroproof_kernel
