#include "apps/run/kept_file.h"

#include <array>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "history/error.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/json_text.h"
#include "history/line_source.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 28;
constexpr std::int64_t largest = std::int64_t{1} << 62;

template <std::size_t N>
constexpr std::uint32_t all(const std::array<std::string_view, N>& names) {
  return (std::uint32_t{1} << names.size()) - 1;
}

// ---- Numbers of many bits: their digits, an exponent, and a radius as a number and an exponent.

std::string hexadecimal(mp_limb_t limb) {
  std::array<char, 16> digits;
  digits.fill('0');
  std::array<char, 16> shortest;
  const auto end = std::to_chars(shortest.begin(), shortest.end(), limb, 16).ptr;
  std::copy(shortest.begin(), end, digits.end() - (end - shortest.begin()));
  return {digits.begin(), digits.end()};
}

std::string ball_text(const Ball& b) {
  const Ball::Digits d = b.digits();
  std::string out = d.negative ? "[\"-" : "[\"";
  for (mp_size_t k = d.size; k-- > 0;) out += hexadecimal(d.limbs[k]);
  const Magnitude radius = b.radius();
  const std::int64_t e = radius.is_zero() ? 0 : radius.exponent();
  const double leading = radius.is_zero() ? 0 : radius.scaled(-e).to_double();
  return out + "\"," + std::to_string(d.exponent) + ',' + number_text(leading) + ',' +
         std::to_string(e) + ']';
}

Ball read_ball(JsonReader& json, Ball::Precision bits) {
  std::vector<mp_limb_t> limbs;
  bool negative = false;
  std::int64_t exponent = 0, radius_exponent = 0;
  double radius = 0;
  json.array_of<4>([&](std::size_t k) {
    if (k == 0) {
      std::string_view text = json.text();
      negative = text.starts_with('-');
      if (negative) text.remove_prefix(1);
      if (text.size() % 16 != 0) json.fail("not the digits of a number");
      for (std::size_t at = text.size(); at > 0; at -= 16) {
        const std::string_view piece = text.substr(at - 16, 16);
        const auto read =
            std::from_chars(piece.data(), piece.data() + 16, limbs.emplace_back(), 16);
        if (read.ptr != piece.data() + 16) json.fail("not the digits of a number");
      }
    } else if (k == 2) {
      radius = json.number().nearest;
    } else {
      (k == 1 ? exponent : radius_exponent) = json.integer(-largest, largest);
    }
  });
  if (radius < 0) json.fail("negative");
  const Magnitude error = radius == 0 ? Magnitude() : Magnitude::of(radius).scaled(radius_exponent);
  if (limbs.empty()) {
    Ball zero(bits);
    zero.widen(error);
    return zero;
  }
  const auto size = static_cast<mp_size_t>(limbs.size());
  return {limbs.data(), size,  exponent,
          negative,     error, std::max<Ball::Precision>(bits, 64 * size)};
}

// ---- Lists. ----

template <class Numbers>
std::string list_text(const Numbers& numbers) {
  std::string out = "[";
  for (const auto& number : numbers) {
    if (out.size() > 1) out += ',';
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(number)>>) {
      out += number_text(number);
    } else {
      out += std::to_string(number);
    }
  }
  return out + ']';
}

std::string diagram_text(const std::vector<Quad>& edges) {
  std::string out = "{\"diagram\":[";
  const char* separator = "";
  for (const Quad& q : edges) {
    out += separator + list_text(std::array<int, 4>{q.l, q.r, q.s, q.e});
    separator = ",";
  }
  return out + "]}\n";
}

std::uint64_t read_count(JsonReader& json) {
  return static_cast<std::uint64_t>(json.integer(0, largest));
}

// ---- The lines. ----

std::string member(const char* name, const std::string& value) {
  return ",\"" + std::string(name) + "\":" + value;
}

std::string header_text(const KeptFile& kept, const HistoryHeader& header) {
  const KeptRun& run = kept.run;
  const EngineStats& stats = run.stats;
  const std::array<std::uint64_t, 2> collisions{stats.disk_collisions, stats.wall_collisions};
  return "{\"format\":\"" + std::string(kept_format) + "\",\"version\":1" +
         member("producer", string_text(header.producer)) +
         member("scene_sha256", string_text(header.scene_sha256)) +
         member("horizon", number_text(header.horizon)) +
         member("bytes", std::to_string(kept.history.bytes)) +
         member("sha256", string_text(kept.history.sha256)) + member("t", number_text(run.t0)) +
         member("last", number_text(run.last)) +
         ",\"events\":{\"flips\":" + list_text(stats.flips) +
         member("collisions", list_text(collisions)) +
         member("maneuvers", std::to_string(stats.maneuvers)) +
         member("settling_flips", std::to_string(stats.settling_flips)) + "}" +
         member("divisions", list_text(run.divisions)) +
         ",\"precision\":{\"goal\":" + std::to_string(run.goal_bits) +
         member("per_time", number_text(run.bits_per_time)) +
         member("bits", std::to_string(run.bits)) + member("v_scale", std::to_string(run.v_scale)) +
         "}}\n";
}

void read_events(JsonReader& json, EngineStats& stats) {
  enum { flips, collisions, maneuvers, settling_flips };
  static constexpr std::array<std::string_view, 4> names = {"flips", "collisions", "maneuvers",
                                                            "settling_flips"};
  json.object(names, all(names), [&](std::size_t member) {
    switch (member) {
      case flips:
        json.array_of<static_cast<int>(FlipKind::count)>(
            [&](std::size_t k) { stats.flips[k] = read_count(json); });
        break;
      case collisions:
        json.array_of<2>([&](std::size_t k) {
          (k == 0 ? stats.disk_collisions : stats.wall_collisions) = read_count(json);
        });
        break;
      default:
        (member == maneuvers ? stats.maneuvers : stats.settling_flips) = read_count(json);
    }
  });
}

void read_precision(JsonReader& json, KeptRun& run) {
  enum { goal, per_time, bits, v_scale };
  static constexpr std::array<std::string_view, 4> names = {"goal", "per_time", "bits", "v_scale"};
  json.object(names, all(names), [&](std::size_t member) {
    switch (member) {
      case goal:
        run.goal_bits = static_cast<int>(json.integer(1, 1 << 30));
        break;
      case per_time:
        run.bits_per_time = json.number().nearest;
        break;
      case bits:
        run.bits = json.integer(2, 1 << 30);
        break;
      case v_scale:
        run.v_scale = json.integer(-largest, largest);
    }
  });
}

// False where the file is of another run.
bool read_header(JsonReader& json, const HistoryHeader& header, KeptFile& kept) {
  enum { format, version, producer, scene, horizon, bytes, sha256, t, last, events, divisions };
  static constexpr std::array<std::string_view, 12> names = {
      "format", "version", "producer", "scene_sha256", "horizon",   "bytes",
      "sha256", "t",       "last",     "events",       "divisions", "precision"};
  KeptRun& run = kept.run;
  bool same = true;
  json.object(names, all(names), [&](std::size_t member) {
    switch (member) {
      case format:
        if (json.text() != kept_format) json.fail("another format");
        break;
      case version:
        read_version(json);
        break;
      case producer:
        same = json.text() == header.producer && same;
        break;
      case scene:
        same = json.text() == header.scene_sha256 && same;
        break;
      case horizon:
        same = json.number().value() == header.horizon && same;
        break;
      case bytes:
        kept.history.bytes = json.integer(1, largest);
        break;
      case sha256:
        kept.history.sha256 = json.text();
        break;
      case t:
      case last:
        (member == t ? run.t0 : run.last) = json.number().nearest;
        break;
      case events:
        read_events(json, run.stats);
        break;
      case divisions:
        json.array([&](std::size_t) {
          run.divisions.push_back(static_cast<int>(json.integer(0, 1 << 30)));
        });
        break;
      default:
        read_precision(json, run);
    }
  });
  run.events = static_cast<std::uint64_t>(kept.counts().all());
  return same;
}

KeptDisk read_disk(JsonReader& json, int disks, Ball::Precision bits) {
  KeptDisk d;
  enum { disk, state, t, x, y, vx, vy };
  static constexpr std::array<std::string_view, 7> names = {"disk", "state", "t", "x",
                                                            "y",    "vx",    "vy"};
  json.object(names, all(names), [&](std::size_t member) {
    switch (member) {
      case disk:
        d.disk = static_cast<GenId>(json.integer(0, disks - 1));
        break;
      case state:
        d.state = static_cast<int>(json.integer(1, 1 << 30));
        break;
      case t:
        d.t = json.number().nearest;
        break;
      default:
        (member == x    ? d.x
         : member == y  ? d.y
         : member == vx ? d.vx
                        : d.vy) = read_ball(json, bits);
    }
  });
  return d;
}

InelasticCollapse::Past read_past(JsonReader& json) {
  InelasticCollapse::Past past;
  enum { at_wall, times };
  static constexpr std::array<std::string_view, 2> names = {"at_wall", "times"};
  json.object(names, all(names), [&](std::size_t member) {
    if (member == at_wall) {
      past.at_wall = static_cast<int>(json.integer(0, 1 << 30));
    } else {
      json.array([&](std::size_t) { past.times.push_back(json.number().nearest); });
    }
  });
  return past;
}

void read_diagram(JsonReader& json, int disks, KeptRun& run) {
  static constexpr std::array<std::string_view, 1> names = {"diagram"};
  json.object(names, all(names), [&](std::size_t) {
    json.array([&](std::size_t) {
      std::array<int, 4> q{};
      json.array_of<4>(
          [&](std::size_t k) { q[k] = static_cast<int>(json.integer(container_id, disks - 1)); });
      run.diagram.push_back({q[0], q[1], q[2], q[3]});
    });
  });
}

std::string end_text(const std::string& sha256) { return "{\"end\":\"" + sha256 + "\"}"; }

// Whether the last line says that the lines before it are whole.
bool is_whole(const std::string& path) {
  LineSource lines(path);
  Sha256 sha;
  std::string end;
  while (const auto line = lines.next(longest_line)) {
    if (!end.empty()) return false;
    if (line->starts_with("{\"end\"")) {
      end = *line;
    } else {
      sha.add(*line);
      sha.add("\n");
    }
  }
  return end == end_text(sha.hex());
}

}  // namespace

HistoryCounts KeptFile::counts() const {
  HistoryCounts counts;
  counts.flips = static_cast<std::int64_t>(run.stats.flip_count());
  counts.collisions =
      static_cast<std::int64_t>(run.stats.disk_collisions + run.stats.wall_collisions);
  counts.maneuvers = static_cast<std::int64_t>(run.stats.maneuvers);
  return counts;
}

std::string kept_text(const KeptFile& kept, const HistoryHeader& header) {
  std::string out = header_text(kept, header) + diagram_text(kept.run.diagram);
  for (const KeptDisk& d : kept.run.disks) {
    out += "{\"disk\":" + std::to_string(d.disk) + ",\"state\":" + std::to_string(d.state) +
           ",\"t\":" + number_text(d.t) + ",\"x\":" + ball_text(d.x) + ",\"y\":" + ball_text(d.y) +
           ",\"vx\":" + ball_text(d.vx) + ",\"vy\":" + ball_text(d.vy) + "}\n";
  }
  for (const InelasticCollapse::Past& past : kept.run.collapses) {
    out += "{\"at_wall\":" + std::to_string(past.at_wall) + ",\"times\":" + list_text(past.times) +
           "}\n";
  }
  return out + end_text(sha256_hex(out)) + '\n';
}

std::optional<KeptFile> read_kept(const std::string& path, const HistoryHeader& header, int disks) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  try {
    if (!is_whole(path)) return std::nullopt;
    KeptFile kept;
    LineSource lines(path);
    while (const auto line = lines.next(longest_line)) {
      JsonReader json(*line, path, lines.number());
      if (line->starts_with("{\"end\"")) break;
      if (lines.number() == 1) {
        if (!read_header(json, header, kept)) return std::nullopt;
      } else if (lines.number() == 2) {
        read_diagram(json, disks, kept.run);
      } else if (line->starts_with("{\"disk\"")) {
        kept.run.disks.push_back(read_disk(json, disks, kept.run.bits));
      } else {
        kept.run.collapses.push_back(read_past(json));
      }
    }
    return kept;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace voroproof::internal
