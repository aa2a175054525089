// The instants at which disks turn, as the leader of a run in slices tells them to the followers.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "exact/enclosure.h"
#include "exact/rational.h"
#include "filtered/computed/computed_motion.h"
#include "filtered/search/moment.h"

namespace voroproof::internal {

// All instants of a slice, in order.
class LedTurns {
 public:
  // A pair that comes into contact at the instant, in its motion before.
  struct Contact {
    GenId i, j;
    Enclosure at;
    Moment moment() const { return Moment::of(i, j, at.lo, at.hi); }
  };
  struct Instant {
    double t = 0;   // rounded to nearest
    DdBall time{};  // for a collision that tells its own time: see Certified::follow()
    bool tells_time = false;
    const Rational* exactly = nullptr;    // for maneuvers, t = 0 and the begin
    std::size_t contacts = 0, turns = 0;  // where its own end
  };

  void begin_instant() {
    instants_.push_back({.contacts = contacts_.size(), .turns = turns_.size()});
  }
  Instant& last() { return instants_.back(); }
  void set_exactly(const Rational& t) { last().exactly = &times_.emplace_back(t); }
  void add(const Contact& c) {
    contacts_.push_back(c);
    ++last().contacts;
  }
  void add(const LedTurn& t) {
    turns_.push_back(t);
    ++last().turns;
  }

  std::size_t size() const { return instants_.size(); }
  const Instant& instant(std::size_t k) const { return instants_[k]; }
  // Precondition: the instant has a contact.
  const Contact& first_contact(std::size_t k) const {
    return contacts_[k == 0 ? 0 : instants_[k - 1].contacts];
  }
  template <class Visit>
  void each_contact(std::size_t k, Visit&& visit) const {
    for (std::size_t c = k == 0 ? 0 : instants_[k - 1].contacts; c < instants_[k].contacts; ++c) {
      visit(contacts_[c]);
    }
  }
  template <class Visit>
  void each_turn(std::size_t k, Visit&& visit) const {
    for (std::size_t c = k == 0 ? 0 : instants_[k - 1].turns; c < instants_[k].turns; ++c) {
      visit(turns_[c]);
    }
  }

 private:
  std::vector<Instant> instants_;
  std::vector<Contact> contacts_;
  std::vector<LedTurn> turns_;
  std::deque<Rational> times_;  // stay where they are
};

}  // namespace voroproof::internal
