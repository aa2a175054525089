#include "apps/draw/static_labels.h"

#include <algorithm>
#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>

#include "apps/draw/digit_pen.h"
#include "library/diagram_geometry.h"

namespace voroproof::internal {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using LabelPoint = bg::model::d2::point_xy<double>;
using LabelBox = bg::model::box<LabelPoint>;

bool is_digits(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return '0' <= c && c <= '9'; });
}

// The height of a letter in a font of size 1.
constexpr double letter = 0.73;

void use_font(cairo_t* cairo, double height) {
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, height / letter);
}

class Room {
 public:
  Room(const std::vector<LabelledDisk>& disks, double size) : size_(size) {
    std::vector<Centre> all;
    for (std::size_t k = 0; k < disks.size(); ++k) {
      all.emplace_back(LabelPoint(disks[k].center[0], disks[k].center[1]), k);
    }
    centres_ = decltype(centres_)(all);
  }

  bool is_free(const LabelBox& box, std::size_t own) const {
    const auto &low = box.min_corner(), &high = box.max_corner();
    if (low.x() < 0 || low.y() < 0 || high.x() > size_ || high.y() > size_) return false;
    if (labels_.qbegin(bgi::intersects(box)) != labels_.qend()) return false;
    const auto is_other = [own](const Centre& c) { return c.second != own; };
    return centres_.qbegin(bgi::intersects(box) && bgi::satisfies(is_other)) == centres_.qend();
  }

  void take(const LabelBox& box) { labels_.insert(box); }

 private:
  using Centre = std::pair<LabelPoint, std::size_t>;
  double size_;
  bgi::rtree<Centre, bgi::quadratic<16>> centres_;
  bgi::rtree<LabelBox, bgi::quadratic<16>> labels_;
};

// Whether the segment meets the box: its part between two sides of the box is not beyond the other
// two.
bool meets(const Vec2& a, const Vec2& b, const LabelBox& box) {
  double from = 0, to = 1;
  const std::array<double, 2> low{box.min_corner().x(), box.min_corner().y()},
      high{box.max_corner().x(), box.max_corner().y()};
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis];
    if (step == 0) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return false;
      continue;
    }
    const double one = (low[axis] - a[axis]) / step, other = (high[axis] - a[axis]) / step;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return from <= to;
}

bool contains(const std::vector<Vec2>& polygon, const LabelBox& box) {
  const double x = box.min_corner().x(), y = box.min_corner().y();
  bool is_inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (meets(a, b, box)) return false;
    if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
      is_inside = !is_inside;
    }
  }
  return is_inside;
}

bool has_room(const LabelledDisk& disk, const LabelBox& box) {
  return disk.cell.empty() ||
         std::any_of(disk.cell.begin(), disk.cell.end(),
                     [&](const auto& polygon) { return contains(polygon, box); });
}

// In the disk, where it has room for it, else above, below, right and left of it.
std::vector<Vec2> places(const LabelledDisk& disk, double width, double height) {
  const double gap = 0.5 * height;
  const double up = disk.radius + gap + height / 2, aside = disk.radius + gap + width / 2;
  std::vector<Vec2> all;
  if (std::hypot(width, height) / 2 < 0.95 * disk.radius) all.push_back(disk.center);
  for (const Vec2& off : {Vec2{0, -up}, Vec2{0, up}, Vec2{aside, 0}, Vec2{-aside, 0}}) {
    all.push_back(disk.center + off);
  }
  return all;
}

}  // namespace

double label_width(cairo_t* cairo, const std::string& text, double height) {
  if (is_digits(text)) return 0.82 * height * static_cast<double>(text.size());
  use_font(cairo, height);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

void write_label(cairo_t* cairo, const std::string& text, const Vec2& middle, double height) {
  if (is_digits(text)) {
    DigitPen(cairo).write(text, middle, height);
    return;
  }
  const double width = label_width(cairo, text, height);
  cairo_move_to(cairo, middle[0] - width / 2, middle[1] + height / 2);
  cairo_show_text(cairo, text.c_str());
}

std::vector<PlacedLabel> place_labels(cairo_t* cairo, const std::vector<LabelledDisk>& disks,
                                      double size) {
  Room room(disks, size);
  std::vector<PlacedLabel> placed;
  const auto place = [&](std::size_t k) {
    const LabelledDisk& disk = disks[k];
    if (disk.text.empty()) return;
    for (const double share : {0.016, 0.011}) {
      const double height = share * size, width = label_width(cairo, disk.text, height);
      for (const Vec2& middle : places(disk, width, height)) {
        // Letters reach below their line; a little room around is theirs, too.
        const Vec2 half{0.5 * width + 0.2 * height, 0.8 * height};
        const LabelBox box({middle[0] - half[0], middle[1] - half[1]},
                           {middle[0] + half[0], middle[1] + half[1]});
        if (!room.is_free(box, k) || !has_room(disk, box)) continue;
        room.take(box);
        placed.push_back({k, middle, height});
        return;
      }
    }
  };
  for (const bool hidden : {false, true}) {
    for (std::size_t k = 0; k < disks.size(); ++k) {
      if (disks[k].cell.empty() == hidden) place(k);
    }
  }
  return placed;
}

}  // namespace voroproof::internal
