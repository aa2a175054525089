#include "queries/history_cursor.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <variant>

#include "history/error.h"
#include "queries/followed_history.h"

namespace voroproof::internal {
namespace {

// The disks whose motion an event changes; -1 for none.
std::array<GenId, 2> movers(const Event& event) {
  if (const auto* collision = std::get_if<CollideEvent>(&event)) {
    return {collision->i, collision->j};
  }
  if (const auto* maneuver = std::get_if<ManeuverEvent>(&event)) {
    return {container_id, maneuver->disk};
  }
  return {container_id, container_id};
}

}  // namespace

HistoryCursor::HistoryCursor(const Scene& scene, const std::string& path,
                             const std::function<Diagram()>& initial, const Rational& covered)
    : HistoryCursor(scene, *open_history(path, static_cast<int>(scene.disks.size()), scene.sha256),
                    path, initial, covered) {}

HistoryCursor::HistoryCursor(const Scene& scene, HistorySource& history, const std::string& name,
                             const std::function<Diagram()>& initial, const Rational& covered)
    : path_(name), last_(scene.disks.size(), -1), diagram_(Diagram(0)) {
  const int disks = static_cast<int>(scene.disks.size());
  HistoryFollower follower;
  follower.begin = [&](const HistoryHeader& header) {
    header_ = header;
    diagram_ = NamedDiagram(initial_diagram(header, disks, name, initial));
  };
  follower.event = [&](const Event& event, bool, std::int64_t) { events_.push_back(event); };
  follow_history(history, name, covered, follower);

  for (const DiskInput& disk : scene.disks) {
    initial_.push_back({0, {disk.x, disk.y}, {disk.vx, disk.vy}});
  }
  std::vector<std::ptrdiff_t> last = last_;
  before_.reserve(events_.size());
  for (std::size_t k = 0; k < events_.size(); ++k) {
    std::array<std::ptrdiff_t, 2> before{-1, -1};
    const std::array<GenId, 2> moved = movers(events_[k]);
    for (const int side : {0, 1}) {
      if (moved[side] == container_id) continue;
      before[side] = std::exchange(last[moved[side]], static_cast<std::ptrdiff_t>(k));
    }
    before_.push_back(before);
  }
}

std::optional<RecordedState> HistoryCursor::motion(GenId disk) const {
  const std::ptrdiff_t last = last_[disk];
  if (last < 0) return initial_[disk];
  const Event& event = events_[last];
  std::optional<ExactVec2> center, velocity;
  if (const auto* collision = std::get_if<CollideEvent>(&event)) {
    const int side = collision->i == disk ? 0 : 1;
    center = exact_center(*collision, side);
    velocity = exact_velocity(*collision, side);
  } else {
    center = exact_center(std::get<ManeuverEvent>(event));
    velocity = exact_velocity(std::get<ManeuverEvent>(event));
  }
  if (!center || !velocity) return std::nullopt;
  return RecordedState{exact_time(event), *std::move(center), *std::move(velocity)};
}

bool HistoryCursor::next() {
  if (position_ == events_.size()) return false;
  const Event& event = events_[position_];
  if (const auto* f = std::get_if<FlipEvent>(&event)) flip(f->quad, position_);
  for (const GenId g : movers(event)) {
    if (g != container_id) last_[g] = static_cast<std::ptrdiff_t>(position_);
  }
  ++position_;
  return true;
}

bool HistoryCursor::previous() {
  if (position_ == 0) return false;
  --position_;
  const Event& event = events_[position_];
  if (const auto* f = std::get_if<FlipEvent>(&event)) {
    flip(canonical(flipped(f->quad)), position_);
  }
  const std::array<GenId, 2> moved = movers(event);
  for (const int side : {0, 1}) {
    if (moved[side] != container_id) last_[moved[side]] = before_[position_][side];
  }
  return true;
}

void HistoryCursor::seek(std::size_t position) {
  if (position > events_.size()) throw std::out_of_range("HistoryCursor: no such position");
  while (position_ < position) next();
  while (position_ > position) previous();
}

void HistoryCursor::seek(const Rational& t) { seek(position_at(t)); }

std::size_t HistoryCursor::position_at(const Rational& t) const {
  if (t >= header_.horizon) return events_.size();
  const auto after =
      std::upper_bound(events_.begin(), events_.end(), t,
                       [](const Rational& time, const Event& e) { return time < exact_time(e); });
  return static_cast<std::size_t>(after - events_.begin());
}

void HistoryCursor::flip(const Quad& q, std::size_t number) {
  try {
    diagram_.flip(q);
  } catch (const std::invalid_argument& fault) {
    // The header has a line of its own before the events.
    throw InputError(path_, static_cast<std::int64_t>(number) + 2, "flip", fault.what());
  }
}

}  // namespace voroproof::internal
