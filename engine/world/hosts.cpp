#include "engine/world/hosts.h"

#include "engine/world/next_root.h"
#include "exact/patience.h"
#include "filtered/worlds/rough_edge.h"

namespace voroproof::internal {
namespace {

// How far g is outside of another disk, or inside of the frame: root of `square`, with this sign,
// and `rest`.
struct Gap {
  Sign sign_of_root;
  TimePolynomial square, rest;

  Gap(const MovingRows& rows, GenId g, GenId j)
      : sign_of_root(j == container_id ? Sign::negative : Sign::positive),
        rest(-rows.excess(g, j)) {
    const Site<TimePolynomial>&a = rows.site(g), &b = j < 0 ? rows.circle() : rows.site(j);
    const TimePolynomial x = a.x - b.x, y = a.y - b.y;
    square = x * x + y * y;
  }
};

// The sign of a - b just after the instant.
Sign compare_gaps(const Gap& a, const Gap& b, const WorldTime& t) {
  const TimePolynomial rest = a.rest - b.rest, squares = rest * rest + a.square - b.square;
  // That of the root of a and the rest, against the root of b.
  const Sign of_rest = sign_after(rest, t);
  const Sign one = sign_with_root(of_rest, a.sign_of_root, sign_after(rest * rest - a.square, t));
  const Sign other = sign_after(b.square, t) == Sign::zero ? Sign::zero : -b.sign_of_root;
  if (one == other || other == Sign::zero) return one;
  if (one == Sign::zero) return other;
  const TimePolynomial twice = rest + rest;
  const Sign of_twice = a.sign_of_root == Sign::positive ? of_rest : -of_rest;
  const Sign larger = sign_with_root(sign_after(squares, t), of_twice,
                                     sign_after(squares * squares - twice * twice * a.square, t));
  return larger == Sign::zero ? Sign::zero : larger == Sign::positive ? one : other;
}

}  // namespace

bool hides_after(const MovingRows& rows, GenId j, GenId g, const LazyTime& t) {
  if (j == container_id && !rows.has_circle()) return false;
  const bool apart = are_apart(rows.rough(), g, j, t.lo(), t.hi());
  if (apart && j != container_id) return false;
  const Sign p = apart ? Sign::positive : sign_after(rows.tangency_of(g, j), t.exact());
  const Sign excess = sign_after(rows.excess(g, j), t.exact());
  if (j == container_id) return p != Sign::positive || excess != Sign::negative;
  if (p == Sign::positive || excess == Sign::negative) return false;
  return excess == Sign::positive || j < g;
}

GenId host_after(const MovingRows& rows, GenId g, const LazyTime& t) {
  const auto one_of = [&](GenId inner) {
    for (GenId j = container_id; j < rows.disks(); ++j) {
      if (j == inner || (j >= 0 && !rows.is_there(j))) continue;
      Patience::ask();
      if (hides_after(rows, j, inner, t)) return j;
    }
    return LiveDiagram::visible;
  };
  GenId host = one_of(g);
  while (host >= 0) {
    const GenId outer = one_of(host);
    if (outer == LiveDiagram::visible) break;
    host = outer;
  }
  return host;
}

std::vector<GenId> also_left_at(const MovingRows& rows, const LiveDiagram& live, GenId host,
                                GenId g, const LazyTime& t) {
  const DoubleBall about = DoubleBall::hull(t.lo(), t.hi());
  std::vector<GenId> all;
  for (GenId j = 0; j < rows.disks(); ++j) {
    if (j == host || j == g || !rows.is_there(j) || !live.is_visible(j)) continue;
    if (is_certain(sign(rows.rough().tangency_of(g, j, about)))) continue;
    if (sign_at(rows.tangency_of(g, j), t.exact()) != Sign::zero) continue;
    if (sign_at(rows.excess(g, j), t.exact()) != Sign::negative) all.push_back(j);
  }
  return all;
}

GenId nearest_after(const MovingRows& rows, GenId host, const std::vector<GenId>& others, GenId g,
                    const LazyTime& t) {
  GenId best = host;
  for (const GenId j : others) {
    if (compare_gaps(Gap(rows, g, j), Gap(rows, g, best), t.exact()) == Sign::negative) best = j;
  }
  return best;
}

bool coincide_at(const MovingRows& rows, GenId i, GenId j, const LazyTime& t) {
  if (are_apart(rows.rough(), i, j, t.lo(), t.hi())) return false;
  const Site<TimePolynomial>&a = rows.site(i), &b = rows.site(j);
  return sign_at(a.r - b.r, t.exact()) == Sign::zero &&
         sign_at(a.x - b.x, t.exact()) == Sign::zero && sign_at(a.y - b.y, t.exact()) == Sign::zero;
}

std::optional<WorldTime> exit_after(const MovingRows& rows, GenId j, GenId g, const LazyTime& now,
                                    const Rational& end) {
  const TimePolynomial p = rows.tangency_of(g, j), excess = rows.excess(g, j);
  const auto leaves = [&](const WorldTime& t, Sign) { return !hides_after(rows, j, g, t); };
  std::optional<WorldTime> out = first_root(p, now.exact(), end, leaves);
  // Where both are the same for an instant the other one may be inside afterwards.
  std::optional<WorldTime> passed = first_root(excess, now.exact(), end, leaves);
  return !out || (passed && compare(*passed, *out) < 0) ? passed : out;
}

std::optional<LazyTime> meeting_after(const MovingRows& rows, GenId i, GenId j, const LazyTime& now,
                                      const Rational& end) {
  const auto [kind, root] = rough_meeting(rows.rough(), i, j, now.lo(), now.hi(), round_up(end));
  if (kind == RoughCollapse::Kind::none) return std::nullopt;
  if (kind == RoughCollapse::Kind::fails) {
    return LazyTime(root.lo, root.hi, [&rows, i, j] { return rows.tangency_of(i, j); });
  }
  const auto any = [](const WorldTime&, Sign) { return true; };
  return first_root(rows.tangency_of(i, j), now.exact(), end, any);
}

}  // namespace voroproof::internal
