// Claimed flips of V-edges.
#pragma once

#include <cstdint>

#include "certify/claims.h"
#include "certify/edge_lives.h"
#include "certify/front.h"
#include "certify/instants.h"
#include "certify/pair_lives.h"
#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

class Flips {
 public:
  using HalfEdge = Diagram::HalfEdge;

  Flips(Setting& s, const Claims& claims, Front& front, const Refuter& refuter, EdgeLives& edges,
        PairLives& pairs, Instants& instants)
      : s_(s),
        claims_(claims),
        front_(front),
        refuter_(refuter),
        edges_(edges),
        pairs_(pairs),
        instants_(instants) {}

  // Proves the claim being checked, or throws Refuted or Undecided.
  void flip(const FlipEvent& claim);

 private:
  // When an edge flips for a claim.
  struct Found {
    IsolatedRoot root;
    bool own = true;  // root is one of the edge's own polynomial; else it flips with others
  };
  // The half-edge that the claim means, and its flip.
  struct Meant {
    HalfEdge h;
    Found found;
  };

  Meant meant_by(const FlipEvent& claim);
  HalfEdge claimed(const Quad& q) const;
  void resolve(HalfEdge h);
  Found collapse_for(const FlipEvent& claim, HalfEdge h);
  Found collapse_by_search(const FlipEvent& claim, const Quad& q, int edge);
  Found present_collapse(const Quad& q, const EdgeLives::Life& life, const Rational& claimed);
  [[noreturn]] void mistimed(const Quad& q, const Collapse& c, const Rational& claimed);
  DdBall true_time(const Moment& m, double claimed, double near) const;
  void count_ulps(const Moment& m, double claimed);

  Setting& s_;
  const Claims& claims_;
  Front& front_;
  const Refuter& refuter_;
  EdgeLives& edges_;
  PairLives& pairs_;
  Instants& instants_;
};

}  // namespace voroproof::internal
