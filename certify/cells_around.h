// The lives around disks that turn: those of the spokes of their cells, which are lives of pairs,
// too, and of the rims. Where flips are not judged: those of all their pairs.
#pragma once

#include <vector>

#include "certify/edge_lives.h"
#include "certify/front.h"
#include "certify/pair_lives.h"
#include "certify/setting.h"

namespace voroproof::internal {

class CellsAround {
 public:
  CellsAround(Setting& s, const Front& front, EdgeLives& edges, PairLives& pairs)
      : s_(s), front_(front), edges_(edges), pairs_(pairs) {}

  // The diagram has been proved, or taken over.
  void assign() { collected_.assign(s_.diagram.edges(), false); }

  // All lives around the two disks end at m, but that of the pair that collides. i may be the
  // container, for one disk. Before the start there are none.
  void end(GenId i, GenId j, const Moment& m);
  // The lives of those that have just been ended begin at m: of pairs at once, of edges when all
  // has turned that turns at m.
  void begin(const Moment& m);

 private:
  void collect(GenId i, GenId j);

  Setting& s_;
  const Front& front_;
  EdgeLives& edges_;
  PairLives& pairs_;
  std::vector<GenId> turning_;     // flips are not judged: the disks that turn
  std::vector<int> spokes_, all_;  // result of the last collection; all: with the rims
  std::vector<char> collected_;    // by edge, within collect(): whether it is among them
};

}  // namespace voroproof::internal
