// Lives of pairs of neighbours (docs/certificate.md, section 5): of the pair of each V-edge, since
// when it is adjacent and on its present lines. To end a life is to prove that the pair has not
// touched in it. Where flips are not judged there are no edges, and all pairs have lives, by the
// windows of their disks (section 12).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "certify/contact_proof.h"
#include "certify/exact_truth.h"
#include "certify/front.h"
#include "certify/near_pairs.h"
#include "certify/recorded_pairs.h"
#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

class PairLives {
 public:
  PairLives(Setting& s, const Front& front, const Refuter& refuter)
      : s_(s),
        front_(front),
        recorded_(s, front, refuter),
        refuter_(refuter),
        apart_(s.motion),
        near_(s.motion, s.search_end) {}

  RecordedPairs& recorded() { return recorded_; }
  const RecordedPairs& recorded() const { return recorded_; }

  // The pairs of the diagram's edges; of one disk, that with the container. Or all pairs. All begin
  // at t.
  void assign(double t);

  // ---- Of the diagram's edges. ----
  void begin(int edge, double t) { since_[edge] = t; }

  // The pair's adjacency, or its motion, ends at m without a collision of the two; `apart`: the two
  // are proved to be apart from their birth until m.hi.
  void end(int edge, const Moment& m, PairEnd why, bool apart = false) {
    const auto [i, j] = s_.replay.pair_of(edge);
    end(i, j, since_[edge], edge, m, why, apart);
  }
  // Ends the lives of the pairs of all these edges but the pair that collides.
  void end(std::span<const int> edges, const Moment& m, PairEnd why);

  // ---- Of all pairs, where flips are not judged. ----
  // The front is to move on to m. `settled`: an event before this time is claimed by none of the
  // claims that are left. Afterwards all windows last until m.
  void reach(const Moment& m, double settled);
  // The lives of all pairs of disk g end at m, at which it turns, but that of the pair that
  // collides.
  void end_around(GenId g, const Moment& m);
  // The disk has turned at m.
  void begin_around(GenId g, const Moment& m) { near_.begin(g, m.lo, m.hi); }

  // ---- Of either. ----
  // A life that is open: since when the pair is adjacent, or watched, and on its present lines, or
  // a little later.
  struct Open {
    GenId i, j;
    double since;
    int edge;  // or -1
  };
  // All that are open, and that may end with a contact by t.
  std::vector<Open> open(double t);
  // Whether the pair has certainly not touched in the life by m, and that is no question of what
  // may be left out. In doubles: false says nothing.
  bool certainly_clear(const Open& life, const Moment& m) const {
    return certainly_clear(life.i, life.j, life.since, m, false);
  }
  void end(const Open& life, const Moment& m, PairEnd why) {
    end(life.i, life.j, life.since, life.edge, m, why, false);
  }
  // The two, and the neighbours of one and the other, are not points that meet by m. Also asked of
  // two whose collision is claimed then: that answers a contact, not a meeting. Throws Undecided.
  void require_no_meeting(GenId i, GenId j, const Moment& m);
  // All lives end, as the history does, or a part of it.
  void end_all(const Moment& m, PairEnd why);
  // Recorded truth: the claimed collision, of a pair that has an open life, is one, or is refuted.
  // `edge`: of the pair, or -1; `at` encloses the two at the claimed time.
  void check_contact(const CollideEvent& claim, int edge, const BallPair& at);

  // How the two of a claimed collision, which is none, stand to each other: see text_of().
  std::string standing(const CollideEvent& claim) const;

  // Asks for the memory of a life.
  void prefetch(int edge) const { internal::prefetch(&since_[edge]); }

 private:
  // These have the life that Open would have of these; `apart`: they are proved to be apart in it.
  bool certainly_clear(GenId i, GenId j, double since, const Moment& m, bool apart) const;
  void end(GenId i, GenId j, double since, int edge, const Moment& m, PairEnd why, bool apart);
  int watching(int edge, int besides = -1) const;
  Open life_of(int edge) const;
  void end_near(const std::vector<NearPairs::Pair>& pairs, const Moment& m, PairEnd why);
  void pass_recorded(GenId i, GenId j, double since, int edge, const Moment& m, PairEnd why);
  Rational end_of(const Gap& gap, const Moment& m) const;

  Setting& s_;
  const Front& front_;
  RecordedPairs recorded_;
  const Refuter& refuter_;
  std::vector<double> since_;  // by edge
  ApartBatch apart_;
  NearPairs near_;  // unassigned where there are edges
};

}  // namespace voroproof::internal
