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
  explicit EventQueue(int items) : place_(items), heap_(items) {
    for (int i = 0; i < items; ++i) {
      heap_[i] = {std::numeric_limits<double>::infinity(), i};
      place_[i] = i;
    }
  }

  int top() const { return heap_[0].item; }
  double key(int item) const { return heap_[place_[item]].key; }
  void set(int item, double key) {
    const int at = place_[item];
    const double old = heap_[at].key;
    if (key < old) {
      rise(at, {key, item});
    } else if (old < key) {
      sink(at, {key, item});
    }
  }

 private:
  static constexpr int arity = 4;

  // Key and item side by side: siblings share a cache line.
  struct Entry {
    double key;
    int item;
    // Without a branch: of two keys either may be the smaller.
    bool operator<(const Entry& other) const {
      return bool(int(key < other.key) | (int(key == other.key) & int(item < other.item)));
    }
  };

  void put(int at, const Entry& entry) {
    heap_[at] = entry;
    place_[entry.item] = at;
  }
  void rise(int at, const Entry& entry) {
    while (at > 0) {
      const int parent = (at - 1) / arity;
      if (!(entry < heap_[parent])) break;
      put(at, heap_[parent]);
      at = parent;
    }
    put(at, entry);
  }
  void sink(int at, const Entry& entry) {
    const int size = static_cast<int>(heap_.size());
    for (;;) {
      const int first = arity * at + 1;
      if (first >= size) break;
      const int last = first + arity < size ? first + arity : size;
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

  std::vector<int> place_;
  std::vector<Entry> heap_;
};

}  // namespace voroproof
