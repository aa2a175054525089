#include "tests/adversary/paths.h"

#include <algorithm>
#include <cmath>

namespace voroproof::internal::adversary {

Wide square_root(Wide x) {
  if (!(x > 0)) return 0;
  Wide root = std::sqrt(static_cast<Real>(x));
  for (int k = 0; k < 2; ++k) root = (root + x / root) / 2;
  return root;
}

namespace {

// The roots of a quadratic with a > 0 and a positive discriminant, without cancellation.
bool two_roots(const Gap& g, Wide& first, Wide& second) {
  const Wide discriminant = g.b * g.b - g.a * g.c;
  if (g.a == 0 || !(discriminant > 0)) return false;
  const Wide root = square_root(discriminant);
  const Wide q = g.b > 0 ? -g.b - root : root - g.b;
  const Wide x = q / g.a, y = q == 0 ? Wide(0) : g.c / q;
  first = x < y ? x : y;
  second = x < y ? y : x;
  return true;
}

}  // namespace

// Two disks: a > 0, overlap between the roots. The container: a < 0, overlap outside of them.
bool Gap::entry(Wide& t) const {
  Wide other;
  if (a >= 0) return two_roots(*this, t, other);
  return two_roots({-a, -b, -c}, other, t);
}

bool Gap::exit(Wide& t) const {
  Wide other;
  if (a >= 0) return two_roots(*this, other, t);
  return two_roots({-a, -b, -c}, t, other);
}

Wide Motion::reach(int i, int j) const {
  const Wide r = scene->disks[static_cast<std::size_t>(j)].radius;
  return i < 0 ? Wide(scene->radius) - r
               : Wide(scene->disks[static_cast<std::size_t>(i)].radius) + r;
}

Gap Motion::gap(int i, const Piece& a, const Piece& b, Wide since, Wide reach) const {
  const WideVec p = Path::at(a, since), q = Path::at(b, since);
  const Wide dx = q.x - p.x, dy = q.y - p.y, wx = b.v.x - a.v.x, wy = b.v.y - a.v.y;
  const Gap g{wx * wx + wy * wy, dx * wx + dy * wy, dx * dx + dy * dy - reach * reach};
  return i < 0 ? Gap{-g.a, -g.b, -g.c} : g;
}

Sites Motion::sites_at(Wide t) const {
  Sites sites{{{scene->cx, scene->cy}, -static_cast<Real>(scene->radius)}};
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const WideVec p = paths[k].at(t);
    sites.push_back({{static_cast<Real>(p.x), static_cast<Real>(p.y)}, scene->disks[k].radius});
  }
  return sites;
}

template <class Visit>
void Motion::on_lines(int i, int j, Wide end, const Visit& visit) const {
  const std::vector<Piece> alone{container()};
  const std::vector<Piece>& first = i < 0 ? alone : paths[static_cast<std::size_t>(i)].pieces();
  const std::vector<Piece>& second = paths[static_cast<std::size_t>(j)].pieces();
  std::size_t a = 0, b = 0;
  Wide since = 0;
  while (since < end) {
    while (a + 1 < first.size() && first[a + 1].since <= since) ++a;
    while (b + 1 < second.size() && second[b + 1].since <= since) ++b;
    Wide until = end;
    if (a + 1 < first.size() && first[a + 1].since < until) until = first[a + 1].since;
    if (b + 1 < second.size() && second[b + 1].since < until) until = second[b + 1].since;
    visit(first[a], second[b], since, until);
    since = until;
  }
}

bool Motion::points_meet(Wide end) const {
  bool meet = false;
  const int n = static_cast<int>(paths.size());
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      if (reach(i, j) != 0) continue;
      on_lines(i, j, end, [&](const Piece& a, const Piece& b, Wide since, Wide until) {
        if (a.since > 0 || b.since > 0) return;
        const Gap g = gap(i, a, b, since, 0);
        const Wide nearest = g.a > 0 ? -g.b / g.a : Wide(0);
        meet |= nearest >= 0 && nearest <= until - since &&
                (g.a > 0 ? g.a * g.c == g.b * g.b : g.c == 0);
      });
    }
  }
  return meet;
}

std::vector<Overlap> Motion::overlaps(int i, int j, Wide end) const {
  const Wide r = reach(i, j);
  const Wide hair =
      (std::fabs(scene->cx) + std::fabs(scene->cy) + scene->radius) * static_cast<Wide>(1e-30);
  std::vector<Overlap> found;
  // `first`: the depth at `from`. Where the two only touch, one overlap ends and another begins.
  const auto note = [&](Wide from, Wide to, Wide depth, Wide first) {
    if (!(from < to) || !(depth > hair)) return;
    if (!found.empty() && found.back().to >= from && first > hair) {
      found.back().to = to;
      if (depth > found.back().depth) found.back().depth = depth;
    } else {
      found.push_back({from, to, false, depth});
    }
  };
  on_lines(i, j, end, [&](const Piece& a, const Piece& b, Wide since, Wide until) {
    const Gap g = gap(i, a, b, since, r);
    const Wide span = until - since;
    const auto depth_at = [&](Wide t) {
      const Wide value = g(t);
      const Wide distance = square_root(i < 0 ? r * r - value : value + r * r);
      return i < 0 ? distance - r : r - distance;
    };
    Wide in = 0, out = 0;
    if (i < 0) {
      // Outside before the first root and after the second.
      if (!g.exit(in) || !g.entry(out)) {
        if (g(span / 2) < 0) {
          note(since, until, std::max(depth_at(0), depth_at(span)), depth_at(0));
        }
      } else {
        if (in > 0) note(since, since + std::min(in, span), depth_at(0), depth_at(0));
        out = std::max(out, Wide(0));
        if (out < span) note(since + out, until, depth_at(span), depth_at(out));
      }
    } else if (g.a == 0) {
      if (g.c < 0) note(since, until, depth_at(0), depth_at(0));
    } else if (g.entry(in) && g.exit(out) && out > 0 && in < span) {
      const Wide lo = std::max(in, Wide(0)), hi = std::min(out, span);
      const Wide middle = std::clamp(-g.b / g.a, lo, hi);
      note(since + lo, since + hi, depth_at(middle), depth_at(lo));
    }
  });
  if (!found.empty() && found.back().to >= end) found.back().open = true;
  return found;
}

}  // namespace voroproof::internal::adversary
