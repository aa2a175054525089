// The meetings that are predicted for the disks of a billiard, in order of time.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "engine/billiard/meeting_time.h"
#include "filtered/billiards/billiard_gaps.h"

namespace voroproof::internal {

// -1, 0, 1: whether x is earlier than y, the same, or later. Throws MoreBits where balls do not
// tell.
template <class T>
int time_order(const T& x, const DoubleBall& near_x, const T& y, const DoubleBall& near_y) {
  const Sign rough = sign(near_x - near_y);
  if (is_certain(rough)) return rough == Sign::negative ? -1 : 1;
  const Sign exact = sign(T(x - y));
  if (exact == Sign::unknown)
    throw MoreBits("which of two events comes first is not told: they may be simultaneous");
  return static_cast<int>(exact);
}

template <class T>
struct Meeting {
  T t;
  DoubleBall near;
  BilliardPair pair;
};

// One meeting of a pair at most.
template <class T>
class MeetingQueue {
 public:
  // Empty, for so many disks.
  void clear(std::size_t disks) {
    meetings_.clear();
    of_disk_.assign(disks, {});
  }

  // The same meeting may be found from either disk.
  void add(Meeting<T> meeting) {
    const auto& known = of_disk_[static_cast<std::size_t>(meeting.pair.b)];
    const auto is_same = [&](const auto& place) { return place->pair == meeting.pair; };
    if (std::any_of(known.begin(), known.end(), is_same)) return;
    const auto place = meetings_.insert(std::move(meeting)).first;
    for (const GenId i : {place->pair.a, place->pair.b}) {
      if (i >= 0) of_disk_[static_cast<std::size_t>(i)].push_back(place);
    }
  }

  // Those of a disk that turns. They are to be gone before others are found: one that is found anew
  // may be at the same time.
  void drop(GenId i) {
    for (const auto place : of_disk_[static_cast<std::size_t>(i)]) {
      const GenId other = place->pair.a == i ? place->pair.b : place->pair.a;
      if (other >= 0) std::erase(of_disk_[static_cast<std::size_t>(other)], place);
      meetings_.erase(place);
    }
    of_disk_[static_cast<std::size_t>(i)].clear();
  }

  // The earliest; at one time that of the smallest pair. Null where there is none. Throws MoreBits
  // where balls do not tell which it is.
  const Meeting<T>* first() const {
    auto first = meetings_.begin();
    if (first == meetings_.end()) return nullptr;
    for (auto other = std::next(first); other != meetings_.end(); ++other) {
      if (low(*other) > high(*first)) break;
      const int order = time_order(other->t, other->near, first->t, first->near);
      if (order < 0 || (order == 0 && other->pair < first->pair)) first = other;
    }
    return &*first;
  }

 private:
  static double low(const Meeting<T>& meeting) { return meeting.near.mid - meeting.near.rad; }
  // More than the rounding of both bounds.
  static double high(const Meeting<T>& meeting) {
    return (meeting.near.mid + meeting.near.rad) * (1 + 0x1p-50) + DBL_MIN;
  }
  // By when it may be at the earliest: which of two far ones is earlier need not be known.
  struct MayBeEarlier {
    bool operator()(const Meeting<T>& x, const Meeting<T>& y) const {
      return std::pair(low(x), x.pair) < std::pair(low(y), y.pair);
    }
  };
  using Meetings = std::set<Meeting<T>, MayBeEarlier>;

  Meetings meetings_;
  std::vector<std::vector<typename Meetings::iterator>> of_disk_;
};

}  // namespace voroproof::internal
