// When does a V-edge collapse? The first instant at which the edge with a given
// quadruplet becomes illegal, under the present motion of its four generators.
//
// An edge [l,r,s,e] collapses at a root of the flip polynomial iff both in-circle
// functions, of e in the circle (l,s,r) and of s in the circle (r,e,l), turn from
// positive to negative there and both circles exist: the paper's Move-&-Check and its
// test for shadow flips (sections 4.3 and 5) become signs at a rational time next to
// an isolated root. Five tiers: doubles with an error bound, double-doubles, balls,
// symmetry, exact algebra. Symmetry comes before balls where a collision is in a past.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "filtered/motion/motion.h"
#include "filtered/numbers/stats.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/moment.h"

namespace voroproof::internal {

struct Collapse {
  enum class Kind {
    none,  // the edge does not collapse in (start, lo]
    root,  // it first collapses in [lo, hi], at the only root of its polynomial in `fine`, or
           // without that in [lo, hi]
    now,   // it is illegal just after the instant at which the search starts
  };
  Kind kind = Kind::none;
  double lo = 0, hi = 0;
  // Where neighbouring doubles do not isolate the root.
  std::shared_ptr<const RootInterval> fine;

  // The interval that isolates the root.
  RootInterval root() const {
    return fine ? *fine : RootInterval{to_rational(lo), to_rational(hi)};
  }
  static Collapse none_until(double t);
  static Collapse at_root(const Rational& lo, const Rational& hi);
};

// Narrowing an isolated root did not show what becomes of its edge there.
class RootTooBlurred : public std::runtime_error {
 public:
  RootTooBlurred(const std::string& what, int bits)
      : std::runtime_error(what + ": " + std::to_string(bits) + " bits of its time do not tell") {}
};

class CollapseSearch {
 public:
  CollapseSearch(Motion& motion, TierCounts& counts) : motion_(motion), counts_(counts) {}

  // The first collapse of q after `start`, at which the edge is legal and the flip
  // polynomial has no root (the point just beyond a collapse, say); looks no
  // further than `end` (but may answer `none` with an earlier lo). A search that
  // starts at `fine` instead starts beyond that isolated root.
  Collapse after(const Quad& q, double start, double end, const RootInterval* fine = nullptr);

  // The first collapse of q at or after the instant `now`: the edge is legal just
  // before it, or its motion changes there. Answers `now` when the four generators are
  // cotangent at the instant and the edge is illegal just after it; where the four
  // stay cotangent by the rule of the largest id (docs/formats.md).
  Collapse from(const Quad& q, const Moment& now, double end);

  // One step of the interval Newton method for the flip polynomial in double-doubles: its root in
  // [lo, hi], if there is one; an enclosure inside [lo, hi] proves that there is one and no other.
  // The radius is infinite where the slope may vanish.
  DdBall newton(const Quad& q, double lo, double hi) const;
  // The collapse in [lo, hi] as a double-double; the radius is infinite where the filter cannot
  // say. [lo, hi] has been isolated before.
  DdBall refine(const Quad& q, double lo, double hi) const;
  // The collapse that refine() gives, step by step, each from what the one before has left, until
  // `enough(enclosure)` or double-doubles tell no more.
  template <class Enough>
  DdBall refine_until(const Quad& q, double lo, double hi, Enough&& enough) const {
    DdBall best = refine(q, lo, hi);
    for (int step = 1; step < 6 && best.rad < hi - lo && !enough(best); ++step) {
      double below = 0, above = 0;
      enclose(best, below, above);
      below = std::max(lo, below);
      above = std::min(hi, above);
      const DdBall next = refine(q, below, above);
      if (!(next.rad < 0.5 * best.rad)) break;
      best = next;
    }
    return best;
  }
  // The collapse in balls of the given precision, from an enclosure [lo, hi] (an ExactTime is the
  // last resort).
  Ball refine(const Quad& q, const Rational& lo, const Rational& hi, int bits) const;
  // The root in [lo, hi] exactly.
  static ExactTime exact_root(const Quad& q, const Rational& lo, const Rational& hi,
                              ExactMotion& exact);

  // Whether all four have a rational motion: then exact arithmetic is cheap.
  bool has_rational_motion(const Quad& q) const;

 private:
  // Does what refine() does where [lo, hi] is too wide for a Newton step: halves it by the signs of
  // the flip polynomial until a step gains.
  DdBall refine_halved(const Quad& q, double lo, double hi) const;
  Collapse in_doubles(const Quad& q, const BernsteinForm& form, double start, double end) const;
  Collapse past_hidden(const Quad& q, double start, double end) const;
  Collapse in_pieces(const Quad& q, double start, double end) const;
  std::optional<Collapse> filter(const Quad& q, const BernsteinForm& form, double start,
                                 double end) const;
  Collapse beyond(const Quad& q, const RootInterval& root, double end);
  bool at_relative_rest(const Quad& q) const;
  Collapse at_rest(const Quad& q, const Moment& now);
  // Answers for q while its four generators stay cotangent, perhaps only with the circle of the
  // other kind: both in-circle signs `s` tell, at a time t of the interval. nullopt: not decided.
  std::optional<Collapse> while_cotangent(const Quad& q, const std::array<Sign, 2>& s,
                                          const Ball& t) const;
  std::optional<Collapse> by_symmetry(const Quad& q, const Rational& start, const Moment* now,
                                      double end);
  Collapse slow(const Quad& q, const Rational& start, const Moment* now, double end);
  Collapse exactly(const Quad& q, const Rational& start, const Moment* now, double end);

  Motion& motion_;
  TierCounts& counts_;
};

// About the time in which some two of the four go as far as they are apart and large at t: a power
// of two. It tells what is short and what is long for the edge, in any unit of length and time;
// costs depend on it, and no decision.
double time_scale(const Motion& motion, const Quad& q, double t);

// The three ways to name a triple start with a disk in at most one rotation: the
// vertex's generators with a disk first.
std::array<GenId, 3> disk_first(GenId a, GenId b, GenId c);

// Whether the edge that exists while its four generators stay cotangent is q: its
// dual joins the largest id to its opposite (docs/formats.md; Devillers & Teillaud,
// "Perturbations for Delaunay and weighted Delaunay 3D triangulations", 2011).
inline bool legal_while_cotangent(const Quad& q) { return std::max(q.l, q.r) > std::max(q.s, q.e); }

}  // namespace voroproof::internal
