// Piecewise linear paths with 113-bit numbers, and when two generators overlap along them.
#pragma once

#include <cstddef>
#include <vector>

#include "tests/adversary/claims.h"
#include "tests/adversary/geometry.h"

namespace voroproof::internal::adversary {

__extension__ typedef __float128 Wide;

Wide square_root(Wide x);

struct WideVec {
  Wide x = 0, y = 0;
};

struct Piece {
  Wide since = 0;
  WideVec at, v;
};

class Path {
 public:
  explicit Path(const Piece& first) : pieces_{first} {}
  const std::vector<Piece>& pieces() const { return pieces_; }
  void turn(Wide t, const WideVec& v) {
    // At one instant the later turn counts, the earlier stays as a piece of no length.
    pieces_.push_back({t, at(t), v});
  }
  void put(const Piece& piece) { pieces_.push_back(piece); }
  const Piece& last() const { return pieces_.back(); }
  WideVec at(Wide t) const { return at(piece_at(t), t); }
  static WideVec at(const Piece& p, Wide t) {
    return {p.at.x + (t - p.since) * p.v.x, p.at.y + (t - p.since) * p.v.y};
  }

 private:
  const Piece& piece_at(Wide t) const {
    std::size_t k = pieces_.size() - 1;
    while (k > 0 && pieces_[k].since > t) --k;
    return pieces_[k];
  }
  std::vector<Piece> pieces_;
};

// The gap of a pair on one pair of lines, as a quadratic in the time from `since`:
// a t^2 + 2 b t + c, negative where they overlap. The container's is that of a disk inside.
struct Gap {
  Wide a, b, c;
  Wide operator()(Wide t) const { return (a * t + 2 * b) * t + c; }
  // When the gap goes from positive to negative.
  bool entry(Wide& t) const;
  bool exit(Wide& t) const;
};

// A maximal interval of overlap.
struct Overlap {
  Wide from, to;  // `to` is the end where it is still open
  bool open = false;
  Wide depth = 0;  // a length
};

// All paths of a scene.
struct Motion {
  const SceneData* scene = nullptr;
  std::vector<Path> paths;

  Wide reach(int i, int j) const;
  Gap gap(int i, const Piece& a, const Piece& b, Wide since, Wide reach) const;
  Piece container() const { return {0, {scene->cx, scene->cy}, {0, 0}}; }
  Sites sites_at(Wide t) const;
  std::vector<Overlap> overlaps(int i, int j, Wide end) const;
  // Whether two points that have not turned have one place at some time up to `end`: no history of
  // that is certified. (Their lines are those of the scene, so that nothing has been rounded.)
  bool points_meet(Wide end) const;

 private:
  // Calls visit(a, b, since, until) for each span of time in which i and j are on the lines a, b.
  template <class Visit>
  void on_lines(int i, int j, Wide end, const Visit& visit) const;
};

}  // namespace voroproof::internal::adversary
