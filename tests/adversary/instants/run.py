#!/usr/bin/env python3
"""Orders of one instant, right and wrong, against `simulate`, `certify`, `certify --events collisions` and the kernel.

usage: tests/adversary/instants/run.py PROGRAM [KERNEL] [--count N] [--seed S] [--out FOLDER]

Disks touch at one instant: at the start, at the horizon or between; in some worlds others touch far away, less than
the tolerance later. Some are scheduled for maneuvers then. Every order in which pairs that approach collide and
maneuvers come leads to a consistent history (worlds.py). Of all these orders one is the format's (docs/formats.md,
section 6). A history is right under the exact truth if the same happens in it to each disk, one after the other, as
in that order. Under --order any it is right if each collision is of two that approach then, each maneuver comes
once, and nobody approaches at the end: orders are spoiled for that. Any other verdict is a find, and any other order
of `simulate`. So is a refutation of a history that stops between two turns and is right so far. Where turns that are
not told would have decided, a history that is wrong so far may be left undecided. The exit code is 1 where there is
a find, and --out keeps its files. The seeds decide everything.
"""
import json
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

from worlds import DiagonalRow, Impossible, World

sys.path.append(str(Path(__file__).resolve().parent.parent))
import questions  # noqa: E402

MOST_ORDERS = 12  # orders of a world that are asked about besides the right one


def history_text(header, lines, world, complete):
    collisions = sum("collide" in line for line in lines)
    counts = {"flips": 0, "collisions": collisions, "maneuvers": len(lines) - collisions}
    last = {"end": {"t": float(world.horizon), **counts}} if complete else {
        "stopped": {"t": float(world.t), "reason": "of a test", "events": []}}
    return "\n".join([header] + [json.dumps(line, separators=(",", ":")) for line in lines + [last]]) + "\n"


def a_world(rng):
    is_diagonal, when = rng.random() < 0.1, rng.choice([(0, Fraction(1, 4)), (0, 0), (1, Fraction(5, 4)), (1, 1)])
    while True:
        try:
            world = DiagonalRow(rng) if is_diagonal else World(rng, *when)
            if world.is_worth_asking():
                return world
        except Impossible:
            pass


class Questions(questions.Questions):
    def __init__(self, options, folder):
        super().__init__(options, folder)
        certify = self.certify + ["--truth", "exact"]
        self.judges = {"certify": certify, "certify --events collisions": certify + ["--events", "collisions"]}
        self.any_order = self.judges["certify --events collisions"] + ["--order", "any"]
        if self.kernel:
            self.judges["kernel"] = self.kernel + ["--truth", "exact"]

    def judge(self, seed):
        rng = random.Random(seed)
        world = a_world(rng)
        self.scene.write_text(json.dumps(world.scene()))
        subprocess.run(self.simulate, check=True, capture_output=True)
        own = self.history.read_text().splitlines()
        # Flips depend on the velocities: those of another order are others.
        judges = self.judges
        if any('"flip"' in line for line in own):
            judges = {"certify --events collisions": judges["certify --events collisions"]}
        right = world.right_order()
        happens = world.by_disk(right)
        engine = [tuple(line["collide"]) if "collide" in line else line["maneuver"]
                  for line in map(json.loads, own[1:-1]) if "flip" not in line]
        if world.by_disk(engine) != happens or (engine != right and not world.late):
            self.find(seed, f"simulate has the turns {engine}, not {right}")
        for turns in [right] + world.orders(MOST_ORDERS, rng):
            lines = world.lines(turns, rng)
            is_right = world.by_disk(turns) == happens
            text = history_text(own[0], lines, world, True)
            for judge in judges:
                expected = ["s CERTIFIED"] if is_right else ["s REFUTED"]
                # The kernel leaves open what takes irrational numbers, and turns of neighbours that are exchanged.
                is_open = judge == "kernel" and (isinstance(world, DiagonalRow) or world.late)
                open_too = ["s UNDECIDED"] if is_open else []
                self.ask(seed, text, judge, judges[judge], "right" if is_right else "wrong", expected + open_too)
            for some in [turns, world.spoiled(turns, rng)]:
                if world.is_quiet_after(some):
                    text = history_text(own[0], world.lines(some, rng), world, True)
                    state, verdict = ("right", "s CERTIFIED") if world.may_happen(some) else ("wrong", "s REFUTED")
                    self.ask(seed, text, "certify --order any", self.any_order, state, [verdict])
            if isinstance(world, DiagonalRow) or world.late:
                continue  # no double says that it stops at that time, or there are two
            so_far = rng.randint(0, len(turns))
            is_right = all(some == then[:len(some)] for some, then in zip(world.by_disk(turns[:so_far]), happens))
            for judge in list(judges)[:1]:
                told = [{**line, "t": float(world.t)} for line in lines[:so_far]]
                self.ask(seed, history_text(own[0], told, world, False), judge, judges[judge],
                         "right so far" if is_right else "wrong so far",
                         ["s UNDECIDED"] if is_right else ["s REFUTED", "s UNDECIDED"])


if __name__ == "__main__":
    questions.main(__doc__, Questions)
