#include "history/world_history.h"

namespace voroproof::internal {
namespace {

const char* fault_of_steps(const std::vector<Step>& steps) {
  for (const Step& step : steps) {
    const char* fault = nullptr;
    if (const auto* hide = std::get_if<Hide>(&step)) fault = fault_of(*hide);
    if (const auto* appear = std::get_if<Appear>(&step)) fault = fault_of(*appear);
    if (fault != nullptr) return fault;
  }
  return nullptr;
}

}  // namespace

const char* fault_of(const Hide& hide) {
  if (hide.g < 0) return "only disks are hidden";
  return hide.g == hide.j ? "a disk is not its own host" : nullptr;
}

const char* fault_of(const Appear& appear) {
  const auto& [g, j, at] = appear;
  if (g < 0) return "only disks appear";
  if (g == j) return "a disk is not its own host";
  if (!at) return nullptr;
  if (!names_an_edge(*at)) return "names no edge: its generators are not distinct";
  if (at->l != j) return "the host is not the first generator of the edge";
  if (g == at->r || g == at->s || g == at->e) return "the edge is one of the disk itself";
  return nullptr;
}

const char* fault_of(const Jump& jump, const Rational& t) {
  if (jump.g < 0) return "only disks jump";
  if (!jump.out && !jump.in && t != 0) return "neither out nor in";
  if (jump.out)
    if (const char* fault = fault_of_steps(*jump.out)) return fault;
  if (!jump.in || jump.in->empty()) return nullptr;
  const auto* first = std::get_if<Appear>(&jump.in->front());
  if (first == nullptr || first->g != jump.g) return "the disk does not appear first";
  return fault_of_steps(*jump.in);
}

void WorldCounts::add(const WorldEvent& event) {
  struct {
    WorldCounts& counts;
    void operator()(const Quad&) const { ++counts.flips; }
    void operator()(const Hide&) const { ++counts.hides; }
    void operator()(const Appear&) const { ++counts.appears; }
    void operator()(const Swap&) const { ++counts.swaps; }
    void operator()(const PathTurn&) const { ++counts.maneuvers; }
    void operator()(const Jump&) const { ++counts.jumps; }
  } const count{*this};
  std::visit(count, event.what);
}

std::int64_t WorldCounts::all() const {
  return flips + hides + appears + swaps + jumps + collisions + maneuvers;
}

}  // namespace voroproof::internal
