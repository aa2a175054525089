#include "apps/draw/render_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "library/diagram_geometry.h"

namespace voroproof::internal {
namespace {

constexpr int samples = 48;  // along an edge, besides its ends and extremes

constexpr std::array<std::array<double, 3>, 7> colours{{{0.73, 0.86, 0.95},
                                                        {0.99, 0.87, 0.70},
                                                        {0.80, 0.92, 0.77},
                                                        {0.90, 0.82, 0.94},
                                                        {0.98, 0.80, 0.80},
                                                        {0.98, 0.95, 0.68},
                                                        {0.76, 0.93, 0.90}}};

std::size_t find(std::vector<std::size_t>& group, std::size_t x) {
  while (group[x] != x) x = group[x] = group[group[x]];
  return x;
}

}  // namespace

FreeSpacePicture::FreeSpacePicture(const DiagramFile& diagram, double probe)
    : diagram_(diagram), probe_(probe) {
  std::map<Triple, std::size_t> vertices;
  for (const DiagramVertex& v : diagram.vertices) vertices.emplace(v.generators, vertices.size());
  std::vector<std::size_t> group(diagram.vertices.size());
  for (std::size_t k = 0; k < group.size(); ++k) group[k] = k;
  if (diagram.disks.size() == 1) {
    group.push_back(0);
    add_edge(0, container_id, points_along(0, container_id, {}, {}, true), 0, 0, group);
  }
  for (const Quad& q : diagram.edges) {
    const std::size_t start = vertices.at(start_vertex(q)), end = vertices.at(end_vertex(q));
    add_edge(
        q.l, q.r,
        points_along(q.l, q.r, diagram.vertices[start].center, diagram.vertices[end].center, false),
        start, end, group);
  }
  std::map<std::size_t, std::size_t> numbers;
  for (Region& region : regions_) {
    region.number = numbers.emplace(find(group, region.number), numbers.size()).first->second;
  }
  voids_ = numbers.size();
}

// The free runs of the points join the void of the vertex that they reach, or make one.
void FreeSpacePicture::add_edge(GenId l, GenId r, const std::vector<Vec2>& points,
                                std::size_t start, std::size_t end,
                                std::vector<std::size_t>& group) {
  const GenId disk = l == container_id ? r : l;
  const double reach = signed_radius(diagram_, disk) + probe_;
  const auto is_free = [&](const Vec2& p) { return length(p - center(diagram_, disk)) >= reach; };
  bool passes = true;
  for (std::size_t k = 0; k < points.size();) {
    if (!is_free(points[k])) {
      passes = false;
      ++k;
      continue;
    }
    std::size_t last = k;
    while (last + 1 < points.size() && is_free(points[last + 1])) ++last;
    std::size_t number = group.size();
    group.push_back(number);
    if (k == 0) group[find(group, number)] = find(group, start);
    if (last + 1 == points.size()) group[find(group, number)] = find(group, end);
    // A sample further on each side: what is not free there the disks will cover.
    const std::size_t from = k == 0 ? 0 : k - 1, to = std::min(last + 1, points.size() - 1);
    regions_.push_back({{points.begin() + static_cast<std::ptrdiff_t>(from),
                         points.begin() + static_cast<std::ptrdiff_t>(to) + 1},
                        l,
                        r,
                        number});
    k = last + 1;
  }
  tunnels_.push_back(passes);
}

// The points are computed in polar coordinates about a disk of the edge (render.cpp says more of
// this form of the bisector). Those of the least and the greatest clearance are among them.
std::vector<Vec2> FreeSpacePicture::points_along(GenId l, GenId r, const Vec2& start,
                                                 const Vec2& end, bool closed) const {
  const bool left = l != container_id;
  const GenId base = left ? l : r, other = left ? r : l;
  const Vec2 c = center(diagram_, base), d = center(diagram_, other) - c;
  const double s = signed_radius(diagram_, other) - signed_radius(diagram_, base);
  const double p = dot(d, d) - s * s;
  const double axis = other == container_id ? angle(-1 * d) : angle(d);
  const double first = closed ? axis : angle((left ? start : end) - c);
  double sweep = closed ? 2 * pi : angle((left ? end : start) - c) - first;
  constexpr double least_angle = 1e-9;
  if (sweep < 0) sweep += 2 * pi;
  if (!closed && sweep > 2 * pi - least_angle) sweep = 0;

  std::vector<double> angles;
  for (int k = 0; k <= samples; ++k) angles.push_back(sweep * k / samples);
  for (double extreme : {axis - first, axis + pi - first}) {
    extreme = std::remainder(extreme, 2 * pi);
    if (extreme < 0) extreme += 2 * pi;
    if (extreme < sweep) angles.push_back(extreme);
  }
  std::sort(angles.begin(), angles.end());
  std::vector<Vec2> points;
  for (const double a : angles) {
    const Vec2 n{std::cos(first + a), std::sin(first + a)};
    const double rho = p / (2 * (dot(d, n) + s));
    // Rounding may lead beyond the ends of a short edge, where there is no point.
    if (rho > 0 && std::isfinite(rho)) points.push_back(c + rho * n);
  }
  if (!left) std::reverse(points.begin(), points.end());
  if (!closed && !points.empty()) {
    points.front() = start;
    points.back() = end;
  }
  return points;
}

void FreeSpacePicture::paint(cairo_t* cairo, const std::function<Vec2(const Vec2&)>& pixel,
                             double scale, double width) const {
  const auto circle = [&](const Vec2& centre, double pixels) {
    if (pixels <= 0) return;
    const Vec2 at = pixel(centre);
    cairo_new_path(cairo);
    cairo_arc(cairo, at[0], at[1], pixels, 0, 2 * pi);
    cairo_close_path(cairo);
    cairo_fill(cairo);
  };
  const auto blocked = [&] { cairo_set_source_rgb(cairo, 0.93, 0.93, 0.94); };
  const auto red = [&] { cairo_set_source_rgb(cairo, 0.80, 0.12, 0.12); };
  const double inset = scale * (diagram_.container_radius - probe_);

  const auto clip = [&](double radius) {
    const Vec2 middle = pixel(diagram_.container_center);
    cairo_new_path(cairo);
    cairo_arc(cairo, middle[0], middle[1], radius, 0, 2 * pi);
    cairo_clip(cairo);
  };

  blocked();
  circle(diagram_.container_center, scale * diagram_.container_radius);
  if (inset <= 0) return;
  cairo_save(cairo);
  clip(scale * diagram_.container_radius);
  red();
  circle(diagram_.container_center, inset + width);
  cairo_save(cairo);
  clip(inset);
  cairo_set_source_rgb(cairo, colours[0][0], colours[0][1], colours[0][2]);
  circle(diagram_.container_center, inset);
  for (const Region& region : regions_) {
    const auto& colour = colours[region.number % colours.size()];
    cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
    for (const GenId g : {region.l, region.r}) paint_wedge(cairo, pixel, region, g);
  }
  red();
  for (const DiagramDisk& disk : diagram_.disks) {
    circle(disk.center, scale * (disk.radius + probe_));
  }
  cairo_restore(cairo);
  // The line lies on the side of the disks; its part at the wall where no disk covers it.
  blocked();
  for (const DiagramDisk& disk : diagram_.disks) {
    circle(disk.center, scale * (disk.radius + probe_) - width);
  }
  cairo_restore(cairo);
}

// Paints between the piece and the centre of a disk, or outwards from the piece to the container.
void FreeSpacePicture::paint_wedge(cairo_t* cairo, const std::function<Vec2(const Vec2&)>& pixel,
                                   const Region& region, GenId g) const {
  cairo_new_path(cairo);
  for (const Vec2& p : region.piece) {
    const Vec2 at = pixel(p);
    cairo_line_to(cairo, at[0], at[1]);
  }
  if (g == container_id) {
    const Vec2 o = diagram_.container_center;
    for (auto p = region.piece.rbegin(); p != region.piece.rend(); ++p) {
      const Vec2 out = *p - o;
      // The point lies beyond the rim, so that the chords do not cut the rim.
      const Vec2 at = pixel(o + (1.1 * diagram_.container_radius / length(out)) * out);
      cairo_line_to(cairo, at[0], at[1]);
    }
  } else {
    const Vec2 at = pixel(center(diagram_, g));
    cairo_line_to(cairo, at[0], at[1]);
  }
  cairo_close_path(cairo);
  cairo_fill_preserve(cairo);
  // No seams between neighbours.
  cairo_set_line_width(cairo, 0.6);
  cairo_stroke(cairo);
}

}  // namespace voroproof::internal
