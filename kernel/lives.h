// The lives of edges: that each edge of the claimed diagram collapses just where a flip is claimed.
#pragma once

#include "kernel/motion.h"

namespace voroproof_kernel {

// Claims [first, last) and the time from `begin` to `end` that they are proved for.
struct Part {
  std::size_t first, last;
  Rat begin, end;
};

// Cuts the claims where they are far apart; the same for any number of processes.
std::vector<Part> parts_of(const Problem& p);
void check_lives(const Problem& p, const Part& part, Counts& counts, std::int64_t& line);

// Throw Stop where the diagram of the walk is wrong at 0, or at t around one generator.
void check_initial(const Walk& walk);
void check_cell(const Walk& walk, int g, const Rat& t);

}  // namespace voroproof_kernel
