// The inputs of the predicate benchmarks: the edges of the diagrams of generated scenes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "exact/generators.h"
#include "filtered/computed/computed_motion.h"
#include "history/scene.h"

namespace voroproof::internal::bench {

// One scene of a data set at t = 0, in its motion, and the quadruplets of its V-edges
// with four different generators (the others never collapse).
struct DataSet {
  std::string name;
  Scene scene;
  std::unique_ptr<ComputedMotion> motion;
  std::vector<Quad> quads;
};

// The names of the data sets:
//   reference     the paper's: radii uniform over [1, 10], density 0.05, one speed
//   equal         all radii 5, the case of identical vehicles
//   nearly_equal  radii uniform over [5, 5 (1 + 1e-9)]
//   dense         as the reference, at density 0.4
//   log_radii     radii log-uniform over [0.1, 30], density 0.3
inline const std::vector<std::string> data_set_names{"reference", "equal", "nearly_equal", "dense",
                                                     "log_radii"};

// The data set of that name, of 1000 disks, made once.
const DataSet& data_set(const std::string& name);

// A fresh motion of the scene at t = 0.
std::unique_ptr<ComputedMotion> motion_of(const Scene& scene);

}  // namespace voroproof::internal::bench
