#include "library/history_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "certify/fingerprint.h"
#include "history/byte_source.h"
#include "history/error.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/json_text.h"
#include "history/line_source.h"
#include "history/sha256.h"
#include "library/index_format.h"

namespace voroproof::internal {
namespace {

constexpr auto bit = JsonReader::bit;
constexpr std::size_t max_index_line = std::size_t{1} << 31;

std::int64_t read_count(JsonReader& json) {
  return json.integer(0, std::numeric_limits<std::int64_t>::max() / 4);
}

std::string read_hash(JsonReader& json) {
  std::string hash(json.text());
  if (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != std::string::npos) {
    json.fail("not 64 hexadecimal digits");
  }
  return hash;
}

struct Header {
  std::string producer, header_sha256;
  Rational tolerance;
  bool unoriented = false;
};

bool read_truth(JsonReader& json) {
  const std::string_view value = json.any();
  if (value != "true" && value != "false") json.fail("neither true nor false");
  return value == "true";
}

Header read_header(std::string_view text, const std::string& path) {
  JsonReader json(text, path);
  Header header;
  enum { format, version, producer, header_sha256, tolerance, unoriented };
  static constexpr std::array<std::string_view, 6> names = {
      "format", "version", "producer", "header_sha256", "tolerance", "unoriented"};
  json.object(names, (std::uint32_t{1} << names.size()) - 1, [&](std::size_t member) {
    switch (member) {
      case format:
        if (json.text() != index_format) {
          json.fail("not \"" + std::string(index_format) + "\"");
        }
        break;
      case version:
        read_version(json);
        break;
      case producer:
        header.producer = json.text();
        break;
      case header_sha256:
        header.header_sha256 = read_hash(json);
        break;
      case tolerance:
        header.tolerance = json.number().value();
        break;
      case unoriented:
        header.unoriented = read_truth(json);
    }
  });
  json.finish();
  return header;
}

IndexedCut read_cut(JsonReader& json) {
  IndexedCut at;
  Cut& cut = at.cut;
  enum { part, t, flips, collisions, maneuvers, line, offset, digest, state_sha256 };
  static constexpr std::array<std::string_view, 9> names = {
      "part", "t", "flips", "collisions", "maneuvers", "line", "offset", "digest", "state_sha256"};
  json.object(names, (std::uint32_t{1} << names.size()) - 1, [&](std::size_t member) {
    switch (member) {
      case part:
        cut.part = read_count(json);
        break;
      case t:
        cut.t = json.number().nearest;
        if (cut.t < 0) json.fail("negative");
        break;
      case flips:
        cut.claims.flips = read_count(json);
        break;
      case collisions:
        cut.claims.collisions = read_count(json);
        break;
      case maneuvers:
        cut.claims.maneuvers = read_count(json);
        break;
      case line:
        cut.line = read_count(json);
        break;
      case offset:
        cut.offset = read_count(json);
        break;
      case digest:
        at.digest = json.text();
        break;
      case state_sha256:
        cut.state_sha256 = read_hash(json);
    }
  });
  // At the beginning of the history there is nothing to know.
  if (cut.part == 0 || cut.offset == 0) json.fail("the beginning of the history");
  std::optional<Sha256> sha = Sha256::resumed(at.digest, cut.offset);
  if (!sha) json.fail("no state of SHA-256 in \"digest\"");
  cut.bytes_sha256 = sha->hex();
  return at;
}

struct End {
  std::int64_t bytes = 0, entries = 0;
};

End read_end(JsonReader& json) {
  End end;
  enum { bytes, entries };
  static constexpr std::array<std::string_view, 2> names = {"bytes", "entries"};
  json.object(names, bit(bytes) | bit(entries), [&](std::size_t member) {
    (member == bytes ? end.bytes : end.entries) = read_count(json);
  });
  return end;
}

// An entry, and the bytes of the history for which it stands: up to the next.
struct Entry : IndexEntry {
  std::int64_t until = 0;
  std::string sha256;
};

Entry read_entry(std::string_view text, const std::string& path, std::int64_t line) {
  JsonReader json(text, path, line);
  Entry entry;
  std::string state_text;
  enum { cut, until, sha256, told, state };
  static constexpr std::array<std::string_view, 5> names = {"cut", "until", "sha256", "told",
                                                            "state"};
  json.object(names, (std::uint32_t{1} << names.size()) - 1, [&](std::size_t member) {
    switch (member) {
      case cut:
        entry.at = read_cut(json);
        break;
      case until:
        entry.until = read_count(json);
        break;
      case sha256:
        entry.sha256 = read_hash(json);
        break;
      case told:
        entry.told = read_truth(json);
        break;
      case state:
        state_text = json.any();
    }
  });
  json.finish();
  entry.at.state = state_text;
  entry.at.file = path;
  entry.at.line = line;
  return entry;
}

}  // namespace

std::string sha256_of_stretch(const std::string& path, std::int64_t from, std::int64_t until) {
  ByteSource source(path);
  Sha256 sha;
  if (from > 0 && !source.skip_to(from))
    throw InputError(path, 0, "", "an index is of a plain file alone");
  std::string piece(std::size_t{1} << 18, '\0');
  while (from < until) {
    const auto wanted =
        std::min<std::int64_t>(until - from, static_cast<std::int64_t>(piece.size()));
    const std::size_t got = source.read(piece.data(), static_cast<std::size_t>(wanted));
    if (got == 0) break;
    sha.add(std::string_view(piece).substr(0, got));
    from += static_cast<std::int64_t>(got);
  }
  return sha.hex();
}

std::optional<IndexEntry> find_entry(const IndexFile& index, const Scene& scene,
                                     const HistoryHeader& header, const std::string& history_path,
                                     const CertifyOptions* options,
                                     const std::function<bool(const Cut&)>& is_early) {
  const std::string& path = index.path;
  const auto refuse = [&](std::int64_t line, const std::string& why) {
    throw InputError(path, line, "", why);
  };
  LineSource lines(path);
  const auto first = lines.next(max_event_line);
  if (!first) refuse(1, "empty file");
  const Header known =
      of_this_version(*first, path, index_format, [&] { return read_header(*first, path); });
  if (known.producer != index.producer) {
    refuse(1, "is by " + printable(known.producer) + ", and this is " + index.producer);
  }
  if (known.header_sha256 != fingerprint_of(scene, header)) {
    refuse(1, "is the index of another history than " + history_path);
  }
  const bool unoriented = options != nullptr && options->unoriented && !options->strict;
  if (known.unoriented != unoriented ||
      (options != nullptr && known.tolerance != options->tolerance)) {
    refuse(1, "is for the tolerance " + number_text(known.tolerance) +
                  (known.unoriented ? " with" : " without") + " --unoriented");
  }
  // Only the begin of each entry but one is looked at.
  std::string text;
  std::int64_t line = 0, entries = 0;
  std::optional<Cut> last;
  std::optional<End> end;
  bool early = true;
  while (const auto next = lines.next(max_index_line)) {
    if (end) refuse(lines.number(), "text after the last line of the index");
    JsonReader json(*next, path, lines.number());
    json.any_object([&](std::string_view name) {
      if (name == "end") {
        end = read_end(json);
      } else if (name == "cut") {
        const Cut cut = read_cut(json).cut;
        if (last && (cut.part <= last->part || cut.offset <= last->offset)) {
          json.fail("not behind the one before it");
        }
        if (cut.t > round_nearest(header.horizon)) json.fail("beyond the horizon");
        early = early && is_early(cut);
        if (early) {
          text = *next;
          line = lines.number();
        }
        last = cut;
        ++entries;
      } else {
        json.fail("neither an entry nor the last line of an index");
      }
      return false;
    });
  }
  if (!end || end->entries != entries) refuse(lines.number(), "incomplete");
  if (end->bytes != static_cast<std::int64_t>(ByteSource(history_path).known_size())) {
    refuse(lines.number(), "is the index of another history than " + history_path);
  }
  if (line == 0) return std::nullopt;
  Entry entry = read_entry(text, path, line);
  if (sha256_of_stretch(history_path, entry.at.cut.offset, entry.until) != entry.sha256) {
    refuse(line, "is of other bytes than those of " + history_path);
  }
  return entry;
}

std::optional<IndexedCut> find_start(const IndexFile& index, const Claim& claim,
                                     const std::string& history_path, const CertifyOptions& options,
                                     const ShardTask& task) {
  const HistoryHeader& header = claim.history->header();
  const double horizon = round_nearest(header.horizon);
  auto entry = find_entry(index, claim.scene, header, history_path, &options, [&](const Cut& cut) {
    return task.from ? cut.part <= task.from->part
                     : shard_of(cut.t, horizon, task.of) < task.number;
  });
  if (!entry) return std::nullopt;
  return std::move(entry->at);
}

std::optional<IndexEntry> go_on_before(const IndexFile& index, const Scene& scene,
                                       HistorySource& history, const std::string& history_path,
                                       const Rational& t) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // A claim before a cut may be later than the cut by the rounding of its time.
  auto entry = find_entry(index, scene, history.header(), history_path, nullptr, [&](const Cut& c) {
    return to_rational(std::nextafter(c.t, infinity)) <= t;
  });
  if (!entry) return std::nullopt;
  const Cut& cut = entry->at.cut;
  if (!history.skip_to({cut.offset, cut.line, cut.t, cut.claims})) {
    throw InputError(index.path, 0, "", "the history is none that can be read from the middle");
  }
  return entry;
}

std::optional<RecordedMoment> start_at_entry(const IndexFile& index, const Scene& scene,
                                             HistorySource& history,
                                             const std::string& history_path, const Rational& t) {
  const auto entry = go_on_before(index, scene, history, history_path, t);
  if (!entry) return std::nullopt;
  CertifyOptions options;
  options.truth = Truth::recorded;
  Replay replay(scene, options);
  replay.read(entry->at);
  RecordedMoment moment;
  if (entry->told) {
    moment.states.emplace();
    for (GenId g = 0; g < replay.disks(); ++g) {
      const Rational since = replay.path(g).since();
      moment.states->push_back({since, replay.path(g).at(since), replay.velocity(g).value()});
    }
  }
  moment.diagram = std::move(replay.diagram());
  return moment;
}

}  // namespace voroproof::internal
