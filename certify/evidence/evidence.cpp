#include "certify/evidence/evidence.h"

#include <algorithm>
#include <utility>

#include "certify/evidence/cgal_circles.h"
#include "certify/evidence/cgal_motion.h"
#include "certify/evidence/cgal_roots.h"

namespace voroproof::internal {

namespace {

using CGAL::Gmpq;
using cgal::Mover;

EvidenceCheck contradicted(std::string why) { return {Evidence::contradicted, std::move(why)}; }

// Times are sought so near to a root, in steps, before a flip is denied. The limits of a scene
// allow times down to 2^-664.
constexpr std::array<int, 7> kBitsAround{32, 64, 128, 256, 512, 1024, 2048};

// The one root in the interval, or why there is none.
struct OneRoot {
  cgal::Roots roots;
  std::size_t index = 0;
  std::string fault;

  OneRoot(const cgal::Polynomial& f, const std::array<Rational, 2>& interval) : roots(f) {
    const auto [first, end] = roots.in(cgal::number(interval[0]), cgal::number(interval[1]));
    index = first;
    if (end - first != 1) {
      fault =
          "the polynomial has " + std::to_string(end - first) + " roots in the isolating interval";
    }
  }
};

// Where each of the two vertices of an edge has the other end's generator.
struct EdgeSides {
  std::optional<CGAL::Bounded_side> start, end;

  bool both(CGAL::Bounded_side side) const { return start == side && end == side; }
  bool both_exist() const { return start && end; }
};

// The generators in the order l, r, s, e.
EdgeSides edge_sides(const std::array<Mover, 4>& m, const Gmpq& t) {
  const cgal::Circle l = m[0].at(t), r = m[1].at(t), s = m[2].at(t), e = m[3].at(t);
  return {cgal::side_of_vertex({l, s, r, e}), cgal::side_of_vertex({l, r, e, s})};
}

EvidenceCheck check_flip(const std::array<Mover, 4>& m, const OneRoot& root) {
  std::string fault = "at the root the circles of the edge do not exist";
  for (const int bits : kBitsAround) {
    const auto times = root.roots.around(root.index, bits);
    if (!times) continue;
    const EdgeSides before = edge_sides(m, (*times)[0]), after = edge_sides(m, (*times)[1]);
    if (!before.both_exist() || !after.both_exist()) continue;
    if (before.both(CGAL::ON_UNBOUNDED_SIDE) && after.both(CGAL::ON_BOUNDED_SIDE)) {
      return {Evidence::confirmed, "confirmed by CGAL's algebraic kernel and its exact circles"};
    }
    fault = "the edge does not turn from legal to illegal at the root";
  }
  return contradicted(fault);
}

// The sign of the polynomial of a contact where the two do not overlap.
CGAL::Sign apart(const Mover& i, const Mover& j) {
  return i.id == container_id || j.id == container_id ? CGAL::NEGATIVE : CGAL::POSITIVE;
}

EvidenceCheck check_contact(const std::array<Mover, 2>& m, const cgal::Polynomial& f,
                            const OneRoot& root) {
  for (const int bits : kBitsAround) {
    const auto times = root.roots.around(root.index, bits);
    if (!times) continue;
    const CGAL::Sign before = apart(m[0], m[1]);
    if (f.sign_at((*times)[0]) == before && f.sign_at((*times)[1]) == -before) {
      return {Evidence::confirmed, "confirmed by CGAL's algebraic kernel"};
    }
    return contradicted("the generators do not approach at the root");
  }
  return contradicted("another root is too near");
}

// The polynomial built anew, by its name; nothing where it has another number of generators.
std::optional<cgal::Polynomial> rebuilt(const std::string& name, const std::vector<Mover>& m) {
  if (name == "contact" && m.size() == 2) return cgal::contact(m[0], m[1]);
  if (m.size() != 4) return std::nullopt;
  const std::array<Mover, 4> four{m[0], m[1], m[2], m[3]};
  if (name == "cotangency") return cgal::cotangency(four);
  const bool equal = std::all_of(m.begin(), m.end(), [&](const Mover& g) { return g.r == m[0].r; });
  if (name == "cocircularity" && equal) return cgal::cocircularity(four);
  return std::nullopt;
}

// Whether the sentence of the refutation names the generators of the witness, in their roles.
bool names_match(const Divergence& d, const std::vector<Mover>& m) {
  if (d.true_flip) {
    return m.size() == 4 && canonical(Quad{m[0].id, m[1].id, m[2].id, m[3].id}) == *d.true_flip;
  }
  return d.true_contact && m.size() == 2 && *d.true_contact == std::pair(m[0].id, m[1].id);
}

// The polynomial rebuilt from the witness, or why the witness is false.
struct Rebuilt {
  cgal::Polynomial f;
  std::string fault;
};

Rebuilt checked_polynomial(const Divergence& d, const std::vector<Mover>& m) {
  if (!names_match(d, m)) return {{}, "the generators are not those of the event"};
  std::vector<Gmpq> coefficients;
  for (const EvidenceNumber& n : d.witness.polynomial) {
    if (n.exact.empty()) return {{}, "the motion is rational, the polynomial is not"};
    coefficients.emplace_back(n.exact);
  }
  const cgal::Polynomial given(coefficients.begin(), coefficients.end());
  const auto f = rebuilt(d.witness.polynomial_is, m);
  if (!f || !cgal::same_up_to_scale(given, *f)) {
    return {{}, "the polynomial is not that of the motions"};
  }
  if (f->is_zero()) return {{}, "the polynomial vanishes identically"};
  return {*f, {}};
}

EvidenceCheck check_root(const Divergence& d, const std::vector<Mover>& m) {
  const auto [f, fault] = checked_polynomial(d, m);
  if (!fault.empty()) return contradicted(fault);
  const OneRoot root(f, *d.witness.root);
  if (!root.fault.empty()) return contradicted(root.fault);
  if (d.true_time) {
    const auto [first, end] = root.roots.in(Gmpq((*d.true_time)[0]), Gmpq((*d.true_time)[1]));
    if (root.index < first || root.index >= end) {
      return contradicted("the root is not at the time of the event");
    }
  }
  if (m.size() == 2) return check_contact({m[0], m[1]}, f, root);
  return check_flip({m[0], m[1], m[2], m[3]}, root);
}

// Two overlap at a time.
EvidenceCheck check_overlap(const Divergence& d, const std::vector<Mover>& m) {
  const auto [f, fault] = checked_polynomial(d, m);
  if (!fault.empty()) return contradicted(fault);
  if (f.sign_at(cgal::number(*d.witness.t)) != -apart(m[0], m[1])) {
    return contradicted("the generators do not overlap at the time given");
  }
  return {Evidence::confirmed, "confirmed by CGAL's exact numbers"};
}

EvidenceCheck check_conflict(const Witness& w, const std::vector<Mover>& m) {
  const Triple& v = *w.vertex;
  if (m.size() != 4 || m[0].id != v[0] || m[1].id != v[1] || m[2].id != v[2] ||
      m[3].id != *w.conflict) {
    return contradicted("the generators are not those of the vertex and the conflict");
  }
  const Gmpq t = cgal::number(*w.t);
  const auto side = cgal::side_of_vertex({m[0].at(t), m[1].at(t), m[2].at(t), m[3].at(t)});
  if (!side) return contradicted("the circle of the vertex does not exist");
  if (*side != CGAL::ON_BOUNDED_SIDE) {
    return contradicted("the circle of the vertex contains no point of the generator");
  }
  return {Evidence::confirmed, "confirmed by CGAL's exact circles"};
}

}  // namespace

EvidenceCheck check_evidence(const Divergence& divergence) {
  const Witness& w = divergence.witness;
  const bool conflict = w.t && w.vertex && w.conflict;
  const bool overlap = w.t && !conflict && !w.polynomial.empty();
  if (!w.root && !conflict && !overlap) {
    return {Evidence::none, "none (no polynomial and no circle to check)"};
  }
  std::vector<Mover> movers;
  for (const EvidenceMotion& motion : w.generators) {
    const auto m = cgal::mover(motion);
    if (!m) return {Evidence::not_checkable, "not checked (motion is not rational)"};
    movers.push_back(*m);
  }
  try {
    if (conflict) return check_conflict(w, movers);
    return overlap ? check_overlap(divergence, movers) : check_root(divergence, movers);
  } catch (const cgal::Disagreement& two) {
    return contradicted(two.what());
  }
}

}  // namespace voroproof::internal
