// The lives of edges: each edge of the claimed diagram collapses just where a flip is claimed.
#include <algorithm>

#include "certify/kernel/motion.h"

namespace voroproof_kernel {
namespace {

using Shared = std::shared_ptr<Instant>;

// The time since which an edge has its quadruplet and its four generators their motion.
struct Birth {
  Shared at;
  bool own = false;            // by its own flip
  std::optional<Quad> flip{};  // that was then
  bool fresh = false;          // it ends a hidden moment: a fresh proof is due
};

class Lives {
 public:
  Lives(const Problem& p, const Part& part, Counts& counts, std::int64_t& line)
      : p_(p),
        part_(part),
        claims_(p.history.claims),
        counts_(counts),
        line_(line),
        walk_(p),
        first_open_(part.first) {}

  void run() {
    for (std::size_t k = 0; k < part_.first; ++k) {
      line_ = claims_[k].line;
      walk_.apply(claims_[k]);
    }
    line_ = 1;
    if (part_.first == 0) check_initial(walk_);
    latest_ = std::make_shared<Instant>(at(part_.begin));
    births_.assign(walk_.edges().size(), {latest_});
    taken_.assign(part_.last - part_.first, false);
    for (std::size_t k = part_.first; k < part_.last; ++k) {
      p_.tell("edges", k);
      take(k);
      check_cells(k + 1 < part_.last ? Rat(claims_[k + 1].filed - p_.tolerance) : part_.end);
    }
    const Shared end = std::make_shared<Instant>(at(part_.end));
    const bool last = part_.last == claims_.size();
    if (last) line_ = p_.history.last_line;
    for (int k = 0; k < static_cast<int>(births_.size()); ++k) {
      // Claims of the recorded truth may lie beyond the horizon.
      if (compare(*births_[k].at, *end) > 0) continue;
      if (const auto found = missed(k, end, last && p_.exact())) unclaimed(k, *found);
    }
    if (left_out_ && last_flip_ && compare(*left_out_, *last_flip_) < 0) {
      undecided("a flip is claimed after one that is left out");
    }
    check_cells(part_.end, true);
    counts_.fresh_proofs += notes_.fresh_proofs;
  }

 private:
  bool open(std::size_t k) const {
    return k >= part_.first && k < part_.last && !taken_[k - part_.first];
  }

  void take(std::size_t k) {
    if (!open(k)) return;
    line_ = claims_[k].line;
    taken_[k - part_.first] = true;
    if (claims_[k].kind == Claim::Kind::flip) {
      flip(k);
    } else {
      turn(k);
    }
  }

  // A claim that is earlier in truth than the one at hand, and later in the file.
  void take_before(std::size_t k) {
    const std::int64_t line = line_;
    count_swap();
    take(k);
    line_ = line;
  }

  // Takes an open claim near the one at hand that is before `now` in truth, if there is one: a
  // turn, or a flip that changes one of the edges `ending`, or any; of several the first in truth.
  bool take_earlier(std::size_t claim, const Instant& now, const std::set<int>* ending = nullptr) {
    const Rat most = claims_[claim].filed + 2 * p_.tolerance;
    while (first_open_ < part_.last && !open(first_open_)) ++first_open_;
    std::optional<std::pair<Instant, std::size_t>> first;
    for (std::size_t m = first_open_; m < part_.last && claims_[m].filed <= most; ++m) {
      if (!open(m)) continue;
      Instant end = first ? first->first : now;
      if (claims_[m].kind != Claim::Kind::flip) {
        if (can_turn(m) && compare(end, claims_[m].t) > 0) first = {at(claims_[m].t), m};
      } else {
        const int k = walk_.edge_of(claims_[m]);
        if (k < 0) continue;
        const std::array<int, 4> near = walk_.diagram->around(k);
        const auto ends = [&](int e) { return ending == nullptr || ending->count(e) == 1; };
        if (!ends(k) && std::none_of(near.begin(), near.end(), ends)) continue;
        auto found = collapse(k, end.hi);
        if (found && compare(found->at, end) < 0) first = {found->at, m};
      }
    }
    if (first) take_before(first->second);
    return first.has_value();
  }

  void count_swap() {
    if (p_.options.strict) refute("the claim is out of order");
    ++counts_.swaps;
  }

  // The first collapse of edge k since its birth, before `end`.
  std::optional<Collapse> collapse(int k, const Rat& end) {
    Instant& b = *births_[k].at;
    const Four four = walk_.four(k);
    if (b.is_point() || births_[k].own) {
      return first_collapse(four, b.hi, end, notes_, births_[k].fresh);
    }
    // A bracket that reaches to the end would leave nothing of this life to be looked at.
    if (b.hi >= end && compare(b, end) >= 0) return {};
    while (!b.is_point() && b.hi >= end) b.split((b.lo + b.hi) / 2);
    auto found = first_collapse(four, b.lo, end, notes_);
    // The birth is a root in a bracket in which this edge has a root or is illegal: either its root
    // is the same, or the bracket can be made so small that it holds none of this edge. Nor may it
    // hold one of a tangency, after which q tells nothing; a tangency may have the same root.
    for (int round = 0; found && found->at.lo < b.hi; ++round) {
      if (b.is_point()) return first_collapse(four, b.lo, end, notes_);
      const Form form = four.polynomial(b.lo, b.hi);
      const bool zero = is_zero(form), ends = !zero && form.front() != 0 && form.back() != 0;
      if (ends && variations(form) == 0) return first_collapse(four, b.lo, end, notes_);
      const Form once = ends ? squarefree(form) : Form{};
      const bool same =
          zero || (variations(once) == 1 && variations(common(once, b.form(b.lo, b.hi))) % 2 == 1);
      if (same && (round == 64 || four.apart(b.lo, b.hi))) {
        found = first_collapse(four, b.hi, end, notes_);
        if (found && found->at.is_point() && found->at.lo == b.hi) found->at = b;
        return found;
      }
      for (int n = 0; n < 8 && !b.is_point(); ++n) b.split((b.lo + b.hi) / 2);
    }
    return found;
  }

  // A collapse of edge k between its birth and an instant at which it does not flip; `last`: the
  // horizon under the exact truth, at which a collapse is due.
  std::optional<Collapse> missed(int k, const Shared& end, bool last = false) {
    const Shared& birth = births_[k].at;
    const auto none = [&]() -> std::optional<Collapse> {
      if (births_[k].fresh) undecided("a generator leaves another by two turns of one instant");
      return {};
    };
    if (birth == end) return none();
    if (birth->hi > end->lo || birth->is_point()) {
      const int order = compare(*birth, *end);
      if (order == 0 && !last) return none();
      if (order > 0) undecided("what changes edge " + name(walk_.edges()[k]) + ": the order");
    }
    ++counts_.lives;
    auto found = collapse(k, end->hi);
    // An event after the horizon counts only where the edge is on the verge of it at the horizon.
    if (!found && last && walk_.four(k).incircle(end->hi, true) <= 0) {
      found = collapse(k, end->hi + p_.tolerance);
    }
    if (!found || compare(found->at, *end) >= (last ? 1 : 0)) return {};
    // The diagram at 0 is the one just after: that it is another is no matter of the horizon.
    const bool excused = !p_.exact() && compare(found->at, Rat(0)) != 0 &&
                         compare(found->at, p_.history.horizon - p_.tolerance) >= 0;
    if (!excused) return found;
    ++counts_.horizon_events;
    if (!left_out_ || compare(found->at, *left_out_) < 0) left_out_ = found->at;
    return {};
  }

  // Whether the two disks of a claimed collision, which are both to turn next, have lain one inside
  // the other before that time: then nothing is claimed of them from there up to the collision. Two
  // disks overlap once on their legs, so this is the overlap that the claim answers, and it was
  // entered within the tolerance before. A disk may lie outside the container twice, at both ends
  // of its way across: there this would excuse the way.
  bool hides(const Claim& c, Instant x) const {
    if (p_.exact() || c.first != 0 || compare(x, c.t - p_.tolerance) < 0) return false;
    const Leg &i = walk_.leg(c.id[0]), &j = walk_.leg(c.id[1]);
    const Gap gap(i, j);
    const Rat inside = -4 * i.radius * j.radius;  // the gap where one touches the other from inside
    if (gap.start >= x.lo || x.lo >= c.t) return false;
    const Rat nearest = gap.a > 0 ? Rat(gap.start - gap.b / gap.a) : gap.start;
    return gap.value(std::clamp(nearest, gap.start, x.lo)) < inside;
  }

  // For words.
  static Instant narrowed(Instant at) {
    for (int n = 0; n < 64 && !at.is_point(); ++n) at.split((at.lo + at.hi) / 2);
    return at;
  }

  [[noreturn]] void unclaimed(int k, const Collapse& found) const {
    const Quad q = walk_.edges()[k];
    for (const int g : {q.l, q.r, q.s, q.e}) {
      for (const int h : {q.l, q.r, q.s, q.e}) {
        if (!births_[k].fresh || g >= h) continue;
        const Rat gap = Gap(walk_.leg(g), walk_.leg(h)).value(found.at.lo);
        if (g == container ? gap > 0 : gap < 0) undecided("a generator lies inside another twice");
      }
      const std::size_t next = walk_.leg_of[g + 1] + 1;
      if (next == p_.legs[g + 1].size()) continue;
      const std::size_t claim = p_.legs[g + 1][next].claim;
      if (can_turn(claim) && hides(claims_[claim], found.at)) {
        undecided("edge " + name(q) + " changes while a generator lies inside another");
      }
    }
    const Rat seen = narrowed(found.at).lo;
    refute("edge " + name(q) + " collapses at " + about(seen) + ", and no flip is claimed",
           sight(seen, q));
  }

  void flip(std::size_t claim) {
    const Rat t = claims_[claim].t, lo = t - p_.tolerance, hi = t + p_.tolerance;
    const int k = walk_.edge_of(claims_[claim]);
    if (k < 0) refute("wrong quadruple: the diagram has no such edge");
    const Quad q = walk_.edges()[k];
    const Birth& birth = births_[k];
    ++counts_.lives;
    const bool past = birth.at->is_point() || birth.own;
    std::optional<Collapse> found;
    if (!birth.fresh) found = collapse_near(walk_.four(k), past ? birth.at->hi : birth.at->lo, t);
    if (found && birth.at->hi >= found->at.lo) found.reset();
    const bool simple = found.has_value();
    if (!found) found = collapse(k, hi + p_.tolerance);
    if (!found) {
      // Unless one of the four turns before.
      std::optional<std::pair<Rat, std::size_t>> first;
      for (const int g : {q.l, q.r, q.s, q.e}) {
        const std::size_t next = walk_.leg_of[g + 1] + 1;
        if (next == p_.legs[g + 1].size()) continue;
        const Leg& leg = p_.legs[g + 1][next];
        if (!open(leg.claim) || leg.start > hi) continue;
        const std::size_t due = next_turn(leg.claim);
        if (!open(due)) continue;  // it waits for this flip
        const std::pair turn(claims_[due].t, due);
        if (!first || turn < *first) first = turn;
      }
      if (first) {
        take_before(first->second);
        return flip(claim);
      }
      refute("edge " + name(q) + " does not collapse by then");
    }
    const std::array<int, 4> near = walk_.diagram->around(k);
    const std::set<int> ending(near.begin(), near.end());
    if (take_earlier(claim, found->at, &ending)) return flip(claim);
    const Four four = walk_.four(k);
    // Both vanish where the rule of the largest id decides.
    const int end = simple ? -1 : four.incircle(found->after, false);
    if (end > 0 || (end == 0 && four.incircle(found->after, true) != 0)) {
      refute("only one end of edge " + name(q) + " touches its fourth generator");
    }
    const Shared now = std::make_shared<Instant>(found->at);
    if (!simple && !one_circle(four, *now)) {
      refute("edge " + name(q) + " leads from one circle to another and stays");
    }
    if (compare(*now, lo) < 0 || compare(*now, hi) > 0) {
      refute("edge " + name(q) + " collapses at " + about(narrowed(*now).lo));
    }
    if (p_.exact() && compare(*now, p_.history.horizon) > 0) refute("it is after the horizon");
    if (compare(*now, Rat(0)) <= 0) refute("the diagram at 0+ is that after all flips at 0");
    for (const int e : near) {
      const auto missing = missed(e, now);
      if (!missing) continue;
      // The flip that it waits for may wait for others further away.
      if (take_earlier(claim, *now)) return flip(claim);
      unclaimed(e, *missing);
    }
    note_order(now);
    if (!last_flip_ || compare(*now, *last_flip_) > 0) last_flip_ = now;
    walk_.diagram->flip(k);
    for (const int e : near) births_[e] = {now, false, q};
    births_[k] = {now, true, q};
  }

  // The turn that has to come first for this one to be next of all its disks: itself, or another.
  std::size_t next_turn(std::size_t claim) const {
    const Claim& c = claims_[claim];
    for (int k = c.first; k < 2; ++k) {
      const std::size_t next = p_.legs[c.id[k] + 1][walk_.leg_of[c.id[k] + 1] + 1].claim;
      if (next != claim) return next_turn(next);
    }
    return claim;
  }
  bool can_turn(std::size_t claim) const { return next_turn(claim) == claim; }

  // Whether both that collide are among the four of edge k.
  bool joins(int k, const Claim& c) const {
    const Quad q = walk_.edges()[k];
    const auto has = [&](int g) { return q.l == g || q.r == g || q.s == g || q.e == g; };
    return has(c.id[0]) && has(c.id[1]);
  }

  // The edges that have a turning disk among their four.
  std::set<int> edges_about(const Claim& c) const {
    std::set<int> all;
    for (int side = c.first; side < 2; ++side) {
      for (const int k : walk_.diagram->spokes(c.id[side])) {
        const std::array<int, 4> near = walk_.diagram->around(k);
        all.insert(near.begin(), near.end());
        all.insert(k);
      }
    }
    return all;
  }

  void turn(std::size_t claim) {
    const Claim& c = claims_[claim];
    if (!can_turn(claim)) refute("two turns of one disk are out of order");
    const Shared now = std::make_shared<Instant>(at(c.t));
    const std::set<int> all = edges_about(c);
    if (take_earlier(claim, *now, &all)) return turn(claim);
    std::set<int> fresh;
    for (const int k : all) {
      const auto found = missed(k, now);
      if (!found) continue;
      if (take_earlier(claim, *now)) return turn(claim);  // as in flip()
      if (!hides(c, found->at) || !joins(k, c)) unclaimed(k, *found);
      fresh.insert(k);
    }
    note_order(now);
    for (const int k : all) {
      const Birth& b = births_[k];
      if (!b.flip || b.at->hi < c.t || compare(*b.at, c.t) != 0) continue;
      const Quad q = *b.flip;
      for (const int g : {q.l, q.r, q.s, q.e}) {
        if (g == c.id[1] || (c.first == 0 && g == c.id[0])) {
          refute("disk " + std::to_string(g) + " turns at the instant of a flip before it");
        }
      }
    }
    walk_.apply(c);
    for (const int k : all) births_[k] = {now, false, {}, fresh.count(k) == 1};
  }

  // Checks anew the cells of generators that were so near that circles between them ceased to
  // exist, where there is time before the next claim and they exist again.
  void check_cells(const Rat& next, bool last = false) {
    if (notes_.touched.empty() || next <= latest_->hi) return;
    const Rat t = (latest_->hi + next) / 2;
    // Where events may be left out at the horizon no diagram is claimed.
    if (!p_.exact() && t >= p_.history.horizon - p_.tolerance) return;
    std::erase_if(notes_.touched, [&](int g) { return check_cell(walk_, g, t); });
    if (last && !notes_.touched.empty()) undecided("a generator lies inside another for long");
  }

  // Claims may be out of order within the tolerance, as the times of each edge are in order.
  void note_order(const Shared& now) {
    if (now->lo < latest_->hi && compare(*now, *latest_) < 0) {
      count_swap();
    } else {
      latest_ = now;
    }
  }

  const Problem& p_;
  const Part& part_;
  const std::vector<Claim>& claims_;
  Counts& counts_;
  std::int64_t& line_;
  Walk walk_;
  std::vector<Birth> births_;
  std::vector<bool> taken_;
  std::size_t first_open_;  // no claim of the part before it is open
  Shared latest_, last_flip_;
  std::optional<Instant> left_out_;  // the first collapse that the horizon leaves out
  Notes notes_;
};

}  // namespace

std::vector<Part> parts_of(const Problem& p) {
  constexpr std::size_t least = 2000;  // claims
  const auto& claims = p.history.claims;
  std::vector<Part> parts{{0, claims.size(), 0, p.history.horizon}};
  for (std::size_t k = 1; k < claims.size(); ++k) {
    if (k - parts.back().first < least) continue;
    if (claims[k].filed - claims[k - 1].filed <= 4 * p.tolerance) continue;
    const Rat cut = (claims[k].filed + claims[k - 1].filed) / 2;
    parts.back().last = k;
    parts.back().end = cut;
    parts.push_back({k, claims.size(), cut, p.history.horizon});
  }
  return parts;
}

void check_lives(const Problem& p, const Part& part, Counts& counts, std::int64_t& line) {
  Lives(p, part, counts, line).run();
}

}  // namespace voroproof_kernel
