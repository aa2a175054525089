"""Two generators in motion: the first time of contact, as (a + b sqrt(square)) / c."""
from circle import sign, sign_of_sum
from fields import Wrong


def room(m, n):
    """[f0, f1, f2]: the room f(t) between two, negative where they overlap; and the time, as a
    fraction, after which a container is smaller than the disk, or None."""
    if m[0] != "d":
        m, n = n, m
    _, x, y, r, vx, vy, vr = m
    letter, a, b, c, va, vb, vc = n
    if letter == "w":
        return [a * x + b * y - c - r, a * vx + b * vy - vr, 0], None
    dx, dy, dvx, dvy = x - a, y - b, vx - va, vy - vb
    distance = [dx * dx + dy * dy, 2 * (dx * dvx + dy * dvy), dvx * dvx + dvy * dvy]
    total, rate, factor, end = (r + c, vr + vc, 1, None) if letter == "d" else (c - r, -vr, -1, None)
    if letter == "c":
        if total < 0:
            raise Wrong("they overlap at time 0")
        if rate:
            end = (total, -rate)
    square = [total * total, 2 * total * rate, rate * rate]
    return [factor * (d - s) for d, s in zip(distance, square)], end


def from_touch(f, end):
    """The first contact where f(0) = 0."""
    _, f1, f2 = f
    if f1 > 0:
        return ("hit", (-f1, 0, 0, f2)) if f2 < 0 else ("none", None)
    if f1 < 0 or f2 < 0:
        return "hit", (0, 0, 0, 1)
    if f2 and not (end and end[0] == 0):
        return "none", None
    # They touch all the time, or the disk is as large as the container now and grows.
    return ("hit", (end[0], 0, 0, end[1])) if end else ("none", None)


def first_contact(f, end):
    """(KIND, time) of the room f. The room of a disk in a container is no more right after the time
    `end`, but it has a zero before, or there."""
    f0, f1, f2 = f
    if f0 < 0:
        raise Wrong("they overlap at time 0")
    if f0 == 0:
        return from_touch(f, end)
    if f2 == 0:
        return ("hit", (-f0, 0, 0, f1)) if f1 < 0 else ("none", None)
    square = f1 * f1 - 4 * f0 * f2
    if square < 0 or (f2 > 0 and f1 >= 0):
        return "none", None
    time = (-f1, -1, square, 2 * f2)
    if square:
        return "hit", time
    # A graze from inside is a hit where the disk fills the container: both centres are the same then.
    filled = end is not None and -f1 * end[1] == end[0] * 2 * f2
    return ("hit" if filled else "graze"), time


def compare(time, value):
    """The sign of time - value."""
    a, b, square, c = time
    numerator, denominator = value.as_integer_ratio()
    return sign(c) * sign_of_sum(a * denominator - numerator * c, b * denominator, square)
