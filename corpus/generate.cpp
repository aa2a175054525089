#include "corpus/generate.h"

#include <mpfr.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace voroproof {
namespace {

struct Vec {
  double x = 0, y = 0;
};

// What the comparisons below add to touching distances. It is far above their
// rounding errors (a few units of 1e-16), so disks that pass are disjoint exactly.
constexpr double gap_margin = 1e-9;

// Places tried for one disk before the round counts as jammed.
constexpr int max_attempts = 200'000;
// Places tried in all rounds together, for each disk on average and in addition.
// A few disks at a high density often need several rounds; thousands of equal disks
// at density 0.5, the hardest case promised, need about 70 attempts a disk.
constexpr std::int64_t attempts_per_disk = 200;
constexpr std::int64_t more_attempts = 10 * max_attempts;

constexpr double two_pi = 6.283185307179586;

// Uniform numbers in [0, 1), multiples of 2^-53. The standard fixes the sequence
// of the engine, but not those of its own distributions.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

// A number of MPFR. 128 bits and a product that is exact in 192: each result is
// rounded correctly at 128 bits, then once more to binary64, on every platform.
class Real {
 public:
  explicit Real(double x, int bits = 128) {
    mpfr_init2(value_, bits);
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  ~Real() { mpfr_clear(value_); }
  operator mpfr_ptr() { return value_; }
  // x times this number, in binary64.
  double times(double x) {
    Real product(0, 192);
    mpfr_mul_d(product, value_, x, MPFR_RNDN);
    return mpfr_get_d(product, MPFR_RNDN);
  }

 private:
  mpfr_t value_;
};

// length (cos angle, sin angle).
Vec polar(double angle, double length) {
  Real cosine(0), sine(0), argument(angle);
  mpfr_sin_cos(sine, cosine, argument, MPFR_RNDN);
  return {cosine.times(length), sine.times(length)};
}

// lo (hi / lo)^u for u in [0, 1).
double between_log(double lo, double hi, double u) {
  Real power(hi), exponent(u);
  mpfr_div_d(power, power, lo, MPFR_RNDN);
  mpfr_pow(power, power, exponent, MPFR_RNDN);
  return std::clamp(power.times(lo), lo, hi);
}

double sine(double angle) {
  Real value(angle);
  mpfr_sin(value, value, MPFR_RNDN);
  return mpfr_get_d(value, MPFR_RNDN);
}

std::string text(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return std::string(buffer, end);
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

bool finite_and_positive(double x) { return std::isfinite(x) && x > 0; }
bool finite_and_not_negative(double x) { return std::isfinite(x) && x >= 0; }

Scene empty_scene(std::string family, int n, std::uint64_t seed, double container_radius,
                  double horizon) {
  Scene scene;
  scene.container_radius = to_rational(container_radius);
  scene.horizon = to_rational(horizon);
  scene.name = std::move(family) + "-n" + std::to_string(n) + "-seed" + std::to_string(seed);
  scene.seed = Integer(std::to_string(seed));
  scene.disks.reserve(n);
  return scene;
}

void add_disk(Scene& scene, Vec centre, double radius, Vec velocity) {
  DiskSpec disk;
  disk.x = to_rational(centre.x);
  disk.y = to_rational(centre.y);
  disk.radius = to_rational(radius);
  disk.vx = to_rational(velocity.x);
  disk.vy = to_rational(velocity.y);
  disk.mass = disk.radius * disk.radius;
  scene.disks.push_back(std::move(disk));
}

// Places disjoint disks in the container of the given radius. A hash grid with
// cells no smaller than the largest disk holds the disks placed so far: what can
// touch a new disk is in the 3 x 3 cells around it.
class Placement {
 public:
  Placement(double container_radius, const std::vector<double>& radii)
      : limit_(container_radius * (1 - gap_margin)),
        radii_(radii),
        centres_(radii.size()),
        next_(radii.size(), none) {
    const double largest = radii.empty() ? 1 : *std::max_element(radii.begin(), radii.end());
    const double count = std::max<double>(1, static_cast<double>(radii.size()));
    const double cell =
        std::max(2 * largest * (1 + 2 * gap_margin), 2 * container_radius / std::sqrt(count));
    columns_ = static_cast<int>(2 * container_radius / cell) + 1;
    scale_ = 1 / cell;
    origin_ = container_radius;
    first_.assign(static_cast<std::size_t>(columns_) * columns_, none);
  }

  // Puts the disk at a random free place, each attempt at the cost of 1 of the
  // budget; false when none was found.
  bool place(int disk, Uniform& random, std::int64_t& budget) {
    const double reach = std::max(limit_ - radii_[disk], 0.0);
    for (int attempt = 0; attempt < max_attempts && budget > 0; ++attempt) {
      --budget;
      const double x = (2 * random() - 1) * reach;
      const double y = (2 * random() - 1) * reach;
      if (x * x + y * y > reach * reach || !is_free(disk, {x, y})) continue;
      centres_[disk] = {x, y};
      int& head = first_[cell_of(y) * static_cast<std::size_t>(columns_) + cell_of(x)];
      next_[disk] = head;
      head = disk;
      return true;
    }
    return false;
  }

  const std::vector<Vec>& centres() const { return centres_; }

 private:
  static constexpr int none = -1;

  int cell_of(double coordinate) const {
    return std::clamp(static_cast<int>((coordinate + origin_) * scale_), 0, columns_ - 1);
  }

  bool is_free(int disk, Vec at) const {
    const int column = cell_of(at.x), row = cell_of(at.y);
    for (int j = std::max(row - 1, 0); j <= std::min(row + 1, columns_ - 1); ++j) {
      for (int i = std::max(column - 1, 0); i <= std::min(column + 1, columns_ - 1); ++i) {
        for (int other = first_[j * static_cast<std::size_t>(columns_) + i]; other != none;
             other = next_[other]) {
          const double dx = centres_[other].x - at.x, dy = centres_[other].y - at.y;
          const double apart = (radii_[other] + radii_[disk]) * (1 + gap_margin);
          if (dx * dx + dy * dy <= apart * apart) return false;
        }
      }
    }
    return true;
  }

  double limit_, origin_, scale_;
  const std::vector<double>& radii_;
  std::vector<Vec> centres_;
  std::vector<int> first_, next_;  // disks of a cell, as linked lists
  int columns_;
};

// Random places for disjoint disks, found in order of decreasing radius.
std::vector<Vec> place_all(double container_radius, const std::vector<double>& radii,
                           Uniform& random) {
  std::vector<int> order(radii.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return radii[i] > radii[j]; });
  std::int64_t budget = attempts_per_disk * static_cast<std::int64_t>(radii.size()) + more_attempts;
  while (budget > 0) {
    Placement placement(container_radius, radii);
    if (std::all_of(order.begin(), order.end(),
                    [&](int disk) { return placement.place(disk, random, budget); })) {
      return placement.centres();
    }
  }
  throw std::runtime_error(
      "generate: no free place was found for some disk; the density is too high");
}

std::string name_of(ReferenceOptions::Radii radii) {
  switch (radii) {
    case ReferenceOptions::Radii::uniform:
      return "uniform";
    case ReferenceOptions::Radii::log:
      return "log-uniform";
    case ReferenceOptions::Radii::equal:
      return "equal";
  }
  throw std::invalid_argument("generate: unknown distribution of radii");
}

std::string name_of(GridOptions::Motion motion) {
  switch (motion) {
    case GridOptions::Motion::rest:
      return "rest";
    case GridOptions::Motion::common:
      return "common";
    case GridOptions::Motion::random:
      return "random";
    case GridOptions::Motion::shear:
      return "shear";
  }
  throw std::invalid_argument("generate: unknown motion");
}

double random_radius(const ReferenceOptions& options, double u) {
  switch (options.radii) {
    case ReferenceOptions::Radii::uniform:
      return std::min(options.rmin + (options.rmax - options.rmin) * u, options.rmax);
    case ReferenceOptions::Radii::log:
      return between_log(options.rmin, options.rmax, u);
    case ReferenceOptions::Radii::equal:
      break;
  }
  return options.rmax;
}

// A square lattice centred at the origin.
struct Lattice {
  Lattice(int n, double spacing) : half(spacing / 2) {
    while (columns * columns < n) ++columns;
    rows = std::max<long>(1, (n + columns - 1) / columns);
  }
  long column(int i) const { return i % columns; }
  long row(int i) const { return i / columns; }
  // Twice the offset from the centre in units of the spacing: small integers.
  long across(int i) const { return 2 * column(i) - (columns - 1); }
  long up(int i) const { return 2 * row(i) - (rows - 1); }
  Vec centre(int i) const {
    return {half * static_cast<double>(across(i)), half * static_cast<double>(up(i))};
  }
  // Distance of the corners of the full rectangle from the origin.
  double extent() const {
    const auto w = static_cast<double>(columns - 1), h = static_cast<double>(rows - 1);
    return half * std::sqrt(w * w + h * h);
  }

  // The least multiple of the spacing from x on.
  double round_up(double x) const { return 2 * half * std::ceil(x / (2 * half)); }

  long columns = 1, rows = 1;
  double half;
};

}  // namespace

Scene generate_reference(const ReferenceOptions& options) {
  require(options.n >= 0, "generate: n must not be negative");
  require(finite_and_positive(options.rmax), "generate: rmax must be positive");
  if (options.radii != ReferenceOptions::Radii::equal) {
    require(options.rmin > 0 && options.rmin <= options.rmax,
            "generate: rmin must be positive and at most rmax");
  }
  require(options.density > 0 && options.density < 1, "generate: density must lie in (0, 1)");
  require(finite_and_not_negative(options.speed), "generate: speed must not be negative");
  require(options.restitution >= 0 && options.restitution <= 1,
          "generate: restitution must lie in [0, 1]");
  require(finite_and_not_negative(options.horizon), "generate: horizon must not be negative");

  Uniform random(options.seed);
  std::vector<double> radii(options.n);
  double area = 0;  // in units of pi
  for (double& radius : radii) {
    radius = random_radius(options, random());
    area += radius * radius;
  }
  const double container_radius = options.n == 0 ? options.rmax : std::sqrt(area / options.density);

  const std::vector<Vec> centres = place_all(container_radius, radii, random);

  Scene scene =
      empty_scene("reference", options.n, options.seed, container_radius, options.horizon);
  scene.restitution = to_rational(options.restitution);
  std::string range = text(options.rmax);
  if (options.radii != ReferenceOptions::Radii::equal)
    range = "from " + text(options.rmin) + " to " + range;
  scene.comment = "random disks: n " + std::to_string(options.n) + ", seed " +
                  std::to_string(options.seed) + ", radii " + name_of(options.radii) + " " + range +
                  ", density " + text(options.density) + ", speed " + text(options.speed) +
                  ", restitution " + text(options.restitution) + ", horizon " +
                  text(options.horizon);
  for (int i = 0; i < options.n; ++i) {
    add_disk(scene, centres[i], radii[i], polar(two_pi * random(), options.speed));
  }
  return scene;
}

Scene generate_grid(const GridOptions& options) {
  require(options.n >= 0, "generate: n must not be negative");
  require(finite_and_positive(options.radius), "generate: radius must be positive");
  require(std::isfinite(options.spacing) && options.spacing >= 2 * options.radius,
          "generate: spacing must be at least twice the radius");
  require(finite_and_not_negative(options.speed), "generate: speed must not be negative");
  require(finite_and_not_negative(options.horizon), "generate: horizon must not be negative");

  const Lattice lattice(options.n, options.spacing);
  // The power of two that brings the fastest row of a shear to at most `speed`.
  double shear = 1;
  while (shear * static_cast<double>(lattice.rows - 1) > 1) shear /= 2;
  Uniform random(options.seed);
  const auto velocity = [&](int i) -> Vec {
    switch (options.motion) {
      case GridOptions::Motion::rest:
        return {0, 0};
      case GridOptions::Motion::common:
        return {options.speed, 0};
      case GridOptions::Motion::random:
        return polar(two_pi * random(), options.speed);
      case GridOptions::Motion::shear:
        break;
    }
    return {options.speed * (shear * static_cast<double>(lattice.up(i))), 0};
  };

  const std::string motion = name_of(options.motion);
  Scene scene = empty_scene("grid-" + motion, options.n, options.seed,
                            lattice.round_up(lattice.extent() + options.radius + options.spacing),
                            options.horizon);
  scene.comment = "square lattice: n " + std::to_string(options.n) + ", seed " +
                  std::to_string(options.seed) + ", spacing " + text(options.spacing) +
                  ", radius " + text(options.radius) + ", motion " + motion + ", speed " +
                  text(options.speed) + ", horizon " + text(options.horizon);
  for (int i = 0; i < options.n; ++i) {
    add_disk(scene, lattice.centre(i), options.radius, velocity(i));
  }
  return scene;
}

Scene generate_swarm(const SwarmOptions& options) {
  require(options.n >= 0, "generate: n must not be negative");
  require(finite_and_positive(options.radius), "generate: radius must be positive");
  require(std::isfinite(options.spacing) && options.spacing > 2 * options.radius,
          "generate: spacing must be more than twice the radius");
  require(finite_and_positive(options.horizon), "generate: horizon must be positive");

  const Lattice lattice(options.n, options.spacing);
  const double n = options.n;
  double circle = lattice.extent() + options.spacing;
  if (options.n >= 3) circle = std::max(circle, options.spacing / (2 * sine(two_pi / 2 / n)));
  circle = lattice.round_up(circle);

  // Disks by direction from the centre, counterclockwise from the positive x
  // axis, compared exactly; the inner of two in one direction first.
  const auto by_direction = [&](int i, int j) {
    const long xi = lattice.across(i), yi = lattice.up(i);
    const long xj = lattice.across(j), yj = lattice.up(j);
    const bool lower_i = yi < 0 || (yi == 0 && xi < 0), lower_j = yj < 0 || (yj == 0 && xj < 0);
    if (lower_i != lower_j) return lower_j;
    const long cross = xi * yj - yi * xj;
    if (cross != 0) return cross > 0;
    return xi * xi + yi * yi < xj * xj + yj * yj;
  };
  std::vector<int> order(options.n);
  std::iota(order.begin(), order.end(), 0);
  // The disk at the very centre has no direction: it comes first.
  const auto middle = std::stable_partition(order.begin(), order.end(), [&](int i) {
    return lattice.across(i) == 0 && lattice.up(i) == 0;
  });
  std::stable_sort(middle, order.end(), by_direction);

  const double arrival = options.horizon / 2;
  Uniform random(options.seed);
  const double turn = random();
  std::vector<Vec> velocity(options.n);
  for (int place = 0; place < options.n; ++place) {
    const Vec from = lattice.centre(order[place]);
    const Vec to = polar(two_pi * ((place + turn) / n), circle);
    velocity[order[place]] = {(to.x - from.x) / arrival, (to.y - from.y) / arrival};
  }

  Scene scene =
      empty_scene("swarm", options.n, options.seed,
                  lattice.round_up(circle + options.radius + options.spacing), options.horizon);
  scene.comment = "square lattice to circle: n " + std::to_string(options.n) + ", seed " +
                  std::to_string(options.seed) + ", spacing " + text(options.spacing) +
                  ", radius " + text(options.radius) + ", horizon " + text(options.horizon);
  for (int i = 0; i < options.n; ++i) {
    add_disk(scene, lattice.centre(i), options.radius, velocity[i]);
    Maneuver stop;
    stop.t = to_rational(arrival);
    stop.disk = i;
    scene.maneuvers.push_back(std::move(stop));
  }
  return scene;
}

}  // namespace voroproof
