// The hot predicates, each a fixed number of times, for callgrind to count: instructions do not
// depend on what else the machine does. bench/instructions.py runs this program, alone it measures
// nothing.
#include <valgrind/callgrind.h>

#include <iostream>
#include <string>

#include "bench/tasks.h"
#include "engine/static_diagram.h"
#include "filtered/search/contact.h"

namespace voroproof::internal::bench {

namespace {

// What was counted since the last call belongs to nobody; then runs the task, whose instructions
// are dumped under its name.
template <class Task>
void count(const std::string& name, std::size_t operations, Task&& task) {
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  task();
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
  std::cout << name << ' ' << operations << '\n';
}

// Keeps the compiler from leaving out what nobody looks at.
template <class T>
void use(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

void count_flips(const DataSet& set) {
  const std::vector<FlipTask> tasks = flip_tasks(set, 10);
  TierCounts counts;
  CollapseSearch search(*set.motion, counts);
  count("flip/" + set.name, tasks.size(), [&] {
    for (const FlipTask& task : tasks) use(certified_collapse(search, task));
  });
}

void count_incircles(const DataSet& set) {
  const std::vector<IncircleTask> tasks = incircle_tasks(set);
  count("incircle/" + set.name, tasks.size(), [&] {
    for (const IncircleTask& task : tasks) {
      use(incircle_at(task.quad, [&](GenId g) { return set.motion->site(g, DoubleBall(task.t)); }));
    }
  });
}

void count_contacts(const DataSet& set) {
  const auto pairs = neighbours(set);
  TierCounts counts;
  ContactSearch search(*set.motion, counts);
  const Moment now = Moment::at(0);
  count("contact/" + set.name, pairs.size(), [&] {
    for (const auto& [i, j] : pairs) use(search.from(i, j, now, 1000));
  });
}

void count_collisions(const DataSet& set) {
  const std::vector<Hit> hits = hits_of(set.scene, 30);
  const std::unique_ptr<ComputedMotion> motion = motion_of(set.scene);
  count("collide/" + set.name, hits.size(), [&] {
    for (const Hit& h : hits) use(motion->collide(h.i, h.j, h.t));
  });
}

void count_static_diagrams(const DataSet& set) {
  const std::unique_ptr<ComputedMotion> motion = motion_of(set.scene);
  TierCounts counts;
  count("static_diagram/" + set.name, set.scene.disks.size(),
        [&] { use(static_diagram(*motion, 0, counts)); });
}

}  // namespace

}  // namespace voroproof::internal::bench

int main() {
  using namespace voroproof::internal::bench;
  for (const std::string& name : data_set_names) count_flips(data_set(name));
  const DataSet& reference = data_set("reference");
  count_incircles(reference);
  count_contacts(reference);
  count_collisions(reference);
  count_static_diagrams(reference);
  return 0;
}
