// Balls of many bits: this project's Ball against a thin wrapper of Arb's, by the same templates.
// The operands are places and radii as the searches have them after collisions: of full precision,
// with a radius in the last bits.
#include <arb.h>

#include <array>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/paired.h"
#include "bench/predicates_bench.h"
#include "exact/ball.h"
#include "exact/predicates.h"

namespace voroproof::internal::bench {

namespace {

// What a wrapper in the place of Ball would be: a number with its precision, that of a result being
// the larger one of the operands.
class ArbBall {
 public:
  ArbBall() { arb_init(value_); }
  explicit ArbBall(int small) : ArbBall() { arb_set_si(value_, small); }
  ArbBall(const ArbBall& o) : bits_(o.bits_) {
    arb_init(value_);
    arb_set(value_, o.value_);
  }
  ArbBall(ArbBall&& o) noexcept : ArbBall() {
    arb_swap(value_, o.value_);
    bits_ = o.bits_;
  }
  ArbBall& operator=(ArbBall o) noexcept {
    arb_swap(value_, o.value_);
    std::swap(bits_, o.bits_);
    return *this;
  }
  ~ArbBall() { arb_clear(value_); }

  static ArbBall of(double first, double second, slong bits) {
    ArbBall b;
    b.bits_ = bits;
    arb_set_d(b.value_, first);
    ArbBall rest;
    arb_set_d(rest.value_, second);
    arb_mul_2exp_si(rest.value_, rest.value_, 60 - bits);
    arb_add(b.value_, b.value_, rest.value_, bits);
    arb_add_error_2exp_si(b.value_, 8 - bits);
    return b;
  }

  friend ArbBall operator+(const ArbBall& a, const ArbBall& b) { return apply(arb_add, a, b); }
  friend ArbBall operator-(const ArbBall& a, const ArbBall& b) { return apply(arb_sub, a, b); }
  friend ArbBall operator*(const ArbBall& a, const ArbBall& b) { return apply(arb_mul, a, b); }
  friend Sign sign(const ArbBall& a) {
    if (arb_is_positive(a.value_)) return Sign::positive;
    if (arb_is_negative(a.value_)) return Sign::negative;
    return arb_is_zero(a.value_) ? Sign::zero : Sign::unknown;
  }

 private:
  template <class Operation>
  static ArbBall apply(Operation&& operation, const ArbBall& a, const ArbBall& b) {
    ArbBall out;
    out.bits_ = std::max(a.bits_, b.bits_);
    operation(out.value_, a.value_, b.value_, out.bits_);
    return out;
  }

  arb_t value_;
  slong bits_ = 2;
};

Ball ball_of(double first, double second, Ball::Precision bits) {
  return Ball(Rational(to_rational(first) + to_rational(second) * Rational(Integer(1) << 60) /
                                                (Integer(1) << static_cast<mp_bitcnt_t>(bits))),
              bits) *
         Ball(1, bits);
}

template <class T>
using Sites = std::array<Site<T>, 4>;

void against_arb(benchmark::State& state, Ball::Precision bits) {
  std::mt19937_64 random(1);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 * 200 - 100; };
  constexpr std::size_t count = 200;
  std::vector<Sites<Ball>> ours(count);
  std::vector<Sites<ArbBall>> theirs(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (int s = 0; s < 4; ++s) {
      const std::array<double, 6> v{uniform(), uniform(), uniform(),
                                    uniform(), uniform(), uniform()};
      ours[k][s] = {ball_of(v[0], v[1], bits), ball_of(v[2], v[3], bits),
                    ball_of(v[4], v[5], bits)};
      theirs[k][s] = {ArbBall::of(v[0], v[1], bits), ArbBall::of(v[2], v[3], bits),
                      ArbBall::of(v[4], v[5], bits)};
    }
  }
  const auto pass = [](const auto& all) {
    return seconds_of([&] {
      for (const auto& s : all) {
        benchmark::DoNotOptimize(sign(cotangency(s[0], s[1], s[2], s[3])));
      }
    });
  };
  run_paired(
      state, count, [&] { return pass(ours); }, [&] { return pass(theirs); });
}

}  // namespace

void register_ball_benchmarks() {
  for (const Ball::Precision bits : {144, 256, 512, 1024, 4096}) {
    benchmark::RegisterBenchmark(("ball/against_arb/" + std::to_string(bits)).c_str(),
                                 [bits](benchmark::State& state) { against_arb(state, bits); })
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace voroproof::internal::bench
