#include "certify/recorded_contacts.h"

#include "filtered/motion/options.h"

namespace voroproof::internal {

std::vector<RecordedContacts::Pair> RecordedContacts::carried() const {
  std::vector<Pair> pairs;
  for (const auto& [pair, overlap] : carried_) pairs.push_back(pair);
  return pairs;
}

bool RecordedContacts::hidden(const Pair& pair) const {
  const auto it = carried_.find(pair);
  return it != carried_.end() && it->second.hidden;
}

void RecordedContacts::reveal(const Pair& pair, const Rational& t) {
  const auto it = carried_.find(pair);
  if (it == carried_.end()) return;
  it->second.hidden = false;
  it->second.revealed = t;
  forget_if_done(it);
}

// Drops a carried overlap that is over and answered, where no proof is owed.
void RecordedContacts::forget_if_done(Pairs::iterator it) {
  const Carried& c = it->second;
  if (c.over && c.answered && !c.hidden) carried_.erase(it);
}

std::optional<RecordedContacts::Missing> RecordedContacts::pass(const Lines& lines,
                                                                const Rational& end, bool watched) {
  auto it = carried_.find(lines.pair);
  if (lines.from < end) {
    const auto overlaps = lines.gap.overlaps(end, lines.rounding);
    const bool goes_on = !overlaps.empty() && overlaps.front().at_start;
    if (it != carried_.end() && !goes_on) it->second.over = true;
    for (const Gap::Overlap& o : overlaps) {
      if (it == carried_.end() || it->second.over) {
        if (it != carried_.end()) {
          // The two have been apart, and meet again.
          if (const auto m = give_up(it)) return m;
        }
        it = carried_
                 .emplace(lines.pair, Carried{o.begin, lines.motions, false, true, false, {}, {}})
                 .first;
        // The rest of an overlap behind the pair's own collision is answered by it: before the
        // collision it was too little to be carried over.
        if (o.at_start && lines.collided) it->second.answered = lines.from;
      }
      Carried& c = it->second;
      c.shallow = c.shallow && is_rounding(lines, o);
      // On the lines on which it was revealed, parting, nothing is hidden again.
      const bool known = o.at_start && c.revealed && *c.revealed >= lines.from &&
                         !lines.gap.approach_at(*c.revealed);
      c.hidden = c.hidden || (diagrams_ && o.hidden && !known);
      c.over = !o.to_end;
      if (c.answered && !c.shallow && o.end.compare(*c.answered + tolerance_) > 0) {
        return missing(c);
      }
    }
  }
  if (it == carried_.end()) return std::nullopt;
  if (!watched) return give_up(it);
  const Carried& c = it->second;
  // An overlap that is not answered by now will not be.
  if (!c.answered && c.entry.compare(end - tolerance_) < 0) {
    if (!c.shallow && !at_horizon(c.entry)) return missing(c);
    if (c.shallow && c.over) return give_up(it);
  }
  forget_if_done(it);
  return std::nullopt;
}

// The pair's overlap is answered no more: it is excused, or missing.
std::optional<RecordedContacts::Missing> RecordedContacts::give_up(Pairs::iterator it) {
  const Carried c = it->second;
  carried_.erase(it);
  if (!c.answered && !c.shallow) {
    if (!at_horizon(c.entry)) return missing(c);
    ++left_out_;
    return std::nullopt;
  }
  if (c.hidden) {
    throw Undecided("a generator lay inside another, and what came of that is not proved");
  }
  if (!c.answered) ++rounded_;
  return std::nullopt;
}

RecordedContacts::Missing RecordedContacts::missing(const Carried& c) {
  const auto [lo, hi] = c.entry.enclosure();
  return {lo, hi, c.motions};
}

RecordedContacts::Answer RecordedContacts::answer(const Lines& lines, const Rational& t) {
  const auto within = [&](const GapTime& at) {
    return at.compare(t - tolerance_) >= 0 && at.compare(t + tolerance_) <= 0;
  };
  const Gap& gap = lines.gap;
  const auto it = carried_.find(lines.pair);
  const bool in_progress = it != carried_.end() && !it->second.over;
  // An overlap by a rounding, as these lines begin, may not have been carried on.
  const bool resting = in_progress ? it->second.shallow
                                   : it == carried_.end() && gap.overlap_at(lines.from) &&
                                         gap.shallow_at_start(lines.rounding) &&
                                         4 * lines.rounding <= lines.reach;
  const auto entry = gap.entry();
  Contact contact = Contact::none;
  std::optional<GapTime> answered;
  if (entry && within(*entry)) {
    contact = Contact::right;
    answered = entry;
  } else if (gap.approach_at(t) && ((in_progress && within(it->second.entry)) ||
                                    (resting && lines.from >= t - tolerance_))) {
    contact = Contact::right;
    answered = in_progress ? it->second.entry : GapTime(lines.from);
  } else if (const auto graze = gap.graze(lines.rounding);
             graze && graze->near && abs(Rational(graze->t - t)) <= tolerance_) {
    contact = Contact::graze;
  }
  // A claim of the next entry does not answer an overlap that the two have passed through before.
  const bool passed = it != carried_.end() && it->second.over && !it->second.answered &&
                      !it->second.shallow && !(answered && answered->compare(t) <= 0);
  if (passed) return {Contact::elsewhere, missing(it->second)};
  if (contact == Contact::none) {
    if (entry) {
      const auto [lo, hi] = entry->enclosure();
      return {Contact::elsewhere, Missing{lo, hi, lines.motions}};
    }
    return {in_progress && !gap.approach_at(t) ? Contact::parting : Contact::none, {}};
  }
  if (it != carried_.end()) {
    it->second.answered = t;
    forget_if_done(it);
  } else if (answered && gap.overlap_at(t)) {
    carried_.emplace(
        lines.pair,
        Carried{*answered, lines.motions, false, false, diagrams_ && gap.hidden_at(t), t, {}});
  }
  return {contact, {}};
}

}  // namespace voroproof::internal
