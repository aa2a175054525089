#include "history/plain_line.h"

#include <array>
#include <charconv>
#include <cstring>
#include <system_error>

#include "history/json_text.h"

namespace voroproof {
namespace {

// Every function reads what it is named after, or says that it is not there: then the rest of the
// line is not looked at.
class PlainLine {
 public:
  PlainLine(std::string_view line, int last_id)
      : next_(line.data()), end_(line.data() + line.size()), last_id_(last_id) {}

  template <std::size_t N>
  bool literal(const char (&text)[N]) {
    if (static_cast<std::size_t>(end_ - next_) < N - 1 || std::memcmp(next_, text, N - 1) != 0) {
      return false;
    }
    next_ += N - 1;
    return true;
  }

  bool number(double& x) {
    const char* const start = next_;
    if (!skip_number()) return false;
    const auto result = std::from_chars(start, next_, x);
    // Zero is for the strict reader, but in its one usual form: it may be -0, or too small.
    return result.ec == std::errc() && (x != 0 || (next_ - start == 1 && *start == '0'));
  }

  bool id(int lowest, int& out) {
    const char* const start = next_;
    const auto result = std::from_chars(start, end_, out);
    const char* const digits = start + (start != end_ && *start == '-');
    if (result.ec != std::errc() || (*digits == '0' && result.ptr != start + 1)) return false;
    next_ = result.ptr;
    return lowest <= out && out <= last_id_;
  }

  bool quad(Quad& q) {
    return literal("[") && id(container_id, q.l) && literal(",") && id(container_id, q.r) &&
           literal(",") && id(container_id, q.s) && literal(",") && id(container_id, q.e) &&
           literal("]") && names_an_edge(q);
  }

  bool vector(std::optional<Vec2>& v) {
    Vec2& out = v.emplace();
    return literal("[") && number(out[0]) && literal(",") && number(out[1]) && literal("]");
  }

  // Of a collision: null for the container, and only for it.
  bool vectors(GenId i, std::array<std::optional<Vec2>, 2>& v) {
    return literal("[") && (i == container_id ? literal("null") : vector(v[0])) && literal(",") &&
           vector(v[1]) && literal("]");
  }

  bool finished() const { return next_ == end_; }

 private:
  bool digit() const { return next_ != end_ && *next_ >= '0' && *next_ <= '9'; }
  bool digits() {
    if (!digit()) return false;
    while (digit()) ++next_;
    return true;
  }
  // A token of JSON's grammar, which is narrower than that of std::from_chars.
  bool skip_number() {
    const char* const start = next_;
    literal("-");
    if (!literal("0") && !digits()) return false;
    if (digit()) return false;  // after a leading zero
    if (literal(".") && !digits()) return false;
    if (literal("e") || literal("E")) {
      if (!literal("+")) literal("-");
      if (!digits()) return false;
    }
    return static_cast<std::size_t>(next_ - start) <= max_number_text;
  }

  const char* next_;
  const char* end_;
  int last_id_;
};

std::optional<Event> plain_flip(PlainLine& line, double t) {
  FlipEvent flip{t, {}, {}};
  if (!line.quad(flip.quad) || !line.literal("}") || !line.finished()) return std::nullopt;
  flip.quad = canonical(flip.quad);
  return flip;
}

std::optional<Event> plain_collision(PlainLine& line, double t) {
  std::optional<Event> event(std::in_place, std::in_place_type<CollideEvent>);
  auto& c = std::get<CollideEvent>(*event);
  c.t = t;
  if (!line.literal("[") || !line.id(container_id, c.i) || !line.literal(",") ||
      !line.id(container_id, c.j) || !line.literal("]") || c.i >= c.j) {
    return std::nullopt;
  }
  if (line.literal(",\"v\":") && !line.vectors(c.i, c.v)) return std::nullopt;
  if (line.literal(",\"p\":") && !line.vectors(c.i, c.p)) return std::nullopt;
  if (!line.literal("}") || !line.finished()) return std::nullopt;
  return event;
}

std::optional<Event> plain_maneuver(PlainLine& line, double t) {
  std::optional<Event> event(std::in_place, std::in_place_type<ManeuverEvent>);
  auto& m = std::get<ManeuverEvent>(*event);
  m.t = t;
  if (!line.id(0, m.disk)) return std::nullopt;
  if (line.literal(",\"v\":") && !line.vector(m.v)) return std::nullopt;
  if (line.literal(",\"p\":") && !line.vector(m.p)) return std::nullopt;
  if (!line.literal("}") || !line.finished()) return std::nullopt;
  return event;
}

}  // namespace

std::optional<Event> plain_event(std::string_view text, int last_id) {
  PlainLine line(text, last_id);
  double t = 0;
  if (!line.literal("{\"t\":") || !line.number(t) || t < 0) return std::nullopt;
  if (line.literal(",\"flip\":")) return plain_flip(line, t);
  if (line.literal(",\"collide\":")) return plain_collision(line, t);
  if (line.literal(",\"maneuver\":")) return plain_maneuver(line, t);
  return std::nullopt;
}

}  // namespace voroproof
