// Numbers in pictures.
#pragma once

#include <cairo.h>

#include <initializer_list>
#include <string>

#include "history/events.h"

namespace voroproof::internal {

// Draws the decimal digits of an id as strokes, so that pictures do not depend on
// the fonts of a system. A digit fills a box 0.6 wide and 1 high, y upwards.
class DigitPen {
 public:
  explicit DigitPen(cairo_t* cairo) : cairo_(cairo) {}

  // Writes the digits around the given place, `height` pixels high.
  void write(const std::string& digits, const Vec2& place, double height) const;

 private:
  void add(char digit) const;
  void start(double x, double y) const { cairo_move_to(cairo_, x, y); }
  void to(std::initializer_list<Vec2> points) const;
  void lines(std::initializer_list<Vec2> points) const;
  void curve(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) const;
  // Clockwise, angles in degrees.
  void arc(double x, double y, double rx, double ry, double from, double to) const;
  void oval(double x, double y, double rx, double ry) const;

  cairo_t* cairo_;
};

}  // namespace voroproof::internal
