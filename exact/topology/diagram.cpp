#include "exact/topology/diagram.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace voroproof::internal {

namespace {

template <class Item>
struct Sorted {
  std::vector<Item> items;
  std::vector<std::size_t> begins;  // by generator, the container first; then the end
};

// `count` items, item(k) of the generator generator(k), sorted: an item of a smaller generator is
// the smaller one. Few have the same generator, so that it takes little more than linear time; and
// no item is kept twice.
template <class Item, class GeneratorOf, class ItemAt>
Sorted<Item> sorted_by_generator(std::size_t count, int disks, const GeneratorOf& generator,
                                 const ItemAt& item) {
  // The place of generator g is g + 1; until the items are in, begins are one place further on.
  std::vector<std::size_t> begins(static_cast<std::size_t>(disks) + 3, 0);
  for (std::size_t k = 0; k < count; ++k) ++begins[generator(k) + 3];
  for (std::size_t place = 1; place < begins.size(); ++place) begins[place] += begins[place - 1];
  std::vector<Item> items(count);
  for (std::size_t k = 0; k < count; ++k) items[begins[generator(k) + 2]++] = item(k);
  begins.pop_back();
  const auto at = [&](std::size_t place) {
    return items.begin() + static_cast<std::ptrdiff_t>(begins[place]);
  };
  for (std::size_t place = 1; place < begins.size(); ++place) std::sort(at(place - 1), at(place));
  return {std::move(items), std::move(begins)};
}

}  // namespace

Diagram::HalfEdge Diagram::new_edge(GenId a, GenId b) {
  const auto h = static_cast<HalfEdge>(halves_.size());
  halves_.push_back({a, -1});
  halves_.push_back({b, -1});
  anchor_[a + 1] = h;
  anchor_[b + 1] = h + 1;
  return h;
}

void Diagram::link(HalfEdge a, HalfEdge b, HalfEdge c) {
  halves_[b].previous = a;
  halves_[c].previous = b;
  halves_[a].previous = c;
}

void Diagram::start(GenId a, GenId b) {
  halves_.reserve(6 * static_cast<std::size_t>(disks_) - 6);  // for the diagram of all disks
  const HalfEdge ca = new_edge(container_id, a);
  const HalfEdge ab = new_edge(a, b);
  const HalfEdge bc = new_edge(b, container_id);
  link(ca, ab, bc);
  link(twin(ca), twin(bc), twin(ab));
}

std::array<Diagram::HalfEdge, 2> Diagram::insert_in_edge(HalfEdge h, GenId g) {
  const GenId l = org(h);
  const GenId r = dest(h);
  // The old edge keeps its triangle with the old apex(h); a second copy takes the
  // other triangle, and g goes in between.
  const HalfEdge lower = twin(h);
  const HalfEdge b = previous(lower);
  const HalfEdge a = previous(b);
  const HalfEdge copy = new_edge(l, r);
  const HalfEdge lg = new_edge(l, g);
  const HalfEdge gr = new_edge(g, r);
  link(twin(copy), a, b);
  link(copy, twin(gr), twin(lg));
  link(lg, gr, lower);
  return {copy, h};
}

void Diagram::insert_in_vertex(HalfEdge h, GenId g) {
  const HalfEdge el = previous(h), re = previous(el);  // triangle l r e
  const GenId l = org(h), r = org(re), e = org(el);
  const HalfEdge lg = new_edge(l, g);
  const HalfEdge rg = new_edge(r, g);
  const HalfEdge eg = new_edge(e, g);
  link(h, rg, twin(lg));
  link(re, eg, twin(rg));
  link(el, lg, twin(eg));
}

void Diagram::move_half(HalfEdge from, HalfEdge to) {
  halves_[next(from)].previous = to;
  halves_[to] = halves_[from];
  HalfEdge& anchor = anchor_[org(to) + 1];
  if (anchor == from) anchor = to;
}

std::vector<int> Diagram::remove(GenId g) {
  if (edges() == 3) {
    halves_.clear();
    std::fill(anchor_.begin(), anchor_.end(), -1);
    return {};
  }
  const HalfEdge gl = anchor(g), gr = rotate(gl);
  const HalfEdge kept = next(gl), gone = next(gr);  // l r and r l, with g as apex
  const HalfEdge outer = twin(gone), b = next(outer), a = previous(outer);
  link(kept, b, a);
  anchor_[g + 1] = -1;
  anchor_[org(kept) + 1] = kept;
  anchor_[dest(kept) + 1] = twin(kept);
  std::array<int, 3> places{gl / 2, gr / 2, gone / 2};
  std::sort(places.rbegin(), places.rend());
  std::vector<int> changed{kept / 2};
  for (const int place : places) {
    const int last = edges() - 1;
    if (place != last) {
      for (const int side : {0, 1}) move_half(2 * last + side, 2 * place + side);
      std::replace(changed.begin(), changed.end(), last, place);
      changed.push_back(place);
    }
    halves_.resize(halves_.size() - 2);
  }
  return changed;
}

void Diagram::exchange(GenId a, GenId b) {
  const auto from = [this](GenId g) {
    std::vector<HalfEdge> all;
    for (const HalfEdge h : ring(g)) all.push_back(h);
    return all;
  };
  const std::vector<HalfEdge> of_a = from(a), of_b = from(b);
  for (const HalfEdge h : of_a) halves_[h].org = b;
  for (const HalfEdge h : of_b) halves_[h].org = a;
  std::swap(anchor_[a + 1], anchor_[b + 1]);
}

void Diagram::flip(HalfEdge h) {
  const HalfEdge t = twin(h);
  const HalfEdge el = previous(h), re = previous(el);  // triangle l r e
  const HalfEdge sr = previous(t), ls = previous(sr);  // triangle r l s
  const GenId l = org(h), r = org(t), e = org(el), s = org(sr);
  if (anchor_[l + 1] == h) anchor_[l + 1] = ls;
  if (anchor_[r + 1] == t) anchor_[r + 1] = re;
  halves_[h].org = s;
  halves_[t].org = e;
  link(h, el, ls);  // s e l
  link(t, sr, re);  // e s r
}

std::vector<GenId> Diagram::neighbours(GenId g) const {
  std::vector<GenId> all;
  for (const HalfEdge h : ring(g)) all.push_back(dest(h));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<Quad> Diagram::quads() const {
  const auto edge = [](std::size_t k) { return 2 * static_cast<HalfEdge>(k); };
  const auto smaller = [&](std::size_t k) { return std::min(org(edge(k)), dest(edge(k))); };
  const auto named = [&](std::size_t k) { return canonical(quad(edge(k))); };
  return sorted_by_generator<Quad>(halves_.size() / 2, disks_, smaller, named).items;
}

bool Diagram::is_valid(std::string* why, const std::vector<bool>& hidden) const {
  const auto fail = [why](const std::string& reason) {
    if (why != nullptr) *why = reason;
    return false;
  };
  const auto is_hidden = [&](GenId g) { return g >= 0 && !hidden.empty() && hidden[g]; };
  const auto halves = static_cast<HalfEdge>(halves_.size());
  const int seen_disks = disks_ - static_cast<int>(std::count(hidden.begin(), hidden.end(), true));
  if (seen_disks < 2) {
    return halves == 0 ? true : fail("a diagram of fewer than two disks has no edges");
  }
  if (edges() != 3 * (seen_disks + 1) - 6) return fail("wrong number of edges");
  std::vector<int> degree(disks_ + 1, 0);
  for (HalfEdge h = 0; h < halves; ++h) {
    if (previous(h) < 0 || previous(h) >= halves) return fail("a half-edge has no predecessor");
  }
  for (HalfEdge h = 0; h < halves; ++h) {
    if (previous(next(h)) != h) return fail("a dual face is not a triangle");
    if (dest(previous(h)) != org(h)) return fail("consecutive half-edges do not meet");
    if (org(h) < container_id || org(h) >= disks_) return fail("a generator does not exist");
    if (org(h) == dest(h)) return fail("an edge has one generator on both sides");
    if (is_hidden(org(h))) return fail("generator " + std::to_string(org(h)) + " has no cell");
    ++degree[org(h) + 1];
  }
  for (GenId g = container_id; g < disks_; ++g) {
    if (is_hidden(g)) continue;
    const HalfEdge first = anchor_[g + 1];
    if (first < 0 || org(first) != g) return fail("generator " + std::to_string(g) + " is lost");
    int seen = 0;
    for ([[maybe_unused]] const HalfEdge h : ring(g)) {
      if (++seen > degree[g + 1]) break;
    }
    if (seen != degree[g + 1]) {
      return fail("the edges of generator " + std::to_string(g) + " do not form one ring");
    }
  }
  // A sphere and a torus apart have as many edges as one sphere.
  std::vector<bool> reached(disks_ + 1, false);
  std::vector<GenId> pending{container_id};
  reached[0] = true;
  int count = 0;
  while (!pending.empty()) {
    const GenId g = pending.back();
    pending.pop_back();
    ++count;
    for (const HalfEdge h : ring(g)) {
      if (reached[dest(h) + 1]) continue;
      reached[dest(h) + 1] = true;
      pending.push_back(dest(h));
    }
  }
  if (count != seen_disks + 1) return fail("the edges do not hang together");
  return true;
}

Diagram::HalfEdge find_edge(const Diagram& diagram, const Quad& q) {
  Diagram::HalfEdge found = -1;
  each_between(diagram, q.l, q.r, [&](Diagram::HalfEdge h) {
    if (diagram.quad(h) == q) found = h;
    return found >= 0;
  });
  return found;
}

namespace {

// A half-edge of a diagram that is being put together, as one of the three around the vertex on its
// left: an oriented triple names at most one vertex. Sorted among those with the same least
// generator, the three stand side by side.
struct Corner {
  std::uint64_t others;  // the other two generators of the vertex, in its order
  int place;             // place of the least one in the half-edge's own triple
  Diagram::HalfEdge half;
  auto operator<=>(const Corner&) const = default;
};

std::string name(const Triple& t) {
  return "[" + std::to_string(t[0]) + "," + std::to_string(t[1]) + "," + std::to_string(t[2]) + "]";
}

// The vertices of the diagram with the edges 0, 1, ...
class Corners {
 public:
  // The generators of the edges exist.
  Corners(int disks, const std::vector<Quad>& edges) : edges_(edges) {
    const auto half = [](std::size_t k) { return static_cast<Diagram::HalfEdge>(k); };
    sorted_ = sorted_by_generator<Corner>(
        2 * edges.size(), disks, [&](std::size_t k) { return canonical(triple(half(k)))[0]; },
        [&](std::size_t k) { return corner(half(k)); });
  }

  // Visits the half-edges a, b, c around each vertex, in their order. Throws std::invalid_argument
  // where there are not three.
  template <class Visit>
  void each_vertex(const Visit& visit) const {
    const std::vector<Corner>& all = sorted_.items;
    for (std::size_t place = 1; place < sorted_.begins.size(); ++place) {
      const std::size_t end = sorted_.begins[place];
      for (std::size_t k = sorted_.begins[place - 1]; k < end; k += 3) {
        require_three(k, end);
        visit(all[k].half, all[k + 2].half, all[k + 1].half);
      }
    }
  }

 private:
  // The half-edge runs from the first to the second.
  Triple triple(Diagram::HalfEdge h) const {
    const Quad& q = edges_[static_cast<std::size_t>(h / 2)];
    return h % 2 == 0 ? Triple{q.l, q.r, q.e} : Triple{q.r, q.l, q.s};
  }
  Corner corner(Diagram::HalfEdge h) const {
    const Triple t = triple(h), vertex = canonical(t);
    const auto place = static_cast<int>(std::find(t.begin(), t.end(), vertex[0]) - t.begin());
    const auto bits = [](GenId g) { return static_cast<std::uint64_t>(g + 1); };
    return {bits(vertex[1]) << 32 | bits(vertex[2]), place, h};
  }
  // That k, k + 1, k + 2 are the corners of one vertex, and the next, up to `end`, of another.
  void require_three(std::size_t k, std::size_t end) const {
    const std::vector<Corner>& all = sorted_.items;
    const auto is_here = [&](std::size_t j) { return j < end && all[j].others == all[k].others; };
    for (int place = 0; place < 3; ++place) {
      const std::size_t j = k + static_cast<std::size_t>(place);
      const bool here = is_here(j);
      if (here && all[j].place == place && (place < 2 || !is_here(j + 1))) continue;
      const Triple v = canonical(triple(all[k].half));
      if (here && all[j].place <= place) {
        throw std::invalid_argument("vertex " + name(v) + " is named by two edges on one side");
      }
      const Triple edge{v[0], v[2], v[1]};  // where the half-edge of this place starts
      throw std::invalid_argument("vertex " + name(v) + " lacks an edge between " +
                                  std::to_string(edge[place]) + " and " +
                                  std::to_string(edge[(place + 2) % 3]));
    }
  }

  const std::vector<Quad>& edges_;
  Sorted<Corner> sorted_;
};

}  // namespace

Diagram diagram_of(int disks, const std::vector<Quad>& edges, const std::vector<bool>& hidden) {
  Diagram d(disks);
  const auto fail = [](const std::string& reason) { throw std::invalid_argument(reason); };
  d.halves_.reserve(2 * edges.size());
  for (const Quad& q : edges) {
    for (const GenId g : {q.l, q.r, q.s, q.e}) {
      if (g < container_id || g >= disks) fail("there is no generator " + std::to_string(g));
    }
    if (q.l == q.r) fail("an edge has one generator on both sides");
    d.new_edge(q.l, q.r);
  }
  const Corners corners(disks, edges);
  corners.each_vertex([&](auto a, auto b, auto c) { d.link(a, b, c); });
  std::string why;
  if (!d.is_valid(&why, hidden)) fail(why);
  return d;
}

Diagram numbered_diagram(int disks, const std::vector<GenId>& origins,
                         const std::vector<Diagram::HalfEdge>& previous,
                         const std::vector<Diagram::HalfEdge>& anchors) {
  Diagram d(disks);
  const auto halves = static_cast<Diagram::HalfEdge>(origins.size());
  if (previous.size() != origins.size() || halves % 2 != 0 || anchors.size() != d.anchor_.size()) {
    throw std::invalid_argument("wrong number of half-edges or anchors");
  }
  for (const Diagram::HalfEdge h : anchors) {
    if (h < -1 || h >= halves) throw std::invalid_argument("an anchor is no half-edge");
  }
  for (Diagram::HalfEdge h = 0; h < halves; ++h) {
    if (origins[h] < container_id || origins[h] >= disks) {
      throw std::invalid_argument("there is no generator " + std::to_string(origins[h]));
    }
    d.halves_.push_back({origins[h], previous[h]});
  }
  d.anchor_ = anchors;
  std::string why;
  if (!d.is_valid(&why)) throw std::invalid_argument(why);
  return d;
}

}  // namespace voroproof::internal
