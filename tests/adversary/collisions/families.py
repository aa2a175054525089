"""Scenes of few disks, each family with something that could go wrong, and the faults that a world may commit."""
import math
from fractions import Fraction

from worlds import Claim, Fault, Scene


def inside(scene_disks, center, radius, x, y, r):
    if math.hypot(x - center[0], y - center[1]) + r >= radius * (1 - 1e-9):
        return False
    return all(math.hypot(x - d[0], y - d[1]) > (r + d[2]) * (1 + 1e-9) + 1e-12 * radius for d in scene_disks)


def scatter(rng, n, radius, sizes, speeds, center=(0.0, 0.0), mass=None):
    """n disks without overlaps, as far as there is room."""
    disks = []
    for _ in range(60 * n):
        if len(disks) == n:
            break
        r = sizes()
        a, d = rng.random() * 2 * math.pi, radius * math.sqrt(rng.random())
        x, y = center[0] + d * math.cos(a), center[1] + d * math.sin(a)
        if inside(disks, center, radius, x, y, r):
            b, v = rng.random() * 2 * math.pi, speeds()
            m = mass() if mass else (r * r if r > 0 else 1.0)
            disks.append((x, y, r, v * math.cos(b), v * math.sin(b), m))
    return disks


def generic(rng):
    n = rng.randint(2, 12)
    return Scene((0.0, 0.0), 10.0, rng.uniform(1, 6),
                 scatter(rng, n, 10, lambda: rng.uniform(0.2, 2), lambda: rng.uniform(0, 4)))


def tiny_fast(rng):
    """Some cross their own size, or the whole scene, in a tolerance."""
    n = rng.randint(2, 8)
    size = 10 ** rng.uniform(-9, -1)
    fast = 10 ** rng.uniform(0, 7)
    disks = scatter(rng, n, 10, lambda: size if rng.random() < 0.6 else rng.uniform(0.1, 2),
                    lambda: fast if rng.random() < 0.4 else rng.uniform(0, 2))
    return Scene((0.0, 0.0), 10.0, rng.choice([5.0, 200 / fast, 40 / fast, 1e-5]), disks)


def points(rng):
    n = rng.randint(2, 8)
    return Scene((0.0, 0.0), 10.0, rng.uniform(2, 10),
                 scatter(rng, n, 10, lambda: rng.choice([0.0, 0.0, rng.uniform(0.1, 3)]), lambda: rng.uniform(0, 4),
                         mass=lambda: rng.uniform(0.5, 2)))


def meeting(rng):
    """Two points that meet, exactly, alone or among others."""
    t, place = rng.choice([0.25, 0.5, 1.0]), (rng.randint(-24, 24) / 8, rng.randint(-24, 24) / 8)
    disks = []
    for _ in range(2):
        v = (rng.randint(-16, 16) / 8, rng.randint(-16, 16) / 8)
        disks.append((place[0] - t * v[0], place[1] - t * v[1], 0.0, *v, 1.0))
    others = scatter(rng, rng.randint(0, 3), 10, lambda: rng.uniform(0.1, 1), lambda: rng.uniform(0, 2))
    disks += [d for d in others if all(math.dist(d[:2], point[:2]) > d[2] for point in disks[:2])]
    return Scene((0.0, 0.0), 10.0, rng.choice([t, 2.0, 4.0]), disks)


def lattice(rng):
    """Whole numbers: disks touch at 0, collide at the same instants, at maneuvers, and at the horizon."""
    n = rng.randint(2, 9)
    disks, cells = [], [(x, y) for x in range(-6, 7, 2) for y in range(-6, 7, 2) if x * x + y * y <= 49]
    rng.shuffle(cells)
    moves = [(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1), (2, 0), (0, -2)]
    for x, y in cells[:n]:
        v = rng.choice(moves)
        disks.append((float(x), float(y), rng.choice([1.0, 1.0, 1.0, 0.5]), float(v[0]), float(v[1]), 1.0))
    scene = Scene((0.0, 0.0), 10.0, float(rng.choice([1, 2, 3, 4, 2.5])), disks)
    return with_maneuvers(rng, scene, lambda: float(rng.choice([0, 0, 1, 2, 0.5])),
                          lambda: tuple(map(float, rng.choice(moves))))


def maneuvers(rng):
    scene = generic(rng)
    return with_maneuvers(rng, scene, lambda: rng.choice([0.0, scene.horizon, rng.uniform(0, scene.horizon * 1.1)]),
                          lambda: (rng.uniform(-3, 3), rng.uniform(-3, 3)))


def with_maneuvers(rng, scene, when, velocity):
    plan = {}
    for _ in range(rng.randint(0, 6)):
        if scene.disks:
            plan[(when(), rng.randrange(len(scene.disks)))] = velocity()
    scene.maneuvers = [(t, k, *v) for (t, k), v in sorted(plan.items())]
    return scene


def near_miss(rng):
    """Two pass each other with a gap, or an overlap, of roundings up to a thousandth; a third crosses the wall's side."""
    gap = rng.choice([-1, 1]) * 10 ** rng.uniform(-17, -3)
    r, s = rng.uniform(0.3, 1.5), rng.uniform(0.3, 1.5)
    v = rng.uniform(0.5, 3)
    disks = [(-6.0, 0.0, r, v, 0.0, 1.0), (6.0 if rng.random() < 0.5 else 2.0, r + s + gap, s, -v * rng.choice([0, 1]), 0.0, 1.0)]
    if rng.random() < 0.5:
        disks += [(0.0, -7.0, 1.0, rng.uniform(-2, 2), rng.uniform(-2, 2), 1.0)]
    return Scene((0.0, 0.0), 10.0, rng.uniform(3, 9), disks)


def inelastic(rng):
    scene = generic(rng)
    scene.restitution = rng.choice([0.0, 0.0, 0.1, 0.5, 0.9])
    scene.wall_restitution = rng.choice([1.0, 0.5, 0.05, 1e-6])
    scene.law = rng.choice(["normal", "whole"])
    return scene


def far(rng):
    """The container is far from the origin: coordinates have few digits left."""
    center = (rng.choice([-1, 1]) * 10 ** rng.uniform(2, 10), rng.choice([0.0, 10 ** rng.uniform(2, 10)]))
    n = rng.randint(2, 8)
    return Scene(center, 10.0, rng.uniform(1, 6),
                 scatter(rng, n, 10, lambda: rng.uniform(0.3, 2), lambda: rng.uniform(0, 4), center=center))


def scaled(rng):
    scene = generic(rng)
    k = 2.0 ** rng.randint(-60, 60)
    h = 2.0 ** rng.randint(-8, 8)
    scene.radius *= k
    scene.horizon *= h
    scene.disks = [(x * k, y * k, r * k, u * k / h, v * k / h, m) for x, y, r, u, v, m in scene.disks]
    return scene


def at_wall(rng):
    """Disks that touch the wall or each other at the start, in exact numbers, among others."""
    disks = [(4.0, 3.0, 5.0, rng.choice([0.0, 1.0, -1.0]), rng.choice([0.0, 2.0, -1.5]), 2.0)]
    if disks[0][3] * 4 + disks[0][4] * 3 == 0 and disks[0][3] != 0:
        disks = [(4.0, 3.0, 5.0, 1.0, 1.0, 2.0)]
    disks += [(-4.0, 3.0, 3.0, rng.choice([0.0, 1.0]), rng.choice([0.0, -1.0, 1.0]), 1.0)]
    disks += [(-6.0, -6.0, 0.5, rng.uniform(-1, 3), rng.uniform(0, 3), 0.25)]
    scene = Scene((0.0, 0.0), 10.0, rng.uniform(1, 8), disks)
    return with_maneuvers(rng, scene, lambda: rng.choice([0.0, 0.0, rng.uniform(0, scene.horizon)]),
                          lambda: (rng.choice([-1.0, 0.0, 1.0]), rng.choice([-1.0, 0.5, 2.0])))


def crossing(rng):
    """One fast disk on its way through a crowd at rest: windows of very different length."""
    n = rng.randint(4, 12)
    disks = scatter(rng, n, 100, lambda: rng.uniform(1, 12), lambda: 0.0)
    if disks:
        x, y, r = disks[0][:3]
        v, a = 10 ** rng.uniform(0, 6), rng.random() * 7
        disks[0] = (x, y, min(r, 10 ** rng.uniform(-6, 1)), v * math.cos(a), v * math.sin(a), 10 ** rng.uniform(-3, 3))
        return Scene((0.0, 0.0), 100.0, 800 / v, disks)
    return generic(rng)


def hasty(rng):
    """Large disks that meet several others within a tolerance: much is settled only after it is over."""
    fast = 10 ** rng.uniform(5.5, 7.5)
    disks = scatter(rng, rng.randint(2, 9), 10, lambda: rng.uniform(0.2, 2), lambda: fast * rng.choice([0, 0, 0.1, 1, 1]))
    return Scene((0.0, 0.0), 10.0, max(2e-6, rng.uniform(5, 80) / fast), disks)


FAMILIES = {f.__name__: f for f in (generic, tiny_fast, points, meeting, lattice, maneuvers, near_miss, inelastic, far,
                                    scaled, at_wall, crossing, hasty)}

FAULTS = ["none", "missed", "late", "early", "false", "doubled", "restitution", "mass", "radius", "mirrored", "perturbed",
          "maneuver missed", "maneuver velocity", "maneuver late",
          "line dropped", "line doubled", "lines swapped", "float32", "other pair", "line moved", "other horizon", "ends dropped"]


def amount(rng, kind, tau):
    if kind in ("late", "early", "maneuver late", "doubled", "line moved"):
        return rng.choice([0.0, 0.3, 0.9, 1.0, 1.1, 1.9, 2.1, 5.0, 1000.0, 1e5]) * tau
    if kind == "restitution":
        return rng.random()
    return rng.choice([-1, 1]) * 10 ** rng.uniform(-13, -0.5)


def a_fault(rng, kind, tau):
    return Fault(kind, rng.choice([0, 0, 0, 1, 2, 4, 8]), amount(rng, kind, tau))


def rewrite(rng, fault, scene, claims):
    """Faults of the file: the claims afterwards, or None where the fault has no place."""
    kind, k = fault.kind, min(fault.at, len(claims) - 1)
    if kind == "none" and rng.random() < 0.5:
        return claims
    if not claims:
        return None
    out = list(claims)
    if kind == "line dropped":
        del out[k]
    elif kind == "line doubled":
        out.insert(k, out[k])
    elif kind == "lines swapped":
        if k == 0:
            return None
        a, b = out[k - 1], out[k]
        t = a.t if rng.random() < 0.5 else b.t
        out[k - 1], out[k] = Claim(t, b.i, b.j, b.v, b.p), Claim(t, a.i, a.j, a.v, a.p)
        out.sort(key=lambda c: c.t)
    elif kind == "float32":
        out[k] = Claim(out[k].t, out[k].i, out[k].j, {g: single(v) for g, v in out[k].v.items()}, out[k].p)
    elif kind == "other pair":
        c, other = out[k], rng.randrange(len(scene.disks))
        if c.i == c.j or other in (c.i, c.j):
            return None
        i, j = sorted((other, c.j))
        out[k] = Claim(c.t, i, j, {i: scene.disks[i][3:5], j: c.v[j]} if i != c.j else {i: c.v[i], j: scene.disks[j][3:5]}, {})
    elif kind == "line moved":
        c = out[k]
        low = out[k - 1].t if k else 0.0
        high = out[k + 1].t if k + 1 < len(out) else scene.horizon
        t = min(max(c.t + rng.choice([-1, 1]) * fault.by, low), high)
        out[k] = Claim(t, c.i, c.j, c.v, c.p)
    elif kind == "ends dropped":
        out = out[:max(0, len(out) - 1 - fault.at)]
    elif kind == "none":
        plain(rng, out)
    return out


def plain(rng, out):
    """A right history in other words: without centres, without velocities, with times that are no doubles."""
    bare = rng.choice(["p", "v of maneuvers", "v", "times"])
    for k, c in enumerate(out):
        if bare == "p" or (bare == "v of maneuvers" and c.i == c.j):
            out[k] = Claim(c.t, c.i, c.j, c.v if bare == "p" else {}, {})
        elif bare == "times" and 0 < c.t < 0.9 * out[-1].t:  # no doubles
            out[k] = Claim(Fraction(c.t) * (1 + Fraction(1, 3 * 2**54)), c.i, c.j, c.v, c.p)
        elif bare == "v":
            out[k] = Claim(c.t, c.i, c.j, {}, c.p)


def single(v):
    def cut(x):
        m, e = math.frexp(x)
        return math.ldexp(round(math.ldexp(m, 24)), e - 24)
    return tuple(cut(x) for x in v)
