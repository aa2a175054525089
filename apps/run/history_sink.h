// Writes the engine's events to a history file.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "engine/engine.h"
#include "history/history_reader.h"
#include "history/history_writer.h"

namespace voroproof::internal {

// Writes the header and the events; the last line is the caller's. The writer must outlive the
// sink. Throws what the writer throws.
class HistorySink : public EventSink {
 public:
  // `header` without the initial diagram, which the engine gives; `disks` is their number.
  HistorySink(HistoryWriter& writer, HistoryHeader header, int disks);

  void begin(const std::vector<Quad>& initial) override;
  void flip(double t, const Quad& edge) final;
  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) final;
  void maneuver(double t, GenId disk, const RoundedState& state) final;

  bool has_begun() const { return begun_; }
  double last_time() const { return last_time_; }  // time of the last event; 0 without any

  // In place of begin(): the writer has the header and the events up to time t.
  virtual void go_on_after(double t) {
    begun_ = true;
    last_time_ = t;
  }

  // The events so far are to outlive the process, soon; what is asked for is done then, by the
  // thread that writes.
  virtual void checkpoint(std::function<void()> then = {}) {
    writer_.flush();
    if (then) then();
  }
  // Afterwards all events have reached the writer, which is the caller's again.
  virtual void finish() {}

 protected:
  virtual void put(Event&& event) { writer_.write(event); }

  HistoryWriter& writer_;

 private:
  void take(Event&& event) {
    last_time_ = time(event);
    put(std::move(event));
  }

  HistoryHeader header_;
  int disks_;
  bool begun_ = false;
  double last_time_ = 0;
};

// A sink with a thread of its own for formatting and writing: the engine's thread hands on batches
// of events and waits when too many of them stand in the queue. The bytes are those that
// HistorySink writes.
class BackgroundHistorySink final : public HistorySink {
 public:
  using HistorySink::HistorySink;
  // Without finish(), what is still in the queue is dropped.
  ~BackgroundHistorySink() override;

  void begin(const std::vector<Quad>& initial) override;
  void go_on_after(double t) override;
  void checkpoint(std::function<void()> then = {}) override;
  void finish() override;

 private:
  struct Batch {
    std::vector<Event> events;
    bool is_checkpoint = false;  // after the events, and what is to be done then
    std::function<void()> then;
  };
  static constexpr std::size_t batch_size = 1024;
  static constexpr std::size_t max_batches = 64;

  void put(Event&& event) override;
  void start();
  void hand_on();
  void write_batches();

  Batch batch_;  // used by the engine's thread
  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_.
  std::deque<Batch> queue_;
  bool closed_ = false;       // nothing more will come
  bool dropped_ = false;      // the queued events are not wanted any more
  std::exception_ptr error_;  // thrown in the writing thread

  std::thread thread_;  // last: it uses the others
};

}  // namespace voroproof::internal
