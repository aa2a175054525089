"""Makes the files of a case with the program, and holds them against what the case expects."""
import json
import shutil
import subprocess
import tempfile
from fractions import Fraction
from pathlib import Path

from degenerate.history import History
from degenerate.picture import compact
from degenerate.scene import Generated, instant_text

PICTURE_SIZE = 480


class Failed(Exception):
    """A case is not as its description says."""


class Program:
    """The program, which may take `patience` seconds for each step."""

    def __init__(self, path, patience):
        self.path = str(Path(path).resolve())
        self.patience = patience

    def run(self, *words, codes=(0,)):
        try:
            done = subprocess.run([self.path, *map(str, words)], capture_output=True, text=True,
                                  timeout=self.patience, check=False)
        except subprocess.TimeoutExpired:
            raise Failed(f"{words[0]}: more than {self.patience} seconds") from None
        if done.returncode not in codes:
            said = (done.stdout + done.stderr).strip().replace("\n", " | ")
            raise Failed(f"{words[0]}: exit {done.returncode}: {said}")
        return done


class Simulator:
    """The program's history of a scene that is not quite the case's."""

    def __init__(self, program, scene):
        self.program, self.scene = program, scene

    def __call__(self, scene):
        with tempfile.TemporaryDirectory() as folder:
            path, out = Path(folder, "a.scene.json"), Path(folder, "a.history.jsonl")
            path.write_text(scene.text("", ""))
            self.program.run("simulate", path, "-o", out, "--quiet")
            return History.read(out.read_text())


def verdict_of(program, scene, history, truth, report):
    """The last word of `certify`, and its report."""
    report.unlink(missing_ok=True)
    done = program.run("certify", scene, history, "--truth", truth, "--report", report, "--quiet",
                       codes=(0, 1, 3))
    return done.stdout.split()[-1].lower(), json.loads(report.read_text())


def flip_kinds(stats):
    """The kinds of flips that happened, with their numbers."""
    return {kind: count for kind, count in stats["events"]["flips"].items()
            if count and kind != "all"}


# As in tests/corpus/truth_test.cpp: from 33 disks on brute force takes seconds a diagram.
MANY_DISKS, FEW_MIDPOINTS = 32, 4


def midpoints(history, disks):
    """At how many midpoints between events the brute force looks: those of stretches of more than
    1e-9, and of these, with many disks, a few spread evenly."""
    if disks < 2:
        return 0
    end = history.last["end"]["t"] if "end" in history.last else history.last["stopped"]["t"]
    times = sorted({0.0, *(e["t"] for e in history.events)}) + [float(Fraction(end))]
    stretches = [b - a for a, b in zip(times, times[1:])]
    step = max(1, len(stretches) // FEW_MIDPOINTS) if disks > MANY_DISKS else 1
    return sum(length > 1e-9 for length in stretches[step // 2::step])


def build(case, program, root):
    """Writes root/FAMILY/NAME anew. Gives what was left out of it; throws Failed where
    anything is not as expected."""
    folder = root / case.family / case.name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    scene, exact = folder / "scene.scene.json", folder / "exact.history.jsonl"
    report = folder / "report.json"
    if isinstance(case.scene, Generated):
        program.run("generate", *case.scene.words, "-o", scene)
    else:
        scene.write_text(case.scene.text(f"{case.family}/{case.name}", ""))
    program.run("simulate", scene, "-o", exact, "--quiet", "--stats", report,
                codes=(3,) if case.verdict == "undecided" else (0,))
    history = History.read(exact.read_text())
    happened = [len(history.indices(kind)) for kind in ("flip", "collide", "maneuver")]
    if case.events is not None and list(case.events) != happened:
        raise Failed(f"{happened} flips, collisions and maneuvers, not {list(case.events)}")
    kinds = flip_kinds(json.loads(report.read_text()))
    if case.flips is not None and case.flips != kinds:
        raise Failed(f"flips are {kinds}")

    record = []
    for truth in case.truths:
        verdict, found = verdict_of(program, scene, exact, truth, report)
        if verdict != case.verdict:
            what = found.get("divergence") or found["reason"]
            raise Failed(f"certify --truth {truth} says {verdict}: {what}")
        claims = found["proved"]
        prefix = found["certified_prefix"]
        record.append(f"voroproof simulate, then certify --truth {truth}: {verdict}; "
                      + (f"{claims['flips']} flips, {claims['collisions']} collisions, "
                         f"{claims['maneuvers']} maneuvers proved" if verdict == "certified" else
                         f"certified prefix {prefix['events']} events"))

    for k, t in enumerate(case.instants):
        diagram = folder / f"diagram-{k}.diagram.json"
        program.run("snapshot", scene, "--at", f"{t.numerator}/{t.denominator}", "-o", diagram)
    if case.instants:
        picture = folder / "picture.svg"
        program.run("render", folder / f"diagram-{case.picture}.diagram.json", "-o", picture,
                    "--size", PICTURE_SIZE)
        picture.write_text(compact(picture.read_text()))
    seen = midpoints(history, len(json.loads(scene.read_text())["disks"])) - case.unseen
    record.append(f"tests/corpus/truth_test.cpp: motion replayed in 300 digits or more; brute force "
                  f"agrees at {seen} midpoints and {len(case.instants)} instants")

    wrong, left_out = [], []
    for w in case.wrong:
        path = folder / "wrong" / f"{w.name}.history.jsonl"
        path.parent.mkdir(exist_ok=True)
        if path.exists():
            raise Failed(f"{w.name}: twice")
        try:
            text = w.make(history, Simulator(program, case.scene)).text()
        except (IndexError, ValueError, StopIteration) as e:
            raise Failed(f"{w.name}: cannot be made: {e}") from e
        if text == exact.read_text():
            raise Failed(f"{w.name}: that is the exact history")
        path.write_text(text)
        verdict, found = verdict_of(program, scene, path, w.truth, report)
        kind = (found.get("divergence") or {}).get("kind")
        if verdict != "refuted" and w.awaits:
            path.unlink()
            left_out.append(f"{case.family}/{case.name}: {w.name}: {w.awaits}")
            continue
        if verdict != "refuted" or kind != w.kind:
            raise Failed(f"{w.name}: expected {w.kind}, certify says {verdict}: {kind or found['reason']}")
        wrong.append({"file": f"wrong/{path.name}", "class": w.name, "kind": w.kind,
                      "truth": w.truth})
    report.unlink(missing_ok=True)
    instants = "[" + ",".join(instant_text(t) for t in case.instants) + "]"
    head = {"format": "voroproof-case", "version": 1, "name": case.name, "family": case.family,
            "tags": case.tags, "story": case.story, "verdict": case.verdict,
            "instants": json.loads(instants), "truth": record, "wrong": wrong}
    (folder / "case.json").write_text(json.dumps(head, indent=1, ensure_ascii=False) + "\n")
    return left_out
