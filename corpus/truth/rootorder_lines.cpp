// The lines of `rootorder`.
#include <array>
#include <cmath>
#include <compare>
#include <optional>
#include <string_view>
#include <vector>

#include "corpus/truth/encounter.h"
#include "corpus/truth/lines.h"
#include "corpus/truth/proof.h"

namespace voroproof::truth {

namespace {

using Function = Polynomial<Rational>;

// A root of a flip polynomial, alone in a window.
struct Root {
  Time time;
  double from, to;
};

// The root nearest to the encounter.
std::optional<Root> root_near(const Encounter& e, const Function& f) {
  if (f.degree() < 1) return std::nullopt;
  const auto exact = [](double x) { return internal::to_rational(x); };
  const double most = 64 * e.span;
  const std::vector<Time> all = real_roots(f, exact(e.time - most), exact(e.time + most));
  std::optional<Root> nearest;
  double least = 0;
  for (const Time& t : all) {
    const double far = std::fabs(round_nearest(t) - e.time);
    if (nearest && far >= least) continue;
    least = far;
    nearest = Root{t, 0, 0};
  }
  if (!nearest) return std::nullopt;
  const double at = round_nearest(nearest->time);
  for (double width = e.span; at - width < at && at < at + width; width /= 2) {
    // Few digits.
    nearest->from = std::floor(at / width - 1) * width;
    nearest->to = nearest->from + 3 * width;
    const Rational a = exact(nearest->from), b = exact(nearest->to);
    if (sgn(f.evaluate(a)) == 0 || sgn(f.evaluate(b)) == 0) continue;
    if (isolate_roots(f, a, b).size() == 1) return nearest;
  }
  return std::nullopt;
}

// At `bits` both roots, whose larger one is less than 2^exponent, have enclosures of this width.
Proof proof(const Time& a, const Time& b, std::strong_ordering order) {
  if (order == 0) return {};
  int exponent = 0;
  std::frexp(std::fmax(std::fabs(round_nearest(a)), std::fabs(round_nearest(b))), &exponent);
  return proof_of(true, [&](int bits) -> std::optional<bool> {
    Rational width = 1;
    const int shift = exponent - bits;
    if (shift < 0) {
      width >>= -shift;
    } else {
      width <<= shift;
    }
    Time first = a, second = b;
    first.refine(width);
    second.refine(width);
    if (first.interval().hi < second.interval().lo || second.interval().hi < first.interval().lo) {
      return true;
    }
    return std::nullopt;
  });
}

std::string named(const Root& root, const std::array<int, 4>& ids) {
  std::string line = ' ' + truth::text(root.from) + ' ' + truth::text(root.to);
  for (const int id : ids) line += ' ' + std::to_string(id);
  return line;
}

}  // namespace

std::string rootorder_line(std::uint64_t k) {
  static constexpr std::array<std::string_view, 12> classes{
      "generic", "near", "tie",   "equal",     "close",  "late",
      "wide",    "wall", "point", "container", "degree", "growth"};
  const std::string_view name = classes[k % classes.size()];
  for (Dice dice(5, k);;) {
    const Distance distance = distance_of(dice, name);
    const Encounter e = encounter(dice, name, 5, distance);
    const std::array<int, 4> one{0, 1, 2, 3};
    const std::array<int, 4> other{0, dice.one_in(2) ? 1 : 3, 2, 4};
    const auto polynomial = [&](const std::array<int, 4>& ids) {
      return cotangency(moving(e.generators, ids));
    };
    const auto first = root_near(e, polynomial(one)), second = root_near(e, polynomial(other));
    if (!first || !second) continue;
    const auto order = compare(first->time, second->time);
    const internal::Sign sign = internal::sign_of(order < 0 ? -1 : order > 0 ? 1 : 0);
    if (!keeps_promise(distance, sign)) continue;
    std::string line = std::string(name) + ' ' + proof(first->time, second->time, order).text() +
                       ' ' + std::to_string(int(sign)) + named(*first, one) +
                       named(*second, other) + ' ' + std::to_string(e.generators.size());
    for (const Generator& g : e.generators) line += ' ' + text_in_motion(g);
    return line;
  }
}

}  // namespace voroproof::truth
