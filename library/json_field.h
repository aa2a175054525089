// Reports as they are read again: every complaint names the file and the field.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace voroproof::internal {

// A value inside a JSON document, with its place there. The document and the file's name outlive
// it.
class JsonField {
 public:
  JsonField(const nlohmann::json& document, const std::string& file)
      : JsonField(document, file, "") {}

  bool has(const std::string& member) const { return value_->contains(member); }
  // All throw InputError: there is no such member or element, or the value is of another kind.
  JsonField operator[](const std::string& member) const;
  JsonField operator[](std::size_t index) const;
  std::vector<JsonField> elements() const;
  std::string text() const;
  std::int64_t integer() const;
  // Finite: a JSON number, or an exact value as text (docs/formats.md, section 1), rounded.
  double number() const;

  const nlohmann::json& json() const { return *value_; }
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  JsonField(const nlohmann::json& value, const std::string& file, std::string name)
      : value_(&value), file_(&file), name_(std::move(name)) {}
  JsonField inside(const nlohmann::json& value, const std::string& step) const;

  const nlohmann::json* value_;
  const std::string* file_;
  std::string name_;  // "divergence.witness.generators[0]"
};

// The JSON document in a file of at most `limit` bytes whose "format" is the given one, version 1.
// Throws InputError where it is none.
nlohmann::json read_report(const std::string& path, const std::string& format, std::size_t limit);
// The document in the text of such a report; `name` is for messages, the format is not looked at.
nlohmann::json parse_report(const std::string& text, const std::string& name);

}  // namespace voroproof::internal
