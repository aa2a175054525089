#include "certify/billiards/billiard_motion.h"

#include <algorithm>
#include <utility>

#include "certify/billiards/ball_roots.h"
#include "certify/billiards/pair_signs.h"
#include "exact/simplest.h"
#include "filtered/billiards/line_boxes.h"

namespace voroproof::internal {
namespace {

// A fraction of more bits than that is a ball from then on.
constexpr std::size_t most_fraction_bits = 1U << 16U;

bool is_short(const Vec3& v) {
  return std::all_of(v.begin(), v.end(),
                     [](const Rational& x) { return bit_size(x) <= most_fraction_bits; });
}

double size_of(const Vector3<DoubleBall>& v) {
  return std::max({std::fabs(v[0].mid), std::fabs(v[1].mid), std::fabs(v[2].mid)});
}

// Doubles are no wider than their roundings make them.
void require_fine(const Vector3<DoubleBall>& v, double size) {
  for (const DoubleBall& x : v) {
    if (!(x.rad <= size * 0x1p-48))
      throw TooCoarse("where a disk is, or how it leaves a collision, is not told");
  }
}

Flight<DoubleBall> enclosed(const Flight<Ball>& flight) {
  return {internal::enclosed(flight.t0), internal::enclosed(flight.x),
          internal::enclosed(flight.v)};
}

}  // namespace

BilliardMotion::BilliardMotion(const Billiard& billiard, const Rational& horizon,
                               const MotionOptions& options)
    : billiard_(billiard),
      horizon_(horizon),
      bits_(std::min(options.start_bits, options.max_bits)),
      max_bits_(options.max_bits),
      exact_(billiard),
      near_(billiard),
      ball_(billiard, bits_),
      forgotten_(billiard.disks.size(), 0) {
  start();
}

void BilliardMotion::start() {
  paths_.assign(billiard_.disks.size(), {});
  dropped_.assign(billiard_.disks.size(), 0);
  const TrueTime zero = time(0);
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    const BilliardDisk& disk = billiard_.disks[i];
    paths_[i].push_back(line_of(
        zero, Flight<Rational>{0, disk.center, disk.velocity},
        {zero.ball, of_kind<Ball>(disk.center, bits_), of_kind<Ball>(disk.velocity, bits_)}));
  }
}

// `ball` counts where there are no fractions.
TrueLine BilliardMotion::line_of(const TrueTime& t, std::optional<Flight<Rational>> exact,
                                 Flight<Ball> ball) const {
  if (exact && !(is_short(exact->x) && is_short(exact->v))) {
    ball = {t.ball, of_kind<Ball>(exact->x, bits_), of_kind<Ball>(exact->v, bits_)};
    exact.reset();
  }
  if (!exact) return {t, std::nullopt, ball, enclosed(ball)};
  const Flight<DoubleBall> near{t.near, internal::enclosed(exact->x), internal::enclosed(exact->v)};
  ball = {t.ball, of_kind<Ball>(exact->x, bits_), of_kind<Ball>(exact->v, bits_)};
  return {t, std::move(exact), std::move(ball), near};
}

PairLines BilliardMotion::last(const BilliardPair& pair) const {
  const TrueLine& b = last(pair.b);
  return {pair, pair.a < 0 ? b : last(pair.a), b};
}

bool BilliardMotion::have_met(const BilliardPair& pair, const TrueLine* a,
                              const TrueLine* b) const {
  const bool a_turns = !is_fixed(pair.a), b_turns = !is_fixed(pair.b);
  if (a_turns && (a == nullptr || a->by != pair)) return false;
  if (b_turns && (b == nullptr || b->by != pair)) return false;
  return a_turns && b_turns ? a->claim == b->claim : a_turns || b_turns;
}

bool BilliardMotion::part_for_good(const BilliardPair& pair) const {
  if (pair.a >= 0) return near_.degree(pair) == 2;
  return !billiard_.round && dot(billiard_.gravity, billiard_.gravity) == 0;
}

TrueTime BilliardMotion::later(const TrueTime& x, const TrueTime& y) const {
  const Sign sign = order(x, y);
  if (sign != Sign::unknown) return sign == Sign::negative ? y : x;
  TrueTime both = x;
  both.exact.reset();
  const auto [lo, hi] = (x.ball - y.ball).rational_interval();
  both.ball.widen(Magnitude::of(round_up(std::max<Rational>(abs(lo), abs(hi)))));
  both.near = internal::enclosed(both.ball);
  return both;
}

TrueTime BilliardMotion::earlier(const TrueTime& x, const TrueTime& y) const {
  const Sign sign = order(x, y);
  if (sign != Sign::unknown) return sign == Sign::positive ? y : x;
  return later(x, y);  // it encloses both
}

std::optional<TrueTime> BilliardMotion::contact(const PairLines& on, const TrueTime& from,
                                                const Rational& until) const {
  const bool met = have_met(on.pair, &on.a, &on.b);
  if (met && part_for_good(on.pair)) return std::nullopt;
  const Rational end = std::min(until, horizon_);
  if (are_exact(on, from)) return exact_contact(on, *from.exact, end - *from.exact);
  const Rational length = Ball(Ball(end, bits_) - from.ball).rational_interval().second;
  std::optional<TrueTime> t = ball_contact(on, from, length, met);
  if (!t) return t;
  const Sign in_time = order(*t, time(end));
  if (in_time == Sign::positive) return std::nullopt;
  if (in_time == Sign::unknown) throw TooCoarse("whether two touch in time is not told");
  return t;
}

namespace {

// The first u > 0 at which c + 2 b u + a u^2 falls below zero, where it does not at 0: as a
// fraction, else as a ball.
struct QuadraticFall {
  std::optional<Rational> exact;
  std::optional<Ball> ball;
};
QuadraticFall fall_of(const Rational& c, const Rational& b, const Rational& a, int bits) {
  if (c == 0) {
    if (a >= 0) return {};
    return {Rational(-2 * b / a), {}};
  }
  if (a >= 0 && b >= 0) return {};
  const Rational discriminant = b * b - a * c;
  if (discriminant <= 0) return {};
  if (const auto root = rational_sqrt(discriminant)) return {Rational(c / (*root - b)), {}};
  return {{}, Ball(c, bits) / (sqrt(Ball(discriminant, bits)) - Ball(b, bits))};
}

}  // namespace

std::optional<TrueTime> BilliardMotion::exact_contact(const PairLines& on, const Rational& from,
                                                      const Rational& length) const {
  if (length < 0) return std::nullopt;
  const GapForm<Rational> f = exact_.form(on.pair, *on.a.exact, *on.b.exact, from, 0);
  if (f[0] < 0) return time(from);
  const Polynomial<Rational> polynomial(std::vector<Rational>(f.begin(), f.end()));
  if (f[0] == 0 && sign_after(polynomial, 0) == Sign::negative) {
    if (f[1] < 0) return time(from);
    throw Undecided(name_of(billiard_, on.pair) + " touch and are pressed together", on.pair.a,
                    on.pair.b);
  }
  QuadraticFall fall;
  if (exact_.degree(on.pair) == 2) {
    fall = fall_of(f[0], f[1] / 2, f[2], bits_);
  } else if (auto root = first_fall(polynomial, Rational(0), length)) {
    root->refine(length >> static_cast<unsigned long>(bits_));
    const auto [lo, hi] = root->interval();
    // A root that is a fraction is the simplest one of a short interval.
    const Rational simplest = lo == hi || lo == 0 ? lo : simplest_between(lo, hi);
    if (sgn(polynomial.evaluate(simplest)) == 0) {
      fall.exact = simplest;
    } else {
      fall.ball.emplace(Rational((lo + hi) / 2), bits_);
      fall.ball->widen(Magnitude::of(round_up(Rational(hi - lo))));
    }
  }
  if (fall.exact) {
    if (*fall.exact > length) return std::nullopt;
    const Rational t = from + *fall.exact;
    return bit_size(t) > most_fraction_bits ? TrueTime(Ball(t, bits_)) : time(t);
  }
  if (!fall.ball) return std::nullopt;
  const Sign in_time = sign(*fall.ball - Ball(length, bits_));
  if (in_time == Sign::positive) return std::nullopt;
  if (in_time != Sign::negative) throw TooCoarse("whether two touch in time is not told");
  return TrueTime(Ball(from, bits_) + *fall.ball);
}

std::optional<TrueTime> BilliardMotion::ball_contact(const PairLines& on, const TrueTime& from,
                                                     const Rational& length, bool met) const {
  if (length < 0) return std::nullopt;
  const GapForm<Ball> form =
      ball_.form(on.pair, on.a.ball, on.b.ball, from.ball, of_kind<Ball>(0, bits_));
  // Where the two have met the form is zero at first, and is divided by the time.
  const auto last = form.begin() + ball_.degree(on.pair) + 1;
  const std::vector<Ball> f(form.begin() + (met ? 1 : 0), last);
  const Sign first = sign(f[0]);
  if (first == Sign::negative && !met) return from;
  if (first != Sign::positive) throw TooCoarse("whether two touch is not told");
  const auto u = first_fall(f, length);
  return u ? std::optional(TrueTime(from.ball + *u)) : std::nullopt;
}

bool BilliardMotion::touch(const PairLines& on, const Rational& t) const {
  return on.a.exact && on.b.exact && exact_.form(on.pair, *on.a.exact, *on.b.exact, t, 0)[0] == 0;
}

template <class T>
BilliardMotion::Bounce<T> BilliardMotion::bounce_of(const BilliardGaps<T>& gaps,
                                                    const BilliardPair& pair, const Flight<T>& a,
                                                    const Flight<T>& b, const T& t) const {
  Bounce<T> bounce;
  if (pair.a >= 0) {
    bounce.p[0] = gaps.place(pair.a, a, t);
    bounce.before[0] = gaps.velocity(pair.a, a, t);
  }
  bounce.p[1] = gaps.place(pair.b, b, t);
  bounce.before[1] = gaps.velocity(pair.b, b, t);
  const auto law = gaps.response(pair, bounce.p, bounce.before, t);
  const Sign apart = sign(law.normal2);
  if (apart == Sign::zero)
    throw Undecided("the centres of two that touch coincide: there is no normal", pair.a, pair.b);
  if (apart != Sign::positive) throw TooCoarse("the normal of a collision is not told");
  bounce.after = {bounce.before[0] + law.normal * law.factor_a,
                  bounce.before[1] + law.normal * law.factor_b};
  return bounce;
}

BilliardMotion::Bounce<Ball> BilliardMotion::bounce(const BilliardPair& pair,
                                                    const TrueTime& t) const {
  const PairLines on = last(pair);
  return bounce_of(ball_, pair, on.a.ball, on.b.ball, t.ball);
}

Vector3<Ball> BilliardMotion::place(GenId disk, const TrueTime& t) const {
  return ball_.place(disk, last(disk).ball, t.ball);
}
Vector3<Ball> BilliardMotion::velocity(GenId disk, const TrueTime& t) const {
  return ball_.velocity(disk, last(disk).ball, t.ball);
}

void BilliardMotion::push(GenId disk, TrueLine line) {
  const auto i = static_cast<std::size_t>(disk);
  paths_[i].push_back(std::move(line));
  if (dropped_[i] == forgotten_[i]) return;
  paths_[i].erase(paths_[i].begin());
  ++dropped_[i];
}

void BilliardMotion::collide(const BilliardPair& pair, const TrueTime& t, const Turn& turn) {
  const PairLines on = last(pair);
  const Bounce<Ball> ball = bounce_of(ball_, pair, on.a.ball, on.b.ball, t.ball);
  std::optional<Bounce<Rational>> exact;
  if (are_exact(on, t)) exact = bounce_of(exact_, pair, *on.a.exact, *on.b.exact, *t.exact);
  double speeds = size_of(near_.drift(pair.image));
  for (const int side : {0, 1})
    speeds += size_of(internal::enclosed(ball.before[side])) +
              size_of(internal::enclosed(ball.after[side]));
  std::array<std::optional<TrueLine>, 2> lines;
  for (const int side : {0, 1}) {
    if (is_fixed(side == 0 ? pair.a : pair.b)) continue;
    std::optional<Flight<Rational>> flight;
    if (exact) flight = Flight<Rational>{*t.exact, exact->p[side], exact->after[side]};
    TrueLine& line = lines[side].emplace(
        line_of(t, std::move(flight), {t.ball, ball.p[side], ball.after[side]}));
    if (!line.exact) {
      require_fine(line.near.v, speeds);
      require_fine(line.near.x, size_of(line.near.x) + speeds * std::fabs(t.near.mid));
    }
    line.claim = turn.claim;
    line.line = turn.line;
    line.by = pair;
  }
  if (lines[0]) push(pair.a, *std::move(lines[0]));
  if (lines[1]) push(pair.b, *std::move(lines[1]));
}

void BilliardMotion::turn(const BilliardManeuver& maneuver, const Turn& turn) {
  const TrueTime t = time(maneuver.t);
  const TrueLine& before = last(maneuver.disk);
  std::optional<Flight<Rational>> exact;
  if (before.exact)
    exact = {maneuver.t, exact_.place(maneuver.disk, *before.exact, maneuver.t), maneuver.velocity};
  TrueLine line =
      line_of(t, std::move(exact),
              {t.ball, place(maneuver.disk, t), of_kind<Ball>(maneuver.velocity, bits_)});
  line.claim = turn.claim;
  line.line = turn.line;
  push(maneuver.disk, std::move(line));
}

void BilliardMotion::collide(const BilliardPair& pair, const TrueTime& t, const Rational& until,
                             std::int64_t claim, std::int64_t line) {
  const Turn turn{pair, nullptr, round_up(until), claim, line};
  collide(pair, t, turn);
  turns_.push_back(turn);
}

void BilliardMotion::maneuver(const BilliardManeuver& maneuver, std::int64_t claim,
                              std::int64_t line) {
  turns_.push_back({{}, &maneuver, 0, claim, line});
  turn(maneuver, turns_.back());
}

void BilliardMotion::forget_before(const Rational& t) {
  const TrueTime end = time(t);
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    TruePath& path = paths_[i];
    std::size_t past = 0;
    while (past + 1 < path.size() && order(path[past + 1].from, end) == Sign::negative) ++past;
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(past));
    forgotten_[i] += past;
    dropped_[i] += past;
  }
}

void BilliardMotion::refine(const std::string& reason) {
  const std::vector<TruePath> paths = paths_;
  const std::vector<std::size_t> dropped = dropped_;
  const int bits = bits_;
  for (bool done = false; !done;) {
    if (bits_ >= max_bits_ || is_spent_) {
      // All that is known in fewer bits stays, whole.
      paths_ = paths;
      dropped_ = dropped;
      bits_ = bits;
      ball_ = BilliardGaps<Ball>(billiard_, bits_);
      is_spent_ = true;
      throw Undecided(reason + " with " + std::to_string(max_bits_) + " bits (--max-bits)", 0, 0);
    }
    bits_ = std::min(2 * bits_, max_bits_);
    ball_ = BilliardGaps<Ball>(billiard_, bits_);
    try {
      start();
      for (const Turn& turn : turns_) {
        if (turn.maneuver != nullptr) {
          this->turn(*turn.maneuver, turn);
          continue;
        }
        const PairLines on = last(turn.pair);
        const auto t = contact(on, since(on), to_rational(turn.until));
        if (!t) throw TooCoarse("a contact is not found again");
        collide(turn.pair, *t, turn);
      }
      done = true;
    } catch (const TooCoarse&) {
    }
  }
}

}  // namespace voroproof::internal
