// A queue of entries that may get stale.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/moving_bound.h"

namespace voroproof::internal {

// An Entry has a finite `key`; of two the lesser is the one with the greater key, as heaps want it.
template <class Entry>
class WaitingQueue {
 public:
  void push(const Entry& entry) {
    if (entry.key < bound_.value()) {
      heap_.push_back(entry);
      std::push_heap(heap_.begin(), heap_.end());
    } else {
      keys_.push_back(entry.key);
      waiting_.push_back(entry);
    }
  }
  // An entry with the least key, or null. Entries that are stale, by is_stale(), may be left out,
  // or not.
  template <class IsStale>
  const Entry* top(const IsStale& is_stale) {
    while (heap_.empty() && !keys_.empty()) refill(is_stale);
    return heap_.empty() ? nullptr : &heap_.front();
  }
  // Precondition: there was a top() since the last change.
  void pop() {
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
  }

 private:
  template <class IsStale>
  void refill(const IsStale& is_stale) {
    if (keys_.size() > 2 * kept_) {
      for (std::size_t k = keys_.size(); k-- > 0;) {
        if (is_stale(waiting_[k])) remove(k);
      }
      kept_ = keys_.size();
    }
    bound_.move(keys_, [&] {
      before_.clear();
      each_before(keys_, bound_.value(), [this](std::size_t k) { before_.push_back(k); });
      return before_.size();
    });
    for (auto k = before_.rbegin(); k != before_.rend(); ++k) {
      if (!is_stale(waiting_[*k])) heap_.push_back(waiting_[*k]);
      remove(*k);
    }
    before_.clear();
    std::make_heap(heap_.begin(), heap_.end());
  }
  void remove(std::size_t k) {
    keys_[k] = keys_.back();
    keys_.pop_back();
    waiting_[k] = waiting_.back();
    waiting_.pop_back();
  }

  MovingBound bound_;  // bound on the heap's keys
  std::vector<Entry> heap_;
  std::vector<double> keys_;  // keys of those that wait
  std::vector<Entry> waiting_;
  std::vector<std::size_t> before_;  // the memory of refill()
  std::size_t kept_ = 0;             // waited after stale ones were last looked for
};

}  // namespace voroproof::internal
