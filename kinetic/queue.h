// The event queue: items with keys that are raised and lowered in place. Every item has at most one
// entry, so there are no stale ones (paper, Lemma 6 and after).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace voroproof {

// Items are 0 .. items-1, at least one. A key is a time that the item's next event does not
// precede; an item without one has the key infinity. Equal keys are ordered by item.
//
// Most keys change before their time comes: only items with keys before a bound are in a heap, the
// others wait in no order. When the heap is empty the bound moves on to about a sixteenth of the
// finite keys, which a sample tells.
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
  void set(int item, double key) {
    const int at = place_[item];
    const double old = key_[item];
    key_[item] = key;
    if (at == kWaits) {
      if (key < bound_) push({key, item});
    } else if (!(key < bound_)) {
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
    // Without a branch: of two keys either may be the smaller.
    bool operator<(const Entry& other) const {
      return bool(int(key < other.key) | (int(key == other.key) & int(item < other.item)));
    }
  };

  void refill() {
    constexpr std::size_t kSamples = 256;
    sample_.clear();
    const std::size_t stride = std::max<std::size_t>(1, key_.size() / kSamples);
    for (std::size_t k = 0; k < key_.size(); k += stride) {
      if (std::isfinite(key_[k])) sample_.push_back(key_[k]);
    }
    const double least = *std::min_element(key_.begin(), key_.end());
    bound_ = std::nextafter(least, std::numeric_limits<double>::infinity());
    if (!sample_.empty()) {
      const auto sixteenth =
          sample_.begin() + static_cast<std::ptrdiff_t>((sample_.size() - 1) / 16);
      std::nth_element(sample_.begin(), sixteenth, sample_.end());
      bound_ = std::max(bound_, *sixteenth);
    }
    for (std::size_t k = 0; k < key_.size(); ++k) {
      if (key_[k] < bound_) push({key_[k], static_cast<int>(k)});
    }
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
  std::vector<double> sample_;
  double bound_ = -std::numeric_limits<double>::infinity();  // of the heap's keys
};

}  // namespace voroproof
