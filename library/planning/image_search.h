// Which images of a disk in a periodic box may be near another disk.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "exact/billiard.h"
#include "exact/vector3.h"
#include "library/planning/least_distance.h"

namespace voroproof::internal {

// A box that has the offset of the second disk from the first: bounds along each axis.
struct OffsetBox {
  Vector3<double> low, high;
};

class ImageSearch {
 public:
  // `sides`: rounded up, zero where an axis is not periodic. `height`: of the third coordinate,
  // where only those count that differ by less there. `go_on` is asked now and then; where it says
  // no, Interrupted is thrown. Undecided is thrown where images are too far away, or too many.
  ImageSearch(const Vector3<double>& sides, const std::optional<Rational>& height,
              std::function<bool()> go_on);

  // Calls visit(image) for all images of the second disk that may be within `near` of the first, or
  // be the nearest where there is none. `box` has the offset at all times. Where that is longer
  // than some sides the offset's way is looked at in parts: `points` gives its Bernstein
  // coefficients; none where there is no such time.
  template <class Points, class Visit>
  void each(const OffsetBox& box, const std::optional<double>& near, Points&& points,
            Visit&& visit) const {
    if (is_short(box)) {
      each_in(range(box, near), visit);
      return;
    }
    std::set<LatticeImage> images;
    if (std::vector<Ball3> all = points(); !all.empty())
      collect(std::move(all), near, max_halvings, images);
    for (const LatticeImage& image : images) visit(image);
  }

 private:
  static constexpr int max_halvings = 30;
  static constexpr std::size_t max_images = 1 << 20;
  struct Range {
    LatticeImage first{}, last{};
  };
  bool is_short(const OffsetBox& box) const;
  Range range(const OffsetBox& box, const std::optional<double>& near) const;
  template <class Visit>
  void each_in(const Range& range, Visit&& visit) const {
    LatticeImage image;
    for (image[0] = range.first[0]; image[0] <= range.last[0]; ++image[0]) {
      for (image[1] = range.first[1]; image[1] <= range.last[1]; ++image[1]) {
        require_patience();
        for (image[2] = range.first[2]; image[2] <= range.last[2]; ++image[2]) visit(image);
      }
    }
  }
  void collect(std::vector<Ball3> points, const std::optional<double>& near, int halvings,
               std::set<LatticeImage>& images) const;
  void require_patience() const;

  Vector3<double> sides_;
  std::optional<double> height_;
  std::function<bool()> go_on_;
};

}  // namespace voroproof::internal
