#include "certify/kernel/kernel.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "certify/kernel/motion.h"

namespace voroproof_kernel {
namespace {

// The result of one task, in memory that processes share.
struct Found {
  Verdict verdict = Verdict::undecided;
  std::int64_t line = 0;
  bool last = false;
  Sight sight;
  Counts counts;
  char reason[256] = "a process ended early";
  // The first refuted claim counts, unless no rule holds by then; else the first undecided one.
  auto rank() const {
    const bool refuted = verdict == Verdict::refuted, certified = verdict == Verdict::certified;
    return std::pair(refuted || last ? 0 : certified ? 2 : 1, line);
  }
};

void add(Counts& all, const Counts& more) {
  for (const auto count :
       {&Counts::flips, &Counts::collisions, &Counts::maneuvers, &Counts::lives,
        &Counts::pair_lives, &Counts::fresh_proofs, &Counts::swaps, &Counts::grazes,
        &Counts::rounding_overlaps, &Counts::horizon_events, &Counts::unoriented}) {
    all.*count += more.*count;
  }
}

// Task 0 checks the contacts, k the lives of part k - 1.
void work(const Problem& p, const std::vector<Part>& parts, std::size_t task, Found& found) {
  Stop stop{Verdict::certified, ""};
  try {
    if (task == 0) check_contacts(p, found.counts, found.line);
    if (task > 0) check_lives(p, parts[task - 1], found.counts, found.line);
  } catch (const Stop& what) {
    stop = what;
  }
  std::snprintf(found.reason, sizeof found.reason, "%s", stop.reason.c_str());
  found.verdict = stop.verdict;
  found.last = stop.last;
  found.sight = stop.sight;
}

// The tasks k, k + jobs, ... in each of several processes.
std::vector<Found> work_on_all(const Problem& p, const std::vector<Part>& parts) {
  const std::size_t tasks = parts.size() + 1, bytes = tasks * sizeof(Found), jobs = p.options.jobs;
  void* shared = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) undecided("no memory to share with other processes");
  Found* found = new (shared) Found[tasks];
  std::vector<pid_t> children;
  for (std::size_t k = 0; k < jobs; ++k) {
    const pid_t child = jobs > 1 ? fork() : 0;
    if (child > 0) children.push_back(child);
    if (child != 0) continue;
    for (std::size_t task = k; task < tasks; task += jobs) work(p, parts, task, found[task]);
    if (jobs > 1) _exit(0);
  }
  for (const pid_t child : children) waitpid(child, nullptr, 0);
  std::vector<Found> all(found, found + tasks);
  munmap(shared, bytes);
  return all;
}

void judge_diagram(Problem& p, Counts& counts) {
  const History& h = p.history;
  trace_paths(p, counts);
  if (!h.initial && p.disks() >= 2) undecided("the history has no initial diagram");
  if (h.initial && p.disks() < 2 && !h.initial->empty()) refute("wrong initial diagram");
  const auto all = work_on_all(p, p.disks() >= 2 ? parts_of(p) : std::vector<Part>{});
  for (const Found& found : all) add(counts, found.counts);
  const Found& first = *std::min_element(
      all.begin(), all.end(), [](const Found& x, const Found& y) { return x.rank() < y.rank(); });
  if (first.verdict != Verdict::certified) {
    throw Stop{first.verdict, first.reason, first.line, false, first.sight};
  }
}

// To which roundings of coordinates are in proportion.
Rat extent_of(const Scene& scene) {
  Rat extent = 0, frame = 0;
  for (const Disk& d : scene.disks) {
    for (const Rat& x : d.center) extent = std::max(extent, Rat(abs(x) + d.radius));
  }
  for (const Rat& x : scene.center) frame = std::max(frame, Rat(abs(x) + scene.radius));
  for (const Wall& wall : scene.walls) frame = std::max(frame, Rat(abs(wall.offset)));
  return extent + frame + scene.sides[0] + scene.sides[1] + scene.sides[2];
}

void judge_billiard(Problem& p, Counts& counts) {
  if (p.exact()) undecided("the kernel judges billiards under the recorded truth alone");
  // A horizon that is the scene's, rounded up, is the scene's.
  Rat& horizon = p.history.horizon;
  if (horizon == nearest_binary64(p.scene.horizon)) horizon = std::min(horizon, p.scene.horizon);
  if (horizon > p.scene.horizon) invalid("the history goes beyond its scene's horizon");
  p.extent = extent_of(p.scene);
  std::vector<Life> lives = trace_flights(p, counts);
  at_line(p.history.last_line, [&] { find_lives(p, lives); });
  check_collisions(p, std::move(lives), counts);
}

void judge(Problem& p, Result& result) {
  const History& h = p.history;
  if (h.stopped) undecided("the history stops before its horizon");
  if (h.horizon != p.scene.horizon) {
    if (p.options.strict) refute("the history has another horizon than its scene");
    result.horizon_note = "horizon " + h.horizon.str() + " of the scene's " + p.scene.horizon.str();
  }
  result.is_first = false;  // each rule looks at all claims before the next does
  if (p.scene.is_billiard()) {
    judge_billiard(p, result.counts);
  } else {
    judge_diagram(p, result.counts);
  }
  result.is_first = true;
  const Counts& c = result.counts;
  if (h.ended[0] != c.flips || h.ended[1] != c.collisions || h.ended[2] != c.maneuvers) {
    throw Stop{Verdict::refuted, "bad count", h.last_line};
  }
  result.verdict = Verdict::certified;
}
}  // namespace

Result check(const std::string& scene_text, const std::string& history_text,
             const Options& options) {
  Problem p{.options = options};
  return check(scene_text, history_text, p);
}

Result check(const std::string& scene_text, const std::string& history_text, Problem& p) {
  Result result;
  try {
    p.tolerance = exact_string(p.options.tolerance);
    p.law_tolerance = exact_string(p.options.law_tolerance);
    if (p.tolerance <= 0 || p.law_tolerance < 0 || p.law_tolerance > 1) invalid("a bad tolerance");
    p.scene = read_scene(scene_text);
    p.history = read_history(history_text, p.scene);
    // A tolerance of times beyond that would accept any.
    const bool vast = p.tolerance > std::max(p.history.horizon, Rat(1, 1000000));
    if (vast) invalid("a tolerance beyond the horizon");
    if (p.history.scene_sha256 != sha256(scene_text)) {
      throw Stop{Verdict::invalid, "another scene's history", 1};
    }
    judge(p, result);
  } catch (const Stop& stop) {
    result.verdict = stop.verdict;
    result.reason = stop.reason;
    result.line = stop.line;
    result.sight = stop.sight;
  }
  return result;
}

std::string lines_of(const Result& r) {
  const Counts& c = r.counts;
  std::ostringstream lines;
  lines << "c " << c.flips << " flips, " << c.collisions << " collisions, " << c.maneuvers
        << " maneuvers; " << c.lives << " lives of edges, " << c.pair_lives << " of pairs, "
        << c.fresh_proofs << " fresh proofs\n"
        << "c " << c.swaps << " swaps, " << c.grazes << " grazes, " << c.rounding_overlaps
        << " overlaps by rounding, " << c.horizon_events << " events at the horizon, "
        << c.unoriented << " quadruplets without orientation\n";
  if (!r.horizon_note.empty()) lines << "c " << r.horizon_note << "\n";
  if (r.verdict == Verdict::refuted && !r.is_first) {
    lines << "c the first fault that was found; an earlier one may exist\n";
  }
  const std::string line = r.line > 0 ? "line " + std::to_string(r.line) + ": " : "";
  if (!r.reason.empty()) lines << "c " << line << r.reason << "\n";
  const char* words[] = {"CERTIFIED", "REFUTED", "UNDECIDED", "INVALID"};
  lines << "s " << words[static_cast<int>(r.verdict)] << "\n";
  return lines.str();
}

}  // namespace voroproof_kernel
