#!/usr/bin/env python3
"""That the oracle accepts lines that are right and rejects lines that are wrong. All are made by hand.

A token with a point stands for the hexadecimal float of that number, as do those from rounded().
"""
import gzip
import pathlib
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from math import inf, isqrt, nextafter

sys.dont_write_bytecode = True
FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

import oracle
from fields import Malformed, Wrong


def line_of(text):
    return " ".join(float(t).hex() if "." in t and "x" not in t else t for t in text.split())


def disks(*triples):
    """Disks at rest, or in motion, from strings of numbers."""
    return " ".join("d " + " ".join(f"{float(t)}" for t in triple.split()) for triple in triples)


def rounded(whole, square):
    """whole + sqrt(square), or minus it where square < 0, an irrational, rounded down and up."""
    root = Fraction(isqrt(abs(square) << 400), 1 << 200)
    value = whole + (root if square > 0 else -root)
    near = float(value)
    low = near if near < value else nextafter(near, -inf)
    return f"{low.hex()} {nextafter(low, inf).hex()}"


class Lines(unittest.TestCase):
    def right(self, name, text):
        with self.subTest(line=text):
            oracle.check(name, line_of(text))

    def wrong(self, name, text, reason=None, error=Wrong):
        with self.subTest(line=text):
            with self.assertRaisesRegex(error, reason or ""):
                oracle.check(name, line_of(text))

    def sign(self, name, sign, rest):
        """Only that sign is right."""
        for said in (-1, 0, 1):
            head = "c 0 exact" if said == 0 else "c 53 interval"
            (self.right if said == sign else self.wrong)(name, f"{head} {said} {rest}")


POINTS = disks("1 0 0", "0 1 0", "-1 0 0")
AT_THREE = disks("3 0 1", "0 3 1", "-3 0 1")
# They touch the line y = 0 from below, and the circle of radius 2 with centre (0, -4).
BELOW = disks("6 -4 4", "0 -1 1", "-6 -4 4")
BELOW_TURNED = disks("-6 -4 4", "0 -1 1", "6 -4 4")


class Incircle(Lines):
    def test_points(self):
        for sign, place in ((0, "0 -1 0"), (1, "0 -2 0"), (-1, "0 0 0")):
            self.sign("incircle", sign, f"{POINTS} {disks(place)}")

    def test_smallest_difference(self):
        self.sign("incircle", 1, f"{POINTS} d 0.0 -0x1.0000000000001p+0 0.0")
        self.sign("incircle", -1, f"{POINTS} d 0x0.0000000000001p-1022 -0x1.fffffffffffffp-1 0.0")
        self.sign("incircle", 1, f"{POINTS} d 0x0.0000000000001p-1022 -1.0 0.0")

    def test_disks(self):
        for sign, place in ((0, "0 -3 1"), (1, "0 -3 0.5"), (-1, "0 -3 1.25")):
            self.sign("incircle", sign, f"{AT_THREE} {disks(place)}")

    def test_fourth_is_container_or_wall(self):
        for sign, fourth in ((0, "c 0.0 0.0 1.0"), (1, "c 0.0 0.0 2.0"), (0, "c 0.5 0.0 1.5"),
                             (-1, "c 0.0 0.4 1.2"), (0, "w 0.0 1.0 -1.0"), (1, "w 0.0 1.0 -2.0"),
                             (-1, "w 0.0 1.0 -0.5")):
            self.sign("incircle", sign, f"{POINTS} {fourth}")

    def test_container_among_the_three(self):
        for sign, place in ((0, "0 0 0"), (-1, "0 1 0"), (1, "0 -1 0")):
            self.sign("incircle", sign, f"c 0.0 0.0 4.0 {disks('-2 2 0', '2 2 0', place)}")
            self.sign("incircle", sign, f"{disks('2 2 0')} c 0.0 0.0 4.0 {disks('-2 2 0', place)}")

    def test_walls_among_the_three(self):
        for sign, place in ((0, "1 2 0"), (1, "0.25 0.25 0"), (-1, "0.5 0.5 0")):
            self.sign("incircle", sign, f"w 1.0 0.0 0.0 w 0.0 1.0 0.0 {disks('4 5 4', place)}")

    def test_other_circle_is_a_line(self):
        for sign, place in ((0, "0 -6 0"), (1, "0 -7 0"), (-1, "0 -5.5 0")):
            self.sign("incircle", sign, f"{BELOW} {disks(place)}")

    def test_no_question(self):
        turned = disks("-1 0 0", "0 1 0", "1 0 0", "0 -2 0")
        self.wrong("incircle", f"c 53 interval 1 {turned}", "does not exist")
        self.wrong("incircle", f"c 53 interval 1 {BELOW_TURNED} {disks('0 -7 0')}", "does not exist")
        self.wrong("incircle", f"c 53 interval -1 {AT_THREE} {disks('0 2 1')}", "overlap")
        self.wrong("incircle", f"c 53 interval -1 {POINTS} w 0.0 1.0 0.5", "overlap")
        self.wrong("incircle", f"c 53 interval -1 {POINTS} c 1.0 0.0 1.5", "overlap")
        self.wrong("incircle", f"c 53 interval 1 {POINTS} w 0.6 0.8 -9.0", "unit vector")
        self.wrong("incircle", f"c 53 interval 1 {POINTS} {disks('0 -2 -1')}", "negative radius")
        self.wrong("incircle", f"c 53 interval 1 {disks('1 0 0', '0 1 0')} w 0.0 1.0 -9.0 c 0.0 0.0 9.0", "container")

    def test_columns(self):
        rest = f"{POINTS} {disks('0 -1 0')}"
        self.wrong("incircle", f"c 53 exact 0 {rest}", "exact zero")
        self.wrong("incircle", f"c 0 interval 0 {rest}", "exact zero")
        self.wrong("incircle", f"c 0 interval 1 {POINTS} {disks('0 -2 0')}", "no precision")
        for head in ("c 54 exact 0", "c 0 guess 0", "c 0 exact 2", "c 0 exact", "0 exact 0"):
            self.wrong("incircle", f"{head} {rest}", error=Malformed)
        for tail in (f"{rest} 1", POINTS, f"{POINTS} d 0 -1.0 0.0", f"{POINTS} d 0x1.00000000000008p+0 0.0 0.0",
                     f"{POINTS} e 0.0 -1.0 0.0", f"{POINTS} d 0x1p+9999 0.0 0.0", f"{POINTS} d inf 0.0 0.0"):
            self.wrong("incircle", f"c 0 exact 0 {tail}", error=Malformed)
        with self.assertRaises(Malformed):
            oracle.check("incircle", line_of(f"c 0 exact 0 {rest}").replace(" d", "  d", 1))


class Exists(Lines):
    def test_disks(self):
        self.sign("exists", 1, POINTS)
        self.sign("exists", -1, disks("-1 0 0", "0 1 0", "1 0 0"))
        self.sign("exists", 1, AT_THREE)

    def test_line_on_one_side(self):
        self.sign("exists", 1, BELOW)
        self.sign("exists", 0, BELOW_TURNED)
        self.sign("exists", -1, disks("6 -1 1", "0 -2 2", "-6 -1 1"))
        self.sign("exists", 0, disks("-6 -1 1", "0 -2 2", "6 -1 1"))

    def test_lines_on_both_sides(self):
        self.sign("exists", 0, disks("0 0 1", "3 0 1", "9 0 1"))
        self.sign("exists", 0, disks("0 0 1", "9 0 1", "3 0 1"))
        self.sign("exists", 0, disks("0 0 1", "4 4 2", "8 8 3"))
        self.sign("exists", 1, disks("0 0 1", "3 0 0.5", "9 0 1"))
        self.sign("exists", -1, disks("0 0 1", "3 0 1.5", "9 0 1"))

    def test_walls(self):
        wall, beside = "w 0.0 1.0 0.0", "w 1.0 0.0 0.0"
        # Equal tops: the circle that would bulge upwards is a line, the one below is not.
        self.sign("exists", 0, f"{wall} {disks('-3 2 1', '3 1.5 1.5')}")
        self.sign("exists", 0, f"{disks('-3 2 1', '3 1.5 1.5')} {wall}")
        self.sign("exists", 1, f"{wall} {disks('3 1.5 1.5', '-3 2 1')}")
        # Others have both circles.
        self.sign("exists", 1, f"{wall} {disks('-3 2 1', '3 1 1')}")
        self.sign("exists", 1, f"{wall} {disks('3 1 1', '-3 2 1')}")
        for first, second in ((wall, beside), (beside, wall), (wall, "w 0.0 -1.0 -9.0")):
            self.sign("exists", 1, f"{first} {second} {disks('4 5 4')}")

    def test_container(self):
        self.sign("exists", 1, f"c 0.0 0.0 4.0 {disks('-2 2 0', '2 2 0')}")
        self.sign("exists", 1, f"c 0.0 0.0 4.0 {disks('2 2 0', '-2 2 0')}")


class Contact(Lines):
    def only(self, kind, time, pair):
        """Only that kind at that time is right."""
        m, n = pair.split(",")
        kinds = {"none", "graze", "hit"}
        for said in kinds:
            for order in (f"{m} {n}", f"{n} {m}"):
                times = "- -" if said == "none" else time if kind != "none" else "1.0 1.0"
                (self.right if said == kind else self.wrong)("contact", f"c 0 exact {said} {times} {order}")
        if kind != "none":
            low, high = (float.fromhex(t) for t in line_of(time).split())
            for times in ((high, nextafter(high, inf)), (nextafter(low, -inf), low), (low, nextafter(high, inf)),
                          (high, high) if low != high else (low, nextafter(low, inf)), (low + 1, high + 1)):
                text = " ".join(t.hex() for t in times)
                self.wrong("contact", f"c 0 exact {kind} {text} {m} {n}", "LO and HI")

    def test_disks(self):
        rest = disks("5 0 1 0 0 0")
        self.only("hit", "3.0 3.0", f"{disks('0 0 1 1 0 0')},{rest}")
        self.only("none", "", f"{disks('0 0 1 -1 0 0')},{rest}")
        self.only("graze", "5.0 5.0", f"{disks('0 2 1 1 0 0')},{rest}")
        self.only("none", "", f"{disks('0 3 1 1 0 0')},{rest}")
        self.only("hit", rounded(5, -3), f"{disks('0 1 1 1 0 0')},{rest}")
        self.only("hit", "1.5 1.5", f"{disks('0 0 1 1 0 0')},{disks('5 0 1 0 0 1')}")

    def test_touching_at_first(self):
        rest = disks("2 0 1 0 0 0")
        self.only("hit", "0.0 0.0", f"{disks('0 0 1 1 0 0')},{rest}")
        self.only("none", "", f"{disks('0 0 1 -1 0 0')},{rest}")
        self.only("none", "", f"{disks('0 0 1 0 1 0')},{rest}")
        self.only("none", "", f"{disks('0 0 1 0 0 0')},{rest}")
        self.only("hit", "0.0 0.0", f"{disks('0 0 1 0 1 1')},{rest}")
        self.only("hit", "0.0 0.0", f"{disks('0 0 1 -1 0 0')},{disks('2 0 1 0 0 2')}")

    def test_container(self):
        container = "c 0.0 0.0 5.0 0.0 0.0 0.0"
        self.only("hit", "4.0 4.0", f"{disks('0 0 1 1 0 0')},{container}")
        self.only("hit", "4.0 4.0", f"{disks('0 0 1 0 0 1')},{container}")
        self.only("hit", "2.0 2.0", f"{disks('0 0 1 1 0 1')},{container}")
        self.only("hit", "4.0 4.0", f"{disks('4 0 1 -1 0 1')},{container}")
        self.only("hit", "8.0 8.0", f"{disks('4 0 1 -1 0 0')},{container}")
        self.only("none", "", f"{disks('0 3 1 0 0 0')},{container}")

    def test_wall(self):
        wall = "w 0.0 1.0 0.0 0.0 0.0 0.0"
        self.only("hit", "4.0 4.0", f"{disks('0 5 1 7 -1 0')},{wall}")
        self.only("none", "", f"{disks('0 5 1 7 1 1')},{wall}")
        self.only("hit", "0.0 0.0", f"{disks('0 1 1 0 0 1')},{wall}")

    def test_no_question(self):
        self.wrong("contact", f"c 53 exact none - - {disks('0 0 1 0 0 0', '1 0 1 0 0 0')}", "overlap")
        self.wrong("contact", f"c 53 exact none - - {disks('0 0 1 0 0 -1', '5 0 1 0 0 0')}", "shrinks")
        self.wrong("contact", f"c 53 exact none - - {disks('0 0 1 0 0 0')} w 0.0 1.0 -5.0 0.0 0.0 1.0", "moves")
        self.wrong("contact", f"c 53 exact none 1.0 1.0 {disks('0 0 1 0 0 0', '5 0 1 0 0 0')}", error=Malformed)


REST = disks("3 0 1 0 0 0", "0 3 1 0 0 0", "-3 0 1 0 0 0")


class Collapse(Lines):
    def test_two_simple_zeros(self):
        rest = f"{REST} {disks('-2.5 -1 0 1 0 0')}"
        first, second = rounded(Fraction(5, 2), -3), rounded(Fraction(5, 2), 3)
        self.right("collapse", f"c 53 exact 1 2 {first} 1 -1 {second} 1 1 0.0 5.0 {rest}")
        self.right("collapse", f"c 53 exact 1 1 {first} 1 -1 0.0 3.0 {rest}")
        self.right("collapse", f"c 53 exact -1 0 1.0 4.0 {rest}")
        for wrong in (f"-1 2 {first} 1 -1 {second} 1 1", f"1 1 {first} 1 -1", f"1 2 {first} 1 -1 {second} 1 -1",
                      f"1 2 {first} 1 -1 {second} 3 1", f"1 2 {second} 1 -1 {first} 1 1", "1 0",
                      f"1 2 {rounded(Fraction(11, 2), -3)} 1 -1 {second} 1 1",
                      f"1 2 {first} 1 -1 4.0 4.5 1 1", f"1 2 {first.split()[0]} {first.split()[0]} 1 -1 {second} 1 1"):
            self.wrong("collapse", f"c 53 exact {wrong} 0.0 5.0 {rest}")

    def test_zero_where_the_window_is_halved(self):
        # f has its zeros at -+6 and -+sqrt(336): one is the middle of the window, and ends the interval of another.
        four = disks("15 0 5 0 0 0", "0 15 5 0 0 0", "-15 0 5 0 0 0", "0 -8 0 1 0 0")
        self.right("collapse", f"c 0 exact 1 2 -6.0 -6.0 1 -1 6.0 6.0 1 1 -30.0 42.0 {four}")

    def test_even_order(self):
        for fourth in ("0 -2 0 1 0 0", "0 -3 1 1 0 0", "0 -3 1 1 -1 1"):
            rest = f"-0.5 1.0 {REST} {disks(fourth)}"
            self.right("collapse", f"c 0 exact 1 1 0.0 0.0 2 1 {rest}")
            self.wrong("collapse", f"c 53 exact 1 1 0.0 0.0 2 1 {rest}", "exact zero")
            self.wrong("collapse", f"c 0 exact 1 0 {rest}", "number of zeros")
            self.wrong("collapse", f"c 0 exact 1 1 0.0 0.0 4 1 {rest}", "order")

    def test_both_circles_at_once(self):
        # The centres are collinear: the circle on the other side has the same gap, and f is a square.
        four = disks("-16 0 8 0 0 0", "-5 0 1 0 0 0", "5 0 1 0 0 0", "16 0 8 0 0 1")
        self.right("collapse", f"c 53 exact 1 1 0.0 0.0 1 -1 -1.0 1.0 {four}")
        self.wrong("collapse", f"c 53 exact 1 1 0.0 0.0 2 -1 -1.0 1.0 {four}", "order")

    def test_third_order(self):
        four = disks("-18 0 5 1 0 1", "-10 0 1 -3 0 2", "10 0 1 -3 0 -3", "18 0 5 1 0 -2")
        self.right("collapse", f"c 0 exact -1 1 0.0 0.0 3 1 -0.0625 0.0625 {four}")
        self.wrong("collapse", f"c 0 exact -1 1 0.0 0.0 1 1 -0.0625 0.0625 {four}", "order")

    def test_wall(self):
        three = disks("3 0 1 0 0 1", "0 3 1 0 0 1", "-3 0 1 0 0 1")
        wall = "w 0.0 1.0 -2.0 0.0 0.0 0.0"
        self.right("collapse", f"c 53 exact -1 1 0.0 0.0 1 1 -0.25 0.25 {three} {wall}")
        self.wrong("collapse", f"c 53 exact 1 1 0.0 0.0 1 1 -0.25 0.25 {three} {wall}")

    def test_other_circle_is_a_line_all_the_time(self):
        three = disks("6 -4 4 0 0 0", "0 -1 1 0 0 0", "-6 -4 4 0 0 0")
        self.right("collapse", f"c 53 exact 1 1 1.0 1.0 1 -1 0.0 1.5 {three} {disks('0 -7 0 0 1 0')}")
        self.wrong("collapse", f"c 53 exact 1 0 0.0 1.5 {three} {disks('0 -7 0 0 1 0')}")

    def test_no_question(self):
        point = disks("0 -1.5 0 0 0 0")
        turned = disks("-3 0 1 0 0 0", "0 3 1 0 0 0", "3 0 1 0 0 0")
        self.wrong("collapse", f"c 53 interval 1 0 0.0 1.0 {turned} {point}", "does not exist")
        self.wrong("collapse", f"c 53 interval 1 0 0.0 9.0 {REST} {disks('0 -9 1 0 3 0')}", "touch or overlap")
        self.wrong("collapse", f"c 53 interval 1 0 0.0 9.0 {REST} {disks('-9 -2 1 2 0 0')}", "touch or overlap")
        self.wrong("collapse", f"c 53 interval 1 0 0.0 0.0 {REST} {point}", "empty window")
        self.wrong("collapse", f"c 53 exact 1 0 0.0 1.0 {REST} {disks('0 -2 0 1 0 0')}", "at an end")
        # With a wall the circle exists before and after it is a line, for a moment.
        tops = disks("-3 2 1 0 0 0", "3 2 1 0 1 0", "0 1.5 0 0 0 0")
        self.wrong("collapse", f"c 53 interval 1 0 -0.5 0.75 w 0.0 1.0 0.0 0.0 0.0 0.0 {tops}", "becomes a line")


class RootOrder(Lines):
    # Roots of each of the points 3, 4 with the disks: 5/2 +- sqrt 3, 5/2 +- sqrt 15, of 5 earlier by 2^-51.
    GENERATORS = (f"{REST} {disks('-2.5 -1 0 1 0 0', '-2.5 1 0 1 0 0')} "
                  f"d -0x1.3fffffffffffep+1 -1.0 0.0 1.0 0.0 0.0")
    # With four points f is a square: a root of order 2 at 1.
    SQUARE = disks("1 0 0 0 0 0", "0 1 0 0 0 0", "-1 0 0 0 0 0", "0 -2 0 0 1 0")

    def test_order(self):
        for sign, first, second in (
                (-1, "0.0 2.0 0 1 2 3", "3.0 5.0 0 1 2 3"), (1, "3.0 5.0 0 1 2 3", "0.0 2.0 0 1 2 4"),
                (0, "0.0 2.0 0 1 2 3", "0.5 1.0 4 2 1 0"), (0, "0.0 2.0 0 1 2 3", "-1.0 1.0 0 1 2 3"),
                (1, "0.0 2.0 0 1 2 3", "0.0 2.0 0 1 2 5"), (-1, "0.0 2.0 5 1 2 0", "0.0 2.0 0 1 2 4")):
            self.sign("rootorder", sign, f"{first} {second} 6 {self.GENERATORS}")

    def test_multiple_root(self):
        self.sign("rootorder", 0, f"0.0 2.0 0 1 2 3 0.5 1.5 3 2 1 0 4 {self.SQUARE}")
        self.sign("rootorder", -1, f"0.0 2.0 0 1 2 3 2.5 4.0 3 2 1 0 4 {self.SQUARE}")

    def test_windows(self):
        second = f"0.0 2.0 0 1 2 3 6 {self.GENERATORS}"
        for window in ("0.0 5.0", "1.0 2.0", "2.0 0.0", "-2.0 2.0"):
            self.wrong("rootorder", f"c 53 interval -1 {window} 0 1 2 3 {second}", "window")
        self.wrong("rootorder", f"c 53 interval -1 0.0 2.0 0 1 2 2 {second}", error=Malformed)
        self.wrong("rootorder", f"c 53 interval -1 0.0 2.0 0 1 2 6 {second}", error=Malformed)
        still = disks("1 0 0 0 0 0", "0 1 0 0 0 0", "-1 0 0 0 0 0", "0 -1 0 0 0 0")
        self.wrong("rootorder", f"c 0 exact 0 0.0 2.0 0 1 2 3 0.0 2.0 0 1 2 3 4 {still}", "zero at all times")


class Static(Lines):
    def only(self, frame, places, edges, gone=""):
        """Only these edges and hidden disks are right."""
        count, pairs, gone = len(places), [tuple(e) for e in edges], gone.split()
        flat = " ".join(f"{float(t)}" for place in places for t in place.split())

        def text(some, hidden):
            parts = [str(t) for pair in some for t in pair]
            return " ".join(["c 0 exact", frame, str(count), flat, str(len(some)), *parts, str(len(hidden)), *hidden])

        self.right("static", text(pairs, gone))
        for a in range(-1 if frame[0] == "c" else 0, count):
            for b in range(a + 1, count):
                other = [p for p in pairs if p != (a, b)] if (a, b) in pairs else sorted([*pairs, (a, b)])
                self.wrong("static", text(other, gone), "edge")
        for i in range(count):
            other = [h for h in gone if h != str(i)] if str(i) in gone else sorted([*gone, str(i)], key=int)
            self.wrong("static", text(pairs, other), "hidden")
        if len(pairs) > 1:
            self.wrong("static", text(pairs[::-1], gone), "sorted")

    def test_few(self):
        self.only("p", [], [])
        self.only("p", ["1 2 3"], [])
        self.only("p", ["1 2 3", "0 0 1"], [(0, 1)])
        self.only("c 0.0 0.0 9.0", [], [])
        self.only("c 0.0 0.0 9.0", ["0 0 1"], [(-1, 0)])
        self.only("c 0.0 0.0 9.0", ["0 0 1", "4 0 1"], [(-1, 0), (-1, 1), (0, 1)])

    def test_squares(self):
        square = [(0, 1), (0, 2), (1, 3), (2, 3)]
        for radius in (0, 1, 2, 2.5):
            self.only("p", [f"{x} {y} {radius}" for x in (0, 4) for y in (0, 4)], square)
        self.only("p", ["0 0 1", "0 4 1", "4 0 1", "4 4 0.5"], [*square[:2], (1, 2), *square[2:]])
        nine = [(a, b) for a in range(9) for b in range(9) if b - a == 3 or (b - a == 1 and b % 3)]
        self.only("p", [f"{x} {y} 1" for x in (0, 4, 8) for y in (0, 4, 8)], nine)

    def test_square_in_a_container(self):
        frame = [(-1, i) for i in range(4)]
        places = [f"{x} {y} 1" for x in (-2, 2) for y in (-2, 2)]
        self.only("c 0.0 0.0 9.0", places, [*frame, (0, 1), (0, 2), (1, 3), (2, 3)])
        # A small disk in the middle; its cell has no edge with the container.
        self.only("c 0.0 0.0 9.0", [*places, "0 0 1"],
                  [*frame, (0, 1), (0, 2), (0, 4), (1, 3), (1, 4), (2, 3), (2, 4), (3, 4)])

    def test_collinear(self):
        self.only("p", ["0 0 1", "5 0 1", "9 0 1"], [(0, 1), (1, 2)])
        self.only("p", ["0 0 1", "4 0 2", "8 0 3"], [(0, 1), (1, 2)])
        self.only("p", ["-10 0 5", "0 0 1", "10 0 5"], [(0, 1), (0, 2), (1, 2)])
        self.only("p", ["-10 0 1", "0 0 5", "10 0 1"], [(0, 1), (1, 2)])

    def test_hidden(self):
        self.only("p", ["0 0 3", "1 0 1", "9 0 1"], [(0, 2)], "1")
        self.only("p", ["0 0 3", "2 0 1", "9 0 1"], [(0, 2)], "1")
        self.only("p", ["0 0 3", "0 0 3", "9 0 1", "0 0 3"], [(0, 2)], "1 3")
        self.only("p", ["0 0 3", "3 0 1", "9 0 1"], [(0, 1), (0, 2), (1, 2)])
        self.only("c 0.0 0.0 4.0", ["0 0 1", "5 0 1", "9 0 1", "4 0 1"], [(-1, 0), (-1, 3), (0, 3)], "1 2")


class Program(unittest.TestCase):
    HEAD = "# voroproof-truth exists 1\n"
    RIGHT = line_of(f"c 53 interval 1 {POINTS}") + "\n"
    WRONG = line_of(f"c 53 interval -1 {POINTS}") + "\n"

    def run_on(self, text, *arguments, name="exists.txt"):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / name
            with (gzip.open if name.endswith(".gz") else open)(path, "wt") as file:
                file.write(text)
            done = subprocess.run([sys.executable, FOLDER / "oracle.py", *arguments, path],
                                  capture_output=True, text=True)
            return done.returncode, done.stdout.replace(folder + "/", "")

    def test_exit_codes(self):
        text = self.HEAD + self.RIGHT + "# a comment\n" + self.RIGHT
        self.assertEqual(self.run_on(text), (0, "exists: 2 lines, 0 wrong\n"))
        self.assertEqual(self.run_on(text, name="e.txt.gz"), (0, "exists: 2 lines, 0 wrong\n"))
        code, said = self.run_on(text + self.WRONG)
        self.assertEqual((code, said), (1, "exists.txt:5: the sign is 1, not -1\nexists: 3 lines, 1 wrong\n"))
        self.assertEqual(self.run_on(text + self.WRONG + "c 53\n" + self.WRONG)[0], 2)
        self.assertEqual(self.run_on(self.RIGHT)[0], 2)

    def test_shares_and_samples(self):
        text = self.HEAD + (self.RIGHT * 9 + self.WRONG) * 3
        found = [self.run_on(text, "--slice", f"{i}/5") for i in range(1, 6)]
        self.assertEqual([code for code, _ in found], [0, 0, 0, 0, 1])
        self.assertTrue(found[4][1].endswith("exists: 6 lines, 3 wrong\n"))
        first = self.run_on(text, "--sample", "12", "--seed", "3")
        self.assertEqual(first, self.run_on(text, "--sample", "12", "--seed", "3"))
        self.assertIn("exists: 12 lines", first[1])


if __name__ == "__main__":
    unittest.main()
