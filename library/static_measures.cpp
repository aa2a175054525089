// The areas, perimeters and centroids of the cells of a diagram of disks at rest.
//
// Let a cell's boundary run counterclockwise, and bring each of its points to the nearest one of
// the box: this closed curve winds around places inside of the box as the boundary does, so that it
// bounds the cell in the box. What is inside stays, and what is beyond a side becomes a way along
// the sides, of which only the ends count. The signed ways along a side have the cell's length on
// it as their sum: so areas, moments and perimeters are sums over parts of edges, in any order.
//
// An unclear part, `excess` out of the box at most, is taken as it is. This moves points of the
// closed curve by no more than that, and leaves gaps as wide at its ends: the curves together sweep
// an area of at most the excess times the part's length, and gaps change area by half their width
// times the distance of the place that areas are seen from, which is in the box.
#include <algorithm>
#include <cmath>
#include <limits>

#include "library/arc_measure.h"
#include "library/box_parts.h"
#include "library/diagram_arcs.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace internal {
namespace {

DoubleBall clamped(double x, double low, double high) { return std::clamp(x, low, high); }

// The sums over the boundary of one cell, as seen from a place in or near the cell and in the box.
struct CellSums {
  BallPoint from;
  DoubleBall area{}, perimeter{};
  BallPoint moment{};
  double blur = 0;         // the area is less certain by that
  bool is_empty = true;    // nothing of the boundary may be in the box
  bool is_certain = true;  // all its edges are
};

// Parts relative to `origin`, with the cell on the left.
void add(CellSums& cell, const BallPoint& origin, const ArcMeasure& part) {
  const BallPoint shift = cell.from - origin, a = part.start - shift, b = part.end - shift;
  const DoubleBall triangle = DoubleBall(0.5) * cross(a, b), third = triangle / DoubleBall(3);
  const DoubleBall both = third + DoubleBall(0.5) * part.area;
  cell.area = cell.area + triangle + part.area;
  cell.moment.x = cell.moment.x + both * (a.x + b.x) + part.moment.x;
  cell.moment.y = cell.moment.y + both * (a.y + b.y) + part.moment.y;
}

ArcMeasure turned(const ArcMeasure& m) {
  return {m.end, m.start, -m.area, {-m.moment.x, -m.moment.y}, m.length};
}

class Cells {
 public:
  Cells(const DiagramArcs& arcs, std::size_t disks) : arcs_(arcs), cells_(disks) {
    const auto& [low, high] = arcs.box();
    for (std::size_t k = 0; k < disks; ++k) {
      const Vec2 c = arcs.disk(static_cast<GenId>(k)).center;
      cells_[k].from = {clamped(c[0], low[0], high[0]), clamped(c[1], low[1], high[1])};
    }
  }

  const CellSums& operator[](std::size_t k) const { return cells_[k]; }

  // Not the frame, nor a wall.
  bool is_disk(GenId g) const { return g >= 0 && static_cast<std::size_t>(g) < cells_.size(); }

  // The arcs of an edge, with the disk `left` on its left; `right` may be the frame or a wall.
  void add_chain(const ArcChain& chain, GenId left, GenId right) {
    if (!chain.is_certain) cells_[left].is_certain = false;
    const BallBox box(arcs_.box(), chain.origin);
    const BallPoint origin{chain.origin[0], chain.origin[1]};
    for (const ConicArc& arc : chain.arcs) {
      for (const BoxPart& part : box_parts(arc, box)) {
        if (part.kind == BoxPart::Kind::outside) {
          const BallPoint a = box.nearest(arc.part(0, part.from).point(2)),
                          b = box.nearest(arc.part(part.to, 1).point(0));
          add_side(part.side, {a, b, 0, {0, 0}, 0}, origin, left, right);
        } else {
          measure_arc(arc.part(part.from, part.to), [&](const ArcMeasure& piece) {
            add_piece(part, piece, box.size, origin, left, right);
          });
        }
      }
    }
  }

 private:
  template <class Add>
  void beside(GenId left, GenId right, const ArcMeasure& piece, const Add& add_to) {
    if (is_disk(left)) add_to(cells_[left], piece);
    if (is_disk(right)) add_to(cells_[right], turned(piece));
  }

  void add_side(int side, const ArcMeasure& way, const BallPoint& origin, GenId left, GenId right) {
    beside(left, right, way, [&](CellSums& cell, const ArcMeasure& m) {
      add(cell, origin, m);
      cell.perimeter = cell.perimeter + BallBox::along(side, m.start, m.end);
    });
  }

  void add_piece(const BoxPart& part, const ArcMeasure& piece, double size, const BallPoint& origin,
                 GenId left, GenId right) {
    beside(left, right, piece, [&](CellSums& cell, const ArcMeasure& m) {
      add(cell, origin, m);
      cell.perimeter = cell.perimeter + counted(part, m);
      if (part.kind == BoxPart::Kind::unclear) {
        cell.blur += part.excess * (upper(m.length) + 2 * size + part.excess);
      }
      cell.is_empty = false;
    });
  }

  // As part of a perimeter. Each bit of an unclear part counts by its length, or by its way along
  // the side, which is not more: so does the whole.
  static DoubleBall counted(const BoxPart& part, const ArcMeasure& m) {
    if (part.kind == BoxPart::Kind::inside) return m.length;
    const double most = upper(m.length);
    const double least =
        part.side == BoxPart::several ? -most : lower(BallBox::along(part.side, m.start, m.end));
    return DoubleBall::hull(std::clamp(least, -most, most), most);
  }

  const DiagramArcs& arcs_;
  std::vector<CellSums> cells_;
};

double error_of(double error) {
  return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

// The area and the perimeter are not known to be more than 0.
Measure nothing(double area_error, double perimeter_error) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {0, 0, {none, none}, error_of(area_error), error_of(perimeter_error), none};
}

Measure measure_of(const CellSums& cell, double size, double unit) {
  constexpr double up = 1 + 0x1p-40;
  DoubleBall area = cell.area;
  area.rad += cell.blur * up;
  // An edge that leads all around the disk would have all others in one place, and leave no area.
  if (!(lower(area) > 0) && !cell.is_certain) {
    const double any = std::numeric_limits<double>::infinity();
    return nothing(any, any);
  }
  if (!(lower(area) > 0)) {
    return nothing((std::fabs(area.mid) + area.rad) * unit * unit * up,
                   (std::fabs(cell.perimeter.mid) + cell.perimeter.rad) * unit * up);
  }
  const auto place = [&](DoubleBall moment, const DoubleBall& from) {
    moment.rad += cell.blur * size * up;
    return moment / area + from;
  };
  const DoubleBall x = place(cell.moment.x, cell.from.x), y = place(cell.moment.y, cell.from.y);
  return {area.mid * unit * unit,
          cell.perimeter.mid * unit,
          {x.mid * unit, y.mid * unit},
          error_of(area.rad * unit * unit),
          error_of(cell.perimeter.rad * unit),
          error_of((x.rad + y.rad) * unit * up)};
}

Measure measure_of_all(const Box& box) {
  const BallBox sides(box, {0, 0});
  const DoubleBall width = sides.high.x - sides.low.x, height = sides.high.y - sides.low.y;
  CellSums cell;
  cell.area = width * height;
  cell.perimeter = DoubleBall(2) * (width + height);
  cell.from = {DoubleBall(0.5) * (sides.low.x + sides.high.x),
               DoubleBall(0.5) * (sides.low.y + sides.high.y)};
  cell.moment = {0, 0};
  return measure_of(cell, sides.size, 1);
}

}  // namespace
}  // namespace internal

std::vector<Measure> StaticDiagram::measures(const Box& box) const {
  internal::require_area(box);
  const internal::DiagramArcs arcs(*this, box);
  internal::Cells cells(arcs, disks_.size());
  for (const internal::Quad& q : arcs.edges()) {
    if (cells.is_disk(q.l)) cells.add_chain(arcs.chain(q), q.l, q.r);
  }
  const Box& cut = arcs.box();
  const double size = (cut.high[0] - cut.low[0]) + (cut.high[1] - cut.low[1]);
  std::vector<Measure> all(disks_.size(), internal::nothing(0, 0));
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (hosts_[k] != visible) continue;
    const auto id = static_cast<internal::GenId>(k);
    if (edges_.empty() && frame_) {
      cells.add_chain(internal::frame_ellipse(arcs.disk(id), arcs.frame()), id,
                      internal::container_id);
    }
    const bool alone = edges_.empty() && !frame_;
    if (!cells[k].is_empty) {
      all[k] = internal::measure_of(cells[k], size, arcs.unit());
    } else if (alone || cells[k].perimeter.mid > size) {  // half of the box's perimeter
      all[k] = internal::measure_of_all(box);
    }
  }
  return all;
}

}  // namespace voroproof
