#include "engine/present.h"

#include "engine/static_diagram.h"
#include "filtered/search/contact.h"

namespace voroproof::internal {

void Present::is_at(const Rational& t) {
  now_ = instant_at(t);
  now_.known = [this] {
    before_change();
    return known_;
  };
}

void Present::begin(const std::vector<TimedEvent>& events) {
  set(events.front());
  known_.flips.clear();
  known_.contacts.clear();
  known_.records = motion_.records();
  lone_flip_ = events.size() == 1 && events.front().event.is_flip();
  if (lone_flip_) return;
  for (const TimedEvent& timed : events) {
    const FoundEvent& event = timed.event;
    if (event.is_flip()) {
      note_flip(event.quad);
    } else if (event.is_contact()) {
      known_.contacts.push_back(states_of(motion_, event.i, event.j));
    }
  }
}

// Noted when somebody asks, or before a state changes.
void Present::before_change() {
  if (!lone_flip_) return;
  lone_flip_ = false;
  note_flip(root_.q);
}

void Present::set(const TimedEvent& timed) {
  const FoundEvent& event = timed.event;
  if (event.exactly != nullptr) {
    is_at(*event.exactly);
    return;
  }
  now_.lo = timed.lo;
  now_.hi = timed.hi;
  now_.dd = timed.dd;
  if (event.is_flip()) {
    root_.q = event.quad;
    root_.at = event.at;
    root_.fine = event.fine;
    now_.exact = [this](ExactMotion& exact) {
      const auto& [q, at, fine] = root_;
      if (fine) return CollapseSearch::exact_root(q, fine->lo, fine->hi, exact);
      return CollapseSearch::exact_root(q, to_rational(at.lo), to_rational(at.hi), exact);
    };
  } else {
    // Until the states change this is the pair's next contact.
    contact_ = {event.i, event.j, event.at.lo};
    now_.exact = [this](ExactMotion& exact) {
      const auto& [i, j, near] = contact_;
      return ContactSearch::exact_time(i, j, to_rational(near), exact);
    };
  }
}

void Present::after_collision(GenId j, const Impact* narrower) {
  if (narrower != nullptr) {
    now_.dd = narrower->time_dd;
    enclose(now_.dd, now_.lo, now_.hi);
  }
  const int id = motion_.state_id(j);
  now_.exact = [id, j](ExactMotion& exact) { return time_of(exact.start(id, j)); };
}

void Present::after_changes() { motion_.note_relations(known_.records, now_.lo, now_.hi); }

}  // namespace voroproof::internal
