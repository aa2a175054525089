#include "library/queries/changing_components.h"

#include <algorithm>
#include <array>
#include <utility>

namespace voroproof::internal {

void ChangingComponents::add(const Node& node) {
  Place& place = places_[node];
  if (place.times++ > 0) return;
  place.component = next_++;
  components_[place.component].nodes.insert(node);
  touched_.insert(place.component);
}

void ChangingComponents::remove(const Node& node) {
  const auto at = places_.find(node);
  if (--at->second.times > 0) return;
  components_.erase(at->second.component);
  touched_.erase(at->second.component);
  places_.erase(at);
}

void ChangingComponents::link(const Node& a, const Node& b) {
  Place &at_a = places_.at(a), &at_b = places_.at(b);
  at_a.links.push_back(b);
  at_b.links.push_back(a);
  Id more = at_a.component, less = at_b.component;
  if (more == less) return;
  if (components_[more].nodes.size() < components_[less].nodes.size()) std::swap(more, less);
  for (const Node& node : components_[less].nodes) places_.at(node).component = more;
  components_[more].nodes.merge(components_[less].nodes);
  components_[more].marks.merge(components_[less].marks);
  components_.erase(less);
  touched_.erase(less);
  touched_.insert(more);
}

void ChangingComponents::cut(const Node& a, const Node& b) {
  const auto forget = [this](const Node& from, const Node& to) {
    std::vector<Node>& links = places_.at(from).links;
    links.erase(std::find(links.begin(), links.end(), to));
  };
  forget(a, b);
  forget(b, a);
  const std::vector<Node> side = side_cut_off(a, b);
  if (side.empty()) return;
  const Id old = places_.at(a).component, part = next_++;
  Component& rest = components_[old];
  Component& cut_off = components_[part];
  cut_off.marks = rest.marks;
  for (const Node& node : side) {
    cut_off.nodes.insert(rest.nodes.extract(node));
    places_.at(node).component = part;
  }
  touched_.insert({old, part});
}

// The nodes that can be reached from one of the two if the other cannot be. Both sides are walked
// through by turns, and the one that is finished first is returned. Nothing if they are connected.
std::vector<ChangingComponents::Node> ChangingComponents::side_cut_off(const Node& a,
                                                                       const Node& b) const {
  struct Front {
    std::vector<Node> reached;  // in order
    std::set<Node> known;
    std::size_t next = 0;
  };
  std::array<Front, 2> fronts{Front{{a}, {a}, 0}, Front{{b}, {b}, 0}};
  if (a == b) return {};
  for (std::size_t turn = 0;; turn = 1 - turn) {
    Front& front = fronts[turn];
    if (front.next == front.reached.size()) return std::move(front.reached);
    const Node node = front.reached[front.next++];
    for (const Node& other : places_.at(node).links) {
      if (fronts[1 - turn].known.contains(other)) return {};
      if (front.known.insert(other).second) front.reached.push_back(other);
    }
  }
}

std::optional<ChangingComponents::Id> ChangingComponents::of(const Node& node) const {
  const auto at = places_.find(node);
  if (at == places_.end()) return std::nullopt;
  return at->second.component;
}

void ChangingComponents::mark(Id component, const Marks& also) {
  components_.at(component).marks.insert(also.begin(), also.end());
  touched_.insert(component);
}

std::vector<ChangingComponents::Id> ChangingComponents::take_touched() {
  std::vector<Id> touched(touched_.begin(), touched_.end());
  touched_.clear();
  std::sort(touched.begin(), touched.end(),
            [this](Id a, Id b) { return smallest(a) < smallest(b); });
  return touched;
}

}  // namespace voroproof::internal
