// A strict JSON reader (RFC 8259) that knows at every moment the line and the field it is at.
//
// The formats of this project are fixed, so the caller asks for what must come next instead of
// walking a tree: nothing is stored, hostile nesting is refused at once, and every complaint, of
// the reader and of the caller alike, names its line and field. Keys may come in any order; unknown
// and repeated keys are errors; so is text after the value.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "exact/rational.h"
#include "history/extensions.h"

namespace voroproof::internal {

inline constexpr int max_json_depth = 16;
inline constexpr std::size_t max_json_text = std::size_t{1} << 20;  // bytes of one string

// A real number as read: a JSON number denotes the nearest binary64, a JSON string an exact value.
struct Number {
  double nearest = 0;             // the value, rounded to nearest; never -0
  std::optional<Rational> exact;  // given where it was written as a string

  Rational value() const { return exact ? *exact : to_rational(nearest); }
};

class JsonReader {
 public:
  // `text` and `file` must outlive the reader. The first line of the text has the given number.
  JsonReader(std::string_view text, const std::string& file, std::int64_t first_line = 1)
      : next_(text.data()), end_(text.data() + text.size()), file_(&file), line_(first_line) {}

  // Reads an object whose keys are among `names`, which outlive the reader: on_member(index) must
  // read the value of names[index]. The keys of the bit set `required` must occur. Returns the bit
  // set of the keys that did. With `extensions` there may be such fields besides, which go there.
  template <std::size_t N, class OnMember>
  std::uint32_t object(const std::array<std::string_view, N>& names, std::uint32_t required,
                       OnMember&& on_member, Extensions* extensions = nullptr) {
    static_assert(N <= 32);
    expect('{', "an object");
    const std::int64_t first_line = line_;
    enter();
    std::uint32_t seen = 0;
    if (!accept('}')) {
      do {
        const std::size_t index = member_name(names.data(), N, extensions);
        if (index == N) continue;  // an extension, which has been read
        top().name = names[index];
        if (seen & bit(index)) fail("appears twice in one object");
        seen |= bit(index);
        on_member(index);
      } while (more('}'));
    }
    leave();
    if (const std::uint32_t missing = required & ~seen) {
      std::size_t index = 0;
      while (!(missing & bit(index))) ++index;
      line_ = first_line;
      fail_in(std::string(names[index]), "missing");
    }
    return seen;
  }
  static constexpr std::uint32_t bit(std::size_t index) { return std::uint32_t{1} << index; }

  // Reads an object with any keys: on_member(name) must read the value and return whether to go on;
  // if not, the rest is left unread and the reader is of no further use. The name holds until the
  // value is read.
  template <class OnMember>
  void any_object(OnMember&& on_member) {
    expect('{', "an object");
    enter();
    if (!accept('}')) {
      do {
        if (!on_member(any_member_name())) return;
      } while (more('}'));
    }
    leave();
  }

  // Reads an array: on_element(index) must read the element. Returns the number of elements.
  template <class OnElement>
  std::size_t array(OnElement&& on_element) {
    expect('[', "an array");
    enter();
    std::size_t count = 0;
    if (!accept(']')) {
      do {
        top().index = static_cast<std::int64_t>(count);
        on_element(count++);
      } while (more(']'));
    }
    leave();
    return count;
  }

  // Reads an array of exactly N elements.
  template <std::size_t N, class OnElement>
  void array_of(OnElement&& on_element) {
    const std::size_t count = array([&](std::size_t index) {
      if (index >= N) {
        leave();  // the fault is the array's, not the element's
        fail_length(N);
      }
      on_element(index);
    });
    if (count != N) fail_length(N);
  }

  // Reads a string of at most max_json_text bytes; the view holds until the next call.
  std::string_view text();

  // Reads a JSON number or an exact string; its value rounds to a finite binary64.
  Number number();

  // Reads a JSON number without fraction and exponent, in [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high);

  // Reads such a number of at most 1000 digits.
  Integer big_integer();

  // Reads a null if one is next.
  bool null();

  bool boolean();

  // Whether the next value is an array or a string.
  bool array_is_next() { return peek() == '['; }
  bool text_is_next() { return peek() == '"'; }
  bool null_is_next() { return peek() == 'n'; }

  // Reads any value and returns its text. What holds of the formats' own values holds of it, too:
  // no key occurs twice in one object, and numbers are binary64.
  std::string_view any();

  // Requires that nothing but white space is left.
  void finish();

  std::int64_t line() const { return line_; }  // line of the last token read
  std::string field() const;                   // e.g. "disks[3].velocity[0]"

  // Throws the InputError that blames the value just read or about to be read.
  [[noreturn]] void fail(const std::string& reason) const;

  // Throws the InputError that blames a member of the object just read.
  [[noreturn]] void fail_in(const std::string& member, const std::string& reason) const;

 private:
  // One step of the field's path: the name of a member, or the index of an element.
  struct Step {
    std::string_view name;
    std::int64_t index;  // -1 for a member
  };

  char peek();  // the next character after white space, '\0' at the end
  bool accept(char c) {
    if (peek() != c || next_ == end_) return false;
    ++next_;
    return true;
  }
  void expect(char c, const char* what);
  bool more(char closing);
  void enter() {
    if (depth_ == max_json_depth) fail_depth();
    path_[depth_++] = {{}, -1};
  }
  void leave() { --depth_; }
  Step& top() { return path_[depth_ - 1]; }

  std::string_view any_member_name();
  std::size_t member_name(const std::string_view* names, std::size_t count, Extensions* extensions);
  void extension(std::string name, Extensions& extensions);
  std::string_view number_token();
  void escape();
  unsigned four_hex_digits();
  [[noreturn]] void fail_expected(const char* what);
  [[noreturn]] void fail_depth() const;
  [[noreturn]] void fail_length(std::size_t wanted) const;

  const char* next_;
  const char* end_;
  const std::string* file_;
  std::int64_t line_;
  int depth_ = 0;
  std::array<Step, max_json_depth> path_;
  std::string unescaped_;
};

}  // namespace voroproof::internal
