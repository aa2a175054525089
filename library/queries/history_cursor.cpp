#include "library/queries/history_cursor.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <variant>

#include "history/error.h"
#include "library/queries/followed_history.h"

namespace voroproof::internal {

HistoryCursor::HistoryCursor(const Scene& scene, const std::string& path,
                             const std::function<Diagram()>& initial, const Rational& covered)
    : HistoryCursor(scene, *open_history(path, static_cast<int>(scene.disks.size()), scene.sha256),
                    path, initial, covered) {}

HistoryCursor::HistoryCursor(const Scene& scene, HistorySource& history, const std::string& name,
                             const std::function<Diagram()>& initial, const Rational& covered)
    : path_(name), diagram_(Diagram(0)) {
  const int disks = static_cast<int>(scene.disks.size());
  HistoryFollower follower;
  follower.begin = [&](const HistoryHeader& header) {
    header_ = header;
    diagram_ = NamedDiagram(initial_diagram(header, disks, name, initial));
  };
  follower.event = [&](const Event& event, bool, std::int64_t) { events_.push_back(event); };
  follow_history(history, name, covered, follower);
}

bool HistoryCursor::next() {
  if (position_ == events_.size()) return false;
  const Event& event = events_[position_];
  if (const auto* f = std::get_if<FlipEvent>(&event)) flip(f->quad, position_);
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
