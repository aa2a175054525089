#include "certify/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filtered/numbers/next_double.h"

namespace voroproof::internal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMostCells = 1024;  // per row of the grid

// Bounds of a ball: one rounding to nearest, and one double further.
double below(const DoubleBall& b) { return next_below(b.mid - b.rad); }
double above(const DoubleBall& b) { return next_above(b.mid + b.rad); }

}  // namespace

bool NearPairs::Box::meets(const Box& other) const {
  return lo[0] <= other.hi[0] && other.lo[0] <= hi[0] && lo[1] <= other.hi[1] &&
         other.lo[1] <= hi[1];
}

void NearPairs::assign(double t) {
  const auto disks = static_cast<std::size_t>(motion_.size());
  const DoubleMotion& container = motion_.doubles(container_id);
  const double radius = std::fabs(container.r);
  side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(disks))), 1, kMostCells);
  size_ = 2 * radius / side_;
  low_[0] = container.x - radius;
  low_[1] = container.y - radius;
  cells_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), {});
  windows_.assign(disks, {});
  seen_.assign(disks, 0);
  for (GenId g = 0; g < motion_.size(); ++g) watch(g, t, t);
  for (GenId g = 0; g < motion_.size(); ++g) begin(g, t, t);
}

// The disk is on a line, so that the hull of where it is at both ends holds it in between.
NearPairs::Box NearPairs::box(GenId g, double from, double to) const {
  const DoubleMotion& m = motion_.doubles(g);
  const DoubleBall r(m.r, m.ex);
  Box b{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const double t : {from, to}) {
    const Site<DoubleBall> at = motion_.site(g, DoubleBall(t));
    const DoubleBall* const centre[2] = {&at.x, &at.y};
    for (const int axis : {0, 1}) {
      const double lo = below(*centre[axis] - r), hi = above(*centre[axis] + r);
      // Coordinates beyond the doubles may be anywhere.
      b.lo[axis] = std::isfinite(lo) ? std::min(b.lo[axis], lo) : -kInfinity;
      b.hi[axis] = std::isfinite(hi) ? std::max(b.hi[axis], hi) : kInfinity;
    }
  }
  return b;
}

// The column or row of a coordinate. It never falls as x grows, roundings included, so that boxes
// that meet have a cell in common.
int NearPairs::cell(double x, int axis) const {
  const double index = std::floor((x - low_[axis]) / size_);
  return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(side_ - 1)));
}

template <class Visit>
void NearPairs::each_cell(const Window& w, Visit&& visit) {
  for (int row = w.first[1]; row <= w.last[1]; ++row) {
    for (int column = w.first[0]; column <= w.last[0]; ++column) {
      visit(cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                   static_cast<std::size_t>(column)]);
    }
  }
}

void NearPairs::watch(GenId g, double from, double to) {
  Window& w = windows_[static_cast<std::size_t>(g)];
  w.begin = from;
  w.end = to;
  w.box = box(g, from, to);
  for (const int axis : {0, 1}) {
    w.first[axis] = cell(w.box.lo[axis], axis);
    w.last[axis] = cell(w.box.hi[axis], axis);
  }
  each_cell(w, [g](std::vector<GenId>& in) { in.push_back(g); });
}

void NearPairs::forget(GenId g) {
  each_cell(windows_[static_cast<std::size_t>(g)], [g](std::vector<GenId>& in) {
    *std::find(in.begin(), in.end(), g) = in.back();
    in.pop_back();
  });
}

void NearPairs::begin(GenId g, double t, double least_end) {
  const DoubleMotion& m = motion_.doubles(g);
  // So long that the disk moves by a cell, or by its own radius: the box stays about as large as
  // the disk, and is not made anew too often.
  const double way = std::max(size_, m.r), speed = std::hypot(m.vx, m.vy);
  const double end = std::max(least_end, std::min(t + way / speed, horizon_));
  forget(g);
  watch(g, t, end);
  endings_.push({end, g});
}

void NearPairs::extend(double t) {
  for (GenId g = 0; g < motion_.size(); ++g) {
    if (end_of(g) >= t) continue;
    const double since = begin_of(g);
    forget(g);
    watch(g, since, t);
    endings_.push({t, g});
  }
}

std::optional<GenId> NearPairs::first_to_end_before(double t) {
  while (!endings_.empty()) {
    const auto [end, g] = endings_.top();
    if (end >= t) break;
    if (end == end_of(g)) return g;
    endings_.pop();
  }
  return std::nullopt;
}

double NearPairs::since(GenId i, GenId j) const {
  return i == container_id ? begin_of(j) : std::max(begin_of(i), begin_of(j));
}

std::vector<NearPairs::Pair> NearPairs::around(GenId g) {
  std::vector<Pair> pairs{{container_id, g, begin_of(g)}};
  ++search_;
  seen_[static_cast<std::size_t>(g)] = search_;
  const Window& w = windows_[static_cast<std::size_t>(g)];
  each_cell(w, [&](const std::vector<GenId>& in) {
    for (const GenId other : in) {
      long& seen = seen_[static_cast<std::size_t>(other)];
      if (seen == search_) continue;
      seen = search_;
      if (!w.box.meets(windows_[static_cast<std::size_t>(other)].box)) continue;
      const auto [i, j] = std::minmax(g, other);
      pairs.push_back({i, j, since(i, j)});
    }
  });
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
  return pairs;
}

std::vector<NearPairs::Pair> NearPairs::all() {
  std::vector<Pair> pairs;
  for (GenId g = 0; g < motion_.size(); ++g) {
    for (const Pair& p : around(g)) {
      if (p.i == container_id || p.i == g) pairs.push_back(p);
    }
  }
  return pairs;
}

}  // namespace voroproof::internal
