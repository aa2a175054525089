#include "apps/draw/digit_pen.h"

#include <numbers>

namespace voroproof::internal {

void DigitPen::write(const std::string& digits, const Vec2& place, double height) const {
  constexpr double advance = 0.82;
  const double width = advance * static_cast<double>(digits.size()) - (advance - 0.6);
  cairo_new_path(cairo_);
  cairo_save(cairo_);
  cairo_translate(cairo_, place[0] - height * width / 2, place[1] + height / 2);
  cairo_scale(cairo_, height, -height);
  for (char digit : digits) {
    add(digit);
    cairo_translate(cairo_, advance, 0);
  }
  cairo_restore(cairo_);
  cairo_set_line_width(cairo_, 0.13 * height);
  cairo_stroke(cairo_);
}

void DigitPen::add(char digit) const {
  switch (digit) {
    case '0':
      return oval(0.3, 0.5, 0.28, 0.5);
    case '1':
      return lines({{0.12, 0.78}, {0.36, 1}, {0.36, 0}});
    case '2':
      start(0.04, 0.74);
      arc(0.3, 0.73, 0.26, 0.27, 178, -40);
      return to({{0.03, 0}, {0.58, 0}});
    case '3':
      start(0.07, 0.88);
      arc(0.28, 0.75, 0.24, 0.25, 148, -90);
      return arc(0.28, 0.25, 0.29, 0.25, 90, -150);
    case '4':
      return lines({{0.46, 0}, {0.46, 1}, {0.02, 0.28}, {0.6, 0.28}});
    case '5':
      lines({{0.53, 1}, {0.13, 1}, {0.08, 0.53}});
      return arc(0.28, 0.31, 0.29, 0.31, 125, -148);
    case '6':
      oval(0.3, 0.3, 0.27, 0.3);
      return curve({0.03, 0.32}, {0.03, 0.7}, {0.18, 0.95}, {0.47, 1});
    case '7':
      return lines({{0.03, 1}, {0.57, 1}, {0.2, 0}});
    case '8':
      oval(0.3, 0.76, 0.23, 0.24);
      return oval(0.3, 0.26, 0.28, 0.26);
    case '9':
      oval(0.3, 0.7, 0.27, 0.3);
      return curve({0.57, 0.68}, {0.57, 0.3}, {0.42, 0.05}, {0.13, 0});
  }
}

void DigitPen::to(std::initializer_list<Vec2> points) const {
  for (const Vec2& p : points) cairo_line_to(cairo_, p[0], p[1]);
}

void DigitPen::lines(std::initializer_list<Vec2> points) const {
  cairo_new_sub_path(cairo_);
  to(points);
}

void DigitPen::curve(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) const {
  start(a[0], a[1]);
  cairo_curve_to(cairo_, b[0], b[1], c[0], c[1], d[0], d[1]);
}

void DigitPen::arc(double x, double y, double rx, double ry, double from, double to) const {
  constexpr double degree = std::numbers::pi / 180;
  cairo_save(cairo_);
  cairo_translate(cairo_, x, y);
  cairo_scale(cairo_, rx, ry);
  cairo_arc_negative(cairo_, 0, 0, 1, from * degree, to * degree);
  cairo_restore(cairo_);
}

void DigitPen::oval(double x, double y, double rx, double ry) const {
  cairo_new_sub_path(cairo_);
  arc(x, y, rx, ry, 360, 0);
  cairo_close_path(cairo_);
}

}  // namespace voroproof::internal
