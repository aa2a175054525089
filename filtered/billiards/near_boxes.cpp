#include "filtered/billiards/near_boxes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace voroproof::internal {
namespace {

// More than what moving a box by a few sides rounds away.
constexpr double share = 0x1p-48;

bool meet(const SweptBox& a, const SweptBox& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.lo[k] > b.hi[k] || b.lo[k] > a.hi[k]) return false;
  }
  return true;
}

LatticeImage plus(const LatticeImage& a, const LatticeImage& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
LatticeImage minus(const LatticeImage& a) { return {-a[0], -a[1], -a[2]}; }

constexpr double most_cells = 64;  // a box in more is compared with all others

}  // namespace

NearBoxes::NearBoxes(const Billiard& billiard)
    : drift_(Rational(billiard.lattice.shear * billiard.lattice.sides[1]).get_d()),
      axes_(static_cast<std::size_t>(billiard.dimension)) {
  for (std::size_t k = 0; k < 3; ++k) sides_[k] = billiard.lattice.sides[k].get_d();
}

// Moves it by so many sides, by as much as that is at any time of the window.
void NearBoxes::shift(Copy& copy, const LatticeImage& by, double from, double to) const {
  for (std::size_t k = 0; k < axes_; ++k) {
    double lo = by[k] * sides_[k], hi = lo, size = std::fabs(lo);
    if (k == 0 && by[1] != 0 && drift_ != 0) {
      const double a = by[1] * drift_ * from, b = by[1] * drift_ * to;
      lo += std::min(a, b);
      hi += std::max(a, b);
      size += std::fabs(a) + std::fabs(b);
    }
    if (lo == 0 && hi == 0) continue;
    const double pad =
        share * (size + std::fabs(copy.box.lo[k]) + std::fabs(copy.box.hi[k]) + sides_[k]);
    copy.box.lo[k] += lo - pad;
    copy.box.hi[k] += hi + pad;
  }
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
  all_ = copies_.empty() ? SweptBox{} : copies_.front().box;
  for (const Copy& copy : copies_) {
    for (std::size_t k = 0; k < 3; ++k) {
      all_.lo[k] = std::min(all_.lo[k], copy.box.lo[k]);
      all_.hi[k] = std::max(all_.hi[k], copy.box.hi[k]);
    }
  }
}

// All images, but the folded disk itself, that meet the box of all. The first axis comes last:
// images along the second one drift along it.
void NearBoxes::add_images(double from, double to) {
  for (const std::size_t k : {std::size_t{2}, std::size_t{1}, std::size_t{0}}) {
    if (sides_[k] == 0) continue;
    const std::size_t so_far = copies_.size();
    for (std::size_t i = 0; i < so_far; ++i) {
      const SweptBox& box = copies_[i].box;
      const double first = std::floor((all_.lo[k] - box.hi[k]) / sides_[k]) - 1;
      const double last = std::ceil((all_.hi[k] - box.lo[k]) / sides_[k]) + 1;
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
}

// As long as the half of all boxes are: these are in few cells.
void NearBoxes::choose_cells() {
  std::vector<double> extents;
  for (const Copy& copy : copies_) {
    double extent = 0;
    for (std::size_t k = 0; k < axes_; ++k) {
      extent = std::max(extent, copy.box.hi[k] - copy.box.lo[k]);
    }
    extents.push_back(extent);
  }
  cell_ = 0;
  if (!extents.empty()) {
    const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
    std::nth_element(extents.begin(), middle, extents.end());
    cell_ = *middle;
  }
  buckets_ = std::bit_ceil(2 * copies_.size() + 1);
}

// The first cell and the last one of a box; none where they are too many.
std::optional<std::array<NearBoxes::Cell, 2>> NearBoxes::cells_of(const SweptBox& box) const {
  std::array<Cell, 2> range{};
  double covered = 1;
  for (std::size_t k = 0; k < axes_; ++k) {
    // Monotonic in the coordinate, so that boxes that meet share a cell.
    const double lo = std::floor((box.lo[k] - all_.lo[k]) / cell_);
    const double hi = std::floor((box.hi[k] - all_.lo[k]) / cell_);
    covered *= hi - lo + 1;
    // Written so that no number is more than covered: neither for a cell of size 0.
    if (!(covered <= most_cells) || !(std::fabs(lo) < 0x1p52) || !(std::fabs(hi) < 0x1p52))
      return std::nullopt;
    range[0][k] = static_cast<std::int64_t>(lo);
    range[1][k] = static_cast<std::int64_t>(hi);
  }
  return range;
}

std::size_t NearBoxes::bucket(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t x : cell) {
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

// Those that share a bucket, in the bucket of the first cell that they share only.
void NearBoxes::compare_in_buckets(std::vector<BilliardPair>& pairs) {
  for (std::size_t k = 0; k + 1 < begins_.size(); ++k) {
    for (std::size_t i = begins_[k]; i < begins_[k + 1]; ++i) {
      for (std::size_t j = i + 1; j < begins_[k + 1]; ++j) {
        const std::size_t c = members_[i], d = members_[j];
        const Cell &at = (*ranges_[c])[0], &of = (*ranges_[d])[0];
        const Cell first{std::max(at[0], of[0]), std::max(at[1], of[1]), std::max(at[2], of[2])};
        if (bucket(first) == k) compare(c, d, pairs);
      }
    }
  }
}

// Counts, or stores, which copies are in which bucket.
void NearBoxes::sort_into_buckets() {
  const auto each_cell = [&](std::size_t c, auto&& visit) {
    if (!ranges_[c]) return;
    const auto& [first, last] = *ranges_[c];
    for (std::int64_t z = first[2]; z <= last[2]; ++z) {
      for (std::int64_t y = first[1]; y <= last[1]; ++y) {
        for (std::int64_t x = first[0]; x <= last[0]; ++x) visit(bucket({x, y, z}));
      }
    }
  };
  ranges_.clear();
  for (const Copy& copy : copies_) ranges_.push_back(cells_of(copy.box));
  begins_.assign(buckets_ + 1, 0);
  for (std::size_t c = 0; c < copies_.size(); ++c) {
    each_cell(c, [&](std::size_t k) { ++begins_[k + 1]; });
  }
  for (std::size_t k = 1; k < begins_.size(); ++k) begins_[k] += begins_[k - 1];
  members_.resize(begins_.back());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (std::size_t c = 0; c < copies_.size(); ++c) {
    each_cell(c, [&](std::size_t k) { members_[next[k]++] = c; });
  }
}

std::vector<BilliardPair> NearBoxes::pairs(const std::vector<SweptBox>& boxes, double from,
                                           double to) {
  fold(boxes, from, to);
  add_images(from, to);
  choose_cells();
  sort_into_buckets();
  compared_ = 0;
  std::vector<BilliardPair> pairs;
  compare_in_buckets(pairs);
  for (std::size_t c = 0; c < copies_.size(); ++c) {
    if (ranges_[c]) continue;  // else it is large, and compared with all
    for (std::size_t d = 0; d < copies_.size(); ++d) {
      if (d != c && (ranges_[d] || c < d)) compare(c, d, pairs);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace voroproof::internal
