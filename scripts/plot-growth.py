#!/usr/bin/python3
"""Draws how the time of an event and the memory of a disk grow with the number of disks.

usage: scripts/plot-growth.py FILE.json... -o NAME

The files are those of voroproof_bench_growth. Writes NAME.png and NAME.svg. Needs Debian's
python3-matplotlib.
"""
import argparse
import json
import math
import pathlib

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

# The same bytes each time.
matplotlib.rcParams["svg.hashsalt"] = "voroproof"

COLORS = ["tab:blue", "tab:green", "tab:red", "tab:purple", "tab:orange"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("-o", required=True, dest="name", type=pathlib.Path)
    options = parser.parse_args()

    figure, (time, memory) = pyplot.subplots(1, 2, figsize=(12, 5))
    for color, file in zip(COLORS, options.files):
        series = json.loads(file.read_text())
        points = series["points"]
        n = [p["n"] for p in points]
        label = f"density {series['density']:g}, T = {series['horizon']:g}"
        certified = [p["certified_loop_cpu_us"] for p in points]
        time.plot(n, certified, "o-", color=color, label=label)
        time.plot(n, [p["plain_loop_cpu_us"] for p in points], "o--", color=color, markerfacecolor="white")
        time.plot(n, [certified[0] * math.log(m) / math.log(n[0]) for m in n], ":", color=color)
        large = [p for p in points if p["bytes_a_disk_beyond_20_MB"] > 0]
        memory.plot([p["n"] for p in large], [p["bytes_a_disk_beyond_20_MB"] for p in large], "o-",
                    color=color, label=label)
    time.set_title("an event, without the first diagram\n(dashed: plain doubles; dotted: log n)")
    time.set_ylabel("microseconds of CPU")
    time.set_ylim(bottom=0)
    memory.axhline(600, color="black", linestyle=":")
    memory.set_title("memory beyond 20 MB (dotted: 600 bytes)")
    memory.set_ylabel("bytes a disk")
    memory.set_ylim(bottom=0)
    for axes in (time, memory):
        axes.set_xscale("log")
        axes.set_xlabel("number of disks")
        axes.legend()
    figure.tight_layout()
    for suffix in (".png", ".svg"):
        figure.savefig(options.name.with_suffix(suffix), metadata={"Date": None} if suffix == ".svg" else None)


if __name__ == "__main__":
    main()
