#include "certify/gap.h"

#include <algorithm>

#include "exact/ball.h"

namespace voroproof::internal {

namespace {

constexpr int kBits = 512;        // for enclosures that are only shown
constexpr int kStepsToRoot = 64;  // effort: halvings of the way to a root

// The sign of u + sqrt(d), d > 0.
int sign_plus_root(const Rational& u, const Rational& d) {
  if (sgn(u) >= 0) return 1;
  return cmp(d, Rational(u * u));
}

}  // namespace

int GapTime::compare(const Rational& t) const {
  if (!root_) return cmp(t_, t);
  // The sign of -b -+ sqrt(d) - a (t - t_), as a > 0.
  const Rational u = -root_->b - root_->a * (t - t_);
  return root_->upper ? sign_plus_root(u, root_->discriminant)
                      : -sign_plus_root(Rational(-u), root_->discriminant);
}

std::pair<double, double> GapTime::enclosure() const {
  Ball t(t_, kBits);
  if (root_) {
    const Ball root = sqrt(Ball(root_->discriminant, kBits)), b(root_->b, kBits);
    t = t + (root_->upper ? root - b : -b - root) / Ball(root_->a, kBits);
  }
  double lo = 0, hi = 0;
  t.to_interval(lo, hi);
  return {lo, hi};
}

Gap::Gap(Contact<Rational> k, bool wall, Rational from, Rational reach, Rational hidden_reach2)
    : k_(std::move(k)),
      wall_(wall),
      from_(std::move(from)),
      reach_(std::move(reach)),
      hidden_reach2_(std::move(hidden_reach2)) {}

// A number of the gap's sign: the squared distance less the squared reach, negated at the wall.
Rational Gap::value(const Rational& t) const {
  const Rational s = t - from_;
  Rational c = (k_.a * s + 2 * k_.b) * s + k_.c;
  return wall_ ? Rational(-c) : c;
}

bool Gap::approach_at(const Rational& t) const {
  const Rational slope = k_.b + k_.a * (t - from_);
  return wall_ ? sgn(slope) > 0 : sgn(slope) < 0;
}

bool Gap::shallow_at_start(const Rational& depth) const {
  const Rational distance2 = k_.c + reach_ * reach_;
  const Rational limit = wall_ ? Rational(reach_ + depth) : Rational(reach_ - depth);
  if (wall_) return distance2 <= limit * limit;
  return sgn(limit) < 0 || distance2 >= limit * limit;
}

bool Gap::hidden_at(const Rational& t) const {
  const Rational distance2 = (wall_ ? Rational(-value(t)) : value(t)) + reach_ * reach_;
  return wall_ ? distance2 >= hidden_reach2_ : distance2 <= hidden_reach2_;
}

std::vector<Gap::Overlap> Gap::overlaps(const Rational& end, const Rational& depth) const {
  std::vector<Overlap> out;
  if (!(from_ < end)) return out;
  const Rational length = end - from_;
  const Rational distance2_at_from = k_.c + reach_ * reach_;
  const auto distance2 = [&](const Rational& s) {
    return Rational((k_.a * s + 2 * k_.b) * s + distance2_at_from);
  };
  // The squared distance is convex: greatest at an end of any time, least where the slope is zero.
  const auto add = [&](GapTime a, GapTime b, bool at_start, bool to_end) {
    bool shallow = false, hidden = false;
    if (wall_) {
      const Rational most = at_start && to_end ? std::max(distance2(0), distance2(length))
                            : at_start         ? distance2(0)
                                               : distance2(length);
      shallow = most <= (reach_ + depth) * (reach_ + depth);
      hidden = most >= hidden_reach2_;
    } else {
      Rational s = 0;
      if (sgn(k_.a) > 0) s = std::clamp<Rational>(Rational(-k_.b / k_.a), 0, length);
      const Rational least = distance2(s);
      shallow = depth <= reach_ && least >= (reach_ - depth) * (reach_ - depth);
      hidden = least <= hidden_reach2_;
    }
    out.push_back({std::move(a), std::move(b), at_start, to_end, shallow, hidden});
  };
  const GapTime first(from_), last(end);
  if (!changes_sign()) {
    // The gap never changes its sign, but for an instant: that in the middle is the one.
    if (sgn(value(Rational(from_ + length / 2))) < 0) add(first, last, true, true);
    return out;
  }
  const GapTime lower(from_, k_, false), upper(from_, k_, true);
  if (wall_) {
    if (lower.compare(from_) > 0) {
      const bool to_end = lower.compare(end) >= 0;
      add(first, to_end ? last : lower, true, to_end);
    }
    if (upper.compare(end) < 0) {
      const bool at_start = upper.compare(from_) < 0;
      add(at_start ? first : upper, last, at_start, true);
    }
    return out;
  }
  if (lower.compare(end) >= 0 || upper.compare(from_) <= 0) return out;
  // An overlap that begins at `from` exactly is entered there, and not at an earlier time.
  const bool at_start = lower.compare(from_) < 0, to_end = upper.compare(end) >= 0;
  add(at_start ? first : lower, to_end ? last : upper, at_start, to_end);
  return out;
}

bool Gap::changes_sign() const {
  return sgn(k_.a) != 0 && sgn(Rational(k_.b * k_.b - k_.a * k_.c)) > 0;
}

bool Gap::changes_in(const Rational& lo, const Rational& hi) const {
  if (!changes_sign()) return false;
  const GapTime lower(from_, k_, false), upper(from_, k_, true);
  const auto within = [&](const GapTime& t) { return t.compare(lo) >= 0 && t.compare(hi) <= 0; };
  return within(lower) || within(upper);
}

Polynomial<Rational> Gap::polynomial() const {
  // a s^2 + 2 b s + c at s = t - from.
  return {Rational((k_.a * from_ - 2 * k_.b) * from_ + k_.c), Rational(2 * (k_.b - k_.a * from_)),
          k_.a};
}

std::optional<GapTime> Gap::entry() const {
  if (!changes_sign()) return std::nullopt;
  GapTime root(from_, k_, wall_);
  if (root.compare(from_) < 0) return std::nullopt;
  return root;
}

std::optional<Gap::Graze> Gap::graze(const Rational& distance) const {
  if (wall_ || sgn(k_.a) == 0 || sgn(k_.b) > 0) return std::nullopt;
  const Rational s = -k_.b / k_.a;
  const Rational least = k_.c + k_.b * s;  // minimum of |d|^2 - reach^2
  if (sgn(least) < 0) return std::nullopt;
  return Graze{from_ + s, least <= distance * (2 * reach_ + distance)};
}

std::optional<Rational> Gap::revealed(const Rational& t, const Rational& margin) const {
  if (!hidden_at(t)) return t;
  Rational clear = t + margin;
  if (hidden_at(clear)) return std::nullopt;
  // The least t + margin / 2^k that will do, and from there towards the root: what happens next may
  // be as near to it.
  Rational step = margin;
  while (!hidden_at(Rational(t + step / 2)) && bit_size(step) < kBits) step /= 2;
  clear = t + step;
  for (int k = 0; k < kStepsToRoot; ++k) {
    step /= 2;
    if (const Rational nearer = clear - step; !hidden_at(nearer)) clear = nearer;
  }
  return clear;
}

}  // namespace voroproof::internal
