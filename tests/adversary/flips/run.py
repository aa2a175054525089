#!/usr/bin/env python3
"""Flips of one instant, right and wrong tellings, against `simulate`, `certify` and the kernel.

usage: tests/adversary/flips/run.py PROGRAM [KERNEL] [--count N] [--seed S] [--out FOLDER]

Four to six generators touch one circle at an instant: at the start, at the horizon or between. In
some worlds a disk turns then or less than the tolerance away, in others a second group has its
instant less than the tolerance later (worlds.py). The flips of `simulate` are told in other orders,
on other ways, to other ends, at other times and without orientation (variants.py). A judge that
shares no code with the program says which of these tellings are right (judge.py). The program must
certify the right ones and refute the others; the kernel may leave both undecided. Any other verdict
is a find. So is a history of `simulate` that the judge finds wrong. The exit code is 1 where there
is a find, and --out keeps its files. It is 1, too, where the judge leaves out more than a tenth of
the worlds. The seeds decide everything.
"""
import json
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

from groups import Impossible
from judge import RIGHT, UNCLEAR, WRONG, Judge
from variants import TooLong, Variants, first_diagram, rounded, without_orientations
from worlds import World

sys.path.append(str(Path(__file__).resolve().parent.parent))
import questions  # noqa: E402

MOST_RIGHT = 3  # tellings of a world that are asked about besides that of `simulate`
MOST_WRONG = 3
TRIED = 16      # tellings of which these are chosen
MOST_TRIES = 1000  # scenes made for a world
# Other events keep so far away from the instants, or it is another world.
AWAY = Fraction(1, 10 ** 5)
TRUTHS = ["exact", "recorded"]
EXPECTED = {RIGHT: "s CERTIFIED", WRONG: "s REFUTED"}


class History:
    """The output of `simulate`, parted at the instants: the claims before, at and after them."""

    def __init__(self, text, world):
        lines = [json.loads(line) for line in text.splitlines()]
        self.header, self.last = lines[0], lines[-1]
        claims = [claim(line) for line in lines[1:-1]]
        begin, end = world.instants[0] - AWAY, world.instants[-1] + AWAY
        self.before = [one for one in claims if one["t"] < begin]
        self.told = [one for one in claims if begin <= one["t"] <= end]
        self.after = [one for one in claims if one["t"] > end]

    def is_worth_asking(self):
        """It is complete, and nothing turns before the instants' end but by the maneuver."""
        return "end" in self.last and not any("collide" in one for one in self.before + self.told)

    def diagram(self):
        """Before the instants."""
        diagram = first_diagram(self.header["initial"])
        for one in self.before:
            diagram = diagram.flipped(one["flip"]) if "flip" in one else diagram
        return diagram

    def text(self, first, told):
        """With this telling, and this first diagram where it is not None."""
        header = dict(self.header)
        if first is not None:
            header["initial"] = sorted(first.edges)
        claims = self.before + told + self.after
        kinds = {"flips": "flip", "collisions": "collide", "maneuvers": "maneuver"}
        counts = {key: sum(kind in one for one in claims) for key, kind in kinds.items()}
        lines = [{**one, "t": float(one["t"])} for one in claims]
        last = {"end": {"t": self.last["end"]["t"], **counts}}
        texts = [json.dumps(line, separators=(",", ":")) for line in [header, *lines, last]]
        return "\n".join(texts) + "\n"


def claim(line):
    told = {**line, "t": Fraction(line["t"])}
    return {**told, "flip": tuple(line["flip"])} if "flip" in line else told


def is_of_an_instant(one, judge):
    """It is no flip of another circle nearby: the times of `simulate` are rounded correctly."""
    return "flip" not in one or any(one["t"] == rounded(t) and judge.collapses(one["flip"], t)
                                    for t in judge.world.instants)


class Questions(questions.Questions):
    def __init__(self, options, folder):
        super().__init__(options, folder)
        self.left_out = 0
        self.judges = {"certify": self.certify}
        if self.kernel:
            self.judges["kernel"] = self.kernel

    def judge(self, seed):
        rng = random.Random(seed)
        world, judge, history, diagram = self.a_world(rng)
        own = judge.judge(diagram, history.told)
        if own == UNCLEAR or not all(is_of_an_instant(one, judge) for one in history.told):
            self.left_out += 1
            return
        if own == WRONG:
            self.find(seed, "simulate has what is wrong")
            return
        self.tell(seed, world, history, (None, history.told), RIGHT)
        left = {RIGHT: MOST_RIGHT, WRONG: MOST_WRONG}
        for variant in self.variants(world, judge, diagram, rng):
            state = judge.judge(variant[0] or diagram, variant[1])
            if left.get(state, 0) > 0:
                left[state] -= 1
                self.tell(seed, world, history, variant, state)
        self.tell_without_orientations(seed, world, history, diagram, rng)

    def a_world(self, rng):
        for _ in range(MOST_TRIES):
            try:
                world = World(rng)
            except Impossible:
                continue
            self.scene.write_text(json.dumps(world.scene()))
            self.history.unlink(missing_ok=True)
            subprocess.run(self.simulate, capture_output=True)
            if not self.history.exists():
                continue  # disks overlap at the start, for instance
            history = History(self.history.read_text(), world)
            if not history.is_worth_asking():
                continue
            judge, diagram = Judge(world), history.diagram()
            flips = any("flip" in one for one in history.told)
            collapsed = any(judge.collapsed(diagram, t) for t in world.instants)
            # A few contacts of an even order, too, which flip nothing.
            if flips or collapsed and (world.is_at_start or rng.random() < 0.2):
                return world, judge, history, diagram
        sys.exit("simulate writes no history worth asking about")

    @staticmethod
    def variants(world, judge, diagram, rng):
        try:
            return Variants(world, judge, diagram, rng).some(TRIED)
        except TooLong:
            return []

    def tell(self, seed, world, history, variant, state, options=()):
        text = history.text(*variant)
        for truth in TRUTHS:
            if truth == "exact" or self.is_judged_by_record(world, variant[1], state):
                for judge in self.judges:
                    self.ask_of(judge, seed, text, state, ["--truth", truth, *options])

    @staticmethod
    def is_judged_by_record(world, told, state):
        """The recorded paths are the true ones. Flips at the horizon may be left out of them."""
        if any("maneuver" in one and one["t"] != world.maneuver[0] for one in told):
            return False
        return state == RIGHT or not world.is_at_horizon

    def tell_without_orientations(self, seed, world, history, diagram, rng):
        changed = without_orientations(diagram, history.told, rng)
        if changed is not None:
            self.tell(seed, world, history, (None, changed), RIGHT, ["--unoriented"])
            self.tell(seed, world, history, (None, changed), WRONG)

    def ask_of(self, judge, seed, text, state, options):
        open_too = ["s UNDECIDED"] if judge == "kernel" else []
        self.ask(seed, text, " ".join([judge, *options]), [*self.judges[judge], *options], state,
                 [EXPECTED[state]] + open_too)

    def report(self):
        super().report()
        print(f"{self.left_out:7} worlds left out")

    def complaint(self, worlds):
        if 10 * self.left_out > worlds:
            return "the judge leaves out more than a tenth of the worlds"
        return super().complaint(worlds)


if __name__ == "__main__":
    questions.main(__doc__, Questions)
