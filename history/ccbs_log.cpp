// The log of a continuous-time multi-agent path finder: root/log/agent/path/section, a section with
// start_i, start_j, goal_i, goal_j and duration. Solvers copy their task, root/agent, into it, and
// sum up in root/log/summary. Any other element may be somebody, and is refused.
#include "history/paths_file.h"

#include <expat.h>

#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {

namespace {

// The callbacks of expat; an error is kept until expat has returned.
class LogReader {
 public:
  LogReader(const std::string& file, const Rational& radius)
      : file_(file), radius_(radius), parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), &begin, &end);
    // Logs declare no entities.
    XML_SetEntityDeclHandler(parser_.get(), &entity);
  }

  GivenPaths read(const std::string& bytes) {
    const XML_Status status =
        XML_Parse(parser_.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE);
    if (error_) throw *error_;
    if (status != XML_STATUS_OK) {
      throw InputError(file_, line(), "", XML_ErrorString(XML_GetErrorCode(parser_.get())));
    }
    if (!has_log_) throw InputError(file_, 0, "root/log", "missing: this file has no plan");
    if (off_ != 0) {
      read_.remarks.push_back("the durations of sections are off those of their paths by up to " +
                              number_text(round_nearest(off_)) + ", as rounded ones are");
    }
    return std::move(read_);
  }

 private:
  static LogReader& self(void* data) { return *static_cast<LogReader*>(data); }

  static void XMLCALL begin(void* data, const XML_Char* name, const XML_Char** attributes) {
    LogReader& reader = self(data);
    reader.place_ += std::string(name) + ">";
    reader.guarded([&] { reader.take(name, attributes); });
  }
  static void XMLCALL end(void* data, const XML_Char*) {
    LogReader& reader = self(data);
    reader.guarded([&] { reader.leave(); });
    reader.place_.pop_back();
    reader.place_.erase(reader.place_.rfind('>') + 1);
  }
  static void XMLCALL entity(void* data, const XML_Char*, int, const XML_Char*, int,
                             const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
    LogReader& reader = self(data);
    reader.guarded([&] { reader.fail("", "declares an entity"); });
  }

  // No exception may pass through expat.
  template <class Work>
  void guarded(Work&& work) {
    if (error_) return;
    try {
      work();
    } catch (const InputError& e) {
      error_ = std::make_unique<InputError>(e);
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  void take(const XML_Char* name, const XML_Char** attributes) {
    if (place_ == "root>agent>") {
      ++tasks_;
    } else if (place_ == "root>log>") {
      if (std::exchange(has_log_, true)) fail("log", "a second one");
    } else if (place_ == "root>log>agent>") {
      read_.paths.push_back({attribute(attributes, "number"), radius_, {}});
      if (!numbers_.insert(read_.paths.back().name).second) fail("number", "another agent has it");
    } else if (place_ == "root>log>agent>path>") {
      path_ = {};
      if (attribute_if_any(attributes, "duration")) path_.duration = number(attributes, "duration");
    } else if (place_ == "root>log>agent>path>section>") {
      take_section(attributes);
    } else if (place_ != "root>" && place_ != "root>log>summary>") {
      fail(printable(name), "a plan has no such element here");
    }
  }

  void leave() {
    if (place_ == "root>log>agent>path>") require_all_sections();
    if (place_ == "root>log>agent>" && read_.paths.back().waypoints.empty()) {
      fail("agent", "no section tells where it is");
    }
    if (place_ == "root>" && has_log_ && tasks_ != 0 && tasks_ != read_.paths.size()) {
      fail("agent", std::to_string(tasks_) + " in the task, and " +
                        std::to_string(read_.paths.size()) + " in the log");
    }
  }

  void take_section(const XML_Char** attributes) {
    std::vector<Waypoint>& way = read_.paths.back().waypoints;
    if (++sections_ > max_waypoints) fail("section", "too many");
    const Vec3 start{number(attributes, "start_i"), number(attributes, "start_j")};
    const Vec3 goal{number(attributes, "goal_i"), number(attributes, "goal_j")};
    const Rational duration = number(attributes, "duration");
    if (sgn(duration) < 0) fail("duration", "negative");
    if (attribute_if_any(attributes, "number") &&
        number(attributes, "number") != static_cast<int>(path_.sections)) {
      fail("number", "section " + std::to_string(path_.sections) + " is missing before");
    }
    ++path_.sections;
    path_.told += duration;
    if (way.empty()) way.push_back({0, start});
    if (start != way.back().at) {
      fail("start_i", "the section starts elsewhere than the one before ends");
    }
    if (sgn(duration) == 0) {
      if (goal != start) fail("duration", "0, and the agent moves");
      return;
    }
    way.push_back({Rational(way.back().t + duration), goal});
  }

  // A plan that lost a section is not the one that was made. Durations may be rounded to six
  // digits; what is off is told.
  void require_all_sections() {
    if (!path_.duration) return;
    const Rational off = abs(Rational(path_.told - *path_.duration));
    off_ = std::max(off_, off);
    if (off * 100'000 <= *path_.duration) return;
    fail("duration", "the path takes " + number_text(round_nearest(*path_.duration)) +
                         ", and its sections " + number_text(round_nearest(path_.told)));
  }

  static const char* attribute_if_any(const XML_Char** attributes, const char* name) {
    for (; *attributes != nullptr; attributes += 2) {
      if (std::string(attributes[0]) == name) return attributes[1];
    }
    return nullptr;
  }
  std::string attribute(const XML_Char** attributes, const char* name) const {
    if (const char* value = attribute_if_any(attributes, name)) return value;
    fail(name, "missing");
  }

  Rational number(const XML_Char** attributes, const char* name) const {
    std::string reason;
    const auto value = path_number(attribute(attributes, name), reason);
    if (!value) fail(name, reason);
    return *value;
  }

  std::int64_t line() const {
    return static_cast<std::int64_t>(XML_GetCurrentLineNumber(parser_.get()));
  }
  [[noreturn]] void fail(const std::string& field, const std::string& reason) const {
    throw InputError(file_, line(), field, reason);
  }

  const std::string& file_;
  const Rational& radius_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::unique_ptr<InputError> error_;
  std::string place_;  // the elements around, each with a ">"
  bool has_log_ = false;
  std::set<std::string> numbers_;
  std::size_t sections_ = 0, tasks_ = 0;
  // The path that is being read: how long it says that it takes, and what its sections say.
  struct Path {
    std::optional<Rational> duration;
    Rational told;
    std::size_t sections = 0;
  };
  Path path_;
  Rational off_;  // the greatest difference of these two so far
  GivenPaths read_;
};

}  // namespace

GivenPaths parse_ccbs_log(const std::string& bytes, const std::string& file,
                          const std::optional<Rational>& radius) {
  if (!radius) {
    throw InputError(file, 0, "radius", "a plan does not give that of its agents: give it");
  }
  GivenPaths read = LogReader(file, *radius).read(bytes);
  read.remarks.push_back("obstacles of the map are not in the plan, and not judged");
  return read;
}

}  // namespace voroproof::internal
