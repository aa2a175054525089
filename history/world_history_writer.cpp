#include "history/world_history_writer.h"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "history/history_writer.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

std::string list_text(std::initializer_list<GenId> ids) {
  std::string text;
  for (const GenId id : ids) text += (text.empty() ? '[' : ',') + std::to_string(id);
  return text + ']';
}

std::string edge_text(const Quad& q) { return list_text({q.l, q.r, q.s, q.e}); }

std::string flip_text(const Quad& q) { return edge_text(canonical(q)); }

std::string pair_text(const Point2& point) {
  return '[' + number_text(point.x) + ',' + number_text(point.y) + ']';
}

std::string step_text(const Step& step) {
  if (const auto* flip = std::get_if<Quad>(&step)) return flip_text(*flip);
  if (const auto* hide = std::get_if<Hide>(&step)) return list_text({hide->g, hide->j});
  const auto& [g, j, at] = std::get<Appear>(step);
  if (at) return list_text({g, j, at->l, at->r, at->s, at->e});
  return '[' + std::to_string(g) + ',' + std::to_string(j) + ",null]";
}

template <class Iterator>
std::string steps_text(Iterator first, Iterator last) {
  std::string text = "[";
  for (Iterator step = first; step != last; ++step) {
    if (step != first) text += ',';
    text += step_text(*step);
  }
  return text + ']';
}

std::string point_member(const char* name, const std::optional<Point2>& point) {
  return point ? name + pair_text(*point) : std::string();
}

std::string number_member(const char* name, const std::optional<Rational>& number) {
  return number ? name + number_text(*number) : std::string();
}

// The members after "t" of an event.
struct Members {
  std::string operator()(const Quad& flip) const { return "\"flip\":" + flip_text(flip); }
  std::string operator()(const Hide& hide) const {
    return "\"hide\":" + list_text({hide.g, hide.j});
  }
  std::string operator()(const Appear& appear) const {
    const auto& [g, j, at] = appear;
    return "\"appear\":" + list_text({g, j}) + (at ? ",\"at\":" + edge_text(*at) : "");
  }
  std::string operator()(const Swap& swap) const {
    return "\"swap\":" + list_text({swap.i, swap.j});
  }
  std::string operator()(const PathTurn& turn) const {
    return "\"maneuver\":" + std::to_string(turn.g) + point_member(",\"v\":", turn.velocity) +
           point_member(",\"p\":", turn.center) + number_member(",\"growth\":", turn.growth);
  }
  std::string operator()(const Jump& jump) const {
    std::string text = "\"jump\":" + std::to_string(jump.g);
    if (jump.out) text += ",\"out\":" + steps_text(jump.out->begin(), jump.out->end());
    if (jump.in && jump.in->empty()) text += ",\"in\":[]";
    if (jump.in && !jump.in->empty()) {
      const auto& at = std::get<Appear>(jump.in->front()).at;
      text += ",\"at\":" + (at ? edge_text(*at) : "null") +
              ",\"in\":" + steps_text(jump.in->begin() + 1, jump.in->end());
    }
    return text + point_member(",\"p\":", jump.center) + point_member(",\"v\":", jump.velocity) +
           number_member(",\"r\":", jump.radius);
  }
};

// Why it is no event of a history; null where it is one.
struct FaultOf {
  const Rational& t;
  const char* operator()(const Quad& flip) const {
    return names_an_edge(flip) ? nullptr : "a flip of no edge";
  }
  const char* operator()(const Swap& swap) const {
    return 0 <= swap.i && swap.i < swap.j ? nullptr : "a swap of no pair";
  }
  const char* operator()(const PathTurn& turn) const {
    return turn.g < 0 ? "a maneuver of no disk" : nullptr;
  }
  const char* operator()(const Hide& hide) const { return fault_of(hide); }
  const char* operator()(const Appear& appear) const { return fault_of(appear); }
  const char* operator()(const Jump& jump) const { return fault_of(jump, t); }
};

}  // namespace

WorldHistoryWriter::WorldHistoryWriter(const std::string& path) : path_(path), file_(path) {}

void WorldHistoryWriter::header(const WorldHistoryHeader& header) {
  require(State::fresh);
  state_ = State::open;
  horizon_ = number_text(header.horizon);
  file_.write("{\"format\":\"voroproof-history\",\"version\":2,\"scene_sha256\":" +
              string_text(header.scene_sha256) + ",\"horizon\":" + horizon_ +
              ",\"producer\":" + string_text(header.producer) + ",\"initial\":[");
  std::vector<Quad> edges = header.initial;
  for (Quad& edge : edges) edge = canonical(edge);
  std::sort(edges.begin(), edges.end());
  const char* separator = "";
  for (const Quad& edge : edges) {
    file_.write(separator + edge_text(edge));
    separator = ",";
  }
  file_.write("]}\n");
}

void WorldHistoryWriter::write(const WorldEvent& event) {
  if (const char* fault = std::visit(FaultOf{event.t}, event.what)) throw std::logic_error(fault);
  advance_to(event.t);
  counts_.add(event);
  file_.write("{\"t\":" + number_text(event.t) + ',' + std::visit(Members(), event.what) + "}\n");
}

void WorldHistoryWriter::end() {
  require(State::open);
  state_ = State::ended;
  complete_ = true;
  const auto count = [](const char* name, std::int64_t number) {
    return name + std::to_string(number);
  };
  file_.write("{\"end\":{\"t\":" + horizon_ + count(",\"flips\":", counts_.flips) +
              count(",\"hides\":", counts_.hides) + count(",\"appears\":", counts_.appears) +
              count(",\"swaps\":", counts_.swaps) + count(",\"jumps\":", counts_.jumps) +
              count(",\"collisions\":", counts_.collisions) +
              count(",\"maneuvers\":", counts_.maneuvers) + "}}\n");
}

void WorldHistoryWriter::stopped(const Rational& t, const std::string& reason) {
  advance_to(t);
  state_ = State::ended;
  file_.write("{\"stopped\":{\"t\":" + number_text(t) + ",\"reason\":" + string_text(reason) +
              "}}\n");
}

void WorldHistoryWriter::close() {
  require(State::ended);
  state_ = State::closed;
  file_.commit();
}

std::string WorldHistoryWriter::close_beside_complete() {
  if (complete_ || file_.is_stream() || !is_complete_history(path_)) {
    close();
    return path_;
  }
  require(State::ended);
  state_ = State::closed;
  return file_.commit_beside(partial_ending);
}

void WorldHistoryWriter::require(State state) const {
  if (state_ != state) throw std::logic_error("the parts of a history come in another order");
}

void WorldHistoryWriter::advance_to(const Rational& t) {
  require(State::open);
  if (t < last_t_) throw std::logic_error("the times of a history never decrease from 0");
  last_t_ = t;
}

}  // namespace voroproof::internal
