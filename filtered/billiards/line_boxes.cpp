#include "filtered/billiards/line_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filtered/billiards/number_kinds.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_sides = 0x1p29;
// More than what a few operations round away.
constexpr double share = 0x1p-48;

double upper(const DoubleBall& x) { return (x.mid + x.rad) * (1 + share); }

}  // namespace

LineBoxes::LineBoxes(const Billiard& billiard, const BilliardGaps<DoubleBall>& gaps)
    : billiard_(billiard), gaps_(gaps), fall_alike_(billiard.last_wall() == 0) {
  for (std::size_t k = 0; k < 3; ++k) sides_[k] = billiard.lattice.sides[k].get_d();
  drift_ = Rational(billiard.lattice.shear * billiard.lattice.sides[1]).get_d();
  for (const BilliardDisk& disk : billiard.disks) fall_alike_ = fall_alike_ && !disk.fixed;
}

void LineBoxes::extend(SweptBox& box, GenId disk, const Flight<DoubleBall>& flight,
                       const DoubleBall& from, const DoubleBall& to) const {
  const double radius = std::max(upper(gaps_.radius(disk, from)), upper(gaps_.radius(disk, to)));
  const bool falls = !billiard_.disks[static_cast<std::size_t>(disk)].fixed && !fall_alike_;
  const double passed = to.mid - from.mid + to.rad + from.rad;
  for (const DoubleBall* t : {&from, &to}) {
    Vector3<DoubleBall> x = gaps_.place(disk, flight, *t);
    if (fall_alike_) x = x - gaps_.fall(*t);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // A parabola is within |g| h^2 / 8 of its chord.
      const double fall = falls ? std::fabs(gaps_.gravity()[axis].mid) * passed * passed / 4 : 0;
      const double around = radius + x[axis].rad + fall;
      const double pad = share * (std::fabs(x[axis].mid) + around);
      box.lo[axis] = std::min(box.lo[axis], x[axis].mid - around - pad);
      box.hi[axis] = std::max(box.hi[axis], x[axis].mid + around + pad);
    }
  }
}

void LineBoxes::require_near(GenId disk, const SweptBox& box, double to) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double drift = axis == 0 ? std::fabs(drift_ * to) : 0;
    const double far = std::max(std::fabs(box.lo[axis]), std::fabs(box.hi[axis])) + drift;
    if (!(far < infinity) || (sides_[axis] > 0 && !(far < most_sides * sides_[axis])))
      throw Undecided("a disk is farther out than images are counted", disk, disk);
  }
}

bool LineBoxes::may_meet_wall(GenId id, const SweptBox& box, double from, double to) const {
  if (billiard_.round) {
    // All corners of the box are inside.
    double far2 = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double c = billiard_.round->center[k].get_d();
      const double far =
          std::max(std::fabs(box.lo[k] - c), std::fabs(box.hi[k] - c)) + share * std::fabs(c);
      far2 += far * far;
      size += std::fabs(c);
    }
    const double radius = billiard_.round->radius.get_d();
    return !(std::sqrt(far2) * (1 + share) + share * size < radius * (1 - share));
  }
  const BilliardWall& wall = billiard_.walls[static_cast<std::size_t>(-1 - id)];
  double least = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = wall.normal[k].get_d();
    const double a = n * box.lo[k], b = n * box.hi[k];
    least += std::min(a, b);
    size += std::fabs(a) + std::fabs(b);
  }
  const double offset = wall.offset.get_d(), speed = wall.speed.get_d();
  const double high = offset + std::max(speed * from, speed * to);
  size += std::fabs(offset) + std::fabs(speed * from) + std::fabs(speed * to);
  return !(least - share * size > high);
}

std::string name_of(const Billiard& billiard, const BilliardPair& pair) {
  const std::string ball = billiard.dimension == 3 ? "ball " : "disk ";
  if (pair.a < 0) {
    const std::string frame = billiard.round ? "the frame" : "wall " + std::to_string(pair.a);
    return ball + std::to_string(pair.b) + " and " + frame;
  }
  std::string text = ball + std::to_string(pair.a) + " and " + ball + std::to_string(pair.b);
  if (pair.image == LatticeImage{}) return text;
  text += " at image [";
  for (int k = 0; k < billiard.dimension; ++k) {
    text += (k ? "," : "") + std::to_string(pair.image[static_cast<std::size_t>(k)]);
  }
  return text + "]";
}

std::optional<BilliardPair> find_overlap_at_start(const Billiard& billiard) {
  const BilliardGaps<Rational> exact(billiard);
  const BilliardGaps<DoubleBall> near(billiard);
  const LineBoxes lines(billiard, near);
  const auto flight_of = [&](GenId i) {
    const BilliardDisk& disk = billiard.disks[static_cast<std::size_t>(i)];
    return Flight<Rational>{0, disk.center, disk.velocity};
  };
  const auto overlap = [&](const BilliardPair& pair) {
    const Flight<Rational> b = flight_of(pair.b);
    return exact.form(pair, pair.a < 0 ? b : flight_of(pair.a), b, 0, 0)[0] < 0;
  };
  const DoubleBall start(0);
  std::vector<SweptBox> boxes;
  for (std::size_t i = 0; i < billiard.disks.size(); ++i) {
    const auto disk = static_cast<GenId>(i);
    SweptBox box = empty_box();
    lines.extend(box, disk, {start, enclosed(billiard.disks[i].center), {}}, start, start);
    lines.require_near(disk, box, 0);
    boxes.push_back(box);
    for (GenId wall = billiard.last_wall(); wall < 0; ++wall) {
      if (lines.may_meet_wall(wall, box, 0, 0) && overlap({wall, disk})) return {{wall, disk}};
    }
  }
  const auto pairs = NearBoxes(billiard).pairs(boxes, 0, 0);
  if (!pairs) throw Undecided("too many images of disks meet at the start", 0, 0);
  for (const BilliardPair& pair : *pairs) {
    if (overlap(pair)) return pair;
  }
  return std::nullopt;
}

std::pair<std::string, std::string> placement_fault(const Billiard& billiard,
                                                    const BilliardPair& pair) {
  const std::string field = "disks[" + std::to_string(pair.b) + "]",
                    names = name_of(billiard, pair);
  if (pair.a < 0)
    return {field, "is not wholly inside of " + names.substr(names.find(" and ") + 5)};
  return {field, "overlaps: " + names + " are at a distance below the sum of their radii"};
}

}  // namespace voroproof::internal
