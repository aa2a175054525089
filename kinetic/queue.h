// The event queue: a heap of items with keys that move up and down in place. Every
// item has at most one entry, so there are no stale ones (paper, Lemma 6 and after).
#pragma once

#include <limits>
#include <vector>

namespace voroproof {

// Items are 0 .. items-1. A key is a time that the item's next event does not precede; an
// item without one has the key infinity. Equal keys are ordered by item.
class EventQueue {
 public:
  explicit EventQueue(int items)
      : key_(items, std::numeric_limits<double>::infinity()), place_(items), heap_(items) {
    for (int i = 0; i < items; ++i) heap_[i] = place_[i] = i;
  }

  int top() const { return heap_[0]; }
  double key(int item) const { return key_[item]; }
  void set(int item, double key) {
    const double old = key_[item];
    key_[item] = key;
    if (key < old) {
      rise(place_[item]);
    } else if (old < key) {
      sink(place_[item]);
    }
  }

 private:
  static constexpr int arity = 4;

  bool before(int a, int b) const { return key_[a] < key_[b] || (key_[a] == key_[b] && a < b); }
  void rise(int at) {
    const int item = heap_[at];
    while (at > 0) {
      const int parent = (at - 1) / arity;
      if (!before(item, heap_[parent])) break;
      heap_[at] = heap_[parent];
      place_[heap_[at]] = at;
      at = parent;
    }
    heap_[at] = item;
    place_[item] = at;
  }
  void sink(int at) {
    const int item = heap_[at];
    const int size = static_cast<int>(heap_.size());
    for (;;) {
      const int first = arity * at + 1;
      if (first >= size) break;
      const int last = first + arity < size ? first + arity : size;
      int best = first;
      for (int child = first + 1; child < last; ++child) {
        if (before(heap_[child], heap_[best])) best = child;
      }
      if (!before(heap_[best], item)) break;
      heap_[at] = heap_[best];
      place_[heap_[at]] = at;
      at = best;
    }
    heap_[at] = item;
    place_[item] = at;
  }

  std::vector<double> key_;
  std::vector<int> place_;
  std::vector<int> heap_;
};

}  // namespace voroproof
