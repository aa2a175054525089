// Collisions of a billiard: every overlap on its flights is answered by a claim, and every claim
// answers one.
#include <algorithm>
#include <optional>

#include "certify/kernel/motion.h"

namespace voroproof_kernel {
namespace {

// A longest time in which two overlap.
struct Episode {
  Root entry;
  std::int64_t line;            // the first claim's after it
  bool deep = false;            // deeper than the rounding so far
  std::optional<Rat> answer{};  // the time of the claim that answers it
  std::int64_t answer_line = 0;
};

// Follows two, image and all, through their lives and claims.
class Watch {
 public:
  Watch(const Problem& p, const Encounter& two, Counts& counts)
      : p_(p), two_(two), counts_(counts) {}

  void follow(const Life& life) {
    const Flight* i = two_.i < 0 ? nullptr : &p_.flights[two_.i][life.flight[0]];
    const Meeting meeting(p_, two_, i, p_.flights[two_.j][life.flight[1]]);
    if (life.claim >= 0) {
      const Claim& c = p_.history.claims[life.claim];
      at_line(c.line, [&] { judge(meeting, c); });
      met_ = life.claim;
      return;
    }
    if (life.from == life.to) return end(meeting, life.to);
    ++counts_.pair_lives;
    // A rounding explains nothing where the reach is not four times as large.
    const Rat depth = meeting.rounding(), beyond = meeting.reach[0] - 4 * depth;
    const Rat& rate = meeting.reach[1];
    Rat from = life.from;
    if (!meeting.is_flat() && rate != 0 && -beyond / rate > from && -beyond / rate < life.to) {
      overlap(meeting, depth, from, -beyond / rate);
      from = -beyond / rate;
    }
    overlap(meeting, depth, from, life.to);
  }

  // No claim comes any more.
  void finish() {
    const Rat& horizon = p_.history.horizon;
    if (open_ && !open_->answer) ended_.push_back(*open_);
    if (open_ && open_->answer) require_short(*open_, point(horizon));
    for (const Episode& episode : ended_) {
      if (!episode.deep) {
        ++counts_.rounding_overlaps;
      } else if (compare(episode.entry, horizon - p_.tolerance) >= 0) {
        ++counts_.horizon_events;
      } else {
        const Rat by = (episode.entry.lo + episode.entry.hi) / 2;
        throw Stop{Verdict::refuted,
                   name(p_, two_) + " overlap before " + about(by) +
                       " and no collision in time answers it",
                   episode.line, false, sight(by, {two_.i, two_.j})};
      }
    }
  }

 private:
  static Root point(const Rat& t) { return {{}, t, t, 0, 0}; }

  // A collision at the end, which need not be claimed.
  void end(const Meeting& meeting, const Rat& t) {
    if (open_ || !falls(meeting.gap(), t, t)) return;
    at_line(p_.history.last_line, [&] { require_mover(); });
    ++counts_.horizon_events;
  }
  void require_mover() const {
    if (p_.is_fixed(two_.i) && p_.is_fixed(two_.j))
      undecided(name(p_, two_) + " touch and cannot move");
  }

  void open(const Root& entry) {
    const auto& claims = p_.history.claims;
    const auto after = std::partition_point(
        claims.begin(), claims.end(), [&](const Claim& c) { return compare(entry, c.t) >= 0; });
    const std::int64_t line = after == claims.end() ? p_.history.last_line : after->line;
    at_line(line, [&] { require_mover(); });
    open_.emplace(Episode{entry, line});
  }

  // An answered overlap that is more than a rounding ends within the tolerance.
  void require_short(const Episode& episode, const Root& exit) const {
    if (!episode.deep || compare(exit, *episode.answer + p_.tolerance) <= 0) return;
    throw Stop{Verdict::refuted, name(p_, two_) + " overlap for too long after their collision",
               episode.answer_line, false, sight(*episode.answer, {two_.i, two_.j})};
  }

  void close(const Root& exit) {
    if (open_->answer) {
      require_short(*open_, exit);
    } else {
      ended_.push_back(*open_);
    }
    open_.reset();
  }

  // Overlaps on their flights in [from, to], where the reach is at least four roundings or is less.
  void overlap(const Meeting& m, const Rat& rounding, const Rat& from, const Rat& to) {
    const Form gap = m.gap();
    const Rat reach = m.reach[0] + m.reach[1] * (from + to) / 2;
    const bool explains = m.is_flat() || reach >= 4 * rounding;
    const Form deeper = explains ? m.gap(rounding) : gap;
    const int first = sign_beside(gap, from, 1);
    if (!open_ && first < 0) open({gap, from, from, 0, -1});
    if (open_ && first >= 0) close(point(from));
    Rat begun = from;
    for (const Root& root : roots(gap, from, to)) {
      if (root.before >= 0 && root.after < 0) {
        open(root);
        begun = root.lo;
      } else if (root.before < 0 && root.after >= 0) {
        open_->deep = open_->deep || sinks(deeper, begun, root.hi);
        close(root);
      }
    }
    if (open_) open_->deep = open_->deep || sinks(deeper, begun, to);
  }

  void judge(const Meeting& m, const Claim& c) {
    const bool parted = have_parted(m);
    if (!parted && answers(m, c)) return require_mover();
    const char* why =
        parted ? " have just collided and part since" : " do not come into contact then";
    refute(name(p_, two_) + why);
  }

  // Two that have just collided do not meet again on the same flights: their gap is convex, but in
  // a frame, and where one of them falls and the other is fixed.
  bool have_parted(const Meeting& m) const {
    if (two_.i < 0 || norm2(m.apart[2]) != 0) return false;
    const auto by_both = [&](int disk, const Flight* flight) {
      return p_.is_fixed(disk) || flight->claim == met_;
    };
    return met_ >= 0 && by_both(two_.i, m.i) && by_both(two_.j, m.j);
  }

  bool answers(const Meeting& m, const Claim& c) {
    const Rat early = c.t - p_.tolerance;
    const Form gap = m.gap();
    if (open_) return answers_open(m, c, early);
    const auto fits = [&](const Episode& episode) {
      return compare(episode.entry, std::max(early, m.begin())) >= 0;
    };
    const auto ended = std::find_if(ended_.begin(), ended_.end(), fits);
    if (ended != ended_.end()) return ended_.erase(ended), true;
    return falls(gap, c.t, c.t + p_.tolerance) || grazes(m, c.t);
  }

  // Whether the claim answers the overlap in progress.
  bool answers_open(const Meeting& m, const Claim& c, const Rat& early) {
    Episode& episode = *open_;
    const bool in_time = compare(episode.entry, early) >= 0;
    if (compare(episode.entry, m.begin()) >= 0 && !episode.answer) {
      if (!in_time) return false;
    } else if (sign_at(slope(m.gap()), c.t) >= 0) {
      return false;
    } else if (episode.deep) {
      if (episode.answer || !in_time) return false;
    } else {  // it counts as entered where their flights began
      if (m.begin() < early) return false;
      episode.entry = point(m.begin());
    }
    episode.answer = c.t;
    episode.answer_line = c.line;
    return true;
  }

  // Whether they come nearest within the tolerance of t, to no more than their rounding.
  bool grazes(const Meeting& m, const Rat& t) const {
    const Rat rounding = m.rounding();
    const Rat from = std::max(Rat(t - p_.tolerance), m.begin()), to = t + p_.tolerance;
    if (!m.is_flat() && m.reach[0] + m.reach[1] * t < 4 * rounding) return false;
    const Form gap = m.gap(), wider = m.gap(-rounding), change = slope(gap);
    if (sinks(gap, from, to) || change.size() < 2) return false;
    if (change.size() > 2) {
      const bool apart = sign_at(wider, from) > 0 && sign_at(wider, to) > 0;
      if (apart && roots(wider, from, to).empty()) return false;
      undecided(name(p_, two_) + " may graze under gravity");
    }
    if (change[1] < 0) return false;
    const Rat nearest(-change[0], change[1]);
    if (nearest <= m.begin() || nearest < from || nearest > to) return false;
    if (sign_at(wider, nearest) > 0) return false;
    ++counts_.grazes;
    return true;
  }

  static Form slope(const Form& p) {
    Form result;
    for (std::size_t k = 1; k < p.size(); ++k) result.push_back(k * p[k]);
    return result.empty() ? Form{0} : result;
  }

  const Problem& p_;
  Encounter two_;
  Counts& counts_;
  std::optional<Episode> open_;  // in progress
  std::vector<Episode> ended_;   // and not answered
  std::int64_t met_ = -1;        // their last claim
};

}  // namespace

void check_collisions(const Problem& p, std::vector<Life> lives, Counts& counts) {
  const auto order = [](const Life& x) {
    return std::tuple(x.two, x.flight[0] + x.flight[1], x.claim, x.from);
  };
  std::sort(lives.begin(), lives.end(),
            [&](const Life& x, const Life& y) { return order(x) < order(y); });
  std::optional<Stop> first;
  for (auto life = lives.begin(); life != lives.end();) {
    const Encounter two = life->two;
    try {
      Watch watch(p, two, counts);
      for (; life != lives.end() && life->two == two; ++life) watch.follow(*life);
      watch.finish();
    } catch (const Stop& stop) {
      const auto rank = [](const Stop& s) {
        return std::pair(s.verdict != Verdict::refuted, s.line);
      };
      if (!first || rank(stop) < rank(*first)) first = stop;
      while (life != lives.end() && life->two == two) ++life;
    }
  }
  if (first) throw Stop(*first);
}

}  // namespace voroproof_kernel
