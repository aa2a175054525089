#include "library/box_parts.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace voroproof::internal {
namespace {

using Kind = BoxPart::Kind;

// The nearest number in an interval depends on all three by factors of 1 at most, and not on a
// number that is certainly outside.
DoubleBall clamped(const DoubleBall& x, const DoubleBall& low, const DoubleBall& high) {
  if (lower(x) >= upper(high)) return high;
  if (upper(x) <= lower(low)) return low;
  return {std::clamp(x.mid, low.mid, high.mid), std::max({x.rad, low.rad, high.rad})};
}

class Splitter {
 public:
  explicit Splitter(const BallBox& box) : box_(box) {}

  void split(const ConicArc& arc, double from, double to, int halvings) {
    BoxPart part = part_of(arc, from, to);
    if (part.kind == Kind::unclear && halvings > 0 && !is_fine_) {
      const auto [first, second] = arc.halves();
      const double half = (from + to) / 2;
      split(first, from, half, halvings - 1);
      split(second, half, to, halvings - 1);
      return;
    }
    const bool goes_on = !parts_.empty() && part.kind != Kind::unclear &&
                         parts_.back().kind == part.kind && parts_.back().side == part.side;
    if (goes_on) {
      parts_.back().to = to;
    } else {
      parts_.push_back(part);
    }
  }

  std::vector<BoxPart>&& take() { return std::move(parts_); }

 private:
  // The triangle of the control points holds the arc, and a distance from a side or from the box is
  // greatest at one of them.
  BoxPart part_of(const ConicArc& arc, double from, double to) {
    BoxPart part{from, to, Kind::unclear};
    is_fine_ = !arc.has_proper_ends();
    part.excess = std::numeric_limits<double>::infinity();
    if (!arc.is_proper()) return part;
    const std::array<BallPoint, 3> points = arc.points();
    std::array<std::array<DoubleBall, 3>, BallBox::sides> beyond;
    for (int side = 0; side < BallBox::sides; ++side) {
      for (int k = 0; k < 3; ++k) beyond[side][k] = box_.beyond(side, points[k]);
      const bool is_beyond = std::all_of(beyond[side].begin(), beyond[side].end(),
                                         [](const DoubleBall& b) { return b.mid >= b.rad; });
      if (is_beyond) return {from, to, Kind::outside, side};
    }
    part.excess = 0;
    int crossed = 0;
    for (int side = 0; side < BallBox::sides; ++side) {
      double most = 0;
      for (const DoubleBall& b : beyond[side]) {
        if (!(b.mid <= -b.rad)) most = std::max(most, upper(b));
      }
      if (most == 0) continue;
      part.excess += most;
      part.side = ++crossed == 1 ? side : BoxPart::several;
    }
    if (crossed == 0) return {from, to, Kind::inside};
    judge(part, points, beyond);
    return part;
  }

  // Whether nothing is gained by more halvings.
  void judge(const BoxPart& part, const std::array<BallPoint, 3>& points,
             const std::array<std::array<DoubleBall, 3>, BallBox::sides>& beyond) {
    // Halvings leave no less of the errors than there are at the ends.
    const double blur =
        std::min(points[0].x.rad + points[0].y.rad, points[2].x.rad + points[2].y.rad);
    const double slack = std::max(box_.size * 0x1p-51, 2 * blur);
    if (!(part.excess <= slack)) return;
    const bool is_along =
        part.side != BoxPart::several &&
        std::all_of(beyond[part.side].begin(), beyond[part.side].end(),
                    [&](const DoubleBall& b) { return std::fabs(b.mid) <= 2 * slack; });
    const auto near = [&](const BallPoint& a, const BallPoint& b) {
      return std::fabs(a.x.mid - b.x.mid) + std::fabs(a.y.mid - b.y.mid) <= 4 * slack;
    };
    is_fine_ = is_along || (near(points[0], points[1]) && near(points[1], points[2]));
  }

  const BallBox& box_;
  bool is_fine_ = false;  // the part looked at last
  std::vector<BoxPart> parts_;
};

}  // namespace

void require_area(const Box& box) {
  const auto& [low, high] = box;
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  if (!(high[0] > low[0] && high[1] > low[1] && std::isfinite(size))) {
    throw std::invalid_argument("box: no area");
  }
  for (const double x : {low[0], low[1], high[0], high[1]}) {
    if (std::fabs(x) > 1e100) throw std::invalid_argument("box: beyond 1e100 in magnitude");
  }
}

BallBox::BallBox(const Box& box, const Vec2& origin) {
  const auto from_origin = [&](double x, int axis) {
    return DoubleBall(x) - DoubleBall(origin[axis]);
  };
  low = {from_origin(box.low[0], 0), from_origin(box.low[1], 1)};
  high = {from_origin(box.high[0], 0), from_origin(box.high[1], 1)};
  size = (box.high[0] - box.low[0]) + (box.high[1] - box.low[1]);
}

DoubleBall BallBox::beyond(int side, const BallPoint& p) const {
  switch (side) {
    case 0:
      return low.x - p.x;
    case 1:
      return p.x - high.x;
    case 2:
      return low.y - p.y;
    default:
      return p.y - high.y;
  }
}

BallPoint BallBox::nearest(const BallPoint& p) const {
  return {clamped(p.x, low.x, high.x), clamped(p.y, low.y, high.y)};
}

DoubleBall BallBox::along(int side, const BallPoint& from, const BallPoint& to) {
  switch (side) {
    case 0:
      return from.y - to.y;
    case 1:
      return to.y - from.y;
    case 2:
      return to.x - from.x;
    default:
      return from.x - to.x;
  }
}

std::vector<BoxPart> box_parts(const ConicArc& arc, const BallBox& box) {
  constexpr int most_halvings = 50;  // parameters are multiples of 2^-50
  Splitter splitter(box);
  splitter.split(arc, 0, 1, most_halvings);
  return splitter.take();
}

}  // namespace voroproof::internal
