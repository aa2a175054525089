"""The common parts of the adversaries of one instant: worlds asked about one by one, verdicts counted, finds kept."""
import argparse
import collections
import subprocess
import sys
import tempfile
from pathlib import Path


def last_line(command):
    run = subprocess.run(command, capture_output=True, text=True)
    lines = run.stdout.strip().splitlines()
    return lines[-1] if lines else f"exit code {run.returncode}: {run.stderr}"


class Questions:
    """About a scene and a history, in these files. A subclass has judge(seed), which makes both and asks."""

    def __init__(self, options, folder):
        self.out = options.out
        self.counts, self.finds = collections.Counter(), 0
        self.scene, self.history = Path(folder, "world.scene.json"), Path(folder, "world.history.jsonl")
        self.simulate = [options.program, "simulate", self.scene, "-o", self.history, "--replace"]
        self.certify = [options.program, "certify", self.scene, self.history]
        self.kernel = [options.kernel, self.scene, self.history] if options.kernel else None

    def ask(self, seed, text, name, command, state, expected):
        """Asks the command, of this name, about the history, which is in that state; expects one of these answers."""
        self.history.write_text(text)
        verdict = last_line(command)
        self.counts[f"{name}, {state}: {verdict}"] += 1
        if verdict not in expected:
            self.find(seed, f"{name} says {verdict} of what is {state}")

    def find(self, seed, what):
        self.finds += 1
        print(f"seed {seed}: {what}", flush=True)
        if self.out:
            self.out.mkdir(parents=True, exist_ok=True)
            for path in self.scene, self.history:
                (self.out / f"{seed}-{self.finds}{path.name[5:]}").write_bytes(path.read_bytes())

    def report(self):
        for key, count in sorted(self.counts.items()):
            print(f"{count:7} {key}")

    def complaint(self, worlds):
        """Why the run says nothing, after so many worlds; None where it does."""
        asked = all(any(f", {state}:" in key for key in self.counts) for state in ("right", "wrong"))
        return None if asked else "nothing was asked"


def main(doc, questions):
    """Asks about as many worlds as the arguments say."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("kernel", nargs="?")
    parser.add_argument("--count", type=int, default=60, help="worlds")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        run = questions(options, folder)
        for seed in range(options.seed, options.seed + options.count):
            run.judge(seed)
    run.report()
    sys.exit(run.complaint(options.count) or (1 if run.finds else 0))
