#include "voroproof/billiard.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/billiards/billiard_certifier.h"
#include "history/billiard_history_writer.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/output_file.h"
#include "history/scene.h"
#include "library/billiard_values.h"

namespace voroproof {
namespace internal {
namespace {

using Row = voroproof::BilliardEvent;
using Vector = std::array<double, 3>;
using Vectors = std::array<std::optional<CompactVec3>, 2>;

bool put(const CompactRational& q, double& to) {
  to = round_nearest(q);
  return q.is_double();
}

// Whether no number was rounded.
bool put(const Vectors& vectors, std::array<Vector, 2>& to) {
  bool exact = true;
  for (const std::size_t side : {0, 1}) {
    if (!vectors[side]) continue;
    for (std::size_t k = 0; k < 3; ++k) exact &= put((*vectors[side])[k], to[side][k]);
  }
  return exact;
}

// The event of a row that is to be line `line` of a history.
class RowReader {
 public:
  RowReader(const Row& row, std::int64_t line, int dimension)
      : row_(row), line_(line), dimension_(static_cast<std::size_t>(dimension)) {}

  BilliardEvent event() const {
    if (!std::isfinite(row_.t)) fail("t", "not a time");
    const auto v = vectors(row_.velocity, "v"), p = vectors(row_.center, "p");
    if (row_.kind == Row::maneuver) return {row_.t, line_, BilliardTurn{row_.ids[0], v[0], p[0]}};
    if (row_.kind != Row::collision)
      fail("kind", "no kind of event is " + std::to_string(row_.kind));
    return {row_.t, line_, BilliardCollision{row_.ids[0], row_.ids[1], image(), v, p}};
  }

 private:
  [[noreturn]] void fail(const char* field, const std::string& why) const {
    throw InputError(history_in_memory, line_, field, why);
  }

  std::optional<LatticeImage> image() const {
    const auto& image = row_.image;
    if (std::all_of(image.begin(), image.end(), [](int k) { return k == Row::none; })) return {};
    if (dimension_ == 2 && image[2] != 0) fail("image", "a third coordinate in the plane");
    return LatticeImage{image[0], image[1], image[2]};
  }

  Vectors vectors(const std::array<Vector, 2>& from, const char* field) const {
    Vectors out;
    for (const std::size_t side : {0, 1}) {
      const Vector& x = from[side];
      if (std::all_of(x.begin(), x.end(), [](double c) { return std::isnan(c); })) continue;
      if (!std::all_of(x.begin(), x.end(), [](double c) { return std::isfinite(c); }))
        fail(field, "not finite");
      if (dimension_ == 2 && x[2] != 0) fail(field, "a third coordinate in the plane");
      out[side] = CompactVec3{x[0], x[1], x[2]};
    }
    return out;
  }

  const Row& row_;
  std::int64_t line_;
  std::size_t dimension_;
};

}  // namespace

void append(voroproof::BilliardHistory& history, const BilliardEvent& event) {
  Row& row = history.events.emplace_back();
  bool exact = put(event.t, row.t);
  if (const auto* turn = std::get_if<BilliardTurn>(&event.what)) {
    row.kind = Row::maneuver;
    row.ids[0] = turn->disk;
    exact &= put({turn->v, {}}, row.velocity);
    exact &= put({turn->p, {}}, row.center);
  } else {
    const auto& collision = std::get<BilliardCollision>(event.what);
    row.ids = {collision.a, collision.b};
    if (collision.image) row.image = *collision.image;
    exact &= put(collision.v, row.velocity);
    exact &= put(collision.p, row.center);
  }
  history.rounded += !exact;
}

std::string history_text(const voroproof::BilliardHistory& history) {
  BilliardHistoryLines lines(history.dimension);
  std::string text =
      lines.header(history.scene_sha256, rational(history.horizon), history.producer);
  std::int64_t line = 1;
  for (const Row& row : history.events)
    text += lines.event(RowReader(row, ++line, history.dimension).event());
  const Ending& ending = history.ending;
  if (ending.complete) return text + lines.end();
  if (!std::isfinite(ending.t))
    throw InputError(history_in_memory, ++line, "stopped", "not a time");
  return text + lines.stopped(ending.t, ending.reason);
}

}  // namespace internal

using internal::with_public_errors;

Billiard::Billiard(std::string bytes, const std::string& name) : text_(std::move(bytes)) {
  with_public_errors([&] {
    auto read = std::make_shared<internal::Billiard>(internal::parse_billiard(text_, name));
    internal::require_placement(*read, name);
    read_ = std::move(read);
  });
}

const std::string& Billiard::sha256() const { return read_->sha256; }
int Billiard::dimension() const { return read_->dimension; }
int Billiard::size() const { return static_cast<int>(read_->disks.size()); }
Number Billiard::horizon() const { return internal::number(read_->horizon); }

Billiard read_billiard(const std::string& path) {
  return with_public_errors(
      [&] { return Billiard(internal::file_bytes(path, internal::max_scene_bytes), path); });
}

void write_billiard(const std::string& path, const Billiard& billiard) {
  with_public_errors([&] { internal::write_output(path, billiard.text()); });
}

BilliardHistory read_history(const std::string& path, const Billiard& billiard) {
  return with_public_errors([&] {
    internal::BilliardHistoryReader reader(path, &billiard.read());
    BilliardHistory out;
    out.scene_sha256 = reader.header().scene_sha256;
    out.dimension = billiard.dimension();
    out.horizon = internal::number(reader.header().horizon);
    out.producer = reader.header().producer;
    while (const auto event = reader.next()) internal::append(out, *event);
    if (!reader.counts_match())
      throw internal::InputError(path, reader.line(), "end", "wrong counts of events");
    const auto* stop = std::get_if<internal::HistoryStop>(&reader.ending());
    if (stop != nullptr) {
      out.ending = {false, stop->t, stop->reason};
    } else {
      out.ending.t = out.horizon.nearest();
    }
    return out;
  });
}

void write_history(const std::string& path, const BilliardHistory& history) {
  with_public_errors([&] {
    const std::string text = internal::history_text(history);
    internal::BilliardHistoryReader reader(internal::history_in_memory, nullptr, text);
    while (reader.next()) {
    }
    internal::write_output(path, text);
  });
}

}  // namespace voroproof
