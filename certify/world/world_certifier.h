// The certifier of worlds: histories of disks that pass through each other, hide, appear, change
// places, jump, come and go, in a round frame or in the plane.
//
// All motion is rational between changes of the scene, so that every time is a rational or a root
// of a polynomial over the rationals, and every decision is exact. The claims are replayed; what
// has to happen is found by the certifier itself, at exact times, and no claimed time tells it what
// to conclude.
//
// To be proved (the words are those of docs/certificate.md; a diagram is that of the *visible*
// disks, those not hidden by a larger one - of equal ones by that of the smaller id - and not
// outside of the frame; "just after" is at all times after the instant and near enough):
//
//  1. Start. The initial diagram is a triangulation of the sphere by the frame and some disks that
//     are there. All their cells are proved just after 0, as in 6. Each other disk has a host.
//     With fewer than two visible disks it has no edges; the visible one is found.
//  2. Visible disks (Lemma S). A cell is star-shaped around its centre, whatever overlaps, and a
//     disk has a cell unless a single other one hides it. So from two visible disks on all edges
//     hang together, and each cell has two at least: a triangulation is all there is to tell.
//     Where the diagram of some disks is proved, all of them have cells; so nothing but the hosts
//     of the others has to be looked at.
//  3. Life of an edge. From just after the instant of its birth both in-circle functions are not
//     negative; the first time after which one is negative (or both vanish for a while, the edge is
//     a point, and the rule of the largest id is against it) is found, and an instant. The
//     functions change their signs at roots of one polynomial only, while tangencies are positive.
//     The edge is gone when that instant is left, or the history is refuted.
//  4. Life of a pair. The first time at which the tangency of two neighbours vanishes is an
//     instant, whatever happens there. Lemma T: if a visible disk comes into another, or touches it
//     from inside, or becomes one with it, the tangency with some neighbour vanishes. (Otherwise
//     the limits of its cells contain a neighbourhood of its centre, where it is nearest; but one
//     that contains it is as near everywhere; and of two that are one, the cells do not overlap.)
//  5. Hidden life. A hidden disk has a visible host or the frame; the first time after which it is
//     not inside any more is an instant. Then it has another host (no event), or has a cell.
//     Hosts that are hidden, turn, jump or go are replaced likewise.
//  6. An instant with flips and turns alone: flipped edges are points then, and not legal just
//     after; all edges with other names or other motion are legal just after (Lemmas 6.2, 6.5).
//     Any other instant (patch lemma): each cell whose edges changed, whose disk jumped or touches
//     a neighbour, and each neighbour of such a disk before or after, is proved at a rational time
//     before the next instant: its tangencies are positive, its vertices have circles, and it winds
//     once. All other cells have the same edges before and after, all tangencies around them are
//     positive at the instant, and nothing around them jumps; so their vertices move continuously
//     and they still wind once. All edges are legal between the instant and that time, by 3. So
//     the diagram is right at that time (Lemma 6.1), and backwards in time up to the instant
//     (Lemma 6.4). How the steps led there does not matter: those of jumps are not judged.
//  7. Hide. The tangency of g and j vanishes at the instant and g is in j just after it (also where
//     it touches it from inside for a while); the cell of g has two edges, one with j. Then without
//     g the diagram is that of the others, since a cell leaves its place to its neighbours.
//     Towards a vertex (Lemma H: just before, the cell lies along the ray from its centre away from
//     that of j): edges of g without length flip first, legal or not.
//  8. Appear. g is hidden before, its tangency with j, not the smaller, vanishes and is positive
//     just after. That no other disk hides g, and that the edge is the right one, follows from 6.
//  9. Swap. Two disks that stay, both visible or one in the other, are one at the instant, neither
//     turns and no third one that stays is there. Just before and after both are M + (t - c) W and
//     M - (t - c) W near it: the mirror image exchanges the names. It must be told, once, unless
//     steps of a jump have hidden both, or one by a third. If one of two turns that are apart
//     before and after, or three are one: undecided. If one turns that is in the other or comes to
//     be in it, the inner one has no cell, and the names change where it becomes the outer one.
//     At the instant of a jump any two that are one may be told, once, to change places: its steps
//     may lead to where they have each other's, and the cells around are proved.
// 10. Jump, turn. All of the scene's, up to the horizon and at it, are told once, at their times,
//     with their values where any are told, and no others are.
// 11. Plane (Lemma N). The generator -1 is infinity. At one time the signs of all predicates are
//     those of a round frame that is large enough, so that 6 holds. As circles are not bounded,
//     the existence of each is followed like an in-circle function (it is that of infinity).
// 12. Order and times. Each event is one of the instant that is open; an instant is left only when
//     nothing of it is missing, and the next is the first at which anything can happen. So events
//     are in the order of their exact times; those of one instant in any order that can be
//     replayed. Each claimed time is within the tolerance of the exact one.
// 13. End. Nothing happens between the last event and the horizon, the horizon included; motion is
//     thought to go on beyond it. The counts are those of the lines.
// 14. Doubles. Where all signs of 3, 4 and 11 that are asked for are certain in doubles with error
//     bounds, these tell them, over windows of time: a window in which a polynomial has one sign
//     has no root of it. An edge whose two functions, certainly positive before, certainly fall at
//     one root, its generators being apart, and its circles one, is a point there (6), unless the
//     scene changes something at that instant. Times are enclosures, and exact where these overlap.
//
// A history that stops is undecided, if nothing is missing before.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/world/world_verdict.h"
#include "exact/rational.h"
#include "history/world_history.h"

namespace voroproof::internal {

class WorldReplay;

class WorldCertifier {
 public:
  // `initial`: canonical, each edge once. `go_on` is asked now and then; where it says no, the
  // verdict is undecided. `filters`: doubles decide where they can; the verdict is the same
  // without.
  WorldCertifier(const World& world, const std::vector<Quad>& initial,
                 Rational tolerance = default_tolerance(), std::function<bool()> go_on = {},
                 bool filters = true);
  ~WorldCertifier();
  WorldCertifier(const WorldCertifier&) = delete;
  WorldCertifier& operator=(const WorldCertifier&) = delete;

  // The next line. Those after the verdict is known are ignored.
  void event(const WorldEvent& event, std::int64_t line);
  bool is_decided() const { return verdict_.has_value(); }

  WorldVerdict finish(const WorldEnd& end, std::int64_t line = 0);
  WorldVerdict finish(const WorldStop& stop, std::int64_t line = 0);

  static Rational default_tolerance() { return {1, 1000000}; }

 private:
  template <class Work>
  void judge(std::int64_t line, const Work& work);
  void take(const WorldEvent& event);
  void leave(const std::string& why_not);
  void conclude(Verdict kind, std::int64_t line, std::string reason);

  std::unique_ptr<WorldReplay> replay_;
  Rational horizon_, tolerance_;
  std::function<bool()> go_on_;
  WorldCounts counts_;
  double last_ = 0;  // the instant that was open last
  std::optional<WorldVerdict> verdict_;
};

}  // namespace voroproof::internal
