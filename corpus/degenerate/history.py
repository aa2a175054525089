"""Histories as lists of claims, and edits of them. Nothing is computed here that the file does not say."""
import json
from dataclasses import dataclass

from degenerate.scene import float_text


def dump(value):
    """Compact JSON with numbers as the program writes them."""
    if isinstance(value, dict):
        return "{" + ",".join(f"{json.dumps(k)}:{dump(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ",".join(dump(v) for v in value) + "]"
    return float_text(value) if isinstance(value, float) else json.dumps(value)


def canonical(q):
    return min(list(q), [q[1], q[0], q[3], q[2]])


def flipped(q):
    """The name of the edge [l,r,s,e] after its flip: [s,e,r,l]."""
    return canonical([q[2], q[3], q[1], q[0]])


def flip(edges, q):
    """The edges after the flip of q, sorted (docs/formats.md, section 3)."""
    l, r, s, e = q
    edges = [list(x) for x in edges]
    edges.remove(canonical(q))
    # Vertices [l,s,r] and [l,r,e] become [l,s,e] and [r,e,s]: the edge between a and b that
    # ended in one of the old has `fresh` there now. An edge may be concerned at both ends.
    for a, b, old, fresh in ((l, s, r, e), (s, r, l, e), (r, e, l, s), (e, l, r, s)):
        for k, x in enumerate(edges):
            if x[:2] == [a, b] and x[3] == old:
                edges[k] = [a, b, x[2], fresh]
                break
            if x[:2] == [b, a] and x[2] == old:
                edges[k] = [b, a, fresh, x[3]]
                break
        else:
            raise ValueError(f"no neighbour of {q} between {a} and {b}")
    return sorted([canonical(x) for x in edges] + [flipped(q)])


@dataclass
class History:
    header: dict
    events: list
    last: dict

    @classmethod
    def read(cls, text):
        lines = [json.loads(line) for line in text.splitlines()]
        return cls(lines[0], lines[1:-1], lines[-1])

    def text(self):
        last = self.last
        if "end" in last:
            kinds = ("flip", "collide", "maneuver")
            count = [sum(kind in e for e in self.events) for kind in kinds]
            last = {"end": {"t": last["end"]["t"], "flips": count[0], "collisions": count[1],
                            "maneuvers": count[2]}}
        return "".join(dump(x) + "\n" for x in [self.header, *self.events, last])

    def with_events(self, events):
        return History(self.header, events, self.last)

    def indices(self, kind):
        return [k for k, e in enumerate(self.events) if kind in e]

    def ties(self, kind):
        """Groups of at least two events of a kind that have one time."""
        groups = {}
        for k in self.indices(kind):
            groups.setdefault(self.events[k]["t"], []).append(k)
        return [group for group in groups.values() if len(group) > 1]

    def edges_before(self, k):
        """The diagram before event k."""
        edges = self.header["initial"]
        for e in self.events[:k]:
            if "flip" in e:
                edges = flip(edges, e["flip"])
        return edges
