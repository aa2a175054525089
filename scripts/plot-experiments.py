#!/usr/bin/python3
"""Draws counterparts of the paper's Figs. 18 to 22 from files of `voroproof experiment`.

usage: scripts/plot-experiments.py FILE.json... [-o DIRECTORY]

For each file a PNG and an SVG named for its set. Needs Debian's python3-matplotlib.
"""
import argparse
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

# The same bytes each time.
matplotlib.rcParams["svg.hashsalt"] = "voroproof"

STEPS = [("step1_flip_times", "1 flip times", "red"), ("step2_collision_times", "2 collision times", "blue"),
         ("step3_queue", "3 queue", "green"), ("step4_move", "4 moving disks", "goldenrod")]
SERIES = [("flips", "flips", "red"), ("collisions", "collisions", "blue"), ("events", "all", "black")]
# What the horizontal axis is, and the paper's figure.
AXES = {"reference": ("n", "number of disks", 18), "speed": ("speed", "initial speed", 19),
        "size": ("rmax", "greatest radius", 20), "density": ("density", "density", 21),
        "restitution": ("restitution", "restitution", 22)}


def legend_below(axes, entries):
    """Below the axis, where it covers no curve."""
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=entries, frameon=False)


def occurred(member):
    collisions = member["collisions"]["disks"] + member["collisions"]["container"]
    return {"flips": member["flips"], "collisions": collisions, "events": member["flips"] + collisions}


def predicted(member):
    counts = member["predicted"]
    return {**counts, "events": counts["flips"] + counts["collisions"]}


def plot_counts(axes, x, counts, title):
    for key, label, color in SERIES:
        axes.plot(x, [c[key] for c in counts], "o-", color=color, label=label)
    axes.set_ylim(bottom=0)
    axes.set_title(title)
    legend_below(axes, len(SERIES))


def plot_predicted(axes, x, counts):
    axes.plot(x, [c["roots"] for c in counts], "o--", color="red", label="roots")
    plot_counts(axes, x, counts, "events predicted")
    legend_below(axes, len(SERIES) + 1)


def plot_total_time(axes, x, members):
    axes.plot(x, [m["seconds"]["total"] for m in members], "ko-")
    axes.set_ylim(bottom=0)
    axes.set_title("seconds, whole run")


def plot_steps(axes, x, members):
    for key, label, color in STEPS:
        axes.plot(x, [m["seconds"][key] for m in members], "o-", color=color, label=label)
    axes.set_yscale("log")
    axes.set_title("seconds by step")
    legend_below(axes, 2)


def plot_distribution(axes, x, distributions, title):
    axes.errorbar(x, [d["mean"] for d in distributions], [d["standard_deviation"] for d in distributions],
                  fmt="ko-", capsize=3, label="mean, standard deviation")
    quartiles = [d["five_numbers"] for d in distributions]
    axes.fill_between(x, [q[1] for q in quartiles], [q[3] for q in quartiles], alpha=0.2, label="quartiles")
    axes.set_title(title)
    legend_below(axes, 2)


def plot_frequency(axes, members, key, title):
    colors = ["green", "gold", "blue", "red", "black"]
    for member, color in zip(members, colors):
        interval = member["frequency_interval"]
        values = member[key]
        axes.plot([interval * (i + 1) for i in range(len(values))], values, color=color, linewidth=1,
                  label=f"{member['restitution']:g}")
    axes.set_xlabel("time")
    axes.set_ylim(bottom=0)
    axes.set_title(title)
    legend_below(axes, len(members))


def draw(experiment, directory):
    name, members = experiment["set"], experiment["members"]
    field, label, number = AXES[name]
    x = [member[field] for member in members]
    panels = []
    if name in ("reference", "speed"):
        panels.append(lambda axes: plot_total_time(axes, x, members))
    if name == "reference":
        panels.append(lambda axes: plot_steps(axes, x, members))
    if name in ("speed", "size", "density"):
        panels.append(lambda axes: plot_counts(axes, x, [occurred(m) for m in members], "events occurring"))
    if name == "speed" and all("predicted" in m for m in members):
        panels.append(lambda axes: plot_predicted(axes, x, [predicted(m) for m in members]))
    if name in ("size", "density"):
        panels.append(lambda axes: plot_distribution(axes, x, [m["neighbor_distance"] for m in members],
                                                     "distance to first neighbours"))
        panels.append(lambda axes: plot_distribution(axes, x, [m["speed_at_end"] for m in members],
                                                     "speed of the disks"))
    if name == "restitution":
        panels.append(lambda axes: plot_frequency(axes, members, "flip_frequency", "flips per 10 time units"))
        panels.append(lambda axes: plot_frequency(axes, members, "collision_frequency",
                                                  "collisions per 10 time units"))
    figure, all_axes = pyplot.subplots(1, len(panels), figsize=(5.5 * len(panels), 4), squeeze=False)
    for panel, axes in zip(panels, all_axes[0]):
        axes.set_xlabel(label)
        panel(axes)
    figure.suptitle(f"After Fig. {number}: {name}, scale {experiment['scale']:g}, "
                    f"time {members[0]['horizon']:g}")
    figure.tight_layout()
    for extension in ("png", "svg"):
        metadata = {"Date": None} if extension == "svg" else {"Software": None}
        path = directory / f"{name}.{extension}"
        try:
            figure.savefig(path, metadata=metadata, dpi=110)
        except OSError as fault:
            sys.exit(f"plot-experiments: {path}: {fault}")
    pyplot.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=pathlib.Path, metavar="FILE.json", help="of voroproof experiment")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("."), metavar="FOLDER",
                        help="where the pictures go, SET.png and SET.svg for each file (default: here)")
    arguments = parser.parse_args()
    try:
        arguments.output.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        sys.exit(f"plot-experiments: {arguments.output}: {fault}")
    for path in arguments.files:
        try:
            experiment = json.loads(path.read_text())
        except (OSError, ValueError) as fault:
            sys.exit(f"plot-experiments: {path}: {fault}")
        if experiment.get("format") != "voroproof-experiment" or not experiment["members"]:
            sys.exit(f"plot-experiments: {path}: not of voroproof experiment, or empty")
        draw(experiment, arguments.output)


if __name__ == "__main__":
    main()
