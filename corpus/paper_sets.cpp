#include "corpus/paper_sets.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace voroproof::internal {

const std::vector<PaperSet>& paper_sets() {
  static const std::vector<PaperSet> sets{
      {"reference", 10}, {"speed", 10}, {"size", 10}, {"density", 10}, {"restitution", 5}};
  return sets;
}

ReferenceOptions paper_set_member(const std::string& name, int k, double scale) {
  const auto set = std::find_if(paper_sets().begin(), paper_sets().end(),
                                [&](const PaperSet& s) { return s.name == name; });
  if (set == paper_sets().end())
    throw std::invalid_argument("no data set is called '" + name + "'");
  if (k < 1 || k > set->members)
    throw std::invalid_argument("data set " + name + " has members 1 to " +
                                std::to_string(set->members));
  ReferenceOptions options;
  if (name == "reference") options.n = 1000 * k;
  if (name == "speed") options.speed = k;
  if (name == "size") options.rmax = k;
  if (name == "density") options.density = k / 20.0;
  if (name == "restitution") {
    options.n = 300;
    options.restitution = (k + 5) / 10.0;
  }
  options.n = std::max(1, static_cast<int>(std::lround(options.n * scale)));
  return options;
}

}  // namespace voroproof::internal
