#!/usr/bin/python3
"""Draws counterparts of the paper's Figs. 18 to 22 from files of experiment.py.

usage: bench/paper/plot.py FILE.json... [-o DIRECTORY]

For each file a PNG and an SVG named for its set. Where an experiment has several seeds, points are their means and
bars, or bands, their standard deviations. Needs Debian's python3-matplotlib.
"""
import argparse
import itertools
import json
import pathlib
import statistics

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

# The same bytes each time.
matplotlib.rcParams["svg.hashsalt"] = "voroproof"

STEPS = [("step1_flip_times", "1 flip times", "red"), ("step2_collision_times", "2 collision times", "blue"),
         ("step3_queue", "3 queue", "green"), ("step4_move", "4 moving disks", "goldenrod")]
SERIES = [("flips", "flips", "red"), ("collisions", "collisions", "blue"), ("events", "all", "black")]
# The horizontal axis, and the paper's figure.
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


def over_seeds(groups, value):
    """Means and standard deviations of value(member) in each group of members that differ in the seed."""
    values = [[value(member) for member in group] for group in groups]
    return ([statistics.fmean(v) for v in values], [statistics.pstdev(v) for v in values])


def plot_means(axes, x, groups, value, style, **more):
    means, deviations = over_seeds(groups, value)
    bars = deviations if any(len(group) > 1 for group in groups) else None
    axes.errorbar(x, means, bars, fmt=style, capsize=3, **more)


def plot_counts(axes, x, groups, counts, title):
    for key, label, color in SERIES:
        plot_means(axes, x, groups, lambda m: counts(m)[key], "o-", color=color, label=label)
    axes.set_ylim(bottom=0)
    axes.set_title(title)
    legend_below(axes, len(SERIES))


def plot_predicted(axes, x, groups):
    plot_means(axes, x, groups, lambda m: predicted(m)["roots"], "o--", color="red", label="roots")
    plot_counts(axes, x, groups, predicted, "events predicted")
    legend_below(axes, len(SERIES) + 1)


def plot_total_time(axes, x, groups):
    plot_means(axes, x, groups, lambda m: m["seconds"]["total"], "ko-")
    axes.set_ylim(bottom=0)
    axes.set_title("seconds, whole run")


def plot_steps(axes, x, groups):
    for key, label, color in STEPS:
        plot_means(axes, x, groups, lambda m: m["seconds"][key], "o-", color=color, label=label)
    axes.set_yscale("log")
    axes.set_title("seconds by step")
    legend_below(axes, 2)


def plot_distribution(axes, x, groups, field, title):
    """Plots a distribution over the disks of a scene; several seeds give the means of their statistics."""
    def mean(of):
        return over_seeds(groups, lambda m: of(m[field]))[0]

    axes.errorbar(x, mean(lambda d: d["mean"]), mean(lambda d: d["standard_deviation"]), fmt="ko-", capsize=3,
                  label="mean, standard deviation")
    axes.fill_between(x, mean(lambda d: d["five_numbers"][1]), mean(lambda d: d["five_numbers"][3]), alpha=0.2,
                      label="quartiles")
    axes.set_title(title)
    legend_below(axes, 2)


def plot_frequency(axes, groups, key, title):
    colors = ["green", "gold", "blue", "red", "black"]
    for group, color in zip(groups, colors):
        interval, bins = group[0]["frequency_interval"], len(group[0][key])
        times = [interval * (i + 1) for i in range(bins)]
        of_bins = [[member[key][i] for member in group] for i in range(bins)]
        means = [statistics.fmean(v) for v in of_bins]
        axes.plot(times, means, color=color, linewidth=1, label=f"{group[0]['restitution']:g}")
        if len(group) > 1:
            spread = [statistics.pstdev(v) for v in of_bins]
            axes.fill_between(times, [m - s for m, s in zip(means, spread)], [m + s for m, s in zip(means, spread)],
                              color=color, alpha=0.15, linewidth=0)
    axes.set_xlabel("time")
    axes.set_ylim(bottom=0)
    axes.set_title(title)
    legend_below(axes, len(groups))


def draw(experiment, directory):
    name, members = experiment["set"], experiment["members"]
    field, label, number = AXES[name]
    groups = [list(group) for _, group in itertools.groupby(members, lambda member: member["k"])]
    seeds = max(len(group) for group in groups)
    x = [group[0][field] for group in groups]
    panels = []
    if name in ("reference", "speed"):
        panels.append(lambda axes: plot_total_time(axes, x, groups))
    if name == "reference":
        panels.append(lambda axes: plot_steps(axes, x, groups))
    if name in ("speed", "size", "density"):
        panels.append(lambda axes: plot_counts(axes, x, groups, occurred, "events occurring"))
    if name == "speed" and all("predicted" in m for m in members):
        panels.append(lambda axes: plot_predicted(axes, x, groups))
    if name in ("size", "density"):
        panels.append(lambda axes: plot_distribution(axes, x, groups, "neighbor_distance",
                                                     "distance to first neighbours"))
        panels.append(lambda axes: plot_distribution(axes, x, groups, "speed_at_end", "speed of the disks"))
    if name == "restitution":
        panels.append(lambda axes: plot_frequency(axes, groups, "flip_frequency", "flips per 10 time units"))
        panels.append(lambda axes: plot_frequency(axes, groups, "collision_frequency",
                                                  "collisions per 10 time units"))
    figure, all_axes = pyplot.subplots(1, len(panels), figsize=(5.5 * len(panels), 4), squeeze=False)
    for panel, axes in zip(panels, all_axes[0]):
        axes.set_xlabel(label)
        panel(axes)
    figure.suptitle(f"After Fig. {number}: {name}, scale {experiment['scale']:g}, "
                    f"time {members[0]['horizon']:g}" + (f", {seeds} seeds" if seeds > 1 else ""))
    figure.tight_layout()
    for extension in ("png", "svg"):
        metadata = {"Date": None} if extension == "svg" else {"Software": None}
        path = directory / f"{name}.{extension}"
        figure.savefig(path, metadata=metadata, dpi=110)
    pyplot.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=pathlib.Path, metavar="FILE.json", help="of experiment.py")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("."), metavar="FOLDER",
                        help="where the pictures go, SET.png and SET.svg for each file (default: here)")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    for path in arguments.files:
        draw(json.loads(path.read_text()), arguments.output)


if __name__ == "__main__":
    main()
