#!/usr/bin/python3
"""Draws a counterpart of the paper's Fig. 26 from a report of `voroproof plan`.

usage: scripts/plot-plan.py [--times T,T...] [--near T] REPORT.json FILE

A panel for each time: the vehicles where the plan has them. A pair is in a red ellipse where the
plan avoids a conjunction that was predicted for it within --near of that time: red is the one
whose speeds are changed for it, green the other one. Needs Debian's python3-matplotlib.
"""
import argparse
import json
import math
import pathlib
import sys
from fractions import Fraction

import matplotlib

matplotlib.use("Agg")
from matplotlib import patches, pyplot  # noqa: E402

# The same bytes each time.
matplotlib.rcParams["svg.hashsalt"] = "voroproof"

COLUMNS = 3
CHANGED, KEPT, OTHER = "#d62728", "#2ca02c", "#bcd3ee"


def numbers(values):
    """Numbers of a report are JSON numbers or, where no double is exact, text such as "1/3"."""
    return [Fraction(value) for value in values]


def place(way, t):
    """Where a vehicle is; its knots are [time, x, y], linear in between."""
    knots = [numbers(knot) for knot in way]
    for (t0, x0, y0), (t1, x1, y1) in zip(knots, knots[1:]):
        if t <= t1:
            part = (t - t0) / (t1 - t0)
            return float(x0 + part * (x1 - x0)), float(y0 + part * (y1 - y0))
    return tuple(map(float, knots[-1][1:]))


def ellipse_around(p, q, margin):
    distance = math.dist(p, q)
    angle = math.degrees(math.atan2(q[1] - p[1], q[0] - p[0]))
    return patches.Ellipse(((p[0] + q[0]) / 2, (p[1] + q[1]) / 2), distance + 2 * margin, 2 * margin, angle=angle,
                           fill=False, edgecolor=CHANGED, linewidth=1.2, zorder=4)


def limits(report):
    """The limits of all panels: the starts, the goals and what is between, with room for ellipses."""
    room = 3 * max(float(Fraction(v["radius"])) for v in report["vehicles"])
    ends = [end for v in report["vehicles"] for end in (numbers(v["start"]), numbers(v["goal"]))]
    return [(float(min(values)) - room, float(max(values)) + room) for values in zip(*ends)]


def draw_moment(axes, report, t, near):
    vehicles = {v["id"]: v for v in report["vehicles"]}
    radii = {i: float(Fraction(v["radius"])) for i, v in vehicles.items()}
    places = {i: place(v["way"], t) for i, v in vehicles.items()}
    avoided = [a for a in report["avoided"] if abs(Fraction(a["t"]) - t) <= near]
    changed = {a["changed"] for a in avoided}
    paired = {i for a in avoided for i in a["pair"]}
    for i, v in vehicles.items():
        axes.plot(*zip(numbers(v["start"]), numbers(v["goal"])), ":", color="#9aa4b5", linewidth=0.5, zorder=1)
        color = CHANGED if i in changed else KEPT if i in paired else OTHER
        axes.add_patch(patches.Circle(places[i], radii[i], facecolor=color, edgecolor="#30384a", linewidth=0.6,
                                      zorder=3))
    for a in avoided:
        p, q = (places[i] for i in a["pair"])
        axes.add_patch(ellipse_around(p, q, 2 * max(radii[i] for i in a["pair"])))
    axes.set_title(f"t = {float(t):g}", fontsize=9)
    width, height = limits(report)
    axes.set(xlim=width, ylim=height)
    axes.set_aspect("equal")
    axes.set_axis_off()


def times_of(text):
    return [Fraction(t) for t in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", type=pathlib.Path, metavar="REPORT.json", help="of voroproof plan --report")
    parser.add_argument("picture", type=pathlib.Path, metavar="FILE", help="to write; ends in .png or .svg")
    parser.add_argument("--times", type=times_of, metavar="T,T...",
                        help="of the panels; otherwise six, evenly over the flight")
    parser.add_argument("--near", type=Fraction, default=Fraction(1), metavar="T",
                        help="how long before and after its time a conjunction is shown (default 1)")
    arguments = parser.parse_args()
    try:
        report = json.loads(arguments.report.read_text())
    except (OSError, ValueError) as fault:
        sys.exit(f"plot-plan: {arguments.report}: {fault}")
    if report.get("format") != "voroproof-plan-report" or not report["found"] or not report["vehicles"]:
        sys.exit(f"plot-plan: {arguments.report}: not of voroproof plan, or without a plan")
    times = arguments.times or [Fraction(report["arrive"]) * i / 5 for i in range(6)]
    rows = -(-len(times) // COLUMNS)
    (left, right), (low, high) = limits(report)
    height = min(4.4, 4.4 * (high - low) / max(right - left, 1e-9)) + 0.3
    figure, all_axes = pyplot.subplots(rows, COLUMNS, figsize=(4.4 * COLUMNS, height * rows), squeeze=False)
    for axes in all_axes.flat[len(times):]:
        axes.set_axis_off()
    for axes, t in zip(all_axes.flat, times):
        draw_moment(axes, report, t, arguments.near)
    figure.tight_layout()
    metadata = {"Date": None} if arguments.picture.suffix == ".svg" else {"Software": None}
    try:
        figure.savefig(arguments.picture, metadata=metadata, dpi=100)
    except (OSError, ValueError) as fault:
        sys.exit(f"plot-plan: {arguments.picture}: {fault}")


if __name__ == "__main__":
    main()
