// The claims of an instant.
#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include "certify/world/world_replay.h"

namespace voroproof::internal {

namespace {

std::string number(GenId g) { return std::to_string(g); }

// A told value is the exact one, or that rounded to nearest.
bool is_told(const Rational& told, const Rational& exact) {
  return told == exact || told == to_rational(round_nearest(exact));
}
bool is_told(const std::optional<Rational>& told, const Rational& exact) {
  return !told || is_told(*told, exact);
}
bool is_told(const std::optional<Point2>& told, const Rational& x, const Rational& y) {
  return !told || (is_told(told->x, x) && is_told(told->y, y));
}

}  // namespace

bool WorldReplay::refuse(std::string why) {
  why_not_ = std::move(why);
  return false;
}

bool WorldReplay::take(const WorldEvent& event) {
  why_not_.clear();
  const bool by_scene =
      std::holds_alternative<PathTurn>(event.what) || std::holds_alternative<Jump>(event.what);
  if (now_->at_start && !by_scene) {
    return refuse("the initial diagram is that after all events at 0");
  }
  return std::visit([&](const auto& what) { return claim(what); }, event.what);
}

// ---- Flips -----------------------------------------------------------------------------

// Whether the tangency of both vanishes at the instant, and g is in h just after it.
bool WorldReplay::falls_at(GenId g, GenId h) const {
  return signs_then(world_tangency(motion_, g, h), now_->t.exact()).at == Sign::zero &&
         is_inside_after(motion_, g, h, now_->t);
}

bool WorldReplay::is_about_to_hide(GenId g) const {
  if (g < 0 || map_.degree(g, 3) <= 2) return false;
  const std::vector<GenId> around = map_.neighbours(g);
  return std::any_of(around.begin(), around.end(), [&](GenId h) { return falls_at(g, h); });
}

// An edge that has no length at the instant flips where it is not legal just after it, or where it
// is one of a disk that is about to hide, or has to do with one that touches another or jumps: the
// cells around that are proved, however flips have led to them.
bool WorldReplay::claim(const Quad& q) {
  if (!names_an_edge(q) || map_.find(q) < 0) return refuse("there is no edge " + text_of(q));
  if (q.s == q.e) return refuse("the edge " + text_of(q) + " cannot flip");
  if (now_->collapsing.contains(canonical(q))) return map_.flip(q);
  const GenId all[] = {q.l, q.r, q.s, q.e};
  bool separated = true;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      separated =
          separated && signs_then(world_tangency(motion_, all[i], all[j]), now_->t.exact()).after ==
                           Sign::positive;
    }
  }
  const WorldEdge edge(motion_, q);
  const bool stirred = std::any_of(std::begin(all), std::end(all),
                                   [&](GenId g) { return now_->centres.count(g) != 0; });
  const bool free = stirred || is_about_to_hide(q.l) || is_about_to_hide(q.r);
  if (!edge.is_point_at(now_->t.exact(), now_->proves_cells)) {
    return refuse("the edge " + text_of(q) + " has a length");
  }
  if (!free && !(separated && edge.is_illegal_after(now_->t.exact()))) {
    return refuse("the edge " + text_of(q) + " does not collapse");
  }
  return map_.flip(q);
}

// ---- Disks that hide, appear and change places -------------------------------------------

bool WorldReplay::claim(const Hide& hide) {
  const auto& [g, j] = hide;
  const std::string who = "disk " + number(g);
  if (!is_disk(g) || !map_.is_visible(g) || !motion_.is_there(g)) {
    return refuse(who + " is not visible");
  }
  if (g == j || (j != container_id && (!is_disk(j) || !map_.is_visible(j)))) {
    return refuse("generator " + number(j) + " is no host");
  }
  if (!falls_at(g, j)) return refuse(who + " does not come into " + number(j));
  if (!map_.hide(hide))
    return refuse(who + " has not two edges, of which one is with " + number(j));
  hosts_[g] = j;
  now_->hidden.insert(g);
  stir(g);
  return true;
}

bool WorldReplay::claim(const Appear& appear) {
  const auto& [g, j, at] = appear;
  const std::string who = "disk " + number(g);
  if (!is_disk(g) || map_.is_visible(g) || !motion_.is_there(g)) {
    return refuse(who + " is not hidden");
  }
  if (g == j || (j != container_id && (!is_disk(j) || !map_.is_visible(j)))) {
    return refuse("generator " + number(j) + " is no host");
  }
  const SignsThen p = signs_then(world_tangency(motion_, g, j), now_->t.exact());
  const bool is_larger =
      j < 0 ||
      signs_then(motion_.course(j).r - motion_.course(g).r, now_->t.exact()).at != Sign::negative;
  if (p.at != Sign::zero || p.after != Sign::positive || !is_larger) {
    return refuse(who + " does not leave " + number(j));
  }
  if (at && map_.find(*at) < 0) return refuse("there is no edge " + text_of(*at));
  if (!map_.appear(appear)) return refuse(who + " does not come into that edge");
  now_->hidden.insert(g);
  stir(g);
  return true;
}

bool WorldReplay::claim(const Swap& swap) {
  const auto& [i, j] = swap;
  const auto found = std::find(now_->swaps.begin(), now_->swaps.end(), swap);
  // Steps of a jump may lead to where two that are one then have each other's places, or to where
  // they have their own: the cells around are proved.
  const bool may = !now_->jumped.empty() && is_disk(i) && is_disk(j) && i != j &&
                   std::find(now_->told.begin(), now_->told.end(), swap) == now_->told.end() &&
                   motion_.is_there(i) && motion_.is_there(j) &&
                   coincide_at(motion_, i, j, now_->t);
  if ((found == now_->swaps.end() && !may) || !map_.exchange(i, j)) {
    return refuse("the disks " + number(i) + " and " + number(j) + " do not change places");
  }
  if (found != now_->swaps.end()) now_->swaps.erase(found);
  now_->told.push_back(swap);
  for (const GenId g : {i, j}) {
    now_->hidden.insert(g);
    hosts_[g] = container_id;  // to be found anew
    stir(g);
  }
  return true;
}

// ---- What the scene says ---------------------------------------------------------------

Scheduled* WorldReplay::scheduled(GenId g, bool turn) {
  for (Scheduled& s : now_->scheduled) {
    if (s.g == g && (s.kind == Scheduled::Kind::turns) == turn) return &s;
  }
  return nullptr;
}

void WorldReplay::forget(const Scheduled& change) {
  const auto place = &change - now_->scheduled.data();
  now_->scheduled.erase(now_->scheduled.begin() + place);
}

bool WorldReplay::claim(const PathTurn& turn) {
  const Scheduled* s = scheduled(turn.g, true);
  if (s == nullptr) return refuse("disk " + number(turn.g) + " has no maneuver");
  const GrowingDisk& d = s->after;
  if (!is_told(turn.velocity, d.vx, d.vy) || !is_told(turn.center, d.x, d.y) ||
      !is_told(turn.growth, d.growth)) {
    throw WorldRefuted{"the state of disk " + number(turn.g) + " after its maneuver is another"};
  }
  forget(*s);
  return true;
}

bool WorldReplay::claim(const Jump& jump) {
  const Scheduled* s = scheduled(jump.g, false);
  if (s == nullptr) return refuse("disk " + number(jump.g) + " does not jump");
  const std::string who = "disk " + number(jump.g);
  const bool comes = s->kind == Scheduled::Kind::enters, goes = s->kind == Scheduled::Kind::leaves;
  if (comes && jump.out) throw WorldRefuted{who + " comes, and was not there"};
  if (goes && (jump.in || jump.center || jump.velocity || jump.radius)) {
    throw WorldRefuted{who + " goes, and is not there afterwards"};
  }
  const GrowingDisk& d = s->after;
  if (!goes && (!is_told(jump.center, d.x, d.y) || !is_told(jump.velocity, d.vx, d.vy) ||
                !is_told(jump.radius, d.radius))) {
    throw WorldRefuted{"the state of " + who + " after its jump is another"};
  }
  forget(*s);
  ++checked_.jumps;
  if (now_->at_start) {
    // The initial diagram is that after the jump.
    const auto has = [](const auto& steps) { return steps && !steps->empty(); };
    if (has(jump.out) || has(jump.in)) throw WorldRefuted{who + " jumps at 0, which has no steps"};
    return true;
  }
  if (!comes && !jump.out) throw WorldRefuted{who + " does not go out before its jump"};
  if (!goes && !jump.in) throw WorldRefuted{who + " does not come in after its jump"};
  if (!comes) jump_out(jump);
  if (!goes) jump_in(jump);
  drop_unseen_swaps();
  return true;
}

// Steps are done without a question: the diagram is proved when the instant is left.
void WorldReplay::take_steps(const std::vector<Step>& steps, const char* which) {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const std::string where =
        std::string("step ") + std::to_string(k + 1) + " of `" + which + "` of a jump ";
    if (const auto* h = std::get_if<Hide>(&steps[k])) {
      if (!map_.hide(*h)) throw WorldRefuted{where + "is not possible: no such cell of two edges"};
      now_->hidden.insert(h->g);
      stir(h->g);
    } else if (const auto* a = std::get_if<Appear>(&steps[k])) {
      // One that goes later at this instant may come out of one that goes.
      if (is_disk(a->g) && !motion_.is_there(a->g) && scheduled(a->g, false) == nullptr) {
        throw WorldRefuted{where + "is not possible: disk " + number(a->g) + " is not there"};
      }
      if (!map_.appear(*a)) throw WorldRefuted{where + "is not possible: no such edge"};
      now_->hidden.insert(a->g);
      stir(a->g);
    } else if (!map_.flip(std::get<Quad>(steps[k]))) {
      throw WorldRefuted{where + "is not possible: there is no edge " +
                         text_of(std::get<Quad>(steps[k]))};
    }
  }
}

// Two change places where both have a cell, or one has and the other is in it. Steps of a jump may
// hide both before, or one in a third.
void WorldReplay::drop_unseen_swaps() {
  std::erase_if(now_->swaps, [&](const Swap& s) {
    if (map_.is_visible(s.i) && map_.is_visible(s.j)) return false;
    if (!map_.is_visible(s.i) && !map_.is_visible(s.j)) return true;
    return signs_then(world_tangency(motion_, s.i, s.j), now_->t.exact()).after == Sign::positive;
  });
}

void WorldReplay::jump_out(const Jump& jump) {
  take_steps(*jump.out, "out");
  // Beside one visible disk at most nothing need be told of how it goes.
  if (map_.is_visible(jump.g) && map_.count() <= 2) {
    stir(jump.g);
    map_.remove_few(jump.g);
  }
  if (map_.is_visible(jump.g)) {
    throw WorldRefuted{"disk " + number(jump.g) + " jumps, and its cell stays"};
  }
}

void WorldReplay::jump_in(const Jump& jump) {
  take_steps(*jump.in, "in");
  stir(jump.g);
}

}  // namespace voroproof::internal
