// The lines of `collapse`.
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "corpus/truth/encounter.h"
#include "corpus/truth/lines.h"
#include "corpus/truth/proof.h"

namespace voroproof::truth {

namespace {

using internal::Sign;
using Function = Polynomial<Rational>;

// A zero of the gap between the circle of the first three and the fourth.
struct Zero {
  Rounded time;
  int order;
  Sign after;
};

struct Answer {
  Sign start;
  std::vector<Zero> zeros;
};

// The gap's sign is that of q = G + sqrt(Gamma) C. Its product with the conjugate is a positive
// multiple of the cotangency f, so that its zeros are among those of f, and so are the conjugate's.
class GapInTime {
 public:
  explicit GapInTime(const Moving& g)
      : g_(g), v_(disk_first(g[0], g[1], g[2])), triple_(circle(v_[0], v_[1], v_[2])) {
    const internal::InCircleParts<Function> parts(triple_, row_of(v_[0], g[3]));
    big_ = parts.g();
    small_ = parts.c();
    cotangency_ = cotangency(std::array{v_[0], v_[1], v_[2], g[3]});
  }

  bool is_constant() const { return cotangency_.degree() < 1; }
  Sign sign_at(const Rational& t) const { return gap_sign(at(g_, t)); }
  std::vector<Time> candidates(const Rational& from, const Rational& to) const {
    return real_roots(cotangency_, from, to);
  }
  // The order of the zero at a root of the cotangency: 0 where it is the conjugate's alone.
  int order(const Time& t) const {
    const auto [k, sign_big] = leading(big_, t);
    const auto [m, sign_small] = leading(small_, t);
    const int all = leading(cotangency_, t).first;
    if (k != m) return std::min(k, m);
    // One of both has a zero of just this order, and the other one all that is left.
    return sign_big == sign_small ? k : all - k;
  }

 private:
  // How many derivatives of f vanish at t, f itself included, and the sign of the next.
  static std::pair<int, Sign> leading(Function f, const Time& t) {
    for (int k = 0; !f.is_zero(); ++k, f = f.derivative()) {
      const Sign s = internal::sign_at(f, t);
      if (s != Sign::zero) return {k, s};
    }
    return {1 << 20, Sign::zero};
  }

  const Moving& g_;
  std::array<Numbers<Function>, 3> v_;
  internal::TangentTriple<Function> triple_;
  Function big_, small_, cotangency_;
};

Answer answer(const GapInTime& gap, const Rational& from, const Rational& to) {
  Answer found{gap.sign_at(from), {}};
  const std::vector<Time> all = gap.candidates(from, to);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int order = gap.order(all[k]);
    if (order == 0) continue;
    const Time next = k + 1 < all.size() ? all[k + 1] : Time(to);
    found.zeros.push_back({rounded(all[k]), order, gap.sign_at(rational_between(all[k], next))});
  }
  return found;
}

// A window around the encounter in which the question is plain, if there is one.
std::optional<std::array<double, 2>> window(Dice& dice, const Encounter& e, const Moving& g,
                                            const GapInTime& gap) {
  double before = e.span * dice.whole(1, 64), after = e.span * dice.whole(1, 64);
  for (int k = 0; k < 24; ++k, before /= 2, after /= 2) {
    const double from = e.time - before, to = e.time + after;
    if (!(from < e.time && e.time < to)) return std::nullopt;
    const Rational a = internal::to_rational(from), b = internal::to_rational(to);
    if (!is_plain(g, a, b)) continue;
    if (gap.sign_at(a) == Sign::zero || gap.sign_at(b) == Sign::zero) continue;
    return std::array{from, to};
  }
  return std::nullopt;
}

bool keeps_promise(std::string_view name, const Answer& a) {
  if (name == "double") return !a.zeros.empty() && a.zeros[0].order == 2;
  if (name == "tie") return !a.zeros.empty() && a.zeros[0].time.lo == a.zeros[0].time.hi;
  return true;
}

// By the signs at both ends of the window, and on both sides of each zero that is no binary64.
Proof proof(const Generators& g, const Answer& a, const std::array<double, 2>& window) {
  std::vector<double> times(window.begin(), window.end());
  for (const Zero& zero : a.zeros) {
    if (zero.order % 2 == 0 || zero.time.lo == zero.time.hi) return {};
    times.push_back(zero.time.lo);
    times.push_back(zero.time.hi);
  }
  return proof_of(true, [&](int bits) -> std::optional<bool> {
    for (const double time : times) {
      const Rational t = internal::to_rational(time);
      const std::array<Numbers<Ball>, 4> numbers{at(g[0], t, bits), at(g[1], t, bits),
                                                 at(g[2], t, bits), at(g[3], t, bits)};
      if (!internal::is_certain(gap_sign(numbers))) return std::nullopt;
    }
    return true;
  });
}

}  // namespace

std::string collapse_line(std::uint64_t k) {
  static constexpr std::array<std::string_view, 12> classes{
      "generic", "near", "tie",  "double",    "equal", "close",
      "late",    "wide", "wall", "container", "point", "growth"};
  const std::string_view name = classes[k % classes.size()];
  for (Dice dice(4, k);;) {
    const Distance distance = name == "double" ? Distance::tie : distance_of(dice, name);
    const Encounter e = encounter(dice, name, 4, distance);
    const Moving g = moving(e.generators, {0, 1, 2, 3});
    const GapInTime gap(g);
    if (gap.is_constant()) continue;
    const auto within = window(dice, e, g, gap);
    if (!within) continue;
    const Answer a =
        answer(gap, internal::to_rational((*within)[0]), internal::to_rational((*within)[1]));
    if (!keeps_promise(name, a)) continue;
    std::string line = std::string(name) + ' ' + proof(e.generators, a, *within).text() + ' ' +
                       std::to_string(int(a.start)) + ' ' + std::to_string(a.zeros.size());
    for (const Zero& zero : a.zeros) {
      line += ' ' + text(zero.time) + ' ' + std::to_string(zero.order) + ' ' +
              std::to_string(int(zero.after));
    }
    line += ' ' + text((*within)[0]) + ' ' + text((*within)[1]);
    for (const Generator& m : e.generators) line += ' ' + text_in_motion(m);
    return line;
  }
}

}  // namespace voroproof::truth
