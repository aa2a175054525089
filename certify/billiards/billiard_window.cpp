#include "certify/billiards/billiard_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/billiards/true_path.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

MeetingPairs::MeetingPairs(const Billiard& billiard, const BilliardGaps<DoubleBall>& gaps)
    : billiard_(billiard), gaps_(gaps), lines_(billiard, gaps), near_(billiard) {}

template <class Path>
SweptBox MeetingPairs::box_of(GenId disk, const Path& path, const BilliardTime& from,
                              const BilliardTime& to) {
  SweptBox box = empty_box();
  const auto is_before = [](const DoubleBall& x, const DoubleBall& y) {
    return sign(x - y) == Sign::negative;
  };
  for (std::size_t k = 0; k < path.size(); ++k) {
    const DoubleBall &start = path[k].near.t0,
                     &begin = is_before(start, from.near) ? from.near : start;
    const bool ends_before = k + 1 < path.size() && !is_before(to.near, path[k + 1].near.t0);
    const DoubleBall& end = ends_before ? path[k + 1].near.t0 : to.near;
    SweptBox& of_line = line_boxes_.emplace_back(empty_box());
    if (is_before(end, begin) || is_before(to.near, begin)) continue;
    lines_.extend(of_line, disk, path[k].near, begin, end);
    extend(box, of_line);
  }
  lines_.require_near(disk, box, to.near.mid);
  return box;
}

// How long the disks take, on the mean, for a part of the way between neighbours.
template <class Path>
void MeetingPairs::measure(const std::vector<Path>& paths, const BilliardTime& to) {
  double speeds = 0, moving = 0, fastest = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Vector3<DoubleBall> v = gaps_.velocity(static_cast<GenId>(i), paths[i].back().near, to.near);
    if (lines_.fall_alike()) v = v - gaps_.gravity() * to.near;
    const double speed = std::hypot(v[0].mid, v[1].mid, v[2].mid);
    speeds += speed;
    moving += speed > 0;
    fastest = std::max(fastest, speed);
  }
  SweptBox all = empty_box();
  for (const SweptBox& box : boxes_) extend(all, box);
  double volume = 1, least_side = infinity;
  const int dimension = billiard_.dimension;
  for (int k = 0; k < dimension; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    const double side = lines_.side(axis);
    if (side > 0) least_side = std::min(least_side, side);
    volume *= side > 0 ? side : all.hi[axis] - all.lo[axis];
  }
  const double spacing = std::pow(
      volume / static_cast<double>(std::max<std::size_t>(paths.size(), 1)), 1.0 / dimension);
  good_length_ = moving > 0 ? spacing / 2 / (speeds / moving) : infinity;
  // No disk runs past all of its images many times, nor do images beside it.
  fastest = std::max(fastest, std::fabs(lines_.drift()));
  if (fastest > 0) good_length_ = std::min(good_length_, 4 * least_side / fastest);
  const double g = std::sqrt(dot(billiard_.gravity, billiard_.gravity).get_d());
  if (g > 0 && !lines_.fall_alike()) good_length_ = std::min(good_length_, std::sqrt(spacing / g));
  if (!(good_length_ > 0)) good_length_ = infinity;
}

void MeetingPairs::adapt(std::size_t pairs) {
  const std::size_t n = billiard_.disks.size();
  constexpr double least = 0x1p-6, most = 0x1p1000;
  if (pairs > 8 * n + 64 || near_.compared() > 64 * n + 512) {
    stretch_ = std::max(least, stretch_ / 2);
  } else if (pairs <= 4 * n + 16 && near_.compared() <= 32 * n + 64) {
    stretch_ = std::min(most, stretch_ * 2);
  }
}

template <class Path>
void MeetingPairs::make_boxes(const std::vector<Path>& paths, const BilliardTime& from,
                              const BilliardTime& to) {
  boxes_.clear();
  line_boxes_.clear();
  first_line_.clear();
  from_ = from.near.mid - from.near.rad;
  to_ = to.near.mid + to.near.rad;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    first_line_.push_back(line_boxes_.size());
    boxes_.push_back(box_of(static_cast<GenId>(i), paths[i], from, to));
  }
}

// The pairs of disks that may meet. A window in which disks run past many images is split.
template <class Path>
void MeetingPairs::add_disks(const std::vector<Path>& paths, const BilliardTime& from,
                             const BilliardTime& to, int splits, std::vector<BilliardPair>& pairs) {
  make_boxes(paths, from, to);
  splits_ = splits > 0;
  const auto found = near_.pairs(boxes_, from_, to_);
  if (found) {
    pairs.insert(pairs.end(), found->begin(), found->end());
    return;
  }
  constexpr int most_splits = 40;
  if (splits == most_splits) throw Undecided("a disk runs past too many images of others", 0, 0);
  const BilliardTime middle{CompactRational(Rational((from.value() + to.value()) / 2))};
  add_disks(paths, from, middle, splits + 1, pairs);
  add_disks(paths, middle, to, splits + 1, pairs);
}

bool MeetingPairs::may_meet(const BilliardPair& pair, std::size_t line_a,
                            std::size_t line_b) const {
  if (pair.a < 0) return true;
  const SweptBox& a = line_boxes_[first_line_[static_cast<std::size_t>(pair.a)] + line_a];
  SweptBox b = line_boxes_[first_line_[static_cast<std::size_t>(pair.b)] + line_b];
  near_.shift(b, pair.image, from_, to_);
  return meet(a, b);
}

template <class Path>
std::vector<BilliardPair> MeetingPairs::in(const std::vector<Path>& paths, const BilliardTime& from,
                                           const BilliardTime& to) {
  std::vector<BilliardPair> pairs;
  good_length_ = infinity;
  if (billiard_.last_wall() == 0 && paths.size() < 2) return pairs;
  if (paths.size() > 1) add_disks(paths, from, to, 0, pairs);
  if (paths.size() < 2 || splits_) make_boxes(paths, from, to);
  for (GenId wall = billiard_.last_wall(); wall < 0; ++wall) {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (lines_.may_meet_wall(wall, boxes_[i], from_, to_))
        pairs.push_back({wall, static_cast<GenId>(i)});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  measure(paths, to);
  return pairs;
}

template std::vector<BilliardPair> MeetingPairs::in(const std::vector<BilliardPath>&,
                                                    const BilliardTime&, const BilliardTime&);
template std::vector<BilliardPair> MeetingPairs::in(const std::vector<TruePath>&,
                                                    const BilliardTime&, const BilliardTime&);

}  // namespace voroproof::internal
