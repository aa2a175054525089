#include "apps/paper/paper_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>
#include <vector>

#include "exact/predicates.h"
#include "exact/topology/named_diagram.h"
#include "filtered/search/collapse.h"
#include "history/error.h"
#include "history/history_file.h"
#include "library/certification.h"
#include "library/maneuver_input.h"
#include "library/queries/followed_history.h"

namespace voroproof::internal {
namespace {

struct State {
  double since, x, y, vx, vy, r;
};

class Follower {
 public:
  Follower(const Scene& scene, const std::string& path, NamedDiagram diagram,
           const PaperCheckOptions& options)
      : path_(path), options_(options), diagram_(std::move(diagram)) {
    container_ = {round_nearest(scene.cx), round_nearest(scene.cy),
                  -round_nearest(scene.container_radius)};
    for (const DiskInput& d : scene.disks) {
      states_.push_back({0, round_nearest(d.x), round_nearest(d.y), round_nearest(d.vx),
                         round_nearest(d.vy), round_nearest(d.radius)});
      largest_ = std::max(largest_, states_.back().r);
    }
    sites_.resize(states_.size());
  }

  // Checks the instants of [now, t), or at the end of [now, t]. False where the check is over.
  bool advance(double t, bool end = false) {
    while (regular(next_) < t || (end && regular(next_) == t)) {
      if (!go_on(regular(next_))) return false;
      ++result_.regular;
      if (!check(regular(next_++))) return false;
    }
    if (!go_on(t)) return false;
    if (t > now_) {
      ++result_.midway;
      if (!check(now_ + (t - now_) / 2)) return false;
    }
    now_ = t;
    return true;
  }

  void follow(const FlipEvent& event, std::int64_t line) {
    try {
      diagram_.flip(event.quad);
    } catch (const std::invalid_argument& fault) {
      throw InputError(path_, line, "flip", fault.what());
    }
  }
  void follow(const CollideEvent& event, std::int64_t line) {
    if (event.i != container_id) set(event.i, event.t, event.p[0], event.v[0], line);
    set(event.j, event.t, event.p[1], event.v[1], line);
  }
  void follow(const ManeuverEvent& event, std::int64_t line) {
    set(event.disk, event.t, event.p, event.v, line);
  }

  const PaperCheckResult& result() const { return result_; }

 private:
  bool go_on(double t) const { return !options_.monitor || options_.monitor(t); }

  double regular(std::int64_t k) const { return static_cast<double>(k) * options_.step; }

  void set(GenId id, double t, const std::optional<Vec2>& p, const std::optional<Vec2>& v,
           std::int64_t line) {
    if (!p || !v) throw InputError(path_, line, p ? "v" : "p", "missing, and needed for this test");
    State& s = states_[id];
    s = {t, (*p)[0], (*p)[1], (*v)[0], (*v)[1], s.r};
  }

  // Every circle at an instant.
  bool check(double t) {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const State& s = states_[i];
      sites_[i] = {s.x + (t - s.since) * s.vx, s.y + (t - s.since) * s.vy, s.r};
    }
    by_x_.resize(sites_.size());
    for (std::size_t i = 0; i < sites_.size(); ++i) by_x_[i] = static_cast<GenId>(i);
    std::sort(by_x_.begin(), by_x_.end(),
              [&](GenId a, GenId b) { return sites_[a].x < sites_[b].x; });
    const Diagram& d = diagram_.diagram();
    for (Diagram::HalfEdge h = 0; h < 2 * d.edges(); ++h) {
      // Each vertex once, from its smallest generator.
      const Triple vertex{d.org(h), d.dest(h), d.apex(h)};
      if (canonical(vertex) == vertex && !check(t, vertex)) return false;
    }
    return true;
  }

  const Site<double>& site(GenId g) const { return g == container_id ? container_ : sites_[g]; }

  bool check(double t, const Triple& vertex) {
    ++result_.circles;
    const std::array<GenId, 3> own = disk_first(vertex[0], vertex[1], vertex[2]);
    const auto [i, j, k] = own;
    const TangentTriple<double> triple(site(i), site(j), site(k),
                                       j == container_id || k == container_id);
    const auto [x, y, rho] =
        tangent_circle(triple, [](double square) { return std::sqrt(std::max(square, 0.0)); });
    if (!(rho >= 0) || !std::isfinite(x) || !std::isfinite(y)) return fault(t, vertex, {}, 0);
    const auto is_own = [&](GenId g) { return g == own[0] || g == own[1] || g == own[2]; };
    if (!is_own(container_id)) {
      const double depth = std::hypot(x - container_.x, y - container_.y) + rho + container_.r;
      if (!judge(t, vertex, container_id, depth)) return false;
    }
    const double reach = rho + largest_;
    auto at = std::lower_bound(by_x_.begin(), by_x_.end(), x - reach,
                               [&](GenId g, double left) { return sites_[g].x < left; });
    for (; at != by_x_.end() && sites_[*at].x <= x + reach; ++at) {
      const Site<double>& other = sites_[*at];
      if (is_own(*at) || std::fabs(other.y - y) > reach) continue;
      const double depth = rho + other.r - std::hypot(other.x - x, other.y - y);
      if (!judge(t, vertex, *at, depth)) return false;
    }
    return true;
  }

  bool judge(double t, const Triple& vertex, GenId generator, double depth) {
    result_.deepest = std::max(result_.deepest, depth);
    return depth <= options_.tolerance || fault(t, vertex, generator, depth);
  }

  bool fault(double t, const Triple& vertex, std::optional<GenId> generator, double depth) {
    result_.first = {t, vertex, generator, depth};
    return false;
  }

  const std::string& path_;
  const PaperCheckOptions& options_;
  NamedDiagram diagram_;
  Site<double> container_{};
  std::vector<State> states_;
  double largest_ = 0;
  std::vector<Site<double>> sites_;
  std::vector<GenId> by_x_;
  double now_ = 0;
  std::int64_t next_ = 0;
  PaperCheckResult result_;
};

}  // namespace

PaperCheckResult paper_check(const Scene& scene, const std::string& history_path,
                             const PaperCheckOptions& options) {
  const int disks = static_cast<int>(scene.disks.size());
  HistoryReader history(history_path, disks, scene.sha256);
  const HistoryHeader& header = history.header();
  Diagram initial = initial_diagram(header, disks, history_path, [&] {
    ComputedMotion motion(motion_input(scene), options.motion);
    return diagram_of(disks, construct_initial(motion));
  });
  Follower follower(scene, history_path, NamedDiagram(std::move(initial)), options);
  while (const std::optional<Event> event = history.next()) {
    if (!follower.advance(time(*event))) return follower.result();
    std::visit([&](const auto& kind) { follower.follow(kind, history.line()); }, *event);
  }
  const auto* stop = std::get_if<HistoryStop>(&history.ending());
  follower.advance(stop ? stop->t : round_nearest(header.horizon), true);
  return follower.result();
}

}  // namespace voroproof::internal
