#include "filtered/worlds/lazy_time.h"

#include <utility>

namespace voroproof::internal {

LazyTime::LazyTime(Exact t) : known_(std::make_shared<Known>()) {
  known_->lo = round_down(t.interval().lo);
  known_->hi = round_up(t.interval().hi);
  known_->exact = std::move(t);
}

LazyTime::LazyTime(double lo, double hi, std::function<Polynomial<Rational>()> polynomial)
    : known_(std::make_shared<Known>(Known{lo, hi, nullptr, {}, 0, std::move(polynomial)})) {}

LazyTime::LazyTime(const RoughRows& rows, const Quad& q, const DoubleRoot& root,
                   std::function<Polynomial<Rational>()> polynomial)
    : known_(std::make_shared<Known>(
          Known{root.lo, root.hi, &rows, q, root.piece_hi, std::move(polynomial)})) {}

const LazyTime::Exact& LazyTime::exact() const {
  if (!known_->exact) {
    known_->exact.emplace(known_->polynomial(),
                          RootInterval{to_rational(known_->lo), to_rational(known_->hi)});
  }
  return *known_->exact;
}

double LazyTime::nearest() const {
  if (!known_->exact && known_->rows != nullptr) {
    const DdBall t = narrowed_root(*known_->rows, known_->q, known_->lo, known_->hi);
    if (rounds_to_leading(t)) return t.hi;
  }
  return round_nearest(exact());
}

std::optional<double> LazyTime::alone_until(const Quad& q) const {
  if (known_->rows == nullptr || !same_generators(q, known_->q)) return std::nullopt;
  return known_->piece_hi;
}

std::strong_ordering compare(const LazyTime& x, const LazyTime& y) {
  if (x.known_ == y.known_) return std::strong_ordering::equal;
  if (x.hi() < y.lo()) return std::strong_ordering::less;
  if (y.hi() < x.lo()) return std::strong_ordering::greater;
  return compare(x.exact(), y.exact());
}

std::strong_ordering compare(const LazyTime& x, const Rational& t) {
  if (t > to_rational(x.hi())) return std::strong_ordering::less;
  if (t < to_rational(x.lo())) return std::strong_ordering::greater;
  return compare(x.exact(), t);
}

}  // namespace voroproof::internal
