// Contacts and overlaps of pairs under the recorded truth: the lines that two disks are on, what
// roundings of the file excuse, and filters in doubles before RecordedContacts is asked.
#pragma once

#include "certify/front.h"
#include "certify/recorded_contacts.h"
#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

class RecordedPairs {
 public:
  RecordedPairs(Setting& s, const Front& front, const Refuter& refuter)
      : s_(s),
        front_(front),
        refuter_(refuter),
        contacts_(s.options.tolerance, s.horizon_window, s.options.judges_flips()) {}

  RecordedContacts& contacts() { return contacts_; }
  const RecordedContacts& contacts() const { return contacts_; }

  // Whether the two, after their own collision at `from`, certainly part and overlap no more than
  // by a rounding. In doubles: false says nothing.
  bool certainly_part(GenId i, GenId j, double from) const;
  // Whether the two certainly do not overlap in the life from `from` to m: in doubles, false says
  // nothing. `apart`: they are proved apart already. What lies outside the container at the
  // beginning by a rounding may have hit it there.
  bool certainly_clear(GenId i, GenId j, double from, const Moment& m, bool apart) const;
  // The pair on its present lines, watched from the time on at which it is on these and adjacent.
  RecordedContacts::Lines lines(GenId i, GenId j, double adjacent_since) const;
  // How two that are said to collide at the time t, and do not, stand to each other then: see
  // text_of().
  std::string standing(GenId i, GenId j, const Rational& t) const;
  // Two points do not meet on their present lines until m. Throws Undecided.
  void require_no_meeting(GenId i, GenId j, const Moment& m) const;
  // The pair, adjacent since `from` and enclosed by `at` at the claimed time, is in contact then,
  // or the claim is refuted.
  void check_contact(const CollideEvent& claim, double from, const BallPair& at);

 private:
  Rational rounding(GenId i, GenId j) const;
  bool certainly_shallow(GenId i, GenId j, double t) const;
  bool certainly_in_contact(const CollideEvent& claim, double from, const BallPair& at) const;
  RecordedContacts::Motions motions(GenId i, GenId j, const Rational& at) const;

  Setting& s_;
  const Front& front_;
  const Refuter& refuter_;
  RecordedContacts contacts_;
};

}  // namespace voroproof::internal
