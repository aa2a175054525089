#!/usr/bin/python3
"""Runs an experiment of the paper's (section 7) again: what its Figs. 18 to 22 plot.

usage: bench/paper/experiment.py PROGRAM SET -o FILE [--scale X] [--horizon T] [--seed S] [--seeds N] [--members K]
       [--predictions] [--threads N]

SET is reference, speed, size, density or restitution: the figures 18 to 22. --scale, by default 0.1, multiplies the
numbers of disks; each member is run for N seeds from S on, N of them side by side. --predictions counts what the
paper would predict (predictions.py), which takes much longer. Writes all results as JSON, for plot.py. PROGRAM is
voroproof; needs its Python module, too.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
import voroproof as vp
from predictions import predictions

# The options of member k.
SETS = {"reference": lambda k: {"n": 1000 * k}, "speed": lambda k: {"speed": k}, "size": lambda k: {"rmax": k},
        "density": lambda k: {"density": k / 20}, "restitution": lambda k: {"n": 300, "restitution": (k + 5) / 10}}
USUAL = {"n": 1000, "speed": 1, "rmin": 1, "rmax": 10, "density": 0.05, "restitution": 1}
MEMBERS = {name: 5 if name == "restitution" else 10 for name in SETS}
INTERVAL = 10  # in units of time, as in Fig. 22


def distribution(values):
    if len(values) == 0:
        return {"count": 0, "mean": 0, "standard_deviation": 0, "five_numbers": [0] * 5}
    return {"count": len(values), "mean": float(np.mean(values)), "standard_deviation": float(np.std(values)),
            "five_numbers": np.quantile(values, [0, 0.25, 0.5, 0.75, 1]).tolist()}


def neighbor_distances(history, t, positions):
    """The mean gap of each disk to the disks that its cell shares an edge with."""
    pairs = np.unique(np.sort(history.diagram(t).edges[:, :2], axis=1), axis=0)
    i, j = pairs[pairs[:, 0] >= 0].T
    radii = history.scene.radii
    gaps = np.hypot(*(positions[i] - positions[j]).T) - radii[i] - radii[j]
    both, gaps = np.concatenate([i, j]), np.concatenate([gaps, gaps])
    counts = np.bincount(both, minlength=len(radii))
    return np.bincount(both, gaps, minlength=len(radii))[counts > 0] / counts[counts > 0]


def frequencies(history, kind):
    """Events in [10 k, 10 (k + 1)); what happens exactly at the horizon counts in the last interval."""
    horizon = float(history.horizon)
    bins = max(int(np.ceil(horizon / INTERVAL)), 1)
    times = history.events["t"][history.events["kind"] == kind]
    return np.bincount(np.minimum(times // INTERVAL, bins - 1).astype(int), minlength=bins).tolist()


def run(program, k, options, predict):
    """All that is told of a run."""
    scene = vp.Scene.reference(**options)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        scene.write(folder / "scene")
        subprocess.run([program, "simulate", folder / "scene", "-o", folder / "history", "--stats", folder / "stats",
                        "--quiet"], check=False, capture_output=True)
        stats = json.loads((folder / "stats").read_text())
        history = vp.History.read(folder / "history", scene)
    end = stats["t"] if history.ending.complete else float(np.nextafter(stats["t"], 0))
    events, searches, found = stats["events"], stats["searches"], stats["predicted"]
    member = {"k": k, **options, "outcome": stats["outcome"], "t": stats["t"]}
    if "reason" in stats:
        member["reason"] = stats["reason"]
    member["flips"] = events["flips"]["all"]
    member["collisions"] = {side: events["collisions"][side] for side in ("disks", "container")}
    if predict and history.ending.complete:
        member["predicted"] = predictions(scene, history)
    return {**member,
            "searched": {"flips": searches["flips"], "found_flips": found["flips"],
                         "collisions": searches["collisions"], "found_collisions": found["collisions"]},
            "highest_bits": stats["precision"]["highest_bits"],
            "seconds": stats["seconds"],
            "neighbor_distance": distribution(neighbor_distances(history, end, history.positions(end))),
            "speed_at_end": distribution(np.hypot(*history.velocities(end).T)),
            "frequency_interval": INTERVAL,
            "flip_frequency": frequencies(history, vp.FLIP),
            "collision_frequency": frequencies(history, vp.COLLISION)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("set", choices=SETS)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--scale", type=float, default=0.1)
    parser.add_argument("--horizon", type=float, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--members", type=int, default=10)
    parser.add_argument("--predictions", action="store_true")
    parser.add_argument("--threads", type=int, default=1)
    args = parser.parse_args()
    members = []
    with ProcessPoolExecutor(args.threads) as pool:
        for k in range(1, min(MEMBERS[args.set], args.members) + 1):
            for seed in range(args.seed, args.seed + args.seeds):
                options = {**USUAL, **SETS[args.set](k), "seed": seed, "horizon": args.horizon}
                options["n"] = max(1, int(options["n"] * args.scale + 0.5))
                members.append(pool.submit(run, args.program.resolve(), k, options, args.predictions))
    result = {"format": "voroproof-experiment", "version": 1, "producer": f"voroproof {vp.__version__}", "set": args.set,
              "scale": args.scale, "members": [member.result() for member in members]}
    args.output.write_text(json.dumps(result, indent=1) + "\n")
    return 0 if all(member["outcome"] == "complete" for member in result["members"]) else 3


if __name__ == "__main__":
    sys.exit(main())
