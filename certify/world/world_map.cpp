#include "certify/world/world_map.h"

#include <algorithm>
#include <stdexcept>
#include <variant>

namespace voroproof::internal {

WorldMap::WorldMap(int disks, const std::vector<Quad>& edges) : WorldMap(disks) {
  std::vector<bool> hidden(disks, true);
  for (const Quad& q : edges) {
    for (const GenId g : {q.l, q.r, q.s, q.e}) {
      if (g < container_id || g >= disks) {
        throw std::invalid_argument("there is no generator " + std::to_string(g));
      }
      if (g >= 0) hidden[g] = false;
    }
  }
  const Diagram diagram = diagram_of(disks, edges, hidden);
  for (GenId g = 0; g < disks; ++g) set_visible(g, !hidden[g]);
  for (Half h = 0; h < 2 * diagram.edges(); ++h) {
    halves_.push_back({diagram.org(h), diagram.previous(h)});
    anchor_[diagram.org(h) + 1] = h;
  }
}

std::vector<GenId> WorldMap::visible() const {
  std::vector<GenId> all;
  for (GenId g = 0; g < disks(); ++g) {
    if (visible_[g]) all.push_back(g);
  }
  return all;
}

std::vector<WorldMap::Half> WorldMap::ring(GenId g) const {
  std::vector<Half> all;
  const Half first = anchor_[g + 1];
  if (first < 0) return all;
  Half h = first;
  do {
    all.push_back(h);
    h = rotate(h);
  } while (h != first);
  return all;
}

int WorldMap::degree(GenId g, int most) const {
  const Half first = anchor_[g + 1];
  if (first < 0) return 0;
  int count = 0;
  Half h = first;
  do {
    ++count;
    h = rotate(h);
  } while (h != first && count < most);
  return count;
}

WorldMap::Half WorldMap::find(const Quad& q) const {
  const auto is_generator = [&](GenId g) { return g >= container_id && g < disks(); };
  if (!is_generator(q.l) || !is_generator(q.r)) return -1;
  if (q.l < 0) {
    const Half h = find(reversed(q));
    return h < 0 ? h : twin(h);
  }
  const Half first = anchor_[q.l + 1];
  if (first < 0) return -1;
  Half h = first;
  do {
    if (quad(h) == q) return h;
    h = rotate(h);
  } while (h != first);
  return -1;
}

std::vector<GenId> WorldMap::neighbours(GenId g) const {
  std::vector<GenId> all;
  for (const Half h : ring(g)) all.push_back(dest(h));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void WorldMap::begin_instant() {
  changed_edges_.clear();
  changed_cells_.clear();
}

void WorldMap::set_visible(GenId g, bool visible) {
  if (visible_[g] == visible) return;
  visible_[g] = visible;
  count_ += visible ? 1 : -1;
}

WorldMap::Half WorldMap::new_edge(GenId a, GenId b) {
  auto h = static_cast<Half>(halves_.size());
  if (free_.empty()) {
    halves_.resize(halves_.size() + 2);
  } else {
    h = free_.back();
    free_.pop_back();
  }
  halves_[h] = {a, -1};
  halves_[h + 1] = {b, -1};
  anchor_[a + 1] = h;
  anchor_[b + 1] = h + 1;
  note_edge(h);
  return h;
}

void WorldMap::delete_edge(Half h) {
  const Half even = h & ~1;
  halves_[even].previous = halves_[even + 1].previous = -1;
  free_.push_back(even);
  note_edge(even);
}

void WorldMap::link(Half a, Half b, Half c) {
  halves_[b].previous = a;
  halves_[c].previous = b;
  halves_[a].previous = c;
}

void WorldMap::start(GenId a, GenId b) {
  const Half ca = new_edge(container_id, a), ab = new_edge(a, b), bc = new_edge(b, container_id);
  link(ca, ab, bc);
  link(twin(ca), twin(bc), twin(ab));
  for (const GenId g : {container_id, a, b}) note_cell(g);
}

bool WorldMap::flip(const Quad& q) {
  if (q.s == q.e) return false;
  const Half h = find(q);
  if (h < 0) return false;
  const Half t = twin(h), el = previous(h), re = previous(el), sr = previous(t), ls = previous(sr);
  for (const GenId g : {q.l, q.r, q.s, q.e}) note_cell(g);
  for (const Half each : {h, el, re, sr, ls}) note_edge(each);
  if (anchor_[q.l + 1] == h) anchor_[q.l + 1] = ls;
  if (anchor_[q.r + 1] == t) anchor_[q.r + 1] = re;
  halves_[h].org = q.s;
  halves_[t].org = q.e;
  link(h, el, ls);
  link(t, sr, re);
  return true;
}

// The edge of h is cut in two, and g comes in between.
void WorldMap::insert(Half h, GenId g) {
  const Quad q = quad(h);
  for (const GenId each : {g, q.l, q.r, q.s, q.e}) note_cell(each);
  const Half lower = twin(h), b = previous(lower), a = previous(b);
  const Half copy = new_edge(q.l, q.r), lg = new_edge(q.l, g), gr = new_edge(g, q.r);
  link(twin(copy), a, b);
  link(copy, twin(gr), twin(lg));
  link(lg, gr, lower);
  note_edge(h);
}

// The inverse: both triangles beside g, which has two edges, go.
void WorldMap::remove(GenId g) {
  const Half gj = anchor_[g + 1], gk = rotate(gj);
  const Half x = previous(previous(gj));                             // j to k
  const Half y = previous(previous(gk));                             // k to j
  const Half outer = twin(y), b = previous(outer), a = previous(b);  // the triangle beyond y
  const GenId j = dest(gj), k = dest(gk);
  for (const GenId each : {g, j, k, apex(twin(x)), apex(outer)}) note_cell(each);
  link(x, a, b);
  anchor_[j + 1] = x;
  anchor_[k + 1] = twin(x);
  anchor_[g + 1] = -1;
  for (const Half gone : {gj, gk, y}) delete_edge(gone);
  note_edge(x);
}

void WorldMap::remove_few(GenId g) {
  if (count_ == 2) {
    for (const GenId each : visible()) {
      note_cell(each);
      anchor_[each + 1] = -1;
    }
    note_cell(container_id);
    anchor_[0] = -1;
    for (Half h = 0; h < static_cast<Half>(halves_.size()); h += 2) note_edge(h);
    halves_.clear();
    free_.clear();
  }
  set_visible(g, false);
}

void WorldMap::show(GenId g) {
  if (count_ == 1) start(visible().front(), g);
  set_visible(g, true);
}

bool WorldMap::hide(const Hide& hide) {
  const auto& [g, j] = hide;
  if (g < 0 || g >= disks() || j < container_id || j >= disks() || g == j) return false;
  if (!visible_[g]) return false;
  if (!has_edges()) {
    if (j >= 0) return false;
    remove_few(g);
    return true;
  }
  const std::vector<GenId> around = neighbours(g);
  if (degree(g, 3) != 2 || std::find(around.begin(), around.end(), j) == around.end()) return false;
  if (count_ == 2) {
    remove_few(g);
    return true;
  }
  remove(g);
  set_visible(g, false);
  return true;
}

bool WorldMap::appear(const Appear& appear) {
  const auto& [g, j, at] = appear;
  if (g < 0 || g >= disks() || visible_[g] || at.has_value() != has_edges()) return false;
  if (!has_edges()) {
    show(g);
    return true;
  }
  if (at->l != j) return false;
  const Half h = find(*at);
  if (h < 0) return false;
  insert(h, g);
  set_visible(g, true);
  return true;
}

bool WorldMap::exchange(GenId i, GenId j) {
  const auto is_disk = [&](GenId g) { return g >= 0 && g < disks(); };
  if (!is_disk(i) || !is_disk(j) || i == j || (!visible_[i] && !visible_[j])) return false;
  const std::vector<Half> of_i = ring(i), of_j = ring(j);
  for (const auto* ring : {&of_i, &of_j}) {
    for (const Half h : *ring) {
      note_cell(dest(h));
      note_edge(h);
      note_edge(previous(previous(h)));
    }
  }
  for (const Half h : of_i) halves_[h].org = j;
  for (const Half h : of_j) halves_[h].org = i;
  std::swap(anchor_[i + 1], anchor_[j + 1]);
  const bool i_before = visible_[i];
  visible_[i] = visible_[j];
  visible_[j] = i_before;
  note_cell(i);
  note_cell(j);
  return true;
}

bool WorldMap::step(const Step& step) {
  if (const auto* q = std::get_if<Quad>(&step)) return flip(*q);
  if (const auto* h = std::get_if<Hide>(&step)) return hide(*h);
  return appear(std::get<Appear>(step));
}

}  // namespace voroproof::internal
