// Lives of V-edges (docs/certificate.md, section 2): of each edge, what is known since its
// quadruplet or the motion of its generators last changed. To end a life is to prove that the edge
// has not collapsed in it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "certify/front.h"
#include "certify/refuter.h"
#include "certify/rootless.h"
#include "certify/setting.h"

namespace voroproof::internal {

// A root of a flip polynomial, the only one in [lo, hi].
struct IsolatedRoot {
  Moment m;
  double lo = 0, hi = 0;
};

// An edge that flips, and those of the two triangles beside it, each once.
struct EdgeRing {
  Quad q;  // the edge before the flip
  std::array<int, 4> edges{-1, -1, -1, -1};
  std::array<GenId, 4> outer{};  // the generators beyond them
  int count = 0;

  EdgeRing(const Diagram& diagram, Diagram::HalfEdge h);
  std::span<const int> near() const { return {edges.data(), static_cast<std::size_t>(count)}; }
};

class EdgeLives {
 public:
  // The edge is legal and does not collapse until `from`.
  struct Life {
    double from = 0;
    int born = 0;          // the instant at which it began
    bool illegal = false;  // it has to flip at that instant
    bool due = false;      // it collapses at its root due(), next
    bool tied = false;     // it began with four cotangent generators, legal by a search
    bool pending = false;  // it begins when all that turns at that instant has turned
    // Ended, or pending after its end: its generators are proved not to be cotangent at the end.
    bool clear_end = false;
  };

  EdgeLives(Setting& s, Front& front, const Refuter& refuter)
      : s_(s), front_(front), refuter_(refuter), batch_(s.motion) {}

  // ---- What is known. ----
  const Life& life(int edge) const { return lives_[edge]; }
  // Precondition: life(edge).due.
  const Collapse& due(int edge) const { return due_.at(edge); }
  // The first collapse of q, which is legal just after `from`, no later than `end`. Throws
  // Undecided.
  std::optional<Collapse> first_collapse(const Quad& q, double from, double end);
  // A flip of q about the claimed time t: where to look for it, nothing is proved.
  IsolatedRoot claimed_root(const Quad& q, double t) const;
  // The flip of q near the claimed time t, if that is easily proved. q is legal just after `from`.
  std::optional<IsolatedRoot> bracket(const Quad& q, double from, double t) const;

  // ---- Lives begin and end. ----
  // All edges of the diagram: none is known; or each is known to be legal from t on.
  void assign() { lives_.assign(s_.diagram.edges(), {}); }
  void assign_legal_from(double t) { lives_.assign(s_.diagram.edges(), Life{.from = t}); }
  void begin(std::span<const int> edges, const Moment& m);
  void begin_all(const Moment& m);
  // The lives end at m without a flip of these edges; `closed`: a collapse at m itself is missed,
  // too.
  void end(std::span<const int> edges, const Moment& m, bool closed = false);
  void end_all(const Moment& m, bool closed);
  // Ends the lives of the edges beside one that is about to flip at m.
  void end_beside(const EdgeRing& ring, const Moment& m);
  // The edge has flipped at m, the diagram is that after it: its life and those beside it begin.
  // `own`: m is a root of the edge's own polynomial, isolated so.
  void begin_after_flip(int edge, const EdgeRing& ring, const Moment& m, const IsolatedRoot* own);

  // Delays the start of these lives until every turn of the present instant has been processed.
  // Between two simultaneous turns no time passes, so the intermediate motion is not part of the
  // truth. Testing it could even produce ties that the final motion does not have.
  void postpone(std::span<const int> edges, const Moment& m);
  bool any_pending() const { return !pending_.empty(); }
  // Exchanges the pending edges, which are to begin now, for the vector, which is cleared.
  void take_pending(std::vector<int>& edges) {
    edges.clear();
    pending_.swap(edges);
  }
  // The lives begin at m, rational and later than the present instant, at which the diagram is
  // proved. Throws Undecided.
  void begin_later(std::span<const int> edges, const Moment& m);

  // The present instant is left: every edge illegal at it must have flipped.
  void require_none_illegal();
  // Whether an event at m may be left out: under the recorded truth roundings move what happens
  // within the tolerance of the horizon to either side of it. Counts it.
  bool left_out(const Moment& m);
  // A claimed flip has been proved at m, no earlier than those before it.
  void note_flip(const Moment& m) {
    if (m.hi >= s_.horizon_window_down) last_flip_ = m;
  }
  // At the end: no flip is claimed later than a collapse that is left out. From that on the claimed
  // diagram is another than the true one. Throws Undecided.
  void require_none_after_left_out();

  // Asks for the memory of a life.
  void prefetch(int edge) const { internal::prefetch(&lives_[edge]); }

 private:
  // The time scale of the brackets about the time t.
  double reference_time(double t) const;
  void begin_life(int edge, const Moment& m, const IsolatedRoot* own, bool rootless);
  void find_beginning(int edge, const Moment& m, const IsolatedRoot* own);
  void end_life(int edge, const Moment& m, bool closed, std::size_t k);
  void find_end(int edge, const Moment& m, bool closed, std::size_t k);
  void require_legal(int edge, const Moment& m) const;

  Setting& s_;
  Front& front_;
  const Refuter& refuter_;
  std::vector<Life> lives_;                // by edge
  std::unordered_map<int, Collapse> due_;  // the roots of edges whose lives are due, and old ones
  std::vector<int> illegal_;               // edges that have to flip at this instant
  std::vector<int> pending_;               // edges whose lives are pending
  std::optional<Moment> first_left_out_, last_flip_;
  // Disks have turned since one of these was found: its enclosure is all that can be compared.
  bool turned_since_ = false;
  RootlessBatch batch_;
};

}  // namespace voroproof::internal
