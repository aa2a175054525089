"""Disks on a line between two walls, where many touch at one instant, against the exact truth of the certifier.

    beads.py PROGRAM [FIRST_SEED] [SCENES]

All times are fractions, and an engine of its own tells the events in the order of the format. That history must be
certified. Whatever leaves out an event must be refuted; so must one in which other things happen to a disk, as where
the largest of the pairs that touch collides first. Counts on standard output; exit code 1 after a disagreement.
"""

import collections
import hashlib
import json
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

MOST_EVENTS = 60
WORDS = {0: "CERTIFIED", 1: "REFUTED", 3: "UNDECIDED"}


def text(x):
    return f"{x.numerator}/{x.denominator}"


class Beads:
    """A row of disks of radius 1; its walls are at 0 and at `end`."""

    def __init__(self, seed):
        rng = random.Random(f"beads {seed}")
        count = rng.randint(2, 5)
        self.x = [Fraction(1 + rng.choice([0, 1, 2]))]
        while len(self.x) < count:
            self.x.append(self.x[-1] + 2 + rng.choice([0, 0, 1, 2, 2]))
        self.end = self.x[-1] + 1 + rng.choice([0, 1, 2])
        self.v = [Fraction(rng.choice([-1, -1, 0, 1, 1])) for _ in self.x]
        self.m = [Fraction(rng.choice([1, 1, 1, 2, 3])) for _ in self.x]
        self.restitution = rng.choice([Fraction(1), Fraction(1), Fraction(1, 2), Fraction(0)])
        self.horizon = Fraction(rng.choice([2, 3, 4]))
        self.maneuvers = []
        if rng.random() < 0.4:
            self.maneuvers = [(Fraction(rng.choice([0, 1, 2])), rng.randrange(count), Fraction(rng.choice([-1, 0, 1])))]
        self.pairs = [(-2, count - 1), (-1, 0)] + [(i, i + 1) for i in range(count - 1)]

    def scene(self):
        walls = [{"normal": [1, 0], "offset": 0}, {"normal": [-1, 0], "offset": text(-self.end)}]
        disks = [{"center": [text(x), 0], "radius": 1, "velocity": [text(v), 0], "mass": text(m)}
                 for x, v, m in zip(self.x, self.v, self.m)]
        maneuvers = [{"t": text(t), "disk": disk, "velocity": [text(v), 0]} for t, disk, v in self.maneuvers]
        return {"format": "voroproof-scene", "version": 2, "contacts": "bounce", "horizon": text(self.horizon),
                "restitution": text(self.restitution), "frame": {"walls": walls}, "disks": disks,
                "maneuvers": maneuvers}

    def gap(self, pair, x, v):
        """The gap and how fast it grows."""
        i, j = pair
        if i == -1:
            return x[0] - 1, v[0]
        if i == -2:
            return self.end - x[-1] - 1, -v[-1]
        return x[j] - x[i] - 2, v[j] - v[i]

    def run(self, first=min):
        """Events (time, pair or disk, velocity and place of each disk); None if they are too many.

        Among the pairs that touch and approach, `first` chooses."""
        x, v, t, events, left = list(self.x), list(self.v), Fraction(0), [], sorted(self.maneuvers)

        def settle():
            while len(events) < MOST_EVENTS:
                due = [p for p in self.pairs if self.gap(p, x, v)[0] == 0 and self.gap(p, x, v)[1] < 0]
                if not due:
                    return
                i, j = pair = first(due)
                if i < 0:
                    v[j] = -v[j]
                else:
                    q = (1 + self.restitution) * (v[j] - v[i]) / (self.m[i] + self.m[j])
                    v[i], v[j] = v[i] + q * self.m[j], v[j] - q * self.m[i]
                events.append((t, pair, {k: (v[k], x[k]) for k in pair if k >= 0}))

        while True:
            settle()
            while left and left[0][0] == t:
                _, disk, v[disk] = left.pop(0)
                events.append((t, disk, {disk: (v[disk], x[disk])}))
            settle()
            if len(events) >= MOST_EVENTS:
                return None
            gaps = [self.gap(p, x, v) for p in self.pairs]
            times = [t - gap / rate for gap, rate in gaps if rate < 0] + [m[0] for m in left[:1]]
            if not times or min(times) > self.horizon:
                return events
            x = [a + b * (min(times) - t) for a, b in zip(x, v)]
            t = min(times)

    def rows(self, events, sha256):
        rows = [{"format": "voroproof-history", "version": 2, "scene_sha256": sha256, "horizon": text(self.horizon),
                 "producer": "beads"}]
        for t, pair, after in events:
            if isinstance(pair, int):
                rows.append({"t": float(t), "maneuver": pair})
                continue
            told = [[None if k < 0 else [float(after[k][n]), 0] for k in pair] for n in (0, 1)]
            rows.append({"t": float(t), "collide": list(pair), "v": told[0], "p": told[1]})
        maneuvers = sum(isinstance(pair, int) for _, pair, _ in events)
        end = {"t": text(self.horizon), "collisions": len(events) - maneuvers, "maneuvers": maneuvers}
        return rows + [{"end": end}]


def chains(events):
    """By disk: what happens to it, one after the other."""
    chain = collections.defaultdict(list)
    for t, pair, after in events:
        for disk in after:
            chain[disk].append((t, pair))
    return chain


def histories(beads, events):
    """(name, events, the word that is right)."""
    yield "right", events, "CERTIFIED"
    others = [("another order", beads.run(max))]
    for k, (event, following) in enumerate(zip(events, events[1:])):
        if event[0] == following[0]:
            others.append(("exchanged", events[:k] + [following, event] + events[k + 2:]))
    for name, other in others:
        if other is not None:
            yield name, other, "CERTIFIED" if chains(other) == chains(events) else "REFUTED"
    for k in range(len(events)):
        yield "left out", events[:k] + events[k + 1:], "REFUTED"


def main():
    program = sys.argv[1]
    seeds = range(int(sys.argv[2]) if len(sys.argv) > 2 else 0, sys.maxsize)
    scenes = int(sys.argv[3]) if len(sys.argv) > 3 else 40
    counts, disagreements = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, name) for name in ("scene.json", "history.jsonl")]
        for seed in seeds[:scenes]:
            beads = Beads(seed)
            events = beads.run()
            if events is None:
                counts["too many events", ""] += 1
                continue
            raw = json.dumps(beads.scene()).encode()
            with open(paths[0], "wb") as file:
                file.write(raw)
            for name, told, right in histories(beads, events):
                with open(paths[1], "w", encoding="utf-8") as file:
                    rows = beads.rows(told, hashlib.sha256(raw).hexdigest())
                    file.write("".join(json.dumps(row) + "\n" for row in rows))
                run = subprocess.run([program, "certify", *paths, "--quiet"], capture_output=True, text=True,
                                     timeout=300, check=False)
                word = WORDS.get(run.returncode, f"exit {run.returncode}")
                counts[name, word] += 1
                if word != right:
                    print(f"seed {seed}, {name}: the program says {word} ({run.stderr.strip()}), right is {right}")
                    disagreements += 1
    for (name, word), count in sorted(counts.items()):
        print(f"{name:20} {word:16} {count}")
    if disagreements or counts["right", "CERTIFIED"] == 0:
        sys.exit(1)


if __name__ == "__main__":
    main()
