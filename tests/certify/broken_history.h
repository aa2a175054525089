// A history with a line that cannot be read.
#pragma once

#include <cstddef>
#include <optional>

#include "history/error.h"
#include "tests/certify/claimed_history.h"

namespace voroproof::internal::testing {

// A history that cannot be read beyond so many claims.
class BrokenHistory : public MemoryHistory {
 public:
  BrokenHistory(const ClaimedHistory& history, std::size_t readable)
      : MemoryHistory(history), left_(readable) {}
  std::optional<voroproof::internal::Event> next() override {
    if (left_ == 0) throw InputError("broken", line() + 1, "", "cannot be read");
    --left_;
    return MemoryHistory::next();
  }

 private:
  std::size_t left_;
};

}  // namespace voroproof::internal::testing
