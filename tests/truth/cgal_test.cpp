// The truth set held against CGAL's exact predicates and its Apollonius graph, where CGAL can
// answer: disks in the plane.
//
// usage: truth_cgal_test FOLDER, which has incircle.txt.gz and static.txt.gz
#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <stdio.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "corpus/truth/readers/voroproof_truth.h"

namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Traits = CGAL::Apollonius_graph_traits_2<Kernel, CGAL::Integral_domain_without_division_tag>;
using Graph = CGAL::Apollonius_graph_2<Traits>;
using Place = std::tuple<CGAL::Gmpq, CGAL::Gmpq, CGAL::Gmpq>;

Traits::Site_2 site(const vt_generator& g) {
  return {Traits::Point_2(CGAL::Gmpq(g.x), CGAL::Gmpq(g.y)), CGAL::Gmpq(g.r)};
}

Place place(const Traits::Site_2& s) { return {s.point().x(), s.point().y(), s.weight()}; }

bool are_disks(const vt_record& line) {
  return std::all_of(line.g, line.g + line.n,
                     [](const vt_generator& g) { return g.letter == 'd'; });
}

bool is_right_sign(const vt_record& line) {
  static const Traits traits;
  const vt_generator* const g = line.g;
  // Their circle is named the other way round.
  const CGAL::Sign conflict =
      traits.vertex_conflict_2_object()(site(g[0]), site(g[1]), site(g[2]), site(g[3]));
  return conflict == line.truth.sign;
}

using Pairs = std::set<std::pair<int, int>>;

// Whether the graph has all these pairs and, where nothing is a tie, no others; and hides these.
bool is_right_graph(const vt_record& line) {
  std::map<Place, int> ids;  // of equal disks the one that is not hidden
  Graph graph;
  for (int k = 0; k < line.n; ++k) {
    ids.emplace(place(site(line.g[k])), k);
    graph.insert(site(line.g[k]));
  }
  std::set<int> seen;
  for (auto v = graph.finite_vertices_begin(); v != graph.finite_vertices_end(); ++v) {
    seen.insert(ids.at(place(v->site())));
  }
  for (int k = 0; k < line.truth.diagram.hidden; ++k) {
    if (!seen.insert(line.truth.diagram.id[k]).second) return false;
  }
  if (static_cast<int>(seen.size()) != line.n) return false;
  Pairs theirs, ours;
  for (auto e = graph.finite_edges_begin(); e != graph.finite_edges_end(); ++e) {
    const int a = ids.at(place(e->first->vertex((e->second + 1) % 3)->site())),
              b = ids.at(place(e->first->vertex((e->second + 2) % 3)->site()));
    theirs.insert(std::minmax(a, b));
  }
  for (int k = 0; k < line.truth.diagram.pairs; ++k) {
    ours.emplace(line.truth.diagram.pair[k][0], line.truth.diagram.pair[k][1]);
  }
  return line.exact ? std::includes(theirs.begin(), theirs.end(), ours.begin(), ours.end())
                    : theirs == ours;
}

// How many lines of a file CGAL was asked about; -1 where one is wrong.
int judge(const std::string& file, bool (*can_answer)(const vt_record&),
          bool (*is_right)(const vt_record&)) {
  FILE* const text = popen(("gzip -dc " + file).c_str(), "r");
  vt_reader reader;
  static vt_record line;
  int asked = 0, wrong = 0;
  if (vt_open(&reader, text)) {
    while (vt_next(&reader, &line)) {
      if (!can_answer(line)) continue;
      ++asked;
      if (is_right(line)) continue;
      ++wrong;
      printf("%s: line %d is not CGAL's\n", file.c_str(), static_cast<int>(reader.line));
    }
  }
  const bool failed = *reader.message != 0;
  if (failed) printf("%s: %s\n", file.c_str(), reader.message);
  vt_close(&reader);
  pclose(text);
  printf("%s: %d lines, %d wrong\n", file.c_str(), asked, wrong);
  return wrong > 0 || failed ? -1 : asked;
}

}  // namespace

int main(int, char** argv) {
  const std::string folder = argv[1];
  const auto in_the_plane = [](const vt_record& line) {
    return are_disks(line) && line.frame.letter == 'p';
  };
  const int signs = judge(folder + "/incircle.txt.gz", are_disks, is_right_sign);
  const int graphs = judge(folder + "/static.txt.gz", in_the_plane, is_right_graph);
  return signs > 7000 && graphs > 4000 ? 0 : 1;
}
