#include "apps/answers/diagram_claim.h"

#include <algorithm>
#include <charconv>

#include "exact/generators.h"
#include "history/disk_table.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/line_source.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 32;
constexpr std::size_t longest_line = std::size_t{1} << 12;
constexpr std::int64_t most_disks = 100'000'000;

class ClaimReader {
 public:
  ClaimReader(std::string_view bytes, const std::string& file) : json_(bytes, file) {}

  DiagramClaim read() {
    enum { format, version, frame, disks, vertices, edges, neighbours };
    static constexpr std::array<std::string_view, 7> names = {
        "format", "version", "frame", "disks", "vertices", "edges", "neighbours"};
    constexpr auto bit = JsonReader::bit;
    json_.object(names, bit(format) | bit(version) | bit(frame) | bit(disks),
                 [&](std::size_t member) {
                   switch (member) {
                     case format:
                       if (json_.text() != "voroproof-static-diagram") {
                         json_.fail("not \"voroproof-static-diagram\"");
                       }
                       break;
                     case version:
                       read_version(json_);
                       break;
                     case frame:
                       read_frame();
                       break;
                     case disks:
                       json_.array([&](std::size_t) { read_disk(); });
                       break;
                     case vertices:
                       claim_.vertices.emplace();
                       json_.array([&](std::size_t) { read_vertex(); });
                       break;
                     case edges:
                       claim_.edges.emplace();
                       json_.array([&](std::size_t) {
                         const auto [l, r, s, e] = ids<4>();
                         claim_.edges->push_back({l, r, s, e});
                       });
                       break;
                     case neighbours:
                       claim_.neighbours.emplace();
                       json_.array([&](std::size_t) { claim_.neighbours->push_back(ids<2>()); });
                   }
                 });
    json_.finish();
    // A file that names no hidden disk says nothing of them, but by its edges.
    if (hides_) claim_.hosts = hosts_;
    return std::move(claim_);
  }

 private:
  template <std::size_t N>
  std::array<int, N> ids() {
    std::array<int, N> all{};
    json_.array_of<N>([&](std::size_t k) {
      all[k] = static_cast<int>(json_.integer(container_id, most_disks - 1));
    });
    return all;
  }

  // The disks that are judged are those of the file: no number is rounded without a word.
  double number() {
    const Number n = json_.number();
    if (n.exact && *n.exact != to_rational(n.nearest)) json_.fail("not a binary64");
    return n.nearest;
  }

  // An object of a centre, a radius, and one field more, which `read_rest` reads.
  template <class ReadRest>
  Circle read_circle(std::string_view rest, bool needs_rest, const ReadRest& read_rest) {
    enum { center, radius, other };
    Circle circle;
    const std::array<std::string_view, 3> names = {"center", "radius", rest};
    const auto bit = JsonReader::bit;
    json_.object(names, bit(center) | bit(radius) | (needs_rest ? bit(other) : 0u),
                 [&](std::size_t member) {
                   if (member == center) {
                     json_.array_of<2>([&](std::size_t k) { circle.center[k] = number(); });
                   } else if (member == radius) {
                     circle.radius = number();
                   } else {
                     read_rest();
                   }
                 });
    return circle;
  }

  void read_frame() {
    if (json_.text_is_next()) {
      if (json_.text() != "none") json_.fail("neither \"none\" nor a circle nor a rectangle");
      return;
    }
    enum { center, radius, low, high };
    static constexpr std::array<std::string_view, 4> names = {"center", "radius", "low", "high"};
    constexpr auto bit = JsonReader::bit;
    Circle circle;
    Box walls;
    std::uint64_t seen = 0;
    json_.object(names, 0, [&](std::size_t member) {
      seen |= bit(member);
      if (member == radius) {
        circle.radius = number();
      } else {
        Vector& place = member == center ? circle.center : member == low ? walls.low : walls.high;
        json_.array_of<2>([&](std::size_t k) { place[k] = number(); });
      }
    });
    if (seen == (bit(center) | bit(radius))) {
      claim_.frame = circle;
    } else if (seen == (bit(low) | bit(high))) {
      claim_.walls = walls;
    } else {
      json_.fail("neither center and radius nor low and high");
    }
  }

  void read_disk() {
    hosts_.push_back(StaticDiagram::visible);
    claim_.disks.push_back(read_circle("hidden_by", false, [&] {
      hosts_.back() = static_cast<int>(json_.integer(container_id, most_disks - 1));
      hides_ = true;
    }));
  }

  void read_vertex() {
    std::array<int, 3> generators{};
    const Circle c = read_circle("generators", true, [&] { generators = ids<3>(); });
    claim_.vertices->push_back({generators, c.center, c.radius});
  }

  JsonReader json_;
  DiagramClaim claim_;
  std::vector<int> hosts_;
  bool hides_ = false;
};

// The generators of an edge, or of a pair, on a line.
std::vector<int> ids_of(std::string_view line, const std::string& path, std::int64_t number) {
  const auto is_between = [](char c) {
    return std::string_view(",;\t []\r").find(c) != std::string_view::npos;
  };
  std::vector<int> ids;
  const char* next = line.data();
  const char* const end = next + line.size();
  while (true) {
    next = std::find_if_not(next, end, is_between);
    if (next == end) break;
    int id = 0;
    const auto [rest, error] = std::from_chars(next, end, id);
    const bool is_whole = rest == end || is_between(*rest);
    if (error != std::errc() || !is_whole || id < container_id) {
      throw InputError(path, number, "", "not the number of a disk, or -1");
    }
    ids.push_back(id);
    next = rest;
  }
  if (ids.size() != 2 && ids.size() != 4) {
    throw InputError(path, number, "", "neither two numbers nor four");
  }
  return ids;
}

}  // namespace

DiagramFiles read_diagram_claim(const std::string& path) {
  const std::string bytes = file_bytes(path, most_bytes);
  return {ClaimReader(bytes, path).read(), sha256_hex(bytes)};
}

DiagramFiles read_diagram_claim(const std::string& table, const std::string& edges,
                                const std::optional<Circle>& frame,
                                const std::optional<Box>& walls) {
  DiagramFiles files;
  DiagramClaim& claim = files.claim;
  const DiskTable disks = read_disk_table(table);
  for (const TableDisk& d : disks.disks) claim.disks.push_back({{d.x, d.y}, d.radius});
  claim.frame = frame;
  claim.walls = walls;
  LineSource lines(edges);
  lines.keep_digest();
  std::size_t size = 0;
  while (const auto line = lines.next(longest_line)) {
    const bool has_digit =
        std::any_of(line->begin(), line->end(), [](char c) { return c >= '0' && c <= '9'; });
    const bool is_blank = line->find_first_not_of(" \t\r") == std::string_view::npos;
    if (is_blank || line->starts_with('#') || (lines.number() == 1 && !has_digit)) continue;
    const std::vector<int> ids = ids_of(*line, edges, lines.number());
    if (size == 0) {
      size = ids.size();
    } else if (size != ids.size()) {
      throw InputError(edges, lines.number(), "", "two numbers here, and four elsewhere");
    }
    if (size == 2) {
      if (!claim.neighbours) claim.neighbours.emplace();
      claim.neighbours->push_back({ids[0], ids[1]});
    } else {
      if (!claim.edges) claim.edges.emplace();
      claim.edges->push_back({ids[0], ids[1], ids[2], ids[3]});
    }
  }
  // An empty list is one of edges.
  if (!claim.neighbours && !claim.edges) claim.edges.emplace();
  files.sha256 = disks.sha256 + ' ' + lines.content_sha256();
  return files;
}

}  // namespace voroproof::internal
