#include "history/billiard_history_writer.h"

#include "history/history_writer.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

std::string number(const CompactRational& q) { return number_text(q.value()); }

std::string ids_text(GenId a, GenId b) {
  return '[' + std::to_string(a) + ',' + std::to_string(b) + ']';
}

}  // namespace

std::string BilliardHistoryLines::header(const std::string& scene_sha256, const Rational& horizon,
                                         const std::string& producer) {
  horizon_ = number_text(horizon);
  return "{\"format\":\"voroproof-history\",\"version\":2,\"scene_sha256\":" +
         string_text(scene_sha256) + ",\"horizon\":" + horizon_ +
         ",\"producer\":" + string_text(producer) + "}\n";
}

std::string BilliardHistoryLines::vector_text(const CompactVec3& v) const {
  std::string text = "[";
  for (std::size_t k = 0; k < dimension_; ++k) text += (k ? "," : "") + number(v[k]);
  return text + ']';
}

std::string BilliardHistoryLines::pair_text(
    const std::array<std::optional<CompactVec3>, 2>& pair) const {
  const auto text = [&](int side) { return pair[side] ? vector_text(*pair[side]) : "null"; };
  return '[' + text(0) + ',' + text(1) + ']';
}

std::string BilliardHistoryLines::event(const BilliardEvent& event) {
  std::string line = "{\"t\":" + number(event.t);
  if (const auto* turn = std::get_if<BilliardTurn>(&event.what)) {
    ++counts_.maneuvers;
    line += ",\"maneuver\":" + std::to_string(turn->disk);
    if (turn->v) line += ",\"v\":" + vector_text(*turn->v);
    if (turn->p) line += ",\"p\":" + vector_text(*turn->p);
  } else {
    const auto& collision = std::get<BilliardCollision>(event.what);
    ++counts_.collisions;
    line += ",\"collide\":" + ids_text(collision.a, collision.b);
    if (collision.image) {
      line += ",\"image\":[";
      for (std::size_t k = 0; k < dimension_; ++k)
        line += (k ? "," : "") + std::to_string((*collision.image)[k]);
      line += ']';
    }
    if (collision.v[0] || collision.v[1]) line += ",\"v\":" + pair_text(collision.v);
    if (collision.p[0] || collision.p[1]) line += ",\"p\":" + pair_text(collision.p);
  }
  return line + "}\n";
}

std::string BilliardHistoryLines::end() const {
  return "{\"end\":{\"t\":" + horizon_ + ",\"collisions\":" + std::to_string(counts_.collisions) +
         ",\"maneuvers\":" + std::to_string(counts_.maneuvers) + "}}\n";
}

std::string BilliardHistoryLines::stopped(double t, const std::string& reason) const {
  return "{\"stopped\":{\"t\":" + number_text(t) + ",\"reason\":" + string_text(reason) + "}}\n";
}

std::string BilliardHistoryWriter::close_beside_complete() {
  if (complete_ || file_.is_stream() || !is_complete_history(path_)) {
    close();
    return path_;
  }
  return file_.commit_beside(partial_ending);
}

}  // namespace voroproof::internal
