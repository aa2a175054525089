// The lines of `static`.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/resting_proof.h"
#include "corpus/truth/hardness.h"
#include "corpus/truth/lines.h"
#include "corpus/truth/proof.h"
#include "engine/resting_diagram.h"
#include "filtered/motion/given_motion.h"
#include "filtered/search/hidden_disks.h"
#include "filtered/search/resting_ties.h"

namespace voroproof::truth {

namespace {

using internal::GenId;
using internal::Quad;

struct Disks {
  Generators all;
  std::optional<Generator> frame;
};

// One draw a statement: the order of arguments is the compiler's.
double coordinate(Dice& dice) {
  const int exponent = -dice.whole(0, 4);
  return std::ldexp(dice.whole(-999, 999), exponent);
}

Generators anywhere(Dice& dice, int n, int largest) {
  Generators all;
  for (int k = 0; k < n; ++k) {
    all.push_back({'d', coordinate(dice), coordinate(dice), double(dice.whole(0, largest))});
  }
  return all;
}

// A part of a square lattice, with radii that may differ.
Generators lattice(Dice& dice, int n) {
  Generators all;
  const int columns = dice.whole(2, 4);
  const bool equal = dice.one_in(2);
  for (int k = 0; k < n; ++k) {
    const double r = equal ? 1 : dice.whole(0, 2);
    all.push_back({'d', 4.0 * (k % columns), 4.0 * double(k / columns), r});
  }
  return all;
}

// On one line, in a direction of rational slope.
Generators collinear(Dice& dice, int n) {
  const Direction d = any_direction(dice);
  const bool equal = dice.one_in(2);
  Generators all;
  for (int k = 0; k < n; ++k) {
    const double far = dice.whole(-40, 40);
    all.push_back({'d', d.a * far, d.b * far, equal ? 5.0 : dice.whole(0, 3 * d.h)});
  }
  return all;
}

// Disks in each other, touching from inside or not, and some twice.
Generators nested(Dice& dice, int n) {
  Generators all = anywhere(dice, (n + 1) / 2, 300);
  while (static_cast<int>(all.size()) < n) {
    Generator g = all[dice.next() % all.size()];
    const double r = std::floor(g.r * dice.whole(0, 4) / 4);
    if (dice.one_in(2)) {
      g.x += g.r - r;
      g.r = r;
    } else if (dice.one_in(2)) {
      g.r = r;
    }
    all.push_back(g);
  }
  return all;
}

Generators draw(Dice& dice, std::string_view name) {
  const int n = name == "few" ? dice.whole(0, 3) : dice.whole(4, 12);
  if (name == "collinear") return collinear(dice, n);
  if (name == "nested") return nested(dice, n);
  const bool random = name == "generic" || name == "few" || name == "overlap";
  const int base = random                            ? 0
                   : name == "tie" || name == "near" ? dice.whole(1, 2)
                                                     : dice.whole(0, 2);
  if (base == 2) {
    const Ingredients with = ingredients(dice, name);
    return touching(dice, dice.whole(4, 7), with);
  }
  Generators all = base == 1 ? lattice(dice, n) : anywhere(dice, n, name == "overlap" ? 900 : 120);
  for (Generator& g : all) {
    if (name == "equal" || name == "close") g.r = base == 1 ? 1 : 50;
    if (name == "point" && dice.one_in(2)) g.r = 0;
  }
  return all;
}

// In a container about as large as what is in it.
Generator frame_of(Dice& dice, const Generators& all) {
  double far = 1;
  for (const Generator& g : all) {
    far = std::max(far, std::max(std::fabs(g.x), std::fabs(g.y)) + g.r);
  }
  return {'c', coordinate(dice) / 8, coordinate(dice) / 8, std::ceil(far * dice.whole(3, 8) / 4)};
}

internal::MotionInput input_of(const Disks& disks) {
  internal::MotionInput input;
  const Generator frame = disks.frame.value_or(Generator{'c', 0, 0, 1});
  input.container_x = internal::to_rational(frame.x);
  input.container_y = internal::to_rational(frame.y);
  input.container_radius = internal::to_rational(frame.r);
  for (const Generator& g : disks.all) input.disks.push_back({g.x, g.y, g.r, 0.0, 0.0, 1.0});
  return input;
}

struct Answer {
  std::vector<std::array<int, 2>> pairs;
  std::vector<int> hidden;
  Proof proof;
};

// The precision that tells the signs of both circles of all edges of a diagram, which together
// prove it.
Proof proof(const Disks& disks, const std::vector<Quad>& edges) {
  const auto generator = [&](GenId g) { return g < 0 ? *disks.frame : disks.all[g]; };
  Proof all{53};
  for (const Quad& q : edges) {
    // Infinity has no place; its predicates are those of `exists`.
    if (!disks.frame && (q.l < 0 || q.r < 0 || q.s < 0 || q.e < 0)) continue;
    if (q.s == q.e) continue;
    for (const auto& [s, e] : {std::pair(q.s, q.e), std::pair(q.e, q.s)}) {
      const bool starts = s == q.s;
      const Generators g{generator(q.l), generator(starts ? s : q.r), generator(starts ? q.r : s),
                         generator(e)};
      const auto balls = [&](int bits) {
        return gap_sign(std::array{in_balls(g[0], bits), in_balls(g[1], bits), in_balls(g[2], bits),
                                   in_balls(g[3], bits)});
      };
      const auto exact = gap_sign(std::array{at(g[0], 0), at(g[1], 0), at(g[2], 0), at(g[3], 0)});
      const Proof one = proof_of_sign(exact, balls);
      if (one.bits == 0) return {};
      all.bits = std::max(all.bits, one.bits);
    }
  }
  return all;
}

Answer answer(const Disks& disks) {
  const auto frame = disks.frame ? internal::Frame::circle : internal::Frame::plane;
  internal::TierCounts counts;
  const internal::MotionInput input = input_of(disks);
  const internal::RestingDiagram diagram = resting_diagram(input, frame, {}, counts);
  const internal::RestingClaim claim{input, frame, diagram.host, diagram.edges};
  if (resting_proof(claim, {}, counts, 1).fault) {
    throw std::logic_error("truth: construction and certifier disagree");
  }
  Answer found;
  for (int g = 0; g < static_cast<int>(diagram.host.size()); ++g) {
    if (diagram.host[g] != internal::visible_disk) found.hidden.push_back(g);
  }
  if (disks.frame && found.hidden.size() + 1 == diagram.host.size()) {
    // A lone cell, without a vertex.
    const auto lone = std::find(diagram.host.begin(), diagram.host.end(), internal::visible_disk);
    found.pairs.push_back({-1, static_cast<int>(lone - diagram.host.begin())});
  }
  const internal::GivenMotion motion(input, {});
  const internal::RestingTies ties(motion, frame);
  std::set<std::array<int, 2>> pairs(found.pairs.begin(), found.pairs.end());
  for (const Quad& q : diagram.edges) {
    if (!disks.frame && (q.l < 0 || q.r < 0)) continue;
    if (q.s != q.e && ties.is_point(q)) continue;
    pairs.insert({std::min(q.l, q.r), std::max(q.l, q.r)});
  }
  found.pairs.assign(pairs.begin(), pairs.end());
  found.proof = proof(disks, diagram.edges);
  return found;
}

}  // namespace

std::string static_line(std::uint64_t k) {
  static constexpr std::array<std::string_view, 12> classes{
      "generic", "near",   "tie",       "few",   "equal", "close",
      "overlap", "nested", "collinear", "point", "wide",  "far"};
  const std::string_view name = classes[k % classes.size()];
  Dice dice(6, k);
  Disks disks{draw(dice, name), {}};
  Generators& all = disks.all;
  if (name == "close") make_close(dice, all);
  if (name == "near") nudge(dice, all.back(), dice.whole(16, 48));
  if (name == "generic") perturb(dice, all, 1);
  if (dice.one_in(2)) all.push_back(frame_of(dice, all));
  change_frame(dice, name, all);
  if (!all.empty() && all.back().kind == 'c') {
    disks.frame = all.back();
    all.pop_back();
  }
  const Answer found = answer(disks);
  std::string line = std::string(name) + ' ' + found.proof.text() + ' ' +
                     (disks.frame ? text_at_rest(*disks.frame) : "p") + ' ' +
                     std::to_string(all.size());
  for (const Generator& g : all) line += ' ' + text(g.x) + ' ' + text(g.y) + ' ' + text(g.r);
  line += ' ' + std::to_string(found.pairs.size());
  for (const auto& [a, b] : found.pairs) {
    line += ' ' + std::to_string(a) + ' ' + std::to_string(b);
  }
  line += ' ' + std::to_string(found.hidden.size());
  for (const int h : found.hidden) line += ' ' + std::to_string(h);
  return line;
}

}  // namespace voroproof::truth
