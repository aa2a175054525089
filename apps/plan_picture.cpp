#include "apps/plan_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/digit_pen.h"
#include "apps/picture.h"

namespace voroproof {
namespace {

struct Color {
  double red, green, blue;
};
constexpr Color ink{0.2, 0.23, 0.3}, pale{0.75, 0.83, 0.93}, dots{0.55, 0.6, 0.7},
    change{0.85, 0.55, 0.1}, nearest_color{0.8, 0.1, 0.1};

class PlanPainter {
 public:
  PlanPainter(cairo_t* cairo, const PlanResult& result, int size)
      : cairo_(cairo), result_(result), size_(size) {
    frame();
  }

  void paint() {
    cairo_set_source_rgb(cairo_, 1, 1, 1);
    cairo_paint(cairo_);
    const PlanTask& task = result_.plan.task;
    disk(task.container_center, round_nearest(task.container_radius));
    stroke(ink, 2);
    for (const Vehicle& vehicle : task.vehicles) way(vehicle);
    for (std::size_t i = 0; i < task.vehicles.size(); ++i) ends(static_cast<int>(i));
    if (result_.nearest) nearest(*result_.nearest);
  }

 private:
  // The starts, the goals and what is between, with a margin.
  void frame() {
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    const auto include = [&](const Point2& p, double r) {
      x0 = std::min(x0, round_nearest(p.x) - r);
      x1 = std::max(x1, round_nearest(p.x) + r);
      y0 = std::min(y0, round_nearest(p.y) - r);
      y1 = std::max(y1, round_nearest(p.y) + r);
    };
    const PlanTask& task = result_.plan.task;
    for (const Vehicle& v : task.vehicles) {
      include(v.start, round_nearest(v.radius));
      include(v.goal, round_nearest(v.radius));
    }
    if (!(x0 < x1)) include(task.container_center, round_nearest(task.container_radius));
    const double half = 0.54 * std::max(x1 - x0, y1 - y0);
    scale_ = size_ / (2 * half);
    left_ = (x0 + x1) / 2 - half;
    top_ = (y0 + y1) / 2 + half;
  }

  Vec2 pixel(const Point2& p) const {
    return {(round_nearest(p.x) - left_) * scale_, (top_ - round_nearest(p.y)) * scale_};
  }

  void disk(const Point2& centre, double radius) {
    const Vec2 at = pixel(centre);
    cairo_new_path(cairo_);
    cairo_arc(cairo_, at[0], at[1], std::max(radius * scale_, 0.5), 0, 2 * std::numbers::pi);
  }

  void source(const Color& c) { cairo_set_source_rgb(cairo_, c.red, c.green, c.blue); }

  void stroke(const Color& color, double width) {
    source(color);
    cairo_set_line_width(cairo_, width);
    cairo_stroke(cairo_);
  }

  void line(const Point2& from, const Point2& to) {
    const Vec2 a = pixel(from), b = pixel(to);
    cairo_move_to(cairo_, a[0], a[1]);
    cairo_line_to(cairo_, b[0], b[1]);
  }

  void way(const Vehicle& vehicle) {
    const double dash[] = {2, 4};
    cairo_set_dash(cairo_, dash, 2, 0);
    line(vehicle.start, vehicle.goal);
    stroke(dots, 1);
    cairo_set_dash(cairo_, nullptr, 0, 0);
  }

  void ends(int i) {
    const Vehicle& vehicle = result_.plan.task.vehicles[i];
    const double radius = round_nearest(vehicle.radius);
    disk(vehicle.goal, radius);
    source(pale);
    cairo_fill_preserve(cairo_);
    stroke(ink, 1);
    disk(vehicle.start, radius);
    stroke(ink, 1);
    const Timetable& timetable = result_.plan.timetables[i];
    for (std::size_t k = 1; k + 1 < timetable.size(); ++k) {
      const Vec2 at = pixel(place(vehicle, timetable[k].progress));
      cairo_arc(cairo_, at[0], at[1], 2.5, 0, 2 * std::numbers::pi);
      source(change);
      cairo_fill(cairo_);
    }
    if (result_.plan.timetables.size() > 60) return;
    source(ink);
    const DigitPen pen(cairo_);
    const double height = std::clamp(radius * scale_, 6.0, 16.0);
    pen.write(std::to_string(i), pixel(vehicle.start), height);
    pen.write(std::to_string(i), pixel(vehicle.goal), height);
  }

  void nearest(const Approach& approach) {
    Point2 at[2];
    for (const int side : {0, 1}) {
      const int i = side == 0 ? approach.i : approach.j;
      const Vehicle& vehicle = result_.plan.task.vehicles[i];
      const Rational step = approach.t * time_steps / result_.plan.task.arrive;
      at[side] = place(vehicle, progress_at<Rational>(result_.plan.timetables[i], step));
      disk(at[side], round_nearest(vehicle.radius));
      stroke(nearest_color, 1.5);
    }
    line(at[0], at[1]);
    stroke(nearest_color, 1.5);
  }

  cairo_t* cairo_;
  const PlanResult& result_;
  double size_, scale_ = 1, left_ = 0, top_ = 0;
};

}  // namespace

void draw_plan(const PlanResult& result, const std::string& path, int size) {
  write_picture(path, size, [&](cairo_t* cairo) { PlanPainter(cairo, result, size).paint(); });
}

}  // namespace voroproof
