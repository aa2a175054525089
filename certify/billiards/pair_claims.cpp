// Whether a claimed collision is one of its pair's, and which fault it is where it is not.
#include <algorithm>

#include "certify/billiards/pair_signs.h"
#include "certify/billiards/pair_watch.h"
#include "history/json_text.h"

namespace voroproof::internal {

// Whether the two have just collided and cannot meet again on these lines: their gap is convex, but
// in a frame, and under gravity for one that is fixed.
bool PairWatch::have_parted(const Life& life) const {
  const auto& [a, b, image] = life.pair;
  if (a < 0) return false;
  const auto is_fixed = [&](GenId g) { return billiard_.disks[static_cast<std::size_t>(g)].fixed; };
  const auto is_own = [&](const BilliardLine& line) { return line.by == life.pair; };
  if (is_fixed(a) != is_fixed(b)) {
    return near_.degree(life.pair) == 2 && is_own(is_fixed(a) ? life.b() : life.a());
  }
  return is_own(life.a()) && life.a().claim == life.b().claim;
}

// Whether the claim at t answers the overlap that is in progress.
bool PairWatch::answer_open(const Life& life, const Rational& t, Walk& walk) const {
  OverlapEpisode& episode = *walk.state.open;
  const Rational earliest = t - tolerance_;
  const bool on_these_lines = (episode.entry <=> life.begin()) >= 0;
  if (on_these_lines && !episode.answer) return (episode.entry <=> earliest) >= 0;
  const Rational length = t - life.since();
  if (sign(form(life, 0).derivative().evaluate(length)) != Sign::negative) return false;
  if (!episode.deep) {
    // An overlap that is none but for roundings counts as entered where these lines begin.
    if (life.begin() < earliest) return false;
    episode.entry = {life.begin(), Rational(0)};
    return true;
  }
  return !episode.answer && (episode.entry <=> earliest) >= 0;
}

// Whether the two come nearest within the tolerance of t, to no more than their rounding.
bool PairWatch::comes_near(const Life& life, const Rational& t, Walk& walk) const {
  const Rational middle = t - life.since();
  const Rational first = life.begin() - life.since();
  const Rational lo = std::max<Rational>(first, middle - tolerance_), hi = middle + tolerance_;
  const Polynomial<Rational> f = form(life, 0), slope = f.derivative();
  const Rational depth = rounding(life);
  if ((life.pair.a >= 0 || billiard_.round) && exact_.reach(life.pair, t) < 4 * depth) return false;
  if (is_negative_in(f, lo, hi)) return false;  // that would be an entry, and is not due
  for (const auto& root : roots_of(slope, lo, hi)) {
    const SignsAround signs = signs_around(slope, root);
    if (signs.before != Sign::negative || signs.after != Sign::positive) continue;
    // Where their lines begin they came no nearer.
    if (compare(root, first) == 0) continue;
    if (sign_at(form(life, -depth), root) != Sign::positive) {
      ++walk.found.grazes;
      return true;
    }
  }
  return false;
}

bool PairWatch::answers(const Life& life, const BilliardClaim& claim, Walk& walk) const {
  if (have_parted(life)) return false;
  PairState& state = walk.state;
  const Rational t = claim.t.value();
  if (state.open) {
    if (!answer_open(life, t, walk)) return false;
    state.open->answer = t;
    state.open->answer_line = claim.line;
    return true;
  }
  for (auto episode = state.ended.begin(); episode != state.ended.end(); ++episode) {
    if ((episode->entry <=> life.begin()) < 0 || (episode->entry <=> t - tolerance_) < 0) continue;
    state.ended.erase(episode);
    return true;
  }
  const Rational length = t - life.since();
  if (first_fall(form(life, 0), length, length + tolerance_)) return true;
  return comes_near(life, t, walk);
}

// Another image that touches then, where the one that is named does not.
std::optional<LatticeImage> PairWatch::touching_image(const Life& life, const Rational& t) const {
  const Rational length = t - life.since(), lo = std::max<Rational>(0, length - tolerance_);
  const Flight<Rational> a = life.path_a.exact(life.index_a), b = life.path_b.exact(life.index_b);
  for (const LatticeImage& other : images_.all(life.pair, a, b, t)) {
    if (other == life.pair.image) continue;
    const BilliardPair pair{life.pair.a, life.pair.b, other};
    const Life there{pair,         life.path_a, life.path_b, life.index_a,
                     life.index_b, life.from,   life.to};
    if (first_fall(form(there, 0), lo, length + tolerance_)) return other;
  }
  return std::nullopt;
}

BilliardFault PairWatch::fault_of(const Life& life, const BilliardClaim& claim) const {
  const Rational t = claim.t.value();
  BilliardFault fault{Fault::spurious_event, claim.line, round_nearest(t), name(life.pair),
                      std::pair(life.pair.a, life.pair.b)};
  if (const auto image = touching_image(life, t)) {
    fault.kind = Fault::wrong_image;
    fault.truth = name({life.pair.a, life.pair.b, *image}) + " touch, and not " + name(life.pair);
    return fault;
  }
  if (have_parted(life)) {
    fault.truth += " have just collided, and neither has turned since";
    return fault;
  }
  const Polynomial<Rational> f = form(life, 0);
  const Rational length = t - life.since();
  if (const auto entry = first_fall(f, 0, horizon_ - life.since())) {
    const double truth = EntryTime{life.since(), *entry}.rounded();
    fault.kind = Fault::wrong_time;
    fault.truth += " touch at t = " + number_text(truth) + ", which is " +
                   number_text(std::fabs(truth - fault.t)) +
                   " off the claimed time (--tolerance sets what is allowed)";
    return fault;
  }
  const Sign now = sign(f.evaluate(length));
  const Sign slope = sign(f.derivative().evaluate(length));
  if (now != Sign::positive && slope != Sign::negative) {
    fault.truth += " touch then, but do not approach";
  } else if (now == Sign::negative) {
    fault.truth += " overlap then, for longer than the tolerance";
  } else {
    fault.truth += " do not touch then, nor later on these lines";
  }
  return fault;
}

void PairWatch::judge_claim(const Life& life, const BilliardClaim& claim, Walk& walk) const {
  if (answers(life, claim, walk)) {
    require_mover(life.pair);
    return;
  }
  PairState& state = walk.state;
  const BilliardFault fault = fault_of(life, claim);
  walk.found.faults.push_back(fault);
  // A late claim tells of this overlap: it is not missing as well.
  if (state.open) state.open->told = true;
  if (fault.kind == Fault::wrong_time) state.ended.clear();
}

}  // namespace voroproof::internal
