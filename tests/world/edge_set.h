// A diagram as the set of its edges, and nothing else: how the events of a world change it.
//
// Half-edges. An edge [l,r,s,e] is two half-edges, one for each of its names. That of [l,r,s,e]
// runs in the dual from l to r, has the vertex [l,r,e] on its left, and is found by (l,r|e); s is
// its value. No diagram has two vertices of one name, so that l, r and e determine s. The vertex
// [l,r,e] has three half-edges on its inside: (l,r|e), (r,e|l), (e,l|r).
//
// Events, on the edges by any of their names:
//
//   flip [l,r,s,e], s and e different:
//     goes:    [l,r,s,e]
//     comes:   [s,e,r,l]
//     changes: [r,e,x,l] to [r,e,x,s], [e,l,x,r] to [e,l,x,s],
//              [l,s,x,r] to [l,s,x,e], [s,r,x,l] to [s,r,x,e]
//   hide [g,j], g with two neighbours a and b, one of them j:
//     goes:    [g,a,b,b], [g,b,a,a], [a,b,x,g], [b,a,y,g]
//     comes:   [a,b,x,y]
//     With g and another disk only all edges go. A lone disk that hides changes no edge.
//   appear [g,j] at [j,k,s,e]: the inverse of the above
//     goes:    [j,k,s,e]
//     comes:   [j,k,s,g], [j,k,g,e], [g,j,k,k], [g,k,j,j]
//     Without `at` the disk is the only one, or there is one other disk a, and these come:
//              [a,g,-1,-1], [-1,a,g,g], [-1,g,a,a]
//   swap [i,j]: i is called j and j is called i in all edges.
//   turn: nothing.
//   jump: the steps of `out`, after which g is not visible, and then those of `in`. Where at most
//     one other disk is visible after `out`, the hide of g may be left out: all edges go. At 0,
//     where the first diagram is that after it, it has neither list.
#pragma once

#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include "exact/generators.h"
#include "exact/world_events.h"

namespace voroproof::internal::testing {

// An event that no diagram of these edges can have.
class ImpossibleEvent : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class EdgeSet {
 public:
  // `lone` is a visible disk that has no edge, if there is one. Throws ImpossibleEvent where the
  // edges are not the sides of triangles.
  explicit EdgeSet(const std::vector<Quad>& edges, const std::set<GenId>& lone = {});

  // All throw ImpossibleEvent.
  void apply(const WorldEvent& event);
  void apply(const Step& step);
  void flip(const Quad& q);
  void hide(const Hide& h);
  void appear(const Appear& a);
  void swap(GenId i, GenId j);
  void jump(const Jump& jump);

  std::vector<Quad> edges() const;  // by canonical names, sorted
  const std::set<GenId>& visible() const { return visible_; }
  bool operator==(const EdgeSet&) const = default;

 private:
  using Key = std::array<GenId, 3>;

  GenId value(const Key& key) const;
  void insert(const Quad& q);
  void erase(const Quad& q);
  void set_left(const Key& key, GenId left);

  std::map<Key, GenId> half_edges_;
  std::set<GenId> visible_;
};

// Names as in a history: `flip [0,1,2,3]`, `hide [1,0]`, and so on.
std::string text(const Quad& q);
std::string text(const Step& step);
std::string text(const WorldEvent& event);

}  // namespace voroproof::internal::testing
