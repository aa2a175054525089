// Components that follow changes against components found anew.
#include "library/queries/changing_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace voroproof::internal::testing {
namespace {

using Node = ChangingComponents::Node;

Node node(int k) { return far_node(k); }

// The smallest node that can be reached from k.
int smallest_reached(int k, const std::vector<std::pair<int, int>>& links) {
  std::set<int> known{k};
  for (std::size_t before = 0; before != known.size();) {
    before = known.size();
    for (const auto& [a, b] : links) {
      if (known.contains(a) || known.contains(b)) known.insert({a, b});
    }
  }
  return *known.begin();
}

TEST(ChangingComponents, AreThoseFoundAnew) {
  std::mt19937_64 random(1);
  const auto below = [&](std::size_t n) { return static_cast<int>(random() % n); };
  for (const int n : {2, 9, 30}) {
    ChangingComponents components;
    std::vector<int> times(static_cast<std::size_t>(n));
    std::vector<std::pair<int, int>> links;
    for (int step = 0; step < 1500; ++step) {
      const int a = below(static_cast<std::size_t>(n)), b = below(static_cast<std::size_t>(n));
      const bool linked = std::any_of(links.begin(), links.end(),
                                      [&](const auto& l) { return l.first == a || l.second == a; });
      switch (below(5)) {
        case 0:
          components.add(node(a));
          ++times[a];
          break;
        case 1:
          if (times[a] < (linked ? 2 : 1)) break;
          components.remove(node(a));
          --times[a];
          break;
        case 2:
          if (times[a] == 0 || times[b] == 0) break;
          components.link(node(a), node(b));
          links.emplace_back(a, b);
          break;
        default:
          if (links.empty()) break;
          const auto cut = links.begin() + below(links.size());
          components.cut(node(cut->first), node(cut->second));
          links.erase(cut);
      }
      for (int k = 0; k < n; ++k) {
        const auto found = components.of(node(k));
        ASSERT_EQ(found.has_value(), times[k] > 0);
        if (found) {
          ASSERT_EQ(components.smallest(*found), node(smallest_reached(k, links)));
        }
      }
    }
  }
}

TEST(ChangingComponents, PartsInheritMarksAndWholesHaveAll) {
  ChangingComponents components;
  for (const int k : {0, 1, 2, 3, 4}) components.add(node(k));
  for (const int k : {0, 1}) components.link(node(k), node(k + 1));
  components.mark_anew(*components.of(node(0)), 7);
  components.mark_anew(*components.of(node(3)), 8);
  components.take_touched();
  components.cut(node(0), node(1));
  components.link(node(3), node(2));
  components.cut(node(3), node(2));
  const auto marks = [&](int k) { return components.marks(*components.of(node(k))); };
  EXPECT_EQ(marks(0), (ChangingComponents::Marks{7}));
  EXPECT_EQ(marks(1), (ChangingComponents::Marks{7, 8}));
  EXPECT_EQ(marks(3), (ChangingComponents::Marks{7, 8}));
  EXPECT_EQ(marks(4), ChangingComponents::Marks{});
  using Ids = std::vector<ChangingComponents::Id>;
  EXPECT_EQ(components.take_touched(),
            (Ids{*components.of(node(0)), *components.of(node(1)), *components.of(node(3))}));
  EXPECT_EQ(components.take_touched(), Ids{});
}

}  // namespace
}  // namespace voroproof::internal::testing
