#include "history/plain_line.h"

#include <simdjson.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "history/json_text.h"

namespace voroproof::internal {
namespace {

namespace json = simdjson::ondemand;
using Value = simdjson::simdjson_result<json::value>;

// Each says whether the value is what it is named after, and takes it over.

// Digits that matter, those after the zeros that a number begins with, fit into 64 bits where they
// are no more than this. simdjson 3.0 takes 0. with more of them for another number. What the
// writer writes has 17.
constexpr std::ptrdiff_t most_digits = 19;

bool has_few_digits(std::string_view token) {
  if (token.size() <= most_digits) return true;
  std::string_view mantissa = token.substr(0, token.find_first_of("eE"));
  mantissa.remove_prefix(std::min(mantissa.find_first_of("123456789"), mantissa.size()));
  return std::count_if(mantissa.begin(), mantissa.end(),
                       [](char c) { return '0' <= c && c <= '9'; }) <= most_digits;
}

bool is_number(Value value, double& x) {
  std::string_view token;
  if (value.raw_json_token().get(token) || !has_few_digits(token)) return false;
  if (value.get_double().get(x)) return false;
  // Zero is for the strict reader, but in its one usual form: it may be -0, or too small.
  return x != 0 || token == "0";
}

bool is_id(Value value, int lowest, int last_id, int& out) {
  std::string_view token;
  std::int64_t id = 0;
  if (value.raw_json_token().get(token) || value.get_int64().get(id)) return false;
  out = static_cast<int>(id);
  return lowest <= id && id <= last_id && (id != 0 || token == "0");
}

// `is_element(element, k)` for the elements of an array of n.
template <class IsElement>
bool is_array(Value value, int n, IsElement&& is_element) {
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
bool are_ids(Value value, int last_id, std::array<int, n>& ids) {
  return is_array(value, n,
                  [&](Value id, int k) { return is_id(id, container_id, last_id, ids[k]); });
}

bool is_vector(Value value, std::optional<Vec2>& v) {
  Vec2& out = v.emplace();
  return is_array(value, 2, [&](Value x, int k) { return is_number(x, out[k]); });
}

// Whether the value is a collision's two vectors: null for the container, and only for it.
bool are_vectors(Value value, GenId i, std::array<std::optional<Vec2>, 2>& v) {
  return is_array(value, 2, [&](Value element, int k) {
    bool null = false;
    if (k == 0 && i == container_id) return !element.is_null().get(null) && null;
    return is_vector(element, v[k]);
  });
}

bool is_flip(Value value, int last_id, FlipEvent& flip) {
  std::array<int, 4> ids{};
  if (!are_ids(value, last_id, ids)) return false;
  const Quad quad{ids[0], ids[1], ids[2], ids[3]};
  if (!names_an_edge(quad)) return false;
  flip.quad = canonical(quad);
  return true;
}

bool is_pair(Value value, int last_id, CollideEvent& c) {
  std::array<int, 2> ids{};
  if (!are_ids(value, last_id, ids) || ids[0] >= ids[1]) return false;
  c.i = ids[0];
  c.j = ids[1];
  return true;
}

}  // namespace

class PlainLineReader::Implementation {
 public:
  std::optional<Event> event(std::string_view line, int last_id) {
    // simdjson reads beyond the end.
    buffer_.assign(line);
    buffer_.reserve(buffer_.size() + simdjson::SIMDJSON_PADDING);
    json::document document;
    json::object object;
    if (parser_.iterate(buffer_.data(), line.size(), buffer_.capacity()).get(document) ||
        document.get_object().get(object)) {
      return std::nullopt;
    }
    double t = 0;
    std::optional<Event> event;
    int seen = 0;
    for (auto field : object) {
      json::raw_json_string key;
      if (field.key().get(key)) return std::nullopt;
      if (!take(key, field.value(), last_id, seen, t, event)) return std::nullopt;
    }
    // Nothing may follow the object.
    if (!event || document.current_location().error() != simdjson::OUT_OF_BOUNDS) {
      return std::nullopt;
    }
    std::visit([t](auto& e) { e.t = t; }, *event);
    return event;
  }

 private:
  // Takes the members in the order of the writer: the time, what happened, then perhaps v, then
  // perhaps p.
  static bool take(json::raw_json_string key, Value value, int last_id, int& seen, double& t,
                   std::optional<Event>& event) {
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
  std::string buffer_;
};

PlainLineReader::PlainLineReader() : implementation_(std::make_unique<Implementation>()) {}
PlainLineReader::PlainLineReader(PlainLineReader&&) noexcept = default;
PlainLineReader& PlainLineReader::operator=(PlainLineReader&&) noexcept = default;
PlainLineReader::~PlainLineReader() = default;

std::optional<Event> PlainLineReader::event(std::string_view line, int last_id) {
  return implementation_->event(line, last_id);
}

}  // namespace voroproof::internal
