// The state of a wrong world: its disks, its diagram, and what it predicts of each.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/adversary/geometry.h"
#include "tests/adversary/wrong_world.h"

namespace voroproof::internal::adversary {

// Events closer than this, relative to 1 + t, are of one instant.
inline constexpr Real one_instant = 1e-15L;

struct Body {
  Vec base{};  // the centre at time `since`
  Real since = 0;
  Vec v{};
  Real r = 0, mass = 1;
  int partner = -2;  // with whom the last turn was a collision
  Vec at(Real t) const { return base + (t - since) * v; }
};

// An edge, and what is next: it flips at `next`, or is looked at again then.
struct EdgeState {
  Edge q{};
  Real next = never;
  bool flips = false;
  bool shadow = false;  // the root is not one of a flip
  bool forced = false;  // at `next`, whatever the geometry says
};

struct PairState {
  Real next = never;
  bool passing = false;  // a collision was missed and the two have not parted yet
  bool forced = false;
  bool false_one = false;  // they do not meet
};

class World {
 public:
  World(const SceneData& scene, const Fault& fault, std::size_t most_lines);
  std::optional<WorldResult> run();

 private:
  struct Next {
    enum class Kind { none, collision, maneuver, flip, look };
    Kind kind = Kind::none;
    Real t = never;
    int i = 0, j = 0;      // of a collision
    std::size_t edge = 0;  // of a flip
  };

  // ---- Places (world_state.cpp). ----
  Body& body(int id) { return bodies_[static_cast<std::size_t>(id + 1)]; }
  const Body& body(int id) const { return bodies_[static_cast<std::size_t>(id + 1)]; }
  PairState& pair(int i, int j) { return pairs_[static_cast<std::size_t>((i + 1) * n_ + j)]; }
  Site site_at(int id, Real t) const { return {body(id).at(t), body(id).r}; }
  Sites sites_at(Real t) const;
  std::array<Real, 2> in_circles(const Edge& q, Real t) const;
  bool make_initial(Real t, bool ties);
  std::vector<std::size_t> corners(std::size_t k) const;
  bool flip_topology(std::size_t k, std::vector<std::size_t>& changed);
  void predict_edge(EdgeState& e, Real from);
  void predict_pair(int i, int j);
  void predict_around(int id);
  void predict_all();

  // ---- Events (wrong_world.cpp, world_events.cpp). ----
  Next next_event(bool without, const Next& excluded) const;
  void start();
  void collide(const Next& event);
  void write_collision(int i, int j, double t);
  void respond(int i, int j);
  void maneuver(std::size_t k, double t, bool turn, bool line);
  void flip(const Next& event);
  void apply_flip(std::size_t k);
  void move_to(Real t);
  void turn(int id, Vec v);
  bool strikes(FaultKind kind);
  void struck(Real t);
  bool process(Next event);
  void finish();

  const SceneData& scene_;
  Fault fault_;
  std::size_t most_lines_;
  WorldResult result_;
  int n_;
  Real now_ = 0, end_ = 0, size_;
  Real restitution_, wall_restitution_;
  int candidates_ = 0;        // events that the fault could have befallen so far
  std::vector<Body> bodies_;  // the container first
  std::vector<EdgeState> edges_;
  std::vector<PairState> pairs_;
  std::vector<double> maneuver_times_;
  std::vector<bool> maneuver_done_;
};

}  // namespace voroproof::internal::adversary
