// Contacts: every overlap of the paths is answered by a collision, and every collision answers one.
//
// k(s) = |d(s)|^2 - reach^2 of two is convex on lines. Two disks overlap where k < 0, between its
// roots; a disk leaves the container where k > 0, before the smaller and after the larger root.
#include <algorithm>
#include <map>

#include "certify/kernel/turns.h"

namespace voroproof_kernel {
namespace {

// An instant: a root of a gap, the smaller (-1) or the larger (1), or the gap's start (0).
struct When {
  Gap gap;
  int which;
  explicit When(const Rat& t) : gap(t), which(0) {}
  When(const Gap& of, int root) : gap(of), which(root) {}
  // The sign of this - t. Between its roots a gap is negative.
  int against(const Rat& t) const {
    if (which == 0) return gap.start < t ? -1 : gap.start > t;
    const int value = sgn(gap.value(t)), slope = sgn(gap.slope(t));
    if (value < 0) return which;
    return slope == which && value == 0 ? 0 : -slope;
  }
};

struct Overlap {
  When from;
  Rat extreme;                // least (wall: greatest) square of the distance so far
  std::optional<Rat> answer;  // the time of the collision claimed for it
};

class Contacts {
 public:
  Contacts(const Problem& p, Counts& counts, std::int64_t& line)
      : p_(p), counts_(counts), line_(line), walk_(p), turns_(p.disks()), by_(p.disks(), -1) {
    if (!p.exact()) slack_ = p.tolerance;  // exact times have none
  }

  void run() {
    std::int64_t number = 0;
    for (const Claim& c : p_.history.claims) {
      line_ = c.line;
      p_.tell("contacts", number++);
      const bool collision = c.kind == Claim::Kind::collision;
      if (c.kind == Claim::Kind::flip) flip(c);
      if (p_.exact() && c.first < 2) {
        // The file's times are within the tolerance of the true ones.
        require_order_until(c.t - 4 * p_.tolerance);
        order_[c.t].begin(c, pairs_of(c), walk_);
      }
      if (collision) judge(c);
      for (int k = c.first; k < 2; ++k) end_pairs(c.id[k], c.t, collision ? &c : nullptr);
      for (int k = c.first; k < 2; ++k) {
        ++turns_[c.id[k]];
        by_[c.id[k]] = collision ? number : -1;
      }
      if (c.first < 2) turn(c);
    }
    while (!order_.empty()) require_order_of_first();
    line_ = p_.history.last_line;
    at_end_ = true;
    const Rat end = p_.history.horizon;
    for (int j = 0; j < p_.disks(); ++j) end_pairs(j, end, nullptr);
    for (const auto& [two, overlap] : open_) close(two, overlap, When(end));
  }

 private:
  static std::string name(Two two) {
    return "generators " + std::to_string(two.first) + " and " + std::to_string(two.second);
  }
  Rat reach(Two two) const { return p_.reach(two.first, two.second); }
  Gap gap(Two two) const { return {walk_.leg(two.first), walk_.leg(two.second)}; }

  // Bounds how far roundings of the numbers on the lines so far can have moved the two.
  Rat delta(Two two) const {
    const Rat extent = abs(p_.scene.center[0]) + abs(p_.scene.center[1]) + p_.scene.radius;
    const std::int64_t n = turns_[two.second] + (two.first == container ? 0 : turns_[two.first]);
    return extent * power(2, -51) * std::max<std::int64_t>(1, n);
  }
  bool shallow(Two two, const Rat& extreme) const {
    const Rat r = reach(two), d = delta(two);
    if (p_.exact() || 4 * d > r) return false;
    return inwards(two) > 0 ? extreme <= square(r + d) : extreme >= square(r - d);
  }
  bool near(const When& x, const Rat& t) const {
    return x.against(t - slack_) >= 0 && x.against(t + slack_) <= 0;
  }

  // An overlap is over: rounding, answered in time, or the horizon's.
  void close(Two two, const Overlap& o, const When& end) {
    if (shallow(two, o.extreme)) {
      ++counts_.rounding_overlaps;
    } else if (o.answer && near(o.from, *o.answer) && near(end, *o.answer)) {
    } else if (!p_.exact() && o.from.against(p_.history.horizon - slack_) >= 0) {
      ++counts_.horizon_events;
    } else {
      const Rat turn = walk_.leg(two.second).start, by = turn > 0 ? turn : p_.history.horizon;
      refute("overlap: " + name(two) + " overlap before " + about(by) +
                 " and no collision in time answers it",
             sight(by, {two.first, two.second}));
    }
  }

  void turn(const Claim& c) {
    walk_.apply(c);
    if (p_.exact()) order_[c.t].end(c, walk_);
  }
  // Judges the order at the instants before t, all of whose claims have been read.
  void require_order_until(const Rat& t) {
    while (!order_.empty() && order_.begin()->first < t) require_order_of_first();
  }
  void require_order_of_first() {
    const auto& [t, turns] = *order_.begin();
    if (const auto fault = turns.fault(t)) {
      line_ = fault->line;
      refute(fault->why);
    }
    order_.erase(order_.begin());
  }

  void flip(const Claim& c) {
    bool mirrored = false;
    const int k = walk_.edge_of(c, &mirrored);
    if (k < 0) refute("wrong quadruple: the diagram has no such edge");
    const Two two = std::minmax(walk_.edges()[k].l, walk_.edges()[k].r);
    ++counts_.flips;
    counts_.unoriented += mirrored;
    walk_.apply(c);
    if (walk_.diagram->adjacent(two.first, two.second)) return;
    require_no_meeting(two, c.t + slack_);
    end_lines(two, c.t, nullptr);
    followed_[two] = c.t;
    const auto open = open_.find(two);
    if (open == open_.end()) return;
    close(two, open->second, When(c.t));
    open_.erase(open);
  }

  // Whether the claimed collision answers an entry of the paths; how is kept for end_pairs.
  void judge(const Claim& c) {
    const Two two(c.id[0], c.id[1]);
    if (walk_.diagram && !walk_.diagram->adjacent(c.id[0], c.id[1])) {
      refute(name(two) + " are not adjacent");
    }
    if (c.first == 0 && by_[c.id[0]] >= 0 && by_[c.id[0]] == by_[c.id[1]]) {
      refute(name(two) + " have just collided and part since");
    }
    require_no_meeting(two, c.t);
    const Gap g = gap(two);
    const When entry(g, inwards(two));
    const bool enters = g.has_roots() && entry.against(g.start) >= 0;
    continues_ = false;
    if (enters && near(entry, c.t)) return;
    const auto open = open_.find(two);
    if (open != open_.end() && sgn(g.value(c.t)) == inwards(two) &&
        sgn(g.slope(c.t)) == inwards(two) &&
        (open->second.from.against(c.t - slack_) >= 0 ||
         (g.start >= c.t - slack_ && shallow(two, open->second.extreme)))) {
      continues_ = true;
      return;
    }
    if (!p_.exact() && c.first == 0 && !enters && g.a > 0) {
      const Rat s = g.start - g.b / g.a, least = g.value(s) + square(reach(two));
      if (s >= g.start && abs(s - c.t) <= slack_ && g.value(s) >= 0 &&
          least <= square(reach(two) + delta(two))) {
        ++counts_.grazes;
        return;
      }
    }
    refute(name(two) + " do not come into contact then");
  }

  std::set<Two> pairs(int disk) const {
    if (!walk_.diagram) return {{container, disk}};
    std::set<Two> all;
    for (const int k : walk_.diagram->spokes(disk)) {
      all.insert(std::minmax(walk_.edges()[k].l, walk_.edges()[k].r));
    }
    return all;
  }

  std::set<Two> pairs_of(const Claim& c) const {
    std::set<Two> all;
    for (int k = c.first; k < 2; ++k) all.merge(pairs(c.id[k]));
    return all;
  }

  // Ends the present lines of all pairs of a disk. `claim`: of these, the one that collides.
  void end_pairs(int disk, const Rat& t, const Claim* claim) {
    for (const Two& two : pairs(disk)) {
      const bool own = claim != nullptr && Two(claim->id[0], claim->id[1]) == two;
      // Each pair is looked at once: its larger disk does it.
      if ((own || at_end_) && disk == two.first) continue;
      require_no_meeting(two, t);
      end_lines(two, t, own ? claim : nullptr);
    }
  }

  // Two points that meet have no law, and change places at a disk by no flip. Before that both are
  // neighbours of that disk, or of each other and so of a third (certificate.md, Lemma 6.8).
  void require_no_meeting(Two two, const Rat& t) const {
    const auto require = [&](int i, int j) {
      if (i == j || p_.radius(j) != 0) return;
      if (!gap({i, j}).meet(t)) return;
      const std::string why = "points " + std::to_string(i) + " and " + std::to_string(j) + " meet";
      throw Stop{Verdict::undecided, why, 0, true, sight(t, {i, j})};
    };
    for (const auto& [i, k] : {two, Two(two.second, two.first)}) {
      if (p_.radius(i) != 0) continue;
      for (const auto& [a, b] : pairs(k)) require(i, a == k ? b : a);
    }
  }

  // Follows the overlaps of two along their present lines up to t.
  void end_lines(Two two, const Rat& t, const Claim* claim) {
    ++counts_.pair_lives;
    const Gap g = gap(two);
    // Only the exact truth has other times than the file.
    if (t < g.start) undecided(name(two) + " turn in another order than the file has");
    const auto followed = followed_.find(two);
    const Rat start = followed == followed_.end() ? g.start : std::max(g.start, followed->second);
    const When before(start - 1), after(t + 1), lower(g, -1), upper(g, 1);
    std::vector<std::array<When, 2>> overlaps;  // on the whole lines
    if (!g.has_roots()) {
      if (inwards(two) > 0 ? g.c > 0 : g.c < 0 && g.a == 0) overlaps = {{before, after}};
    } else if (inwards(two) > 0) {
      overlaps = {{before, lower}, {upper, after}};
    } else {
      overlaps = {{lower, upper}};
    }
    std::optional<Overlap> last;
    if (const auto open = open_.extract(two)) last = open.mapped();
    for (const auto& [x, y] : overlaps) {
      const bool old = x.against(start) < 0;
      // Under the exact truth an entry at the horizon is due.
      const int late = x.against(t);
      if (y.against(start) <= 0 || late > 0 || (late == 0 && !(p_.exact() && at_end_))) continue;
      Overlap o = old && last ? *last : Overlap{old ? When(start) : x, square(reach(two)), {}};
      if (old) last.reset();
      for (const Rat& s : {start, t, g.a > 0 ? Rat(g.start - g.b / g.a) : t}) {
        const Rat k = g.value(s), d2 = k + square(reach(two));
        if (s < start || s > t || sgn(k) != inwards(two)) continue;
        if (x.against(s) > 0 || y.against(s) < 0) continue;
        if (inwards(two) > 0 ? d2 > o.extreme : d2 < o.extreme) o.extreme = d2;
      }
      if (claim != nullptr && old == continues_) o.answer = claim->t;
      if (y.against(t) <= 0) {
        close(two, o, y);
      } else {
        open_.emplace(two, o);
      }
    }
    if (last) close(two, *last, When(start));
  }

  const Problem& p_;
  Rat slack_ = 0;
  Counts& counts_;
  std::int64_t& line_;
  Walk walk_;
  std::vector<std::int64_t> turns_;  // claims so far that moved a disk
  std::vector<std::int64_t> by_;     // the collision that turned it last, or -1
  std::map<Rat, Turns> order_;       // instants that other claims may belong to
  std::map<Two, Overlap> open_;
  std::map<Two, Rat> followed_;  // to where the lines of some that are no neighbours were
  bool at_end_ = false;
  bool continues_ = false;  // the claim answers an overlap begun on earlier lines
};

}  // namespace

void check_contacts(const Problem& p, Counts& counts, std::int64_t& line) {
  Contacts(p, counts, line).run();
}

}  // namespace voroproof_kernel
