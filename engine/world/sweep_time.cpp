#include "engine/world/sweep_time.h"

#include <utility>

#include "engine/world/moving_edge.h"

namespace voroproof::internal {

SweepTime::SweepTime(WorldTime t) : known_(std::make_shared<Known>()) {
  known_->lo = round_down(t.interval().lo);
  known_->hi = round_up(t.interval().hi);
  known_->exact = std::move(t);
}

SweepTime::SweepTime(const MovingRows& rows, const Quad& q, const DoubleRoot& root)
    : known_(std::make_shared<Known>()) {
  *known_ = {root.lo, root.hi, &rows, q, root.piece_hi, {}};
}

const WorldTime& SweepTime::exact() const {
  if (!known_->exact) {
    const MovingEdge edge(*known_->rows, known_->q);
    known_->exact.emplace(edge.polynomial(),
                          RootInterval{to_rational(known_->lo), to_rational(known_->hi)});
  }
  return *known_->exact;
}

double SweepTime::nearest() const {
  if (!known_->exact) {
    const DdBall t = narrowed_root(*known_->rows, known_->q, known_->lo, known_->hi);
    if (rounds_to_leading(t)) return t.hi;
  }
  return round_nearest(exact());
}

double SweepTime::alone_until(const Quad& q) const {
  return known_->rows != nullptr && same_generators(q, known_->q) ? known_->piece_hi : hi();
}

std::strong_ordering compare(const SweepTime& x, const SweepTime& y) {
  if (x.known_ == y.known_) return std::strong_ordering::equal;
  if (x.hi() < y.lo()) return std::strong_ordering::less;
  if (y.hi() < x.lo()) return std::strong_ordering::greater;
  return compare(x.exact(), y.exact());
}

std::strong_ordering compare(const SweepTime& x, const Rational& t) {
  if (t > to_rational(x.hi())) return std::strong_ordering::less;
  if (t < to_rational(x.lo())) return std::strong_ordering::greater;
  return compare(x.exact(), t);
}

}  // namespace voroproof::internal
