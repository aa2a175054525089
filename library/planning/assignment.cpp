#include "library/planning/assignment.h"

#include <lemon/network_simplex.h>
#include <lemon/smart_graph.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>

namespace voroproof::internal {
namespace {

using Costs = std::vector<std::int64_t>;  // rows times columns

// The columns of a cheapest assignment: a flow of one unit from each row to each column.
std::vector<int> cheapest(int n, const Costs& costs) {
  using Graph = lemon::SmartDigraph;
  Graph graph;
  graph.reserveNode(2 * n);
  graph.reserveArc(n * n);
  for (int k = 0; k < 2 * n; ++k) graph.addNode();
  Graph::ArcMap<std::int64_t> cost(graph);
  Graph::NodeMap<int> supply(graph);
  for (int i = 0; i < n; ++i) {
    supply[Graph::nodeFromId(i)] = 1;
    supply[Graph::nodeFromId(n + i)] = -1;
    for (int j = 0; j < n; ++j)
      cost[graph.addArc(Graph::nodeFromId(i), Graph::nodeFromId(n + j))] =
          costs[static_cast<std::size_t>(i) * n + j];
  }
  lemon::NetworkSimplex<Graph, int, std::int64_t> simplex(graph);
  if (simplex.costMap(cost).supplyMap(supply).run() != decltype(simplex)::OPTIMAL)
    throw std::logic_error("assignment: the network simplex failed");
  std::vector<int> column(n, -1);
  for (Graph::ArcIt arc(graph); arc != lemon::INVALID; ++arc)
    if (simplex.flow(arc) == 1)
      column[Graph::id(graph.source(arc))] = Graph::id(graph.target(arc)) - n;
  return column;
}

Rational square_of_way(const Vehicle& from, const Vehicle& to) {
  const Rational x = to.goal.x - from.start.x, y = to.goal.y - from.start.y;
  return x * x + y * y;
}

}  // namespace

std::vector<int> nearest_goals(const std::vector<Vehicle>& vehicles) {
  constexpr int cost_bits = 40;
  std::map<Rational, std::vector<int>> by_radius;
  for (std::size_t i = 0; i < vehicles.size(); ++i)
    by_radius[vehicles[i].radius].push_back(static_cast<int>(i));
  std::vector<int> goal(vehicles.size());
  for (const auto& [radius, group] : by_radius) {
    const int n = static_cast<int>(group.size());
    std::vector<Rational> squares;
    for (const int i : group)
      for (const int j : group) squares.push_back(square_of_way(vehicles[i], vehicles[j]));
    const Rational largest = *std::max_element(squares.begin(), squares.end());
    Costs costs;
    for (const Rational& square : squares) {
      const Rational scaled =
          largest == 0 ? Rational(0) : Rational(square / largest * (std::int64_t{1} << cost_bits));
      costs.push_back(std::int64_t{Integer(scaled + Rational(1, 2)).get_si()});
    }
    const std::vector<int> column = cheapest(n, costs);
    for (int k = 0; k < n; ++k) goal[group[k]] = group[column[k]];
  }
  return goal;
}

void assign_nearest_goals(PlanTask& task) {
  const std::vector<int> goal = nearest_goals(task.vehicles);
  const std::vector<Vehicle> old = task.vehicles;
  for (std::size_t i = 0; i < goal.size(); ++i) task.vehicles[i].goal = old[goal[i]].goal;
}

}  // namespace voroproof::internal
