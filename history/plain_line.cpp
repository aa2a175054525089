#include "history/plain_line.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <system_error>

namespace voroproof::internal {
namespace {

// As many as an id may have, and one more.
constexpr std::ptrdiff_t most_id_digits = std::numeric_limits<GenId>::digits10 + 2;

constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }

// A line read from left to right. Each function says whether what it is named after comes next,
// perhaps behind spaces, and takes it.
class PlainLine {
 public:
  PlainLine(std::string_view line, int last_id)
      : next_(line.data()), end_(line.data() + line.size()), last_id_(last_id) {}

  // `event` is a flip at first.
  bool event(Event& event) {
    double t = 0;
    if (!is('{') || !name("\"t\"") || !number(t) || !(t >= 0) || !is(',')) return false;
    bool right = false;
    if (name("\"flip\"")) {
      FlipEvent& flip = std::get<FlipEvent>(event);
      flip.t = t;
      right = edge(flip.quad);
    } else if (name("\"collide\"")) {
      CollideEvent& collision = event.emplace<CollideEvent>();
      collision.t = t;
      const auto both = [&](auto& vectors) { return pair_of_vectors(collision.i, vectors); };
      right = pair(collision) && vectors(both, collision.v, collision.p);
    } else if (name("\"maneuver\"")) {
      ManeuverEvent& maneuver = event.emplace<ManeuverEvent>();
      maneuver.t = t;
      const auto one = [&](auto& of) { return vector(of); };
      right = id(0, maneuver.disk) && vectors(one, maneuver.v, maneuver.p);
    }
    return right && is('}') && nothing_else();
  }

 private:
  void skip_spaces() {
    while (next_ != end_ && *next_ == ' ') ++next_;
  }

  [[gnu::always_inline]] bool is(char c) {
    if (!at(c)) return false;
    ++next_;
    return true;
  }
  // The same, not taken.
  [[gnu::always_inline]] bool at(char c) {
    if (next_ != end_ && *next_ == c) return true;
    skip_spaces();
    return next_ != end_ && *next_ == c;
  }

  // A member's name with its quotation marks, and the colon.
  bool name(std::string_view quoted) {
    skip_spaces();
    if (!std::string_view(next_, static_cast<std::size_t>(end_ - next_)).starts_with(quoted)) {
      return false;
    }
    next_ += quoted.size();
    return is(':');
  }

  // Zero is for the strict reader, but in its one usual form: it may be -0, or too small.
  bool number(double& x) {
    skip_spaces();
    const char* const begin = next_;
    const char* digit = begin != end_ && *begin == '-' ? begin + 1 : begin;
    // What a number of JSON must not be, and std::from_chars takes.
    if (digit == end_ || !is_digit(*digit)) return false;
    if (*digit == '0' && digit + 1 != end_ && is_digit(digit[1])) return false;
    while (digit != end_ && is_digit(*digit)) ++digit;
    if (digit != end_ && *digit == '.' && (digit + 1 == end_ || !is_digit(digit[1]))) return false;
    const auto [end, error] = std::from_chars(begin, end_, x);
    next_ = end;
    return error == std::errc() && (x != 0 || (end - begin == 1 && *begin == '0'));
  }

  // The one way to write it: without zeros before it.
  [[gnu::always_inline]] bool id(GenId lowest, GenId& g) {
    skip_spaces();
    const bool negative = next_ != end_ && *next_ == '-';
    const char* const begin = next_ + (negative ? 1 : 0);
    const char* const end = end_ - begin > most_id_digits ? begin + most_id_digits : end_;
    const char* digit = begin;
    std::int64_t value = 0;
    for (; digit != end && is_digit(*digit); ++digit) value = 10 * value + (*digit - '0');
    if (digit == begin || (*begin == '0' && (negative || digit != begin + 1))) return false;
    if (negative) value = -value;
    next_ = digit;  // what has more digits goes on with one
    g = static_cast<GenId>(value);
    return lowest <= value && value <= last_id_;
  }

  bool edge(Quad& quad) {
    Quad q;
    if (!is('[') || !id(container_id, q.l) || !is(',') || !id(container_id, q.r) || !is(',') ||
        !id(container_id, q.s) || !is(',') || !id(container_id, q.e) || !is(']') ||
        !names_an_edge(q)) {
      return false;
    }
    quad = canonical(q);
    return true;
  }

  bool pair(CollideEvent& c) {
    return is('[') && id(container_id, c.i) && is(',') && id(container_id, c.j) && is(']') &&
           c.i < c.j;
  }

  bool vector(std::optional<Vec2>& v) {
    Vec2& out = v.emplace();
    return is('[') && number(out[0]) && is(',') && number(out[1]) && is(']');
  }

  // Of a collision: null for the container, and only for it.
  bool pair_of_vectors(GenId i, std::array<std::optional<Vec2>, 2>& v) {
    return is('[') && (i == container_id ? null() : vector(v[0])) && is(',') && vector(v[1]) &&
           is(']');
  }
  bool null() {
    skip_spaces();
    if (!std::string_view(next_, static_cast<std::size_t>(end_ - next_)).starts_with("null")) {
      return false;
    }
    next_ += 4;
    return true;
  }

  // Velocities, then centres, each if there.
  template <class Read, class Vectors>
  bool vectors(const Read& read, Vectors& velocities, Vectors& centres) {
    if (at('}')) return true;
    if (!is(',')) return false;
    if (name("\"v\"")) {
      if (!read(velocities)) return false;
      if (at('}')) return true;
      if (!is(',')) return false;
    }
    return name("\"p\"") && read(centres);
  }

  bool nothing_else() {
    while (next_ != end_ && (*next_ == ' ' || *next_ == '\t' || *next_ == '\r')) ++next_;
    return next_ == end_;
  }

  const char* next_;
  const char* end_;
  int last_id_;
};

}  // namespace

std::optional<Event> plain_event(std::string_view line, int last_id) {
  // As the smallest of the three: an empty one would have all of its memory cleared.
  std::optional<Event> event(std::in_place, std::in_place_type<FlipEvent>);
  if (!PlainLine(line, last_id).event(*event)) event.reset();
  return event;
}

}  // namespace voroproof::internal
