// Two disks, or a wall and a disk, on a piece of time on which their gap is made of polynomials.
//
// The gap of two disks is the root of their distance's square, which is a polynomial where their
// offset is one, less the sum of their radii, another one. The gap in a round container is its
// radius less the disk's, less such a root; that to a wall is a polynomial itself. The least gap is
// at an end of the piece or where the gap's derivative is zero, and the times at which the gap is
// some distance are roots of polynomials, too. Roots of a polynomial of degree 1 are rational, and
// so is all that is said of two straight ways of disks that do not grow; others are isolated
// (exact/roots.h) and narrowed.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "exact/enclosure.h"
#include "exact/polynomial.h"
#include "exact/roots.h"
#include "history/paths_file.h"
#include "library/planning/clearance.h"

namespace voroproof::internal {

// A longest interval in which the gap of a pair is less than some distance. Each end is enclosed;
// it is where the distance is reached, or where one of the two comes or goes.
struct NearSpell {
  Enclosure from, to;
  Approach nearest;  // the least gap in it, and when first
};

// The part of a spell in a piece of time.
struct SpellPart {
  bool at_begin, at_end;  // whether it has the piece's beginning and end
  NearSpell spell;
};

// A number from 0 to 1: a fraction, or the root of a polynomial that is enclosed. Enclosures of two
// may overlap; their order is that of the numbers.
struct Place {
  RootInterval s;
  std::shared_ptr<const Polynomial<Rational>> root_of{};  // null for a fraction
};

// The disks i and j, or the wall i < 0 and the disk j, from one time to another, or for an instant.
struct CommonTime {
  int i, j;
  LatticeImage image;  // the one of j
  Rational from, to;
  // The sum of both radii; of the container and a disk by how much the former is greater; of a wall
  // and a disk their gap. By s from 0 to 1 in proportion to time. Its degree is 1 at most unless
  // the offset is zero.
  Polynomial<Rational> reach;
  bool has_end = true;  // whether both are still there at the end
};

class CommonPiece {
 public:
  // `offset`: of the image of j from i, or of the container's centre from j, by s, or at one
  // instant; zero for a wall. `height` > 0: they count as near each other only while their third
  // coordinates differ by less, and their distance is that of the other two; then radii do not
  // change.
  CommonPiece(CommonTime time, const Curve& offset, const std::optional<Rational>& height);

  const CommonTime& time() const { return time_; }

  // The least gap; of equal ones the first in time. At a contact the gap is zero. Nothing where
  // they never count as near.
  std::optional<Approach> nearest(const std::set<GivenContact>& contacts) const;
  // All parts of spells in which the gap is less than `distance` >= 0, in order.
  std::vector<SpellPart> below(const Rational& distance,
                               const std::set<GivenContact>& contacts) const;
  // Whether one look at the coefficients proves that no gap of two disks is as small as that.
  bool is_plainly_beyond(const Rational& gap) const;

 private:
  // A part of the piece.
  struct Span {
    Place begin, end;
  };
  bool is_at_wall() const { return time_.i < 0; }
  // `is_stationary`: at a root of the derivative of the distance's square, radii being constant.
  Approach approach_at(const RootInterval& s, bool is_stationary) const;
  // The approach, with a gap of zero where the two are in contact then.
  Approach at_contact(Approach approach, const std::set<GivenContact>& contacts) const;
  static bool is_inside(const Place& place, const Span& span);  // and at neither end
  Approach nearest_on(const Span& span, const std::set<GivenContact>& contacts) const;
  const std::vector<Place>& stationary() const;
  // The distance at which the gap is that.
  Polynomial<Rational> limit(const Rational& distance) const;
  // Where the gap may come to be less than `distance`, or cease to be.
  std::vector<Place> ends_below(const Rational& distance) const;
  Enclosure time_at(const RootInterval& s) const;

  CommonTime time_;
  Polynomial<Rational> distance2_;
  bool is_constant_;         // the gap
  std::vector<Span> spans_;  // where they count as near; the ends may not
  bool is_near_at_begin_ = true, is_near_at_end_ = true;
  mutable std::optional<std::vector<Place>> stationary_;
};

// The spells in which gaps are less than a distance >= 0, of pieces of all pairs.
class SpellsBelow {
 public:
  // Both outlive this.
  SpellsBelow(const Rational& distance, const std::set<GivenContact>& contacts)
      : distance_(distance), contacts_(contacts) {}

  // `i` and `j` are the disks, or the wall and the disk.
  void add(const CommonPiece& piece, int i, int j);
  // All, by pair, image and time. Parts are put together where one goes on in the next piece.
  std::vector<NearSpell> spells();

 private:
  struct PiecePart {
    Rational begin, end;  // the piece's
    SpellPart part;
  };
  static void join(std::vector<PiecePart>& parts, std::vector<NearSpell>& spells);

  const Rational& distance_;
  const std::set<GivenContact>& contacts_;
  std::map<std::tuple<int, int, LatticeImage>, std::vector<PiecePart>> parts_;
};

}  // namespace voroproof::internal
