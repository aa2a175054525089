#include "tests/world/edge_set.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <variant>

namespace voroproof::internal::testing {

namespace {

[[noreturn]] void refuse(const std::string& why) { throw ImpossibleEvent(why); }

std::string text(const std::optional<std::vector<Step>>& steps, const std::string& name) {
  if (!steps) return "";
  std::string all;
  for (const Step& step : *steps) all += (all.empty() ? "" : ", ") + testing::text(step);
  return " " + name + " (" + all + ")";
}

}  // namespace

EdgeSet::EdgeSet(const std::vector<Quad>& edges, const std::set<GenId>& lone) : visible_(lone) {
  if (!edges.empty()) visible_.clear();
  for (const Quad& q : edges) {
    insert(q);
    for (const GenId g : {q.l, q.r}) {
      if (g != container_id) visible_.insert(g);
    }
  }
  for (const auto& [key, s] : half_edges_) {
    value({key[1], key[2], key[0]});
    value({key[2], key[0], key[1]});
  }
}

GenId EdgeSet::value(const Key& key) const {
  const auto found = half_edges_.find(key);
  if (found != half_edges_.end()) return found->second;
  refuse("no edge of " + std::to_string(key[0]) + " and " + std::to_string(key[1]) + " leads to " +
         std::to_string(key[2]));
}

void EdgeSet::insert(const Quad& q) {
  if (!names_an_edge(q)) refuse("no name of an edge: " + testing::text(q));
  for (const Quad& name : {q, reversed(q)}) {
    if (!half_edges_.insert({{name.l, name.r, name.e}, name.s}).second) {
      refuse("a vertex is there twice: that at the end of " + testing::text(name));
    }
  }
}

void EdgeSet::erase(const Quad& q) {
  for (const Quad& name : {q, reversed(q)}) {
    if (value({name.l, name.r, name.e}) != name.s) refuse("no edge " + testing::text(name));
    half_edges_.erase({name.l, name.r, name.e});
  }
}

// The half-edge of `key` gets another vertex on its left.
void EdgeSet::set_left(const Key& key, GenId left) {
  const GenId s = value(key);
  erase({key[0], key[1], s, key[2]});
  insert({key[0], key[1], s, left});
}

void EdgeSet::flip(const Quad& q) {
  const auto [l, r, s, e] = q;
  if (s == e) refuse("the edge has no flip: " + testing::text(q));
  erase(q);
  set_left({r, e, l}, s);
  set_left({e, l, r}, s);
  set_left({l, s, r}, e);
  set_left({s, r, l}, e);
  insert(flipped(q));
}

void EdgeSet::hide(const Hide& h) {
  const auto [g, j] = h;
  if (visible_.erase(g) == 0) refuse("a disk hides that is not visible");
  if (visible_.empty()) {
    if (j != container_id) refuse("a lone disk hides in a disk");
    return;
  }
  if (half_edges_.size() == 6) {
    if (j != container_id && !visible_.contains(j)) refuse("hides in an unseen disk");
    half_edges_.clear();
    return;
  }
  const auto first = half_edges_.lower_bound({g, std::numeric_limits<GenId>::min(), 0});
  const GenId a = first->first[1], b = first->first[2];
  if (j != a && j != b) refuse("hides in a disk that is no neighbour");
  erase({g, a, b, b});
  erase({g, b, a, a});
  const GenId x = value({a, b, g}), y = value({b, a, g});
  erase({a, b, x, g});
  erase({b, a, y, g});
  insert({a, b, x, y});
}

void EdgeSet::appear(const Appear& a) {
  const GenId g = a.g;
  if (visible_.contains(g)) refuse("a disk appears that is visible");
  if (visible_.size() < 2) {
    if (a.at) refuse("appears in an edge, but there is none");
    if (!visible_.empty()) {
      const GenId other = *visible_.begin();
      if (a.j != container_id && a.j != other) refuse("appears from an unseen disk");
      insert({other, g, container_id, container_id});
      insert({container_id, other, g, g});
      insert({container_id, g, other, other});
    }
    visible_.insert(g);
    return;
  }
  if (!a.at) refuse("appears in no edge");
  const auto [j, k, s, e] = *a.at;
  if (j != a.j) refuse("appears from another disk than the edge's first");
  erase(*a.at);
  insert({j, k, s, g});
  insert({j, k, g, e});
  insert({g, j, k, k});
  insert({g, k, j, j});
  visible_.insert(g);
}

void EdgeSet::swap(GenId i, GenId j) {
  if (!(0 <= i && i < j)) refuse("a swap needs two disks, the smaller first");
  const auto other = [i, j](GenId g) { return g == i ? j : g == j ? i : g; };
  std::map<Key, GenId> renamed;
  for (const auto& [key, s] : half_edges_) {
    renamed[{other(key[0]), other(key[1]), other(key[2])}] = other(s);
  }
  half_edges_ = std::move(renamed);
  std::set<GenId> seen;
  for (const GenId g : visible_) seen.insert(other(g));
  visible_ = std::move(seen);
}

void EdgeSet::jump(const Jump& jump) {
  if (!jump.out && !jump.in) return;
  if (jump.out) {
    for (const Step& step : *jump.out) apply(step);
  }
  if (visible_.contains(jump.g)) {
    if (visible_.size() > 2) refuse("a disk has jumped out and is still visible");
    half_edges_.clear();
    visible_.erase(jump.g);
  }
  if (!jump.in) return;
  const auto is_appear = [&](const Step& step) {
    const auto* appears = std::get_if<Appear>(&step);
    return appears != nullptr && appears->g == jump.g;
  };
  if (!jump.in->empty() && !is_appear(jump.in->front())) refuse("no appear begins a way in");
  for (const Step& step : *jump.in) apply(step);
}

void EdgeSet::apply(const Step& step) {
  if (const auto* q = std::get_if<Quad>(&step)) flip(*q);
  if (const auto* h = std::get_if<Hide>(&step)) hide(*h);
  if (const auto* a = std::get_if<Appear>(&step)) appear(*a);
}

void EdgeSet::apply(const WorldEvent& event) {
  try {
    if (const auto* q = std::get_if<Quad>(&event.what)) flip(*q);
    if (const auto* h = std::get_if<Hide>(&event.what)) hide(*h);
    if (const auto* a = std::get_if<Appear>(&event.what)) appear(*a);
    if (const auto* s = std::get_if<Swap>(&event.what)) swap(s->i, s->j);
    const auto* j = std::get_if<Jump>(&event.what);
    if (j != nullptr && (j->out || j->in) == (event.t == 0)) {
      refuse("a jump goes out or comes in, but at 0");
    }
    if (j != nullptr) jump(*j);
  } catch (const ImpossibleEvent& why) {
    refuse(testing::text(event) + ": " + why.what());
  }
}

std::vector<Quad> EdgeSet::edges() const {
  std::vector<Quad> all;
  for (const auto& [key, s] : half_edges_) {
    const Quad q{key[0], key[1], s, key[2]};
    if (canonical(q) == q) all.push_back(q);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string text(const Quad& q) {
  return "[" + std::to_string(q.l) + "," + std::to_string(q.r) + "," + std::to_string(q.s) + "," +
         std::to_string(q.e) + "]";
}

std::string text(const Step& step) {
  const auto pair = [](GenId g, GenId j) {
    return "[" + std::to_string(g) + "," + std::to_string(j) + "]";
  };
  if (const auto* h = std::get_if<Hide>(&step)) return "hide " + pair(h->g, h->j);
  if (const auto* a = std::get_if<Appear>(&step)) {
    return "appear " + pair(a->g, a->j) + (a->at ? " at " + text(*a->at) : "");
  }
  return "flip " + text(std::get<Quad>(step));
}

std::string text(const WorldEvent& event) {
  const std::string t = std::to_string(round_nearest(event.t)) + " ";
  if (const auto* q = std::get_if<Quad>(&event.what)) return t + text(Step(*q));
  if (const auto* h = std::get_if<Hide>(&event.what)) return t + text(Step(*h));
  if (const auto* a = std::get_if<Appear>(&event.what)) return t + text(Step(*a));
  if (const auto* s = std::get_if<Swap>(&event.what)) {
    return t + "swap [" + std::to_string(s->i) + "," + std::to_string(s->j) + "]";
  }
  if (const auto* u = std::get_if<PathTurn>(&event.what)) return t + "turn " + std::to_string(u->g);
  const Jump& jump = std::get<Jump>(event.what);
  return t + "jump " + std::to_string(jump.g) + text(jump.out, "out") + text(jump.in, "in");
}

}  // namespace voroproof::internal::testing
