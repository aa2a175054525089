#include "apps/draw/static_picture.h"

#include <algorithm>
#include <cmath>

#include "apps/draw/colours.h"
#include "apps/draw/picture.h"
#include "apps/draw/static_curves.h"
#include "apps/draw/static_labels.h"
#include "library/diagram_geometry.h"
#include "library/palette.h"

namespace voroproof::internal {
namespace {

class StaticPainter {
 public:
  StaticPainter(cairo_t* cairo, const StaticDiagram& diagram, const Box& box,
                const std::vector<std::string>& labels, int size)
      : cairo_(cairo), diagram_(diagram), box_(box), labels_(labels), size_(size) {
    const double width = box.high[0] - box.low[0], height = box.high[1] - box.low[1];
    scale_ = 0.96 * size_ / std::max(width, height);
    middle_ = {box.low[0] + width / 2, box.low[1] + height / 2};
    const double spacing = 0.5 * size_ / std::sqrt(static_cast<double>(diagram.disks().size()) + 1);
    stroke_ = std::clamp(0.02 * spacing, 0.00015 * size_, 0.0018 * size_);
  }

  void paint() {
    cairo_set_tolerance(cairo_, 0.01);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    use(white);
    cairo_paint(cairo_);
    cairo_save(cairo_);
    trace({box_.low, {box_.high[0], box_.low[1]}, box_.high, {box_.low[0], box_.high[1]}});
    cairo_clip_preserve(cairo_);
    use(pale(ink, 0.07));
    cairo_fill(cairo_);
    paint_cells();
    paint_disks();
    paint_edges();
    cairo_restore(cairo_);
    paint_labels();
  }

 private:
  Vec2 pixel(const Vec2& p) const {
    const Vec2 offset = scale_ * (p - middle_);
    return {size_ / 2 + offset[0], size_ / 2 - offset[1]};
  }

  void use(const Colour& c, double opacity = 1) {
    cairo_set_source_rgba(cairo_, c.red, c.green, c.blue, opacity);
  }

  void stroke(const Colour& colour, double width) {
    use(colour);
    cairo_set_line_width(cairo_, width);
    cairo_stroke(cairo_);
  }

  void trace(const std::vector<Vector>& polygon) {
    cairo_new_path(cairo_);
    for (const Vec2& p : polygon) {
      const Vec2 at = pixel(p);
      cairo_line_to(cairo_, at[0], at[1]);
    }
    cairo_close_path(cairo_);
  }

  void paint_cells() {
    // The lines of edges hide by how much the sides of polygons are off.
    cells_ = diagram_.cells(box_, 0.2 * stroke_ / scale_);
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      for (const auto& polygon : cells_[k]) {
        trace(polygon);
        use(pale(disk_colour(k), cell_share));
        cairo_fill(cairo_);
      }
    }
  }

  void paint_edges() {
    for (const std::vector<Cubic>& chain : curves_in_box(diagram_, box_, 0.02 / scale_)) {
      cairo_new_path(cairo_);
      const Vec2 first = pixel(chain.front()[0]);
      cairo_move_to(cairo_, first[0], first[1]);
      for (const Cubic& cubic : chain) {
        const Vec2 b = pixel(cubic[1]), c = pixel(cubic[2]), d = pixel(cubic[3]);
        cairo_curve_to(cairo_, b[0], b[1], c[0], c[1], d[0], d[1]);
      }
      stroke(ink, stroke_);
    }
    if (const auto& frame = diagram_.frame()) {
      if (circle(frame->center, scale_ * frame->radius)) stroke(ink, 2 * stroke_);
    }
    if (const auto& walls = diagram_.walls()) {
      const auto& [low, high] = *walls;
      trace({low, {high[0], low[1]}, high, {low[0], high[1]}});
      stroke(ink, 2 * stroke_);
    }
  }

  // The path of a circle, or of what is near the picture of a large one: cairo's numbers have 24
  // bits before the point. Whether any of its rim or inside is in the picture.
  bool circle(const Vec2& center, double radius) {
    const Vec2 at = pixel(center), to_middle = Vec2{size_ / 2, size_ / 2} - at;
    const double far = length(to_middle);
    if (!(far - radius < size_)) return false;
    cairo_new_path(cairo_);
    if (radius <= 4 * size_) {
      cairo_arc(cairo_, at[0], at[1], radius, 0, 2 * pi);
    } else if (far + size_ < radius) {
      cairo_rectangle(cairo_, -size_, -size_, 3 * size_, 3 * size_);
    } else {
      // Its part near the picture is flat: an arc, and two corners so far inside of the disk that
      // the sides between are not seen.
      const double middle = angle(to_middle), reach = 3 * size_ / radius;
      constexpr int steps = 64;
      for (int k = -steps; k <= steps; ++k) {
        const Vec2 p = at + radius * direction(middle + reach * k / steps);
        cairo_line_to(cairo_, p[0], p[1]);
      }
      for (const double side : {1.0, -1.0}) {
        const Vec2 p = at + (radius - 4 * size_) * direction(middle + side * reach);
        cairo_line_to(cairo_, p[0], p[1]);
      }
    }
    cairo_close_path(cairo_);
    return true;
  }

  bool is_hidden(std::size_t k) const { return diagram_.hosts()[k] != StaticDiagram::visible; }

  // Points are drawn as dots.
  double disk_pixels(const voroproof::Circle& disk) const {
    return std::max(scale_ * disk.radius, 1.5 * stroke_);
  }

  // One may lie upon another: the insides are half transparent, and all rims are above them.
  void paint_disks() {
    const auto& disks = diagram_.disks();
    for (std::size_t k = 0; k < disks.size(); ++k) {
      if (is_hidden(k) || disks[k].radius < 0) continue;
      if (!circle(disks[k].center, disk_pixels(disks[k]))) continue;
      use(disk_colour(k), 0.6);
      cairo_fill(cairo_);
    }
    for (std::size_t k = 0; k < disks.size(); ++k) {
      if (disks[k].radius < 0) {
        cross(disks[k].center);
        continue;
      }
      if (!circle(disks[k].center, disk_pixels(disks[k]))) continue;
      const double dash = 4 * stroke_;
      cairo_set_dash(cairo_, &dash, is_hidden(k) ? 1 : 0, 0);
      stroke(is_hidden(k) ? pale(ink, 0.7) : ink, 0.8 * stroke_);
    }
    cairo_set_dash(cairo_, nullptr, 0, 0);
  }

  void cross(const Vec2& center) {
    if (!is_in_box(center)) return;
    const Vec2 at = pixel(center);
    const double arm = 3 * stroke_;
    cairo_set_dash(cairo_, nullptr, 0, 0);
    cairo_new_path(cairo_);
    for (const double side : {1.0, -1.0}) {
      cairo_move_to(cairo_, at[0] - arm, at[1] - side * arm);
      cairo_line_to(cairo_, at[0] + arm, at[1] + side * arm);
    }
    stroke(ink, stroke_);
  }

  bool is_in_box(const Vec2& p) const {
    return box_.low[0] <= p[0] && p[0] <= box_.high[0] && box_.low[1] <= p[1] &&
           p[1] <= box_.high[1];
  }

  void paint_labels() {
    std::vector<LabelledDisk> all;
    const auto& disks = diagram_.disks();
    for (std::size_t k = 0; k < disks.size(); ++k) {
      const bool is_shown = is_hidden(k) ? is_in_box(disks[k].center) : !cells_[k].empty();
      all.push_back(
          {is_shown ? labels_[k] : "", pixel(disks[k].center), disk_pixels(disks[k]), {}});
      for (const auto& polygon : cells_[k]) {
        all.back().cell.emplace_back();
        for (const Vec2& p : polygon) all.back().cell.back().push_back(pixel(p));
      }
    }
    for (const PlacedLabel& label : place_labels(cairo_, all, size_)) {
      use(is_hidden(label.disk) ? pale(ink, 0.7) : ink);
      write_label(cairo_, labels_[label.disk], label.middle, label.height);
    }
  }

  cairo_t* cairo_;
  const StaticDiagram& diagram_;
  const Box& box_;
  const std::vector<std::string>& labels_;
  double size_;
  double scale_;   // pixels per unit of length
  double stroke_;  // width of an edge, in pixels
  Vec2 middle_{};
  std::vector<std::vector<std::vector<Vector>>> cells_;
};

}  // namespace

void draw_static_diagram(const StaticDiagram& diagram, const Box& box,
                         const std::vector<std::string>& labels, const std::string& path,
                         int size) {
  write_picture(path, size,
                [&](cairo_t* cairo) { StaticPainter(cairo, diagram, box, labels, size).paint(); });
}

}  // namespace voroproof::internal
