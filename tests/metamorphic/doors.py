"""Asks one question through every door of the program: what it says of a history may not depend on the way in.

usage: doors.py PROGRAM WRITE_WORLDS [--count N] [--seed S] [--out DIRECTORY]

The histories are those of write_worlds (tests/adversary), right and wrong ones. The doors are the program on plain
files, on compressed ones, on standard input, with two threads, with the kernel, in shards with and without an index,
after an interruption, and the Python module. The engine writes each scene's history with two threads, compressed and
resumed, too; its events are those of the certified prefix, under the exact truth. Exit code 1 where two doors differ;
the files are then kept in DIRECTORY.
"""
import argparse
import collections
import fractions
import gzip
import hashlib
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import voroproof

SHARDS = 3


class Doors:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, *arguments, stdin=None):
        done = subprocess.run([self.program, *map(str, arguments), "--quiet"], stdin=stdin, capture_output=True)
        return done.returncode, done.stderr.decode()

    def report(self, scene, history, truth, *options, stdin=None):
        """The content of the report; the error where there is none."""
        path = self.folder / "report.json"
        path.unlink(missing_ok=True)
        code, error = self.run("certify", scene, history, "--truth", truth, "--report", path, *options, stdin=stdin)
        return self.said(path) if path.exists() else {"code": code, "error": error.split(": ")[-1]}

    @staticmethod
    def said(path):
        report = json.loads(path.read_text())
        return {key: report.get(key) for key in ("verdict", "words", "reason", "certified_prefix", "divergence",
                                                 "history_sha256", "leniency")}

    def compressed(self, scene, history, truth):
        packed = self.folder / "packed.jsonl.gz"
        packed.write_bytes(gzip.compress(history.read_bytes()))
        answer = self.report(scene, packed, truth)
        return {**answer, "history_sha256": sha256(history)} if "history_sha256" in answer else answer

    def standard_input(self, scene, history, truth):
        with open(history, "rb") as stream:
            answer = self.report(scene, "-", truth, stdin=stream)
        # There is no hash of a stream that was not read to its end.
        if answer.get("verdict") != "CERTIFIED" and "history_sha256" in answer:
            answer["history_sha256"] = answer["history_sha256"] or sha256(history)
        return answer

    def shards(self, scene, history, truth, *options):
        """The verdict that the shards together come to."""
        parts = [self.folder / f"part{k}.json" for k in range(1, SHARDS + 1)]
        for k, part in enumerate(parts, 1):
            part.unlink(missing_ok=True)
            self.run("certify", scene, history, "--truth", truth, "--part", f"{k}/{SHARDS}", "--report", part, *options)
        whole = self.folder / "whole.json"
        whole.unlink(missing_ok=True)
        code, error = self.run("certify", "--merge", *parts, "--report", whole)
        return self.said(whole)["verdict"] if whole.exists() else error or code

    def indexed(self, scene, history, truth):
        index = self.folder / "index"
        index.unlink(missing_ok=True)
        code, error = self.run("index", scene, history, "-o", index)
        return self.shards(scene, history, truth, "--index", index) if code == 0 else error

    def python(self, scene, history, truth):
        try:
            report = voroproof.certify_files(scene, history, truth=truth)
        except voroproof.InputError:
            return "invalid"
        return report.verdict.upper(), report.prefix_events, report.prefix_t

    def simulated(self, scene, *options, name="own.jsonl"):
        own = self.folder / name
        own.unlink(missing_ok=True)
        code, error = self.run("simulate", scene, "-o", own, *options)
        if not own.exists():
            return code, error
        content = own.read_bytes()
        return code, gzip.decompress(content) if name.endswith(".gz") else content

    def resumed(self, scene):
        """A history of which the second half was lost."""
        own = self.folder / "resumed.jsonl"
        lines = self.simulated(scene, name=own.name)[1].splitlines(keepends=True)
        own.write_bytes(b"".join(lines[: len(lines) // 2 + 1]))
        code, _ = self.run("simulate", scene, "-o", own, "--resume")
        return code, own.read_bytes()


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def happenings(lines):
    """The times of what happens, by its kind and generators."""
    times = collections.defaultdict(list)
    for line in lines:
        event = json.loads(line)
        if "flip" in event:
            what = "flip", *sorted(event["flip"][:2]), *sorted(event["flip"][2:])
        elif "collide" in event:
            what = "collide", *event["collide"]
        elif "maneuver" in event:
            what = "maneuver", event["maneuver"]
        else:
            continue
        t = event["t"]
        times[what].append(float(t) if not isinstance(t, str) else float.fromhex(t) if "x" in t else
                           float(fractions.Fraction(t)))
    return times


def beyond_prefix(prefix, claimed, own):
    """Events that are missing before the end of the certified prefix, and wrong ones in it."""
    tolerance = 1.0001e-6
    claims, truth = happenings(claimed), happenings(own)
    first = happenings(claimed[: prefix["events"]])
    missing = [(what, t) for what, times in truth.items() for t in times
               if t < prefix["t"] and all(abs(t - c) > tolerance for c in claims[what])]
    wrong = [(what, t) for what, times in first.items() for t in times
             if all(abs(t - c) > tolerance for c in truth[what])]
    return missing + wrong


def differences(doors, scene, history, counts):
    """The doors at which something else is said, with both answers."""
    def compare(door, ours, theirs):
        counts[door] += 1
        if ours != theirs:
            yield door, ours, theirs

    prefixes = {}
    for truth in ("exact", "recorded"):
        plain = doors.report(scene, history, truth)
        verdict = plain.get("verdict", "invalid")
        yield from compare("standard input", plain, doors.standard_input(scene, history, truth))
        yield from compare("compressed", plain, doors.compressed(scene, history, truth))
        yield from compare("two threads", plain, doors.report(scene, history, truth, "--threads", "2"))
        prefix = prefixes[truth] = plain.get("certified_prefix", {})
        yield from compare("Python", (verdict, prefix.get("events"), prefix.get("t")) if prefix else "invalid",
                           doors.python(scene, history, truth))
        both = doors.report(scene, history, truth, "--kernel").get("verdict", "invalid")
        counts["kernel"] += 1
        if both != verdict and (both, verdict) not in {("UNDECIDED", "CERTIFIED"), ("REFUTED", "UNDECIDED")}:
            yield "kernel", verdict, both
        if truth == "recorded":
            yield from compare("shards", verdict, doors.shards(scene, history, truth))
            yield from compare("shards with an index", verdict, doors.indexed(scene, history, truth))
    own = doors.simulated(scene)
    yield from compare("simulate, two threads", own, doors.simulated(scene, "--threads", "2"))
    yield from compare("simulate, compressed", own, doors.simulated(scene, name="own.jsonl.gz"))
    if own[0] == 0:
        claimed = history.read_text().splitlines()[1:]
        if prefixes["exact"]:
            yield from compare("certified prefix", [], beyond_prefix(prefixes["exact"], claimed, own[1].splitlines()[1:]))
        yield from compare("simulate, resumed", own, doors.resumed(scene))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("write_worlds")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=pathlib.Path)
    asked = parser.parse_args()
    counts, found = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        worlds = folder / "worlds"
        subprocess.run([asked.write_worlds, worlds, str(asked.count), str(asked.seed)], check=True)
        doors = Doors(asked.program, folder)
        for scene in sorted(worlds.glob("*.scene.json")):
            history = scene.with_name(scene.name.replace(".scene.json", ".history.jsonl"))
            for door, ours, theirs in differences(doors, scene, history, counts):
                found += 1
                print(f"{scene.name}: {door}\n  {ours}\n  {theirs}")
                if asked.out:
                    asked.out.mkdir(parents=True, exist_ok=True)
                    for file in (scene, history):
                        shutil.copy(file, asked.out)
    for door, count in sorted(counts.items()):
        print(f"{count:8} {door}")
    print(f"{sum(counts.values())} pairs, {found} differences")
    return 1 if found or not counts else 0


if __name__ == "__main__":
    sys.exit(main())
