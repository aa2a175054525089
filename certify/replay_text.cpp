// A replay from the text that an index beside a history keeps of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "certify/fingerprint.h"
#include "certify/replay.h"
#include "history/error.h"
#include "history/json_reader.h"

namespace voroproof::internal {
namespace {

double read_double(JsonReader& json) {
  const Number x = json.number();
  if (x.exact) json.fail("not a number");
  return x.nearest;
}

// A rational of any size that a string may have.
Rational read_rational(JsonReader& json) {
  const std::string text(json.text());
  const std::size_t slash = text.find('/');
  const auto is_integer = [](std::string_view digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::string_view all = text;
  const std::string_view numerator = all.substr(0, slash);
  const bool negative = numerator.starts_with('-');
  Rational x;
  if (!is_integer(numerator.substr(negative)) ||
      (slash != std::string::npos && !is_integer(all.substr(slash + 1))) ||
      x.set_str(text, 10) != 0 || x.get_den() == 0) {
    json.fail("not a fraction");
  }
  x.canonicalize();
  return x;
}

std::vector<int> read_integers(JsonReader& json, int low, int high) {
  std::vector<int> all;
  json.array([&](std::size_t) { all.push_back(static_cast<int>(json.integer(low, high))); });
  return all;
}

}  // namespace

DyadicSum DyadicSum::read(JsonReader& json) {
  std::array<double, kMax> parts{};  // smallest first
  int count = 0;
  json.array([&](std::size_t k) {
    if (k == kMax) json.fail("too many parts");
    const double part = read_double(json);
    // Where parts overlap, the bounds of errors would be false.
    const double size = std::fabs(part), last_place = std::nextafter(size, HUGE_VAL) - size;
    if (part == 0 || (k > 0 && !(std::fabs(parts[k - 1]) <= last_place))) {
      json.fail("parts that overlap");
    }
    parts[k] = part;
    ++count;
  });
  DyadicSum sum;
  std::reverse_copy(parts.begin(), parts.begin() + count, sum.part_.begin());
  return sum;
}

// One disk: [changed, turns, at container, vx, vy, t, x, y].
void Replay::read_disk(JsonReader& json, std::size_t g) {
  std::array<CompactRational, 2> v;
  Rational exact_t;
  double t = 0;
  bool exact = false;
  ExactVec2 p;
  std::array<DyadicSum, 2> sums;
  json.array_of<8>([&](std::size_t k) {
    switch (k) {
      case 0:
        turns_[g + 1].last = static_cast<int>(json.integer(0, std::numeric_limits<int>::max()));
        break;
      case 1:
        turns_[g + 1].count = static_cast<int>(json.integer(0, std::numeric_limits<int>::max()));
        break;
      case 2:
        turns_[g + 1].at_container = json.integer(0, 1) == 1;
        break;
      case 3:
      case 4:
        v[k - 3] = json.number().value();
        break;
      case 5:
        exact = json.text_is_next();
        if (exact) {
          exact_t = read_rational(json);
        } else {
          t = read_double(json);
        }
        break;
      default:
        if (exact) {
          p[k - 6] = read_rational(json);
        } else {
          sums[k - 6] = DyadicSum::read(json);
        }
    }
  });
  velocities_[g] = Velocity(v[0], v[1]);
  paths_[g] = exact ? Path(exact_t, p, velocities_[g]) : Path(t, sums[0], sums[1], velocities_[g]);
}

void Replay::read_text(JsonReader& json) {
  enum { origins, previous, anchors, disks, changes, next_maneuver, done_maneuvers };
  static constexpr std::array<std::string_view, 7> names = {
      "origins", "previous", "anchors", "disks", "changes", "next_maneuver", "done_maneuvers"};
  constexpr std::uint32_t all = (std::uint32_t{1} << names.size()) - 1;
  const int ids = static_cast<int>(paths_.size()), halves = 6 * ids;
  const auto maneuvers = static_cast<std::int64_t>(scene_->maneuvers.size());
  std::vector<int> org, before, first;
  json.object(names, all, [&](std::size_t member) {
    switch (member) {
      case origins:
        org = read_integers(json, container_id, ids - 1);
        break;
      case previous:
        before = read_integers(json, 0, std::max(0, halves - 1));
        break;
      case anchors:
        first = read_integers(json, -1, std::max(0, halves - 1));
        break;
      case disks: {
        const std::size_t count = json.array([&](std::size_t g) {
          if (g >= paths_.size()) json.fail("more disks than the scene has");
          read_disk(json, g);
        });
        if (count != paths_.size()) json.fail("fewer disks than the scene has");
        break;
      }
      case changes:
        changes_ = static_cast<int>(json.integer(0, std::numeric_limits<int>::max()));
        break;
      case next_maneuver:
        next_maneuver_ = static_cast<std::size_t>(json.integer(0, maneuvers));
        break;
      case done_maneuvers:
        done_maneuvers_.clear();
        json.array([&](std::size_t) {
          done_maneuvers_.insert(static_cast<std::size_t>(json.integer(0, maneuvers - 1)));
        });
    }
  });
  json.finish();
  try {
    diagram_ = numbered_diagram(ids, org, before, first);
  } catch (const std::invalid_argument& fault) {
    json.fail_in("state", fault.what());
  }
}

void Replay::read(const IndexedCut& at) {
  JsonReader json(at.state, at.file, at.line);
  read_text(json);
  Fingerprint fingerprint;
  add_to(fingerprint);
  if (fingerprint.hex() != at.cut.state_sha256) {
    throw InputError(at.file, at.line, "cut.state_sha256", "is not that of the state");
  }
}

}  // namespace voroproof::internal
