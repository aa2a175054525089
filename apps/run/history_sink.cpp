#include "apps/run/history_sink.h"
#include "history/history_writer.h"

#include <utility>

namespace voroproof::internal {
namespace {

Vec2 velocity(const RoundedState& state) { return {state.vx, state.vy}; }
Vec2 center(const RoundedState& state) { return {state.px, state.py}; }

}  // namespace

HistorySink::HistorySink(HistoryWriter& writer, HistoryHeader header, int disks)
    : writer_(writer), header_(std::move(header)), disks_(disks) {}

void HistorySink::begin(const std::vector<Quad>& initial) {
  begun_ = true;
  // A run that stopped before the diagram at 0+ was known gives none.
  if (!initial.empty() || disks_ < 2) {
    writer_.header(header_, initial);
  } else {
    writer_.header(header_);
  }
}

void HistorySink::flip(double t, const Quad& edge) { take(FlipEvent{.t = t, .quad = edge}); }

void HistorySink::collide(double t, GenId i, GenId j, const RoundedState& first,
                          const RoundedState& second) {
  CollideEvent event{.t = t, .i = i, .j = j};
  if (i != container_id) {
    event.v[0] = velocity(first);
    event.p[0] = center(first);
  }
  event.v[1] = velocity(second);
  event.p[1] = center(second);
  take(std::move(event));
}

void HistorySink::maneuver(double t, GenId disk, const RoundedState& state) {
  take(ManeuverEvent{.t = t, .disk = disk, .v = velocity(state), .p = center(state)});
}

BackgroundHistorySink::~BackgroundHistorySink() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    closed_ = dropped_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundHistorySink::begin(const std::vector<Quad>& initial) {
  HistorySink::begin(initial);
  start();
}

void BackgroundHistorySink::go_on_after(double t) {
  HistorySink::go_on_after(t);
  start();
}

void BackgroundHistorySink::start() {
  batch_.events.reserve(batch_size);
  thread_ = std::thread([this] { write_batches(); });
}

void BackgroundHistorySink::checkpoint(std::function<void()> then) {
  if (!thread_.joinable()) return;
  batch_.is_checkpoint = true;
  batch_.then = std::move(then);
  hand_on();
}

void BackgroundHistorySink::finish() {
  if (!thread_.joinable()) return;
  if (!batch_.events.empty()) hand_on();
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  thread_.join();
  if (error_) std::rethrow_exception(error_);
}

void BackgroundHistorySink::put(Event&& event) {
  batch_.events.push_back(std::move(event));
  if (batch_.events.size() == batch_size) hand_on();
}

void BackgroundHistorySink::hand_on() {
  Batch next;
  next.events.reserve(batch_size);
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return error_ || queue_.size() < max_batches; });
    if (error_) std::rethrow_exception(error_);
    queue_.push_back(std::exchange(batch_, std::move(next)));
  }
  changed_.notify_all();
}

void BackgroundHistorySink::write_batches() {
  try {
    for (;;) {
      Batch batch;
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return closed_ || !queue_.empty(); });
        if (dropped_ || queue_.empty()) return;
        batch = std::move(queue_.front());
        queue_.pop_front();
      }
      changed_.notify_all();
      for (const Event& event : batch.events) writer_.write(event);
      if (batch.is_checkpoint) writer_.flush();
      if (batch.then) batch.then();
    }
  } catch (...) {
    {
      const std::lock_guard lock(mutex_);
      error_ = std::current_exception();
    }
    changed_.notify_all();
  }
}

}  // namespace voroproof::internal
