#include "certify/world/world_replay.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "certify/world/world_cells.h"
#include "exact/patience.h"
#include "exact/simplest.h"

namespace voroproof::internal {

namespace {

constexpr GenId kNoHost = -2;

std::string number(GenId g) { return std::to_string(g); }

WorldMap map_of(int disks, const std::vector<Quad>& initial) {
  if (initial.empty()) return WorldMap(disks);
  try {
    return {disks, initial};
  } catch (const std::invalid_argument& e) {
    throw WorldRefuted{std::string("the initial diagram is none: ") + e.what()};
  }
}

}  // namespace

WorldReplay::WorldReplay(const World& world, const std::vector<Quad>& initial, bool filters)
    : motion_(world.motion(), filters),
      map_(map_of(motion_.disks(), initial)),
      hosts_(world.disks.size(), kNoHost) {
  next_ = LazyTime(Rational(0));
  open();
  now_->at_start = true;
  now_->proves_cells = true;
  for (const GenId g : map_.visible()) {
    if (!motion_.is_there(g)) throw WorldRefuted{"disk " + number(g) + " is not there at 0"};
    stir(g);
  }
  stir(container_id);
  for (GenId g = 0; g < motion_.disks(); ++g) now_->hidden.insert(g);
  if (!map_.has_edges()) see_alone();
}

// Without edges at the start one disk is visible at most, and which is not told.
void WorldReplay::see_alone() {
  GenId last = kNoHost;
  for (GenId g = 0; g < motion_.disks(); ++g) {
    if (!motion_.is_there(g)) continue;
    const auto is_in = [&](GenId h) { return is_inside_after(motion_, g, h, now_->t); };
    bool hidden = is_in(container_id) || (last >= 0 && is_in(last));
    for (GenId h = 0; h < motion_.disks() && !hidden; ++h) {
      hidden = motion_.is_there(h) && is_in(h);
      if (hidden) last = h;
    }
    if (hidden) continue;
    if (map_.count() == 1) {
      throw WorldRefuted{"two disks are visible at 0, " + number(map_.visible()[0]) + " and " +
                         number(g) + ", and the initial diagram has no edges"};
    }
    map_.show(g);
  }
}

// ---- Entering --------------------------------------------------------------------------

const LazyTime* WorldReplay::next() {
  if (!next_) {
    const WorldAgenda::Item* item = agenda_.next();
    if (item != nullptr) next_ = item->t;
    if (next_scheduled_ < motion_.schedule().size()) {
      const Rational& t = motion_.schedule()[next_scheduled_].t;
      if (!next_ || compare(*next_, t) >= 0) next_ = LazyTime(t);
    }
  }
  return next_ && compare(*next_, motion_.horizon()) <= 0 ? &*next_ : nullptr;
}

void WorldReplay::open() {
  Patience::ask();
  ++checked_.instants;
  now_.emplace(Instant{*next_});
  next_.reset();
  map_.begin_instant();
  // All that is due is seen as the instant finds it, before anything of the scene takes effect.
  while (const WorldAgenda::Item* item = agenda_.next()) {
    if (compare(item->t, now_->t) != 0) break;
    const WorldAgenda::Item due = *item;
    agenda_.drop();
    take_due(due);
  }
  while (next_scheduled_ < motion_.schedule().size()) {
    const Scheduled& change = motion_.schedule()[next_scheduled_];
    if (compare(now_->t, change.t) != 0) break;
    take_scheduled(change);
    ++next_scheduled_;
    now_->collapsing.clear();  // on other paths they need not
  }
  for (const Swap& meeting : now_->meetings) expect_swap(meeting);
}

void WorldReplay::take_due(const WorldAgenda::Item& item) {
  if (item.kind == WorldAgenda::Kind::edge) {
    now_->edges.insert(item.id);
    const Quad q = with_disk_on_left(map_.quad(2 * item.id));
    if (item.collapses) {
      now_->collapsing.insert(canonical(q));
    } else if (sign_at(world_tangency(motion_, q.l, q.r), now_->t.exact()) == Sign::zero) {
      touch(q.l, q.r);
    }
  } else if (item.kind == WorldAgenda::Kind::hidden) {
    now_->hidden.insert(item.id);
    const GenId h = hosts_[item.id];
    if (h >= 0 && coincide_at(motion_, item.id, h, now_->t)) coincide(item.id, h);
  }
}

// g becomes one with its neighbours: its cell and all around it are proved.
void WorldReplay::stir(GenId g) {
  now_->proves_cells = true;
  now_->centres.insert(g);
  for (const GenId h : map_.neighbours(g)) now_->around.insert(h);
}

// The tangency of two neighbours vanishes.
void WorldReplay::touch(GenId g, GenId h) {
  if (coincide_at(motion_, g, h, now_->t)) {
    coincide(g, h);
    stir(g);
    stir(h);
    return;
  }
  const int most = 64;
  const bool first = h < 0 || map_.degree(g, most) < map_.degree(h, most);
  stir(first ? g : h);
  now_->around.insert(first ? h : g);
}

void WorldReplay::coincide(GenId i, GenId j) {
  const Swap meeting{std::min(i, j), std::max(i, j)};
  auto& all = now_->meetings;
  if (std::find(all.begin(), all.end(), meeting) == all.end()) all.push_back(meeting);
}

// All of the scene has taken effect. Disks that it takes away or brings do not meet others.
void WorldReplay::expect_swap(const Swap& meeting) {
  const auto& [i, j] = meeting;
  const auto stays = [&](GenId g) { return motion_.is_there(g) && !now_->jumped.contains(g); };
  if (!stays(i) || !stays(j)) return;
  const std::string both = "the disks " + number(i) + " and " + number(j);
  for (GenId k = 0; k < motion_.disks(); ++k) {
    if (k == i || k == j || !stays(k) || !coincide_at(motion_, i, k, now_->t)) continue;
    throw WorldUndecided{both + " coincide with " + number(k)};
  }
  const bool parted = map_.is_visible(i) && map_.is_visible(j);
  if (!parted) {  // one is in the other, and the other in it afterwards
    const bool first = map_.is_visible(i);
    if (is_inside_after(motion_, first ? i : j, first ? j : i, now_->t)) {
      now_->swaps.push_back(meeting);
    }
  } else if (!now_->turned.contains(i) && !now_->turned.contains(j)) {
    now_->swaps.push_back(meeting);
  } else if (signs_then(world_tangency(motion_, i, j), now_->t.exact()).after == Sign::positive) {
    throw WorldUndecided{both + " coincide, and one of them turns"};
  }
}

void WorldReplay::take_scheduled(const Scheduled& change) {
  now_->scheduled.push_back(change);
  now_->hidden.insert(change.g);
  if (change.kind == Scheduled::Kind::turns) {
    now_->turned.insert(change.g);
  } else {
    now_->jumped.insert(change.g);
    stir(change.g);
  }
  motion_.take(change);
}

// ---- Leaving ---------------------------------------------------------------------------

void WorldReplay::close() {
  require_nothing_left();
  renew_hidden();
  renew_edges();
  renew_last_disk();
  if (now_->proves_cells && map_.has_edges()) prove_cells();
  now_.reset();
}

void WorldReplay::require_nothing_left() const {
  static constexpr const char* kinds[] = {"enters", "turns", "jumps", "leaves"};
  for (const Scheduled& s : now_->scheduled) {
    throw WorldRefuted{"disk " + number(s.g) + " " + kinds[static_cast<int>(s.kind)] +
                       ", which is not told"};
  }
  for (const Swap& s : now_->swaps) {
    throw WorldRefuted{"the disks " + number(s.i) + " and " + number(s.j) +
                       " change places, which is not told"};
  }
}

void WorldReplay::renew_edges() {
  std::set<int> edges = now_->edges;
  edges.insert(map_.changed_edges().begin(), map_.changed_edges().end());
  for (const auto* cells : {&now_->turned, &now_->centres}) {
    for (const GenId g : *cells) {
      for (const WorldMap::Half h : map_.ring(g)) {
        edges.insert(h / 2);
        edges.insert(map_.next(h) / 2);
      }
    }
  }
  for (const int k : edges) {
    agenda_.forget(WorldAgenda::Kind::edge, k);
    if (!map_.is_edge(k)) continue;
    EdgeFate fate = edge_fate(motion_, map_.quad(2 * k), now_->t);
    if (fate.fault) throw WorldRefuted{std::move(*fate.fault)};
    ++checked_.edge_lives;
    ++checked_.pair_lives;
    if (fate.due) {
      agenda_.note({*std::move(fate.due), WorldAgenda::Kind::edge, k, fate.collapses});
    }
  }
}

bool WorldReplay::is_host(GenId g, GenId h) const {
  return map_.is_visible(h) && motion_.is_there(h) && is_inside_after(motion_, g, h, now_->t);
}

bool WorldReplay::find_host(GenId g) {
  if (hosts_[g] != kNoHost && is_host(g, hosts_[g])) return true;
  for (GenId h = container_id; h < motion_.disks(); ++h) {
    if (!is_host(g, h)) continue;
    hosts_[g] = h;
    return true;
  }
  return false;
}

void WorldReplay::renew_hidden() {
  auto& again = now_->hidden;
  const auto is_stirred = [&](GenId h) {
    return now_->turned.count(h) != 0 || now_->centres.count(h) != 0;
  };
  if (now_->proves_cells || !now_->turned.empty()) {
    for (GenId g = 0; g < motion_.disks(); ++g) {
      if (hosts_[g] != kNoHost && (is_stirred(hosts_[g]) || !map_.is_visible(hosts_[g]))) {
        again.insert(g);
      }
    }
  }
  for (const GenId g : again) {
    agenda_.forget(WorldAgenda::Kind::hidden, g);
    if (!motion_.is_there(g)) {
      if (map_.is_visible(g)) throw WorldRefuted{"disk " + number(g) + " stays, but it is gone"};
      hosts_[g] = kNoHost;
    } else if (map_.is_visible(g)) {
      hosts_[g] = kNoHost;
    } else {
      if (!find_host(g)) {
        throw WorldRefuted{"disk " + number(g) + " is visible, which is not told"};
      }
      ++checked_.hidden_lives;
      auto exit = first_exit(motion_, g, hosts_[g], now_->t);
      if (exit) agenda_.note({*std::move(exit), WorldAgenda::Kind::hidden, g});
    }
  }
}

// A disk alone is followed until it leaves the frame.
void WorldReplay::renew_last_disk() {
  agenda_.forget(WorldAgenda::Kind::last_disk, 0);
  if (map_.count() != 1) return;
  const GenId g = map_.visible().front();
  if (is_inside_after(motion_, g, container_id, now_->t)) {
    throw WorldRefuted{"disk " + number(g) + " is outside of the frame, which is not told"};
  }
  ++checked_.pair_lives;
  auto contact = first_contact(motion_, g, container_id, now_->t);
  if (contact) agenda_.note({*std::move(contact), WorldAgenda::Kind::last_disk, 0});
}

// A time after the instant and before anything else happens.
Rational WorldReplay::time_after() {
  LazyTime end(motion_.limit());
  if (const WorldAgenda::Item* item = agenda_.next()) {
    if (compare(item->t, end) < 0) end = item->t;
  }
  if (next_scheduled_ < motion_.schedule().size()) {
    const Rational& t = motion_.schedule()[next_scheduled_].t;
    if (compare(end, t) > 0) end = LazyTime(t);
  }
  if (now_->t.hi() < end.lo()) {
    const Rational early = to_rational(now_->t.hi()), late = to_rational(end.lo());
    return simplest_between(early + (late - early) / 4, late - (late - early) / 2);
  }
  const Rational late = rational_between(now_->t.exact(), end.exact());
  return simplest_between(rational_between(now_->t.exact(), WorldTime(late)), late);
}

void WorldReplay::prove_cells() {
  std::set<GenId> cells = now_->around;
  cells.insert(map_.changed_cells().begin(), map_.changed_cells().end());
  for (const GenId g : now_->centres) {
    cells.insert(g);
    for (const GenId h : map_.neighbours(g)) cells.insert(h);
  }
  WorldCells proof(motion_, map_, time_after());
  for (const GenId g : cells) {
    if (!map_.is_visible(g)) continue;
    if (const auto fault = proof.fault(g)) throw WorldRefuted{*fault};
    ++checked_.cells;
  }
}

}  // namespace voroproof::internal
