#include "kernel/lives.h"

#include <algorithm>
#include <set>

namespace voroproof_kernel {
namespace {

using Shared = std::shared_ptr<Instant>;

// Since when an edge has its quadruplet and its four generators their motion.
struct Birth {
  Shared at;
  bool own = false;  // by its own flip
  bool flip = false;
  Quad four{};  // that flipped then
};

class Lives {
 public:
  Lives(const Problem& p, const Part& part, Counts& counts, std::int64_t& line)
      : p_(p), part_(part), counts_(counts), line_(line), walk_(p) {}

  void run() {
    const auto& claims = p_.history.claims;
    for (std::size_t k = 0; k < part_.first; ++k) walk_.apply(claims[k]);
    line_ = 1;
    if (part_.first == 0) check_initial(walk_);
    latest_ = std::make_shared<Instant>(at(part_.begin));
    births_.assign(edges().size(), {latest_});
    for (std::size_t k = part_.first; k < part_.last; ++k) {
      line_ = claims[k].line;
      if (claims[k].kind == Claim::Kind::flip) {
        flip(claims[k]);
      } else {
        turn(claims[k]);
      }
      check_cells(k + 1 < part_.last ? Rat(claims[k + 1].filed - p_.tolerance) : part_.end);
    }
    const Shared end = std::make_shared<Instant>(at(part_.end));
    const bool last = p_.exact() && part_.last == claims.size();
    line_ = part_.last == claims.size() ? p_.history.last_line : line_;
    for (std::size_t k = 0; k < edges().size(); ++k) close(static_cast<int>(k), end, last);
    check_cells(part_.end);
    counts_.fresh_proofs += four_.fresh_proofs;
  }

 private:
  const std::vector<Quad>& edges() const { return walk_.diagram->edges(); }

  void set(int k) {
    const Quad& q = edges()[k];
    four_.set(q, {&walk_.leg(q.l), &walk_.leg(q.r), &walk_.leg(q.s), &walk_.leg(q.e)});
  }

  static std::string name(const Quad& q) {
    return "[" + std::to_string(q.l) + "," + std::to_string(q.r) + "," + std::to_string(q.s) + "," +
           std::to_string(q.e) + "]";
  }

  // The first collapse of edge k since its birth, before `end`.
  std::optional<Collapse> collapse(int k, const Rat& end) {
    const Birth& birth = births_[k];
    set(k);
    if (birth.at->is_point() || birth.own) return four_.first_collapse(birth.at->hi, end);
    auto found = four_.first_collapse(birth.at->lo, end);
    if (!found || found->at.lo >= birth.at->hi) return found;
    // The birth is a root in a bracket in which this edge has a root or is illegal: either its root
    // is the same, or the bracket can be made so small that it holds none of this edge.
    for (;;) {
      Instant& b = *birth.at;
      if (b.is_point()) return four_.first_collapse(b.lo, end);
      Form form = four_.roots_over(b.lo, b.hi);
      const bool ends = form.front() != 0 && form.back() != 0;
      if (!four_.always() && ends && variations(form) == 0) {
        return four_.first_collapse(b.lo, end);
      }
      bool same = is_zero(form);  // or cotangent throughout
      if (!same && ends && variations(form = squarefree(form)) == 1) {
        form = common(form, restricted(b.form, b.a, b.b, b.lo, b.hi));
        same = variations(form) % 2 == 1;
      }
      if (same || (four_.always() && ends && variations(form) == 0)) {
        found = four_.first_collapse(b.hi, end);
        if (found && found->at.is_point() && found->at.lo == b.hi) found->at = b;
        return found;
      }
      for (int n = 0; n < 8 && !b.is_point(); ++n) b.refine();
    }
  }

  // Recorded truth: a flip within the tolerance of a turn of one of its generators may be claimed
  // on the other side of it, which is not followed here.
  static constexpr const char* kNearTurn = ", within the tolerance of a turn";
  bool near_turn(const Quad& q, const Rat& flip) const {
    if (p_.exact()) return false;
    for (const int g : {q.l, q.r, q.s, q.e}) {
      for (const Leg& leg : p_.legs[g + 1]) {
        if (leg.start > 0 && abs(Rat(leg.start - flip)) <= 2 * p_.tolerance) return true;
      }
    }
    return false;
  }

  // Whether a flip of these four generators is claimed about that time.
  bool is_claimed(const Quad& q, const Rat& flip) const {
    const auto four = [](const Quad& of) { return std::multiset<int>{of.l, of.r, of.s, of.e}; };
    return std::any_of(p_.history.claims.begin(), p_.history.claims.end(), [&](const Claim& c) {
      return c.kind == Claim::Kind::flip && abs(Rat(c.filed - flip)) <= 2 * p_.tolerance &&
             four(c.quad) == four(q);
    });
  }

  // Ends the life of edge k, which does not flip, at an instant; `last`: the horizon under the
  // exact truth, at which a collapse is due.
  void close(int k, const Shared& end, bool last = false) {
    const Birth& birth = births_[k];
    if (birth.at == end) return;
    if (birth.at->hi > end->lo || (birth.at->is_point() && end->is_point())) {
      const int order = compare(*birth.at, *end);
      if (order == 0 && !last) return;
      if (order > 0) {
        const std::string what = "edge " + name(edges()[k]) + " is changed before it is there";
        if (near_turn(edges()[k], birth.at->hi)) undecided(what + kNearTurn);
        refute(what);
      }
    }
    ++counts_.lives;
    auto found = collapse(k, last ? Rat(end->hi + p_.tolerance) : end->hi);
    if (!found || compare(found->at, *end) >= (last ? 1 : 0)) return;
    if (!p_.exact() && compare(found->at, Rat(p_.horizon - p_.tolerance)) >= 0) {
      ++counts_.horizon_events;
      return;
    }
    const std::string what = "edge " + name(edges()[k]) + " collapses at " + about(found->at.lo) +
                             ", and no flip is claimed";
    if (near_turn(edges()[k], found->at.hi) && is_claimed(edges()[k], found->at.hi)) {
      undecided(what + kNearTurn);
    }
    refute(what);
  }

  void flip(const Claim& claim) {
    const int k = walk_.edge_of(claim, nullptr);
    const Quad q = edges()[k];
    const Birth birth = births_[k];
    ++counts_.lives;
    set(k);
    std::optional<Collapse> found;
    const Rat lo = claim.t - p_.tolerance, hi = claim.t + p_.tolerance;
    if (birth.at->is_point() || birth.own)
      found = four_.collapse_near(birth.at->hi, claim.t);
    else
      found = four_.collapse_near(birth.at->lo, claim.t);
    if (found && birth.at->hi >= found->at.lo) found.reset();
    const bool near_it = found.has_value();
    if (!found) {
      found = collapse(k, hi + p_.tolerance);
      if (!found) refute("edge " + name(q) + " does not collapse by then");
      set(k);
      // Both vanish where the rule of the largest id decides.
      const int end = four_.incircle_at(found->after, false);
      if (end > 0 || (end == 0 && four_.incircle_at(found->after, true) != 0)) {
        refute("only one end of edge " + name(q) + " touches its fourth generator");
      }
    }
    const Shared now = std::make_shared<Instant>(found->at);
    if (!near_it && !four_.one_circle(*now)) {
      refute("edge " + name(q) + " leads from one circle to another and stays");
    }
    if (compare(*now, lo) < 0 || compare(*now, hi) > 0) {
      refute("edge " + name(q) + " collapses at " + about(now->lo));
    }
    if (p_.exact() && compare(*now, p_.horizon) > 0) refute("the flip is after the horizon");
    if (compare(*now, Rat(0)) <= 0) refute("the diagram at 0+ is that after all flips at 0");
    note_order(now);
    const std::array<int, 4> near = walk_.diagram->around(k);
    for (const int e : near) close(e, now);
    walk_.diagram->flip(k);
    for (const int e : near) births_[e] = {now, false, true, q};
    births_[k] = {now, true, true, q};
  }

  void turn(const Claim& claim) {
    const Shared now = std::make_shared<Instant>(at(claim.t));
    note_order(now);
    const std::vector<int> disks = turned(claim);
    std::vector<int> all;
    for (const int disk : disks) {
      const std::vector<int> some = walk_.diagram->about(disk);
      all.insert(all.end(), some.begin(), some.end());
      for (const int k : some) {
        const Birth& b = births_[k];
        const bool its =
            b.four.l == disk || b.four.r == disk || b.four.s == disk || b.four.e == disk;
        if (b.flip && its && b.at->hi >= claim.t && compare(*b.at, claim.t) == 0) {
          refute("disk " + std::to_string(disk) + " turns at the instant of a flip before it");
        }
      }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const int k : all) close(k, now);
    walk_.apply(claim);
    for (const int k : all) births_[k] = {now};
  }

  // After generators were so near that circles between them ceased to exist: their cells anew,
  // where there is time before the next claim.
  void check_cells(const Rat& next) {
    if (four_.touched.empty() || next <= latest_->hi) return;
    const Rat t = (latest_->hi + next) / 2;
    for (const int g : four_.touched) check_cell(walk_, g, t);
    four_.touched.clear();
  }

  // Claims may be out of order within the tolerance, as the times of each edge are in order.
  void note_order(const Shared& now) {
    if (now->lo < latest_->hi && compare(*now, *latest_) < 0) {
      if (p_.options.strict) refute("the claim is out of order");
      ++counts_.swaps;
      return;
    }
    latest_ = now;
  }

  const Problem& p_;
  const Part& part_;
  Counts& counts_;
  std::int64_t& line_;
  Walk walk_;
  std::vector<Birth> births_;
  Shared latest_;
  Edge4 four_;
};

}  // namespace

std::vector<Part> parts_of(const Problem& p) {
  constexpr std::size_t least = 2000;  // claims
  const auto& claims = p.history.claims;
  std::vector<Part> parts{{0, claims.size(), 0, p.horizon}};
  for (std::size_t k = 1; k < claims.size(); ++k) {
    if (k - parts.back().first < least) continue;
    if (claims[k].filed - claims[k - 1].filed <= 4 * p.tolerance) continue;
    const Rat cut = (claims[k].filed + claims[k - 1].filed) / 2;
    parts.back().last = k;
    parts.back().end = cut;
    parts.push_back({k, claims.size(), cut, p.horizon});
  }
  return parts;
}

void check_lives(const Problem& p, const Part& part, Counts& counts, std::int64_t& line) {
  Lives(p, part, counts, line).run();
}

}  // namespace voroproof_kernel
