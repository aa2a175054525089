#include "certify/billiards/true_lives.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voroproof::internal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double low(const DoubleBall& x) {
  return x.rad == 0 ? x.mid : std::nextafter(x.mid - x.rad, -infinity);
}
double high(const DoubleBall& x) {
  return x.rad == 0 ? x.mid : std::nextafter(x.mid + x.rad, infinity);
}

DoubleBall later(const DoubleBall& x, const DoubleBall& y) {
  return DoubleBall::hull(std::max(low(x), low(y)), std::max(high(x), high(y)));
}
DoubleBall earlier(const DoubleBall& x, const DoubleBall& y) {
  return DoubleBall::hull(std::min(low(x), low(y)), std::min(high(x), high(y)));
}

// Whether the one line certainly ends, where the other follows it, before the other one begins.
bool ends_before(const TrueLine* next, const TrueLine& other) {
  return next != nullptr && sign(next->near.t0 - other.near.t0) == Sign::negative;
}

// Whether one line ends with the very claim by which the other begins: they have no time in common.
bool succeeds(const TrueLine& line, const TrueLine* next) {
  return next != nullptr && line.claim >= 0 && line.claim == next->claim;
}

}  // namespace

std::optional<TrueTime> TrueLives::find_contact(const BilliardPair& pair, const BilliardTime& from,
                                                const BilliardTime& to, bool is_end,
                                                Touches& touches, std::int64_t& lives) const {
  const Span span{from, to, is_end};
  const auto line = [](const TruePath& path, std::size_t k) {
    return k < path.size() ? &path[k] : nullptr;
  };
  const TruePath& b = motion_.paths()[static_cast<std::size_t>(pair.b)];
  if (pair.a < 0) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      const TrueLine* const next = line(b, k + 1);
      if (auto t = find_contact({pair, b[k], b[k], next, next}, span, touches, lives)) return t;
    }
    return std::nullopt;
  }
  const TruePath& a = motion_.paths()[static_cast<std::size_t>(pair.a)];
  std::size_t first = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = first; k < b.size(); ++k) {
      const Life life{pair, a[i], b[k], line(a, i + 1), line(b, k + 1)};
      if (ends_before(life.next_b, life.a)) {
        first = k + 1;
        continue;
      }
      if (ends_before(life.next_a, life.b)) break;
      if (auto t = find_contact(life, span, touches, lives)) return t;
    }
  }
  return std::nullopt;
}

// Whether doubles tell that the gap is positive. After a collision of the two its form is divided
// by the time since.
bool TrueLives::is_certainly_free(const Life& life, bool met, const Span& span) const {
  DoubleBall start = later(life.a.near.t0, life.b.near.t0);
  if (!met) start = later(start, span.from.near);
  DoubleBall end = span.to.near;
  for (const TrueLine* next : {life.next_a, life.next_b}) {
    if (next != nullptr) end = earlier(end, next->near.t0);
  }
  const double length = high(end - start);
  if (length < 0) return true;
  if (!filters_) return false;
  GapForm<DoubleBall> f =
      motion_.near().form(life.pair, life.a.near, life.b.near, start, DoubleBall(0));
  if (met) {
    std::move(f.begin() + 1, f.end(), f.begin());
    f.back() = DoubleBall(0);
  }
  return certainly_positive(f, motion_.near().degree(life.pair), 0, length);
}

std::optional<TrueTime> TrueLives::find_contact(const Life& life, const Span& span,
                                                Touches& touches, std::int64_t& lives) const {
  if (succeeds(life.a, life.next_b) || succeeds(life.b, life.next_a)) return std::nullopt;
  ++lives;
  // The claim was of their first contact on these lines.
  if (motion_.have_met(life.pair, life.next_a, life.next_b)) return std::nullopt;
  const bool met = motion_.have_met(life.pair, &life.a, &life.b);
  if (met && motion_.part_for_good(life.pair)) return std::nullopt;
  if (is_certainly_free(life, met, span)) return std::nullopt;
  const PairLines on{life.pair, life.a, life.b};
  TrueTime start = motion_.since(on);
  if (!met) start = motion_.later(start, motion_.time(span.from.value()));
  const TrueTime to = motion_.time(span.to.value());
  TrueTime end = to;
  for (const TrueLine* next : {life.next_a, life.next_b}) {
    if (next != nullptr) end = motion_.earlier(end, next->from);
  }
  if (order(end, start) == Sign::negative) return std::nullopt;
  note_touches(life, span, start, end, touches);
  const bool ends_all = span.is_end && order(end, to) == Sign::zero;
  if (order(end, start) == Sign::zero && !ends_all) return std::nullopt;
  const Rational until = end.exact ? *end.exact : end.ball.rational_interval().second;
  const auto t = motion_.contact(on, start, until);
  if (!t) return std::nullopt;
  const Sign early = order(*t, end);
  if (early == Sign::unknown) throw TooCoarse("which of two events comes first is not told");
  if (early == Sign::positive) return std::nullopt;
  if (early == Sign::negative) return t;
  // One of the two turns where they come to touch: what comes after is of the next lines.
  const auto turns_then = [&](const TrueLine* next) {
    return next != nullptr && order(next->from, end) != Sign::positive;
  };
  return ends_all && !turns_then(life.next_a) && !turns_then(life.next_b) ? t : std::nullopt;
}

// Notes that the two touch where one of them turns, or at the start. What was before the window has
// been noted and judged.
void TrueLives::note_touches(const Life& life, const Span& span, const TrueTime& start,
                             const TrueTime& end, Touches& touches) const {
  for (const TrueTime* t : {&start, &end}) {
    if (!t->exact || *t->exact < span.from.value()) continue;
    const auto is_then = [&](const TrueLine* line) {
      return line != nullptr && line->from.exact && *line->from.exact == *t->exact;
    };
    const bool turns =
        is_then(&life.a) || is_then(&life.b) || is_then(life.next_a) || is_then(life.next_b);
    if (turns && motion_.touch({life.pair, life.a, life.b}, *t->exact))
      touches[*t->exact].insert(life.pair);
  }
}

}  // namespace voroproof::internal
