#include "apps/draw/render.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "apps/draw/colours.h"
#include "apps/draw/digit_pen.h"
#include "apps/draw/picture.h"
#include "apps/draw/render_probe.h"
#include "exact/names.h"
#include "library/diagram_geometry.h"
#include "library/edge_curves.h"
#include "library/palette.h"

namespace voroproof::internal {
namespace {

std::vector<Cubic> reversed(std::vector<Cubic> chain) {
  std::reverse(chain.begin(), chain.end());
  for (Cubic& cubic : chain) std::reverse(cubic.begin(), cubic.end());
  return chain;
}

// ---- Cells

// The boundary of each disk's cell, counterclockwise, from the curves of all edges.
std::vector<std::vector<Cubic>> cell_boundaries(const DiagramFile& diagram,
                                                const EdgeCurves& curves,
                                                const std::vector<std::vector<Cubic>>& edges) {
  const std::size_t n = diagram.disks.size();
  std::vector<std::vector<Cubic>> cells(n);
  if (n == 1) cells[0] = curves.only_cell();

  struct Side {
    Triple from, to;
    std::size_t edge;
    bool backwards;
  };
  std::vector<std::vector<Side>> sides(n);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Quad& q = diagram.edges[i];
    const Triple start = start_vertex(q), end = end_vertex(q);
    if (q.l != container_id) sides[q.l].push_back({start, end, i, false});
    if (q.r != container_id) sides[q.r].push_back({end, start, i, true});
  }
  for (std::size_t disk = 0; disk < n; ++disk) {
    std::map<Triple, const Side*> leaving;
    for (const Side& side : sides[disk]) leaving.emplace(side.from, &side);
    if (leaving.empty()) continue;
    Triple vertex = leaving.begin()->first;
    while (!leaving.empty()) {
      const auto found = leaving.find(vertex);
      if (found == leaving.end())
        throw std::invalid_argument("diagram: the edges around disk " + std::to_string(disk) +
                                    " do not close");
      const Side& side = *found->second;
      const auto chain = side.backwards ? reversed(edges[side.edge]) : edges[side.edge];
      cells[disk].insert(cells[disk].end(), chain.begin(), chain.end());
      vertex = side.to;
      leaving.erase(found);
    }
  }
  return cells;
}

// ---- Painting

class Painter {
 public:
  Painter(cairo_t* cairo, const DiagramFile& diagram, const RenderOptions& options)
      : cairo_(cairo),
        diagram_(diagram),
        probe_(options.probe),
        half_(options.size / 2.0),
        margin_(0.05 * options.size),
        scale_((half_ - margin_) / diagram.container_radius),
        spacing_(scale_ * diagram.container_radius /
                 std::sqrt(static_cast<double>(diagram.disks.size()) + 1)),
        stroke_(std::clamp(0.02 * spacing_, 0.00015 * options.size, 0.0018 * options.size)) {}

  void paint() {
    cairo_set_tolerance(cairo_, 0.01);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    use(white);
    cairo_paint(cairo_);
    circle(diagram_.container_center, scale_ * diagram_.container_radius);
    use(pale(ink, 0.07));
    cairo_fill(cairo_);

    const EdgeCurves curves(diagram_, 0.01 / scale_);
    std::vector<std::vector<Cubic>> edges;
    edges.reserve(diagram_.edges.size());
    for (const Quad& edge : diagram_.edges) edges.push_back(curves.of(edge));
    const auto cells = cell_boundaries(diagram_, curves, edges);
    if (edges.empty() && !cells.empty()) edges.push_back(cells[0]);

    if (probe_) {
      paint_free_space(edges);
    } else {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        trace(cells[i]);
        use(pale(disk_colour(i), cell_share));
        cairo_fill(cairo_);
      }
      for (const auto& edge : edges) stroke(edge, ink, stroke_);
    }
    circle(diagram_.container_center, scale_ * diagram_.container_radius);
    use(ink);
    cairo_set_line_width(cairo_, std::max(2 * stroke_, 0.001 * half_));
    cairo_stroke(cairo_);
    paint_disks();
    if (diagram_.disks.size() <= 200) paint_vertices();
    paint_velocities();
    if (diagram_.disks.size() <= 60) paint_ids();
  }

 private:
  Vec2 pixel(const Vec2& p) const {
    const Vec2 offset = scale_ * (p - diagram_.container_center);
    return {half_ + offset[0], half_ - offset[1]};
  }

  // The voids of the probe, the offset, and the edges: tunnels stand out.
  void paint_free_space(const std::vector<std::vector<Cubic>>& edges) {
    const FreeSpacePicture free_space(diagram_, *probe_);
    free_space.paint(
        cairo_, [this](const Vec2& p) { return pixel(p); }, scale_, 2.5 * stroke_);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const bool tunnel = free_space.is_tunnel(k);
      stroke(edges[k], tunnel ? ink : pale(ink, 0.4), tunnel ? 2 * stroke_ : 0.7 * stroke_);
    }
  }

  void stroke(const std::vector<Cubic>& curve, const Colour& colour, double width) {
    trace(curve);
    use(colour);
    cairo_set_line_width(cairo_, width);
    cairo_stroke(cairo_);
  }

  void use(const Colour& c) { cairo_set_source_rgb(cairo_, c.red, c.green, c.blue); }

  void circle(const Vec2& centre, double pixels) {
    const Vec2 p = pixel(centre);
    cairo_new_path(cairo_);
    cairo_arc(cairo_, p[0], p[1], pixels, 0, 2 * pi);
    cairo_close_path(cairo_);
  }

  void trace(const std::vector<Cubic>& chain) {
    cairo_new_path(cairo_);
    if (chain.empty()) return;
    const Vec2 first = pixel(chain.front()[0]);
    cairo_move_to(cairo_, first[0], first[1]);
    for (const Cubic& cubic : chain) {
      const Vec2 b = pixel(cubic[1]), c = pixel(cubic[2]), d = pixel(cubic[3]);
      cairo_curve_to(cairo_, b[0], b[1], c[0], c[1], d[0], d[1]);
    }
  }

  // Disks that would vanish are drawn as dots a little larger than the lines.
  double disk_pixels(const DiagramDisk& disk) const {
    return std::max(scale_ * disk.radius, 0.9 * stroke_);
  }

  void paint_disks() {
    for (std::size_t i = 0; i < diagram_.disks.size(); ++i) {
      const DiagramDisk& disk = diagram_.disks[i];
      circle(disk.center, disk_pixels(disk));
      use(disk_colour(i));
      cairo_fill_preserve(cairo_);
      use(ink);
      cairo_set_line_width(cairo_, 0.6 * stroke_);
      cairo_stroke(cairo_);
    }
  }

  void paint_vertices() {
    for (const DiagramVertex& vertex : diagram_.vertices) {
      circle(vertex.center, 1.5 * stroke_);
      use(ink);
      cairo_fill(cairo_);
    }
  }

  // The arrows lead from the rims of the disks outwards, to one scale: the fastest disk's arrow has
  // about half the typical distance of disks.
  void paint_velocities() {
    double fastest = 0;
    for (const DiagramDisk& disk : diagram_.disks)
      fastest = std::max(fastest, length(disk.velocity));
    for (const DiagramDisk& disk : diagram_.disks) {
      const double speed = length(disk.velocity);
      if (speed == 0) continue;
      const Vec2 along{disk.velocity[0] / speed, -disk.velocity[1] / speed};
      const Vec2 across{-along[1], along[0]};
      const double reach = std::min(0.5 * spacing_, margin_) * (speed / fastest);
      const double head = std::min(0.35 * reach, 7 * stroke_);
      const Vec2 tail = pixel(disk.center) + disk_pixels(disk) * along;
      const Vec2 tip = tail + reach * along, neck = tip - head * along;
      use(arrow_ink);
      cairo_set_line_width(cairo_, 1.2 * stroke_);
      cairo_new_path(cairo_);
      cairo_move_to(cairo_, tail[0], tail[1]);
      cairo_line_to(cairo_, neck[0], neck[1]);
      cairo_stroke(cairo_);
      cairo_move_to(cairo_, tip[0], tip[1]);
      for (double side : {0.4, -0.4}) {
        const Vec2 barb = neck + (side * head) * across;
        cairo_line_to(cairo_, barb[0], barb[1]);
      }
      cairo_close_path(cairo_);
      cairo_fill(cairo_);
    }
  }

  // Inside disks that have room for them, else behind the disk.
  void paint_ids() {
    const DigitPen pen(cairo_);
    for (std::size_t i = 0; i < diagram_.disks.size(); ++i) {
      const DiagramDisk& disk = diagram_.disks[i];
      const std::string id = std::to_string(i);
      const double radius = disk_pixels(disk);
      const double least = 0.011 * 2 * half_;
      Vec2 place = pixel(disk.center);
      const double height = std::clamp(0.7 * radius, least, 2 * least);
      if (0.7 * radius < least) {
        const double speed = length(disk.velocity);
        const Vec2 behind =
            speed == 0 ? Vec2{0, -1} : Vec2{-disk.velocity[0] / speed, disk.velocity[1] / speed};
        place = place + (radius + least) * behind;
      }
      use(ink);
      pen.write(id, place, height);
    }
  }

  cairo_t* cairo_;
  const DiagramFile& diagram_;
  std::optional<double> probe_;
  double half_;     // half the picture's size
  double margin_;   // around the container, in pixels: room for arrows that point outwards
  double scale_;    // pixels per unit of length
  double spacing_;  // typical distance of neighbouring disks, in pixels
  double stroke_;   // width of an edge, in pixels
};

// ---- Files

void check(const DiagramFile& diagram) {
  if (!(std::isfinite(diagram.container_radius) && diagram.container_radius > 0))
    throw std::invalid_argument("diagram: the container's radius is not positive");
  // Cairo walks along whatever lies beyond the picture.
  const auto require_near = [&](const Vec2& center, double radius, const std::string& what) {
    const double reach = 4 * diagram.container_radius;
    if (!(length(center - diagram.container_center) <= reach && radius <= reach))
      throw std::invalid_argument("diagram: " + what + " lies far beyond the container");
  };
  for (std::size_t k = 0; k < diagram.disks.size(); ++k) {
    const DiagramDisk& disk = diagram.disks[k];
    require_near(disk.center, disk.radius, "disk " + std::to_string(k));
  }
  for (const DiagramVertex& v : diagram.vertices)
    require_near(v.center, v.radius, "vertex " + text_of(v.generators));
  const auto known = [&](GenId id) {
    return id == container_id || (id >= 0 && static_cast<std::size_t>(id) < diagram.disks.size());
  };
  for (const Quad& q : diagram.edges) {
    if (!names_an_edge(q) || !known(q.l) || !known(q.r) || !known(q.s) || !known(q.e))
      throw std::invalid_argument("diagram: " + text_of(q) + " names no edge of it");
  }
}

}  // namespace

void render_diagram(const DiagramFile& diagram, const std::string& path,
                    const RenderOptions& options) {
  check(diagram);
  write_picture(path, options.size,
                [&](cairo_t* cairo) { Painter(cairo, diagram, options).paint(); });
}

}  // namespace voroproof::internal
