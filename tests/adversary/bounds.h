// What both parts of the oracle use: lengths, and values held against bounds.
#pragma once

#include <array>
#include <string>

#include "tests/adversary/paths.h"
#include "tests/adversary/truth.h"

namespace voroproof::internal::adversary {

inline Opinion wrong(const std::string& why) { return {Finding::wrong, why}; }
inline Opinion unclear(const std::string& why) { return {Finding::unclear, why}; }

inline Wide norm(const WideVec& a) { return square_root(a.x * a.x + a.y * a.y); }
// A bound of the length, as a certifier may take it.
inline Wide length_bound(const WideVec& a) {
  return (a.x < 0 ? -a.x : a.x) + (a.y < 0 ? -a.y : a.y);
}
inline Wide dot(const WideVec& a, const WideVec& b) { return a.x * b.x + a.y * b.y; }
inline WideVec minus(const WideVec& a, const WideVec& b) { return {a.x - b.x, a.y - b.y}; }
inline WideVec wide(const Pair2& v) { return {v[0], v[1]}; }

// Within the bound, beyond it, or too near to it to say.
inline Finding within(Wide value, Wide bound) {
  const Wide slack = bound * static_cast<Wide>(1e-6);
  return value <= bound - slack   ? Finding::right
         : value <= bound + slack ? Finding::unclear
                                  : Finding::wrong;
}

// The better of two.
inline Finding either(Finding a, Finding b) {
  if (a == Finding::right || b == Finding::right) return Finding::right;
  return a == Finding::unclear || b == Finding::unclear ? Finding::unclear : Finding::wrong;
}

// Whether the value is within a bound that may be taken larger than it need be: up to `most`.
inline Finding within(Wide value, Wide least, Wide most) {
  return either(within(value, least),
                within(value, most) == Finding::wrong ? Finding::wrong : Finding::unclear);
}

// The worse of two.
inline Finding both(Finding a, Finding b) {
  if (a == Finding::wrong || b == Finding::wrong) return Finding::wrong;
  return a == Finding::unclear || b == Finding::unclear ? Finding::unclear : Finding::right;
}

inline std::string text(const Line& line) {
  return "t " + std::to_string(line.t) + " of " + std::to_string(line.i) + " and " +
         std::to_string(line.j);
}

// The velocities after the collision of a line, by the law, with these centres and velocities
// before.
inline std::array<WideVec, 2> response(const SceneData& scene, const Line& line,
                                       const std::array<WideVec, 2>& p,
                                       const std::array<WideVec, 2>& before) {
  const WideVec vi = before[0], vj = before[1], n = minus(p[1], p[0]);
  const Wide towards = dot(minus(vj, vi), n) / dot(n, n);
  if (line.i >= 0) {
    const Wide mi = scene.disks[static_cast<std::size_t>(line.i)].mass,
               mj = scene.disks[static_cast<std::size_t>(line.j)].mass;
    const Wide k = (1 + Wide(scene.restitution)) * towards / (mi + mj);
    return {WideVec{vi.x + k * mj * n.x, vi.y + k * mj * n.y},
            WideVec{vj.x - k * mi * n.x, vj.y - k * mi * n.y}};
  }
  const Wide e = scene.wall_restitution, k = scene.whole ? Wide(2) : 1 + e;
  const WideVec back{vj.x - k * towards * n.x, vj.y - k * towards * n.y};
  return {vi, scene.whole ? WideVec{e * back.x, e * back.y} : back};
}

}  // namespace voroproof::internal::adversary
