// The checker of one history, or of one part of it: proves the claims one by one.
//
// It carries, for every V-edge and for every pair of neighbours, the life that is open (docs/
// certificate.md, section 2). Each claim ends some lives and begins others; ending a life is where
// the proofs are. One class, in files by subject:
//   checker.cpp      reading, the order of claims
//   divergence.cpp   refutations
//   checker_ends.cpp the start and the end of the history or of a part
//   edge_lives.cpp   lives of edges, flips
//   pair_lives.cpp   lives of pairs: contacts and overlaps
//   hidden.cpp       generators that lie inside others for a moment
//   collisions.cpp   collisions and maneuvers
//   instant_order.cpp  the order of what one instant changes
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "certify/certifier.h"
#include "certify/collision_law.h"
#include "certify/contact_proof.h"
#include "certify/moment.h"
#include "certify/recorded_contacts.h"
#include "certify/replay.h"
#include "certify/rootless.h"
#include "filtered/search/carry.h"

namespace voroproof::internal {

// A false claim is called mistimed where the event comes within so many tolerances of it.
inline constexpr int kMistimed = 1000;

inline constexpr const char* constructed_initial_remark =
    "the history gives no initial diagram: that of the scene was constructed and proved";

// Where a part that is not the last ends, and the diagram that the next one begins with.
struct PartEnd {
  double t = 0;
  Diagram diagram;
};

// The scene, as Motion takes it, up to the last instant of which the history may tell.
MotionInput checked_input(MotionInput input, const HistoryHeader& header);

class Checker {
 public:
  // `motion` is that of checked_input(), new or as an earlier part of the history has left it. The
  // other references outlive the checker. `replay` is that of the claims before the history, or
  // before the part of it that begins at `begin`; before the whole it may hold the diagram that the
  // header gives, so that it need not be put together again. `places`: for the claims in their
  // order, as far as somebody knows, what a claim is about. Whoever is wrong there makes the
  // checker slower.
  Checker(const Scene& scene, Motion& motion, HistorySource& history, const CertifyOptions& options,
          Replay replay, std::optional<double> begin = {}, std::vector<Replay::Place> places = {});

  // The whole history, or the part of it up to `end`: the verdict of a part that is not the last
  // is `certified` where all is right up to there and the diagram is the one given. Once only.
  // Throws InputError and CertificationInterrupted.
  Certificate run(const PartEnd* end = nullptr);

 private:
  using HalfEdge = Diagram::HalfEdge;

  // Thrown where the history is false.
  struct Refuted {
    Divergence divergence;
  };

  // What claims have in common that were proved simultaneous: a number, 0 for none. With the moment
  // of each as it was isolated then, by the motion after so many changes.
  struct Tie {
    std::int64_t number = 0;
    double lo = 0, hi = 0;
    int changes = 0;
  };

  struct Claim {
    Claim(Event&& e, std::int64_t l, HalfEdge h = -1) : event(std::move(e)), line(l), place(h) {}
    Event event;
    std::int64_t line;
    HalfEdge place;
    Tie tie;
    bool placed = false;  // no order with another is known: it stays where the file has it
  };

  // What is known of a V-edge since its quadruplet or the motion of its generators last changed: it
  // is legal and does not collapse until `from`.
  struct Life {
    double from = 0;
    int born = 0;          // the instant at which it began
    bool illegal = false;  // it has to flip at that instant
    bool due = false;      // it collapses at its root in due_, next
    bool pending = false;  // it begins when all that turns at that instant has turned
  };

  // The pair of a V-edge is adjacent and on its present lines since `from`, or a little later.
  struct Adjacency {
    double from = 0;
  };

  // Exact truth: when the present motion of a disk began, and the number of that instant.
  struct Birth {
    Moment moment;
    int instant;
  };

  // Why the life of a pair ends: one of the two turns; its edge flips; the history ends, or a part.
  enum class PairEnd { turn, flip, end };

  // A root of a flip polynomial, the only one in [lo, hi].
  struct Isolated {
    Moment m;
    double lo = 0, hi = 0;
  };

  // A collision (i < j) or maneuver (i = j), and the states of the motion that it ended.
  struct Turn {
    GenId i, j;
    int state_i, state_j;
  };

  // When an edge flips for a claim.
  struct Found {
    Isolated root;
    bool own = true;  // root is one of the edge's own polynomial; else it flips with others
  };

  // ---- checker.cpp ----
  bool refill();
  [[gnu::always_inline]] void fetch_ahead() const;
  void process_next();
  std::size_t earliest();
  std::size_t turn_before(const Event& event);
  std::optional<Moment> probe(const Event& event);
  void take(std::size_t k);
  void take_before_others(std::size_t k);
  void done();
  bool is_moment_of(const Tie& tie, const Moment& m) const;
  void advance(const Moment& m);
  void leave_instant();
  bool in_time(const Moment& m);

  // ---- divergence.cpp ----
  void prefix_until(double t);
  std::int64_t line_at(double t) const;
  Divergence divergence_at_claim(Fault fault, std::string truth) const;
  [[noreturn]] void refute(Fault fault, const std::string& truth, Witness witness = {});
  Divergence missing_flip(const Quad& q, const Collapse& root);
  Divergence missing_contact(GenId i, GenId j, double lo, double hi);
  Divergence missing_maneuver(std::size_t k) const;
  void refute_missing_contacts();
  bool turns_one_of(std::initializer_list<GenId> generators) const;
  Divergence first_event_missing(const Divergence& found);
  Divergence first_divergence(const Divergence& found);
  std::optional<Divergence> maneuver_missing_by(double t);
  bool is_claimed(const Maneuver& due);

  // ---- checker_ends.cpp ----
  void start();
  void take_initial_diagram();
  bool turns_at_start(const Event& event);
  std::optional<std::size_t> next_turn_at_start();
  void resume(double t);
  void finish_part(const PartEnd& end);
  void finish();
  std::vector<int> all_edges() const;
  void end_all_lives(const Moment& m, bool closed);

  // ---- edge_lives.cpp ----
  void begin_life(int edge, const Moment& m, const Isolated* own, bool rootless);
  void end_life(int edge, const Moment& m, bool closed, std::size_t k);
  void begin_lives(std::span<const int> edges, const Moment& m);
  void end_lives(std::span<const int> edges, const Moment& m, bool closed = false);
  std::optional<Collapse> first_collapse(const Quad& q, double from, double end);
  Isolated claimed_root(const Quad& q, double t) const;
  std::optional<Isolated> bracket(const Quad& q, double from, double t) const;
  Found collapse_for(const FlipEvent& claim, HalfEdge h);
  HalfEdge claimed(const Quad& q) const;
  void flip(const FlipEvent& claim);
  void resolve(HalfEdge h);
  bool left_out(const Moment& m);
  void count_ulps(const Moment& m, double claimed);
  [[noreturn]] void mistimed(const Quad& q, const Collapse& c, const Rational& claimed);

  // ---- pair_lives.cpp ----
  const Birth* birth(GenId i, GenId j) const;
  Moment born(GenId i, GenId j) const;
  bool born_at_present(GenId i, GenId j) const;
  Instant since(GenId i, GenId j) const;
  void note_birth(GenId g, const Moment& m);
  Moment moment_of(GenId i, GenId j, const NextContact& c) const;
  NextContact next_contact(GenId i, GenId j);
  void require_no_contact(GenId i, GenId j, const Moment& m, PairEnd why);
  void end_pair(int edge, const Moment& m, PairEnd why, bool apart = false);
  void end_pairs(std::span<const int> edges, const Moment& m, PairEnd why);
  Rational rounding(GenId i, GenId j) const;
  bool certainly_shallow(GenId i, GenId j, double t) const;
  bool certainly_part(GenId i, GenId j, double from) const;
  bool certainly_clear(int edge, const Moment& m, bool apart) const;
  Contact<Rational> recorded_contact(GenId i, GenId j, const Rational& at) const;
  RecordedContacts::Lines recorded_lines(GenId i, GenId j, double adjacent_since) const;
  void pass_recorded(int edge, const Moment& m, PairEnd why);
  int watching(int edge, int besides = -1) const;
  bool certainly_in_contact(const CollideEvent& claim, double from, const BallPair& at) const;
  void check_recorded_contact(const CollideEvent& claim, int edge, const BallPair& at);

  // ---- hidden.cpp ----
  std::vector<int> prove_hidden_anew(const std::vector<int>& edges);

  // ---- collisions.cpp ----
  void collide(const CollideEvent& claim);
  void collide_exactly(const CollideEvent& claim);
  void collide_as_recorded(const CollideEvent& claim, int edge);
  void maneuver(const ManeuverEvent& claim);
  void require_maneuvers_before(double t);
  void collect_around(GenId i, GenId j);
  void end_around(const Moment& m);
  void require_no_contact_at_start(GenId g);
  void require_after_start() const;
  bool turned_at_present(GenId g) const;
  void begin_around(const Moment& m);
  void begin_pending_lives();
  void check_state(const CollideEvent& claim, int side, const RoundedState& truth);
  static BallVec2 claimed_center(const CollideEvent& claim, int side);
  bool certainly_near(const CollideEvent& claim, int side, const BallVec2& at) const;
  static bool certainly_equal(const CollideEvent& claim, int side, const RoundedState& truth);
  Rational allowed_distance(GenId g, const ExactVec2& after, const ExactVec2& at) const;
  void check_center(GenId g, const std::optional<ExactVec2>& p, const ExactVec2& after,
                    const ExactVec2& true_p);
  [[noreturn]] void refute_response(const CollideEvent& claim, const ExactPair& p);
  void turn(GenId g);
  void remark_velocities(bool centers);

  // ---- instant_order.cpp ----
  void require_no_flip_yet(GenId i, GenId j);
  void require_first_at_start(GenId i, GenId j);
  void place_turn(const Turn& turn);
  bool would_collide(GenId g, const DiskState& other) const;

  const Scene& scene_;
  HistorySource& history_;
  const CertifyOptions& options_;
  Certificate certificate_;
  Rational last_instant_;    // no event that the file may claim lies beyond it
  double search_end_;        // nor beyond this
  double horizon_down_;      // nor at or before it beyond the last instant
  Rational horizon_window_;  // the horizon less the tolerance
  double horizon_window_down_;
  Motion& motion_;
  std::optional<double> begin_;  // of a part that is not the first
  Replay replay_;
  Diagram& diagram_;
  CollapseSearch collapses_;
  ContactSearch contacts_;
  Chronology chronology_;
  CollisionLaw law_;
  double tolerance_up_;
  DoubleBall near_tolerance_;

  // Of the claims.
  std::vector<Claim> near_;            // read and not yet checked: one, nearly always
  bool ended_ = false;                 // no more to read
  std::vector<double> times_;          // of the claims read
  std::vector<std::int64_t> lines_;    // theirs
  std::vector<Replay::Place> places_;  // of the claims, read or not
  std::optional<Event> claim_;         // being checked
  std::int64_t line_ = 1;
  HalfEdge place_ = -1;
  Tie tie_;
  bool placed_ = false;
  std::int64_t processed_ = 0;

  // Of the lives.
  bool begun_ = false;
  Moment frontier_;                // the last event proved
  std::int64_t ties_ = 0;          // so many have been numbered
  std::int64_t frontier_tie_ = 0;  // what is tied so is simultaneous with it
  int instant_ = 0;                // numbers the instants at which events were proved
  std::vector<Life> lives_;
  std::unordered_map<int, Collapse> due_;  // the roots of edges whose lives are due, and old ones
  std::vector<Adjacency> pairs_;
  std::vector<std::shared_ptr<const Birth>> births_;  // by disk; empty before the first
  RecordedContacts recorded_;
  double revealed_ = 0;  // up to here a generator lay inside another at the last such moment
  RootlessBatch batch_;
  ApartBatch apart_;
  std::vector<int> illegal_;                          // edges that have to flip at this instant
  std::vector<int> pending_;                          // edges whose lives are pending
  std::optional<std::pair<GenId, GenId>> colliding_;  // by the claim being checked
  std::optional<GenId> maneuvering_;                  // the disk of the maneuver that is checked
  // The disks whose motion has changed, and whose lives have not begun anew yet: nothing is looked
  // for of these.
  std::vector<GenId> turning_;
  std::unordered_map<GenId, long> turned_;  // the instants of the disks' last maneuvers
  std::vector<Turn> turns_;                 // of this instant, in the order of the format
  std::vector<GenId> flipped_;  // generators of the edges that have flipped at this instant
  // Of the last collection: the spokes of the cells of the disks that turn, and with them the rims.
  std::vector<int> spokes_, around_;
  std::vector<long> collected_;  // by edge: the last collection it is in
  long collection_ = 0;

  bool remarked_centers_ = false, remarked_paths_ = false;
  double ulps_sum_ = 0;
  std::int64_t ulps_count_ = 0;
};

inline std::vector<GenId> generators(const Quad& q) { return {q.l, q.r, q.s, q.e}; }

}  // namespace voroproof::internal
