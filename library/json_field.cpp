#include "library/json_field.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "exact/rational.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/file_format.h"
#include "history/format_version.h"

namespace voroproof::internal {

JsonField JsonField::inside(const nlohmann::json& value, const std::string& step) const {
  return {value, *file_, name_ + step};
}

JsonField JsonField::operator[](const std::string& member) const {
  if (!value_->is_object()) fail("not an object");
  const std::string step = name_.empty() ? member : "." + member;
  const auto found = value_->find(member);
  if (found == value_->end()) throw InputError(*file_, 0, name_ + step, "missing");
  return inside(*found, step);
}

JsonField JsonField::operator[](std::size_t index) const {
  if (!value_->is_array()) fail("not an array");
  if (index >= value_->size()) fail("fewer than " + std::to_string(index + 1) + " elements");
  return inside((*value_)[index], "[" + std::to_string(index) + "]");
}

std::vector<JsonField> JsonField::elements() const {
  if (!value_->is_array()) fail("not an array");
  std::vector<JsonField> all;
  all.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) all.push_back((*this)[i]);
  return all;
}

std::string JsonField::text() const {
  if (!value_->is_string()) fail("not a string");
  return value_->get<std::string>();
}

std::int64_t JsonField::integer() const {
  if (!value_->is_number_integer()) fail("not an integer");
  const auto value = value_->get<std::int64_t>();
  // A number beyond has wrapped.
  if (value_->is_number_unsigned() && value < 0) fail("out of range");
  return value;
}

double JsonField::number() const {
  double value = INFINITY;
  if (value_->is_number()) {
    value = value_->get<double>();
  } else if (const auto exact = parse_rational(text())) {
    value = round_nearest(*exact);
  } else {
    fail("not a number: " + printable(text()));
  }
  if (!std::isfinite(value)) fail("not a finite number");
  return value;
}

void JsonField::fail(const std::string& reason) const {
  throw InputError(*file_, 0, name_, reason);
}

namespace {

// Refuses an object that has a name twice; the parser would take the last.
struct UniqueNames {
  std::string path;
  std::vector<std::set<std::string>> open = {};

  bool operator()(int, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (event == Event::object_start) open.emplace_back();
    if (event == Event::object_end) open.pop_back();
    if (event == Event::key && !open.back().insert(parsed.get<std::string>()).second) {
      throw InputError(path, 0, printable(parsed.get<std::string>()),
                       "a field appears twice in one object");
    }
    return true;
  }
};

}  // namespace

nlohmann::json parse_report(const std::string& bytes, const std::string& path) {
  // The parser takes a byte 0 for the end.
  const auto zero = std::find(bytes.begin(), bytes.end(), '\0');
  if (zero != bytes.end()) {
    throw InputError(path, 1 + std::count(bytes.begin(), zero, '\n'), "", "a byte 0");
  }
  nlohmann::json report;
  try {
    report = nlohmann::json::parse(bytes, UniqueNames{path});
  } catch (const nlohmann::json::parse_error& error) {
    const auto end =
        bytes.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, bytes.size()));
    throw InputError(path, 1 + std::count(bytes.begin(), end, '\n'), "",
                     error.byte > bytes.size() ? "incomplete" : "not JSON");
  } catch (const nlohmann::json::exception&) {  // a number beyond binary64
    throw InputError(path, 0, "", "a number out of range");
  }
  const JsonField version = JsonField(report, path)["version"];
  if (const std::int64_t number = version.integer(); number > format_version) {
    version.fail(newer_version(number));
  } else if (number != format_version) {
    version.fail("not " + std::to_string(format_version));
  }
  return report;
}

nlohmann::json read_report(const std::string& path, const std::string& format, std::size_t limit) {
  const std::string bytes = file_bytes(path, limit + 1, true);
  const FileFormat found = format_of_text(bytes, path);
  if (found.name != format) throw InputError(path, found.line, "format", "not \"" + format + "\"");
  if (bytes.size() > limit)
    throw InputError(path, 0, "", "larger than " + std::to_string(limit) + " bytes");
  return parse_report(bytes, path);
}

}  // namespace voroproof::internal
