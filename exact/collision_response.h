// The effect of a contact on two motions, for numbers of any kind.
#pragma once

#include "exact/predicates.h"

namespace voroproof::internal {

// Two generators at a reference time (the container first) and their contact, `delay` after it. A
// motion after the contact is told as it would be at the reference time, going back along its line.
// The laws are those of docs/formats.md.
template <class T>
class CollisionResponse {
 public:
  CollisionResponse(const MovingSite<T>& i, const MovingSite<T>& j, const Contact<T>& contact,
                    const T& delay)
      : delay_(delay),
        nx_(j.x - i.x + (j.vx - i.vx) * delay),
        ny_(j.y - i.y + (j.vy - i.vy) * delay) {
    const T reach = i.r + j.r;
    // w.n = b + a s, with the relative velocity w and the offset n at the contact.
    q_ = (contact.b + contact.a * delay) / (reach * reach);
  }

  // The site with its velocity changed by `factor` (w.n) n / reach^2. The factor is -(1 + e) m_j /
  // (m_i + m_j) for the disk j of two, with the sign and the masses exchanged for i, -(1 + e) at
  // the container.
  MovingSite<T> pushed(const MovingSite<T>& m, const T& factor) const {
    const T k = q_ * factor;
    return turned(m, m.vx + k * nx_, m.vy + k * ny_);
  }
  // The site with its whole reflected velocity scaled.
  MovingSite<T> reflected(const MovingSite<T>& m, const T& scale) const {
    const T k = q_ + q_;
    return turned(m, scale * (m.vx - k * nx_), scale * (m.vy - k * ny_));
  }

 private:
  MovingSite<T> turned(const MovingSite<T>& m, const T& vx, const T& vy) const {
    return {m.x + (m.vx - vx) * delay_, m.y + (m.vy - vy) * delay_, vx, vy, m.r};
  }

  T delay_, nx_, ny_, q_;
};

}  // namespace voroproof::internal
