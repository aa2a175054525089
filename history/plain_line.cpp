#include "history/plain_line.h"

#include <simdjson.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "history/json_text.h"

namespace voroproof::internal {
namespace {

namespace json = simdjson::ondemand;
using Value = simdjson::simdjson_result<json::value>;

// Each says whether the value is what it is named after, and takes it over. (Values are handed on
// by reference: processors wait where a copy reads at once what was just written in pieces.)

// Digits that matter, those after the zeros that a number begins with, fit into 64 bits where they
// are no more than this. simdjson 3.0 takes 0. with more of them for another number. What the
// writer writes has 17.
constexpr std::size_t most_digits = 19;

bool has_few_digits(std::string_view token) {
  if (token.size() <= most_digits) return true;
  token.remove_prefix(static_cast<std::size_t>(
      std::find_if(token.begin(), token.end(), [](char c) { return '1' <= c && c <= '9'; }) -
      token.begin()));
  if (token.size() <= most_digits) return true;
  const std::string_view mantissa = token.substr(0, token.find_first_of("eE"));
  return std::count_if(mantissa.begin(), mantissa.end(), [](char c) {
           return '0' <= c && c <= '9';
         }) <= static_cast<std::ptrdiff_t>(most_digits);
}

[[gnu::always_inline]] inline bool is_number(Value& value, double& x) {
  std::string_view token;
  if (value.raw_json_token().get(token) || !has_few_digits(token)) return false;
  if (value.get_double().get(x)) return false;
  // Zero is for the strict reader, but in its one usual form: it may be -0, or too small.
  return x != 0 || token == "0";
}

[[gnu::always_inline]] inline bool is_id(Value& value, int lowest, int last_id, int& out) {
  std::string_view token;
  std::int64_t id = 0;
  if (value.raw_json_token().get(token) || value.get_int64().get(id)) return false;
  out = static_cast<int>(id);
  return lowest <= id && id <= last_id && (id != 0 || token == "0");
}

// `is_element(element, k)` for the elements of an array of n.
template <class IsElement>
[[gnu::always_inline]] inline bool is_array(Value& value, int n, IsElement&& is_element) {
  json::array array;
  if (value.get_array().get(array)) return false;
  int k = 0;
  for (Value element : array) {
    if (element.error() || k == n || !is_element(element, k)) return false;
    ++k;
  }
  return k == n;
}

template <std::size_t n>
[[gnu::always_inline]] inline bool are_ids(Value& value, int last_id, std::array<int, n>& ids) {
  return is_array(value, n,
                  [&](Value& id, int k) { return is_id(id, container_id, last_id, ids[k]); });
}

bool is_vector(Value& value, std::optional<Vec2>& v) {
  Vec2& out = v.emplace();
  return is_array(value, 2, [&](Value& x, int k) { return is_number(x, out[k]); });
}

// Whether the value is a collision's two vectors: null for the container, and only for it.
bool are_vectors(Value& value, GenId i, std::array<std::optional<Vec2>, 2>& v) {
  return is_array(value, 2, [&](Value& element, int k) {
    bool null = false;
    if (k == 0 && i == container_id) return !element.is_null().get(null) && null;
    return is_vector(element, v[k]);
  });
}

[[gnu::always_inline]] inline bool is_flip(Value& value, int last_id, FlipEvent& flip) {
  std::array<int, 4> ids{};
  if (!are_ids(value, last_id, ids)) return false;
  const Quad quad{ids[0], ids[1], ids[2], ids[3]};
  if (!names_an_edge(quad)) return false;
  flip.quad = canonical(quad);
  return true;
}

bool is_pair(Value& value, int last_id, CollideEvent& c) {
  std::array<int, 2> ids{};
  if (!are_ids(value, last_id, ids) || ids[0] >= ids[1]) return false;
  c.i = ids[0];
  c.j = ids[1];
  return true;
}

}  // namespace

class PlainLineReader::Implementation {
 public:
  Implementation() {
    // No thread of its own: whoever reads decides how many there are.
#ifdef SIMDJSON_THREADS_ENABLED
    parser_.threaded = false;
#endif
  }

  // Whether the line is right in form. What `event` is then is the line's; else it may be anything.
  bool read(std::string_view line, std::string_view text, std::int64_t begin, int last_id,
            std::optional<Event>& event) {
    // The second time it is the line alone.
    for (int k = 0; k < 2 && !is_at(begin); ++k) load(line, text, begin);
    if (!is_at(begin)) return false;
    const bool right = next_event(last_id, event);
    ++next_;
    // An object of this form has no brace inside: it ends with the first one.
    const std::size_t end = std::min(line.find('}'), line.size() - 1);
    return right && line[end] == '}' && line.find_first_not_of(" \t\r", end + 1) == line.npos;
  }

 private:
  // So many bytes are split at once, or one line.
  static constexpr std::size_t kBytes = 1 << 14;

  // Whether the next object begins there in the file.
  bool is_at(std::int64_t begin) {
    return next_ != objects_.end() && next_.error() == simdjson::SUCCESS &&
           first_ + static_cast<std::int64_t>(next_.current_index()) == begin;
  }

  // Has simdjson split whole lines of the text. Where it took one of them for something else before
  // it came to their end it splits line by line up to there.
  void load(std::string_view line, std::string_view text, std::int64_t begin) {
    const bool amid = first_ <= begin && begin < end_;
    std::string_view lines = line;
    if (!amid) {
      const std::size_t end = text.substr(0, kBytes).rfind('\n');
      if (end != text.npos && end > line.size()) lines = text.substr(0, end + 1);
      end_ = begin + static_cast<std::int64_t>(lines.size());
    }
    first_ = begin;
    // simdjson reads beyond the end.
    buffer_.reserve(lines.size() + simdjson::SIMDJSON_PADDING);
    buffer_.assign(lines);
    if (parser_.iterate_many(buffer_.data(), buffer_.size(), buffer_.size()).get(objects_)) {
      objects_ = {};
    }
    next_ = objects_.begin();
  }

  bool next_event(int last_id, std::optional<Event>& event) {
    json::document_reference document;
    json::object object;
    if ((*next_).get(document) || document.get_object().get(object)) return false;
    double t = 0;
    int seen = 0;
    for (auto field : object) {
      json::raw_json_string key;
      if (field.key().get(key)) return false;
      Value value = field.value();
      if (!take(key, value, last_id, seen, t, event)) return false;
    }
    if (event) std::visit([t](auto& e) { e.t = t; }, *event);
    return event.has_value();
  }

  // Takes the members in the order of the writer: the time, what happened, then perhaps v, then
  // perhaps p.
  [[gnu::always_inline]] static bool take(json::raw_json_string key, Value& value, int last_id,
                                          int& seen, double& t, std::optional<Event>& event) {
    enum { nothing, time, what, velocities, centres };
    if (seen == nothing) {
      seen = time;
      return key == "t" && is_number(value, t) && t >= 0;
    }
    if (seen == time) {
      seen = what;
      if (key == "flip") return is_flip(value, last_id, event.emplace().emplace<FlipEvent>());
      if (key == "collide") return is_pair(value, last_id, event.emplace().emplace<CollideEvent>());
      return key == "maneuver" &&
             is_id(value, 0, last_id, event.emplace().emplace<ManeuverEvent>().disk);
    }
    const bool v = key == "v";
    if (!(v && seen == what) && !(key == "p" && seen < centres)) return false;
    seen = v ? velocities : centres;
    if (auto* c = std::get_if<CollideEvent>(&*event))
      return are_vectors(value, c->i, v ? c->v : c->p);
    if (auto* m = std::get_if<ManeuverEvent>(&*event)) return is_vector(value, v ? m->v : m->p);
    return false;
  }

  json::parser parser_;
  std::string buffer_;      // what is split
  std::int64_t first_ = 0;  // where that begins in the file
  std::int64_t end_ = 0;    // where the last lines split at once end in the file
  json::document_stream objects_;
  json::document_stream::iterator next_;
};

PlainLineReader::PlainLineReader() : implementation_(std::make_unique<Implementation>()) {}
PlainLineReader::PlainLineReader(PlainLineReader&&) noexcept = default;
PlainLineReader& PlainLineReader::operator=(PlainLineReader&&) noexcept = default;
PlainLineReader::~PlainLineReader() = default;

std::optional<Event> PlainLineReader::event(std::string_view line, std::string_view text,
                                            std::int64_t begin, int last_id) {
  std::optional<Event> event;
  if (!implementation_->read(line, text, begin, last_id, event)) event.reset();
  return event;
}

}  // namespace voroproof::internal
