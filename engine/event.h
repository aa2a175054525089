// An event that a search has found, and its time.
#pragma once

#include <memory>

#include "exact/generators.h"
#include "exact/rational.h"
#include "exact/roots.h"
#include "filtered/numbers/dd_ball.h"

namespace voroproof::internal {

// The time of a flip or contact as its search has left it: no other root of the flip polynomial,
// or no other contact of the pair, is between lo and hi.
struct IsolatingInterval {
  double lo = 0, hi = 0;
};

struct FoundEvent {
  enum class Kind {
    flip,
    contact,
    maneuver,  // one or more disks turn
    horizon,
  };
  FoundEvent(Kind of_kind, int queue_item) : kind(of_kind), item(queue_item) {}
  Kind kind;
  int item;              // in the schedule's queue
  Quad quad{};           // for a flip
  GenId i = 0, j = 0;    // for a contact, i < j
  IsolatingInterval at;  // for a flip or contact
  // The root of a flip that neighbouring doubles do not isolate, else null.
  std::shared_ptr<const RootInterval> fine;
  const Rational* exactly = nullptr;  // for a maneuver or the horizon; valid during the instant

  bool is_flip() const { return kind == Kind::flip; }
  bool is_contact() const { return kind == Kind::contact; }
  // The isolating interval of a flip, whatever its width.
  RootInterval root() const {
    return fine ? *fine : RootInterval{to_rational(at.lo), to_rational(at.hi)};
  }
};

// An event with an enclosure of its time.
struct TimedEvent {
  FoundEvent event;
  double lo, hi;
  DdBall dd;
  bool tight;  // dd is as narrow as it gets without more precision
};

}  // namespace voroproof::internal
