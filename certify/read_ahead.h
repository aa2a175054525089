// A history read some claims ahead of the one that is taken, so that whoever takes them can ask for
// the memory that they are about in time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <vector>

#include "certify/replay.h"
#include "history/history_source.h"

namespace voroproof::internal {

class ReadAhead {
 public:
  struct Claim {
    // Constructs the next event of the history in its place. A copy would be slow: it would read,
    // in larger pieces, what has just been written in smaller ones, and the processor would wait
    // for these writes.
    explicit Claim(HistorySource& history)
        : given(history.next()), line(history.line()), offset(history.offset()) {}

    Event& event() { return *given; }
    const Event& event() const { return *given; }

    std::optional<Event> given;
    std::int64_t line, offset;  // HistorySource has them so when it has given the event
    Replay::Place place;        // for whoever finds out what the claim is about
  };

  // Reads the claim that is to be taken and `far` others. The history outlives the reader; nobody
  // else reads it meanwhile.
  ReadAhead(HistorySource& history, std::size_t far) : history_(history), ring_(far + 1) {}

  const HistorySource& history() const { return history_; }

  // The claim to be taken next, null after the last. What reading throws is thrown in the place of
  // the claim that could not be read.
  Claim* first() {
    while (size_ < ring_.size() && !ended_) read();
    if (size_ > 0) return &*ring_[begin_];
    if (error_) std::rethrow_exception(error_);
    return nullptr;
  }
  // That claim is taken. Precondition: there is one.
  void drop_first() {
    begin_ = place_of(1);
    --size_;
  }

  // The claim after so many others, the next one being after none; null where none is read.
  Claim* after(std::size_t others) { return others < size_ ? &*ring_[place_of(others)] : nullptr; }
  const Claim* after(std::size_t others) const {
    return others < size_ ? &*ring_[place_of(others)] : nullptr;
  }

 private:
  // The place of the k-th claim, k <= size_.
  std::size_t place_of(std::size_t k) const {
    const std::size_t place = begin_ + k;
    return place < ring_.size() ? place : place - ring_.size();
  }

  void read() {
    try {
      if (ring_[place_of(size_)].emplace(history_).given) {
        ++size_;
      } else {
        ended_ = true;
      }
    } catch (...) {
      error_ = std::current_exception();
      ended_ = true;
    }
  }

  HistorySource& history_;
  std::vector<std::optional<Claim>> ring_;  // those from begin_ on are read and not yet taken
  std::size_t begin_ = 0, size_ = 0;
  bool ended_ = false;  // nothing is left in the history
  std::exception_ptr error_;
};

}  // namespace voroproof::internal
