#include "history/history_writer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "history/byte_source.h"
#include "history/error.h"
#include "history/history_reader.h"
#include "history/json_text.h"
#include "history/output_file.h"

namespace voroproof::internal {
namespace {

// The longest event line: a collision with nine numbers, two ids and its keys.
constexpr std::size_t max_written_line = 10 * max_double_text + 256;
static_assert(max_written_line <= OutputFile::max_room);

template <std::size_t N>
char* put_literal(char* out, const char (&text)[N]) {
  return std::copy(text, text + N - 1, out);
}

char* put_quad(char* out, const Quad& quad) {
  const Quad q = canonical(quad);
  *out++ = '[';
  out = put_integer(out, q.l);
  *out++ = ',';
  out = put_integer(out, q.r);
  *out++ = ',';
  out = put_integer(out, q.s);
  *out++ = ',';
  out = put_integer(out, q.e);
  *out++ = ']';
  return out;
}

char* put_vector(char* out, const std::optional<Vec2>& v) {
  if (!v) return put_literal(out, "null");
  *out++ = '[';
  out = put_number(out, (*v)[0]);
  *out++ = ',';
  out = put_number(out, (*v)[1]);
  *out++ = ']';
  return out;
}

char* put_vectors(char* out, const std::array<std::optional<Vec2>, 2>& v) {
  *out++ = '[';
  out = put_vector(out, v[0]);
  *out++ = ',';
  out = put_vector(out, v[1]);
  *out++ = ']';
  return out;
}

// The members "flip", "collide", "maneuver" of an event.
char* put_kind(char* out, const FlipEvent& event) {
  return put_quad(put_literal(out, "\"flip\":"), event.quad);
}

char* put_kind(char* out, const CollideEvent& event) {
  out = put_literal(out, "\"collide\":[");
  out = put_integer(out, event.i);
  *out++ = ',';
  out = put_integer(out, event.j);
  *out++ = ']';
  return out;
}

char* put_kind(char* out, const ManeuverEvent& event) {
  return put_integer(put_literal(out, "\"maneuver\":"), event.disk);
}

char* put_time(char* out, double t) {
  out = put_number(put_literal(out, "{\"t\":"), t);
  *out++ = ',';
  return out;
}

// Whether the values are given in the one way the format knows: for both disks or for neither.
bool well_formed(const CollideEvent& event, const std::array<std::optional<Vec2>, 2>& values) {
  return event.i == container_id ? !values[0] : values[0].has_value() == values[1].has_value();
}

bool says_complete(const std::string& last_line, const std::string& path) {
  bool complete = false;
  try {
    JsonReader json(last_line, path);
    json.any_object([&](std::string_view name) {
      complete |= name == "end";
      json.any();
      return true;
    });
  } catch (const InputError&) {
    return false;
  }
  return complete;
}

// The last line of a compressed file is known once all of it is read.
bool ends_as_complete(const std::string& path) {
  try {
    LineSource lines(path);
    std::string last;
    while (const auto line = lines.next(max_header_line)) {
      if (line->find_first_not_of(" \t\r") != std::string_view::npos) last = *line;
    }
    return says_complete(last, path);
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

HistoryWriter::HistoryWriter(const std::string& path) : path_(path), file_(path) {}

void HistoryWriter::header(const HistoryHeader& header) {
  put(header, header.initial ? &*header.initial : nullptr);
}

void HistoryWriter::header(const HistoryHeader& header, const std::vector<Quad>& initial) {
  put(header, &initial);
}

void HistoryWriter::put(const HistoryHeader& header, const std::vector<Quad>* initial) {
  require(State::fresh);
  state_ = State::open;
  horizon_ = number_text(header.horizon);
  file_.write("{\"format\":\"voroproof-history\",\"version\":1,\"scene_sha256\":" +
              string_text(header.scene_sha256) + ",\"horizon\":" + horizon_ +
              ",\"producer\":" + string_text(header.producer));
  if (initial != nullptr) {
    // Mostly they are as they are written: large diagrams are not copied for it.
    std::vector<Quad> put_right;
    const std::vector<Quad>* edges = initial;
    const auto is_canonical = [](const Quad& q) { return q == canonical(q); };
    if (!std::all_of(edges->begin(), edges->end(), is_canonical) ||
        !std::is_sorted(edges->begin(), edges->end())) {
      put_right = *edges;
      for (Quad& edge : put_right) edge = canonical(edge);
      std::sort(put_right.begin(), put_right.end());
      edges = &put_right;
    }
    const char* separator = ",\"initial\":[";
    for (const Quad& edge : *edges) {
      file_.write(separator);
      file_.advance(put_quad(file_.room(max_written_line), edge));
      separator = ",";
    }
    file_.write(edges->empty() ? ",\"initial\":[]" : "]");
  }
  file_.write(members_text(header.extensions) + "}\n");
}

// The end of an event line, which has room up to `out`.
void HistoryWriter::close_line(char* out, const Extensions& extensions) {
  if (extensions.empty()) {
    file_.advance(put_literal(out, "}\n"));
    return;
  }
  file_.advance(out);
  file_.write(members_text(extensions) + "}\n");
}

void HistoryWriter::flip(double t, const Quad& quad, const Extensions& extensions) {
  advance_to(t);
  ++counts_.flips;
  char* out = put_time(file_.room(max_written_line), t);
  close_line(put_quad(put_literal(out, "\"flip\":"), quad), extensions);
}

void HistoryWriter::collide(const CollideEvent& event, const Extensions& extensions) {
  if (event.i >= event.j || !well_formed(event, event.v) || !well_formed(event, event.p))
    throw std::logic_error("not a collision of a history");
  advance_to(event.t);
  ++counts_.collisions;
  char* out = put_kind(put_time(file_.room(max_written_line), event.t), event);
  if (event.v[1]) out = put_vectors(put_literal(out, ",\"v\":"), event.v);
  if (event.p[1]) out = put_vectors(put_literal(out, ",\"p\":"), event.p);
  close_line(out, extensions);
}

void HistoryWriter::maneuver(const ManeuverEvent& event, const Extensions& extensions) {
  advance_to(event.t);
  ++counts_.maneuvers;
  char* out = put_kind(put_time(file_.room(max_written_line), event.t), event);
  if (event.v) out = put_vector(put_literal(out, ",\"v\":"), event.v);
  if (event.p) out = put_vector(put_literal(out, ",\"p\":"), event.p);
  close_line(out, extensions);
}

void HistoryWriter::write(const Event& event, const Extensions& extensions) {
  if (const auto* f = std::get_if<FlipEvent>(&event)) return flip(f->t, f->quad, extensions);
  if (const auto* c = std::get_if<CollideEvent>(&event)) return collide(*c, extensions);
  maneuver(std::get<ManeuverEvent>(event), extensions);
}

void HistoryWriter::begin_with(const std::string& path, const OutputFile::Written& part,
                               const Rational& horizon, const HistoryCounts& counts, double last) {
  require(State::fresh);
  ByteSource source(path);
  std::vector<char> piece(OutputFile::max_room * 64);
  for (std::int64_t left = part.bytes; left > 0;) {
    const auto most = std::min<std::int64_t>(left, static_cast<std::int64_t>(piece.size()));
    const std::size_t got = source.read(piece.data(), static_cast<std::size_t>(most));
    if (got == 0) break;
    file_.write({piece.data(), got});
    left -= static_cast<std::int64_t>(got);
  }
  if (written().sha256 != part.sha256) {
    throw InputError(path, 0, "", "is not the history that was kept");
  }
  state_ = State::open;
  horizon_ = number_text(horizon);
  counts_ = counts;
  last_t_ = last;
}

void HistoryWriter::end(const Extensions& extensions) {
  require(State::open);
  state_ = State::ended;
  complete_ = true;
  file_.write("{\"end\":{\"t\":" + horizon_ + ",\"flips\":" + std::to_string(counts_.flips) +
              ",\"collisions\":" + std::to_string(counts_.collisions) + ",\"maneuvers\":" +
              std::to_string(counts_.maneuvers) + "}" + members_text(extensions) + "}\n");
}

void HistoryWriter::stopped(double t, const std::string& reason, const std::vector<Event>& events,
                            const Extensions& extensions) {
  advance_to(t);
  state_ = State::ended;
  file_.write("{\"stopped\":{\"t\":" + number_text(t) + ",\"reason\":" + string_text(reason) +
              ",\"events\":[");
  for (std::size_t i = 0; i < events.size(); ++i) {
    char* out = put_literal(file_.room(max_written_line), "{");
    if (i > 0) {
      *(out - 1) = ',';
      *out++ = '{';
    }
    out = std::visit([&](const auto& event) { return put_kind(out, event); }, events[i]);
    file_.advance(put_literal(out, "}"));
  }
  file_.write("]}" + members_text(extensions) + "}\n");
}

void HistoryWriter::close() {
  require(State::ended);
  state_ = State::closed;
  file_.commit();
}

std::string HistoryWriter::close_beside_complete() {
  if (complete_ || file_.is_stream() || !is_complete_history(path_)) {
    close();
    return path_;
  }
  return close_as_partial();
}

std::string HistoryWriter::close_as_partial() {
  require(State::ended);
  state_ = State::closed;
  return file_.commit_beside(partial_ending);
}

std::optional<std::string> HistoryWriter::close_short(const std::string& reason, bool replace) {
  constexpr std::size_t room = 1024;
  const bool ended =
      file_.end_early(room, [&](std::string_view line) -> std::optional<std::string> {
        // The line is this writer's: it begins with the time, and ends it with a comma.
        constexpr std::string_view before = "{\"t\":";
        if (!line.starts_with(before)) return std::nullopt;
        line.remove_prefix(before.size());
        return "{\"stopped\":{\"t\":" + std::string(line.substr(0, line.find(','))) +
               ",\"reason\":" + string_text(printable(reason, room / 4)) + ",\"events\":[]}}\n";
      });
  if (!ended) return std::nullopt;
  complete_ = false;
  state_ = State::ended;
  if (!replace) return close_beside_complete();
  close();
  return path_;
}

bool is_complete_history(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  char beginning[longest_magic];
  file.read(beginning, sizeof beginning);
  if (is_compressed({beginning, static_cast<std::size_t>(file.gcount())})) {
    return ends_as_complete(path);
  }
  file.clear();
  // The last line, and the end of that before it.
  constexpr std::streamoff most = static_cast<std::streamoff>(max_event_line) + 2;
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  file.seekg(std::max<std::streamoff>(0, size - most));
  std::string line, last;
  while (std::getline(file, line)) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return says_complete(last, path);
}

void HistoryWriter::require(State state) const {
  if (state_ != state) throw std::logic_error("the parts of a history come in another order");
}

void HistoryWriter::advance_to(double t) {
  require(State::open);
  if (!(std::isfinite(t) && t >= last_t_))
    throw std::logic_error("the times of a history must be finite and never decrease from 0");
  last_t_ = t;
}

}  // namespace voroproof::internal
