// Whether two claims are the same, with their exact values.
#pragma once

#include <variant>

#include "history/history_reader.h"

namespace voroproof::internal::testing {

using Claim = voroproof::internal::Event;

template <class T>
bool same_exact(const T& a, const T& b) {
  if (!a.exact || !b.exact) return !a.exact && !b.exact;
  return a.exact->t == b.exact->t && a.exact->v == b.exact->v && a.exact->p == b.exact->p;
}

inline bool same(const Claim& a, const Claim& b) {
  if (a.index() != b.index()) return false;
  if (const auto* f = std::get_if<FlipEvent>(&a)) {
    const auto& g = std::get<FlipEvent>(b);
    return f->t == g.t && f->quad == g.quad && same_exact(*f, g);
  }
  if (const auto* c = std::get_if<CollideEvent>(&a)) {
    const auto& d = std::get<CollideEvent>(b);
    return c->t == d.t && c->i == d.i && c->j == d.j && c->v == d.v && c->p == d.p &&
           same_exact(*c, d);
  }
  const auto& m = std::get<ManeuverEvent>(a);
  const auto& n = std::get<ManeuverEvent>(b);
  return m.t == n.t && m.disk == n.disk && m.v == n.v && m.p == n.p && same_exact(m, n);
}

}  // namespace voroproof::internal::testing
