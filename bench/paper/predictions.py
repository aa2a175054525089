"""How many events the paper's Algorithm 2 would predict on the way through a history, in doubles.

After every instant it asks what the paper asks: whether each edge whose four generators or their motion have
changed flips up to the horizon, and whether each pair whose adjacency or motion is new touches, as if nothing
else happened; at first all. Each yes counts.
"""
import collections

import numpy as np
import voroproof as vp
from circles import tangent_circles

PAIRS = [(0, 1), (2, 3), (0, 2), (1, 3), (0, 3), (1, 2)]
BATCH = 20_000
NEAR = 1e-8  # roots so soon are those of the instant itself
SOON = 1e-5  # after a collapse
LEAST = 1e-14  # a leading coefficient is at least so large beside the others


class Edges:
    """The diagram: the twin (r, l, s) of each half-edge (l, r, e), with what is opposite of it to its left."""

    def __init__(self, quads):
        self.twin, self.spoke = {}, {}
        for l, r, s, e in quads:
            self.join((l, r, e), (r, l, s))

    def join(self, h, twin):
        self.twin[h], self.twin[twin] = twin, h
        self.spoke[h[0]], self.spoke[twin[0]] = h, twin

    def flip(self, l, r, s, e):
        """The half-edges that are new: of the edge itself, and of the four around it."""
        del self.twin[l, r, e], self.twin[r, l, s]
        new = {(e, l, r): (e, l, s), (l, s, r): (l, s, e), (s, r, l): (s, r, e), (r, e, l): (r, e, s)}
        around = [(name, self.twin.pop(old)) for old, name in new.items()]
        for name, twin in around:
            self.join(name, new.get(twin, twin))
        self.join((s, e, l), (e, s, r))
        return [(s, e, l), *new.values()]

    def around(self, g):
        """The spokes of a cell, and its rim."""
        first = h = self.spoke.get(g)
        while h is not None:
            g, b, c = h
            yield h, (b, c, g)
            h = self.twin[c, g, b]
            if h == first:
                break


def contacts(motion, i, j):
    """The time from now to the next contact of two columns of generators; infinity where there is none."""
    x, y, u, v = (motion[:, j] - motion[:, i])[:, :4].T
    reach = motion[:, i, 4] + motion[:, j, 4]
    a, b, c = u * u + v * v, x * u + y * v, x * x + y * y - reach * reach
    root = np.sqrt(np.maximum(b * b - a * c, 0))
    inside = np.minimum(motion[:, i, 4], motion[:, j, 4]) < 0
    with np.errstate(all="ignore"):
        t = np.where(inside, (root - b) / a, np.where((b < 0) & (b * b >= a * c), c / (root - b), np.inf))
    return np.where(t > 0, t, np.inf)


def product(p, q):
    """Products of polynomials, their coefficients from the lowest on in the last axis."""
    result = np.zeros((len(p), p.shape[1] + q.shape[1] - 1))
    for k in range(p.shape[1]):
        result[:, k:k + q.shape[1]] += p[:, k:k + 1] * q
    return result


def flip_polynomials(motion):
    """f of the four generators of each row; for equal radii C, whose square it is."""
    def tangency(i, j):
        d = motion[:, i] - motion[:, j]
        return np.stack([d[:, 0]**2 + d[:, 1]**2 - d[:, 4]**2, 2 * (d[:, 0] * d[:, 2] + d[:, 1] * d[:, 3]),
                         d[:, 2]**2 + d[:, 3]**2], axis=1)

    def offset(k, axis):
        return (motion[:, k] - motion[:, 0])[:, axis:axis + 3:2]

    a, b, c = (product(tangency(*PAIRS[k]), tangency(*PAIRS[k + 1])) for k in (0, 2, 4))
    f = product(a - b - c, a - b - c) - 4 * product(b, c)
    equal = sum(product(tangency(i, 0), product(offset(j, 0), offset(k, 1)) - product(offset(j, 1), offset(k, 0)))
                for i, j, k in ((1, 2, 3), (2, 3, 1), (3, 1, 2)))
    equal = np.pad(equal, ((0, 0), (0, f.shape[1] - equal.shape[1])))
    return np.where((motion[:, :, 4] == motion[:, :1, 4]).all(axis=1)[:, None], equal, f)


def roots_within(polynomials, ends):
    """The real roots in (0, end], others as NaN; shape (m, degree)."""
    c = polynomials * ends[:, None] ** np.arange(polynomials.shape[1])
    c /= np.maximum(np.abs(c).max(axis=1, keepdims=True), 1e-300)
    c[:, -1] = np.where(np.abs(c[:, -1]) < LEAST, LEAST, c[:, -1])
    companion = np.zeros((len(c), c.shape[1] - 1, c.shape[1] - 1))
    companion[:, 1:, :-1] = np.eye(c.shape[1] - 2)
    companion[:, :, -1] = -c[:, :-1] / c[:, -1:]
    u = np.linalg.eigvals(companion)
    times = u.real * ends[:, None]
    return np.where((u.imag == 0) & (times > NEAR) & (u.real <= 1), times, np.nan)


def illegal(motion, t):
    """Whether the circles of both ends of each edge are there, and hold what is beyond the edge."""
    sites = np.concatenate([motion[:, :, :2] + t[:, None, None] * motion[:, :, 2:4], motion[:, :, 4:]], axis=2)
    result = np.ones(len(t), bool)
    for three, fourth in (([0, 2, 1], 3), ([0, 1, 3], 2)):
        x, y, rho, side = tangent_circles(sites[:, three])
        e = sites[:, fourth].T
        result &= (side > 0) & (np.where(e[2] < 0, -1, 1) * ((e[0] - x)**2 + (e[1] - y)**2 - (rho + e[2])**2) < 0)
    return result


class Counter:
    """The counts of the edges (l, r, s, e) and pairs that are asked about, in batches."""

    def __init__(self, horizon):
        self.horizon, self.counts = horizon, collections.Counter()
        self.edges, self.pairs = [], []

    def ask(self, now, motion, edges, pairs):
        """`motion`: x, y, vx, vy, signed radius of each generator now, the container last."""
        for kind, ids, rows in (("edges", edges, self.edges), ("pairs", pairs, self.pairs)):
            if ids:
                rows.append((np.full(len(ids), self.horizon - now), motion[np.array(ids)]))
        if len(self.edges) > BATCH:
            self.count()

    def count(self):
        if self.pairs:
            ends, motion = (np.concatenate(parts) for parts in zip(*self.pairs))
            self.counts["collisions"] += int((contacts(motion, 0, 1) <= ends).sum())
        if self.edges:
            self.count_flips(*(np.concatenate(parts) for parts in zip(*self.edges)))
        self.edges, self.pairs = [], []

    def count_flips(self, ends, motion):
        roots = roots_within(flip_polynomials(motion), ends)
        first_contact = np.minimum.reduce([contacts(motion, i, j) for i, j in PAIRS])
        row, column = np.nonzero(~np.isnan(roots))
        t = roots[row, column]
        collapses = illegal(motion[row], t + SOON)
        self.counts["flips"] += len(np.unique(row[collapses]))
        self.counts["flips_before_contact"] += len(np.unique(row[collapses & (t < first_contact[row])]))
        self.counts["roots"] += len(np.unique(row))


def predictions(scene, history):
    motion = np.array([[*map(float, (d.x, d.y, d.vx, d.vy, d.radius))] for d in scene.disks] +
                      [[float(x) for x in (*scene.container[:2], 0, 0, -scene.container[2])]])
    since = np.zeros(len(motion))
    edges = Edges(history.initial.tolist())
    counter = Counter(float(history.horizon))
    changed, adjacent, moved = set(edges.twin), set(edges.twin), set()

    def ask(now):
        for g in moved - {vp.CONTAINER}:
            for spoke, rim in edges.around(g):
                changed.update((spoke, rim))
                adjacent.add(spoke)
        places = motion.copy()
        places[:, :2] += (now - since)[:, None] * motion[:, 2:4]
        quads = {min((l, r, edges.twin[l, r, e][2], e), (r, l, e, edges.twin[l, r, e][2]))
                 for l, r, e in changed & edges.twin.keys()}
        pairs = {(min(h[:2]), max(h[:2])) for h in adjacent & edges.twin.keys()}
        counter.ask(now, places, sorted(q for q in quads if q[2] != q[3]), sorted(pairs))
        for some in (changed, adjacent, moved):
            some.clear()

    now = 0.0
    for event in history.events:
        t, ids = float(event["t"]), event["ids"].tolist()
        if t != now:
            ask(now)
            now = t
        if event["kind"] == vp.FLIP:
            new = edges.flip(*ids)
            changed.update(new)
            adjacent.add(new[0])
            continue
        for side, g in enumerate(ids[:2]):
            if g >= 0:
                motion[g, :2], motion[g, 2:4], since[g] = event["center"][side], event["velocity"][side], t
                moved.add(g)
    if now < counter.horizon:
        ask(now)
    counter.count()
    return {what: counter.counts[what] for what in ("flips", "flips_before_contact", "roots", "collisions")}
