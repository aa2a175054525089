// The free space of a probe as a layer of a picture: decided in doubles, from the rounded
// coordinates of the diagram file (exactly: voroproof query voids).
#pragma once

#include <cairo.h>

#include <cstddef>
#include <functional>
#include <vector>

#include "history/diagram_file.h"

namespace voroproof::internal {

class FreeSpacePicture {
 public:
  // Precondition: the diagram is one (render_diagram checks it), probe >= 0.
  FreeSpacePicture(const DiagramFile& diagram, double probe);

  // The voids, each in a colour, and the offset as a red line of a width in pixels on the side of
  // the disks; `pixel` maps points, `scale` lengths.
  void paint(cairo_t* cairo, const std::function<Vec2(const Vec2&)>& pixel, double scale,
             double width) const;

  // Whether the probe passes along the edge with this index in the diagram (of a lone disk the
  // closed edge, 0).
  bool is_tunnel(std::size_t edge) const { return tunnels_[edge]; }
  std::size_t voids() const { return voids_; }

 private:
  // The region between a free piece of an edge and the centres of its generators.
  struct Region {
    std::vector<Vec2> piece;
    GenId l, r;
    std::size_t number;  // number of its void
  };

  void add_edge(GenId l, GenId r, const std::vector<Vec2>& points, std::size_t start,
                std::size_t end, std::vector<std::size_t>& group);
  std::vector<Vec2> points_along(GenId l, GenId r, const Vec2& start, const Vec2& end,
                                 bool closed) const;
  void paint_wedge(cairo_t* cairo, const std::function<Vec2(const Vec2&)>& pixel,
                   const Region& region, GenId g) const;

  const DiagramFile& diagram_;
  double probe_;
  std::vector<Region> regions_;
  std::vector<bool> tunnels_;
  std::size_t voids_ = 0;
};

}  // namespace voroproof::internal
