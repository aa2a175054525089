// Where labels of disks at rest have room in a picture.
#pragma once

#include <cairo.h>

#include <optional>
#include <string>
#include <vector>

#include "history/events.h"

namespace voroproof::internal {

// A disk of a picture, in pixels, y downwards.
struct LabelledDisk {
  std::string text;
  Vec2 center;
  double radius;
  std::vector<std::vector<Vec2>> cell;  // polygons; none where it is hidden
};

struct PlacedLabel {
  std::size_t disk;
  Vec2 middle;
  double height;
};

// The width of a text of this height, in pixels.
double label_width(cairo_t* cairo, const std::string& text, double height);
// Writes it around the place, in the colour that is set: digits as strokes (DigitPen), other texts
// in the system's sans-serif type.
void write_label(cairo_t* cairo, const std::string& text, const Vec2& middle, double height);

// The labels that have room, those of visible disks first: in the disk or beside it, within its
// cell and the picture of `size` pixels, and neither on another disk's centre nor on a label. That
// of a hidden disk needs no cell.
std::vector<PlacedLabel> place_labels(cairo_t* cairo, const std::vector<LabelledDisk>& disks,
                                      double size);

}  // namespace voroproof::internal
