// Lives of pairs of neighbours (docs/certificate.md, section 5): of the pair of each V-edge, since
// when it is adjacent and on its present lines. To end a life is to prove that the pair has not
// touched in it.
#pragma once

#include <span>
#include <vector>

#include "certify/contact_proof.h"
#include "certify/exact_pairs.h"
#include "certify/front.h"
#include "certify/recorded_pairs.h"
#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

class PairLives {
 public:
  PairLives(Setting& s, const Front& front, const Refuter& refuter)
      : s_(s),
        front_(front),
        exact_(s, front, refuter),
        recorded_(s, front, refuter),
        refuter_(refuter),
        apart_(s.motion) {}

  ExactPairs& exact() { return exact_; }
  RecordedPairs& recorded() { return recorded_; }
  const RecordedPairs& recorded() const { return recorded_; }

  // The pairs of the diagram's edges; of one disk, that with the container. All begin at t.
  void assign(double t) { since_.assign(s_.motion.size() == 1 ? 1 : s_.diagram.edges(), t); }
  int size() const { return static_cast<int>(since_.size()); }
  // Since when the pair of the edge is adjacent and on its present lines, or a little later.
  double since(int edge) const { return since_[edge]; }
  void begin(int edge, double t) { since_[edge] = t; }

  // The pair's adjacency, or its motion, ends at m without a collision of the two; `apart`: the two
  // are proved to be apart from their birth until m.hi.
  void end(int edge, const Moment& m, PairEnd why, bool apart = false);
  // Ends the lives of the pairs of all these edges but the pair that collides.
  void end(std::span<const int> edges, const Moment& m, PairEnd why);
  // Recorded truth: the claimed collision of the pair of this edge, enclosed by `at` at the claimed
  // time, is one, or is refuted.
  void check_contact(const CollideEvent& claim, int edge, const BallPair& at) {
    recorded_.check_contact(claim, front_.begun ? since_[watching(edge)] : 0, at);
  }

  // Asks for the memory of a life.
  void prefetch(int edge) const { __builtin_prefetch(&since_[edge]); }

 private:
  void require_no_meeting(GenId i, GenId j, const Moment& m);
  int watching(int edge, int besides = -1) const;
  void pass_recorded(int edge, const Moment& m, PairEnd why);

  Setting& s_;
  const Front& front_;
  ExactPairs exact_;
  RecordedPairs recorded_;
  const Refuter& refuter_;
  std::vector<double> since_;  // by edge
  ApartBatch apart_;
};

}  // namespace voroproof::internal
