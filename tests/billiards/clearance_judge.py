"""How near the disks of a billiard come to each other, to images and to walls on recorded paths: exactly, by brute force.

All pairs, images and walls are looked at between any two turns. Nothing is rounded.
"""

import os
import sys
from fractions import Fraction
from itertools import pairwise
from math import isqrt

from billiard import dot, record_paths

sys.path.append(os.path.join(os.path.dirname(__file__), "..", "planning", "agreement"))
from polynomials import (between, bounds, is_negative_at, negative_parts, plus, reaches, roots,  # noqa: E402
                         times, value, whole)

ZERO = Fraction(0)


def shifted(p, u, v):
    """A polynomial of time as one of s from 0 to 1, from u to v."""
    result = []
    for c in reversed(p):
        result = plus(times(result, [u, v - u]), [c])
    return result


def less(p, q):
    return plus(p, [-c for c in q])


def root(x):
    """The root of a fraction, which may be a little less."""
    return Fraction(isqrt(int(x * 4 ** 200)), 2 ** 200)


def either_negative(p, q):
    """The longest intervals of [0, 1] in which one of two polynomials is negative, as pairs of roots, None at 0 and 1."""
    kinds = [f for f in (p, q) if f]
    places = roots(times(*kinds) if len(kinds) == 2 else kinds[0]) if kinds else []
    parts = []
    for k, x in enumerate(between(places)):
        first, last = places[k - 1] if k else None, places[k] if k < len(places) else None
        if first and first.lo == first.hi == 1 or last and last.lo == last.hi == 0:
            continue
        if all(value(f, x) >= 0 for f in kinds):
            continue
        if parts and parts[-1][1] is first and any(is_negative_at(whole(f), first) for f in kinds):
            parts[-1] = (parts[-1][0], last)
        else:
            parts.append((first, last))
    return parts


class Piece:
    """Two, or a wall i < 0 and a disk, from u to v: the gap is sign (sqrt(square) - reach), by s."""

    def __init__(self, i, j, image, u, v, square, reach):
        self.i, self.j, self.image, self.u, self.v = i, j, image, u, v
        self.square, self.reach = square, reach
        self.is_contact = False

    def limit(self, gap):
        return plus(self.reach, [gap if self.i >= 0 else -gap])

    def is_below(self, gap, strict):
        """Whether the gap is less than that somewhere, or as small unless strict."""
        limit = self.limit(gap)
        excess = less(self.square, times(limit, limit))
        if self.i >= 0:
            return bounds(excess)[0] <= 0 and reaches(excess, [-c for c in limit], strict)
        if reaches(limit, None, True):
            return True
        if not self.square:
            return not strict and reaches(limit, None, False)
        return reaches([-c for c in excess], None, strict)

    def parts(self, gap):
        """Where the gap is less than that, which is positive: pairs of roots, None at the piece's ends."""
        limit = self.limit(gap)
        if self.i < 0 and not self.square:
            return negative_parts(limit, None)
        excess = less(self.square, times(limit, limit))
        if self.i >= 0:
            return negative_parts(excess, None)
        return either_negative(limit, [-c for c in excess])

    def gap_at(self, s):
        """In doubles."""
        distance, reach = float(root(value(self.square, s))), float(value(self.reach, s))
        return distance - reach if self.i >= 0 else reach - distance


class ClearanceJudge:
    """A scene without shear and a history that was read, up to `end`."""

    def __init__(self, scene, history, end):
        self.scene, self.history, self.end = scene, history, end
        self.paths = record_paths(scene, history)
        self.radii = [[d.radius, d.growth] for d in scene.disks]
        self.largest = max((max(d.radius, d.radius + d.growth * end) for d in scene.disks), default=ZERO)
        # Roundings are less; no decision of interest is as near.
        speed = max((max(map(abs, p.velocity(n, t))) for p in self.paths for n, t in enumerate(p.starts)),
                    default=ZERO)
        self.rounding = (scene.extent + speed * end) * (len(history.claims) + 1) / 2 ** 40
        self.walls = self._walls()
        self.contacts, self.apart = self._contacts()

    def _cuts(self, *disks):
        cuts = {ZERO, self.end} | {t for g in disks for t in self.paths[g].starts if ZERO < t < self.end}
        return list(pairwise(sorted(cuts))) or [(ZERO, ZERO)]

    def _line(self, g, u, v):
        starts = self.paths[g].starts
        n = max(k for k, t in enumerate(starts) if t <= u)
        return [shifted(c, u, v) for c in self.paths[g].lines[n]]

    def _radius(self, g, u, v):
        return shifted(self.radii[g], u, v)

    def _contact(self, i, j, image, t):
        return (i, j, image, min(t, self.end)) in self.contacts

    def _mark(self, piece):
        piece.is_contact = any(self._contact(piece.i, piece.j, piece.image, t) for t in (piece.u, piece.v))
        return piece

    def _walls(self):
        pieces = []
        for g in range(len(self.scene.disks)):
            for u, v in self._cuts(g):
                line, radius = self._line(g, u, v), self._radius(g, u, v)
                for k, wall in enumerate(self.scene.walls):
                    gap = less([-c for c in shifted([wall.offset, wall.speed], u, v)], radius)
                    for n, p in zip(wall.normal, line):
                        gap = plus(gap, [n * c for c in p])
                    pieces.append(Piece(-1 - k, g, None, u, v, [], gap))
                if self.scene.circle:
                    square = []
                    for o, p in zip(self.scene.circle.center, line):
                        d = plus(p, [-o])
                        square = plus(square, times(d, d))
                    pieces.append(Piece(-1, g, None, u, v, square, less([self.scene.circle.radius], radius)))
        return pieces

    def _contacts(self):
        """The claims of two that touch, and the first of two that do not."""
        touching, apart = set(), []
        for claim in self.history.claims:
            if not claim.pair:
                continue
            (i, j), t = claim.pair, min(claim.t, self.end)
            gap = self._gap(i, j, claim.image, t)
            image = claim.image if i >= 0 else None
            if abs(gap) <= self.rounding:
                touching.add((i, j, image, t))
            else:
                apart.append(claim)
        return touching, apart

    def _gap(self, i, j, image, t):
        def place(g):
            path = self.paths[g]
            n = max(k for k, since in enumerate(path.starts) if since <= t)
            return path.centre(n, t)
        b, radius = place(j), self.radii[j][0] + self.radii[j][1] * t
        if i < 0 and not self.scene.circle:
            wall = self.scene.walls[-1 - i]
            return dot(wall.normal, b) - wall.offset - wall.speed * t - radius
        if i < 0:
            d = [x - o for x, o in zip(b, self.scene.circle.center)]
            return self.scene.circle.radius - radius - root(dot(d, d))
        d = [y - x + k * (side or 0) for x, y, k, side in zip(place(i), b, image, self.scene.sides)]
        return root(dot(d, d)) - radius - self.radii[i][0] - self.radii[i][1] * t

    def pieces(self, gap):
        """All of two disks that may be as near as that, and all of walls."""
        limit = 2 * self.largest + max(gap, ZERO)
        for j in range(len(self.scene.disks)):
            for i in range(j):
                for u, v in self._cuts(i, j):
                    offset = [less(q, p) for p, q in zip(self._line(i, u, v), self._line(j, u, v))]
                    low, high = zip(*(bounds(p) for p in offset))
                    reach = plus(self._radius(i, u, v), self._radius(j, u, v))
                    for image in self.scene.images(low, high, limit):
                        yield self._mark(self._pair(i, j, image, u, v, offset, reach))
            for axis, side in enumerate(self.scene.sides):
                if side is not None:
                    image = tuple(int(a == axis) for a in range(self.scene.dimension))
                    reach = [2 * c for c in self._radius(j, ZERO, self.end)]
                    yield Piece(j, j, image, ZERO, self.end, [side * side], plus(reach, []))
        for piece in self.walls:
            yield self._mark(piece)

    def _pair(self, i, j, image, u, v, offset, reach):
        square = []
        for p, k, side in zip(offset, image, self.scene.sides):
            d = plus(p, [k * (side or 0)])
            square = plus(square, times(d, d))
        return Piece(i, j, image, u, v, square, reach)

    def verdicts(self, required, may_touch, kind=lambda piece: True):
        """Whether it must be refuted, and whether it may be. What is too near at a contact may be either."""
        strict = required != 0 or may_touch
        must = may = False
        for piece in filter(kind, self.pieces(required)):
            if piece.is_contact and (required > 0 or not strict):
                must = may = True
            elif piece.is_below(required, strict):
                may = True
                must = must or not piece.is_contact or piece.is_below(required - self.rounding, True)
            if must:
                break
        return must, may

    def missing_maneuvers(self):
        """Whether the maneuvers up to the end are other than the scheduled ones, but for rounding."""
        scheduled = {}
        for m in self.scene.maneuvers:
            if m.t <= self.end:
                scheduled.setdefault(m.disk, []).append((float(m.t), [float(x) for x in m.velocity]))
        told = {}
        for claim in self.history.claims:
            if claim.maneuver is not None:
                (disk, v), = claim.velocities.items()
                told.setdefault(disk, []).append((float(claim.t), [float(x) for x in v]))
        return scheduled != told

    def is_missing(self):
        collisions = sum(claim.pair is not None for claim in self.history.claims)
        counts = collisions, len(self.history.claims) - collisions
        return bool(self.apart or self.end < self.scene.horizon or self.missing_maneuvers()
                    or self.history.counts != counts)

    def spells(self, gap):
        """(i, j, image) to all times in which a gap is less than that, each from one (piece, root) to another."""
        found = {}
        for piece in self.pieces(gap):
            parts = found.setdefault((piece.i, piece.j, piece.image), [])
            for first, last in piece.parts(gap):
                if parts and first is None and parts[-1][1][1] is None and parts[-1][1][0].v == piece.u:
                    parts[-1] = (parts[-1][0], (piece, last))
                else:
                    parts.append(((piece, first), (piece, last)))
        return {key: parts for key, parts in found.items() if parts}
