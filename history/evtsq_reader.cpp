#include "history/evtsq_reader.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "history/error.h"
#include "history/event_limit.h"
#include "history/file_bytes.h"

namespace voroproof::internal {

namespace {

constexpr std::int64_t kMaxId = std::int64_t{1} << 40;
constexpr std::int64_t kMaxLines = std::int64_t{1} << 40;

// The decimal as it stands: a rational.
Rational decimal(const FieldLines& lines, std::string_view text, const char* name) {
  std::string reason;
  const auto value = parse_rational(text, &reason);
  if (!value) lines.fail(name, reason);
  return *value;
}

// Reads the header and leaves `lines` at the line with the number of events.
EvtsqHeader read_header(FieldLines& lines) {
  EvtsqHeader header;
  bool version = false, horizon = false, restitution = false;
  while (lines.next() && lines.line().starts_with('#')) {
    const std::string_view key = lines.field(0);
    // The rest of the line, which may have blanks.
    std::string_view value = lines.line().substr(key.size());
    value.remove_prefix(std::min(value.find_first_not_of(" \t"), value.size()));
    if (key == "#SOURCE:") {
      header.source = value;
    } else if (key == "#DVD_GENERATOR:") {
      header.generator = value;
    } else if (key == "#EVENT_SEQUENCE_FILE_FORMAT_VERSION:") {
      const Rational number = decimal(lines, value, "EVENT_SEQUENCE_FILE_FORMAT_VERSION");
      if (number != 1 && number != Rational(11, 10)) {
        lines.fail("EVENT_SEQUENCE_FILE_FORMAT_VERSION", "neither 1.0 nor 1.1");
      }
      header.has_centers = number != 1;
      version = true;
    } else if (key == "#SIMULATION_TIME:") {
      header.horizon = decimal(lines, value, "SIMULATION_TIME");
      if (header.horizon < 0) lines.fail("SIMULATION_TIME", "negative");
      if (header.horizon > to_rational(max_scene_value)) {
        lines.fail("SIMULATION_TIME", "beyond the limits of a scene");
      }
      horizon = true;
    } else if (key == "#RESTITUTION_COEFFICIENT:") {
      header.restitution = decimal(lines, value, "RESTITUTION_COEFFICIENT");
      if (header.restitution < 0 || header.restitution > 1) {
        lines.fail("RESTITUTION_COEFFICIENT", "not in [0, 1]");
      }
      restitution = true;
    } else if (key != "#TIME:") {
      lines.fail(std::string(key), "no field of the header of an event sequence");
    }
  }
  if (!version) lines.fail("EVENT_SEQUENCE_FILE_FORMAT_VERSION", "missing");
  if (!horizon) lines.fail("SIMULATION_TIME", "missing");
  if (!restitution) lines.fail("RESTITUTION_COEFFICIENT", "missing");
  header.lines = lines.integer(0, "number of events", 0, kMaxLines);
  if (lines.size() != 1) lines.fail("number of events", "more than one field");
  header.first_line = lines.number() + 1;
  return header;
}

// One event line: its letter, its numbers, its generators.
class EvtsqLines {
 public:
  EvtsqLines(const std::string& path, const EvtsqIds& ids) : lines_(path), ids_(ids) {
    source().keep_digest();
    header_ = read_header(lines_);
  }

  const EvtsqHeader& header() const { return header_; }
  std::int64_t number() const { return lines_.number(); }
  LineSource& source() { return lines_.source(); }
  std::int64_t offset() const { return lines_.offset(); }
  std::int64_t read() const { return read_; }
  char kind() const { return lines_.field(0)[0]; }
  [[noreturn]] void fail(const char* field, const std::string& reason) const {
    lines_.fail(field, reason);
  }

  // Moves to the next event; false after the last.
  bool next() {
    if (!lines_.next()) {
      if (read_ < header_.lines) {
        lines_.fail("", "incomplete: the file ends after " + std::to_string(read_) + " of " +
                            std::to_string(header_.lines) + " events");
      }
      return false;
    }
    ++read_;
    const std::string_view letter = lines_.field(0);
    if (letter == "T" || letter == "B") {
      lines_.fail("event", "hops between containers are not supported");
    }
    if (letter.size() != 1 || std::string_view("ESCV").find(letter[0]) == std::string_view::npos) {
      lines_.fail("event", "none of E, S, C and V");
    }
    // One way of writing numbers throughout the file.
    if (read_ == 1) hexadecimal_ = lines_.size() > 1 && is_hexadecimal(lines_.field(1));
    return true;
  }

  double value(std::size_t k, const char* name) const {
    return hexadecimal_ ? lines_.hexadecimal(k, name) : lines_.number(k, name);
  }

  GenId generator(std::size_t k, const char* name) {
    const std::int64_t id = lines_.integer(k, name, -1, kMaxId);
    if (id == -1) return container_id;
    if (!ids_) {
      const auto [it, is_new] = seen_.try_emplace(id, static_cast<GenId>(seen_.size()));
      if (is_new && seen_.size() > max_disks) lines_.fail(name, "more disks than a scene may have");
      return it->second;
    }
    const auto it = std::lower_bound(ids_->begin(), ids_->end(), id);
    if (it == ids_->end() || *it != id) lines_.fail(name, "no such disk");
    return static_cast<GenId>(it - ids_->begin());
  }

  void require_fields(std::initializer_list<std::size_t> counts) const {
    if (std::find(counts.begin(), counts.end(), lines_.size()) == counts.end()) {
      lines_.fail("", std::to_string(lines_.size()) + " fields are too few or too many");
    }
  }
  std::size_t fields() const { return lines_.size(); }

 private:
  FieldLines lines_;
  EvtsqHeader header_;
  EvtsqIds ids_;
  std::unordered_map<std::int64_t, GenId> seen_;  // where no ids are given
  bool hexadecimal_ = false;
  std::int64_t read_ = 0;
};

class EvtsqHistory : public HistorySource {
 public:
  EvtsqHistory(const std::string& path, const EvtsqIds& ids, const std::optional<Rational>& horizon,
               const std::string& sha256)
      : path_(path), lines_(path, ids), known_sha256_(sha256), keeps_digest_(!sha256.empty()) {
    const EvtsqHeader& h = lines_.header();
    header_.producer = h.generator;
    header_.horizon = h.horizon;
    header_.oriented = false;
    if (horizon && abs(Rational(*horizon - h.horizon)) <= evtsq_rounding()) {
      header_.horizon = *horizon;
    } else {
      header_.horizon_error = evtsq_rounding();
      remarks_.push_back("the file gives its horizon to two decimals only");
    }
    remarks_.push_back("the file gives no velocities after collisions");
    if (!h.has_centers) remarks_.push_back("the file gives no centres at collisions");
  }

  const EvtsqHeader& own_header() const { return lines_.header(); }
  const HistoryHeader& header() const override { return header_; }
  std::int64_t line() const override { return lines_.number(); }
  std::int64_t offset() const override { return lines_.offset(); }
  void keep_digest() override { keeps_digest_ = true; }
  void settle(std::int64_t offset) override { lines_.source().settle(offset); }
  Sha256 digest_up_to(std::int64_t offset) override { return lines_.source().digest_up_to(offset); }
  std::string content_sha256() override { return lines_.source().content_sha256(); }
  void require_unchanged() override {
    if (known_sha256_.empty()) return;
    // Once it was read to its end: so a stream does not keep us waiting.
    while (lines_.source().next(max_text_line)) {
    }
    if (content_sha256() == known_sha256_) return;
    throw InputError(path_, 0, "",
                     "has other bytes than when its header and velocity changes were read");
  }
  const std::variant<HistoryEnd, HistoryStop>& ending() const override { return ending_; }
  const HistoryCounts& counts() const override { return counts_; }
  bool counts_match() const override { return lines_.read() == lines_.header().lines; }
  std::vector<std::string> remarks() const override { return remarks_; }

  std::optional<Event> next() override {
    if (!keeps_digest_) lines_.source().drop_digest();
    while (lines_.next()) {
      const double t = lines_.value(1, "t");
      if (t < last_t_) lines_.fail("t", "earlier than the event before it");
      if (to_rational(t) > header_.horizon + evtsq_rounding())
        lines_.fail("t", "beyond the horizon");
      last_t_ = t;
      switch (lines_.kind()) {
        case 'S':
          shadows_.push_back({t, quad(), lines_.number()});
          break;
        case 'E':
          return counted(counts_.flips, FlipEvent{t, quad()});
        case 'C':
          return counted(counts_.collisions, collision(t));
        default:
          return counted(counts_.maneuvers, maneuver(t));
      }
    }
    ending_ = HistoryEnd{counts_};
    return std::nullopt;
  }

  std::optional<std::int64_t> shadow_line(const Quad& q, double lo, double hi) const override {
    const auto first = std::lower_bound(shadows_.begin(), shadows_.end(), lo,
                                        [](const Shadow& s, double t) { return s.t < t; });
    for (auto it = first; it != shadows_.end() && it->t <= hi; ++it) {
      const Quad swapped = canonical(Quad{q.l, q.r, q.e, q.s});
      if (it->quad == canonical(q) || it->quad == swapped) return it->line;
    }
    return std::nullopt;
  }

 private:
  struct Shadow {
    double t;
    Quad quad;
    std::int64_t line;
  };

  Event counted(std::int64_t& count, Event event) {
    ++count;
    EventLimit::check(counts_);
    return event;
  }

  // l r h k: head h and tail k are the third generators of the end and of the start.
  Quad quad() {
    lines_.require_fields({6});
    const Quad q{lines_.generator(2, "l"), lines_.generator(3, "r"), lines_.generator(5, "k"),
                 lines_.generator(4, "h")};
    // Only the third generators may be the same.
    if (q.l == q.r || q.l == q.s || q.l == q.e || q.r == q.s || q.r == q.e) {
      lines_.fail("", "a generator stands twice in the quadruplet");
    }
    return canonical(q);
  }

  CollideEvent collision(double t) {
    CollideEvent c;
    c.t = t;
    lines_.require_fields({4, 8});
    c.i = lines_.generator(2, "i");
    c.j = lines_.generator(3, "j");
    if (c.i == c.j) lines_.fail("j", "the same generator twice");
    if (lines_.fields() == 8) {
      c.p[0] = Vec2{lines_.value(4, "xi"), lines_.value(5, "yi")};
      c.p[1] = Vec2{lines_.value(6, "xj"), lines_.value(7, "yj")};
    }
    if (c.j < c.i) {
      std::swap(c.i, c.j);
      std::swap(c.p[0], c.p[1]);
    }
    if (c.i == container_id) c.p[0].reset();
    return c;
  }

  ManeuverEvent maneuver(double t) {
    ManeuverEvent m;
    m.t = t;
    lines_.require_fields({5, 7});
    m.disk = lines_.generator(2, "i");
    if (m.disk == container_id) lines_.fail("i", "the container does not move");
    m.v = Vec2{lines_.value(3, "vx"), lines_.value(4, "vy")};
    if (lines_.fields() == 7) m.p = Vec2{lines_.value(5, "x"), lines_.value(6, "y")};
    return m;
  }

  std::string path_;
  EvtsqLines lines_;
  std::string known_sha256_;
  bool keeps_digest_;
  HistoryHeader header_;
  std::vector<std::string> remarks_;
  double last_t_ = 0;
  HistoryCounts counts_;
  std::vector<Shadow> shadows_;
  std::variant<HistoryEnd, HistoryStop> ending_;
};

}  // namespace

bool is_evtsq_file(const std::string& path) {
  const std::string beginning = file_bytes(path, 4096, true);
  // Disk files begin with comments too.
  return beginning.starts_with('#') &&
         beginning.find("#EVENT_SEQUENCE_FILE_FORMAT_VERSION:") != std::string::npos;
}

EvtsqSetting read_evtsq_setting(const std::string& path, const std::vector<std::int64_t>& ids) {
  EvtsqLines lines(path, ids);
  std::vector<Maneuver> maneuvers;
  while (lines.next()) {
    if (lines.kind() != 'V') continue;
    if (maneuvers.size() == max_maneuvers) lines.fail("", "too many velocity changes");
    lines.require_fields({5, 7});
    const GenId disk = lines.generator(2, "i");
    if (disk == container_id) lines.fail("i", "the container does not move");
    maneuvers.push_back({to_rational(lines.value(1, "t")), disk, to_rational(lines.value(3, "vx")),
                         to_rational(lines.value(4, "vy"))});
  }
  return {lines.header(), std::move(maneuvers), lines.source().content_sha256()};
}

EventSequence open_evtsq(const std::string& path, const EvtsqIds& ids,
                         const std::optional<Rational>& horizon, const std::string& sha256) {
  auto history = std::make_unique<EvtsqHistory>(path, ids, horizon, sha256);
  const EvtsqHeader header = history->own_header();
  return {header, std::move(history)};
}

}  // namespace voroproof::internal
