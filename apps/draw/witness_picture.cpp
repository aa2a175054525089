#include "apps/draw/witness_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "apps/draw/colours.h"
#include "apps/draw/digit_pen.h"
#include "apps/draw/picture.h"
#include "library/palette.h"

namespace voroproof::internal {

namespace {

constexpr int picture_size = 800;

constexpr Colour tangent_ink{0.85, 0.20, 0.17};  // as the movie draws evidence

struct Circle {
  Vec2 center;
  double radius;
};

// The two circles that touch three generators from outside (the container from inside): the
// difference of two of |x - c| = rho + r is linear in (x, rho).
std::vector<Circle> tangent_circles(const DrawnGenerator& a, const DrawnGenerator& b,
                                    const DrawnGenerator& c) {
  const double x1 = b.center[0] - a.center[0], y1 = b.center[1] - a.center[1];
  const double x2 = c.center[0] - a.center[0], y2 = c.center[1] - a.center[1];
  const double s1 = b.radius - a.radius, s2 = c.radius - a.radius;
  const double k1 = (x1 * x1 + y1 * y1 - s1 * s1) / 2, k2 = (x2 * x2 + y2 * y2 - s2 * s2) / 2;
  const double det = x1 * y2 - x2 * y1;
  if (det == 0) return {};
  // x = u + v tau with tau = rho + r_a the distance from the centre of a.
  const Vec2 u{(k1 * y2 - k2 * y1) / det, (x1 * k2 - x2 * k1) / det};
  const Vec2 v{(s2 * y1 - s1 * y2) / det, (x2 * s1 - x1 * s2) / det};
  const double qa = v[0] * v[0] + v[1] * v[1] - 1, qb = u[0] * v[0] + u[1] * v[1],
               qc = u[0] * u[0] + u[1] * u[1];
  std::vector<Circle> circles;
  const double discriminant = qb * qb - qa * qc;
  if (discriminant < 0) return circles;
  for (const double sign : {-1.0, 1.0}) {
    const double tau =
        std::fabs(qa) < 1e-12 ? -qc / (2 * qb) : (-qb + sign * std::sqrt(discriminant)) / qa;
    const Circle circle{{a.center[0] + u[0] + v[0] * tau, a.center[1] + u[1] + v[1] * tau},
                        tau - a.radius};
    const auto touches = [&](const DrawnGenerator& g) {
      const double d = std::hypot(circle.center[0] - g.center[0], circle.center[1] - g.center[1]);
      const double reach = g.radius < 0 ? -g.radius - circle.radius : g.radius + circle.radius;
      return std::fabs(d - reach) <= 1e-6 * (1 + std::fabs(circle.radius) + std::fabs(g.radius));
    };
    if (circle.radius > 0 && touches(a) && touches(b) && touches(c)) circles.push_back(circle);
  }
  return circles;
}

class WitnessPainter {
 public:
  WitnessPainter(cairo_t* cairo, const std::vector<DrawnGenerator>& generators)
      : cairo_(cairo), generators_(generators) {
    const std::size_t n = generators.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        for (std::size_t k = j + 1; k < n; ++k) {
          for (const Circle& c : tangent_circles(generators[i], generators[j], generators[k])) {
            circles_.push_back(c);
          }
        }
      }
    }
    keep_common();
    frame();
  }

  void paint() {
    use(white);
    cairo_paint(cairo_);
    for (const Circle& c : circles_) {
      circle(c);
      use(tangent_ink, 0.02);
      cairo_fill(cairo_);
    }
    for (const DrawnGenerator& g : generators_) {
      circle({g.center, std::fabs(g.radius)});
      if (g.radius < 0) {
        stroke(ink, 2.5);
        continue;
      }
      use(disk_colour(static_cast<std::size_t>(g.id)));
      cairo_fill_preserve(cairo_);
      stroke(ink, 1.2);
    }
    const double dashes[] = {8, 5};
    cairo_set_dash(cairo_, dashes, 2, 0);
    for (const Circle& c : circles_) {
      circle(c);
      stroke(tangent_ink, 1.6);
    }
    cairo_set_dash(cairo_, nullptr, 0, 0);
    const DigitPen pen(cairo_);
    for (const DrawnGenerator& g : generators_) {
      if (g.radius < 0) continue;
      velocity(g);
      use(ink);
      pen.write(std::to_string(g.id), pixel(g.center), 16);
    }
  }

 private:
  // Where some circles touch all generators, up to rounding, these are the evidence and the others
  // are left out.
  void keep_common() {
    const auto touches = [](const Circle& c, const DrawnGenerator& g) {
      const double d = std::hypot(c.center[0] - g.center[0], c.center[1] - g.center[1]);
      const double gap = g.radius < 0 ? -g.radius - d : d - g.radius;
      return std::fabs(gap - c.radius) <= 1e-4 * c.radius;
    };
    std::vector<Circle> common;
    for (const Circle& c : circles_) {
      if (std::all_of(generators_.begin(), generators_.end(),
                      [&](const DrawnGenerator& g) { return touches(c, g); })) {
        common.push_back(c);
      }
    }
    if (!common.empty()) circles_ = std::move(common);
  }

  // Shows the disks and those circles that are not much larger than they are apart; the container
  // whole only where there is nothing else.
  void frame() {
    std::vector<Circle> shown;
    for (const DrawnGenerator& g : generators_) {
      if (g.radius >= 0) shown.push_back({g.center, g.radius});
    }
    if (shown.empty()) shown.push_back({generators_[0].center, -generators_[0].radius});
    box(shown);
    for (const Circle& c : circles_) {
      if (c.radius < 2 * half_) shown.push_back(c);
    }
    box(shown);
  }

  void box(const std::vector<Circle>& circles) {
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    for (const Circle& c : circles) {
      x0 = std::min(x0, c.center[0] - c.radius);
      x1 = std::max(x1, c.center[0] + c.radius);
      y0 = std::min(y0, c.center[1] - c.radius);
      y1 = std::max(y1, c.center[1] + c.radius);
    }
    middle_ = {(x0 + x1) / 2, (y0 + y1) / 2};
    half_ = std::max({(x1 - x0) / 2, (y1 - y0) / 2, 1e-300}) * 1.15;
    scale_ = picture_size / (2 * half_);
  }

  Vec2 pixel(const Vec2& p) const {
    return {picture_size / 2.0 + scale_ * (p[0] - middle_[0]),
            picture_size / 2.0 - scale_ * (p[1] - middle_[1])};
  }

  void circle(const Circle& c) {
    const Vec2 p = pixel(c.center);
    cairo_new_path(cairo_);
    cairo_arc(cairo_, p[0], p[1], std::max(scale_ * c.radius, 2.0), 0, 2 * std::numbers::pi);
    cairo_close_path(cairo_);
  }

  void use(const Colour& c, double alpha = 1) {
    cairo_set_source_rgba(cairo_, c.red, c.green, c.blue, alpha);
  }

  void stroke(const Colour& c, double width) {
    use(c);
    cairo_set_line_width(cairo_, width);
    cairo_stroke(cairo_);
  }

  // An arrow from the rim, the fastest an eighth of the picture long.
  void velocity(const DrawnGenerator& g) {
    double fastest = 0;
    for (const DrawnGenerator& other : generators_) {
      fastest = std::max(fastest, std::hypot(other.velocity[0], other.velocity[1]));
    }
    const double speed = std::hypot(g.velocity[0], g.velocity[1]);
    if (speed == 0) return;
    const Vec2 along{g.velocity[0] / speed, -g.velocity[1] / speed};
    const double reach = picture_size / 8.0 * speed / fastest, rim = scale_ * g.radius;
    const Vec2 center = pixel(g.center);
    const auto at = [&](double forward, double aside) -> Vec2 {
      return {center[0] + forward * along[0] - aside * along[1],
              center[1] + forward * along[1] + aside * along[0]};
    };
    const Vec2 tail = at(rim, 0), tip = at(rim + reach, 0);
    cairo_new_path(cairo_);
    cairo_move_to(cairo_, tail[0], tail[1]);
    cairo_line_to(cairo_, tip[0], tip[1]);
    for (const double side : {5.0, -5.0}) {
      const Vec2 barb = at(rim + reach - 10, side);
      cairo_move_to(cairo_, tip[0], tip[1]);
      cairo_line_to(cairo_, barb[0], barb[1]);
    }
    stroke(arrow_ink, 1.8);
  }

  cairo_t* cairo_;
  const std::vector<DrawnGenerator>& generators_;
  std::vector<Circle> circles_;
  Vec2 middle_{};
  double half_ = 1, scale_ = 1;
};

}  // namespace

void draw_witness(const std::vector<DrawnGenerator>& generators, const std::string& path) {
  write_picture(path, picture_size,
                [&](cairo_t* cairo) { WitnessPainter(cairo, generators).paint(); });
}

}  // namespace voroproof::internal
