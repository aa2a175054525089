#include "certify/billiards/pair_watch.h"

#include <algorithm>
#include <limits>

#include "certify/billiards/pair_signs.h"
#include "certify/vectors.h"
#include "filtered/billiards/line_boxes.h"
#include "filtered/motion/options.h"
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

Rational PairWatch::Life::begin() const {
  if (pair.a < 0) return b().from.value();
  return std::max(a().from.value(), b().from.value());
}

PairWatch::PairWatch(const Billiard& billiard, const Rational& horizon, const Rational& tolerance,
                     const Rational& extent, bool filters)
    : billiard_(billiard),
      horizon_(horizon),
      tolerance_(tolerance),
      extent_(extent),
      tolerance_down_(round_down(tolerance)),
      tolerance_up_(round_up(tolerance)),
      filters_(filters),
      exact_(billiard),
      near_(billiard),
      images_(billiard, exact_) {}

std::string PairWatch::name(const BilliardPair& pair) const { return name_of(billiard_, pair); }

// Each turn rounds places, and the last one times as well, by which the two go on from elsewhere.
Rational PairWatch::rounding(const Life& life) const {
  const auto speed = [](const BilliardLine& line) {
    const Vec3 v = value_of(line.velocity);
    return root_bound(dot(v, v));
  };
  Rational speeds = speed(life.b());
  std::int64_t turns = life.b().turns;
  if (life.pair.a >= 0) {
    speeds += speed(life.a());
    turns += life.a().turns;
  }
  const Rational places = extent_ * static_cast<long>(std::max<std::int64_t>(1, turns));
  return Rational(places + speeds * life.begin()) >> 51;
}

Polynomial<Rational> PairWatch::form(const Life& life, const Rational& depth) const {
  const GapForm<Rational> f = exact_.form(life.pair, life.path_a.exact(life.index_a),
                                          life.path_b.exact(life.index_b), life.since(), depth);
  return Polynomial<Rational>(std::vector<Rational>(f.begin(), f.end()));
}

// Doubles decide the usual cases. Without a claim the two are apart throughout. With one they are
// apart until the tolerance before it, and approach from then on until the tolerance after it, when
// they would overlap: so there is one entry, and it is answered. After a collision that was
// answered the two part until the tolerance is over, and are apart then: so an episode in progress
// ends within the tolerance, and there is no other.
bool PairWatch::certainly_regular(const Life& life, bool answered, bool claimed) const {
  const int degree = near_.degree(life.pair);
  const double first = answered ? tolerance_down_ : 0;
  const double last =
      claimed ? up(DoubleBall(life.length_up) - DoubleBall(tolerance_down_)) : life.length_up;
  if (answered && (!(life.length_down > 3 * tolerance_up_) ||
                   !certainly_positive(derivative(life.near), degree, 0, tolerance_up_)))
    return false;
  if (!certainly_positive(life.near, degree, first, std::max(first, last))) return false;
  if (!claimed) return true;
  const double after = down(DoubleBall(life.length_down) + DoubleBall(tolerance_down_));
  if (sign(value_at(life.near, after)) != Sign::negative) return false;
  GapForm<DoubleBall> falling = derivative(life.near);
  for (DoubleBall& c : falling) c = -c;
  return certainly_positive(falling, degree, std::max(0.0, last - tolerance_up_),
                            life.length_up + tolerance_up_);
}

bool PairWatch::has_mover(const BilliardPair& pair) const {
  const auto moves = [&](GenId g) {
    return g >= 0 && !billiard_.disks[static_cast<std::size_t>(g)].fixed;
  };
  return moves(pair.a) || moves(pair.b);
}

void PairWatch::require_mover(const BilliardPair& pair) const {
  if (!has_mover(pair)) throw Undecided(name(pair) + " touch, and cannot move", pair.a, pair.b);
}

void PairWatch::open(const EntryTime& entry, Walk& walk) const {
  require_mover(walk.pair);
  OverlapEpisode& episode = walk.state.open.emplace(OverlapEpisode{entry, false, false, {}, 0, 0});
  episode.line = walk.line_after(entry);
}

void PairWatch::miss(const OverlapEpisode& episode, Walk& walk) const {
  if ((episode.entry <=> walk.window.until - tolerance_) >= 0) {
    ++walk.found.left_out;
    return;
  }
  walk.found.faults.push_back({Fault::missing_event, episode.line, episode.entry.rounded(),
                               name(walk.pair) +
                                   " touch at t = " + number_text(episode.entry.rounded()) +
                                   ", and overlap from then on; no collision of them is claimed",
                               std::pair(walk.pair.a, walk.pair.b)});
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
         std::pair(walk.pair.a, walk.pair.b)});
  }
}

void PairWatch::expire(const BilliardTime& at, Walk& walk) const {
  PairState& state = walk.state;
  if (!state.open && state.ended.empty()) return;
  const Rational now = at.value();
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

// Whether the two overlap by more than that rounding somewhere in [lo, hi], in the time since the
// beginning of the life. A rounding explains nothing where the reach is not four times as large.
bool PairWatch::is_deeper_in(const Life& life, const Rational& depth, const Rational& lo,
                             const Rational& hi) const {
  const Polynomial<Rational> deeper = form(life, depth), any = form(life, 0);
  if (life.pair.a < 0 && !billiard_.round) return is_negative_in(deeper, lo, hi);
  const Rational since = life.since();
  const auto beyond = [&](const Rational& u) {
    return Rational(exact_.reach(life.pair, since + u) - 4 * depth);
  };
  const Rational first = beyond(lo), last = beyond(hi);
  if (first >= 0 && last >= 0) return is_negative_in(deeper, lo, hi);
  if (first < 0 && last < 0) return is_negative_in(any, lo, hi);
  const Rational cut = lo + (hi - lo) * first / (first - last);
  return is_negative_in(first < 0 ? any : deeper, lo, cut) ||
         is_negative_in(first < 0 ? deeper : any, cut, hi);
}

// Tells what doubles left open of a collision that was answered when this life began: it may be in
// progress, and is deep where it is so for the rounding before it or after it.
void PairWatch::settle(const Life& life, Walk& walk) const {
  PairState& state = walk.state;
  if (!state.answered) return;
  const Rational t = state.answered->value();
  state.answered.reset();
  if (state.open || sign(form(life, 0).evaluate(0)) != Sign::negative) return;
  OverlapEpisode& episode =
      state.open.emplace(OverlapEpisode{{t, Rational(0)}, false, false, {}, 0, 0});
  episode.answer = t;
  episode.answer_line = state.answered_line;
  // The claim began the lines of those that are not fixed, in this window.
  const auto before = [&](GenId disk, std::size_t index) {
    return index == 0 || billiard_.disks[static_cast<std::size_t>(disk)].fixed ? index : index - 1;
  };
  const GenId a = life.pair.a < 0 ? life.pair.b : life.pair.a;
  const Life last{life.pair,
                  life.path_a,
                  life.path_b,
                  before(a, life.index_a),
                  before(life.pair.b, life.index_b),
                  life.from,
                  life.to};
  episode.deep =
      is_deeper_in(life, rounding(last), 0, 0) || is_deeper_in(life, rounding(life), 0, 0);
}

// Opens and closes the episodes of [from, to) on lines that both keep.
void PairWatch::judge_life(const Life& life, Walk& walk) const {
  PairState& state = walk.state;
  const Rational since = life.since(), length = life.length();
  const Polynomial<Rational> f = form(life, 0);
  const Rational depth = rounding(life);
  Rational begun = 0;  // where the episode in progress began, in this life
  const auto at = [&](const AlgebraicNumber<Rational>& u) { return EntryTime{since, u}; };
  const auto deepen = [&](const Rational& lo, const Rational& hi) {
    if (!state.open->deep) state.open->deep = is_deeper_in(life, depth, lo, hi);
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

// Counts two that touch at the end of the last life and approach. That life may have no length.
void PairWatch::count_left_out(const Life& life, Walk& walk) const {
  const bool ends_all = walk.window.last && &life.to == &walk.window.to;
  if (!ends_all || walk.state.open) return;
  const Rational length = life.length();
  if (!first_fall(form(life, 0), length, length)) return;
  require_mover(walk.pair);
  ++walk.found.left_out;
}

void PairWatch::follow(const BilliardPair& pair, const BilliardPath& a, const BilliardPath& b,
                       std::span<const BilliardClaim> claims, const BilliardWindow& window,
                       const MeetingPairs& meeting, PairState& state,
                       BilliardFindings& found) const {
  constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
  Walk walk{pair, window, meeting, state, found};
  std::size_t ia = 0, ib = 0;
  const BilliardTime* now = &window.from;
  const auto turn_of = [](const BilliardPath& path, std::size_t i) {
    return i + 1 < path.size() ? path[i + 1].claim : never;
  };
  for (;;) {
    const std::int64_t turn_a = pair.a < 0 ? never : turn_of(a, ia), turn_b = turn_of(b, ib);
    const std::int64_t own = claims.empty() ? never : claims.front().number;
    const std::int64_t turn = std::min({turn_a, turn_b, own});
    const BilliardClaim* claim = turn == own && own != never ? &claims.front() : nullptr;
    const BilliardTime& to = turn == never    ? window.to
                             : claim          ? claim->t
                             : turn == turn_a ? a[ia + 1].from
                                              : b[ib + 1].from;
    Life life{pair, pair.a < 0 ? b : a, b, pair.a < 0 ? ib : ia, ib, *now, to};
    live(life, claim, walk);
    if (turn == never) break;
    expire(to, walk);
    if (claim) claims = claims.subspan(1);
    if (turn == turn_a) ++ia;
    if (turn == turn_b) ++ib;
    now = &to;
  }
  expire(window.to, walk);
  if (window.last) finish(walk);
}

// The life of the two up to its end, and the claim there, if there is one.
void PairWatch::live(Life& life, const BilliardClaim* claim, Walk& walk) const {
  PairState& state = walk.state;
  ++walk.found.pair_lives;
  if (filters_ && !claim && state.is_empty() &&
      !walk.meeting.may_meet(life.pair, life.index_a, life.index_b))
    return;
  life.near = near_.form(life.pair, life.a().near, life.b().near, life.from.near, DoubleBall(0));
  const DoubleBall length = life.to.near - life.from.near;
  life.length_up = std::max(0.0, up(length));
  life.length_down = std::max(0.0, down(length));
  const bool plain =
      filters_ && !state.open && state.ended.empty() && (!claim || has_mover(life.pair));
  if (plain && certainly_regular(life, state.answered.has_value(), claim != nullptr)) {
    state.answered.reset();
    if (!claim) return;
    state.answered = claim->t.exact;
    state.answered_line = claim->line;
    return;
  }
  settle(life, walk);
  if (life.from.exact < life.to.exact) judge_life(life, walk);
  count_left_out(life, walk);
  if (claim) judge_claim(life, *claim, walk);
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
