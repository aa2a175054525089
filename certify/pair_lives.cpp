#include "certify/pair_lives.h"

#include <algorithm>
#include <utility>

#include "certify/blocks.h"
#include "exact/patience.h"
#include "filtered/numbers/next_double.h"

namespace voroproof::internal {

namespace {

// The limit of windows on the way to one moment. Only disks that would cross the container some
// thousand times before their next event need more.
constexpr std::size_t most_windows = 1 << 16;

}  // namespace

void PairLives::assign(double t) {
  if (s_.options.judges_flips()) {
    since_.assign(s_.motion.size() == 1 ? 1 : s_.diagram.edges(), t);
  } else {
    near_.assign(t);
  }
}

PairLives::Open PairLives::life_of(int edge) const {
  const auto [i, j] = s_.replay.pair_of(edge);
  return {i, j, since_[edge], edge};
}

bool PairLives::certainly_clear(GenId i, GenId j, double since, const Moment& m, bool apart) const {
  const bool partners = s_.replay.partners(i, j);
  if (s_.exact != nullptr)
    return apart || (!partners && proved_apart(s_.motion, i, j, since, m.hi));
  if (recorded_.contacts().carries({i, j})) return false;
  return partners ? recorded_.certainly_part(i, j, since)
                  : recorded_.certainly_clear(i, j, since, m, apart);
}

void PairLives::end(GenId i, GenId j, double since, int edge, const Moment& m, PairEnd why,
                    bool apart) {
  const bool partners = s_.replay.partners(i, j);
  if (!partners) ++s_.certificate.pair_lives;
  if (certainly_clear(i, j, since, m, apart)) return;
  if (s_.exact == nullptr) {
    if (!partners) ++s_.certificate.tiers.beyond_filter;
    require_no_meeting(i, j, m);
    pass_recorded(i, j, since, edge, Moment(m), why);
    return;
  }
  if (why == PairEnd::turn) s_.exact->note_near(i, j);
  if (partners) return;
  ++s_.certificate.tiers.beyond_filter;
  require_no_meeting(i, j, m);
  s_.exact->require_no_contact(i, j, m, why);
}

// In the life of i and j, which doubles do not prove to be apart, no point of the two meets another
// point: neither the other of the two, nor a neighbour of the other. (Points that graze one disk
// from two sides meet there without ever being neighbours.)
void PairLives::require_no_meeting(GenId i, GenId j, const Moment& m) {
  if (!s_.points.any() || i == container_id) return;
  const auto require = [&](GenId a, GenId b) {
    if (a == b || !s_.points.is_point(a) || !s_.points.is_point(b)) return;
    const auto [first, second] = std::minmax(a, b);
    if (s_.exact != nullptr) {
      s_.exact->require_no_meeting(first, second, m);
    } else {
      recorded_.require_no_meeting(first, second, m);
    }
  };
  require(i, j);
  if (!s_.options.judges_flips()) return;  // all pairs have lives
  for (const GenId g : s_.diagram.neighbours(j)) require(i, g);
  for (const GenId g : s_.diagram.neighbours(i)) require(j, g);
}

void PairLives::end(std::span<const int> edges, const Moment& m, PairEnd why) {
  apart_.clear();
  for (const int e : edges) {
    const auto [i, j] = s_.replay.pair_of(e);
    apart_.add(i, j, since_[e]);
  }
  apart_.prove(m.hi);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto pair = s_.replay.pair_of(edges[k]);
    if (front_.colliding && pair == *front_.colliding) {
      require_no_meeting(pair.first, pair.second, m);
    } else {
      end(pair.first, pair.second, since_[edges[k]], edges[k], m, why, apart_.apart(k));
    }
  }
}

void PairLives::reach(const Moment& m, double settled) {
  if (!near_.assigned()) return;
  std::size_t windows = 0;
  while (const auto g = near_.first_to_end_before(m.hi)) {
    Patience::ask();
    const double begin = near_.begin_of(*g);
    const double now = std::max(begin, std::min(near_.end_of(*g), settled));
    if (now > begin) end_near(near_.around(*g), Moment::at(now), PairEnd::window);
    // A disk so fast that its windows are without number gets one that lasts.
    const bool lasts = now == begin || ++windows > most_windows;
    near_.begin(*g, now, lasts ? m.hi : now);
  }
}

void PairLives::end_around(GenId g, const Moment& m) {
  end_near(near_.around(g), m, PairEnd::turn);
}

void PairLives::end_near(const std::vector<NearPairs::Pair>& pairs, const Moment& m, PairEnd why) {
  apart_.clear();
  for (const NearPairs::Pair& p : pairs) apart_.add(p.i, p.j, p.since);
  apart_.prove(m.hi);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const NearPairs::Pair& p = pairs[k];
    // Another window of the two has begun meanwhile: up to there they are proved.
    if (why == PairEnd::window && p.since >= m.lo) continue;
    if (why == PairEnd::turn && front_.colliding == std::pair(p.i, p.j)) {
      require_no_meeting(p.i, p.j, m);
      continue;
    }
    end(p.i, p.j, p.since, -1, m, why, apart_.apart(k));
  }
}

std::vector<PairLives::Open> PairLives::open(double t) {
  std::vector<Open> lives;
  if (near_.assigned()) {
    near_.extend(t);
    std::vector<RecordedContacts::Pair> carried = recorded_.contacts().carried();
    for (const NearPairs::Pair& p : near_.all()) {
      lives.push_back({p.i, p.j, p.since, -1});
      std::erase(carried, RecordedContacts::Pair{p.i, p.j});
    }
    // Those whose boxes have come apart since they overlapped.
    for (const auto& [i, j] : carried) lives.push_back({i, j, near_.since(i, j), -1});
  }
  for (int e = 0; e < static_cast<int>(since_.size()); ++e) lives.push_back(life_of(e));
  return lives;
}

void PairLives::end_all(const Moment& m, PairEnd why) {
  if (!near_.assigned()) {
    each_block(static_cast<int>(since_.size()),
               [&](std::span<const int> edges) { end(edges, m, why); });
    return;
  }
  reach(m, next_below(m.lo));
  end_near(near_.all(), m, why);
  // Those whose boxes have come apart since they overlapped.
  for (const auto& [i, j] : recorded_.contacts().carried()) {
    end(i, j, near_.since(i, j), -1, m, why, false);
  }
}

void PairLives::check_contact(const CollideEvent& claim, int edge, const BallPair& at) {
  double since = 0;
  if (near_.assigned()) {
    since = near_.since(claim.i, claim.j);
  } else if (front_.begun) {
    since = since_[watching(edge)];
  }
  recorded_.check_contact(claim, since, at);
}

std::string PairLives::standing(const CollideEvent& claim) const {
  const Rational t = exact_time(claim);
  return s_.exact != nullptr ? s_.exact->standing(claim.i, claim.j, t)
                             : recorded_.standing(claim.i, claim.j, t);
}

// Two generators may be neighbours along several V-edges: the one that has been there for longest
// stands for the pair. `besides`: one that counts no more. -1 where there is none.
int PairLives::watching(int edge, int besides) const {
  if (s_.diagram.edges() == 0) return edge;
  const auto pair = s_.replay.pair_of(edge);
  int oldest = -1;
  for (const Diagram::HalfEdge h : s_.diagram.ring(pair.second)) {
    const int e = h / 2;
    if (e != besides && s_.replay.pair_of(e) == pair &&
        (oldest < 0 || std::pair(since_[e], e) < std::pair(since_[oldest], oldest))) {
      oldest = e;
    }
  }
  return oldest;
}

void PairLives::pass_recorded(GenId i, GenId j, double since, int edge, const Moment& m,
                              PairEnd why) {
  if (edge >= 0 && watching(edge) != edge) return;
  if (const int next = why == PairEnd::flip ? watching(edge, edge) : -1; next >= 0) {
    since_[next] = since;  // another edge watches the two, from where this one began
    return;
  }
  const auto lines = recorded_.lines(i, j, since);
  if (lines.gap.slides()) {
    throw Undecided("a disk slides along the container: it has no motion in this model", i, j);
  }
  const bool watched = why == PairEnd::turn || why == PairEnd::window;
  if (const auto missing = recorded_.contacts().pass(lines, end_of(lines.gap, m), watched)) {
    throw Refuted{refuter_.missing_contact(i, j, *missing)};
  }
}

// A rational time at m, or so soon after it that the gap does not change its sign in between.
// (After m, where one of the two may turn, the gap tells nothing of them.)
Rational PairLives::end_of(const Gap& gap, const Moment& m) const {
  if (m.kind == Moment::Kind::rational) return m.rational();
  const Moment narrow = s_.chronology.instant(m);
  const RootInterval about{to_rational(narrow.lo), to_rational(narrow.hi)};
  if (!gap.changes_in(about.lo, about.hi)) return about.hi;
  ExactMotion exact(s_.motion);
  return clear_of(over_tower(gap.polynomial()), narrow.exact(exact), about).hi;
}

}  // namespace voroproof::internal
