// A history read some claims ahead of the one that is taken, so that whoever takes them can ask for
// the memory that they are about in time.
#pragma once

#include <boost/circular_buffer.hpp>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <utility>

#include "certify/replay.h"
#include "history/history_source.h"

namespace voroproof::internal {

class ReadAhead {
 public:
  struct Claim {
    Claim(Event&& e, std::int64_t l, std::int64_t o) : event(std::move(e)), line(l), offset(o) {}

    Event event;
    std::int64_t line, offset;  // HistorySource has them so when it has given the event
    Replay::Place place;        // for whoever finds out what the claim is about
  };

  // Reads the claim that is to be taken and `far` others. The history outlives the reader; nobody
  // else reads it meanwhile.
  ReadAhead(HistorySource& history, std::size_t far) : history_(history), claims_(far + 1) {}

  const HistorySource& history() const { return history_; }

  // The claim to be taken next, null after the last. What reading throws is thrown in the place of
  // the claim that could not be read.
  Claim* first() {
    while (!claims_.full() && !ended_) read();
    if (!claims_.empty()) return &claims_.front();
    if (error_) std::rethrow_exception(error_);
    return nullptr;
  }
  // That claim is taken. Precondition: there is one.
  void drop_first() { claims_.pop_front(); }

  // The claim after so many others, the next one being after none; null where none is read.
  Claim* after(std::size_t others) { return others < claims_.size() ? &claims_[others] : nullptr; }
  const Claim* after(std::size_t others) const {
    return others < claims_.size() ? &claims_[others] : nullptr;
  }

 private:
  void read() {
    try {
      if (auto event = history_.next()) {
        claims_.push_back(Claim(std::move(*event), history_.line(), history_.offset()));
      } else {
        ended_ = true;
      }
    } catch (...) {
      error_ = std::current_exception();
      ended_ = true;
    }
  }

  HistorySource& history_;
  boost::circular_buffer<Claim> claims_;
  bool ended_ = false;  // nothing is left in the history
  std::exception_ptr error_;
};

}  // namespace voroproof::internal
