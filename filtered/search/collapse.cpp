#include "filtered/search/collapse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/dual.h"
#include "exact/patience.h"
#include "filtered/numbers/double_roots.h"
#include "filtered/numbers/subdivision.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/branch_search.h"
#include "filtered/search/edge_predicates.h"
#include "filtered/search/flip_polynomial.h"
#include "filtered/search/rough_judge.h"

namespace voroproof::internal {

ExactTime time_of(const Tower& t) {
  if (t.is_rational()) return ExactTime(t.rational());
  // The root of x - t, between binary64 neighbours made distinct.
  const auto [lo, hi] = double_interval(t);
  constexpr double inf = std::numeric_limits<double>::infinity();
  return ExactTime(
      Polynomial<Tower>{-t, Tower(1)},
      RootInterval{to_rational(std::nextafter(lo, -inf)), to_rational(std::nextafter(hi, inf))});
}

std::array<GenId, 3> disk_first(GenId a, GenId b, GenId c) {
  if (a != container_id) return {a, b, c};
  return {b, c, a};
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Effort. None of these decides anything: they say when a tier has done enough, and only the cost
// depends on them.
//
// So much of a window makes an answer of a search in doubles; the rest waits for its turn.
constexpr double kPartWorthAnAnswer = 0.05;
// The same where double-doubles were needed: less, since an event may come before it is hard again.
constexpr double kPartWorthAnAnswerInDd = 0.01;
// Halvings of a window: in double-doubles until it is about as short as they can tell times apart;
// in balls by their bits, and no more than the second.
constexpr int kHalvingsInDd = 48, kHalvingsInBalls = 512;
// Windows beyond an instant are looked at from 1/2^4 of the way to the end of the search down to
// 1/2^60, and are never shorter than 2^-40 altogether.
constexpr int kFirstShortening = 4, kLastShortening = 60;
const Rational kLeastWindow(1, 1L << 40);

Site<double> plain_site(const Motion& motion, GenId g, double t) {
  const DoubleMotion& m = motion.doubles(g);
  const double dt = t - m.t;
  return {m.x + m.vx * dt, m.y + m.vy * dt, m.r};
}

// The answer of a tier that may give up: then it is decided up to `reached` only.
struct Attempt {
  bool decided = false;
  Collapse answer;
  Rational reached;
};

// Searches [start, end]; a root that is not certainly later than `now` is left to the
// exact tier. `max_halvings` bounds the depth.
template <class T, class Make>
Attempt search_in(const Motion& motion, const Quad& q, const Rational& start, const Rational& end,
                  const Instant* now, int max_halvings, const Make& make) {
  const bool cocircular = flip_polynomial_is_cocircularity(motion, q);
  struct Part {
    Rational a, b;
    Coefficients<T> c;
    int depth;
  };
  std::vector<Part> stack;
  stack.push_back({start, end, form_in<T>(motion, q, start, end, cocircular, make), 0});
  const T half = make(Rational(1, 2));
  while (!stack.empty()) {
    Patience::ask();
    Part part = std::move(stack.back());
    stack.pop_back();
    const int roots = count_roots_in(part.c);
    if (roots == 0) continue;
    if (roots == 1) {
      // Narrow until the verdict is known.
      const Sign before = sign(part.c.front());
      for (;;) {
        Patience::ask();
        const T hull = make.hull(part.a, part.b);
        const auto at_hull = sites(motion, q, hull);
        const auto after = [&] { return sites(motion, q, make(part.b)); };
        const Judgement verdict = judge(q, at_hull, after, cotangency_sign(-before, cocircular));
        const bool near_now = now != nullptr && part.a <= to_rational(now->hi);
        if (verdict == Judgement::stays && !near_now) break;
        if (verdict == Judgement::collapses && !near_now &&
            voroproof::internal::round_up(part.b) - voroproof::internal::round_down(part.a) <
                1e-6 * (1 + std::fabs(voroproof::internal::round_down(part.a)))) {
          return {true, Collapse::at_root(part.a, part.b), {}};
        }
        if (++part.depth > max_halvings) return {false, {}, part.a};
        Coefficients<T> left, right;
        halve_in(part.c, half, left, right);
        const Sign middle = sign(right.front());
        const Rational m = (part.a + part.b) / 2;
        if (middle == before) {
          part.a = m;
          part.c = std::move(right);
        } else if (middle == -before) {
          part.b = m;
          part.c = std::move(left);
        } else {
          return {false, {}, part.a};
        }
      }
      continue;
    }
    if (++part.depth > max_halvings) return {false, {}, part.a};
    const Rational m = (part.a + part.b) / 2;
    Part right{m, part.b, {}, part.depth};
    Part left{part.a, m, {}, part.depth};
    halve_in(part.c, half, left.c, right.c);
    stack.push_back(std::move(right));
    stack.push_back(std::move(left));
  }
  return {true, Collapse::none_until(voroproof::internal::round_down(end)), {}};
}

// What becomes of the edge at a root of its form; a collapse in `found`.
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

std::optional<Collapse> CollapseSearch::while_cotangent(const Quad& q, const std::array<Sign, 2>& s,
                                                        const Ball& t) const {
  const bool cotangent = s[0] == Sign::zero && s[1] == Sign::zero;
  const bool in_conflict = s[0] == Sign::negative && s[1] == Sign::negative;
  if (!in_conflict && (!cotangent || legal_while_cotangent(q)))
    return Collapse::none_until(kInfinity);
  if (cotangent) {
    const Sign order = contact_order(q, sites(motion_, q, t));
    if (order == Sign::negative) return Collapse::none_until(kInfinity);
    if (order != Sign::positive) return std::nullopt;
  }
  Collapse illegal;
  illegal.kind = Collapse::Kind::now;
  return illegal;
}

// By the roots of a form whose coefficients are not all of one sign: a collapse, or none up to the
// time to which the form tells, the start if it tells nothing.
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

// The same piece by piece: the error bound of a form grows with a high power of the way that the
// generators go in it, so that long windows hide what short ones show. Pieces are as long as forms
// are of use. Where nobody goes far they would tell no more than the whole.
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

// Of nearly equal radii C tells nothing next to a root of f, a flip at the start say: past that by
// the in-circle functions, then by C again.
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

Collapse CollapseSearch::from(const Quad& q, const Instant& now, double end) {
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

Collapse CollapseSearch::slow(const Quad& q, const Rational& start, const Instant* now,
                              double end) {
  const Rational finish = std::max<Rational>(to_rational(end), start + kLeastWindow);
  Attempt attempt;
  // Generators that look cotangent at the instant mostly are. Nothing but the exact tier can say
  // so, and while their motion is rational it is quick.
  const bool exact_first = motion_.options().filters && now != nullptr && has_rational_motion(q) &&
                           sign(flip_value(motion_, q, now->dd, false)) == Sign::unknown;
  if (motion_.options().filters && !exact_first) {
    attempt = search_in<DdBall>(motion_, q, start, finish, now, kHalvingsInDd, MakeDd{});
    if (!attempt.decided) {
      // What is hard later in the window can wait: an event may come first.
      const double from = now != nullptr ? now->hi : voroproof::internal::round_up(start);
      const double reached = voroproof::internal::round_down(attempt.reached);
      attempt.decided = reached - from > kPartWorthAnAnswerInDd * (end - from);
      attempt.answer = Collapse::none_until(reached);
    }
    if (attempt.decided) {
      counts_.count(Predicate::flip_search, Tier::dd);
      return attempt.answer;
    }
  }
  if (const auto answer = by_symmetry(q, start, now, end)) return *answer;
  std::string budget;
  for (bool tried_exact = false;;) {
    if (tried_exact || !exact_first) {
      const int bits = motion_.goal_bits() + 32;
      attempt = search_in<Ball>(motion_, q, start, finish, now,
                                std::min(bits / 2, kHalvingsInBalls), MakeBall{bits});
      if (attempt.decided) {
        counts_.count(Predicate::flip_search, Tier::ball);
        return attempt.answer;
      }
    }
    if (!tried_exact) {
      tried_exact = true;
      try {
        const Collapse c = exactly(q, start, now, end);
        counts_.count(Predicate::flip_search, Tier::exact);
        return c;
      } catch (const BudgetExceeded& e) {
        budget = e.what();
      } catch (const RootTooBlurred& e) {
        budget = e.what();
      }
    }
    if (!motion_.raise_precision()) {
      throw Undecided("the next flip of an edge is not decided with " +
                          std::to_string(motion_.options().max_bits) + " bits; exactly: " + budget,
                      q);
    }
  }
}

namespace {

// What becomes of an edge whose four generators touch one circle at an instant of the hull, in the
// rest of the hull: the slopes of its in-circle functions tell, if both circles exist and are the
// one that is touched. (The flip polynomial itself may have a double root, where two circles that
// touch three of them touch the fourth.)
Judgement departs(const Motion& motion, const Quad& q, const Ball& hull, bool every_circle) {
  const std::array<Site<Ball>, 4> at = sites(motion, q, hull);
  const EdgeTriples<Ball> circles = EdgeTriples<Ball>::of(q, at);
  const Sign start_exists = circle_exists(circles.start), end_exists = circle_exists(circles.end);
  if (start_exists == Sign::negative || end_exists == Sign::negative) return Judgement::stays;
  if (start_exists != Sign::positive || end_exists != Sign::positive || !keeps_tangencies(at)) {
    return Judgement::unknown;
  }
  if (!every_circle) {
    const Sign a = incircle(circles.start, at[3], q.e == container_id, Sign::zero);
    const Sign b = incircle(circles.end, at[2], q.s == container_id, Sign::zero);
    if (a == Sign::positive || b == Sign::positive) return Judgement::stays;
    if (a != Sign::zero || b != Sign::zero) return Judgement::unknown;
  }
  std::array<Site<Dual<Ball>>, 4> moving;
  const GenId ids[4] = {q.l, q.r, q.s, q.e};
  for (int k = 0; k < 4; ++k) {
    const MovingSite<Ball> m = motion.moving_site(ids[k], hull);
    moving[k] = {{m.x, m.vx}, {m.y, m.vy}, {m.r, Ball()}};
  }
  const EdgeTriples<Dual<Ball>> triples = EdgeTriples<Dual<Ball>>::of(q, moving);
  const Sign a = sign(incircle_value(triples.start, moving[3], q.e == container_id).slope);
  const Sign b = sign(incircle_value(triples.end, moving[2], q.s == container_id).slope);
  if (a == Sign::positive || b == Sign::positive) return Judgement::stays;
  if (a != Sign::negative || b != Sign::negative) return Judgement::unknown;
  const Sign order = contact_order(q, at);
  return order == Sign::negative   ? Judgement::stays
         : order == Sign::positive ? Judgement::collapses
                                   : Judgement::unknown;
}

}  // namespace

// Where the four are cotangent for good, or at the present instant, and symmetry proves it.
std::optional<Collapse> CollapseSearch::by_symmetry(const Quad& q, const Rational& start,
                                                    const Instant* now, double end) {
  if (has_rational_motion(q)) return std::nullopt;
  const Symmetry symmetry(motion_);
  const Rational t = now != nullptr ? to_rational(now->hi) : start;
  const DoubleBall about =
      DoubleBall::hull(voroproof::internal::round_down(t), voroproof::internal::round_up(t));
  if (symmetry.always_cotangent(symmetry.states(q), about)) {
    const auto answer =
        while_cotangent(q, {Sign::zero, Sign::zero}, Ball(t, motion_.goal_bits() + 32));
    if (answer) counts_.count(Predicate::flip_search, Tier::symmetry);
    return answer;
  }
  if (now == nullptr || !now->known) return std::nullopt;
  const auto proved = symmetry.cotangency(symmetry.states(q), now->known(), now->lo, now->hi);
  if (proved == Symmetry::Cotangency::unknown) return std::nullopt;
  const bool every_circle =
      proved == Symmetry::Cotangency::every_circle || flip_polynomial_is_cocircularity(motion_, q);
  const MakeBall make{motion_.goal_bits() + 32};
  // As far beyond the instant as the signs are certain: a search is expensive next to a root.
  const Rational last = std::max<Rational>(to_rational(end) - to_rational(now->hi), kLeastWindow);
  for (int k = kFirstShortening; k <= kLastShortening; k += 4) {
    const Rational beyond = to_rational(now->hi) + last / (Integer(1) << k);
    const Judgement verdict =
        departs(motion_, q, make.hull(to_rational(now->lo), beyond), every_circle);
    if (verdict == Judgement::unknown) continue;
    counts_.count(Predicate::flip_search, Tier::symmetry);
    if (verdict == Judgement::stays) return slow(q, beyond, nullptr, end);
    Collapse answer;
    answer.kind = Collapse::Kind::now;
    return answer;
  }
  return std::nullopt;
}

}  // namespace voroproof::internal
