#include "bench/plain_billiard.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voroproof::bench {
namespace {

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

PlainBilliard::PlainBilliard(int dimension, double side, double radius,
                             std::vector<std::array<double, 3>> x,
                             std::vector<std::array<double, 3>> v)
    : dimension_(dimension), side_(side), radius_(radius) {
  const double fit = std::floor(side / (2 * radius));
  const double enough = std::pow(static_cast<double>(x.size()), 1.0 / dimension);
  cells_ = static_cast<int>(std::max(3.0, std::min(fit, enough)));
  std::size_t count = 1;
  for (int k = 0; k < dimension; ++k) count *= static_cast<std::size_t>(cells_);
  members_.resize(count);
  for (std::size_t i = 0; i < x.size(); ++i) {
    Ball ball{x[i], v[i], {}, {}, 0};
    for (int k = 0; k < dimension_; ++k) {
      ball.cell[k] = std::clamp(static_cast<int>(x[i][k] / side_ * cells_), 0, cells_ - 1);
    }
    balls_.push_back(ball);
    put(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < x.size(); ++i) search(static_cast<int>(i));
}

std::size_t PlainBilliard::cell_index(const std::array<int, 3>& cell) const {
  std::size_t index = 0;
  for (int k = dimension_ - 1; k >= 0; --k) {
    index = index * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(cell[k]);
  }
  return index;
}

void PlainBilliard::put(int i) { members_[cell_index(balls_[i].cell)].push_back(i); }

void PlainBilliard::remove(int i) {
  auto& members = members_[cell_index(balls_[i].cell)];
  members.erase(std::find(members.begin(), members.end(), i));
}

void PlainBilliard::move(Ball& ball, double t) const {
  for (int k = 0; k < dimension_; ++k) ball.x[k] += ball.v[k] * (t - ball.t);
  ball.t = t;
}

// From a to the nearest image of b.
std::array<double, 3> PlainBilliard::offset(const Ball& a, const Ball& b) const {
  std::array<double, 3> d{};
  for (int k = 0; k < dimension_; ++k) {
    d[k] = b.x[k] - a.x[k];
    d[k] -= side_ * std::round(d[k] / side_);
  }
  return d;
}

void PlainBilliard::search_pair(int i, int j) {
  Ball a = balls_[i], b = balls_[j];
  move(a, now_);
  move(b, now_);
  const std::array<double, 3> d = offset(a, b);
  const std::array<double, 3> w{b.v[0] - a.v[0], b.v[1] - a.v[1], b.v[2] - a.v[2]};
  const double dw = dot(d, w);
  if (dw >= 0) return;
  const double ww = dot(w, w), c = dot(d, d) - 4 * radius_ * radius_;
  const double discriminant = dw * dw - ww * c;
  if (discriminant <= 0) return;
  const double passed = std::max(0.0, c / (-dw + std::sqrt(discriminant)));
  queue_.push({now_ + passed, i, j, a.turns, b.turns});
}

void PlainBilliard::search_crossing(int i) {
  const Ball& ball = balls_[i];
  double best = std::numeric_limits<double>::infinity();
  int side = -1;
  for (int k = 0; k < dimension_; ++k) {
    const double width = side_ / cells_;
    const double x = ball.x[k] + ball.v[k] * (now_ - ball.t);
    const double to = ball.v[k] > 0 ? (ball.cell[k] + 1) * width : ball.cell[k] * width;
    if (ball.v[k] == 0) continue;
    const double passed = std::max(0.0, (to - x) / ball.v[k]);
    if (passed < best) {
      best = passed;
      side = 2 * k + (ball.v[k] > 0 ? 1 : 0);
    }
  }
  if (side >= 0) queue_.push({now_ + best, i, -1 - side, ball.turns, 0});
}

void PlainBilliard::search(int i) {
  const std::array<int, 3> cell = balls_[i].cell;
  const int layers = dimension_ == 3 ? 27 : 9;
  for (int c = 0; c < layers; ++c) {
    std::array<int, 3> near{};
    int rest = c;
    for (int k = 0; k < dimension_; ++k, rest /= 3) {
      near[k] = (cell[k] + rest % 3 - 1 + cells_) % cells_;
    }
    for (const int j : members_[cell_index(near)]) {
      if (j != i) search_pair(i, j);
    }
  }
  search_crossing(i);
}

void PlainBilliard::cross(int i, int axis, bool up) {
  Ball& ball = balls_[i];
  move(ball, now_);
  remove(i);
  ball.cell[axis] += up ? 1 : -1;
  if (ball.cell[axis] == cells_ || ball.cell[axis] < 0) {
    ball.cell[axis] = up ? 0 : cells_ - 1;
    ball.x[axis] += up ? -side_ : side_;
    ball.folds[axis] += up ? 1 : -1;
  }
  put(i);
  ++ball.turns;
  search(i);
}

PlainCollision PlainBilliard::collide(const Event& event) {
  Ball &a = balls_[event.i], &b = balls_[event.j];
  move(a, now_);
  move(b, now_);
  const std::array<double, 3> d = offset(a, b);
  PlainCollision told{now_, event.i, event.j, {}, {}, {}};
  for (int k = 0; k < dimension_; ++k) {
    const int near = static_cast<int>(std::lround((d[k] - (b.x[k] - a.x[k])) / side_));
    told.image[k] = near + a.folds[k] - b.folds[k];
  }
  const std::array<double, 3> w{b.v[0] - a.v[0], b.v[1] - a.v[1], b.v[2] - a.v[2]};
  const double q = dot(w, d) / dot(d, d);
  for (int k = 0; k < dimension_; ++k) {
    a.v[k] += q * d[k];
    b.v[k] -= q * d[k];
  }
  told.vi = a.v;
  told.vj = b.v;
  ++a.turns;
  ++b.turns;
  search(event.i);
  search(event.j);
  return told;
}

void PlainBilliard::run(std::int64_t collisions,
                        const std::function<void(const PlainCollision&)>& tell) {
  while (collisions > 0 && !queue_.empty()) {
    const Event event = queue_.top();
    queue_.pop();
    if (balls_[event.i].turns != event.turns_i) continue;
    if (event.j >= 0 && balls_[event.j].turns != event.turns_j) continue;
    now_ = event.t;
    if (event.j < 0) {
      const int side = -1 - event.j;
      cross(event.i, side / 2, side % 2 == 1);
      continue;
    }
    PlainCollision told = collide(event);
    if (told.i > told.j) {
      std::swap(told.i, told.j);
      std::swap(told.vi, told.vj);
      for (int& k : told.image) k = -k;
    }
    tell(told);
    --collisions;
  }
}

}  // namespace voroproof::bench
