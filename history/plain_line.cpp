#include "history/plain_line.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <system_error>

namespace voroproof::internal {
namespace {

constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }

// The digits with which eight characters begin, without a branch for each: the first character is
// the lowest byte of the word.
class LeadingDigits {
 public:
  static constexpr int kMost = 8;

  explicit LeadingDigits(std::uint64_t word) : values_(word ^ 0x30 * kEach) {
    const std::uint64_t others = ((values_ & 0x7f * kEach) + 0x76 * kEach) | values_;
    count_ = std::countr_zero(others & 0x80 * kEach) / 8;
  }

  int count() const { return count_; }
  // The number that they are. Precondition: there are some.
  std::uint32_t value() const {
    // Zeros before the first; then pairs of digits, in every other byte; then all pairs by two
    // products, whose upper halves add up.
    std::uint64_t x = values_ << (64 - 8 * count_);
    x = 10 * x + (x >> 8);
    constexpr std::uint64_t far = 0x000000ff000000ff;
    x = (x & far) * (100 + (1000000ULL << 32)) + (x >> 16 & far) * (1 + (10000ULL << 32));
    return static_cast<std::uint32_t>(x >> 32);
  }

 private:
  static constexpr std::uint64_t kEach = 0x0101010101010101;
  std::uint64_t values_;
  int count_;
};

// A line of eight characters at least, read from left to right. Each function says whether what it
// is named after comes next, perhaps behind spaces, and takes it.
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
    // std::from_chars takes these forms, but JSON has no such number.
    if (digit == end_ || !is_digit(*digit)) return false;
    if (*digit == '0' && digit + 1 != end_ && is_digit(digit[1])) return false;
    while (digit != end_ && is_digit(*digit)) ++digit;
    if (digit != end_ && *digit == '.' && (digit + 1 == end_ || !is_digit(digit[1]))) return false;
    const auto [end, error] = std::from_chars(begin, end_, x);
    next_ = end;
    return error == std::errc() && (x != 0 || (end - begin == 1 && *begin == '0'));
  }

  // Eight characters, zeros behind the end.
  [[gnu::always_inline]] std::uint64_t word() const {
    if (next_ == end_) return 0;
    const char* const begin = std::min(next_, end_ - sizeof(std::uint64_t));
    std::uint64_t characters;
    std::memcpy(&characters, begin, sizeof characters);
    if constexpr (std::endian::native == std::endian::big) {
      characters = __builtin_bswap64(characters);
    }
    return characters >> (8 * (next_ - begin));
  }

  // The one way to write it: without zeros before it. One of more digits is for the strict reader.
  [[gnu::always_inline]] bool id(GenId lowest, GenId& g) {
    skip_spaces();
    const bool negative = next_ != end_ && *next_ == '-';
    if (negative) ++next_;
    const LeadingDigits digits(word());
    const int count = digits.count();
    if (count == 0 || count == LeadingDigits::kMost) return false;
    if (*next_ == '0' && (negative || count != 1)) return false;
    next_ += count;
    const auto value = static_cast<GenId>(digits.value());
    g = negative ? -value : value;
    return lowest <= g && g <= last_id_;
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

  // Reads the two vectors of a collision: null for the container, and only for it.
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
  if (line.size() < sizeof(std::uint64_t) || !PlainLine(line, last_id).event(*event)) event.reset();
  return event;
}

}  // namespace voroproof::internal
