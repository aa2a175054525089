// The event queue beside an ordered set.
#include "kinetic/queue.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

namespace voroproof::internal::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(EventQueue, EmptyAtFirst) {
  EventQueue queue(3);
  EXPECT_EQ(queue.key(queue.top()), kInfinity);
  queue.set(2, 5);
  EXPECT_EQ(queue.top(), 2);
  queue.set(2, kInfinity);
  EXPECT_EQ(queue.key(queue.top()), kInfinity);
}

TEST(EventQueue, EqualKeysByItem) {
  EventQueue queue(100);
  for (int item = 99; item >= 0; --item) queue.set(item, 1);
  for (int item = 0; item < 100; ++item) {
    ASSERT_EQ(queue.top(), item);
    queue.set(item, kInfinity);
  }
}

// The queue is used as a run uses it: keys only come later than what has been taken, but for some
// that come earlier than what waits. Every third queue has few distinct keys.
TEST(EventQueue, TakesItemsInOrder) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const int items = 1 + static_cast<int>(random() % 2000);
    const bool coarse = trial % 3 == 0;
    EventQueue queue(items);
    std::set<std::pair<double, int>> model;
    double now = 0;
    const auto set = [&](int item, double key) {
      model.erase({queue.key(item), item});
      queue.set(item, key);
      if (key < kInfinity) model.insert({key, item});
    };
    const auto some_key = [&] {
      if (random() % 5 == 0) return kInfinity;
      const double ahead = std::exponential_distribution<double>(0.2)(random);
      return now + (coarse ? std::floor(ahead) : ahead);
    };
    for (int item = 0; item < items; ++item) set(item, some_key());
    for (int step = 0; step < 5000 && !model.empty(); ++step) {
      ASSERT_EQ(queue.top(), model.begin()->second) << trial << " " << step;
      ASSERT_EQ(queue.key(queue.top()), model.begin()->first);
      now = model.begin()->first;
      set(queue.top(), some_key());
      for (int k = 0; k < 3; ++k) set(static_cast<int>(random() % items), some_key());
    }
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
