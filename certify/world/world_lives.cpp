#include "certify/world/world_lives.h"

#include <algorithm>
#include <array>
#include <utility>

#include "exact/patience.h"

namespace voroproof::internal {

namespace {

std::string text(const Quad& q) {
  return "[" + std::to_string(q.l) + "," + std::to_string(q.r) + "," + std::to_string(q.s) + "," +
         std::to_string(q.e) + "]";
}

Rational until(const WorldCourses& motion, std::initializer_list<GenId> ids) {
  Rational end = motion.limit();
  for (const GenId g : ids) end = std::min(end, motion.until(g));
  return end;
}

// Follows what may be due first.
class First {
 public:
  First(const WorldTime& now, Rational end) : now_(now), end_(std::move(end)) {}

  // The first root at which `is_due` says so.
  template <class IsDue>
  void look(const WorldPolynomial* f, const IsDue& is_due) {
    if (f == nullptr) return;
    for (WorldTime& root : roots_after(*f, now_, end_)) {
      if (due_ && compare(root, *due_) >= 0) return;
      if (!is_due(root)) continue;
      end_ = std::min(end_, root.interval().hi);
      due_ = std::move(root);
      return;
    }
  }
  std::optional<WorldTime> due() && { return std::move(due_); }

 private:
  const WorldTime& now_;
  Rational end_;
  std::optional<WorldTime> due_;
};

// Follows what may be due first, in doubles.
class RoughFirst {
 public:
  RoughFirst(const WorldCourses& motion, const Quad& q, const LazyTime& now)
      : motion_(motion), q_(q), now_(now), end_(round_up(until(motion, {q.l, q.r, q.s, q.e}))) {}

  // All that edge_fate() tells; nullopt where doubles leave something open.
  std::optional<EdgeFate> fate() && {
    if (!are_apart(rows_, q_.l, q_.r, now_.lo(), now_.hi())) return std::nullopt;
    if (auto contact = first_contact(motion_, q_.l, q_.r, now_)) take(*std::move(contact), false);
    if (q_.s != q_.e && !look_at_edge()) return std::nullopt;
    const bool has_lines = !motion_.has_circle() && q_.r >= 0;
    if (has_lines && (!look_at_circle(true) || !look_at_circle(false))) return std::nullopt;
    return std::move(fate_);
  }

 private:
  using Kind = RoughCollapse::Kind;

  void take(LazyTime t, bool collapses) {
    if (fate_.due && compare(t, *fate_.due) >= 0) return;
    end_ = std::min(end_, t.hi());
    fate_.due = std::move(t);
    fate_.collapses = collapses;
  }

  // While tangencies are positive nothing but roots of its polynomial changes a function's sign.
  bool stay_apart(double until) const {
    const std::array<GenId, 4> all{q_.l, q_.r, q_.s, q_.e};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) {
        const auto meeting = rough_meeting(rows_, all[i], all[j], now_.lo(), now_.hi(), until);
        if (meeting.kind != Kind::none) return false;
      }
    }
    return true;
  }

  // Both look at what comes until then; false where doubles do not tell.
  bool look_at_edge() {
    double lo = now_.lo(), hi = now_.hi();
    if (const auto until = now_.alone_until(q_)) {
      // The functions of an edge that a flip has just made vanish at the instant. They have the
      // signs that they have a little later, while no pair meets.
      lo = hi = hi + (*until - hi) / 16;
      if (!stay_apart(lo)) return false;
    }
    if (!is_legal_edge(rows_, q_, lo, hi)) return false;
    const auto [kind, root] = rough_fall(rows_, q_, lo, hi, end_);
    if (kind == Kind::unknown) return false;
    if (kind == Kind::none) return true;
    const auto polynomial = [&motion = motion_, q = q_] { return *WorldEdge(motion, q).changes(); };
    take(LazyTime(rows_, q_, root, polynomial), kind == Kind::collapses);
    return true;
  }
  bool look_at_circle(bool at_start) {
    const GenId j = at_start ? q_.s : q_.r, k = at_start ? q_.r : q_.e;
    if (j < 0 || k < 0) return true;
    if (!has_circle(rows_, q_.l, j, k, now_.lo(), now_.hi())) return false;
    const auto [kind, root] = rough_end_of_circle(rows_, q_.l, j, k, now_.lo(), now_.hi(), end_);
    if (kind == Kind::unknown) return false;
    if (kind == Kind::none) return true;
    const auto polynomial = [&motion = motion_, q = q_, at_start] {
      const WorldEdge edge(motion, q);
      return *existence(at_start ? edge.start() : edge.end()).changes();
    };
    take(LazyTime(root.lo, root.hi, polynomial), false);
    return true;
  }

  const WorldCourses& motion_;
  const RoughRows& rows_ = motion_.rough();
  const Quad& q_;
  const LazyTime& now_;
  double end_;
  EdgeFate fate_;
};

bool is_always(const WorldTime&) { return true; }

// In the plane: the circles of both vertices, as far as they are no lines by their names.
std::optional<std::string> look_at_circles(const Quad& q, const WorldEdge& edge,
                                           const WorldTime& now, First& first) {
  if (q.l < 0 || q.r < 0) return std::nullopt;
  for (const bool at_start : {true, false}) {
    if ((at_start ? q.s : q.e) < 0) continue;
    const RootedForm form = existence(at_start ? edge.start() : edge.end());
    if (form.after(now) == Sign::negative) {
      return "a vertex of the edge " + text(q) + " has no circle";
    }
    first.look(form.changes(), [&](const WorldTime& t) { return form.after(t) == Sign::negative; });
  }
  return std::nullopt;
}

}  // namespace

EdgeFate edge_fate(const WorldCourses& motion, const Quad& edge, const LazyTime& time) {
  Patience::ask(8);
  const Quad q = with_disk_on_left(edge);
  if (auto fate = RoughFirst(motion, q, time).fate()) return *std::move(fate);
  const WorldTime& now = time.exact();
  EdgeFate fate;
  const WorldPolynomial p = world_tangency(motion, q.l, q.r);
  if (signs_then(p, now).after != Sign::positive) {
    fate.fault = "one of the neighbours " + std::to_string(q.l) + " and " + std::to_string(q.r) +
                 " has no cell: one is hidden by the other";
    return fate;
  }
  First first(now, until(motion, {q.l, q.r, q.s, q.e}));
  first.look(&p, is_always);
  const bool has_lines = !motion.has_circle();
  if (q.s != q.e || has_lines) {
    const WorldEdge at(motion, q);
    if (q.s != q.e) {
      if (at.is_illegal_after(now)) {
        fate.fault = "the edge " + text(canonical(q)) + " is not there: its flip is missing";
        return fate;
      }
      first.look(at.changes(), [&](const WorldTime& t) { return at.is_illegal_after(t); });
    }
    if (has_lines) fate.fault = look_at_circles(q, at, now, first);
    if (fate.fault) return fate;
  }
  fate.due = std::move(first).due();
  return fate;
}

std::optional<WorldTime> first_exit(const WorldCourses& motion, GenId g, GenId h,
                                    const LazyTime& now) {
  Patience::ask();
  First first(now.exact(), until(motion, {g, h}));
  const auto is_out = [&](const WorldTime& t) { return !is_inside_after(motion, g, h, t); };
  const WorldPolynomial p = world_tangency(motion, g, h);
  if (!p.is_zero()) {
    first.look(&p, is_out);
  } else if (h >= 0) {
    const WorldPolynomial larger = motion.course(h).r - motion.course(g).r;
    first.look(&larger, is_out);
  }
  return std::move(first).due();
}

std::optional<LazyTime> first_contact(const WorldCourses& motion, GenId g, GenId h,
                                      const LazyTime& now) {
  const Rational end = until(motion, {g, h});
  const auto [kind, root] = rough_meeting(motion.rough(), g, h, now.lo(), now.hi(), round_up(end));
  if (kind == RoughCollapse::Kind::none) return std::nullopt;
  if (kind == RoughCollapse::Kind::fails) {
    return LazyTime(root.lo, root.hi, [&motion, g, h] { return world_tangency(motion, g, h); });
  }
  First first(now.exact(), end);
  const WorldPolynomial p = world_tangency(motion, g, h);
  first.look(&p, is_always);
  return std::move(first).due();
}

void WorldAgenda::forget(Kind kind, int id) {
  const auto known = items_.find({kind, id});
  if (known == items_.end()) return;
  queue_.erase({known->second.t.lo(), known->first});
  items_.erase(known);
}

void WorldAgenda::note(Item item) {
  const Key key{item.kind, item.id};
  queue_.insert({item.t.lo(), key});
  items_.emplace(key, std::move(item));
}

const WorldAgenda::Item* WorldAgenda::next() const {
  const Item* first = nullptr;
  for (const auto& [lo, key] : queue_) {
    if (first != nullptr && lo > first->t.hi()) break;
    const Item& item = items_.at(key);
    if (first == nullptr || compare(item.t, first->t) < 0) first = &item;
  }
  return first;
}

void WorldAgenda::drop() {
  const Item& item = *next();
  forget(item.kind, item.id);
}

}  // namespace voroproof::internal
