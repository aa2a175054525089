// The event queue, and that of entries that get stale, beside ordered sets.
#include "engine/queue.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/waiting_queue.h"

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

// ---- The queue of entries that get stale. ----

struct Entry {
  double key;
  int item, version;
  bool operator<(const Entry& o) const { return key > o.key; }
};

// Items have new versions now and then, which makes their entries stale. Every entry that is not is
// taken in the order of the keys, none before its time and none twice.
TEST(WaitingQueue, TakesWhatIsNotStaleInOrder) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 30; ++trial) {
    const int items = 1 + static_cast<int>(random() % 300);
    const bool coarse = trial % 3 == 0;
    std::vector<int> version(items, 0);
    const auto is_stale = [&](const Entry& e) { return version[e.item] != e.version; };
    WaitingQueue<Entry> queue;
    std::multiset<std::tuple<double, int, int>> model;
    double now = 0;
    const auto push = [&](int item) {
      const double ahead = std::exponential_distribution<double>(0.1)(random);
      const double key = now + (coarse ? std::floor(ahead) : ahead);
      queue.push({key, item, version[item]});
      model.insert({key, item, version[item]});
    };
    const auto renew = [&](int item) {
      ++version[item];
      std::erase_if(model, [&](const auto& e) { return std::get<1>(e) == item; });
    };
    EXPECT_EQ(queue.top(is_stale), nullptr);
    for (int item = 0; item < items; ++item) push(item);
    int taken = 0;
    for (int step = 0; step < 5000; ++step) {
      const Entry* head = queue.top(is_stale);
      while (head != nullptr && is_stale(*head)) {
        queue.pop();
        head = queue.top(is_stale);
      }
      ASSERT_EQ(head == nullptr, model.empty()) << trial << " " << step;
      if (head == nullptr) break;
      now = head->key;
      ASSERT_EQ(now, std::get<0>(*model.begin())) << trial << " " << step;
      const auto found = model.find({head->key, head->item, head->version});
      ASSERT_NE(found, model.end());
      model.erase(found);
      queue.pop();
      ++taken;
      for (int k = static_cast<int>(random() % 4); k > 0; --k) {
        const int item = static_cast<int>(random() % items);
        if (random() % 3 == 0) renew(item);
        push(item);
      }
    }
    EXPECT_GT(taken, 0);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
