// The peer of the certifier of billiards: an event-driven engine in plain doubles, as programs of
// molecular dynamics have it (D. Rapaport, The event scheduling problem in molecular dynamic
// simulation, J. Comput. Phys. 34, 1980), in a periodic box of two or three dimensions.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace voroproof::bench {

// A collision of i and the image of j: the velocities just after.
struct PlainCollision {
  double t;
  int i, j;
  std::array<int, 3> image;
  std::array<double, 3> vi, vj;
};

class PlainBilliard {
 public:
  // Balls of that radius and of mass 1 in a cube of that side; the third coordinate is unused in
  // the plane. Preconditions: they do not overlap; a cell of the box is no smaller than a ball.
  PlainBilliard(int dimension, double side, double radius, std::vector<std::array<double, 3>> x,
                std::vector<std::array<double, 3>> v);

  // Runs until so many collisions have been told.
  void run(std::int64_t collisions, const std::function<void(const PlainCollision&)>& tell);

 private:
  struct Ball {
    std::array<double, 3> x, v;  // folded, at t
    std::array<int, 3> folds;    // sides taken off the true centre
    std::array<int, 3> cell;
    double t;
    std::int64_t turns = 0;  // an event with another count is stale
  };
  struct Event {
    double t;
    int i, j;  // j < 0: i crosses a side of its cell along the axis (-1 - j) / 2
    std::int64_t turns_i, turns_j;
    bool operator>(const Event& e) const { return t > e.t; }
  };

  void move(Ball& ball, double t) const;
  void search(int i);
  void search_pair(int i, int j);
  void search_crossing(int i);
  void cross(int i, int axis, bool up);
  void put(int i);
  void remove(int i);
  std::size_t cell_index(const std::array<int, 3>& cell) const;
  std::array<double, 3> offset(const Ball& a, const Ball& b) const;
  PlainCollision collide(const Event& event);

  int dimension_, cells_;
  double side_, radius_;
  double now_ = 0;
  std::vector<Ball> balls_;
  std::vector<std::vector<int>> members_;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
};

}  // namespace voroproof::bench
