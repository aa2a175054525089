"""Cells of disks at rest, in the plane or in a container.

Seen from the centre of the disk a, let a place be in direction n at distance l. Another generator, at c
from there, with e = r - r_a, or e = -(R + r_a) for the container, is as near as a where
2 l (n.c + e) = |c|^2 - e^2 = p, and is nearer exactly where 1/l < 2 (n.c + e) / p: for a disk p > 0 if
neither contains the other, for the container p < 0 if the disk is not outside. So a pair has a common edge
where the second one's function of n is above 0 and above all others'. Each such condition,
G.n + H > 0, holds on an open arc of the circle of directions. An edge of positive length is an open
arc where all hold: if there is one, and not all arcs are whole circles, then one that all others
contain starts where one of them does.
"""
from circle import sign_of_sum


def hidden(container, disks):
    found = set()
    for i, (x, y, r) in enumerate(disks):
        if container and (x - container[0]) ** 2 + (y - container[1]) ** 2 >= (r + container[2]) ** 2:
            found.add(i)
        for j, (u, v, s) in enumerate(disks):
            inside = s >= r and (x - u) ** 2 + (y - v) ** 2 <= (s - r) ** 2
            if inside and j != i and ((x, y, r) != (u, v, s) or j < i):
                found.add(i)
    return found


def seen_from(a, b, is_container):
    """(c, e, p) of the generator b, with the sign that makes p positive."""
    x, y = b[0] - a[0], b[1] - a[1]
    e = -(b[2] + a[2]) if is_container else b[2] - a[2]
    p = x * x + y * y - e * e
    return (x, y, e, p) if p > 0 else (-x, -y, -e, -p)


def holds_after(start, arc):
    """Whether a condition holds right after the start of another one's arc, counterclockwise."""
    gx, gy, h, square = start
    ux, uy, k, _ = arc
    along, across = gx * ux + gy * uy, gx * uy - gy * ux
    now = sign_of_sum(k * (gx * gx + gy * gy) - h * along, -across, square)
    return now > 0 or (now == 0 and sign_of_sum(-h * across, along, square) > 0)


def has_edge(b, others):
    """Whether b is strictly above all others, and above 0, on an arc."""
    bx, by, be, bp = b
    conditions = [(bx, by, be)]
    conditions += [(bx * p - x * bp, by * p - y * bp, be * p - e * bp) for x, y, e, p in others]
    arcs = []
    for x, y, h in conditions:
        square = x * x + y * y - h * h
        if square > 0:
            arcs.append((x, y, h, square))
        elif h <= 0:
            return False
        # Else it holds everywhere, or but for one direction.
    return not arcs or any(
        all(holds_after(arc, other) for other in arcs if other is not arc) for arc in arcs)


def edges(container, disks, gone):
    """The sorted pairs with a common edge, the container as -1."""
    found = []
    for a, disk in enumerate(disks):
        if a in gone:
            continue
        seen = {b: seen_from(disk, other, False)
                for b, other in enumerate(disks) if b != a and b not in gone}
        if container:
            seen[-1] = seen_from(disk, container, True)
        for b in seen:
            if (b > a or b < 0) and has_edge(seen[b], [s for j, s in seen.items() if j != b]):
                found.append((min(a, b), max(a, b)))
    return sorted(found)
