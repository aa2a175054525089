#include "filtered/billiards/near_boxes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace voroproof::internal {
namespace {

// More than what moving a box by a few sides rounds away.
constexpr double share = 0x1p-48;

LatticeImage plus(const LatticeImage& a, const LatticeImage& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
LatticeImage minus(const LatticeImage& a) { return {-a[0], -a[1], -a[2]}; }

}  // namespace

NearBoxes::NearBoxes(const Billiard& billiard)
    : drift_(Rational(billiard.lattice.shear * billiard.lattice.sides[1]).get_d()),
      axes_(static_cast<std::size_t>(billiard.dimension)) {
  for (std::size_t k = 0; k < 3; ++k) sides_[k] = billiard.lattice.sides[k].get_d();
}

void NearBoxes::shift(SweptBox& box, const LatticeImage& by, double from, double to) const {
  for (std::size_t k = 0; k < axes_; ++k) {
    double lo = by[k] * sides_[k], hi = lo, size = std::fabs(lo);
    if (k == 0 && by[1] != 0 && drift_ != 0) {
      const double a = by[1] * drift_ * from, b = by[1] * drift_ * to;
      lo += std::min(a, b);
      hi += std::max(a, b);
      size += std::fabs(a) + std::fabs(b);
    }
    if (lo == 0 && hi == 0) continue;
    const double pad = share * (size + std::fabs(box.lo[k]) + std::fabs(box.hi[k]) + sides_[k]);
    box.lo[k] += lo - pad;
    box.hi[k] += hi + pad;
  }
}

void NearBoxes::shift(Copy& copy, const LatticeImage& by, double from, double to) const {
  shift(copy.box, by, from, to);
  copy.image = plus(copy.image, by);
}

void NearBoxes::fold(const std::vector<SweptBox>& boxes, double from, double to) {
  copies_.clear();
  // Into the cell of the first disk: only what disks are apart counts, and images far along the
  // second axis drift fast along the first one.
  std::array<double, 3> base{};
  const auto cell = [&](const SweptBox& box, std::size_t k) {
    return std::floor((box.lo[k] / 2 + box.hi[k] / 2) / sides_[k]);
  };
  for (std::size_t k = 0; k < 3 && !boxes.empty(); ++k) {
    if (sides_[k] != 0) base[k] = cell(boxes.front(), k);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Copy copy{boxes[i], static_cast<GenId>(i), {}};
    // The second axis first: it moves the first one.
    for (const std::size_t k : {std::size_t{2}, std::size_t{1}, std::size_t{0}}) {
      if (sides_[k] == 0) continue;
      LatticeImage by{};
      by[k] = -static_cast<int>(std::clamp(cell(copy.box, k) - base[k], -1e9, 1e9));
      if (by[k] != 0) shift(copy, by, from, to);
    }
    copies_.push_back(copy);
  }
  folded_ = copies_.size();
  all_ = empty_box();
  for (const Copy& copy : copies_) extend(all_, copy.box);
}

// All images, but the folded disk itself, that meet the box of all. The first axis comes last:
// images along the second one drift along it. False where they are too many.
bool NearBoxes::add_images(double from, double to) {
  const double most = 64 * static_cast<double>(folded_) + 4096;
  for (const std::size_t k : {std::size_t{2}, std::size_t{1}, std::size_t{0}}) {
    if (sides_[k] == 0) continue;
    const std::size_t so_far = copies_.size();
    for (std::size_t i = 0; i < so_far; ++i) {
      const SweptBox& box = copies_[i].box;
      const double first = std::floor((all_.lo[k] - box.hi[k]) / sides_[k]) - 1;
      const double last = std::ceil((all_.hi[k] - box.lo[k]) / sides_[k]) + 1;
      if (!(static_cast<double>(copies_.size()) + last - first < most)) return false;
      for (double n = first; n <= last; ++n) {
        if (n == 0) continue;
        Copy moved = copies_[i];
        LatticeImage by{};
        by[k] = static_cast<int>(n);
        shift(moved, by, from, to);
        if (moved.box.lo[k] <= all_.hi[k] && moved.box.hi[k] >= all_.lo[k])
          copies_.push_back(moved);
      }
    }
  }
  return true;
}

NearBoxes::Range NearBoxes::cells_of(const SweptBox& box, int level) const {
  Range range{Cell{level, {}}, Cell{level, {}}};
  for (std::size_t k = 0; k < axes_; ++k) {
    // Monotonic in the coordinate, so that boxes that meet share a cell.
    range[0].at[k] = static_cast<std::int64_t>(std::floor(std::ldexp(box.lo[k], -level)));
    range[1].at[k] = static_cast<std::int64_t>(std::floor(std::ldexp(box.hi[k], -level)));
  }
  return range;
}

// A box is in few cells of its level, and its cells there are counted in 52 bits.
void NearBoxes::choose_levels() {
  ranges_.clear();
  levels_.clear();
  for (const Copy& copy : copies_) {
    double extent = 0, far = 0;
    for (std::size_t k = 0; k < axes_; ++k) {
      extent = std::max(extent, copy.box.hi[k] - copy.box.lo[k]);
      far = std::max({far, std::fabs(copy.box.lo[k]), std::fabs(copy.box.hi[k])});
    }
    const int lowest = far > 0 ? std::ilogb(far) - 50 : 0;
    const int level = extent > 0 ? std::max(lowest, std::ilogb(extent) + 1) : lowest;
    ranges_.push_back(cells_of(copy.box, level));
    levels_.push_back(level);
  }
  std::sort(levels_.begin(), levels_.end());
  levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
  buckets_ = std::bit_ceil(2 * copies_.size() + 1);
}

std::size_t NearBoxes::bucket(const Cell& cell) const {
  auto hash = static_cast<std::uint64_t>(cell.level);
  for (const std::int64_t x : cell.at) {
    hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 32U;
  }
  return hash & (buckets_ - 1);
}

// The pair, if one of the two is folded, named as the disks are that are not folded.
void NearBoxes::add(const Copy& a, const Copy& b, std::vector<BilliardPair>& pairs) const {
  if (a.disk >= b.disk || !meet(a.box, b.box)) return;
  // a is moved by a.image, and b by b.image: seen from a, b is at image b.image - a.image.
  pairs.push_back({a.disk, b.disk, plus(b.image, minus(a.image))});
}

void NearBoxes::compare(std::size_t c, std::size_t d, std::vector<BilliardPair>& pairs) {
  ++compared_;
  if (c >= folded_ && d >= folded_) return;
  add(copies_[c], copies_[d], pairs);
  add(copies_[d], copies_[c], pairs);
}

namespace {

template <class Range, class Visit>
void each_cell(const Range& range, Visit&& visit) {
  auto cell = range[0];
  const auto &first = range[0].at, &last = range[1].at;
  for (cell.at[2] = first[2]; cell.at[2] <= last[2]; ++cell.at[2]) {
    for (cell.at[1] = first[1]; cell.at[1] <= last[1]; ++cell.at[1]) {
      for (cell.at[0] = first[0]; cell.at[0] <= last[0]; ++cell.at[0]) visit(cell);
    }
  }
}

}  // namespace

void NearBoxes::sort_into_buckets() {
  begins_.assign(buckets_ + 1, 0);
  for (const Range& range : ranges_) {
    each_cell(range, [&](const Cell& cell) { ++begins_[bucket(cell) + 1]; });
  }
  for (std::size_t k = 1; k < begins_.size(); ++k) begins_[k] += begins_[k - 1];
  members_.resize(begins_.back());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (std::size_t c = 0; c < copies_.size(); ++c) {
    each_cell(ranges_[c], [&](const Cell& cell) { members_[next[bucket(cell)]++] = c; });
  }
}

// Compares it with those of that level, its own or a higher one, in the first cell that they share.
void NearBoxes::compare_in(std::size_t c, int level, std::vector<BilliardPair>& pairs) {
  const bool is_own = level == ranges_[c][0].level;
  const Range range = is_own ? ranges_[c] : cells_of(copies_[c].box, level);
  each_cell(range, [&](const Cell& cell) {
    const std::size_t k = bucket(cell);
    for (std::size_t m = begins_[k]; m < begins_[k + 1]; ++m) {
      const std::size_t d = members_[m];
      const Cell& other = ranges_[d][0];
      if (other.level != level || (is_own && d <= c)) continue;
      bool is_first = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        is_first = is_first && cell.at[axis] == std::max(range[0].at[axis], other.at[axis]);
      }
      if (is_first) compare(c, d, pairs);
    }
  });
}

std::optional<std::vector<BilliardPair>> NearBoxes::pairs(const std::vector<SweptBox>& boxes,
                                                          double from, double to) {
  fold(boxes, from, to);
  if (!add_images(from, to)) return std::nullopt;
  choose_levels();
  sort_into_buckets();
  compared_ = 0;
  std::vector<BilliardPair> pairs;
  for (std::size_t c = 0; c < copies_.size(); ++c) {
    for (auto level = std::lower_bound(levels_.begin(), levels_.end(), ranges_[c][0].level);
         level != levels_.end(); ++level) {
      compare_in(c, *level, pairs);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<BilliardPair> NearBoxes::partners(GenId disk, const std::vector<SweptBox>& boxes,
                                              double from, double to) const {
  std::vector<BilliardPair> found;
  const SweptBox& own = boxes[static_cast<std::size_t>(disk)];
  // Moves the box along the axes from that one down by all sides with which it may meet.
  const auto visit = [&](auto&& self, const Copy& copy, std::size_t k) -> void {
    double first = 0, last = 0;
    if (sides_[k] != 0) {
      first = std::floor((own.lo[k] - copy.box.hi[k]) / sides_[k]);
      last = std::ceil((own.hi[k] - copy.box.lo[k]) / sides_[k]);
    }
    for (double n = first; n <= last; ++n) {
      Copy moved = copy;
      LatticeImage by{};
      by[k] = static_cast<int>(n);
      if (n != 0) shift(moved, by, from, to);
      if (moved.box.lo[k] > own.hi[k] || moved.box.hi[k] < own.lo[k]) continue;
      if (k > 0) {
        self(self, moved, k - 1);
      } else if (meet(moved.box, own)) {
        const bool is_first = disk < copy.disk;
        found.push_back({is_first ? disk : copy.disk, is_first ? copy.disk : disk,
                         is_first ? moved.image : minus(moved.image)});
      }
    }
  };
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    const auto other = static_cast<GenId>(j);
    if (other != disk) visit(visit, Copy{boxes[j], other, {}}, 2);
  }
  return found;
}

}  // namespace voroproof::internal
