#include "voroproof/recorded_motion.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "filtered/motion/enclosures.h"
#include "filtered/numbers/dd_ball.h"
#include "history/error.h"
#include "library/closest_over.h"
#include "library/queries/openings.h"
#include "library/queries/over_time.h"
#include "library/queries/void_lives.h"
#include "library/true_moment.h"
#include "library/values.h"

namespace voroproof {
namespace internal {
namespace {

constexpr const char* history_name = "history";

HistoryCursor cursor_of(const Scene& scene, const voroproof::History& history,
                        const EngineOptions& options) {
  if (history.scene_sha256 != scene.sha256) {
    throw InputError(history_name, 1, "scene_sha256", "the history is one of another scene");
  }
  const auto source = memory_history(history, static_cast<int>(scene.disks.size()));
  return HistoryCursor(scene, *source, history_name,
                       [&] { return diagram_at(run_to(scene, 0, options)->motion(), 0); });
}

// A piece of a path whose time and velocity are binary64.
struct PlainPiece {
  bool plain = false, plain_since = false;
  double since = 0;
  std::array<DdBall, 2> center{};
  Vec2 velocity{};
};

PlainPiece plain_piece(const RecordedState& state) {
  PlainPiece out;
  const auto take = [](const Rational& q, double& x) {
    x = round_nearest(q);
    return to_rational(x) == q;
  };
  out.plain = out.plain_since = take(state.since, out.since);
  for (const int axis : {0, 1}) {
    out.center[axis] = dd_of(state.center[axis]);
    out.plain = take(state.velocity[axis], out.velocity[axis]) && out.plain;
  }
  return out;
}

// x + v (t - s), rounded to nearest, where double-doubles tell.
std::optional<double> plain_coordinate(const DdBall& x, double v, double t, double s) {
  const DdBall sum = x + DdBall(v) * (DdBall(t) - DdBall(s));
  if (!rounds_to_leading(sum)) return std::nullopt;
  return sum.hi;
}

}  // namespace
}  // namespace internal

struct RecordedMotion::Implementation {
  internal::HistoryCursor cursor;
  internal::Paths paths;
  int disks;
  internal::Rational end;                                // up to which it tells
  bool complete;                                         // end included
  std::vector<std::vector<internal::PlainPiece>> plain;  // by disk, like paths.pieces()
  std::vector<bool> plain_times;  // whether all of the disk's pieces start at binary64

  Implementation(const internal::Scene& scene, const History& history)
      : cursor(internal::cursor_of(scene, history, {})),
        paths(scene, cursor, internal::history_name),
        disks(static_cast<int>(scene.disks.size())),
        end(history.ending.complete ? internal::rational(history.horizon)
                                    : internal::to_rational(history.ending.t)),
        complete(history.ending.complete) {
    plain.resize(scene.disks.size());
    for (int g = 0; g < disks; ++g) {
      for (const auto& state : paths.pieces(g)) plain[g].push_back(internal::plain_piece(state));
      plain_times.push_back(std::all_of(plain[g].begin(), plain[g].end(),
                                        [](const auto& piece) { return piece.plain_since; }));
    }
  }

  internal::Rational time(const Number& t) const {
    internal::Rational q = internal::instant(t);
    if (complete ? q > end : q >= end) {
      throw std::invalid_argument("t: " + t.text() + " is beyond what the history covers, " +
                                  internal::number(end).text());
    }
    return q;
  }
  internal::Window window(const Number& from, const Number& to) const {
    internal::Window window{time(from), time(to)};
    if (window.from > window.to) throw std::invalid_argument("from: later than to");
    return window;
  }
  // A window in which something can open and close.
  internal::Window long_window(const Number& from, const Number& to) const {
    internal::Window both = window(from, to);
    if (both.from == both.to) throw std::invalid_argument("from: not before to");
    return both;
  }
  void require_generator(int g) const {
    if (g < internal::container_id || g >= disks) {
      throw std::invalid_argument("there is no generator " + std::to_string(g));
    }
  }
  void require_pair(int i, int j) const {
    require_generator(i);
    require_generator(j);
    if (i == j) throw std::invalid_argument("a generator is named twice");
  }

  // The piece in force at t. Where times are binary64, which they are nearly always, they are
  // compared as such.
  const internal::PlainPiece& plain_at(int disk, const Number& t,
                                       const internal::Rational& exact_t) const {
    const std::vector<internal::PlainPiece>& all = plain[disk];
    if (!t.is_double() || !plain_times[disk]) {
      return all[&paths.piece(disk, exact_t) - paths.pieces(disk).data()];
    }
    const auto after =
        std::upper_bound(all.begin(), all.end(), t.nearest(),
                         [](double time, const internal::PlainPiece& p) { return time < p.since; });
    return *std::prev(after);
  }

  Vector position(int disk, const Number& t, const internal::Rational& exact_t) const {
    const internal::PlainPiece& known = plain_at(disk, t, exact_t);
    Vector out{};
    std::optional<internal::ExactVec2> exact;
    for (const int axis : {0, 1}) {
      std::optional<double> x;
      if (known.plain && t.is_double()) {
        x = internal::plain_coordinate(known.center[axis], known.velocity[axis], t.nearest(),
                                       known.since);
      }
      if (!x && !exact) exact = internal::position_at(paths.piece(disk, exact_t), exact_t);
      out[axis] = x ? *x : internal::round_nearest((*exact)[axis]);
    }
    return out;
  }
};

namespace {

using internal::with_public_errors;

// Where a path leads into another disk or out of the container, the circles that the claimed
// diagram speaks of need not exist.
template <class Ask>
auto on_fitting_paths(Ask&& ask) {
  try {
    return ask();
  } catch (const std::domain_error&) {
    throw internal::InputError(internal::history_name, 0, "",
                               "the recorded paths do not fit the claimed diagram (certify tells "
                               "where)");
  }
}

std::vector<Opening> values_of(const std::vector<internal::Opening>& openings) {
  std::vector<Opening> out;
  for (const internal::Opening& o : openings) {
    out.push_back({internal::enclosure_value(o.from), internal::enclosure_value(o.to)});
  }
  return out;
}

LeastGap value_of(const internal::Paths& paths, const internal::LeastGap& least) {
  return {least.i, least.j, internal::number(least.t),
          internal::enclosure_value(internal::gap_of(paths, least)), least.contact};
}

}  // namespace

RecordedMotion::RecordedMotion(const Scene& scene, const History& history) {
  with_public_errors([&] {
    implementation_ = std::make_unique<Implementation>(internal::checked_scene(scene), history);
  });
}
RecordedMotion::RecordedMotion(RecordedMotion&&) noexcept = default;
RecordedMotion& RecordedMotion::operator=(RecordedMotion&&) noexcept = default;
RecordedMotion::~RecordedMotion() = default;

std::vector<Vector> RecordedMotion::positions(const Number& t) const {
  return with_public_errors([&] {
    const internal::Rational at = implementation_->time(t);
    std::vector<Vector> out;
    out.reserve(implementation_->disks);
    for (int g = 0; g < implementation_->disks; ++g) {
      out.push_back(implementation_->position(g, t, at));
    }
    return out;
  });
}

std::vector<Vector> RecordedMotion::velocities(const Number& t) const {
  return with_public_errors([&] {
    const internal::Rational at = implementation_->time(t);
    std::vector<Vector> out;
    out.reserve(implementation_->disks);
    for (int g = 0; g < implementation_->disks; ++g) {
      const internal::ExactVec2& v = implementation_->paths.piece(g, at).velocity;
      out.push_back({internal::round_nearest(v[0]), internal::round_nearest(v[1])});
    }
    return out;
  });
}

double RecordedMotion::gap(int i, int j, const Number& t) const {
  implementation_->require_pair(i, j);
  return with_public_errors(
      [&] { return internal::gap_at(implementation_->paths, i, j, implementation_->time(t)); });
}

std::vector<Neighbourhood> RecordedMotion::neighbours(int disk, const Number& from,
                                                      const Number& to) {
  implementation_->require_generator(disk);
  return with_public_errors([&] {
    std::vector<Neighbourhood> out;
    for (const auto& n : internal::neighbours_over(implementation_->cursor, disk,
                                                   implementation_->window(from, to))) {
      out.push_back({n.generator, internal::number(n.from), internal::number(n.to)});
    }
    return out;
  });
}

LeastGap RecordedMotion::least_gap(int i, int j, const Number& from, const Number& to) {
  implementation_->require_pair(i, j);
  return with_public_errors([&] {
    return value_of(implementation_->paths, internal::least_gap(implementation_->paths, i, j,
                                                                implementation_->window(from, to)));
  });
}

std::optional<LeastGap> RecordedMotion::least_gap(const Number& from, const Number& to) {
  return with_public_errors([&]() -> std::optional<LeastGap> {
    const auto least = internal::least_gap_of_all(implementation_->paths, implementation_->cursor,
                                                  implementation_->window(from, to));
    if (!least) return std::nullopt;
    return value_of(implementation_->paths, *least);
  });
}

std::vector<Opening> RecordedMotion::tunnel_openings(int i, int j, const Number& probe,
                                                     const Number& from, const Number& to) {
  implementation_->require_pair(i, j);
  return with_public_errors([&] {
    const internal::Rational radius = internal::probe_radius(probe);
    const internal::Window window = implementation_->long_window(from, to);
    return on_fitting_paths([&] {
      return values_of(internal::tunnel_openings(implementation_->paths, implementation_->cursor, i,
                                                 j, radius, window));
    });
  });
}

std::vector<Opening> RecordedMotion::void_openings(const std::array<int, 3>& vertex,
                                                   const Number& probe, const Number& from,
                                                   const Number& to) {
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
    implementation_->require_pair(vertex[i], vertex[j]);
  }
  return with_public_errors([&] {
    const internal::Rational radius = internal::probe_radius(probe);
    const internal::Window window = implementation_->long_window(from, to);
    return on_fitting_paths([&] {
      return values_of(internal::void_openings(implementation_->paths, implementation_->cursor,
                                               vertex, radius, window));
    });
  });
}

std::vector<VoidLife> RecordedMotion::void_lives(const Number& probe, const Number& from,
                                                 const Number& to) {
  return with_public_errors([&] {
    const internal::Rational radius = internal::probe_radius(probe);
    const internal::Window window = implementation_->long_window(from, to);
    return on_fitting_paths([&] {
      std::vector<VoidLife> out;
      for (const internal::VoidLife& life :
           internal::void_lives(implementation_->paths, implementation_->cursor, radius, window)) {
        VoidLife& last = out.emplace_back();
        last.from = internal::enclosure_value(life.from);
        last.to = internal::enclosure_value(life.to);
        last.before = life.before;
        last.after = life.after;
        if (life.at) last.at = internal::place_value(*life.at);
      }
      return out;
    });
  });
}

}  // namespace voroproof
