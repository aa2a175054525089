// The connected components of a graph of nodes that changes a little at a time, at the cost of what
// changes: of two parts that fall apart only the smaller is walked through, and where they do not,
// only as far as the way around what was cut.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "library/queries/clearance.h"

namespace voroproof::internal {

class ChangingComponents {
 public:
  using Node = ClearanceNode;
  using Id = std::size_t;
  using Marks = std::set<std::size_t>;

  // A node that is added several times is there until it is removed as often, its links before it.
  void add(const Node& node);
  void remove(const Node& node);
  // Two nodes may be linked several times.
  void link(const Node& a, const Node& b);
  void cut(const Node& a, const Node& b);

  // The component of a node, if that is there.
  std::optional<Id> of(const Node& node) const;
  const Node& smallest(Id component) const { return *components_.at(component).nodes.begin(); }

  // Parts inherit the marks of what they were parts of; what joins has those of both. A new node
  // has none.
  const Marks& marks(Id component) const { return components_.at(component).marks; }
  void mark(Id component, const Marks& also);
  void mark_anew(Id component, std::size_t mark) { components_.at(component).marks = {mark}; }

  // The components that were marked or are not what they were since the last call, as far as they
  // are still there, by their smallest nodes.
  std::vector<Id> take_touched();

 private:
  struct Place {
    int times = 0;  // added and not removed
    Id component = 0;
    std::vector<Node> links;
  };
  struct Component {
    std::set<Node> nodes;
    Marks marks;
  };

  std::vector<Node> side_cut_off(const Node& a, const Node& b) const;

  std::map<Node, Place> places_;
  std::map<Id, Component> components_;
  std::set<Id> touched_;
  Id next_ = 0;
};

}  // namespace voroproof::internal
