// Contacts: every overlap of the paths is answered by a collision, and every collision answers one.
//
// k(s) = |d(s)|^2 - reach^2 of two is convex on lines. Two disks overlap where k < 0, between its
// roots; a disk leaves the container where k > 0, before the smaller and after the larger root.
#include <algorithm>
#include <map>
#include <set>

#include "kernel/motion.h"

namespace voroproof_kernel {
namespace {

// An instant: a root of a gap, the smaller (-1) or the larger (1), or the gap's start (0).
struct When {
  Gap gap;
  int which;
  // The sign of this - t. Between its roots a gap is negative.
  int against(const Rat& t) const {
    if (which == 0) return gap.start < t ? -1 : gap.start > t;
    const int value = sgn(gap.value(t)), slope = sgn(gap.slope(t));
    if (value < 0) return which;
    return slope == which && value == 0 ? 0 : -slope;
  }
};
When exact(const Rat& t) { return {Gap(t), 0}; }

struct Overlap {
  When from;
  Rat extreme;                // least (wall: greatest) square of the distance so far
  std::optional<Rat> answer;  // the time of the collision claimed for it
};

class Contacts {
 public:
  Contacts(const Problem& p, Counts& counts, std::int64_t& line)
      : p_(p),
        slack_(p.exact() ? Rat(0) : p.tolerance),
        counts_(counts),
        line_(line),
        walk_(p),
        lines_(p.disks()),
        turned_by_(p.disks(), -1) {}

  void run() {
    std::int64_t number = 0;
    for (const Claim& c : p_.history.claims) {
      line_ = c.line;
      if (c.kind == Claim::Kind::flip) {
        const Quad q = walk_.diagram->edges()[walk_.edge_of(c, &counts_.unoriented)];
        ++counts_.flips;
        walk_.apply(c);
        if (!walk_.diagram->adjacent(std::min(q.l, q.r), std::max(q.l, q.r))) part(q.l, q.r, c.t);
        continue;
      }
      const bool collision = c.kind == Claim::Kind::collision;
      if (p_.exact()) require_first(c);
      if (collision) judge(c);
      for (const int disk : turned(c)) end_pairs(disk, c.t, collision ? &c : nullptr);
      for (const int disk : turned(c)) {
        ++lines_[disk];
        turned_by_[disk] = collision ? number : -1;
      }
      walk_.apply(c);
      ++number;
    }
    line_ = p_.history.last_line;
    at_end_ = true;
    for (int j = 0; j < p_.disks(); ++j) end_pairs(j, p_.horizon, nullptr, true);
    for (const auto& [pair, overlap] : open_)
      close(pair.first, pair.second, overlap, exact(p_.horizon));
  }

 private:
  using Two = std::pair<int, int>;

  Rat reach(int i, int j) const { return abs(Rat(p_.radius(i) + p_.radius(j))); }

  Gap gap(int i, int j) const { return {walk_.leg(i), walk_.leg(j)}; }

  // What the rounding of the numbers of the lines so far can have moved i and j by.
  Rat delta(int i, int j) const {
    const Vec& o = p_.scene.center;
    const Rat extent = abs(o[0]) + abs(o[1]) + p_.scene.radius;
    const std::int64_t n = lines_[j] + (i == container ? 0 : lines_[i]);
    return extent * power_of_two(-51) * std::max<std::int64_t>(1, n);
  }

  bool shallow(int i, int j, const Rat& extreme) const {
    const Rat r = reach(i, j), d = delta(i, j);
    if (p_.exact() || 4 * d > r) return false;
    return i == container ? extreme <= square(Rat(r + d)) : extreme >= square(Rat(r - d));
  }
  bool near(const When& x, const Rat& t) const {
    return x.against(Rat(t - slack_)) >= 0 && x.against(Rat(t + slack_)) <= 0;
  }

  // An overlap is over: rounding, answered in time, or the horizon's.
  void close(int i, int j, const Overlap& o, const When& end) {
    if (shallow(i, j, o.extreme)) {
      ++counts_.rounding_overlaps;
    } else if (o.answer && near(o.from, *o.answer) && near(end, *o.answer)) {
    } else if (!p_.exact() && o.from.against(Rat(p_.horizon - slack_)) >= 0) {
      ++counts_.horizon_events;
    } else {
      refute("overlap: generators " + std::to_string(i) + " and " + std::to_string(j) +
             " overlap before " + about(walk_.leg(j).start > 0 ? walk_.leg(j).start : p_.horizon) +
             " and no collision in time answers it");
    }
  }

  // Exact: no smaller pair of these disks, before a maneuver no pair, touches and approaches now.
  void require_first(const Claim& c) {
    for (const int disk : turned(c)) {
      for (const int other : neighbours(disk)) {
        const int i = std::min(disk, other), j = std::max(disk, other), out = i < 0 ? 1 : -1;
        if (c.kind == Claim::Kind::collision && std::pair(i, j) >= std::pair(c.i, c.j)) continue;
        const Gap g = gap(i, j);
        if (g.start <= c.t && g.value(c.t) == 0 && sgn(g.slope(c.t)) == out) {
          refute("generators " + std::to_string(i) + " and " + std::to_string(j) +
                 " collide before that at the same instant");
        }
      }
    }
  }

  // Whether the claimed collision answers an entry of the paths; how is kept for end_pairs.
  void judge(const Claim& c) {
    const int i = c.i, j = c.j;
    const std::string two = "generators " + std::to_string(i) + " and " + std::to_string(j);
    if (walk_.diagram && !walk_.diagram->adjacent(i, j)) refute(two + " are not adjacent");
    if (i != container && turned_by_[i] >= 0 && turned_by_[i] == turned_by_[j]) {
      refute(two + " have just collided and part since");
    }
    const Gap g = gap(i, j);
    const bool wall = i == container;
    const int out = wall ? 1 : -1;  // the sign of k where they overlap
    continues_ = false;
    const When entry{g, wall ? 1 : -1};
    const bool enters = g.has_roots() && entry.against(g.start) >= 0;
    if (enters && near(entry, c.t)) return;
    const auto open = open_.find({i, j});
    if (open != open_.end() && sgn(g.value(c.t)) == out && sgn(g.slope(c.t)) == out &&
        (open->second.from.against(Rat(c.t - slack_)) >= 0 ||
         (g.start >= c.t - slack_ && shallow(i, j, open->second.extreme)))) {
      continues_ = true;
      return;
    }
    if (!p_.exact() && !wall && !enters && g.a > 0) {
      const Rat s = g.start - g.b / g.a, least = g.value(s) + square(reach(i, j));
      if (s >= g.start && abs(Rat(s - c.t)) <= slack_ && g.value(s) >= 0 &&
          least <= square(Rat(reach(i, j) + delta(i, j)))) {
        ++counts_.grazes;
        return;
      }
    }
    refute(two + " do not come into contact then");
  }

  std::set<int> neighbours(int disk) const {
    if (!walk_.diagram) return {container};
    std::set<int> all;
    for (const int k : walk_.diagram->spokes(disk)) {
      const Quad& q = walk_.diagram->edges()[k];
      all.insert(q.l == disk ? q.r : q.l);
    }
    return all;
  }

  // Ends the present lines of all pairs of a disk. `claim`: of these, the one that collides.
  void end_pairs(int disk, const Rat& t, const Claim* claim, bool once = false) {
    for (const int other : neighbours(disk)) {
      if (once && other > disk) continue;
      const int i = std::min(disk, other), j = std::max(disk, other);
      const bool own = claim != nullptr && claim->i == i && claim->j == j;
      if (own && disk == i) continue;  // its other disk does it
      end_lines(i, j, t, own ? claim : nullptr);
    }
  }

  // The two are neighbours no more.
  void part(int a, int b, const Rat& t) {
    const int i = std::min(a, b), j = std::max(a, b);
    end_lines(i, j, t, nullptr);
    followed_[{i, j}] = t;
    const auto open = open_.find({i, j});
    if (open == open_.end()) return;
    close(i, j, open->second, exact(t));
    open_.erase(open);
  }

  // Follows the overlaps of i and j along their present lines up to t.
  void end_lines(int i, int j, const Rat& t, const Claim* claim) {
    ++counts_.pair_lives;
    const Gap g = gap(i, j);
    const bool wall = i == container;
    Rat start = g.start;  // or when they were last looked at
    if (t < start) refute("a disk turns before it did last");
    const auto followed = followed_.find({i, j});
    if (followed != followed_.end() && followed->second > start) start = followed->second;
    const auto open = open_.find({i, j});
    std::vector<std::pair<When, When>> intervals;  // of overlap, on the whole lines
    const When before = exact(Rat(start - 1)), after = exact(Rat(t + 1));
    if (g.has_roots()) {
      if (wall) {
        intervals = {{before, {g, -1}}, {{g, 1}, after}};
      } else {
        intervals = {{{g, -1}, {g, 1}}};
      }
    } else if (wall ? g.c > 0 : g.c < 0 && g.a == 0) {
      intervals = {{before, after}};
    }
    std::optional<Overlap> last;
    if (open != open_.end()) {
      last = open->second;
      open_.erase(open);
    }
    for (auto& [x, y] : intervals) {
      const bool old = x.against(start) < 0;
      // Under the exact truth an entry at the horizon is due.
      const int late = x.against(t);
      if (y.against(start) <= 0 || late > 0 || (late == 0 && !(p_.exact() && at_end_))) continue;
      Overlap o = old && last ? *last : Overlap{old ? exact(start) : x, square(reach(i, j)), {}};
      if (old) last.reset();
      std::vector<Rat> at{start, t};
      if (g.a > 0) at.push_back(g.start - g.b / g.a);
      for (const Rat& s : at) {
        const Rat k = g.value(s), d2 = k + square(reach(i, j));
        if (s < start || s > t || (wall ? k <= 0 : k >= 0)) continue;
        if (x.against(s) > 0 || y.against(s) < 0) continue;
        if (wall ? d2 > o.extreme : d2 < o.extreme) o.extreme = d2;
      }
      if (claim != nullptr && old == continues_) o.answer = claim->t;
      if (y.against(t) <= 0) {
        close(i, j, o, y);
      } else {
        open_.emplace(Two{i, j}, o);
      }
    }
    if (last) close(i, j, *last, exact(start));
  }

  const Problem& p_;
  const Rat slack_;  // exact times have none
  Counts& counts_;
  std::int64_t& line_;
  Walk walk_;
  std::vector<std::int64_t> lines_;      // claims so far that moved a disk
  std::vector<std::int64_t> turned_by_;  // the collision that turned it last, or -1
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
