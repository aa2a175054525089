// A plain-double kinetic Voronoi engine of the usual kind, for one purpose: to be held against the
// corpus. It stands alone and uses nothing of this project. Scenes in general position come out
// right; ties, double roots and degenerate starts, which tolerances decide here, need not.
//
// usage: plain-double SCENE HISTORY
//
// The diagram at 0 is found by trying all circles; an edge flips at a root of a polynomial of
// degree 8, a pair touches at a root of a quadratic; the next event is the least of all predicted.
#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

constexpr double same_time = 1e-9;      // events closer than this are simultaneous
constexpr double same_distance = 1e-7;  // circles closer than this touch, relative to the container
constexpr double equal_radii = 1e-9;
constexpr double tie_breaker = 1e-12;  // for radii, relative to the container
constexpr double never = std::numeric_limits<double>::infinity();
constexpr int most_events_at_once = 10000;

struct Vec {
  double x = 0, y = 0;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
double length(Vec a) { return std::hypot(a.x, a.y); }

// ---- Polynomials in the time from now, lowest power first. ----

using Poly = std::vector<double>;

double value(const Poly& p, double t) {
  double sum = 0;
  for (std::size_t k = p.size(); k-- > 0;) sum = sum * t + p[k];
  return sum;
}

// a + factor b
Poly sum(const Poly& a, const Poly& b, double factor = 1) {
  Poly c(std::max(a.size(), b.size()));
  for (std::size_t k = 0; k < a.size(); ++k) c[k] += a[k];
  for (std::size_t k = 0; k < b.size(); ++k) c[k] += factor * b[k];
  return c;
}

Poly product(const Poly& a, const Poly& b) {
  Poly c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

// The places in (0, end) where p changes its sign, in order: between two of those of its
// derivative there is one at most.
std::vector<double> roots(const Poly& p, double end) {
  if (p.size() < 2) return {};
  Poly derivative;
  for (std::size_t k = 1; k < p.size(); ++k) derivative.push_back(static_cast<double>(k) * p[k]);
  std::vector<double> bounds = roots(derivative, end), found;
  bounds.push_back(end);
  double lo = 0;
  for (const double bound : bounds) {
    double a = lo, b = bound;
    lo = bound;
    const bool positive = value(p, a) > 0;
    if (positive == (value(p, b) > 0)) continue;
    for (double middle = (a + b) / 2; middle > a && middle < b; middle = (a + b) / 2) {
      ((value(p, middle) > 0) == positive ? a : b) = middle;
    }
    found.push_back(b);
  }
  return found;
}

// ---- Generators and the diagram. ----

struct Disk {
  Vec center, velocity;  // the centre at time `since`
  double radius, mass, since = 0;
  Vec at(double t) const { return center + (t - since) * velocity; }
};

struct Circle {
  Vec center;
  double radius;
};

// The edge from the vertex [l,s,r] to the vertex [l,r,e].
struct Edge {
  int l, r, s, e;
  std::array<int, 4> name() const {
    return std::min(std::array{l, r, s, e}, std::array{r, l, e, s});
  }
};

// A vertex: its generators counterclockwise; beyond its edge of g[k] and g[k+1] lies the vertex
// over[k].
struct Vertex {
  std::array<int, 3> g{}, over{};
  int place(int first, int second) const {
    for (int k = 0; k < 3; ++k) {
      if (g[k] == first && g[(k + 1) % 3] == second) return k;
    }
    throw std::runtime_error("the diagram is broken");
  }
  int third(int first, int second) const { return g[(place(first, second) + 2) % 3]; }
  int& across(int first, int second) { return over[place(first, second)]; }
};

// Events at the same time come in this order.
enum class Kind { collision, maneuver, flip };
struct Event {
  double t = never;
  Kind kind = Kind::flip;
  int i = 0, j = 0;  // the pair that collides; of a flip i is the half-edge
};

class Simulation {
 public:
  Simulation(const std::string& scene, const std::string& history)
      : out_(history, std::ios::binary) {
    read(scene);
    build_diagram();
  }

  void run() {
    out_ << header().dump() << '\n';
    flips_.resize(3 * vertices_.size());
    contacts_.resize(flips_.size());
    walls_.resize(static_cast<std::size_t>(n_));
    for (int h = 0; h < half_edges(); ++h) predict(h);
    for (int i = 0; i < n_; ++i) walls_[i] = contact_time(-1, i);
    int at_once = 0;
    for (Event event = next(); event.t < never; event = next()) {
      at_once = event.t > now_ ? 0 : at_once + 1;
      if (at_once > most_events_at_once) throw std::runtime_error("time stands still");
      now_ = std::max(now_, event.t);
      const Json line = event.kind == Kind::flip        ? flip(event.i)
                        : event.kind == Kind::collision ? collide(event.i, event.j)
                                                        : maneuver();
      out_ << line.dump() << '\n';
    }
    const Json end{
        {"t", horizon_}, {"flips", done_[2]}, {"collisions", done_[0]}, {"maneuvers", done_[1]}};
    out_ << Json{{"end", end}}.dump() << '\n' << std::flush;
    if (!out_) throw std::runtime_error("cannot write the history");
  }

 private:
  // ---- Files. ----

  static double number(const Json& j) {
    if (!j.is_string()) return j.get<double>();
    const std::string text = j;
    const std::size_t slash = text.find('/');
    const double whole = std::strtod(text.c_str(), nullptr);
    return slash == text.npos ? whole : whole / std::strtod(text.c_str() + slash + 1, nullptr);
  }
  static double number(const Json& j, const char* name, double otherwise) {
    return j.contains(name) ? number(j.at(name)) : otherwise;
  }
  static Vec vector(const Json& j) { return {number(j.at(0)), number(j.at(1))}; }
  static Json json(Vec v) { return {v.x, v.y}; }

  void read(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
    SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
    for (const unsigned char byte : digest) {
      char hex[3];
      std::snprintf(hex, sizeof hex, "%02x", byte);
      sha256_ += hex;
    }
    const Json scene = Json::parse(bytes);
    horizon_ = number(scene.at("horizon"));
    restitution_ = number(scene, "restitution", 1);
    whole_ = scene.value("container_law", "normal") == "whole";
    const Json& wall = scene.at("container");
    wall_restitution_ = number(wall, "restitution", 1);
    disks_.push_back({vector(wall.at("center")), {}, -number(wall.at("radius")), 0});
    for (const Json& d : scene.at("disks")) {
      const double r = number(d.at("radius"));
      const double mass = number(d, "mass", r * r);
      disks_.push_back({vector(d.at("center")), vector(d.at("velocity")), r, mass});
      ++n_;
    }
    maneuvers_ = scene.value("maneuvers", Json::array());
  }

  Json header() const {
    std::vector<std::array<int, 4>> edges;
    for (int h = 0; h < half_edges(); ++h) {
      if (edge(h).l < edge(h).r) edges.push_back(edge(h).name());
    }
    std::sort(edges.begin(), edges.end());
    return {{"format", "voroproof-history"}, {"version", 1},
            {"scene_sha256", sha256_},       {"horizon", horizon_},
            {"producer", "plain-double 1"},  {"initial", edges}};
  }

  // ---- Geometry. The container is the generator -1, its radius negative. ----

  const Disk& disk(int id) const { return disks_[id + 1]; }
  Disk& disk(int id) { return disks_[id + 1]; }
  double size() const { return -disks_[0].radius; }

  // How far the generator is from touching the circle.
  double clearance(const Circle& c, int id) const {
    const double d = length(disk(id).at(now_) - c.center);
    return id < 0 ? size() - d - c.radius : d - disk(id).radius - c.radius;
  }

  bool counterclockwise(const Circle& c, const std::array<int, 3>& g) const {
    std::array<Vec, 3> touch;
    for (int k = 0; k < 3; ++k) {
      const Vec d = disk(g[k]).at(now_) - c.center;
      touch[k] = (g[k] < 0 ? -1 : 1) / length(d) * d;
    }
    return cross(touch[1] - touch[0], touch[2] - touch[0]) > 0;
  }

  // The circles that the three touch in this order, counterclockwise. Seen from the first centre,
  // with the first radius taken off all: the centre m n, |n| = 1, has n c / p + s / p = 1 / (2 m)
  // for the centre c and the radius s of each other, p = c c - s s.
  std::vector<Circle> circles(const std::array<int, 3>& g) const {
    std::array<int, 3> order = g;
    if (order[0] < 0) std::rotate(order.begin(), order.begin() + 1, order.end());
    const Vec origin = disk(order[0]).at(now_);
    std::array<Vec, 2> c;
    std::array<double, 2> s{};
    for (int k = 0; k < 2; ++k) {
      const Vec d = disk(order[k + 1]).at(now_) - origin;
      const double dr = disk(order[k + 1]).radius - disk(order[0]).radius;
      const double p = dot(d, d) - dr * dr;
      c[k] = 1 / p * d;
      s[k] = dr / p;
    }
    const Vec d = c[0] - c[1];
    const double ds = s[0] - s[1], root = std::sqrt(dot(d, d) - ds * ds);
    std::vector<Circle> found;
    for (const double side : {root, -root}) {
      const Vec n = 1 / dot(d, d) * (side * Vec{-d.y, d.x} - ds * d);
      const double m = 0.5 / (dot(n, c[0]) + s[0]);
      const Circle circle{origin + m * n, m - disk(order[0]).radius};
      const bool exists = m > 0 && circle.radius > 0 && circle.radius < size();
      if (exists && counterclockwise(circle, g)) found.push_back(circle);
    }
    return found;
  }

  // ---- The diagram at 0. ----

  void build_diagram() {
    // Where circles have a fourth generator, what comes just after 0 decides, and where it stays
    // there, the ids: a small step and hardly different radii do that mostly.
    const std::vector<Disk> unchanged = disks_;
    for (int i = 0; i < n_; ++i) disk(i).radius += tie_breaker * (i + 1) * size();
    now_ = same_time;
    std::vector<Circle> of_vertex;
    for (int i = -1; i < n_; ++i) {
      for (int j = i + 1; j < n_; ++j) {
        for (int k = j + 1; k < n_; ++k) {
          for (const auto& g : {std::array{i, j, k}, std::array{i, k, j}}) {
            for (const Circle& c : circles(g)) {
              if (!empty(c, g)) continue;
              vertices_.push_back({g, {}});
              of_vertex.push_back(c);
            }
          }
        }
      }
    }
    if (n_ > 1 && static_cast<int>(vertices_.size()) != 2 * (n_ + 1) - 4) {
      throw std::runtime_error("the diagram at 0 is degenerate");
    }
    for (int l = 0; l < n_; ++l) join_around(l, of_vertex);
    now_ = 0;
    disks_ = unchanged;
  }

  bool empty(const Circle& c, const std::array<int, 3>& g) const {
    for (int id = -1; id < n_; ++id) {
      if (std::find(g.begin(), g.end(), id) == g.end() && clearance(c, id) <= 0) return false;
    }
    return true;
  }

  // Cells are star-shaped: vertices that follow one another round the disk share an edge.
  void join_around(int l, const std::vector<Circle>& of_vertex) {
    std::vector<std::pair<double, int>> around;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      const auto& g = vertices_[v].g;
      if (std::find(g.begin(), g.end(), l) == g.end()) continue;
      const Vec d = of_vertex[v].center - disk(l).at(now_);
      around.emplace_back(std::atan2(d.y, d.x), static_cast<int>(v));
    }
    std::sort(around.begin(), around.end());
    for (std::size_t k = 0; k < around.size(); ++k) {
      const int start = around[k].second, end = around[(k + 1) % around.size()].second;
      const auto& g = vertices_[start].g;
      const int r = g[(std::find(g.begin(), g.end(), l) - g.begin() + 2) % 3];
      vertices_[start].across(r, l) = end;
      vertices_[end].across(l, r) = start;
    }
  }

  // ---- What is predicted. ----

  int half_edges() const { return static_cast<int>(3 * vertices_.size()); }

  // Half-edge 3 v + k ends at v, between its generators k and k + 1.
  Edge edge(int h) const {
    const Vertex& end = vertices_[h / 3];
    const int k = h % 3, l = end.g[k], r = end.g[(k + 1) % 3];
    return {l, r, vertices_[end.over[k]].third(r, l), end.g[(k + 2) % 3]};
  }

  // |c_i - c_j|^2 - (r_i - r_j)^2
  Poly power(int i, int j) const {
    const Vec d = disk(i).at(now_) - disk(j).at(now_), v = disk(i).velocity - disk(j).velocity;
    const double dr = disk(i).radius - disk(j).radius;
    return {dot(d, d) - dr * dr, 2 * dot(d, v), dot(v, v)};
  }

  // Zero where the four have a common tangent circle; for equal radii, whose every root is double
  // there, zero where their centres lie on a circle.
  Poly cotangency(const std::array<int, 4>& g) const {
    if (std::all_of(g.begin(), g.end(), [&](int id) {
          return std::abs(disk(id).radius - disk(g[0]).radius) < equal_radii;
        })) {
      return cocircularity(g);
    }
    const Poly a = product(power(g[0], g[1]), power(g[2], g[3]));
    const Poly b = product(power(g[0], g[2]), power(g[1], g[3]));
    const Poly c = product(power(g[0], g[3]), power(g[1], g[2]));
    const Poly d = sum(sum(a, b), c, -1);
    return sum(product(d, d), product(a, b), -4);
  }

  Poly cocircularity(const std::array<int, 4>& g) const {
    std::array<Poly, 3> x, y, p;
    for (int k = 0; k < 3; ++k) {
      const Vec d = disk(g[k + 1]).at(now_) - disk(g[0]).at(now_);
      const Vec v = disk(g[k + 1]).velocity - disk(g[0]).velocity;
      x[k] = {d.x, v.x};
      y[k] = {d.y, v.y};
      p[k] = power(g[k + 1], g[0]);
    }
    Poly determinant;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Poly minor = sum(product(x[i], y[j]), product(x[j], y[i]), -1);
      determinant = sum(determinant, product(p[k], minor));
    }
    return determinant;
  }

  double flip_time(const Edge& q) {
    if (q.s == q.e) return never;
    const double now = now_;
    double found = never;
    for (const double t : roots(cotangency({q.l, q.r, q.s, q.e}), horizon_ - now)) {
      if (t < same_time) continue;  // an edge that has just flipped has a root here
      now_ = now + t;
      for (const Circle& c : circles({q.l, q.s, q.r})) {
        // The edge shrinks to a point if its four touch one circle in the order l, s, r, e.
        const bool touches = std::abs(clearance(c, q.e)) < same_distance * size();
        if (touches && counterclockwise(c, {q.l, q.r, q.e})) found = std::min(found, now_);
      }
      if (found < never) break;
    }
    now_ = now;
    return found;
  }

  double contact_time(int i, int j) const {
    const Vec d = disk(j).at(now_) - disk(i).at(now_), v = disk(j).velocity - disk(i).velocity;
    const double reach = disk(i).radius + disk(j).radius;
    const double a = dot(v, v), b = dot(d, v), c = dot(d, d) - reach * reach;
    if (a == 0 || b * b - a * c <= 0) return never;
    const double root = std::sqrt(b * b - a * c);
    if (i >= 0 && b >= 0) return never;
    const double t = i >= 0 ? c / (root - b) : b > 0 ? -c / (b + root) : (root - b) / a;
    return now_ + std::max(t, 0.0);
  }

  void predict(int h) {
    const Edge q = edge(h);
    const bool once = q.l < q.r;  // takes one of the two half-edges of an edge
    flips_[h] = once ? flip_time(q) : never;
    contacts_[h] = once && q.l >= 0 ? contact_time(q.l, q.r) : never;
  }

  void predict_around(int id) {
    walls_[id] = contact_time(-1, id);
    for (int h = 0; h < half_edges(); ++h) {
      const Edge q = edge(h);
      if (q.l == id || q.r == id || q.s == id || q.e == id) predict(h);
    }
  }

  Event next() const {
    Event first;
    const auto offer = [&](const Event& event) {
      if (event.t > horizon_) return;
      const bool tie = std::abs(event.t - first.t) < same_time;
      if (tie ? event.kind < first.kind : event.t < first.t) first = event;
    };
    for (int h = 0; h < half_edges(); ++h) {
      offer({contacts_[h], Kind::collision, edge(h).l, edge(h).r});
      offer({flips_[h], Kind::flip, h});
    }
    for (int i = 0; i < n_; ++i) offer({walls_[i], Kind::collision, -1, i});
    if (done_[1] < maneuvers_.size()) {
      offer({number(maneuvers_[done_[1]].at("t")), Kind::maneuver});
    }
    return first;
  }

  // ---- What happens. ----

  void move(int id, Vec velocity) {
    disk(id) = {disk(id).at(now_), velocity, disk(id).radius, disk(id).mass, now_};
  }

  Json maneuver() {
    const Json& m = maneuvers_[done_[1]++];
    const int id = m.at("disk");
    move(id, vector(m.at("velocity")));
    predict_around(id);
    return {{"t", now_},
            {"maneuver", id},
            {"v", json(disk(id).velocity)},
            {"p", json(disk(id).center)}};
  }

  Json collide(int i, int j) {
    ++done_[0];
    const Disk a = disk(i), b = disk(j);
    const Vec n = b.at(now_) - a.at(now_);
    const Vec towards = dot(b.velocity - a.velocity, n) / dot(n, n) * n;
    if (i >= 0) {
      const double mass = (1 + restitution_) / (a.mass + b.mass);
      move(i, a.velocity + mass * b.mass * towards);
      move(j, b.velocity - mass * a.mass * towards);
    } else if (whole_) {
      move(j, wall_restitution_ * (b.velocity - 2 * towards));
    } else {
      move(j, b.velocity - (1 + wall_restitution_) * towards);
    }
    if (i >= 0) predict_around(i);
    predict_around(j);
    const auto both = [&](Vec Disk::*member) -> Json {
      return Json::array({i < 0 ? Json() : json(disk(i).*member), json(disk(j).*member)});
    };
    return {{"t", now_},
            {"collide", Json::array({i, j})},
            {"v", both(&Disk::velocity)},
            {"p", both(&Disk::center)}};
  }

  // The vertices [l,s,r] and [l,r,e] become [l,s,e] and [r,e,s].
  Json flip(int h) {
    ++done_[2];
    const Edge q = edge(h);
    const int b = h / 3, a = vertices_[b].across(q.l, q.r);
    const int ls = vertices_[a].across(q.l, q.s), sr = vertices_[a].across(q.s, q.r);
    const int re = vertices_[b].across(q.r, q.e), el = vertices_[b].across(q.e, q.l);
    vertices_[a] = {{q.l, q.s, q.e}, {ls, b, el}};
    vertices_[b] = {{q.r, q.e, q.s}, {re, a, sr}};
    vertices_[el].across(q.l, q.e) = a;
    vertices_[sr].across(q.r, q.s) = b;
    for (const int v : {a, b, ls, sr, re, el}) {
      for (int k = 0; k < 3; ++k) predict(3 * v + k);
    }
    return {{"t", now_}, {"flip", q.name()}};
  }

  std::ofstream out_;
  std::string sha256_;
  double now_ = 0, horizon_ = 0, restitution_ = 1, wall_restitution_ = 1;
  bool whole_ = false;
  int n_ = 0;
  std::vector<Disk> disks_;  // the container first
  Json maneuvers_;
  std::vector<Vertex> vertices_;
  std::vector<double> flips_, contacts_, walls_;  // by half-edge, half-edge, disk
  std::array<std::size_t, 3> done_{};             // events, by kind
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: plain-double SCENE HISTORY\n", stderr);
    return 2;
  }
  try {
    Simulation(argv[1], argv[2]).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plain-double: %s\n", error.what());
    return 1;
  }
  return 0;
}
