"""Diagrams as sets of V-edges, and their flips (docs/formats.md, section 3)."""


def reversed_name(edge):
    l, r, s, e = edge
    return r, l, e, s


def name(edge):
    """The one of the two names of a V-edge that is to be written."""
    return min(tuple(edge), reversed_name(edge))


def back(edge):
    """The quadruplet that undoes the flip of this one."""
    l, r, s, e = edge
    return s, e, r, l


def without_orientation(edge):
    l, r, s, e = edge
    return l, r, e, s


def vertices(edge):
    """The vertices that the flip of the V-edge takes away and brings, without their orientation."""
    l, r, s, e = edge
    return {frozenset(triple) for triple in ((l, s, r), (l, r, e), (l, s, e), (r, e, s))}


class Diagram:
    def __init__(self, edges):
        self.edges = frozenset(map(name, edges))

    def has(self, edge):
        return name(edge) in self.edges

    def flipped(self, edge):
        """The diagram after the flip, or None where there is no such V-edge or no such diagram."""
        l, r, s, e = edge
        if s == e or not self.has(edge):
            return None
        edges = set(self.edges) - {name(edge)}
        # Each V-edge [left, right, start, old] that met it ends in another generator.
        for left, right, old, new in (l, s, r, e), (s, r, l, e), (r, e, l, s), (e, l, r, s):
            met = self.ending(left, right, old, edges)
            if met is None or new in (left, right):
                return None
            edges.remove(name(met))
            edges.add(name((left, right, met[2], new)))
        edges.add(name(back(edge)))
        return Diagram(edges) if len(edges) == len(self.edges) else None

    @staticmethod
    def ending(left, right, end, edges):
        for edge in edges:
            for named in edge, reversed_name(edge):
                if (named[0], named[1], named[3]) == (left, right, end):
                    return named
        return None
