// The event queue: items with keys that are raised and lowered in place. Every item has at most one
// entry, so there are no stale ones (paper, Lemma 6 and after).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "engine/moving_bound.h"

namespace voroproof::internal {

// Items are 0 .. items-1, at least one. A key is a time that the item's next event does not
// precede; an item without one has the key infinity. Equal keys are ordered by item.
//
// Only items with keys before a bound are in a heap: see MovingBound.
class EventQueue {
 public:
  explicit EventQueue(int items)
      : key_(items, std::numeric_limits<double>::infinity()), place_(items, kWaits) {}

  // The item with the least key.
  int top() {
    if (heap_.empty()) refill();
    return heap_.empty() ? 0 : heap_[0].item;
  }
  double key(int item) const { return key_[item]; }
  // Items whose time is near, or -1: at 0 the one with the least key, at 1 to 4 those of which one
  // is the next after it.
  int near(std::size_t place) const { return place < heap_.size() ? heap_[place].item : -1; }
  // Asks for the memory of the item and the one after it.
  [[gnu::always_inline]] void prefetch(int item) const {
    __builtin_prefetch(&key_[item]);
    __builtin_prefetch(&place_[item]);
  }
  void set(int item, double key) {
    const int at = place_[item];
    const double old = key_[item];
    key_[item] = key;
    if (at == kWaits) {
      if (key < bound_.value()) push({key, item});
    } else if (!(key < bound_.value())) {
      remove(at);
    } else if (key < old) {
      rise(at, {key, item});
    } else if (old < key) {
      sink(at, {key, item});
    }
  }

 private:
  static constexpr int kArity = 4;
  static constexpr int kWaits = -1;  // the place of an item that is not in the heap

  // Key and item side by side: siblings share a cache line.
  struct Entry {
    double key;
    int item;
    // The comparison has no branch: of two keys either may be the smaller.
    bool operator<(const Entry& other) const {
      return bool(int(key < other.key) | (int(key == other.key) & int(item < other.item)));
    }
  };

  void refill() {
    bound_.move(key_, [this] {
      gather();
      return heap_.size();
    });
  }

  // Makes a heap of the items with keys before the bound; it is empty so far.
  void gather() {
    each_before(key_, bound_.value(), [this](std::size_t k) {
      heap_.push_back({key_[k], static_cast<int>(k)});
    });
    const int size = static_cast<int>(heap_.size());
    for (int at = 0; at < size; ++at) place_[heap_[at].item] = at;
    for (int at = (size - 2) / kArity; at >= 0 && size > 1; --at) sink(at, Entry(heap_[at]));
  }

  void push(const Entry& entry) {
    heap_.push_back(entry);
    rise(static_cast<int>(heap_.size()) - 1, entry);
  }
  void remove(int at) {
    place_[heap_[at].item] = kWaits;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (at == static_cast<int>(heap_.size())) return;
    if (at > 0 && last < heap_[(at - 1) / kArity]) {
      rise(at, last);
    } else {
      sink(at, last);
    }
  }
  void put(int at, const Entry& entry) {
    heap_[at] = entry;
    place_[entry.item] = at;
  }
  void rise(int at, const Entry& entry) {
    while (at > 0) {
      const int parent = (at - 1) / kArity;
      if (!(entry < heap_[parent])) break;
      put(at, heap_[parent]);
      at = parent;
    }
    put(at, entry);
  }
  void sink(int at, const Entry& entry) {
    const int size = static_cast<int>(heap_.size());
    for (;;) {
      const int first = kArity * at + 1;
      if (first >= size) break;
      const int last = first + kArity < size ? first + kArity : size;
      int best = first;
      for (int child = first + 1; child < last; ++child) {
        best = heap_[child] < heap_[best] ? child : best;
      }
      if (!(heap_[best] < entry)) break;
      put(at, heap_[best]);
      at = best;
    }
    put(at, entry);
  }

  std::vector<double> key_;
  std::vector<int> place_;  // in the heap
  std::vector<Entry> heap_;
  MovingBound bound_;  // bound on the heap's keys
};

}  // namespace voroproof::internal
