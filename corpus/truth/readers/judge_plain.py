# SPDX-License-Identifier: CC0-1.0
"""An engine in plain floating point, wrong where numbers are close: it shows how.

judge_plain.h says what the formulas mean. Here, there and in judge_plain.mjs the operations have
the same order, so that all three make the same mistakes in double. Therefore there are only + - * /
and the square root, which IEEE 754 rounds in one way; no hypot, and no sines.
"""

from math import sqrt

STEPS = 64
GOLDEN = 0.6180339887498949
# The row of what is infinitely far.
PLANE = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)


def row_of(b, g):
    """A generator seen from a base disk: x, y, s, their rates, and the coefficients of p."""
    if g.letter == "w":
        p0 = 2 * (g.x * b.x + g.y * b.y - g.r + b.r)
        p1 = 2 * (g.x * b.vx + g.y * b.vy + b.vr)
        return -g.x, -g.y, 1.0, 0.0, 0.0, 0.0, p0, p1, 0.0
    x, y, s = g.x - b.x, g.y - b.y, (-g.r if g.letter == "c" else g.r) - b.r
    vx, vy, vs = g.vx - b.vx, g.vy - b.vy, g.vr - b.vr
    p0 = x * x + y * y - s * s
    p1 = 2 * (x * vx + y * vy - s * vs)
    p2 = vx * vx + vy * vy - vs * vs
    if g.letter == "c":
        return -x, -y, -s, -vx, -vy, -vs, -p0, -p1, -p2
    return x, y, s, vx, vy, vs, p0, p1, p2


def rows_of(g):
    """The rows of the others after the first three are rotated so that a disk is the base."""
    base = 0 if g[0].letter == "d" else 1 if g[1].letter == "d" else 2
    return [row_of(g[base], g[(base + k) % 3 if k < 3 else k]) for k in range(1, len(g))]


def sign(x):
    """None for what is not a number."""
    return None if x != x else (x > 0) - (x < 0)


def gap_of(rows):
    """The gap between the circle and the last generator, times something positive, at a time."""
    (jx, jy, js, jvx, jvy, jvs, j0, j1, j2) = rows[0]
    (kx, ky, ks, kvx, kvy, kvs, k0, k1, k2) = rows[1]
    (ex, ey, es, evx, evy, evs, e0, e1, e2) = rows[2]

    def gap(t):
        x1, y1, s1, p1 = jx + jvx * t, jy + jvy * t, js + jvs * t, j0 + t * (j1 + t * j2)
        x2, y2, s2, p2 = kx + kvx * t, ky + kvy * t, ks + kvs * t, k0 + t * (k1 + t * k2)
        x3, y3, s3, p3 = ex + evx * t, ey + evy * t, es + evs * t, e0 + t * (e1 + t * e2)
        xp = x1 * p2 - p1 * x2
        yp = y1 * p2 - p1 * y2
        sp = s1 * p2 - p1 * s2
        square = xp * xp + yp * yp - sp * sp
        root = sqrt(square) if square > 0 else 0.0
        a = x3 * sp - s3 * xp + p3 * (x1 * s2 - s1 * x2)
        b = y3 * sp - s3 * yp + p3 * (y1 * s2 - s1 * y2)
        c = x3 * yp - y3 * xp + p3 * (x1 * y2 - y1 * x2)
        return xp * a + yp * b + root * c

    return gap


def first_fall(a, b, c):
    """The first time t >= 0 at which a t^2 + 2 b t + c, not negative at 0, becomes so. Not a
    number where the numbers are too large."""
    if c <= 0 and (b < 0 or (b == 0 and a < 0)):
        return "hit", 0.0
    d = b * b - a * c
    if d != d:
        return "none", d
    if a >= 0 and (b >= 0 or d < 0):
        return "none", None
    root = sqrt(d) if d > 0 else 0.0
    time = c / (root - b) if b < 0 else (b + root) / -a
    return "graze" if a > 0 and d == 0 else "hit", time


def bisect(f, lo, hi, positive):
    """Where f, positive at lo or not, has changed its sign."""
    while True:
        mid = (lo + hi) / 2
        if not lo < mid < hi:
            return hi
        value = f(mid)
        if value > 0 if positive else value < 0:
            lo = mid
        else:
            hi = mid


def tangency(i, j):
    """The tangency of two generators as a polynomial in time."""
    if i.letter == "w" and j.letter == "w":
        x, y = i.x - j.x, i.y - j.y
        return x * x + y * y, 0.0, 0.0
    return (row_of(i, j) if i.letter == "d" else row_of(j, i))[6:]


def cotangency_of(i, j, k, l):
    a0, a1, a2 = tangency(i, j)
    b0, b1, b2 = tangency(k, l)
    c0, c1, c2 = tangency(i, k)
    d0, d1, d2 = tangency(j, l)
    e0, e1, e2 = tangency(i, l)
    f0, f1, f2 = tangency(j, k)

    def cotangency(t):
        u = (a0 + t * (a1 + t * a2)) * (b0 + t * (b1 + t * b2))
        v = (c0 + t * (c1 + t * c2)) * (d0 + t * (d1 + t * d2))
        w = (e0 + t * (e1 + t * e2)) * (f0 + t * (f1 + t * f2))
        d = u - v - w
        return d * d - 4 * v * w

    return cotangency


def root_of(f, lo, hi):
    """The one root between lo and hi: where the sign changes, else where the value is least."""
    first, last = f(lo), f(hi)
    if first == 0:
        return lo
    if last == 0:
        return hi
    if (first < 0) != (last < 0):
        return bisect(f, lo, hi, first > 0)
    turn = -1 if first < 0 else 1
    a, b = hi - GOLDEN * (hi - lo), lo + GOLDEN * (hi - lo)
    at_a, at_b = turn * f(a), turn * f(b)
    for _ in range(48):
        if at_a < at_b:
            hi, b, at_b = b, a, at_a
            a = hi - GOLDEN * (hi - lo)
            at_a = turn * f(a)
        else:
            lo, a, at_a = a, b, at_b
            b = lo + GOLDEN * (hi - lo)
            at_b = turn * f(b)
    return (lo + hi) / 2


def is_hidden(frame, disks, i):
    """Whether disk i lies in another one, or outside of the container."""
    d = disks[i]
    if frame:
        x, y, s = frame.x - d.x, frame.y - d.y, -frame.r - d.r
        if x * x + y * y - s * s >= 0:
            return True
    for j, o in enumerate(disks):
        s = o.r - d.r
        if s >= 0 and j != i:
            x, y = o.x - d.x, o.y - d.y
            if x * x + y * y - s * s <= 0 and (s > 0 or j < i):
                return True
    return False


def is_neighbour(wave, waves):
    """Whether a wave is above all others on more than points. u and v grow with the angle, from 0
    to 4: this is the function turn of judge_plain.h, for this is where the time goes."""
    ja, jb, jc = wave
    pieces = [(0.0, 4.0)]
    for other in waves:
        if other is wave:
            continue
        ka, kb, kc = other
        a, b, c = ja - ka, jb - kb, jc - kc
        d = a * a + b * b - c * c
        if d > 0:
            root = sqrt(d)
            ra, rb, ca, cb = root * a, root * b, c * a, c * b
            x, y = rb - ca, -ra - cb
            if y >= 0:
                u = y / (x + y or 1) if x >= 0 else 1 - x / (y - x)
            else:
                u = 2 + y / (x + y) if x < 0 else 3 + x / (x - y)
            x, y = -rb - ca, ra - cb
            if y >= 0:
                v = y / (x + y or 1) if x >= 0 else 1 - x / (y - x)
            else:
                v = 2 + y / (x + y) if x < 0 else 3 + x / (x - y)
            if u < v:
                pieces = [(u if u > lo else lo, v if v < hi else hi)
                          for lo, hi in pieces if lo < v and u < hi]
            elif v < u:
                low = [(lo, v if v < hi else hi) for lo, hi in pieces if lo < v]
                pieces = low + [(u if u > lo else lo, hi) for lo, hi in pieces if u < hi]
            elif not c > 0:
                return False
            if not pieces:
                return False
        elif not c > 0:
            return False
    return True


class Plain:
    name = "double"

    def incircle(self, g):
        return sign(gap_of(rows_of(g))(0.0))

    def exists(self, g):
        (jx, jy, js, _, _, _, jp, _, _), (kx, ky, ks, _, _, _, kp, _, _) = rows_of(g)
        xp, yp, sp = jx * kp - jp * kx, jy * kp - jp * ky, js * kp - jp * ks
        xs, ys, xy = jx * ks - js * kx, jy * ks - js * ky, jx * ky - jy * kx
        square = xp * xp + yp * yp - sp * sp
        root = sqrt(square) if square > 0 else 0.0
        return sign(xp * xs + yp * ys + root * xy)

    def contact(self, g):
        i, j = g if g[0].letter == "d" else (g[1], g[0])
        if i.letter != "d":
            return "none", None
        if j.letter == "w":
            c = j.x * i.x + j.y * i.y - j.r - i.r
            b = j.x * i.vx + j.y * i.vy - i.vr
            answer = first_fall(0.0, b / 2, c)
        else:
            inside = j.letter == "c"
            x, y, vx, vy = j.x - i.x, j.y - i.y, j.vx - i.vx, j.vy - i.vy
            s, vs = (j.r - i.r, -i.vr) if inside else (j.r + i.r, j.vr + i.vr)
            a = vx * vx + vy * vy - vs * vs
            b = x * vx + y * vy - s * vs
            c = x * x + y * y - s * s
            answer = first_fall(-a, -b, -c) if inside else first_fall(a, b, c)
            if inside and answer[0] != "hit" and answer[1] == answer[1]:
                # A disk never grazes its container from inside. It may fill it as it touches.
                answer = ("hit", s / -vs) if vs < 0 else ("none", None)
        return None if answer[1] != answer[1] else answer

    def collapse(self, g, t0, t1):
        """Looks at steps for changes of the sign. It misses zeros of even order, and pairs of
        zeros between two steps; more steps take longer, and miss them, too."""
        gap = gap_of(rows_of(g))
        s0 = was = sign(gap(t0))
        if not s0:
            return None
        zeros, signs, touching, before = [], [], False, t0
        for i in range(1, STEPS + 1):
            t = t1 if i == STEPS else t0 + (t1 - t0) * i / STEPS
            value = gap(t)
            if value != value:
                return None
            now = (value > 0) - (value < 0)
            if now != was:
                if not touching:
                    zeros.append(t if now == 0 else bisect(gap, before, t, was > 0))
                    signs.append(was)
                was = now or was
                signs[-1] = was
            touching = now == 0
            before = t
        return s0, list(zip(zeros, signs))

    def rootorder(self, question):
        roots = []
        for (lo, hi), ids in zip(question.windows, question.ids):
            roots.append(root_of(cotangency_of(*[question.g[i] for i in ids]), lo, hi))
        return (roots[0] > roots[1]) - (roots[0] < roots[1])

    def static(self, frame, disks):
        hidden = [i for i in range(len(disks)) if is_hidden(frame, disks, i)]
        seen = sorted(set(range(len(disks))) - set(hidden))
        pairs = []
        for i in seen:
            rows = [(row_of(disks[i], disks[k]), k) for k in seen if k != i]
            # The near ones first: they hide the others sooner, and the order changes no answer.
            rows.sort(key=lambda row: row[0][6])
            rows.insert(0, (row_of(disks[i], frame) if frame else PLANE, -1))
            waves = [(w[0] / w[6], w[1] / w[6], w[2] / w[6]) for w, _ in rows]
            for (_, k), wave in zip(rows, waves):
                if (k > i or (k < 0 and frame)) and is_neighbour(wave, waves):
                    pairs.append((min(i, k), max(i, k)))
        return pairs, hidden
