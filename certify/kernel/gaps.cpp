// The gaps of a billiard as polynomials of time, their roots and signs.
#include "certify/kernel/motion.h"

namespace voroproof_kernel {

std::string name(const Problem& p, const Encounter& two) {
  std::string text = "disk " + std::to_string(two.j) + " and ";
  if (two.i < 0) {
    return text + (p.scene.radius > 0 ? "the frame" : "wall " + std::to_string(two.i));
  }
  text = "disks " + std::to_string(two.i) + " and " + std::to_string(two.j);
  if (two.image == Image{}) return text;
  for (int k = 0; k < p.scene.dimension; ++k) {
    text += (k == 0 ? " at image [" : ",") + std::to_string(two.image[k]);
  }
  return text + "]";
}

Vec offset(const Scene& scene, const Image& image) {
  return {image[0] * scene.sides[0], image[1] * scene.sides[1], image[2] * scene.sides[2]};
}
Vec drift(const Scene& scene, const Image& image) {
  return {image[1] * scene.sides[1] * scene.shear, 0, 0};
}

Meeting::Meeting(const Problem& p, const Encounter& two_, const Flight* i_, const Flight& j_)
    : problem(p), two(two_), i(i_), j(&j_), apart{j_.a, j_.b, p.fall(two_.j)} {
  const Scene& scene = p.scene;
  const Disk& b = scene.disks[two.j];
  if (is_flat()) {
    const Wall& wall = scene.walls[-1 - two.i];
    for (Vec& x : apart) x = {dot(wall.normal, x)};
    reach[0] = wall.offset + b.radius;
    reach[1] = wall.speed + b.growth;
  } else if (two.i < 0) {
    apart[0] = minus(apart[0], scene.center);
    reach[0] = scene.radius - b.radius;
    reach[1] = -b.growth;
  } else {
    const Vec from[] = {minus(i->a, offset(scene, two.image)), minus(i->b, drift(scene, two.image)),
                        p.fall(two.i)};
    for (int k = 0; k < 3; ++k) apart[k] = minus(apart[k], from[k]);
    reach[0] = scene.disks[two.i].radius + b.radius;
    reach[1] = scene.disks[two.i].growth + b.growth;
  }
}

bool Meeting::is_flat() const { return two.i < 0 && problem.scene.radius == 0; }

Rat Meeting::rounding() const {
  Rat speeds = length_above(j->velocity);
  std::int64_t turns = j->turns;
  if (i != nullptr) {
    speeds += length_above(i->velocity);
    turns += i->turns;
  }
  const Rat places = problem.extent * std::max<std::int64_t>(1, turns);
  return (places + speeds * begin()) * power(2, -51);
}

Form Meeting::gap(const Rat& depth) const {
  if (is_flat()) {
    return polynomial({apart[0][0] - reach[0] + depth, apart[1][0] - reach[1], apart[2][0]});
  }
  const Rat r = two.i < 0 ? Rat(reach[0] + depth) : Rat(reach[0] - depth);
  std::vector<Rat> c{norm2(apart[0]) - square(r), 2 * (dot(apart[0], apart[1]) - r * reach[1]),
                     norm2(apart[1]) - square(reach[1])};
  if (norm2(apart[2]) != 0) {
    c[2] += 2 * dot(apart[0], apart[2]);
    c.insert(c.end(), {2 * dot(apart[1], apart[2]), norm2(apart[2])});
  }
  Form form = polynomial(c);
  for (Int& x : form) x = two.i < 0 ? Int(-x) : x;
  return form;
}

namespace {

// Adds the roots in (a, b) of p; those of `simple` are the same, each of them once.
void isolate(const Form& p, const Form& simple, const Rat& a, const Rat& b, std::vector<Root>& to) {
  const Form f = over(simple, a, b);
  const int most = variations(f);
  if (most == 0 || (f.size() == 3 && most == 2 && f[1] * f[1] < 4 * f[0] * f[2])) return;
  if (most == 1) {
    to.push_back({p, a, b, sign_beside(p, a, 1), sign_beside(p, b, -1)});
    return;
  }
  const Rat m = (a + b) / 2;
  isolate(p, simple, a, m, to);
  if (sign_at(simple, m) == 0) to.push_back({p, m, m, sign_beside(p, m, -1), sign_beside(p, m, 1)});
  isolate(p, simple, m, b, to);
}

}  // namespace

std::vector<Root> roots(const Form& p, const Rat& a, const Rat& b) {
  std::vector<Root> all;
  if (a < b) isolate(p, variations(over(p, a, b)) > 1 ? squarefree(p) : p, a, b, all);
  return all;
}

int compare(const Root& root, const Rat& t) {
  if (root.lo == root.hi) return sgn(Rat(root.lo - t));
  if (t <= root.lo || t >= root.hi) return t <= root.lo ? 1 : -1;
  const int sign = sign_at(root.p, t);
  return sign == 0 ? 0 : sign == root.before ? 1 : -1;
}

bool sinks(const Form& p, const Rat& a, const Rat& b) {
  if (sign_at(p, a) < 0 || sign_at(p, b) < 0) return true;
  for (const Root& r : roots(p, a, b)) {
    if (r.before < 0 || r.after < 0) return true;
  }
  return false;
}

bool falls(const Form& p, const Rat& a, const Rat& b) {
  if (sign_at(p, a) == 0 && sign_beside(p, a, 1) < 0) return true;
  if (sign_at(p, b) == 0 && sign_beside(p, b, -1) > 0 && sign_beside(p, b, 1) < 0) return true;
  for (const Root& r : roots(p, a, b)) {
    if (r.before > 0 && r.after < 0) return true;
  }
  return false;
}

}  // namespace voroproof_kernel
