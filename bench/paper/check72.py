#!/usr/bin/python3
"""Tests a history as section 7.2 of the paper does, for comparison with what `voroproof certify` proves.

usage: bench/paper/check72.py SCENE HISTORY [--step TIME] [--tolerance LENGTH]

At every multiple of the step, and midway between any two consecutive times of events, computes in doubles the
tangent circle of every V-vertex and looks for a generator that reaches into it by more than the tolerance. Ends
at the first such instant with `failed` and exit code 1, else with `passed`. Proves nothing (docs/experiments.md).
Needs the module voroproof.
"""
import argparse
import sys

import numpy as np
import voroproof as vp
from circles import tangent_circles


def vertices_of(l, r, s, e):
    """The vertices at the ends of an edge, each from its smallest generator."""
    def canonical(*three):
        first = three.index(min(three))
        return three[first:] + three[:first]
    return {canonical(l, s, r), canonical(l, r, e)}


class Check:
    def __init__(self, scene, history, tolerance):
        self.history, self.tolerance = history, tolerance
        x, y, radius = map(float, scene.container)
        self.sites = np.column_stack([np.zeros((len(scene) + 1, 2)), [*scene.radii, -radius]])
        self.sites[-1, :2] = x, y  # the container is the last one, as its id -1 says
        edges = scene.diagram(0).edges if history.initial is None else history.initial
        self.vertices = set().union(*(vertices_of(*edge) for edge in edges.tolist()))
        self.regular = self.midway = self.circles = 0
        self.deepest = -np.inf

    def run(self, step):
        """The first intrusion (t, vertex, generator, depth), or None."""
        now, events = 0.0, self.history.events
        for t, kind, ids in [*zip(events["t"].tolist(), events["kind"], events["ids"].tolist()),
                             (self.history.ending.t, None, None)]:
            while self.regular * step < t or (kind is None and self.regular * step == t):
                self.regular += 1
                if found := self.look((self.regular - 1) * step):
                    return found
            if t > now:
                self.midway += 1
                if found := self.look(now + (t - now) / 2):
                    return found
            now = t
            if kind == vp.FLIP:
                l, r, s, e = ids
                if not vertices_of(*ids) <= self.vertices:
                    sys.exit(f"at t = {t}: no such edge: {ids}")
                self.vertices = self.vertices - vertices_of(*ids) | vertices_of(s, e, r, l)
        return None

    def look(self, t):
        """The deepest intrusion at an instant beyond the tolerance, or None."""
        if not self.vertices:
            return None
        self.circles += len(self.vertices)
        self.sites[:-1, :2] = self.history.positions(t)
        vertices = np.array(sorted(self.vertices))
        x, y, rho, _ = tangent_circles(self.sites[vertices])
        for missing in np.flatnonzero(~(rho >= 0)):
            return t, vertices[missing], None, 0
        distance = np.hypot(x[:, None] - self.sites[:, 0], y[:, None] - self.sites[:, 1])
        distance[:, -1] *= -1  # the container is around
        depth = rho[:, None] + self.sites[:, 2] - distance
        np.put_along_axis(depth, vertices % len(self.sites), -np.inf, axis=1)
        vertex, generator = np.unravel_index(depth.argmax(), depth.shape)
        self.deepest = max(self.deepest, depth[vertex, generator])
        if depth[vertex, generator] <= self.tolerance:
            return None
        return t, vertices[vertex], generator if generator < len(depth[0]) - 1 else vp.CONTAINER, depth[vertex, generator]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("history")
    parser.add_argument("--step", type=float, default=0.1)
    parser.add_argument("--tolerance", type=float, default=1e-6)
    args = parser.parse_args()
    scene = vp.Scene.read(args.scene)
    check = Check(scene, vp.History.read(args.history, scene), args.tolerance)
    found = check.run(args.step)
    print(f"c {check.circles} circles at {check.regular} regular instants and {check.midway} midway between events; "
          f"deepest intrusion {max(check.deepest, 0.0)}")
    if found is None:
        print("passed")
        return 0
    t, vertex, generator, depth = found
    print(f"c at t = {t} the circle of {vertex.tolist()} " +
          ("does not exist" if generator is None else f"is entered by {generator}, by {depth}"))
    print("failed")
    return 1


if __name__ == "__main__":
    sys.exit(main())
