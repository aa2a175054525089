#include "certify/exact_pairs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/standing.h"
#include "certify/wording.h"

namespace voroproof::internal {

// With whose last turn the present motion of the pair began: the later. The container where neither
// has turned.
GenId ExactPairs::born_last(GenId i, GenId j) const {
  const auto turned = [this](GenId g) { return g != container_id && births_[g] != nullptr; };
  if (!turned(i) || !turned(j)) return turned(i) ? i : turned(j) ? j : container_id;
  // States are numbered in their order of time.
  return s_.motion.state_id(i) > s_.motion.state_id(j) ? i : j;
}

Moment ExactPairs::born(GenId i, GenId j) const {
  const GenId g = born_last(i, j);
  return g != container_id ? *births_[g] : Moment::at(0);
}

bool ExactPairs::born_at_present(GenId i, GenId j) const {
  const GenId g = born_last(i, j);
  return (g != container_id ? instants_[g] : 0) == front_.instant && !front_.moment.is_flip();
}

Moment ExactPairs::since(GenId i, GenId j) const {
  return born_at_present(i, j) ? s_.chronology.present(front_.moment)
                               : s_.chronology.instant(born(i, j));
}

void ExactPairs::note_birth(GenId g, const Moment& m) {
  if (g == container_id) return;
  births_[g] = std::make_shared<const Moment>(m);
  instants_[g] = front_.instant;
}

Moment ExactPairs::moment_of(GenId i, GenId j, const NextContact& c) const {
  if (c.kind != NextContact::Kind::now) return Moment::of(i, j, c);
  return born_at_present(i, j) ? front_.moment : born(i, j);
}

NextContact ExactPairs::next_contact(GenId i, GenId j) {
  if (s_.replay.partners(i, j)) return {};
  NextContact c = s_.contacts.from(i, j, since(i, j), s_.search_end);
  if (c.kind != NextContact::Kind::at) return c;
  const DdBall dd = s_.contacts.refine(i, j, 0.5 * (c.lo + c.hi));
  if (std::isfinite(dd.rad)) {
    double lo = 0, hi = 0;
    enclose(dd, lo, hi);
    c.lo = std::max(c.lo, lo);
    c.hi = std::min(c.hi, hi);
  }
  return c;
}

std::string ExactPairs::standing(GenId i, GenId j, const Rational& t) const {
  const bool wall = i == container_id;
  const Moment& now = front_.moment;
  const double near = round_nearest(t);
  const bool present = std::fabs(near - now.lo) <= s_.tolerance_up;
  try {
    ExactMotion exact(s_.motion);
    const Tower at = !present                             ? Tower(t)
                     : now.kind == Moment::Kind::state    ? exact.start(now.state, now.j)
                     : now.kind == Moment::Kind::rational ? Tower(now.rational())
                                                          : Tower(t);
    const auto site = [&](GenId g) -> MovingSite<Tower> {
      const ExactMotion::State& m = exact.state(g);
      const Tower dt = at - Tower(m.t_ref);
      return {m.x + m.vx * dt, m.y + m.vy * dt, m.vx, m.vy, exact.radius(g)};
    };
    const MovingSite<Tower> first = site(i), second = site(j);
    const Tower reach = wall ? -(first.r + second.r) : first.r + second.r;
    return text_of(standing_of(Contact<Tower>(first, second), reach, wall), near);
  } catch (const BudgetExceeded&) {
    const DdBall at = present ? s_.chronology.narrow(now) : s_.chronology.narrow(Moment::at(t));
    const MovingSite<DdBall> first = s_.motion.moving_site(i, at),
                             second = s_.motion.moving_site(j, at);
    const DdBall reach = wall ? -(first.r + second.r) : first.r + second.r;
    return text_of(standing_of(Contact<DdBall>(first, second), reach, wall), near);
  }
}

void ExactPairs::require_no_meeting(GenId i, GenId j, const Moment& m) {
  const NextContact c = s_.contacts.from(i, j, since(i, j), std::nextafter(m.hi, HUGE_VAL));
  if (c.kind == NextContact::Kind::none || s_.chronology.compare(moment_of(i, j, c), m) > 0) return;
  throw Undecided("two points meet: a contact without a normal", i, j);
}

void ExactPairs::require_no_contact(GenId i, GenId j, const Moment& m, PairEnd why) {
  const NextContact c = s_.contacts.from(i, j, since(i, j), std::nextafter(m.hi, HUGE_VAL));
  if (c.kind == NextContact::Kind::none) return;
  const Moment contact = moment_of(i, j, c);
  const int order = s_.chronology.compare(contact, m);
  if (order > 0) return;
  const auto [lo, hi] = s_.chronology.enclosure(contact);
  Refuted missing{refuter_.missing_contact(i, j, lo, hi)};
  if (order < 0 || why != PairEnd::turn) throw missing;
  order_.note_due(i, j, std::move(missing.divergence));
}

}  // namespace voroproof::internal
