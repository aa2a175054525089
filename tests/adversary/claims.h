// Scenes and histories of the adversary, in doubles, and their texts (docs/formats.md).
#pragma once

#include <array>
#include <string>
#include <vector>

namespace voroproof::internal::adversary {

// An oriented quadruple [l, r, s, e]; -1 is the container.
using Edge = std::array<int, 4>;
using Pair2 = std::array<double, 2>;

struct DiskData {
  double x = 0, y = 0, radius = 1, vx = 0, vy = 0, mass = 1;
};

struct ManeuverData {
  double t = 0;
  int disk = 0;
  double vx = 0, vy = 0;
};

struct SceneData {
  double cx = 0, cy = 0, radius = 100;
  double restitution = 1, wall_restitution = 1;
  bool whole = false;  // the container's law
  double horizon = 1;
  std::vector<DiskData> disks;
  std::vector<ManeuverData> maneuvers;  // sorted by t
  int size() const { return static_cast<int>(disks.size()); }
};

// One line of a history. A collision has i < j; [1] of v and p is of j, [0] of i (not used of the
// container). A maneuver has i = j, and [1] is of the disk.
struct Line {
  enum class Kind { flip, collide, maneuver };
  Kind kind = Kind::flip;
  double t = 0;
  Edge edge{};
  int i = 0, j = 0;
  std::array<Pair2, 2> v{}, p{};
};

// Whether the line is about this generator.
inline bool concerns(const Line& line, int id) {
  if (line.kind != Line::Kind::flip) return line.i == id || line.j == id;
  return line.edge[0] == id || line.edge[1] == id || line.edge[2] == id || line.edge[3] == id;
}

struct History {
  double horizon = 1;
  bool centres = true, velocities = true;  // whether its lines give p and v
  std::vector<Edge> initial;
  std::vector<Line> lines;
};

// Powers of two by which lengths and times are multiplied. No rounding differs in other units, so
// that what is right in one is right in all.
struct Units {
  int length = 0, time = 0;  // exponents
};
SceneData in_units(SceneData scene, const Units& units);
History in_units(History history, const Units& units);

// The smaller of the edge's two names.
inline Edge canonical(const Edge& q) {
  const Edge back{q[1], q[0], q[3], q[2]};
  return back < q ? back : q;
}

// The file's bytes; every number has the digits that give it back.
std::string scene_text(const SceneData& scene);

// The file's bytes. `sha256` is that of the scene's text. With `long_decimals` all numbers have
// 17 significant digits, else the shortest that give them back.
std::string history_text(const History& history, const std::string& sha256, bool long_decimals);

}  // namespace voroproof::internal::adversary
