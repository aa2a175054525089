#include "certify/kernel/json.h"

#include <cmath>
#include <cstdlib>
#include <set>

namespace voroproof_kernel {
namespace {

// Refuses what nlohmann would let pass: keys that occur twice, nesting without end, numbers beyond
// binary64, or that are not zero and whose nearest binary64 is. An integer beyond 64 bits is the
// nearest binary64; where it is a scene's seed, which is not used, it is 0.
class StrictReader : public nlohmann::detail::json_sax_dom_parser<Json> {
  using Base = nlohmann::detail::json_sax_dom_parser<Json>;

 public:
  explicit StrictReader(Json& result) : Base(result, false) {}
  bool start_object(std::size_t size) { return open() && Base::start_object(size); }
  bool start_array(std::size_t size) { return open() && Base::start_array(size); }
  bool end_object() { return close() && Base::end_object(); }
  bool end_array() { return close() && Base::end_array(); }
  bool key(std::string& name) {
    if (!keys_.back().insert(name).second) invalid("a field occurs twice");
    is_seed_ = name == "seed";
    return Base::key(name);
  }
  bool number_float(long double, const std::string& text) {
    if (text.size() > 4096) invalid("a number of more than 4096 characters");
    if (is_seed_ && keys_.size() == 1 && text.find_first_of(".eE") == std::string::npos) {
      if (text.size() > 1000) invalid("a seed of more than 1000 characters");
      return Base::number_integer(0);
    }
    const double x = std::strtod(text.c_str(), nullptr);
    const bool zero = text.find_first_of("123456789") >= text.find_first_of("eE");
    if (std::isinf(x) || (x == 0 && !zero)) invalid("beyond the range of binary64");
    return Base::number_float(x, text);
  }

 private:
  bool open() {
    keys_.emplace_back();
    if (keys_.size() > 16) invalid("nested too deeply");
    return true;
  }
  bool close() {
    keys_.pop_back();
    return true;
  }
  std::vector<std::set<std::string>> keys_;  // keys of each object or list that is open
  bool is_seed_ = false;                     // whether the key read last is that of a seed
};

}  // namespace

Json parse(const char* begin, const char* end) {
  Json result;
  StrictReader reader(result);
  if (!Json::sax_parse(begin, end, &reader)) invalid("not JSON");
  return result;
}

void expect_fields(const Json& object, Names required, Names optional, bool extensible) {
  std::size_t known = required.size();
  for (const char* name : required) {
    if (!object.contains(name)) invalid(std::string("the field '") + name + "' is missing");
  }
  for (const char* name : optional) known += object.contains(name);
  for (const auto& [name, value] : object.items()) known += extensible && name.starts_with("x-");
  if (known != object.size()) invalid("an unknown field");
}

int version_of(const Json& object, const char* format) {
  const Json version = object.value("version", Json());
  if (object.value("format", Json()) != format || !version.is_number_integer() || version < 1)
    invalid("another format or version");
  if (version > 2)
    invalid("of version " + version.dump() + "; this program reads versions 1 and 2");
  return version.get<int>();
}

const std::string& string_of(const Json& json) {
  if (!json.is_string()) invalid("not a string");
  return json.get_ref<const std::string&>();
}

// strtod rounds correctly; integers are rounded to nearest, too.
Rat number(const Json& json) {
  if (json.is_number()) return exactly(json.get<double>());
  return exact_string(string_of(json));
}

// The limits are binary64, the one a little more and the other a little less than the power of ten.
Rat scene_number(const Json& json) {
  const Rat x = number(json), size = abs(x);
  if (x != 0 && (size > exactly(1e100) || size < exactly(1e-100)))
    invalid("beyond a scene's limits");
  return x;
}

Rat history_number(const Json& json) {
  const Rat x = number(json);
  if (x != 0 && json.is_string() && nearest_binary64(x) == 0) invalid("beyond binary64");
  return x;
}

const Json& list(const Json& json, std::size_t least, std::size_t most) {
  if (!json.is_array() || json.size() < least || json.size() > most) invalid("not such a list");
  return json;
}

Vec vec(const Json& json, Rat read(const Json&), int coordinates) {
  list(json, coordinates, coordinates);
  Vec v;
  for (int k = 0; k < coordinates; ++k) v[k] = read(json[k]);
  return v;
}

std::int64_t whole(const Json& json, std::int64_t least, std::int64_t most) {
  if (!json.is_number_integer()) invalid("not an integer");
  const bool huge = json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX;
  const std::int64_t x = huge ? INT64_MAX : json.get<std::int64_t>();
  if (huge || x < least || x > most) invalid("an integer beyond its limits");
  return x;
}

}  // namespace voroproof_kernel
