#include "certify/world/world_lives.h"

#include <algorithm>
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
      if (due_ && order_of(root, *due_) >= 0) return;
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

EdgeFate edge_fate(const WorldCourses& motion, const Quad& edge, const WorldTime& now) {
  Patience::ask(8);
  const Quad q = with_disk_on_left(edge);
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
                                    const WorldTime& now) {
  Patience::ask();
  First first(now, until(motion, {g, h}));
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

std::optional<WorldTime> first_contact(const WorldCourses& motion, GenId g, GenId h,
                                       const WorldTime& now) {
  First first(now, until(motion, {g, h}));
  const WorldPolynomial p = world_tangency(motion, g, h);
  first.look(&p, is_always);
  return std::move(first).due();
}

std::int64_t& WorldAgenda::stamp(Kind kind, int id) {
  auto& stamps = stamps_[static_cast<int>(kind)];
  const auto place = static_cast<std::size_t>(id);
  if (stamps.size() <= place) stamps.resize(place + 1, 0);
  return stamps[place];
}

const WorldAgenda::Item* WorldAgenda::next() {
  while (!items_.empty()) {
    const Item& top = items_.top();
    if (top.stamp == stamp(top.kind, top.id)) return &top;
    items_.pop();
  }
  return nullptr;
}

}  // namespace voroproof::internal
