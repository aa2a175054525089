// The checker of one history, or of one part of it: proves the claims one by one.
//
// It carries, for every V-edge and for every pair of neighbours, the life that is open (docs/
// certificate.md, section 2). Each claim ends some lives and begins others; ending a life is where
// the proofs are. Its parts, each above those that it uses:
//   Setting          scene, motion, diagram, the tools that decide, the certificate
//   Claims, Front    what has been read; where the truth has come to
//   Refuter          what a refutation says
//   EdgeLives        lives of edges
//   PairLives        lives of pairs, by RecordedPairs or the exact truth
//   Instants         from one instant to the next
//   CellsAround      the lives around disks that turn
//   Flips, Turns     the claims, by Responses
//   ClaimOrder       which claim is next
//   FirstDivergence  what a history that is false lacks first
//   ExactTruth       pairs and turns under the exact truth
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "certify/cells_around.h"
#include "certify/claim_order.h"
#include "certify/exact_truth.h"
#include "certify/first_divergence.h"
#include "certify/flips.h"
#include "certify/turns.h"

namespace voroproof::internal {

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
  // Recorded truth: `motion` is that of checked_input(), new or as an earlier part of the history
  // has left it. The other references outlive the checker. `replay` is that of the claims before
  // the history, or before the part of it that begins at `begin`; before the whole it may hold the
  // diagram that the header gives, so that it need not be put together again. `places`: as Claims
  // takes them.
  Checker(const Scene& scene, GivenMotion& motion, HistorySource& history,
          const CertifyOptions& options, Replay replay, std::optional<double> begin = {},
          std::vector<Replay::Place> places = {});
  // Exact truth: `motion` is new, or as it is in truth at `begin`, and turns as `exact` has it.
  Checker(const Scene& scene, Motion& motion, HistorySource& history, const CertifyOptions& options,
          Replay replay, std::optional<double> begin, std::vector<Replay::Place> places,
          const ExactTruth::Make& exact);

  // The whole history, or the part of it up to `end`: the verdict of a part that is not the last
  // is `certified` where all is right up to there and the diagram is the one given. Once only.
  // Throws InputError and CertificationInterrupted.
  Certificate run(const PartEnd* end = nullptr);

 private:
  Checker(const Scene& scene, Motion& motion, GivenMotion* given, HistorySource& history,
          const CertifyOptions& options, Replay replay, std::optional<double> begin,
          std::vector<Replay::Place> places);

  void prove(const PartEnd* end);
  bool refill();
  void process();
  void start();
  void take_initial_diagram();
  void resume(double t);
  void finish_part(const PartEnd& end);
  void finish();
  void end_all_lives(const Moment& m, bool closed);
  void right_until(double t);
  void conclude(bool whole);
  void prefix_until(double t, bool briefly = false);

  Setting s_;
  std::optional<double> begin_;  // where a part begins that is not the first
  Front front_;
  Claims claims_;
  Refuter refuter_;
  EdgeLives edges_;
  PairLives pairs_;
  Instants instants_;
  CellsAround around_;
  Flips flips_;
  Turns turns_;
  ClaimOrder claim_order_;
  FirstDivergence first_divergence_;
  std::unique_ptr<ExactTruth> exact_;
};

}  // namespace voroproof::internal
