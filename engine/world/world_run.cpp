#include "engine/world/world_run.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/world/arrival.h"
#include "engine/world/first_diagram.h"
#include "engine/world/hosts.h"
#include "engine/world/jumps.h"
#include "engine/world/moving_rows.h"
#include "engine/world/world_sweep.h"
#include "exact/patience.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {
namespace {

Rational rounded(const Rational& x) { return to_rational(round_nearest(x)); }
Point2 rounded(const Rational& x, const Rational& y) { return {rounded(x), rounded(y)}; }

// How near to its time a jump is done: little happens in between, on paths that lead back there.
constexpr int kBitsBefore = 32;

// All that the scene has for one instant.
struct Scheduled {
  std::vector<GenId> leaves;
  std::map<GenId, WorldPiece> begins;  // by disk
};

class WorldRun final : public ChangeSink {
 public:
  WorldRun(const WorldMotion& world, const WorldOptions& options, WorldSink& sink)
      : world_(world),
        max_events_(options.max_events),
        sink_(sink),
        rows_(world.circle, static_cast<int>(world.paths.size()), options.filters),
        live_(static_cast<int>(world.paths.size())) {
    for (GenId g = 0; g < rows_.disks(); ++g) {
      const WorldPath& path = world.paths[static_cast<std::size_t>(g)];
      for (const WorldPiece& piece : path) {
        if (piece.from > 0) {
          schedule_[piece.from].begins.emplace(g, piece);
        } else {
          rows_.set(g, piece.from, piece.state);
          if (piece.start != PieceStart::enters) at_zero_.push_back({g, piece});
        }
      }
      if (!path.empty() && path.back().to) schedule_[*path.back().to].leaves.push_back(g);
    }
  }

  bool has_begun() const { return sweep_.has_value(); }
  // No event that was told is later, and no other earlier.
  double time() const { return sweep_ ? std::max(last_, sweep_->now().lo()) : 0; }

  std::uint64_t told() const { return told_; }

  void run() {
    live_ = first_diagram(rows_, first_scale());
    sink_.begin(live_.diagram().quads());
    sweep_.emplace(live_, rows_, 0, world_.horizon, *this);
    for (const PieceStart start : {PieceStart::jumps, PieceStart::turns}) {
      for (const auto& [g, piece] : at_zero_) {
        if (piece.start == start) tell_begin(g, piece, {}, {});
      }
    }
    sweep_->settle();
    sweep_->look_ahead();
    for (const auto& [t, scheduled] : schedule_) instant(t, scheduled);
    sweep_->run_up_to(world_.horizon);
  }

 private:
  using Steps = std::vector<Step>;

  // Some time after 0 before which nothing is scheduled.
  Rational first_scale() const {
    if (!schedule_.empty()) return schedule_.begin()->first;
    return sgn(world_.horizon) > 0 ? world_.horizon : Rational(1);
  }

  void instant(const Rational& t, const Scheduled& scheduled) {
    sweep_->run_before(t);
    for (const GenId g : scheduled.leaves) tell_event(t, Jump{g, go_out(g, t), {}, {}, {}, {}});
    for (const auto& [g, piece] : scheduled.begins) {
      if (piece.start == PieceStart::turns) continue;
      std::optional<Steps> out;
      if (piece.start == PieceStart::jumps) out = go_out(g, t);
      tell_begin(g, piece, std::move(out), come_in(g, piece, scheduled));
    }
    sweep_->begin_instant(t);
    for (const GenId g : std::exchange(led_, {})) {
      rows_.set(g, t, scheduled.begins.at(g).state);
      sweep_->arrive(g);
    }
    for (const auto& [g, piece] : scheduled.begins) {
      if (piece.start != PieceStart::turns) continue;
      rows_.set(g, piece.from, piece.state);
      tell_begin(g, piece, {}, {});
      sweep_->turn(g);
    }
    sweep_->settle();
    sweep_->look_ahead();
  }

  // A time between the last instant and t. What is scheduled for t, but is no turn, is done there:
  // the paths lead back to it.
  Rational just_before(const Rational& t) {
    const Rational earlier = rational_between(sweep_->now().exact(), WorldTime(t));
    const Rational before = t - ((t - earlier) >> kBitsBefore);
    sweep_->wait_until(before);
    return before;
  }

  Steps go_out(GenId g, const Rational& t) {
    const Rational before = just_before(t);
    JumpSteps jump;
    if (live_.is_visible(g)) {
      jump = shrink_out(live_, rows_, g, before);
    } else {
      live_.set_host(g, LiveDiagram::absent);
      jump.disks.push_back(g);
    }
    rows_.take_out(g);
    return up_to(t, std::move(jump));
  }

  Steps come_in(GenId g, const WorldPiece& piece, const Scheduled& scheduled) {
    const Rational before = just_before(piece.from);
    rows_.set(g, piece.from, piece.state);
    const std::vector<MetDisk> met = met_by(g, scheduled, piece.from);
    if (!met.empty()) {
      rows_.set(g, piece.from, led(piece.state, met));
      led_.insert(g);
    }
    return up_to(piece.from, grow_in(live_, rows_, g, before));
  }

  // Those that are one with the disk, which comes at t, but for others that are led there.
  std::vector<MetDisk> met_by(GenId g, const Scheduled& scheduled, const Rational& t) const {
    std::vector<MetDisk> met;
    for (GenId j = 0; j < rows_.disks(); ++j) {
      if (j == g || !rows_.is_there(j) || led_.contains(j)) continue;
      const auto begins = scheduled.begins.find(j);
      const bool changes = begins != scheduled.begins.end();
      if (changes && begins->second.start == PieceStart::jumps && j > g) continue;  // is to go
      if (!coincide_at(rows_, g, j, LazyTime(t))) continue;
      const GrowingDisk now = rows_.state_at(j, t);
      met.push_back({now, changes ? begins->second.state : now});
    }
    return met;
  }

  // The steps, with those that follow from them before t.
  Steps up_to(const Rational& t, JumpSteps jump) {
    following_ = &jump.steps;
    sweep_->suspect(jump.edges, jump.disks);
    sweep_->settle();
    sweep_->look_ahead();
    sweep_->run_before(t);
    following_ = nullptr;
    return std::move(jump.steps);
  }

  bool takes_swaps() const override { return following_ == nullptr; }
  void change(const LazyTime& t, const WorldChange& change) override {
    if (following_ != nullptr) {
      following_->push_back(step_of(change));
    } else {
      std::visit([&](const auto& what) { tell_event(to_rational(t.nearest()), what); }, change);
    }
  }

  // A run that stops within an instant tells nothing of it.
  void instant_is_over() override {
    if (following_ != nullptr) return;
    if (max_events_ > 0 && told_ + events_.size() > max_events_) {
      throw Undecided("the history has more than " + std::to_string(max_events_) + " events");
    }
    told_ += events_.size();
    for (const WorldEvent& event : events_) {
      last_ = std::max(last_, round_nearest(event.t));
      sink_.event(event);
    }
    events_.clear();
  }

  template <class What>
  void tell_event(const Rational& t, What what) {
    events_.push_back({rounded(t), std::move(what)});
  }

  void tell_begin(GenId g, const WorldPiece& piece, std::optional<Steps> out,
                  std::optional<Steps> in) {
    const GrowingDisk& s = piece.state;
    const Point2 center = rounded(s.x, s.y), velocity = rounded(s.vx, s.vy);
    if (piece.start == PieceStart::turns) {
      const WorldPath& path = world_.paths[static_cast<std::size_t>(g)];
      const auto same = std::find_if(path.begin(), path.end(), [&](const WorldPiece& other) {
        return other.from == piece.from && other.start == piece.start;
      });
      std::optional<Rational> growth;
      if (std::prev(same)->state.growth != s.growth) growth = rounded(s.growth);
      tell_event(piece.from, PathTurn{g, velocity, center, growth});
    } else {
      tell_event(piece.from,
                 Jump{g, std::move(out), std::move(in), center, velocity, rounded(s.radius)});
    }
  }

  const WorldMotion& world_;
  std::uint64_t max_events_;
  WorldSink& sink_;
  MovingRows rows_;
  LiveDiagram live_;
  std::map<Rational, Scheduled> schedule_;
  std::vector<std::pair<GenId, WorldPiece>> at_zero_;
  std::set<GenId> led_;  // that come at the present instant, on other paths than they have then
  std::optional<WorldSweep> sweep_;
  std::vector<WorldEvent> events_;  // those of the present instant
  std::uint64_t told_ = 0;
  double last_ = 0;             // the time of the last event that was told
  Steps* following_ = nullptr;  // where to the steps of a jump are told
};

}  // namespace

WorldOutcome run_world(const WorldMotion& world, const WorldOptions& options, WorldSink& sink) {
  std::optional<WorldRun> run;
  std::optional<Patience> patience;
  if (options.monitor) {
    patience.emplace([&] { return options.monitor(run ? run->time() : 0, run ? run->told() : 0); });
  }
  WorldOutcome outcome;
  try {
    run.emplace(world, options, sink);
    run->run();
    outcome.t = round_nearest(world.horizon);
    return outcome;
  } catch (const GivenUp&) {
    outcome.kind = WorldOutcome::Kind::interrupted;
    outcome.reason = "interrupted";
  } catch (const Undecided& u) {
    outcome.kind = WorldOutcome::Kind::stopped;
    outcome.reason = u.what();
  }
  if (!run->has_begun()) sink.begin({});
  outcome.t = run->time();
  return outcome;
}

}  // namespace voroproof::internal
