#include "tests/oracle/cgal_apollonius.h"

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "tests/oracle/tangent_circles.h"

namespace voroproof::oracle {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
// Ring operations and signs only: no square roots, no divisions.
using Traits = CGAL::Apollonius_graph_traits_2<Kernel, CGAL::Integral_domain_without_division_tag>;
using Graph = CGAL::Apollonius_graph_2<Traits>;

CGAL::Gmpq cgal(const mpq_class& q) { return CGAL::Gmpq(q.get_mpq_t()); }

Generators generators_of(const std::vector<ExactCircle>& disks, const ExactCircle& container) {
  std::vector<Circle> circles;
  circles.reserve(disks.size());
  for (const ExactCircle& disk : disks) circles.push_back(rounded(disk));
  return Generators(circles, rounded(container));
}

// A face of the graph is a vertex of the diagram. Its circle is the one on which the generators
// in the order of the face have counterclockwise contacts.
TangentCircle circle_of(const Generators& generators, const Triple& face) {
  for (const TangentCircle& circle : generators.tangent_circles(face[0], face[1], face[2])) {
    if (generators.counterclockwise(face[0], face[1], face[2], circle)) return circle;
  }
  throw std::logic_error("CGAL: a face has no counterclockwise tangent circle");
}

// The diagram with its circles in the frame of `generators`.
struct FramedDiagram {
  std::vector<std::pair<Triple, TangentCircle>> vertices;
  std::set<Quadruple> edges;
};

FramedDiagram framed_diagram(const std::vector<ExactCircle>& disks, const Generators& generators) {
  generators.check_disjoint();
  Graph graph;
  // Disjoint disks have distinct centres, which name them.
  std::map<std::pair<CGAL::Gmpq, CGAL::Gmpq>, int> ids;
  for (std::size_t i = 0; i < disks.size(); ++i) {
    const CGAL::Gmpq x = cgal(disks[i].x), y = cgal(disks[i].y);
    ids[{x, y}] = static_cast<int>(i);
    graph.insert(Graph::Site_2(Graph::Point_2(x, y), cgal(disks[i].radius)));
  }
  FramedDiagram diagram;
  if (disks.size() < 3) return diagram;

  const auto id = [&](Graph::Vertex_handle v) {
    return ids.at({v->site().point().x(), v->site().point().y()});
  };
  const auto& triangulation = graph.data_structure();
  for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face) {
    const Triple vertex =
        smallest_first({id(face->vertex(0)), id(face->vertex(1)), id(face->vertex(2))});
    diagram.vertices.emplace_back(vertex, circle_of(generators, vertex));
    for (int i = 0; i < 3; ++i) {
      const Graph::Face_handle neighbour = face->neighbor(i);
      if (graph.is_infinite(neighbour)) continue;
      const int left = id(face->vertex((i + 2) % 3)), right = id(face->vertex((i + 1) % 3));
      const int start = id(face->vertex(i));
      const int end = id(neighbour->vertex(triangulation.mirror_index(face, i)));
      diagram.edges.insert(canonical({left, right, start, end}));
    }
  }
  return diagram;
}

}  // namespace

CgalDiagram cgal_diagram(const std::vector<ExactCircle>& disks, const ExactCircle& container) {
  const Generators generators = generators_of(disks, container);
  FramedDiagram framed = framed_diagram(disks, generators);
  CgalDiagram diagram;
  for (const auto& [vertex, circle] : framed.vertices) {
    diagram.vertices.push_back({vertex, generators.restored(circle)});
  }
  diagram.edges = std::move(framed.edges);
  return diagram;
}

bool agrees_with_cgal(const std::vector<ExactCircle>& disks, const ExactCircle& container,
                      const std::vector<Quadruple>& edges, std::string* why) {
  const auto no = [why](const std::string& reason) {
    if (why != nullptr) *why = reason;
    return false;
  };
  const int n = static_cast<int>(disks.size());
  const Generators generators = generators_of(disks, container);
  const FramedDiagram cgal = framed_diagram(disks, generators);

  // The vertices of both diagrams by circle: how many of each.
  struct Place {
    TangentCircle circle;
    int of_cgal = 0, tested = 0;
  };
  std::vector<Place> places;
  std::set<Triple> cgal_vertices;
  const auto place_of = [&places](const TangentCircle& circle) {
    return std::find_if(places.begin(), places.end(),
                        [&](const Place& p) { return coincide(p.circle, circle); });
  };
  for (const auto& [vertex, circle] : cgal.vertices) {
    cgal_vertices.insert(vertex);
    auto place = place_of(circle);
    if (place == places.end()) place = places.insert(places.end(), Place{circle});
    ++place->of_cgal;
  }

  std::set<Triple> tested_vertices;
  for (const Quadruple& edge : edges) {
    tested_vertices.insert(start_vertex(edge));
    tested_vertices.insert(end_vertex(edge));
  }
  for (const Triple& vertex : tested_vertices) {
    if (vertex[0] == -1) continue;  // The smallest id comes first.
    const bool known =
        std::all_of(vertex.begin(), vertex.end(), [n](int id) { return id >= 0 && id < n; });
    const bool distinct =
        vertex[0] != vertex[1] && vertex[1] != vertex[2] && vertex[2] != vertex[0];
    if (!known || !distinct) return no("vertex " + text(vertex) + " is not three generators");
    bool found = false;
    for (const TangentCircle& circle :
         generators.tangent_circles(vertex[0], vertex[1], vertex[2])) {
      if (!generators.counterclockwise(vertex[0], vertex[1], vertex[2], circle)) continue;
      const auto place = place_of(circle);
      if (place == places.end()) continue;
      ++place->tested;
      found = true;
    }
    if (!found) return no("vertex " + text(vertex) + " is not in CGAL's diagram");
  }
  std::set<Triple> common_inside;
  for (const auto& [vertex, circle] : cgal.vertices) {
    const Place& place = *place_of(circle);
    const bool inside = generators.gap(-1, circle) > contact_tolerance();
    if (inside && tested_vertices.count(vertex) == 1) common_inside.insert(vertex);
    if (place.tested > place.of_cgal || (inside && place.tested < place.of_cgal)) {
      return no("CGAL has " + std::to_string(place.of_cgal) + " vertices at the circle of " +
                text(vertex) + ", the tested diagram " + std::to_string(place.tested));
    }
  }

  std::set<Quadruple> tested_edges;
  for (const Quadruple& edge : edges) {
    tested_edges.insert(canonical(edge));
    if (std::find(edge.begin(), edge.end(), -1) != edge.end()) continue;
    if (cgal_vertices.count(start_vertex(edge)) == 1 &&
        cgal_vertices.count(end_vertex(edge)) == 1 && cgal.edges.count(canonical(edge)) == 0) {
      return no("CGAL does not have the edge " + text(edge));
    }
  }
  for (const Quadruple& edge : cgal.edges) {
    if (common_inside.count(start_vertex(edge)) == 1 &&
        common_inside.count(end_vertex(edge)) == 1 && tested_edges.count(edge) == 0) {
      return no("the edge " + text(edge) + " of CGAL's diagram is missing");
    }
  }
  return true;
}

}  // namespace voroproof::oracle
