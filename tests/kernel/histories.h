// Scenes and histories made in a line, of disks of mass 1 in a container of radius 50 at the
// origin.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "certify/kernel/kernel.h"
#include "certify/kernel/motion.h"

namespace voroproof_kernel {

inline std::string scene_of(const std::string& disks, const std::string& horizon = "3",
                            const std::string& more = "") {
  return R"({"format":"voroproof-scene","version":1,"container":{"center":[0,0],"radius":50},)"
         "\"horizon\":" +
         horizon + more + ",\"disks\":[" + disks + "]}";
}

inline std::string disk(const std::string& x, const std::string& y, const std::string& r,
                        const std::string& vx, const std::string& vy) {
  return "{\"center\":[" + x + "," + y + "],\"radius\":" + r + ",\"velocity\":[" + vx + "," + vy +
         "],\"mass\":1}";
}

// Two disks have one diagram, at all times.
inline const std::string kTwo = "[[-1,0,1,1],[-1,1,0,0],[0,1,-1,-1]]";

inline std::string history_of(const std::string& scene, const std::vector<std::string>& claims,
                              const std::string& horizon = "3", const std::string& initial = kTwo) {
  int flips = 0, collisions = 0, maneuvers = 0;
  std::string lines = R"({"format":"voroproof-history","version":1,"scene_sha256":")" +
                      sha256(scene) + "\",\"horizon\":" + horizon +
                      ",\"producer\":\"hand\",\"initial\":" + initial + "}\n";
  for (const std::string& c : claims) {
    flips += c.find("flip") != std::string::npos;
    collisions += c.find("collide") != std::string::npos;
    maneuvers += c.find("maneuver") != std::string::npos;
    lines += c + "\n";
  }
  return lines + "{\"end\":{\"t\":" + horizon + ",\"flips\":" + std::to_string(flips) +
         ",\"collisions\":" + std::to_string(collisions) +
         ",\"maneuvers\":" + std::to_string(maneuvers) + "}}\n";
}

inline Verdict verdict(const std::string& scene, const std::vector<std::string>& claims,
                       Truth truth, const std::string& horizon = "3",
                       const std::string& initial = kTwo) {
  Options options;
  options.truth = truth;
  const Result r = check(scene, history_of(scene, claims, horizon, initial), options);
  EXPECT_NE(r.verdict, Verdict::invalid) << r.reason << ", line " << r.line;
  return r.verdict;
}

}  // namespace voroproof_kernel
