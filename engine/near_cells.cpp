#include "engine/near_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voroproof::internal {

namespace {

// In widths of a square: how far a centre may be beyond its square, and what doubles may err by.
constexpr double kMargin = 1.0 / 256;
constexpr double kError = 1.0 / 4096;
// Two disks that touch are at most two radii apart. Where their squares share no corner their
// centres are apart by more than 1 - 2 (kMargin + kError) widths in one coordinate.
constexpr double kLeastWidth = 2.03;  // in radii of the largest disk
// More disks than these in a square on the average make it a detour.
constexpr double kMostDisks = 16;
constexpr int kMostSide = 4096;

}  // namespace

NearCells::NearCells(const Motion& motion) : motion_(motion) {
  const int n = motion.size();
  double rmax = 0;
  for (GenId g = 0; g < n; ++g) rmax = std::max(rmax, motion.doubles(g).r);
  const DoubleMotion& wall = motion.doubles(container_id);
  const double radius = -wall.r;
  const double wanted = std::max(kLeastWidth * rmax, 2 * radius / std::sqrt(1.0 + n));
  side_ = static_cast<int>(std::clamp(2 * radius / wanted, 1.0, double{kMostSide}));
  width_ = 2 * radius / side_;
  x0_ = wall.x - radius;
  y0_ = wall.y - radius;
  const double size = std::fabs(wall.x) + std::fabs(wall.y) + radius;
  possible_ = n < kMostDisks * side_ * side_ && width_ > kLeastWidth * rmax * (1 - 0x1p-40) &&
              size * 0x1p-45 < kError * width_;
  if (!possible_) return;
  head_.assign(std::size_t(side_) * side_, -1);
  links_.resize(n);
  cell_.assign(n, -1);
  mark_wall(rmax);
}

// Whether the farthest corner of a square, its margin included, is within a disk's radius of the
// container.
void NearCells::mark_wall(double rmax) {
  wall_.assign(head_.size(), 0);
  const double radius = 0.5 * width_ * side_;
  for (int y = 0; y < side_; ++y) {
    for (int x = 0; x < side_; ++x) {
      const double fx = std::fabs((x + 0.5) * width_ - radius) + width_ * (0.5 + 2 * kMargin);
      const double fy = std::fabs((y + 0.5) * width_ - radius) + width_ * (0.5 + 2 * kMargin);
      wall_[std::size_t(y) * side_ + x] = std::hypot(fx, fy) + rmax > radius ? 1 : 0;
    }
  }
}

int NearCells::coordinate(double offset) const {
  return static_cast<int>(std::clamp(offset / width_, 0.0, side_ - 1.0));
}

int NearCells::place(GenId g, double t) {
  const DoubleMotion& m = motion_.doubles(g);
  const double dt = t - m.t;
  const int cell = coordinate(m.y + m.vy * dt - y0_) * side_ + coordinate(m.x + m.vx * dt - x0_);
  const int before = cell_[g];
  if (cell == before) return before;
  Link& link = links_[g];
  if (before >= 0) {
    if (link.next >= 0) links_[link.next].previous = link.previous;
    (link.previous >= 0 ? links_[link.previous].next : head_[before]) = link.next;
  }
  link = {head_[cell], -1};
  if (link.next >= 0) links_[link.next].previous = g;
  head_[cell] = g;
  cell_[g] = cell;
  return before;
}

double NearCells::leaves(GenId g, double t) const {
  const DoubleMotion& m = motion_.doubles(g);
  const double speed = std::fabs(m.vx) + std::fabs(m.vy);
  // Through a square, its margins included, a disk goes for less than 3 widths / speed.
  if (!(m.ex + (m.ev + speed * 0x1p-50) * (std::fabs(t) + 3 * width_ / speed) < kError * width_) &&
      speed > 0) {
    throw Undecided("a place is not known well");
  }
  // No square ends where the lattice does.
  const auto delay = [&](double at, double v, int cell) {
    constexpr double never = std::numeric_limits<double>::infinity();
    if (v > 0) return cell == side_ - 1 ? never : ((cell + 1 + kMargin) * width_ - at) / v;
    if (v < 0) return cell == 0 ? never : ((cell - kMargin) * width_ - at) / v;
    return never;
  };
  const double dt = t - m.t;
  const double x = delay(m.x + m.vx * dt - x0_, m.vx, cell_[g] % side_);
  const double y = delay(m.y + m.vy * dt - y0_, m.vy, cell_[g] / side_);
  return t + std::max(0.0, std::min(x, y));
}

double NearCells::rate_of_leaving() const {
  double speeds = 0;
  for (GenId g = 0; g < motion_.size(); ++g) {
    const DoubleMotion& m = motion_.doubles(g);
    speeds += std::fabs(m.vx) + std::fabs(m.vy);
  }
  return speeds / width_;
}

}  // namespace voroproof::internal
