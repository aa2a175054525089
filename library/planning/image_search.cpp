#include "library/planning/image_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/patience.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {

ImageSearch::ImageSearch(const Vector3<double>& sides, const std::optional<Rational>& height,
                         std::function<bool()> go_on)
    : sides_(sides), go_on_(std::move(go_on)) {
  if (height) height_ = round_up(*height);
}

void ImageSearch::require_patience() const {
  if (!go_on_()) throw Interrupted();
}

bool ImageSearch::is_short(const OffsetBox& box) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (sides_[axis] != 0 && box.high[axis] - box.low[axis] > 4 * sides_[axis]) return false;
  }
  return true;
}

// Within half a side lies the nearest; one more on each side allows for all roundings.
ImageSearch::Range ImageSearch::range(const OffsetBox& box,
                                      const std::optional<double>& near) const {
  Range range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double side = sides_[axis];
    if (side == 0) continue;
    const bool by_height = near && axis == 2 && height_;
    const double reach = by_height ? *height_ / side : near ? *near / side : 0.5;
    const double low = box.low[axis] / side, high = box.high[axis] / side;
    constexpr double farthest = 1 << 30;
    if (!(std::fabs(low) + reach < farthest && std::fabs(high) + reach < farthest))
      throw Undecided("two disks are farther apart than images are counted");
    range.first[axis] = static_cast<int>(std::floor(-reach - high - 1e-6));
    range.last[axis] = static_cast<int>(std::ceil(reach - low + 1e-6));
  }
  return range;
}

// By de Casteljau's subdivision.
void ImageSearch::collect(std::vector<Ball3> points, const std::optional<double>& near,
                          int halvings, std::set<LatticeImage>& images) const {
  require_patience();
  OffsetBox box;
  bool is_short = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::numeric_limits<double>::infinity();
    box.high[axis] = -box.low[axis];
    double error = 0;
    for (const Ball3& p : points) {
      box.low[axis] = std::min(box.low[axis], low(p[axis]));
      box.high[axis] = std::max(box.high[axis], -low(-p[axis]));
      error = std::max(error, p[axis].rad);
    }
    // Halves of what is as short as its errors are no shorter.
    if (sides_[axis] != 0 && box.high[axis] - box.low[axis] > std::max(sides_[axis], 8 * error))
      is_short = false;
  }
  if (halvings == 0 || is_short) {
    each_in(range(box, near), [&](const LatticeImage& image) { images.insert(image); });
    if (images.size() > max_images)
      throw Undecided("two disks run past more images than are looked at");
    return;
  }
  std::vector<Ball3> first;
  for (std::size_t left = points.size(); left > 0; --left) {
    first.push_back(points.front());
    for (std::size_t k = 0; k + 1 < left; ++k)
      points[k] = (points[k] + points[k + 1]) * DoubleBall(0.5);
  }
  collect(std::move(first), near, halvings - 1, images);
  collect(std::move(points), near, halvings - 1, images);
}

}  // namespace voroproof::internal
