// The common state of the checker's parts: the scene, what was asked for, the motion, the diagram,
// the tools that decide, and the certificate that is being made.
#pragma once

#include <utility>

#include "certify/collision_law.h"
#include "certify/options.h"
#include "certify/replay.h"
#include "filtered/search/moment.h"
#include "filtered/search/point_cells.h"
#include "history/history_reader.h"

namespace voroproof::internal {

class ExactTruth;

struct Setting {
  // `of_motion` is that of checked_input(); under the recorded truth `is_given` is the same, else
  // null. All but the replay outlive the setting.
  Setting(const Scene& of_scene, Motion& of_motion, GivenMotion* is_given,
          const HistoryHeader& of_history, const CertifyOptions& asked, Replay known)
      : scene(of_scene),
        header(of_history),
        options(asked),
        last_instant(header.horizon + header.horizon_error),
        search_end(round_up(last_instant)),
        horizon_down(round_down(last_instant)),
        horizon_window(header.certain_horizon() - options.tolerance),
        horizon_window_down(round_down(horizon_window)),
        tolerance_up(round_up(options.tolerance)),
        near_tolerance(ball(options.tolerance)),
        motion(of_motion),
        given(is_given),
        replay(std::move(known)),
        diagram(replay.diagram()),
        collapses(motion, certificate.tiers),
        contacts(motion, certificate.tiers),
        points(motion, contacts),
        chronology(motion, collapses, contacts, certificate.tiers),
        law(scene, options.law_tolerance) {}
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

  const Scene& scene;
  const HistoryHeader& header;
  const CertifyOptions& options;
  Rational last_instant;       // no event that the file may claim lies beyond it
  double search_end;           // nor beyond this
  double horizon_down;         // nor at or before it beyond the last instant
  Rational horizon_window;     // the horizon less the tolerance
  double horizon_window_down;  // rounded
  double tolerance_up;
  DoubleBall near_tolerance;
  Motion& motion;
  GivenMotion* const given;     // recorded truth: the motion
  ExactTruth* exact = nullptr;  // exact truth: what only that knows
  Replay replay;                // after the claims proved so far
  Diagram& diagram;
  Certificate certificate;
  CollapseSearch collapses;
  ContactSearch contacts;
  PointCells points;
  Chronology chronology;
  CollisionLaw law;
};

// A false claim is called mistimed where the event comes within so many tolerances of it.
inline constexpr int mistimed_tolerances = 1000;

inline std::vector<GenId> generators(const Quad& q) { return {q.l, q.r, q.s, q.e}; }

}  // namespace voroproof::internal
