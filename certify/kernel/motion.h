// The problem to judge: the files, the options, and the paths of the disks that the claims define.
#pragma once

#include <algorithm>
#include <memory>

#include "certify/kernel/billiard.h"
#include "certify/kernel/diagram.h"
#include "certify/kernel/edge.h"

namespace voroproof_kernel {

struct Problem {
  Scene scene{};
  History history{};
  Options options;
  Rat tolerance{}, law_tolerance{};
  std::vector<std::vector<Leg>> legs{};  // paths, of generator g at [g + 1], one leg for each turn
  std::vector<std::vector<Flight>> flights{};  // the paths of a billiard's disks
  Rat extent{};                                // the size of a billiard at the start

  bool exact() const { return options.truth == Truth::exact; }
  int disks() const { return static_cast<int>(scene.disks.size()); }
  Rat radius(int g) const { return g == container ? -scene.radius : scene.disks[g].radius; }
  Rat reach(int i, int j) const { return abs(radius(i) + radius(j)); }
  bool is_fixed(int g) const { return g < 0 || scene.disks[g].fixed; }
  Vec fall(int g) const { return is_fixed(g) ? Vec{} : plus({}, Rat(1, 2), scene.gravity); }
  Vec place(int g, const Flight& f, const Rat& t) const {
    return plus(plus(f.a, t, f.b), t * t, fall(g));
  }
  void tell(const char* rule, std::size_t claim) const {
    if (options.progress) options.progress(rule, claim, history.claims.size());
  }
};

// As check() of kernel.h. The problem has options; what else of it was read and found stays in it.
Result check(const std::string& scene_text, const std::string& history_text, Problem& p);
inline Sight sight(const Rat& t, std::initializer_list<int> generators) {
  Sight s{t.convert_to<double>(), static_cast<int>(generators.size())};
  std::copy(generators.begin(), generators.end(), s.generators);
  return s;
}
inline Sight sight(const Rat& t, const Quad& q) { return sight(t, {q.l, q.r, q.s, q.e}); }

// Does the work; a Stop that names no line names that one then.
template <class Work>
void at_line(std::int64_t line, Work&& work) {
  try {
    work();
  } catch (Stop& stop) {
    if (stop.line == 0) stop.line = line;
    throw;
  }
}

// The scene's maneuvers up to the horizon, as far as they are not claimed yet.
class Schedule {
 public:
  explicit Schedule(const Problem& p) : p_(p), done_(p.scene.maneuvers.size()) {}
  // The one that is claimed. Throws Stop (refuted) where there is none then.
  const Maneuver& claimed(const Claim& c);
  // Throws Stop (refuted) where one is left.
  void require_done() const;

 private:
  const Problem& p_;
  std::vector<bool> done_;
};

// The gap |d(t)|^2 - reach^2 = a s^2 + 2 b s + c of two on their lines, s = t - start.
struct Gap {
  Rat start, a, b, c;
  Gap(const Leg& i, const Leg& j);
  explicit Gap(const Rat& t) : start(t) {}
  Rat value(const Rat& t) const { return (a * (t - start) + 2 * b) * (t - start) + c; }
  Rat slope(const Rat& t) const { return a * (t - start) + b; }  // half the derivative
  bool has_roots() const { return a > 0 && b * b > a * c; }
  // For two points: whether they meet up to t.
  bool meet(const Rat& t) const {
    const Rat nearest = a > 0 ? Rat(start - b / a) : start;
    return nearest >= start && nearest <= t && value(nearest) == 0;
  }
};

// A walk along the claims: the diagram and the leg on which each generator is.
struct Walk {
  const Problem& problem;
  std::unique_ptr<Diagram> diagram;  // none for fewer than two disks
  std::vector<std::size_t> leg_of;

  explicit Walk(const Problem& p);
  const Leg& leg(int g) const { return problem.legs[g + 1][leg_of[g + 1]]; }
  const std::vector<Quad>& edges() const { return diagram->edges(); }
  // Edge k on its generators' present legs.
  Four four(int k) const;
  // The edge that a flip names, or -1; with --unoriented the quadruplet may be a mirrored one.
  int edge_of(const Claim& flip, bool* mirrored = nullptr) const;
  // Throws Stop (refuted) where a flip names no edge.
  void apply(const Claim& claim);
};

// Checks maneuvers, centres, velocities, and that each disk's motion is determined; fills p.legs.
void trace_paths(Problem& p, Counts& counts);
// Checks that the collisions are those of the paths.
void check_contacts(const Problem& p, Counts& counts, std::int64_t& line);

// Claims [first, last) and the time from `begin` to `end` that they are proved for.
struct Part {
  std::size_t first, last;
  Rat begin, end;
};
// Cuts the claims where they are far apart; the same for any number of processes.
std::vector<Part> parts_of(const Problem& p);
// Checks that the edges of the claimed diagram collapse just where flips are claimed.
void check_lives(const Problem& p, const Part& part, Counts& counts, std::int64_t& line);
// Throw Stop where the diagram of the walk is wrong at 0, or at t around one generator; false where
// that has no vertices then, as of it and those around it one lies inside another.
void check_initial(const Walk& walk);
bool check_cell(const Walk& walk, int g, const Rat& t);

}  // namespace voroproof_kernel
