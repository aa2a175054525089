// The entrance to the search for collapses, and its tier of doubles.
#include "filtered/search/collapse.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>

#include "filtered/numbers/double_roots.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/branch_search.h"
#include "filtered/search/edge_predicates.h"
#include "filtered/search/flip_polynomial.h"
#include "filtered/search/rough_judge.h"

namespace voroproof::internal {

namespace {

Site<double> plain_site(const Motion& motion, GenId g, double t) {
  const DoubleMotion& m = motion.doubles(g);
  const double dt = t - m.t;
  return {m.x + m.vx * dt, m.y + m.vy * dt, m.r};
}

}  // namespace

double time_scale(const Motion& motion, const Quad& q, double t) {
  const Site<double> l = plain_site(motion, q.l, t);
  const DoubleMotion& m = motion.doubles(q.l);
  double size = 0, speed = 0;
  for (const GenId g : {q.r, q.s, q.e}) {
    const Site<double> other = plain_site(motion, g, t);
    const DoubleMotion& n = motion.doubles(g);
    size = std::max(size, std::fabs(other.x - l.x) + std::fabs(other.y - l.y) + std::fabs(other.r) +
                              std::fabs(l.r));
    // Velocities that differ by less than a rounding count as if they differed by one.
    speed = std::max(speed, std::fabs(n.vx - m.vx) + std::fabs(n.vy - m.vy) +
                                unit_roundoff * (std::fabs(n.vx) + std::fabs(n.vy)));
  }
  const int exponent = std::ilogb(std::max(size, DBL_MIN)) - std::ilogb(std::max(speed, DBL_MIN));
  return std::ldexp(1, std::clamp(exponent, -1000, 1000));
}

std::array<GenId, 3> disk_first(GenId a, GenId b, GenId c) {
  if (a != container_id) return {a, b, c};
  return {b, c, a};
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The part of a window that is enough for an answer of a search in doubles; the rest waits for its
// turn. Only the cost depends on this number, and no decision.
constexpr double kPartWorthAnAnswer = 0.05;

// Judges the edge at a root of its form; a collapse goes into `found`.
Judgement judge_root(const Motion& motion, const Quad& q, const BernsteinForm& form,
                     const DoubleRoot& root, Collapse& found) {
  found = {Collapse::Kind::root, root.lo, root.hi, nullptr};
  const Judgement verdict =
      form.degree == 8 ? judge_roughly(motion, q, root.lo, root.hi, root.after)
                       : judge_cocircular(motion, q, root.lo, root.hi, form.spread, root.after);
  if (verdict == Judgement::stays) return verdict;
  if (form.spread == 0) {
    if (verdict == Judgement::collapses) return verdict;
    const auto at_hull = sites(motion, q, DoubleBall::hull(root.lo, root.hi));
    return judge(
        q, at_hull, [&] { return sites(motion, q, DoubleBall(root.hi)); },
        cotangency_sign(root.after, form.degree == 4));
  }
  // C has one root where f has two.
  if (verdict == Judgement::collapses) {
    const std::optional<Collapse> collapse = isolate_on_branch(motion, q, root.lo, root.hi);
    if (collapse) found = *collapse;
    return collapse ? verdict : Judgement::unknown;
  }
  found = search_branches(motion, q, root.lo, root.hi);
  return found.kind == Collapse::Kind::root ? Judgement::collapses
         : found.lo == root.hi              ? Judgement::stays
                                            : Judgement::unknown;
}

// Whether some of the four go further in [start, end] than they are apart at its start, nearly.
bool go_far(const Motion& motion, const Quad& q, double start, double end) {
  const Site<double> l = plain_site(motion, q.l, start);
  const DoubleMotion& m = motion.doubles(q.l);
  for (const GenId g : {q.r, q.s, q.e}) {
    const Site<double> other = plain_site(motion, g, start);
    const DoubleMotion& n = motion.doubles(g);
    const double speed = std::fabs(n.vx - m.vx) + std::fabs(n.vy - m.vy);
    if (speed * (end - start) > std::fabs(other.x - l.x) + std::fabs(other.y - l.y)) return true;
  }
  return false;
}

// Whether so much of [start, end] is decided that the rest can wait for its turn.
bool is_answer(const Collapse& c, double start, double end) {
  return c.kind == Collapse::Kind::root || c.lo == end ||
         c.lo - start > kPartWorthAnAnswer * (end - start);
}

}  // namespace

Collapse Collapse::at_root(const Rational& lo, const Rational& hi) {
  Collapse c;
  c.kind = Collapse::Kind::root;
  c.lo = voroproof::internal::round_down(lo);
  c.hi = voroproof::internal::round_up(hi);
  c.fine = std::make_shared<RootInterval>(RootInterval{lo, hi});
  return c;
}

Collapse Collapse::none_until(double t) {
  Collapse c;
  c.kind = Collapse::Kind::none;
  c.lo = c.hi = t;
  return c;
}

// The collapse by the roots of a form whose coefficients are not all of one sign; or none up to the
// time to which the form tells, which is the start if it tells nothing.
Collapse CollapseSearch::in_doubles(const Quad& q, const BernsteinForm& form, double start,
                                    double end) const {
  std::optional<Collapse> collapse;
  const auto on_root = [&](const DoubleRoot& root) {
    Collapse found;
    const Judgement verdict = judge_root(motion_, q, form, root, found);
    if (verdict == Judgement::collapses) collapse = found;
    return verdict == Judgement::stays;
  };
  double reached = start;
  if (form.degree == 8 && form.bound.first < form.err) {
    if (std::fabs(form.c[0]) > form.bound.first) {
      reached = each_root(form, form.bound, start, end, on_root);
    }
  } else if (std::fabs(form.c[0]) > form.err) {
    reached = each_root(form, start, end, on_root);
  }
  return collapse ? *collapse : Collapse::none_until(reached);
}

// Searches as in_doubles() does, but piece by piece: the error bound of a form grows with a high
// power of the way that the generators go in it, so that long windows hide what short ones show.
// Pieces are as long as forms are of use. Where no generator goes far, pieces would tell no more
// than the whole.
Collapse CollapseSearch::in_pieces(const Quad& q, double start, double end) const {
  if (!go_far(motion_, q, start, end)) return Collapse::none_until(start);
  constexpr int kMaxPieces = 40;
  // The first is short: where it does not help, none does.
  const double shortest = 0x1p-6 * (end - start);
  double from = start, length = shortest, growth = 4;
  for (int pieces = 0; pieces < kMaxPieces && from < end && length >= shortest; ++pieces) {
    const double to = length < end - from ? from + length : end;
    if (!(from < to)) break;
    BernsteinForm form;
    Collapse found = Collapse::none_until(to);
    if (!form_for_collapse(motion_, q, from, to, form)) {
      found = in_doubles(q, form, from, to);
      if (found.kind == Collapse::Kind::root) return found;
    }
    if (found.lo < to) {
      length *= 0.25;
      growth = 1;
    } else {
      length *= growth;
    }
    from = found.lo;
  }
  return Collapse::none_until(from);
}

// For nearly equal radii C tells nothing next to a root of f, a flip at the start say. So the
// beginning is searched by the in-circle functions, the rest by C again.
Collapse CollapseSearch::past_hidden(const Quad& q, double start, double end) const {
  const double past = start + 0x1p-6 * (end - start);
  const Collapse near = search_branches(motion_, q, start, past);
  if (near.lo != past) return near;
  BernsteinForm form;
  return form_for_collapse(motion_, q, past, end, form) ? Collapse::none_until(end)
                                                        : in_doubles(q, form, past, end);
}

// The first tier. Undecided where the filter cannot say what happens just after the start;
// undecided parts further on wait for their turn (`none` up to there).
std::optional<Collapse> CollapseSearch::filter(const Quad& q, const BernsteinForm& form,
                                               double start, double end) const {
  Collapse found = in_doubles(q, form, start, end);
  if (found.kind == Collapse::Kind::root || found.lo == end) return found;
  if (form.spread > 0) found = past_hidden(q, found.lo, end);
  if (found.kind == Collapse::Kind::root || found.lo == end) return found;
  found = in_pieces(q, found.lo, end);
  if (is_answer(found, start, end)) return found;
  found = search_branches(motion_, q, found.lo, end);
  if (is_answer(found, start, end)) return found;
  return std::nullopt;
}

Collapse CollapseSearch::after(const Quad& q, double start, double end, const RootInterval* fine) {
  if (q.s == q.e || at_relative_rest(q)) return Collapse::none_until(kInfinity);  // Lemma 8
  if (fine != nullptr) return beyond(q, *fine, end);
  if (!(start < end)) return Collapse::none_until(end);
  if (!motion_.options().filters) return slow(q, to_rational(start), nullptr, end);
  BernsteinForm form;
  if (form_for_collapse(motion_, q, start, end, form)) {
    counts_.count(Predicate::flip_search, Tier::filter);
    return Collapse::none_until(end);
  }
  if (const std::optional<Collapse> answer = filter(q, form, start, end)) {
    counts_.count(Predicate::flip_search, Tier::filter);
    return *answer;
  }
  return slow(q, to_rational(start), nullptr, end);
}

// The sign of f is expensive next to a root that doubles do not isolate. The in-circle functions
// are not: they rise there for an edge that has just begun.
Collapse CollapseSearch::beyond(const Quad& q, const RootInterval& root, double end) {
  const double start = voroproof::internal::round_down(root.lo);
  if (motion_.options().filters && start < end) {
    const Collapse c = search_branches(motion_, q, start, end);
    const Rational reached = c.fine ? c.fine->lo : to_rational(c.lo);
    if (reached > root.hi && is_answer(c, start, end)) {
      counts_.count(Predicate::flip_search, Tier::filter);
      return c;
    }
  }
  return slow(q, root.hi, nullptr, end);
}

Collapse CollapseSearch::from(const Quad& q, const Moment& now, double end) {
  if (q.s == q.e) return Collapse::none_until(kInfinity);
  if (at_relative_rest(q)) return at_rest(q, now);
  if (now.lo < end && motion_.options().filters) {
    BernsteinForm form;
    std::optional<Collapse> answer;
    if (form_for_collapse(motion_, q, now.lo, end, form)) {
      answer = Collapse::none_until(end);
    } else if (std::fabs(form.c[0]) > form.err) {
      answer = filter(q, form, now.lo, end);
    } else {
      // Not search_branches(): it presumes an edge that is legal just after the start.
      const Collapse found = in_pieces(q, now.lo, end);
      if (is_answer(found, now.lo, end)) answer = found;
    }
    if (answer && answer->lo > now.hi) {
      counts_.count(Predicate::flip_search, Tier::filter);
      return *answer;
    }
  }
  return slow(q, to_rational(now.lo), &now, end);
}

bool CollapseSearch::at_relative_rest(const Quad& q) const {
  return motion_.same_velocity(q.l, q.r) && motion_.same_velocity(q.l, q.s) &&
         motion_.same_velocity(q.l, q.e);
}

bool CollapseSearch::has_rational_motion(const Quad& q) const {
  return motion_.is_rational(q.l) && motion_.is_rational(q.r) && motion_.is_rational(q.s) &&
         motion_.is_rational(q.e);
}

}  // namespace voroproof::internal
