#include "certify/billiards/pair_watch.h"

#include <algorithm>
#include <limits>

#include "certify/billiards/pair_signs.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

double up(const DoubleBall& x) {
  return std::nextafter(x.mid + x.rad, std::numeric_limits<double>::infinity());
}
double down(const DoubleBall& x) {
  return std::nextafter(x.mid - x.rad, -std::numeric_limits<double>::infinity());
}

}  // namespace

BilliardTime::BilliardTime(const Rational& t) : exact(t) {
  const double x = t.get_d();
  near = {x, to_rational(x) == t ? 0 : std::fabs(x) * 0x1p-52 + DBL_MIN};
}

const Rational& PairWatch::Life::begin() const {
  if (pair.a < 0) return b.from.exact;
  return std::max(a.from.exact, b.from.exact);
}

PairWatch::PairWatch(const Billiard& billiard, const Rational& horizon, const Rational& tolerance,
                     const Rational& extent)
    : billiard_(billiard),
      horizon_(horizon),
      tolerance_(tolerance),
      extent_(extent),
      tolerance_down_(round_down(tolerance)),
      tolerance_up_(round_up(tolerance)),
      exact_(billiard),
      near_(billiard) {}

std::string PairWatch::name(const BilliardPair& pair) const {
  const std::string ball = billiard_.dimension == 3 ? "ball " : "disk ";
  if (pair.a < 0) {
    const std::string frame = billiard_.round ? "the frame" : "wall " + std::to_string(pair.a);
    return ball + std::to_string(pair.b) + " and " + frame;
  }
  std::string text = ball + std::to_string(pair.a) + " and " + ball + std::to_string(pair.b);
  if (pair.image == LatticeImage{}) return text;
  text += " at image [";
  for (int k = 0; k < billiard_.dimension; ++k) {
    text += (k ? "," : "") + std::to_string(pair.image[static_cast<std::size_t>(k)]);
  }
  return text + "]";
}

Rational PairWatch::rounding(const Life& life) const {
  const std::int64_t turns = (life.pair.a < 0 ? 0 : life.a.turns) + life.b.turns;
  Rational rounding = extent_ * static_cast<long>(std::max<std::int64_t>(1, turns));
  return rounding >> 51;
}

Polynomial<Rational> PairWatch::form(const Life& life, const Rational& depth) const {
  const GapForm<Rational> f =
      exact_.form(life.pair, life.a.exact, life.b.exact, life.from.exact, depth);
  return Polynomial<Rational>(std::vector<Rational>(f.begin(), f.end()));
}

bool PairWatch::certainly_apart(const Life& life) const {
  return certainly_positive(life.near, near_.degree(life.pair), 0, life.length_up);
}

// After a collision that was answered: the two part until the tolerance is over, and are apart
// then. So an episode in progress at its beginning ends within the tolerance, and there is no
// other.
bool PairWatch::certainly_parting(const Life& life) const {
  const int degree = near_.degree(life.pair);
  return life.length_down > tolerance_up_ &&
         certainly_positive(derivative(life.near), degree, 0, tolerance_up_) &&
         certainly_positive(life.near, degree, tolerance_down_, life.length_up);
}

// The two are apart until the tolerance before the claim, and approach from then on until the
// tolerance after it, when they would overlap: so there is one entry, and it is answered.
bool PairWatch::certainly_answered(const Life& life, const BilliardClaim&) const {
  const int degree = near_.degree(life.pair);
  const double before = life.length_up - tolerance_down_;
  const double first = std::max(0.0, before);
  if (sign(life.near[0]) != Sign::positive) return false;
  if (before > 0 && !certainly_positive(life.near, degree, 0, before)) return false;
  const double after = std::nextafter(life.length_down + tolerance_down_, 0.0);
  if (sign(value_at(life.near, after)) != Sign::negative) return false;
  GapForm<DoubleBall> falling = derivative(life.near);
  for (DoubleBall& c : falling) c = -c;
  return certainly_positive(falling, degree, std::max(0.0, first - tolerance_up_),
                            life.length_up + tolerance_up_);
}

void PairWatch::open(const EntryTime& entry, Walk& walk) const {
  OverlapEpisode& episode = walk.state.open.emplace(OverlapEpisode{entry, false, false, {}, 0, 0});
  episode.line = walk.line_after(entry);
}

void PairWatch::miss(const OverlapEpisode& episode, Walk& walk) const {
  if ((episode.entry <=> horizon_ - tolerance_) >= 0) {
    ++walk.found.left_out;
    return;
  }
  walk.found.faults.push_back({Fault::missing_event, episode.line, episode.entry.rounded(),
                               name(walk.pair) +
                                   " touch at t = " + number_text(episode.entry.rounded()) +
                                   ", and overlap from then on; no collision of them is claimed",
                               walk.pair});
}

// An overlap that no claim answers in time, or that goes on when its collision is over.
void PairWatch::close(const EntryTime& exit, Walk& walk) const {
  OverlapEpisode episode = *std::move(walk.state.open);
  walk.state.open.reset();
  if (episode.told) return;
  if (!episode.answer) {
    walk.state.ended.push_back(std::move(episode));
  } else if (episode.deep && (exit <=> *episode.answer + tolerance_) > 0) {
    walk.found.faults.push_back(
        {Fault::overlap, episode.answer_line, round_nearest(*episode.answer),
         name(walk.pair) + " overlap until t = " + number_text(exit.rounded()) +
             ", for longer than the tolerance after their collision",
         walk.pair});
  }
}

void PairWatch::expire(const Rational& now, Walk& walk) const {
  PairState& state = walk.state;
  if (state.answered && *state.answered + tolerance_ < now) state.answered.reset();
  if (state.open && state.open->deep && !state.open->told) {
    if (state.open->answer && *state.open->answer + tolerance_ < now) {
      const OverlapEpisode episode = *state.open;
      close({now, Rational(0)}, walk);
      state.open = episode;
      state.open->told = true;
    } else if (!state.open->answer && (state.open->entry <=> now - tolerance_) < 0) {
      miss(*state.open, walk);
      state.open->told = true;
    }
  }
  std::erase_if(state.ended, [&](const OverlapEpisode& episode) {
    if ((episode.entry <=> now - tolerance_) >= 0) return false;
    if (episode.deep)
      miss(episode, walk);
    else
      ++walk.found.rounding_overlaps;
    return true;
  });
}

// Tells what doubles left open of a collision that was answered when this life began.
void PairWatch::settle(Life& life, Walk& walk) const {
  PairState& state = walk.state;
  if (!state.answered) return;
  const Rational t = *state.answered;
  state.answered.reset();
  if (state.open || sign(form(life, 0).evaluate(0)) != Sign::negative) return;
  OverlapEpisode& episode =
      state.open.emplace(OverlapEpisode{{t, Rational(0)}, false, false, {}, 0, 0});
  episode.answer = t;
  episode.answer_line = state.answered_line;
  const Rational depth = rounding(life);
  episode.deep = (life.pair.a >= 0 || billiard_.round) && exact_.reach(life.pair, t) < 4 * depth
                     ? true
                     : sign(form(life, depth).evaluate(0)) == Sign::negative;
}

// Opens and closes the episodes of [from, to) on lines that both keep.
void PairWatch::judge_life(const Life& life, Walk& walk) const {
  PairState& state = walk.state;
  ++walk.found.exact_lives;
  const Rational& since = life.from.exact;
  const Rational length = life.to.exact - since;
  const Polynomial<Rational> f = form(life, 0);
  const Rational depth = rounding(life);
  const bool has_reach = life.pair.a >= 0 || billiard_.round;
  const bool covered = !has_reach || (exact_.reach(life.pair, since) >= 4 * depth &&
                                      exact_.reach(life.pair, life.to.exact) >= 4 * depth);
  const Polynomial<Rational> deeper = covered ? form(life, depth) : f;
  Rational begun = 0;  // where the episode in progress began, in this life
  const auto at = [&](const AlgebraicNumber<Rational>& u) { return EntryTime{since, u}; };
  const auto deepen = [&](const Rational& lo, const Rational& hi) {
    if (!state.open->deep) state.open->deep = is_negative_in(deeper, lo, hi);
  };
  const Sign first = sign_after(f, 0);
  if (!state.open && first == Sign::negative) open(at(Rational(0)), walk);
  if (state.open && first != Sign::negative) close(at(Rational(0)), walk);
  for (const auto& root : roots_of(f, 0, length)) {
    if (compare(root, Rational(0)) == 0 || compare(root, length) >= 0) continue;
    const SignsAround signs = signs_around(f, root);
    if (signs.before != Sign::negative && signs.after == Sign::negative) {
      open(at(root), walk);
      begun = root.interval().lo;
    } else if (signs.before == Sign::negative && signs.after != Sign::negative) {
      deepen(std::max<Rational>(begun, 0), std::min(root.interval().hi, length));
      close(at(root), walk);
    }
  }
  if (state.open) deepen(std::max<Rational>(begun, 0), length);
}

void PairWatch::follow(const BilliardPair& pair, const BilliardPath& a, const BilliardPath& b,
                       const std::vector<BilliardClaim>& claims, const Window& window,
                       PairState& state, BilliardFindings& found) const {
  constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
  Walk walk{pair, window, state, found};
  std::size_t ia = 0, ib = 0, next_claim = 0;
  BilliardTime now = window.from;
  const auto turn_of = [](const BilliardPath& path, std::size_t i) {
    return i + 1 < path.size() ? path[i + 1].claim : never;
  };
  const bool is_wall = pair.a < 0;
  for (;;) {
    const std::int64_t turn_a = is_wall ? never : turn_of(a, ia), turn_b = turn_of(b, ib);
    const std::int64_t own = next_claim < claims.size() ? claims[next_claim].number : never;
    const std::int64_t turn = std::min({turn_a, turn_b, own});
    const BilliardClaim* claim = turn == own && own != never ? &claims[next_claim] : nullptr;
    const BilliardTime& to = turn == never    ? window.to
                             : claim          ? claim->t
                             : turn == turn_a ? a[ia + 1].from
                                              : b[ib + 1].from;
    Life life{pair, is_wall ? b[ib] : a[ia], b[ib], now, to};
    life.near = near_.form(pair, life.a.near, life.b.near, now.near, DoubleBall(0));
    const DoubleBall length = to.near - now.near;
    life.length_up = std::max(0.0, up(length));
    life.length_down = std::max(0.0, down(length));
    ++found.pair_lives;
    const bool lasts = now.exact < to.exact;
    const bool plain = !state.open && state.ended.empty() && !state.answered;
    if (claim && plain && certainly_answered(life, *claim)) {
      state.answered = claim->t.exact;
      state.answered_line = claim->line;
    } else {
      const bool clear = !claim && (plain ? certainly_apart(life)
                                          : state.answered && !state.open && state.ended.empty() &&
                                                certainly_parting(life));
      if (clear) {
        state.answered.reset();
      } else {
        settle(life, walk);
        if (lasts) judge_life(life, walk);
        if (claim) judge_claim(life, *claim, walk);
      }
    }
    if (turn == never) break;
    expire(to.exact, walk);
    if (claim) ++next_claim;
    if (turn == turn_a) ++ia;
    if (turn == turn_b) ++ib;
    now = to;
  }
  expire(window.to.exact, walk);
  if (window.last) finish(walk);
}

// No claim comes any more.
void PairWatch::finish(Walk& walk) const {
  PairState& state = walk.state;
  if (state.open && !state.open->answer && !state.open->told)
    state.ended.push_back(*std::move(state.open));
  for (const OverlapEpisode& episode : state.ended) {
    if (episode.deep)
      miss(episode, walk);
    else
      ++walk.found.rounding_overlaps;
  }
  state = {};
}

}  // namespace voroproof::internal
