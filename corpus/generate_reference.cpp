#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "corpus/generate.h"
#include "corpus/generate_shared.h"

namespace voroproof::internal {
namespace {

// Places tried for one disk before the round counts as jammed.
constexpr int max_attempts = 200'000;
// Places tried in all rounds together, for each disk on average and in addition.
// A few disks at a high density often need several rounds; thousands of equal disks
// at density 0.5, the hardest case promised, need about 70 attempts a disk.
constexpr std::int64_t attempts_per_disk = 200;
constexpr std::int64_t more_attempts = 10 * max_attempts;

// lo (hi / lo)^u for u in [0, 1).
double between_log(double lo, double hi, double u) {
  Real power(hi), exponent(u);
  mpfr_div_d(power, power, lo, MPFR_RNDN);
  mpfr_pow(power, power, exponent, MPFR_RNDN);
  return std::clamp(power.times(lo), lo, hi);
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

}  // namespace voroproof::internal
