#include "tests/oracle/brute_force.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "tests/oracle/tangent_circles.h"

namespace voroproof::oracle {
namespace {

// ---- Vertices ----

struct EmptyCircle {
  TangentCircle circle;
  std::vector<int> contacts;
};

using Direction = std::array<Work, 2>;

bool smaller_angle(const Direction& a, const Direction& b) {
  const auto lower_half = [](const Direction& d) { return d[1] < 0 || (d[1] == 0 && d[0] < 0); };
  const bool low_a = lower_half(a), low_b = lower_half(b);
  return low_a != low_b ? low_b : a[0] * b[1] > a[1] * b[0];
}

// Sorts `items` by the angle of direction(item), counterclockwise.
template <class Item, class DirectionOf>
void sort_by_angle(std::vector<Item>& items, DirectionOf direction) {
  std::vector<std::pair<Direction, Item>> keyed;
  for (const Item& item : items) keyed.emplace_back(direction(item), item);
  std::sort(keyed.begin(), keyed.end(),
            [](const auto& a, const auto& b) { return smaller_angle(a.first, b.first); });
  for (std::size_t i = 0; i < items.size(); ++i) items[i] = keyed[i].second;
}

void start_with(std::vector<int>& cycle, int id) {
  std::rotate(cycle.begin(), std::find(cycle.begin(), cycle.end(), id), cycle.end());
}

// All generators tangent to the circle, counterclockwise from the smallest id; none when the
// circle is not empty.
std::vector<int> contacts_if_empty(const Generators& generators, const TangentCircle& circle) {
  std::vector<int> contacts;
  for (int g = -1; g < generators.disk_count(); ++g) {
    const Work gap = generators.gap(g, circle);
    if (gap < -contact_tolerance()) return {};
    if (gap <= contact_tolerance()) contacts.push_back(g);
  }
  sort_by_angle(contacts, [&](int g) { return generators.contact_direction(g, circle); });
  start_with(contacts, *std::min_element(contacts.begin(), contacts.end()));
  return contacts;
}

std::vector<EmptyCircle> empty_circles(const Generators& generators) {
  const Work container_radius = generators.gap(-1, {0, 0, 0});
  std::vector<EmptyCircle> found;
  const int n = generators.disk_count();
  for (int i = -1; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      for (int k = j + 1; k < n; ++k) {
        for (const TangentCircle& circle : generators.tangent_circles(i, j, k)) {
          if (circle.radius > container_radius || generators.clearly_not_empty(circle)) continue;
          // A cotangent class turns up once for each triple of it.
          const bool known = std::any_of(found.begin(), found.end(), [&](const EmptyCircle& c) {
            return coincide(c.circle, circle);
          });
          if (known) continue;
          std::vector<int> contacts = contacts_if_empty(generators, circle);
          if (!contacts.empty()) found.push_back({circle, std::move(contacts)});
        }
      }
    }
  }
  std::sort(found.begin(), found.end(),
            [](const EmptyCircle& a, const EmptyCircle& b) { return a.contacts < b.contacts; });
  return found;
}

// ---- Edges ----

// Walks around every generator with its cell on the left: counterclockwise around a disk,
// clockwise around the container, whose cell lies outside. The class that starts an edge has the
// edge's right generator last before the left one in its contacts, the class that ends it has it
// first after.
std::set<std::array<int, 4>> links_between(const Generators& generators,
                                           const std::vector<EmptyCircle>& classes) {
  std::map<std::array<int, 4>, int> times_found;
  for (int left = -1; left < generators.disk_count(); ++left) {
    std::vector<int> around;
    for (std::size_t c = 0; c < classes.size(); ++c) {
      const std::vector<int>& contacts = classes[c].contacts;
      if (std::find(contacts.begin(), contacts.end(), left) != contacts.end()) {
        around.push_back(static_cast<int>(c));
      }
    }
    sort_by_angle(around, [&](int c) {
      return generators.direction_from_centre(left, classes[static_cast<std::size_t>(c)].circle);
    });
    if (left < 0) std::reverse(around.begin(), around.end());
    for (std::size_t i = 0; i < around.size(); ++i) {
      const int start = around[i], end = around[(i + 1) % around.size()];
      std::vector<int> at_start = classes[static_cast<std::size_t>(start)].contacts;
      std::vector<int> at_end = classes[static_cast<std::size_t>(end)].contacts;
      start_with(at_start, left);
      start_with(at_end, left);
      if (at_start.back() != at_end[1]) {
        throw std::logic_error("brute force: the walk around generator " + std::to_string(left) +
                               " does not close");
      }
      ++times_found[canonical({left, at_end[1], start, end})];
    }
  }
  std::set<std::array<int, 4>> links;
  for (const auto& [link, times] : times_found) {
    if (times != 2) throw std::logic_error("brute force: an edge was not seen from both sides");
    links.insert(link);
  }
  return links;
}

int third(const std::vector<int>& contacts, int a, int b) {
  return *std::find_if(contacts.begin(), contacts.end(), [=](int g) { return g != a && g != b; });
}

// ---- Comparison ----

// The index of the class in whose contacts the triple occurs in this cyclic order, or -1. There
// is at most one: the counterclockwise tangent circle of a triple is unique.
int class_of(const BruteDiagram& truth, const Triple& vertex) {
  for (std::size_t c = 0; c < truth.classes.size(); ++c) {
    const std::vector<int>& contacts = truth.classes[c].contacts;
    const auto position = [&](int g) { return std::find(contacts.begin(), contacts.end(), g); };
    const auto a = position(vertex[0]), b = position(vertex[1]), d = position(vertex[2]);
    if (a == contacts.end() || b == contacts.end() || d == contacts.end()) continue;
    const bool distinct = a != b && b != d && d != a;
    const int descents = (b < a) + (d < b) + (a < d);
    if (distinct && descents == 1) return static_cast<int>(c);
  }
  return -1;
}

// Whether counterclockwise triangles cover the polygon once: their directed sides must be those
// of the polygon, once each, and pairs of opposite diagonals, once each.
bool triangulates(const std::vector<Triple>& triangles, const std::vector<int>& polygon) {
  std::set<std::pair<int, int>> sides;
  for (const Triple& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!sides.emplace(t[i], t[(i + 1) % 3]).second) return false;
    }
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (sides.erase({polygon[i], polygon[(i + 1) % polygon.size()]}) == 0) return false;
  }
  return triangles.size() + 2 == polygon.size() &&
         std::all_of(sides.begin(), sides.end(), [&](const auto& s) {
           return sides.count({s.second, s.first}) == 1;
         });
}

// Receives the first reason for a disagreement.
class Verdict {
 public:
  explicit Verdict(std::string* why) : why_(why) {}
  bool no(const std::string& reason) const {
    if (why_ != nullptr) *why_ = reason;
    return false;
  }

 private:
  std::string* why_;
};

bool agrees_with_edges(const BruteDiagram& truth, const std::set<Quadruple>& edges,
                       const Verdict& verdict) {
  for (const Quadruple& edge : truth.edges) {
    if (edges.count(edge) == 0) return verdict.no("edge " + text(edge) + " is missing");
  }
  for (const Quadruple& edge : edges) {
    if (truth.edges.count(edge) == 0) return verdict.no("edge " + text(edge) + " does not exist");
  }
  return true;
}

bool agrees_modulo_classes(const BruteDiagram& truth, const std::set<Quadruple>& edges,
                           const Verdict& verdict) {
  std::map<Triple, int> edge_ends;
  for (const Quadruple& edge : edges) {
    ++edge_ends[start_vertex(edge)];
    ++edge_ends[end_vertex(edge)];
  }
  std::map<Triple, int> classes;
  std::vector<std::vector<Triple>> triangles(truth.classes.size());
  for (const auto& [vertex, ends] : edge_ends) {
    if (ends != 3) {
      return verdict.no("vertex " + text(vertex) + " ends " + std::to_string(ends) + " edges");
    }
    const int c = class_of(truth, vertex);
    if (c < 0) return verdict.no("vertex " + text(vertex) + " does not exist");
    classes[vertex] = c;
    triangles[static_cast<std::size_t>(c)].push_back(vertex);
  }
  for (std::size_t c = 0; c < truth.classes.size(); ++c) {
    if (!triangulates(triangles[c], truth.classes[c].contacts)) {
      return verdict.no("the vertices of the cotangent class " + text(truth.classes[c].contacts) +
                        " do not triangulate it");
    }
  }
  std::set<std::array<int, 4>> links;
  for (const Quadruple& edge : edges) {
    const int start = classes[start_vertex(edge)], end = classes[end_vertex(edge)];
    if (start == end) continue;
    const std::array<int, 4> link = canonical({edge[0], edge[1], start, end});
    if (truth.links.count(link) == 0) return verdict.no("edge " + text(edge) + " does not exist");
    if (!links.insert(link).second) return verdict.no("edge " + text(edge) + " exists twice");
  }
  for (const std::array<int, 4>& link : truth.links) {
    if (links.count(link) == 0) {
      return verdict.no("an edge between " + std::to_string(link[0]) + " and " +
                        std::to_string(link[1]) + " is missing");
    }
  }
  return true;
}

}  // namespace

std::set<Triple> BruteDiagram::vertices() const {
  std::set<Triple> result;
  if (degenerate) return result;
  for (const CotangentClass& c : classes) {
    result.insert({c.contacts[0], c.contacts[1], c.contacts[2]});
  }
  return result;
}

BruteDiagram brute_force_diagram(const std::vector<Circle>& disks, const Circle& container) {
  const Generators generators(disks, container);
  generators.check_disjoint();
  BruteDiagram diagram;
  diagram.disk_count = generators.disk_count();
  if (diagram.disk_count < 2) return diagram;

  const std::vector<EmptyCircle> circles = empty_circles(generators);
  std::size_t vertex_count = 0, edge_count = 0;
  for (const EmptyCircle& c : circles) {
    diagram.classes.push_back({generators.restored(c.circle), c.contacts});
    if (c.contacts.size() > 3) diagram.degenerate = true;
    vertex_count += c.contacts.size() - 2;
    edge_count += c.contacts.size() - 3;
  }
  diagram.links = links_between(generators, circles);
  edge_count += diagram.links.size();
  const std::size_t generator_count = disks.size() + 1;
  if (vertex_count != 2 * generator_count - 4 || edge_count != 3 * generator_count - 6) {
    throw std::logic_error("brute force: " + std::to_string(vertex_count) + " vertices and " +
                           std::to_string(edge_count) + " edges for " +
                           std::to_string(generator_count) + " generators");
  }

  if (!diagram.degenerate) {
    for (const auto& [left, right, start, end] : diagram.links) {
      const auto other = [&, l = left, r = right](int c) {
        return third(diagram.classes[static_cast<std::size_t>(c)].contacts, l, r);
      };
      diagram.edges.insert(canonical({left, right, other(start), other(end)}));
    }
  }
  return diagram;
}

bool agrees(const BruteDiagram& truth, const std::vector<Quadruple>& edges, std::string* why) {
  const Verdict verdict(why);
  std::set<Quadruple> canonical_edges;
  for (const Quadruple& edge : edges) {
    if (std::any_of(edge.begin(), edge.end(),
                    [&](int id) { return id < -1 || id >= truth.disk_count; })) {
      return verdict.no("edge " + text(edge) + " names an unknown generator");
    }
    if (!canonical_edges.insert(canonical(edge)).second) {
      return verdict.no("edge " + text(edge) + " is listed twice");
    }
  }
  return truth.degenerate ? agrees_modulo_classes(truth, canonical_edges, verdict)
                          : agrees_with_edges(truth, canonical_edges, verdict);
}

}  // namespace voroproof::oracle
