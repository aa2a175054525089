#include "certify/edge_lives.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/blocks.h"
#include "certify/edge_proof.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Effort, by which nothing is decided. The half width of the bracket that is tried around a claimed
// flip time, within the tolerance and relative to that time, or to this part of the horizon where
// that is later: wide beside the errors of doubles, narrow beside the gaps between events.
constexpr double bracket_width = 0x1p-20, least_part = 0x1p-10;

// The half width where double-doubles look: what is proved free of roots then begins further away.
constexpr double wide_bracket = 0x1p-21;

// Ends n lives by `end(k)`. Where one is undecided, another may still refute the history.
template <class End>
void end_each(std::size_t n, End&& end) {
  std::optional<Undecided> first;
  for (std::size_t k = 0; k < n; ++k) {
    try {
      end(k);
    } catch (const Undecided& u) {
      if (!first) first = u;
    }
  }
  if (first) throw *first;
}

}  // namespace

std::optional<Collapse> EdgeLives::first_collapse(const Quad& q, double from, double end) {
  while (from < end) {
    const Collapse c = s_.collapses.after(q, from, end);
    if (c.kind == Collapse::Kind::root) return c;
    if (!(c.lo > from)) {
      throw Undecided("the life of edge " + text_of(canonical(q)) + " is not decided", q);
    }
    from = c.lo;
  }
  return std::nullopt;
}

double EdgeLives::reference_time(double t) const {
  return std::fmax(t, least_part * s_.horizon_down);
}

IsolatedRoot EdgeLives::claimed_root(const Quad& q, double t) const {
  const double pad = std::fmin(bracket_width * reference_time(t), 0.99 * s_.tolerance_up);
  return {Moment::of(q, t - pad, t + pad, nullptr), t - pad, t + pad};
}

std::optional<IsolatedRoot> EdgeLives::bracket(const Quad& q, double from, double t) const {
  IsolatedRoot root = claimed_root(q, t);
  if (from <= root.lo && proved_collapse(s_.motion, q, root.lo, root.hi)) return root;
  // The polynomial is flat there, or an event is near.
  const double wide = wide_bracket * reference_time(t);
  root.lo = std::fmax(from, t - wide);
  root.hi = t + wide;
  const auto dd = newton_collapse(s_.motion, s_.collapses, q, root.lo, root.hi);
  if (!dd) return std::nullopt;
  root.m = Moment::of(q, root.lo, root.hi, nullptr);
  root.m.narrow_to(*dd);
  if (!(root.m.lo >= t - 0.99 * s_.tolerance_up && root.m.hi <= t + 0.99 * s_.tolerance_up)) {
    return std::nullopt;
  }
  return root;
}

// A life begins at m. `own`: m is a root of the edge's own polynomial, isolated so, and the edge
// is what the flip there left. `rootless`: its generators are proved not to be cotangent at m.
inline void EdgeLives::begin_life(int edge, const Moment& m, const IsolatedRoot* own,
                                  bool rootless) {
  lives_[edge] = {.from = own != nullptr ? own->hi : m.lo, .born = front_.instant};
  const bool isolated = own != nullptr && m.fine == nullptr;
  if (!isolated && !rootless) find_beginning(edge, m, own);
}

// Finds the state of the edge at m, where it is not known.
void EdgeLives::find_beginning(int edge, const Moment& m, const IsolatedRoot* own) {
  Life& life = lives_[edge];
  const Quad q = s_.diagram.quad(2 * edge);
  const auto not_cotangent = [&](const auto& at) { return proved_not_cotangent(s_.motion, q, at); };
  if (q.s == q.e || (own == nullptr && not_cotangent(DoubleBall::hull(m.lo, m.hi)))) return;
  ++s_.certificate.tiers.beyond_filter;
  const double soon = std::nextafter(m.hi, infinity);
  const Collapse c = own != nullptr ? s_.collapses.after(q, m.hi, soon, m.fine.get())
                                    : s_.collapses.from(q, s_.chronology.present(m), soon);
  switch (c.kind) {
    case Collapse::Kind::none:
      life.from = std::max(c.lo, m.lo);
      life.tied = own == nullptr && !not_cotangent(s_.chronology.ball(m));
      break;
    case Collapse::Kind::root:
      life.due = true;
      due_[edge] = c;
      break;
    case Collapse::Kind::now:
      life.illegal = true;
      illegal_.push_back(edge);
      s_.chronology.note_flip(q);
      break;
  }
}

// The life ends at m without a flip of the edge; `closed`: a collapse at m itself is missed too.
// Its quadruplet, over the time from its `from` to m.hi, is the k-th of the batch.
inline void EdgeLives::end_life(int edge, const Moment& m, bool closed, std::size_t k) {
  ++s_.certificate.edge_lives;
  Life& life = lives_[edge];
  if (life.pending) return;
  life.clear_end = batch_.rootless(k);
  if (life.illegal || life.due || !life.clear_end) find_end(edge, m, closed, k);
  if (life.tied) require_legal(edge, m);
  life.from = m.lo;  // also where no other life begins, since something is undecided
}

// Checks a search's answer to a tie against the signs at the end of the life, where no tie is left.
// Without this check a wrong answer of the exact tier would be believed for as long as the edge has
// no root again.
void EdgeLives::require_legal(int edge, const Moment& m) const {
  const Life& life = lives_[edge];
  if (life.due || !(life.from < m.lo)) return;  // it collapses, or it ends where it began
  const Quad q = s_.diagram.quad(2 * edge);
  if (proved_illegal(s_.motion, q, to_rational(m.lo))) {
    throw Undecided("the edge " + text_of(canonical(q)) +
                        " is illegal, though it began legal and does not collapse",
                    q);
  }
}

// The same where the edge has to flip, or where the batch does not prove the life free of roots.
void EdgeLives::find_end(int edge, const Moment& m, bool closed, std::size_t k) {
  Life& life = lives_[edge];
  if (life.illegal) {
    if ((life.born == front_.instant && !closed) || left_out(front_.moment)) return;
    throw Refuted{refuter_.missing_flip(s_.diagram.quad(2 * edge), front_.moment)};
  }
  const Quad q = s_.diagram.quad(2 * edge);
  if (!life.due) {
    if (batch_.one_root(k) && proved_free_of_one(s_.motion, q, m.hi, batch_.end_sign(k))) return;
    if (proved_free(s_.motion, q, life.from, m.hi)) return;
    ++s_.certificate.tiers.beyond_filter;
    const auto c = first_collapse(q, life.from, m.hi);
    if (!c) return;
    life.due = true;
    due_[edge] = *c;
  }
  const Collapse& root = due_.at(edge);
  const Moment at = Moment::of(q, root);
  const int order = s_.chronology.compare(at, m);
  if ((order < 0 || (order == 0 && closed)) && !left_out(at))
    throw Refuted{refuter_.missing_flip(q, root)};
}

void EdgeLives::begin(std::span<const int> edges, const Moment& m) {
  batch_.clear();
  for (const int e : edges) {
    if (!lives_[e].clear_end) batch_.add(s_.diagram.quad(2 * e), m.lo, m.hi);
  }
  batch_.prove_instant();
  std::size_t asked = 0;
  for (const int e : edges) {
    const bool rootless = lives_[e].clear_end || batch_.rootless(asked++);
    begin_life(e, m, nullptr, rootless);
  }
}

void EdgeLives::begin_later(std::span<const int> edges, const Moment& m) {
  const double soon = std::nextafter(m.hi, infinity);
  for (const int e : edges) {
    const Quad q = s_.diagram.quad(2 * e);
    const Collapse c = s_.collapses.from(q, s_.chronology.instant(m), soon);
    if (c.kind == Collapse::Kind::now) {
      throw Undecided("an edge flips when a generator is no longer inside another", q);
    }
    lives_[e] = {.from = std::max(c.lo, m.lo),
                 .born = front_.instant,
                 .due = c.kind == Collapse::Kind::root};
    if (lives_[e].due) due_[e] = c;
  }
}

void EdgeLives::end(std::span<const int> edges, const Moment& m, bool closed) {
  batch_.clear();
  for (const int e : edges) batch_.add(s_.diagram.quad(2 * e), lives_[e].from, m.hi);
  batch_.prove();
  end_each(edges.size(), [&](std::size_t k) { end_life(edges[k], m, closed, k); });
}

void EdgeLives::begin_all(const Moment& m) {
  each_block(s_.diagram.edges(), [&](std::span<const int> edges) { begin(edges, m); });
}

void EdgeLives::end_all(const Moment& m, bool closed) {
  each_block(s_.diagram.edges(), [&](std::span<const int> edges) { end(edges, m, closed); });
}

bool EdgeLives::left_out(const Moment& m) {
  if (s_.options.truth == Truth::exact || m.hi < s_.horizon_window_down ||
      s_.chronology.compare(m, Moment::at(s_.horizon_window)) < 0) {
    return false;
  }
  ++s_.certificate.left_out;
  if (!first_left_out_) first_left_out_ = m;
  const bool first =
      turned_since_ ? m.lo < first_left_out_->lo : s_.chronology.compare(m, *first_left_out_) < 0;
  if (first) first_left_out_ = m;
  return true;
}

void EdgeLives::require_none_after_left_out() {
  if (!first_left_out_ || !last_flip_) return;
  const bool later = turned_since_ ? first_left_out_->lo > last_flip_->hi
                                   : s_.chronology.compare(*first_left_out_, *last_flip_) >= 0;
  if (later) return;
  throw Undecided("a flip is claimed after one that is left out at the horizon");
}

EdgeRing::EdgeRing(const Diagram& diagram, Diagram::HalfEdge h) : q(diagram.quad(h)) {
  const Diagram::HalfEdge back = diagram.previous(h), other_back = diagram.previous(h ^ 1);
  for (const Diagram::HalfEdge g :
       {diagram.previous(back), back, diagram.previous(other_back), other_back}) {
    // In small configurations one edge may appear twice.
    const int edge = g / 2;
    if (edge == h / 2 || edge == edges[0] || edge == edges[1] || edge == edges[2]) continue;
    outer[count] = diagram.apex(g ^ 1);
    edges[count++] = edge;
  }
}

void EdgeLives::end_beside(const EdgeRing& ring, const Moment& m) {
  if (ring.count < 4) {
    end(ring.near(), m);
    return;
  }
  const auto& e = ring.edges;
  batch_.prove_around(ring.q, ring.outer,
                      {lives_[e[0]].from, lives_[e[1]].from, lives_[e[2]].from, lives_[e[3]].from},
                      m.lo, m.hi);
  end_each(4, [&](std::size_t k) { end_life(e[k], m, false, k); });
}

void EdgeLives::begin_after_flip(int edge, const EdgeRing& ring, const Moment& m,
                                 const IsolatedRoot* own) {
  begin_life(edge, m, own, false);
  const Quad& q = ring.q;
  if (ring.count < 4) {
    batch_.clear();
    for (const int e : ring.near()) batch_.add(s_.diagram.quad(2 * e), m.lo, m.hi);
    batch_.prove_instant();
  }
  for (int k = 0; k < ring.count; ++k) {
    // An edge of the same four generators has the same root, and is legal beyond it.
    const GenId g = ring.outer[k];
    const bool same = (g == q.l || g == q.r || g == q.s || g == q.e) &&
                      same_generators(s_.diagram.quad(2 * ring.edges[k]), q);
    const bool rootless = ring.count < 4 ? batch_.rootless(k) : batch_.rootless_flipped(k);
    begin_life(ring.edges[k], m, same ? own : nullptr, rootless);
  }
}

// Recorded truth: a disk is in one place before and after it turns, so that what is not cotangent
// before is not so after. Under the exact truth the place after a collision is rounded.
void EdgeLives::postpone(std::span<const int> edges, const Moment& m) {
  turned_since_ = turned_since_ || first_left_out_ || last_flip_;
  const bool continuous = s_.options.truth == Truth::recorded && m.lo == m.hi;
  for (const int e : edges) {
    Life& life = lives_[e];
    if (!life.pending) pending_.push_back(e);
    const bool clear_end = life.clear_end && continuous;
    life = {};
    life.clear_end = clear_end;
    life.from = m.lo;
    life.born = front_.instant;
    life.pending = true;
  }
}

void EdgeLives::require_none_illegal() {
  for (const int e : illegal_) {
    const Life& life = lives_[e];
    if (!life.illegal || life.born != front_.instant || left_out(front_.moment)) continue;
    throw Refuted{refuter_.missing_flip(s_.diagram.quad(2 * e), front_.moment)};
  }
  illegal_.clear();
}

}  // namespace voroproof::internal
