#include "corpus/paper_sets.h"

#include <map>
#include <stdexcept>

namespace voroproof::internal {

ReferenceOptions paper_set_member(const std::string& name, int k) {
  static const std::map<std::string, int> sets{
      {"reference", 10}, {"speed", 10}, {"size", 10}, {"density", 10}, {"restitution", 5}};
  const auto set = sets.find(name);
  if (set == sets.end()) throw std::invalid_argument("no data set is called '" + name + "'");
  if (k < 1 || k > set->second)
    throw std::invalid_argument("data set " + name + " has members 1 to " +
                                std::to_string(set->second));
  ReferenceOptions options;
  if (name == "reference") options.n = 1000 * k;
  if (name == "speed") options.speed = k;
  if (name == "size") options.rmax = k;
  if (name == "density") options.density = k / 20.0;
  if (name == "restitution") {
    options.n = 300;
    options.restitution = (k + 5) / 10.0;
  }
  return options;
}

}  // namespace voroproof::internal
