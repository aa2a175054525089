#include "apps/draw/plan_picture.h"

#include <algorithm>
#include <cmath>

#include "apps/draw/digit_pen.h"
#include "apps/draw/picture.h"
#include "library/diagram_geometry.h"
#include "library/palette.h"

namespace voroproof::internal {
namespace {

constexpr Colour goal_colour{0.75, 0.83, 0.93}, way_colour{0.55, 0.6, 0.7},
    change_colour{0.85, 0.55, 0.1}, conjunction_colour{0.42, 0.24, 0.94},
    nearest_colour{0.8, 0.1, 0.1};

class PlanPainter {
 public:
  PlanPainter(cairo_t* cairo, const PlanDrawing& plan, int size)
      : cairo_(cairo), plan_(plan), size_(size) {
    frame();
  }

  void paint() {
    cairo_set_source_rgb(cairo_, 1, 1, 1);
    cairo_paint(cairo_);
    // Cairo walks along all of it; one that is so much larger is hardly ever in the picture.
    constexpr double most_pixels = 1e7;
    if (plan_.container_radius * scale_ < most_pixels) {
      disk(plan_.container_center, plan_.container_radius);
      stroke(ink, 2);
    }
    for (const PlanDrawing::DrawnVehicle& vehicle : plan_.vehicles) way(vehicle);
    for (std::size_t i = 0; i < plan_.vehicles.size(); ++i) ends(static_cast<int>(i));
    for (const Vec2& place : plan_.conjunctions) cross(place);
    if (plan_.nearest) nearest(*plan_.nearest);
  }

 private:
  // The starts, the goals and what is between, with a margin.
  void frame() {
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    const auto include = [&](const Vec2& p, double r) {
      x0 = std::min(x0, p[0] - r);
      x1 = std::max(x1, p[0] + r);
      y0 = std::min(y0, p[1] - r);
      y1 = std::max(y1, p[1] + r);
    };
    for (const PlanDrawing::DrawnVehicle& v : plan_.vehicles) {
      include(v.way.front().at, v.radius);
      include(v.way.back().at, v.radius);
    }
    double side = std::max(x1 - x0, y1 - y0);
    if (!(side > 0)) {  // nobody, or points that stay at one place
      include(plan_.container_center, plan_.container_radius);
      side = std::max(x1 - x0, y1 - y0);
    }
    Vec2 middle{(x0 + x1) / 2, (y0 + y1) / 2};
    double half = 0.54 * side;
    // A container that is about as large is shown as a whole, not cut at its sides.
    if (plan_.container_radius < 1.3 * half) {
      middle = plan_.container_center;
      half = 1.04 * plan_.container_radius;
    }
    scale_ = size_ / (2 * half);
    left_ = middle[0] - half;
    top_ = middle[1] + half;
  }

  Vec2 pixel(const Vec2& p) const { return {(p[0] - left_) * scale_, (top_ - p[1]) * scale_}; }

  void circle(const Vec2& at, double pixels) {
    cairo_new_path(cairo_);
    cairo_arc(cairo_, at[0], at[1], pixels, 0, 2 * pi);
  }
  void disk(const Vec2& centre, double radius) {
    circle(pixel(centre), std::max(radius * scale_, 0.5));
  }

  void source(const Colour& c) { cairo_set_source_rgb(cairo_, c.red, c.green, c.blue); }

  void stroke(const Colour& colour, double width) {
    source(colour);
    cairo_set_line_width(cairo_, width);
    cairo_stroke(cairo_);
  }

  void line(const Vec2& from, const Vec2& to) {
    cairo_move_to(cairo_, from[0], from[1]);
    cairo_line_to(cairo_, to[0], to[1]);
  }

  void way(const PlanDrawing::DrawnVehicle& vehicle) {
    const double dash[] = {2, 4};
    cairo_set_dash(cairo_, dash, 2, 0);
    line(pixel(vehicle.way.front().at), pixel(vehicle.way.back().at));
    stroke(way_colour, 1);
    cairo_set_dash(cairo_, nullptr, 0, 0);
  }

  void ends(int i) {
    const PlanDrawing::DrawnVehicle& vehicle = plan_.vehicles[i];
    const Vec2 start = vehicle.way.front().at, goal = vehicle.way.back().at;
    disk(goal, vehicle.radius);
    source(goal_colour);
    cairo_fill_preserve(cairo_);
    stroke(ink, 1);
    disk(start, vehicle.radius);
    stroke(ink, 1);
    for (std::size_t k = 1; k + 1 < vehicle.way.size(); ++k) {
      circle(pixel(vehicle.way[k].at), 2.5);
      source(change_colour);
      cairo_fill(cairo_);
    }
    if (plan_.vehicles.size() > 60) return;
    source(ink);
    const DigitPen pen(cairo_);
    const std::string digits = std::to_string(i);
    const double radius = vehicle.radius * scale_;
    const double width = 0.7 * static_cast<double>(digits.size());  // width at height 1
    const double inside = std::min(16.0, 1.6 * radius / std::hypot(width, 1.0));
    if (inside >= 8) {
      pen.write(digits, pixel(start), inside);
      pen.write(digits, pixel(goal), inside);
      return;
    }
    // The digits stand beside the ends, where no way leads.
    const Vec2 from = pixel(start), way = pixel(goal) - from;
    const double length = std::hypot(way[0], way[1]);
    const Vec2 along = length > 0 ? (1 / length) * way : Vec2{0, 1};
    constexpr double height = 9;
    const double off = radius + 3 + 0.5 * height * std::hypot(width * along[0], along[1]);
    pen.write(digits, from - off * along, height);
    pen.write(digits, from + way + off * along, height);
  }

  void cross(const Vec2& place) {
    const Vec2 at = pixel(place);
    const double arm = std::clamp(0.006 * size_, 3.0, 8.0);
    for (const double side : {1.0, -1.0}) line(at - arm * Vec2{1, side}, at + arm * Vec2{1, side});
    stroke(conjunction_colour, 1.5);
  }

  void nearest(const PlanDrawing::Pair& pair) {
    for (const int i : {pair.i, pair.j}) {
      disk(plan_.place(i, pair.t), plan_.vehicles[i].radius);
      stroke(nearest_colour, 1.5);
    }
    line(pixel(plan_.place(pair.i, pair.t)), pixel(plan_.place(pair.j, pair.t)));
    stroke(nearest_colour, 1.5);
  }

  cairo_t* cairo_;
  const PlanDrawing& plan_;
  double size_, scale_ = 1, left_ = 0, top_ = 0;
};

}  // namespace

void draw_plan(const PlanDrawing& drawing, const std::string& path, int size) {
  write_picture(path, size, [&](cairo_t* cairo) { PlanPainter(cairo, drawing, size).paint(); });
}

}  // namespace voroproof::internal
