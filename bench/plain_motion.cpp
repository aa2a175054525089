#include "bench/plain_motion.h"

#include <array>
#include <cmath>
#include <limits>

#include "exact/predicates.h"
#include "filtered/numbers/double_roots.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/edge_predicates.h"

namespace voroproof::internal::bench {

namespace {

Site<double> site(const Motion& motion, GenId g, double t) {
  const DoubleMotion& m = motion.doubles(g);
  const double dt = t - m.t;
  return {m.x + m.vx * dt, m.y + m.vy * dt, m.r};
}

// What becomes of the edge q at a root of f, judged by the sites at a time just after it, where f
// has the sign `after`.
Judgement judge_edge(const std::array<Site<double>, 4>& at, const Quad& q, Sign after) {
  return judge(
      q, at, [&] { return at; }, after);
}

// What becomes of an edge between equal radii at a root of C, judged by the sites at a time just
// after it, where C has the sign `after`.
Judgement judge_cocircular(const std::array<Site<double>, 4>& at, Sign after) {
  const auto& [l, r, s, e] = at;
  const auto left = [](const Site<double>& a, const Site<double>& b, const Site<double>& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
  };
  return after != Sign::positive && left(l, s, r) && left(r, e, l) ? Judgement::collapses
                                                                   : Judgement::stays;
}

// A motion whose doubles may be set without any proof.
struct Unproved : Motion {
  static void overwrite(Motion& motion, GenId g, const DoubleMotion& m) {
    (motion.*&Unproved::doubles_)[g + 1] = m;
  }
};

void advance(DoubleMotion& m, double t) {
  m.x += m.vx * (t - m.t);
  m.y += m.vy * (t - m.t);
  m.t = t;
}

}  // namespace

PlainMotion::PlainMotion(Motion& motion)
    : motion_(motion),
      restitution_(motion.input().restitution.get_d()),
      container_restitution_(motion.input().container_restitution.get_d()),
      last_change_(motion.size() + 1, 0) {}

Collapse PlainMotion::collapse(const Quad& q, double start, double end) const {
  if (q.s == q.e) return Collapse::none_until(std::numeric_limits<double>::infinity());
  if (!(start < end)) return Collapse::none_until(end);
  BernsteinForm form;
  if (form_flip_polynomial<false>(motion_, q, start, end, form)) return Collapse::none_until(end);
  Collapse answer;
  const double reached = each_root(form, start, end, [&](const DoubleRoot& root) {
    const double t = root.hi;
    const std::array<Site<double>, 4> at{site(motion_, q.l, t), site(motion_, q.r, t),
                                         site(motion_, q.s, t), site(motion_, q.e, t)};
    const Judgement verdict =
        form.degree == 8 ? judge_edge(at, q, root.after) : judge_cocircular(at, root.after);
    if (verdict != Judgement::collapses) return true;
    answer = {Collapse::Kind::root, root.lo, root.hi, nullptr};
    return false;
  });
  if (answer.kind == Collapse::Kind::root) return answer;
  // A root too near to the start to be told from it is passed over.
  return Collapse::none_until(std::fmax(reached, start + 1e-7 * (end - start)));
}

NextContact PlainMotion::contact(GenId i, GenId j, double now, double end) const {
  const int last = last_change_[j + 1];
  if (i != container_id && last > 0 && last == last_change_[i + 1]) return {};
  const auto at = [&](GenId g) {
    const DoubleMotion& m = motion_.doubles(g);
    const double dt = now - m.t;
    return MovingSite<double>{m.x + m.vx * dt, m.y + m.vy * dt, m.vx, m.vy, m.r};
  };
  const Contact<double> k(at(i), at(j));
  double s = 0;
  const double disc = k.b * k.b - k.a * k.c;
  if (i == container_id) {
    if (!(k.a > 0)) return {};
    s = k.b > 0 ? -k.c / (k.b + std::sqrt(disc)) : (std::sqrt(disc) - k.b) / k.a;
  } else {
    if (!(k.b < 0) || !(disc > 0)) return {};
    s = k.c / (std::sqrt(disc) - k.b);
  }
  const double t = now + std::fmax(s, 0);
  if (!(t <= end)) return {};
  return {NextContact::Kind::at, t, t};
}

Impact PlainMotion::collide(GenId i, GenId j, double t) {
  DoubleMotion a = motion_.doubles(i), b = motion_.doubles(j);
  advance(b, t);
  if (i != container_id) advance(a, t);
  const double nx = b.x - a.x, ny = b.y - a.y;
  const double reach = a.r + b.r;
  const double q = ((b.vx - a.vx) * nx + (b.vy - a.vy) * ny) / (reach * reach);
  last_change_[j + 1] = ++changes_;
  if (i == container_id) {
    const double e = container_restitution_;
    if (motion_.input().whole_container_law) {
      b.vx = e * (b.vx - 2 * q * nx);
      b.vy = e * (b.vy - 2 * q * ny);
    } else {
      b.vx -= (1 + e) * q * nx;
      b.vy -= (1 + e) * q * ny;
    }
  } else {
    const double mi = round_nearest(motion_.input().disks[i].mass),
                 mj = round_nearest(motion_.input().disks[j].mass);
    const double k = (1 + restitution_) * q / (mi + mj);
    a.vx += k * mj * nx;
    a.vy += k * mj * ny;
    b.vx -= k * mi * nx;
    b.vy -= k * mi * ny;
    last_change_[i + 1] = changes_;
    Unproved::overwrite(motion_, i, a);
  }
  Unproved::overwrite(motion_, j, b);
  return {t, DoubleBall(t), DdBall(t), {a.x, a.y, a.vx, a.vy}, {b.x, b.y, b.vx, b.vy}};
}

RoundedState PlainMotion::maneuver(GenId g, double t, double vx, double vy) {
  DoubleMotion m = motion_.doubles(g);
  advance(m, t);
  m.vx = vx;
  m.vy = vy;
  Unproved::overwrite(motion_, g, m);
  last_change_[g + 1] = ++changes_;
  return {m.x, m.y, vx, vy};
}

}  // namespace voroproof::internal::bench
