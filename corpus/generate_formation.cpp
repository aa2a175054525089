// Formation flights: from one formation through maneuvers to others, without collisions.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "corpus/formations.h"
#include "corpus/generate.h"
#include "corpus/generate_shared.h"

namespace voroproof::internal {
namespace {

using Places = std::vector<Point2>;

// A flight of all disks together: their places are mapped linearly about the swarm's centre, and
// the centre moves on.
struct Move {
  std::string_view name;
  int xx, xy, yx, yy, divisor;  // the linear map
  int dx, dy;                   // shift of the centre, in spacings
};

constexpr std::array<Move, 8> moves{{{"east", 1, 0, 0, 1, 1, 4, 0},
                                     {"north", 1, 0, 0, 1, 1, 0, 4},
                                     {"west", 1, 0, 0, 1, 1, -4, 0},
                                     {"south", 1, 0, 0, 1, 1, 0, -4},
                                     {"turn", 3, -4, 4, 3, 5, 0, 0},
                                     {"shear", 4, 3, 0, 4, 4, 0, 0},
                                     {"spread", 3, 0, 0, 3, 2, 0, 0},
                                     {"rest", 1, 0, 0, 1, 1, 0, 0}}};

std::vector<Vec> in_doubles(const Places& places) {
  std::vector<Vec> rounded;
  for (const Point2& p : places) rounded.push_back({round_nearest(p.x), round_nearest(p.y)});
  return rounded;
}

Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }

// Which goal each disk flies to. No two disks would fly a shorter way (in the sum of the squares)
// by exchanging their goals: (a_i - a_j) . (b_i - b_j) >= 0. Hence they approach each other at most
// to 1/sqrt 2 of the lesser of their distances at both ends. (Turpin, Michael & Kumar, "CAPT:
// Concurrent assignment and planning of trajectories for multiple robots", 2014, with the exchange
// of pairs in place of the best assignment, of which their proof uses no more.)
std::vector<int> assign(const std::vector<Vec>& from, const std::vector<Vec>& goals,
                        double spacing) {
  const auto sorted = [](const std::vector<Vec>& points) {
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
      return std::pair(points[i].x, points[i].y) < std::pair(points[j].x, points[j].y);
    });
    return order;
  };
  const std::vector<int> disks = sorted(from), places = sorted(goals);
  std::vector<int> goal(from.size());
  for (std::size_t k = 0; k < disks.size(); ++k) goal[disks[k]] = places[k];
  // Each exchange makes the sum smaller by twice the margin, so there is an end of it.
  const double margin = gap_margin * spacing * spacing;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < from.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (dot(from[i] - from[j], goals[goal[i]] - goals[goal[j]]) >= -margin) continue;
        std::swap(goal[i], goal[j]);
        changed = true;
      }
    }
  }
  return goal;
}

// Whether no two disks touch on straight ways from one set of places to the other.
bool keep_apart(const std::vector<Vec>& from, const std::vector<Vec>& to, double radius) {
  const double reach = 2 * radius * (1 + gap_margin);
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec before = from[i] - from[j], way = (to[i] - to[j]) - before;
      const double length = dot(way, way);
      const double nearest = length > 0 ? std::clamp(-dot(before, way) / length, 0.0, 1.0) : 0;
      const Vec apart{before.x + nearest * way.x, before.y + nearest * way.y};
      if (!(dot(apart, apart) > reach * reach)) return false;
    }
  }
  return true;
}

// Where the disks are at the beginning and after each step of the flight.
class Flight {
 public:
  Flight(int n, const Rational& spacing) : n_(n), spacing_(spacing) {}

  void begin(std::string_view formation) {
    relative_ = formation_places(formation, n_, spacing_);
    stop();
  }

  void step(std::string_view name) {
    const auto move =
        std::find_if(moves.begin(), moves.end(), [&](const Move& m) { return m.name == name; });
    if (move != moves.end()) {
      for (Point2& p : relative_) {
        const Point2 old = p;
        p.x = (move->xx * old.x + move->xy * old.y) / move->divisor;
        p.y = (move->yx * old.x + move->yy * old.y) / move->divisor;
      }
      centre_.x += move->dx * spacing_;
      centre_.y += move->dy * spacing_;
    } else {
      const Places goals = formation_places(name, n_, spacing_);
      const std::vector<int> goal =
          assign(in_doubles(relative_), in_doubles(goals), round_nearest(spacing_));
      for (std::size_t i = 0; i < goal.size(); ++i) relative_[i] = goals[goal[i]];
    }
    stop();
  }

  const std::vector<Places>& stops() const { return stops_; }

 private:
  void stop() {
    Places places = relative_;
    for (Point2& p : places) {
      p.x += centre_.x;
      p.y += centre_.y;
    }
    stops_.push_back(std::move(places));
  }

  int n_;
  Rational spacing_;
  Point2 centre_;
  Places relative_;  // to the centre
  std::vector<Places> stops_;
};

}  // namespace

Scene generate_formation(const FormationOptions& options) {
  require(options.n >= 0 && options.n <= max_formation_disks,
          "generate: n must lie between 0 and 5000");
  require(finite_and_positive(options.radius), "generate: radius must be positive");
  require(std::isfinite(options.spacing) && options.spacing > 2 * options.radius,
          "generate: spacing must be more than twice the radius");
  require(finite_and_positive(options.horizon), "generate: horizon must be positive");
  require(!options.flight.empty() && is_formation(options.flight.front()),
          "generate: a flight begins with a formation");

  Flight flight(options.n, to_rational(options.spacing));
  flight.begin(options.flight.front());
  std::string route = options.flight.front();
  for (std::size_t k = 1; k < options.flight.size(); ++k) {
    flight.step(options.flight[k]);
    route += "-" + options.flight[k];
  }
  const std::vector<Places>& stops = flight.stops();

  double extent = 0;
  std::vector<Vec> before;
  for (const Places& stop : stops) {
    std::vector<Vec> here = in_doubles(stop);
    for (const Vec p : here) extent = std::max(extent, std::sqrt(dot(p, p)));
    require(keep_apart(before.empty() ? here : before, here, options.radius),
            "generate: disks of this radius would collide on this flight");
    before = std::move(here);
  }
  const double container =
      options.spacing * (std::ceil((extent + options.radius) / options.spacing) + 1);

  Scene scene;
  scene.container_radius = to_rational(container);
  scene.horizon = to_rational(options.horizon);
  scene.name = "formation-" + route + "-n" + std::to_string(options.n);
  scene.comment = "formation flight: " + route + ", n " + std::to_string(options.n) + ", spacing " +
                  text(options.spacing) + ", radius " + text(options.radius) + ", horizon " +
                  text(options.horizon);
  const Rational step = scene.horizon / static_cast<unsigned long>(stops.size());
  const auto velocity = [&](std::size_t k, int i) -> Point2 {
    if (k + 1 == stops.size()) return {0, 0};
    return {(stops[k + 1][i].x - stops[k][i].x) / step, (stops[k + 1][i].y - stops[k][i].y) / step};
  };
  const Rational radius = to_rational(options.radius);
  for (int i = 0; i < options.n; ++i) {
    const Point2 v = velocity(0, i);
    scene.disks.push_back(
        {stops[0][i].x, stops[0][i].y, radius, v.x, v.y, Rational(radius * radius)});
  }
  for (std::size_t k = 1; k < stops.size(); ++k) {
    for (int i = 0; i < options.n; ++i) {
      const Point2 v = velocity(k, i);
      scene.maneuvers.push_back({step * static_cast<unsigned long>(k), i, v.x, v.y});
    }
  }
  return scene;
}

FormationOptions formation_preset(const std::string& name) {
  FormationOptions options;
  const auto set = [&](int n, std::vector<std::string> flight) {
    options.n = n;
    options.horizon = 16 * static_cast<double>(flight.size());
    options.flight = std::move(flight);
  };
  if (name == "figure24") {
    set(20, {"frame", "circle"});
  } else if (name == "h-to-y") {
    set(19, {"h", "y"});
  } else if (name == "segments58") {
    set(58, {"square", "turn", "rings", "east", "h", "y", "west", "circle", "staggered"});
  } else if (name == "drones1218") {
    set(1218, {"square", "turn", "shear", "staggered"});
  } else if (name == "drones2018") {
    set(2018, {"square", "east", "shear", "shear", "rings"});
  } else {
    throw std::invalid_argument("generate: no preset is called '" + name + "'");
  }
  return options;
}

}  // namespace voroproof::internal
