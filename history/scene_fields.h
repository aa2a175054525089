// The members that scenes of all kinds have (docs/formats.md, sections 4, 20 and 21), read in one
// way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "exact/rational.h"
#include "history/error.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/scene.h"
#include "history/scene_value.h"

namespace voroproof::internal {

// Base of the readers of one kind each. Functions throw InputError at what is next in the file.
class SceneFields {
 protected:
  SceneFields(std::string_view bytes, const std::string& file, std::int64_t version_wanted)
      : file_(file), json_(bytes, file), version_(version_wanted) {}

  static constexpr auto bit = JsonReader::bit;

  // They come first in each reader's list of names.
  enum CommonMember { format, version, name, comment, seed, horizon, first_other };
  void read_common(std::size_t member) {
    switch (member) {
      case format:
        if (json_.text() != "voroproof-scene") json_.fail("not \"voroproof-scene\"");
        break;
      case version:
        read_version(json_, version_);
        break;
      case name:
        name_ = json_.text();
        break;
      case comment:
        comment_ = json_.text();
        break;
      case seed:
        seed_ = read_seed(json_);
        break;
      case horizon:
        read_time(horizon_);
    }
  }
  template <class Titled>
  void give_title(Titled& scene) {
    scene.name = std::move(name_);
    scene.comment = std::move(comment_);
    scene.seed = std::move(seed_);
  }

  CompactRational value() { return scene_value(json_); }
  void read_time(Rational& t) {
    t = value();
    if (t < 0) json_.fail("negative");
  }
  template <class Number>
  void read_radius(Number& radius) {
    radius = value();
    if (sgn(radius) < 0) json_.fail("negative");
  }
  template <class Number>
  void read_pair(Number& x, Number& y) {
    json_.array_of<2>([&](std::size_t i) { (i == 0 ? x : y) = value(); });
  }
  void read_restitution(Rational& e) {
    e = value();
    if (e < 0 || e > 1) json_.fail("not in [0, 1]");
  }
  // A frame's: without one nothing would part from it.
  void read_positive_restitution(Rational& e) {
    e = value();
    if (e <= 0 || e > 1) json_.fail("not in (0, 1]");
  }

  // Moves to the object that is next, for its line.
  std::int64_t line_of_object() {
    json_.array_is_next();
    return json_.line();
  }

  // Before the members of the next disk or maneuver, which has that index.
  void begin_disk(std::size_t index) {
    if (index >= max_disks) json_.fail("more than " + std::to_string(max_disks) + " disks");
    disk_lines_.push_back(line_of_object());
  }
  void begin_maneuver(std::size_t index) {
    if (index >= max_maneuvers)
      json_.fail("more than " + std::to_string(max_maneuvers) + " maneuvers");
    maneuver_lines_.push_back(line_of_object());
  }
  // The time and the disk of a maneuver; `before`: those that have been read.
  template <class Maneuvers>
  void read_maneuver_time(Rational& t, const Maneuvers& before) {
    read_time(t);
    if (!before.empty() && t < before.back().t) json_.fail("earlier than the maneuver before it");
  }
  int read_maneuver_disk() { return static_cast<int>(json_.integer(0, max_disks - 1)); }

  // Each is of one of so many disks, and there is one of a disk at a time. Calls check(k, maneuver)
  // for what else is wanted of it.
  template <class Maneuvers, class Check>
  void check_maneuvers(const Maneuvers& maneuvers, std::size_t disks, Check&& check) const {
    std::vector<const Rational*> last(disks);  // when the disk's last one was
    for (std::size_t k = 0; k < maneuvers.size(); ++k) {
      const auto disk = static_cast<std::size_t>(maneuvers[k].disk);
      if (disk >= disks) fail_in_maneuver(k, "disk", "no such disk");
      check(k, maneuvers[k]);
      if (last[disk] != nullptr && *last[disk] == maneuvers[k].t)
        fail_in_maneuver(k, "disk", "second maneuver of one disk at one time");
      last[disk] = &maneuvers[k].t;
    }
  }

  [[noreturn]] void fail_in_disk(std::size_t k, const std::string& member,
                                 const std::string& why) const {
    const std::string field = "disks[" + std::to_string(k) + ']';
    throw InputError(file_, disk_lines_[k], member.empty() ? field : field + '.' + member, why);
  }
  [[noreturn]] void fail_in_maneuver(std::size_t k, const char* member,
                                     const std::string& why) const {
    throw InputError(file_, maneuver_lines_[k], "maneuvers[" + std::to_string(k) + "]." + member,
                     why);
  }

  const std::string& file_;
  JsonReader json_;
  Rational horizon_;

 private:
  std::int64_t version_;
  std::string name_, comment_;
  std::optional<std::variant<std::string, Integer>> seed_;
  std::vector<std::int64_t> disk_lines_, maneuver_lines_;  // lines of the opening braces
};

}  // namespace voroproof::internal
