#include "library/replay_writer.h"

#include <cstdint>
#include <vector>

#include "history/json_text.h"

namespace voroproof::internal {
namespace {

std::string text_of(const Rational& x) { return '"' + x.get_str() + '"'; }

// Writes `[`, what put_element(k) writes for each k, with commas between, and `]`.
template <class PutElement>
void put_array(std::string& out, std::size_t size, PutElement&& put_element) {
  out += '[';
  for (std::size_t k = 0; k < size; ++k) {
    if (k > 0) out += ',';
    put_element(k);
  }
  out += ']';
}

void put_integer(std::string& out, std::int64_t x) { out += std::to_string(x); }

}  // namespace

void ReplayWriter::put(const DyadicSum& sum) {
  const auto parts = static_cast<std::size_t>(sum.size());
  put_array(out_, parts, [&](std::size_t k) { out_ += number_text(sum.part_[parts - 1 - k]); });
}

void ReplayWriter::put(const Velocity& velocity) {
  const ExactVec2 v = velocity.value();
  out_ += number_text(v[0]) + ',' + number_text(v[1]);
}

void ReplayWriter::put(const Path& path) {
  if (path.exact_) {
    out_ += text_of(path.exact_->t) + ',' + text_of(path.exact_->p[0]) + ',' +
            text_of(path.exact_->p[1]);
    return;
  }
  out_ += number_text(path.t_) + ',';
  put(path.x_);
  out_ += ',';
  put(path.y_);
}

void ReplayWriter::put_disk(const Replay& replay, std::size_t g) {
  const Replay::Turns& turns = replay.turns_[g + 1];
  out_ += '[' + std::to_string(turns.last) + ',' + std::to_string(turns.count) +
          (turns.at_container ? ",1," : ",0,");
  put(replay.velocities_[g]);
  out_ += ',';
  put(replay.paths_[g]);
  out_ += ']';
}

void ReplayWriter::put(const Replay& replay) {
  const Diagram& diagram = replay.diagram();
  const auto halves = static_cast<std::size_t>(2 * diagram.edges());
  out_ += "{\"origins\":";
  put_array(out_, halves, [&](std::size_t h) {
    put_integer(out_, diagram.org(static_cast<Diagram::HalfEdge>(h)));
  });
  out_ += ",\"previous\":";
  put_array(out_, halves, [&](std::size_t h) {
    put_integer(out_, diagram.previous(static_cast<Diagram::HalfEdge>(h)));
  });
  out_ += ",\"anchors\":";
  put_array(out_, replay.turns_.size(),
            [&](std::size_t g) { put_integer(out_, diagram.anchor(static_cast<GenId>(g) - 1)); });
  out_ += ",\"disks\":";
  put_array(out_, replay.paths_.size(), [&](std::size_t g) { put_disk(replay, g); });
  out_ += ",\"changes\":" + std::to_string(replay.changes_) +
          ",\"next_maneuver\":" + std::to_string(replay.next_maneuver_);
  const std::vector<std::size_t> done(replay.done_maneuvers_.begin(), replay.done_maneuvers_.end());
  out_ += ",\"done_maneuvers\":";
  put_array(out_, done.size(),
            [&](std::size_t k) { put_integer(out_, static_cast<std::int64_t>(done[k])); });
  out_ += '}';
}

}  // namespace voroproof::internal
