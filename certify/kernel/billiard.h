// Billiards under the recorded truth (docs/kernel.md, section 9): flights, gaps as polynomials of
// time, and the lives of pairs.
#pragma once

#include <tuple>
#include <vector>

#include "certify/kernel/files.h"

namespace voroproof_kernel {

struct Problem;

// A disk from a turn on: at t its centre is a + b t + fall t^2, fall being half of gravity, or 0
// where it is fixed.
struct Flight {
  Rat start;
  Vec a, b, velocity;       // the last one at the start
  std::int64_t turns = 0;   // claims that turned it so far
  std::int64_t claim = -1;  // the last of them
};

// A wall or a disk i, and an image of the disk j > i.
struct Encounter {
  int i, j;
  Image image{};
  bool operator==(const Encounter&) const = default;
  bool operator<(const Encounter& o) const {
    return std::tie(i, j, image) < std::tie(o.i, o.j, o.image);
  }
};
std::string name(const Problem& p, const Encounter& two);
// Where an image is from its disk at time 0, and how fast it goes from there.
Vec offset(const Scene& scene, const Image& image);
Vec drift(const Scene& scene, const Image& image);

// Two on their flights; i is none for a wall. The sign of a gap is that of a polynomial.
struct Meeting {
  const Problem& problem;
  Encounter two;
  const Flight *i, *j;
  Vec apart[3];  // from i to j; for a wall along its normal; coefficients of t^0, t^1, t^2
  Rat reach[2];  // the distance at which they touch; coefficients of t^0, t^1

  Meeting(const Problem& problem, const Encounter& two, const Flight* i, const Flight& j);
  bool is_flat() const;
  // When the later of their flights began.
  Rat begin() const { return i == nullptr ? j->start : std::max(i->start, j->start); }
  // Bounds how far roundings of the numbers on these flights so far can have moved the two.
  Rat rounding() const;
  Form gap(const Rat& depth = 0) const;  // its sign is that of gap + depth, |depth| <= reach
};

// Two on their flights (numbers in Problem::flights) in a time in which they may touch; or, with
// from = to, just before a claim of their collision.
struct Life {
  Encounter two;
  std::size_t flight[2];
  Rat from, to;
  std::int64_t claim = -1;  // its number
};

// Throws Stop (invalid) where disks overlap at the start, or are not in their frame.
void check_start(const Problem& p);
// Checks maneuvers, centres and velocities; fills p.flights. Gives the claims of collisions.
std::vector<Life> trace_flights(Problem& p, Counts& counts);
// Adds all lives in which gaps are not positive throughout.
void find_lives(const Problem& p, std::vector<Life>& lives);
// Checks that the collisions are those of the flights. Throws Stop with the first fault.
void check_collisions(const Problem& p, std::vector<Life> lives, Counts& counts);

// The only root of p in (lo, hi), or lo = hi; and p's signs just before and after it.
struct Root {
  Form p;
  Rat lo, hi;
  int before, after;
};
// All in the open interval, in order.
std::vector<Root> roots(const Form& p, const Rat& a, const Rat& b);
// The sign of root - t, where p changes its sign at the root.
int compare(const Root& root, const Rat& t);
// Whether p is negative somewhere in [a, b]; whether it falls below 0 there, from 0 or more.
bool sinks(const Form& p, const Rat& a, const Rat& b);
bool falls(const Form& p, const Rat& a, const Rat& b);

}  // namespace voroproof_kernel
