// The claims of a history as they are read: those near the next one in time, the one being checked,
// and what refutations have to say of the lines.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "certify/read_ahead.h"
#include "certify/replay.h"
#include "filtered/numbers/next_double.h"
#include "filtered/search/moment.h"
#include "history/history_source.h"

namespace voroproof::internal {

// The tie that claims have in common which were proved simultaneous: a number, 0 for none. Each
// claim has its moment as it was isolated then, after so many changes of the motion.
struct Tie {
  std::int64_t number = 0;
  double lo = 0, hi = 0;
  int changes = 0;
};

// The disks that a claim turns, the container for none.
std::array<GenId, 2> turned_by(const Event& event);
// Whether both turn one and the same disk.
bool turn_one_disk(const Event& a, const Event& b);

class Claims {
 public:
  using HalfEdge = Diagram::HalfEdge;

  struct Claim {
    Claim(Event&& e, std::int64_t l, HalfEdge p, bool o)
        : event(std::move(e)), line(l), place(p), overlooked(o) {}

    Event event;
    std::int64_t line;
    HalfEdge place;  // half-edge or disks that it is about, as far as known, or -1
    Tie tie{};
    bool placed = false;  // no order with another is known: it stays where the file has it
    // Others were taken without a look at it: more were near these than are looked at together.
    bool overlooked = false;
    // Its true time or none, as it was found when so many claims had been taken; -1: never.
    std::optional<Moment> moment{};
    std::int64_t probed = -1;
  };

  // `most_near` claims that are near each other are looked at together, at most. `places`: for the
  // claims in their order, what a claim is about; empty: see
  // unplaced_ahead(). Whoever is wrong there makes the checker slower. `kinds`: others are passed
  // over.
  Claims(HistorySource& history, double tolerance, std::size_t most_near, EventKinds kinds,
         std::vector<Replay::Place> places)
      : ahead_(history, places.empty() ? kAhead : kAheadPlaced),
        tolerance_(tolerance),
        most_near_(most_near),
        kinds_(kinds),
        places_(std::move(places)),
        read_to_(history.line()) {
    times_.reserve(places_.size());
    lines_.reserve(places_.size());
  }

  const HistorySource& history() const { return ahead_.history(); }

  // ---- Reading. ----
  // Reads the claims that follow within twice the tolerance of the next one: their true order may
  // differ from that of the file. False at the end. `on_read` is called after each.
  template <class OnRead>
  bool refill(OnRead&& on_read) {
    while (wants_more() && read()) on_read();
    return !near_.empty();
  }
  // The claims that are read and not yet checked: one, nearly always.
  std::vector<Claim>& near() { return near_; }
  // Whether no other of them is so near the first that it may come before it.
  bool first_is_alone() const { return near_.size() == 1; }
  // The known place of the claim that will be read after `far` others.
  Replay::Place place_ahead(std::size_t far) const {
    const std::size_t k = times_.size() + far;
    if (k < places_.size()) return places_[k];
    const ReadAhead::Claim* const claim = ahead_.after(far);
    return claim != nullptr ? claim->place : Replay::Place{};
  }
  // The claim that will be read after so many others, where it is at hand and nobody has said what
  // it is about, for whoever finds out to say so; else null.
  ReadAhead::Claim* unplaced_ahead(std::size_t far) {
    return places_.empty() ? ahead_.after(far) : nullptr;
  }
  // Makes the k-th of the near claims the one being checked.
  void take(std::size_t k);
  // Whether the claim being checked may depend on another near it: on one whose true time is
  // undecided, or, where more were near than are looked at together, on one that has not been read
  // yet. Reads on: no claim is checked after this.
  bool may_depend_on_others();
  // An event before this time is claimed by none but claims that were taken already.
  double settled() const { return next_below(taken_ - tolerance_); }
  // Whether a claim that has not been proved, up to the time `until`, is such a one, or may be for
  // what the file says. Reads on: no claim is checked after this.
  bool has_unchecked(const Rational& until, const std::function<bool(const Event&)>& is_it);

  // ---- The claim being checked; none before the first and after the last. ----
  const std::optional<Event>& current() const { return current_; }
  // The line of that claim, or the line that the history has come to.
  std::int64_t line() const { return line_; }
  HalfEdge place() const { return place_; }
  const Tie& tie() const { return tie_; }
  bool placed() const { return placed_; }
  bool overlooked() const { return overlooked_; }
  // It is proved.
  void done() { ++processed_; }
  // No claim is being checked: the history is at this line.
  void stand_at(std::int64_t line) {
    current_.reset();
    line_ = line;
  }
  // All are proved: the history, or the part of it, ends at t.
  void end_at(double t);
  std::int64_t processed() const { return processed_; }
  // Claims read that are not of the kinds asked for.
  std::int64_t passed_over() const { return passed_over_; }

  // ---- What the lines say. ----
  // The line of the first claim later than t, or the last line read.
  std::int64_t line_at(double t) const;
  // How many of the claims proved are before t.
  std::int64_t proved_before(double t) const;
  // Whether the last claim read is of this time.
  bool last_is_at(double t) const { return !times_.empty() && times_.back() == t; }

 private:
  // The number of claims that are read ahead of those taken, where their places are to be found.
  static constexpr std::size_t kAhead = 12;
  // The number where the places are known: a claim that has just been written is not read at once.
  static constexpr std::size_t kAheadPlaced = 1;

  bool wants_more();
  bool read();
  // The next claim of the history, which is to be dropped then; null at the end.
  ReadAhead::Claim* next();
  // The same, of the kinds asked for: others before it are passed over.
  ReadAhead::Claim* next_of_kinds();

  ReadAhead ahead_;
  double tolerance_;
  std::size_t most_near_;
  EventKinds kinds_;
  std::int64_t passed_over_ = 0;
  std::vector<Claim> near_;
  bool ended_ = false;                 // no more to read
  bool full_ = false;                  // when a claim was taken last as many were near as can be,
  double taken_ = 0;                   // the first of them at this time, or the end
  std::vector<double> times_;          // times of the claims read
  std::vector<std::int64_t> lines_;    // theirs
  std::vector<Replay::Place> places_;  // places of the claims, read or not
  std::int64_t read_to_;               // the line of the next claim; at the end, of that
  std::optional<Event> current_;
  std::int64_t line_ = 1;
  HalfEdge place_ = -1;
  Tie tie_;
  bool placed_ = false, overlooked_ = false;
  std::int64_t processed_ = 0;
};

}  // namespace voroproof::internal
