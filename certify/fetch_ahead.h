// Memory asked for in time: large diagrams do not fit into the nearest caches. Nothing is decided
// here. (Always inline: g++ leaves out calls of functions that do nothing else.)
#pragma once

#include "certify/claims.h"
#include "certify/edge_lives.h"
#include "certify/pair_lives.h"
#include "certify/setting.h"

namespace voroproof::internal {

// Asks for the memory of claims that are soon to be checked. What a claim is about is found step by
// step, each from what the one before has asked for: the half-edge h, those of its two triangles,
// their twins' triangles, and the generators on the way.
[[gnu::always_inline]] inline void fetch_ahead(const Setting& s, Claims& claims,
                                               const EdgeLives& edges, const PairLives& pairs) {
  using HalfEdge = Diagram::HalfEdge;
  // Where nobody has said what they are about: as far as the present diagram tells.
  if (const auto* const claim = claims.unplaced_ahead(11)) s.replay.prefetch(claim->event());
  if (auto* const claim = claims.unplaced_ahead(8))
    claim->place = s.replay.place_of(claim->event());
  const Diagram& d = s.diagram;
  const auto generator = [&](GenId g) { s.motion.prefetch(g); };
  const auto turning = [&](GenId g) {
    if (g == container_id) return;
    s.replay.prefetch(g);
    if (s.given != nullptr) s.given->prefetch_restart(g);
    s.law.prefetch(g);
  };
  if (const HalfEdge h = claims.place_ahead(8).half; h >= 0) {
    d.prefetch(h);
    edges.prefetch(h / 2);
    pairs.prefetch(h / 2);
  }
  if (const auto [h, turns] = claims.place_ahead(6); h >= 0) {
    if (turns != Replay::Place::kNone) {
      turning(turns);
      turning(d.org(h));
    }
    for (const HalfEdge g : {h, h ^ 1}) {
      const HalfEdge side = d.previous(g);
      d.prefetch(side);
      edges.prefetch(side / 2);
      generator(d.org(g));
      s.replay.prefetch_turns(d.org(g));
    }
  }
  if (const HalfEdge h = claims.place_ahead(4).half; h >= 0) {
    for (const HalfEdge g : {h, h ^ 1}) {
      const HalfEdge side = d.previous(g), other = d.previous(side);
      d.prefetch(other);
      edges.prefetch(other / 2);
      d.prefetch(d.previous(side ^ 1));
      generator(d.org(side));
    }
  }
  if (const HalfEdge h = claims.place_ahead(2).half; h >= 0) {
    for (const HalfEdge g : {h, h ^ 1}) {
      const HalfEdge side = d.previous(g), other = d.previous(side);
      d.prefetch(d.previous(other ^ 1));
      generator(d.org(d.previous(side ^ 1)));
    }
  }
}

}  // namespace voroproof::internal
