#!/usr/bin/env python3
"""That all JSON which the program writes, and all of corpus/, is of the schemas.

Fields that a schema does not describe are errors here, though readers are to pass over new fields of
reports: so no field is without a description. Each format must be written at least once, and each that the
sources name has a schema.

usage: written.py PROGRAM EXAMPLE      (build/voroproof, build/plain-double)
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    from schemas import NAMES, Files
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORPUS = ROOT / "corpus"
ROOMS = ["apps", "certify", "history", "library", "planning"]

# Two starts too near each other, and two that nobody separates: reports without a plan.
BETWEEN_WALLS = {"format": "voroproof-scene", "version": 2, "contacts": "bounce", "horizon": 3, "gravity": [0, -1],
                 "frame": {"periodic": [9, None], "walls": [{"normal": [0, 1], "offset": 0, "speed": "1/8"}]},
                 "disks": [{"center": [1, 4], "radius": 1, "velocity": [-2, 0], "growth": "1/7"},
                           {"center": [6, 4], "radius": 1, "velocity": [0, 0]}]}
CROWDED = {"format": "voroproof-plan", "version": 1, "container": {"center": [0, 0], "radius": 50},
           "arrive": 10, "vehicles": [{"id": 0, "radius": 1, "start": [0, 0], "goal": [10, 0]},
                                      {"id": 1, "radius": 1, "start": [1, 0], "goal": [0, 10]}]}

QUERIES = ["nearest --at 5 --point 1 -2", "neighbours --at 5 --disk 1", "closest --at 5", "offset --at 5 --probe 1",
           "voids --at 5 --probe 1", "critical --at 5"]
QUERIES_OVER = ["neighbours-over --disk 1", "gap-over --pair 0 1", "closest-over", "tunnel --pair 0 1 --probe 1",
                "void --vertex -1 0 1 --probe 1/8", "voids-over --probe 1"]


def run(folder, program, *arguments):
    """Runs the program; any exit code that a verdict has is right."""
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True)
    assert done.returncode in (0, 1, 3), f"{arguments}: {done.returncode}: {done.stderr}"


def write_indexes(folder, go):
    """Writes an index of paths in binary64, and one of paths in fractions."""
    go("generate reference --n 12 --seed 3 --horizon 1500 -o i.scene.json")
    scene = json.loads((folder / "i.scene.json").read_text())
    scene["disks"][0]["center"] = [str(x) for x in scene["disks"][0]["center"]]
    (folder / "j.scene.json").write_text(json.dumps(scene))
    for name in "ij":
        go(f"simulate {name}.scene.json -o {name}.history.jsonl --quiet")
        go(f"index {name}.scene.json {name}.history.jsonl -o {name}.index.jsonl")


def write_some(folder, program, example):
    """One file of each kind, and more of those that have several forms."""
    go = lambda line, *more: run(folder, program, *line.split(), *more)
    go("generate reference --n 12 --seed 3 --horizon 20 -o a.scene.json")
    go("simulate a.scene.json -o a.history.jsonl --stats a.stats.json")
    go("simulate a.scene.json -o b.history.jsonl --stats b.stats.json --max-events 5")
    go("certify a.scene.json a.history.jsonl --report a.report.json --kernel --least-tolerances")
    go("certify a.scene.json b.history.jsonl --truth recorded --report b.report.json")
    go("certify a.scene.json a.history.jsonl --truth recorded --part 1/2 --report a.shard.json")
    go("certify a.scene.json b.history.jsonl --truth recorded --part 2/2 --report b.shard.json")
    write_indexes(folder, go)
    go("snapshot a.scene.json a.history.jsonl --at 1/3 -o a.diagram.json")
    for queries, of in ((QUERIES, "a.scene.json"), (QUERIES_OVER, "a.scene.json a.history.jsonl")):
        for query in queries:
            name, _, options = query.partition(" ")
            go(f"query {name} {of} {options} -o {name}.answer.json")
    go("plan --preset five -o p.scene.json --report p.plan.json")
    (folder / "crowded.json").write_text(json.dumps(CROWDED))
    go("plan crowded.json -o q.scene.json --report q.plan.json")
    (folder / "paths.csv").write_text("disk,t,x,y,radius\na,0,0,0,1\na,10,20,0,1\nb,0,10,1.5,1\nb,10,10,-3,1\n")
    go("clearance paths.csv --below 1 --required 1/2 -o paths.clearance.json")
    (folder / "curves.csv").write_text("# periodic: 40,none,40\ndisk,t,duration,x^0,x^1,y^0,y^3,z^0\n"
                                       "a,0,4,1,2,0,1/8,0\nb,0,4,9,-1,3,0,1\n")
    go("clearance curves.csv --radius 0 --below 3 --required=-1/2 --height 2 --may-touch -o curves.clearance.json")
    go("clearance paths.csv --frames-only -o frames.clearance.json")
    go("clearance a.scene.json a.history.jsonl --below 5 --required 1/2 -o history.clearance.json")
    (folder / "between.scene.json").write_text(json.dumps(BETWEEN_WALLS))
    go("simulate between.scene.json -o between.history.jsonl")
    go("clearance between.scene.json between.history.jsonl --below 5 --required 0 -o between.clearance.json")
    (folder / "disks.csv").write_text("0,0,1\n4,0,2\n4,1,0.5\n1,3,0\n40,0,1\n")
    go("diagram disks.csv -o plane.json")
    go("diagram disks.csv --frame 2,1,9 -o framed.json")
    (folder / "help.json").write_text(subprocess.check_output([program, "help", "--json"], text=True))
    go("corpus run --family few --json own.corpus.json")
    go("corpus run --family few --json their.corpus.json --against", f"'{example}' {{scene}} {{history}}")
    for line in (CORPUS / "cases.txt").read_text().splitlines():
        if line.startswith(("refuted/", "undecided/")):
            file, scene, truth, _, options = line.split("\t")
            report = f"{pathlib.Path(file).stem}.{truth}.report.json"
            go(f"certify {CORPUS}/scenes/{scene}.scene.json {CORPUS / file} --truth {truth} --report {report}",
               *([] if options == "-" else options.split()))


# Other names of this form: a program.
NO_FORMATS = {"proved"}


def named_in_sources():
    """The formats that the sources name, each as a string of its own or at the beginning of a file."""
    return {name for room in ROOMS for path in (ROOT / room).rglob("*.cpp")
            for name in re.findall(r'voroproof-([a-z]+(?:-[a-z]+)*)\\?"', path.read_text())} - NO_FORMATS


def main():
    program, example = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:])
    files = Files(strangers=False)
    failed, formats = 0, set()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_some(folder, program, example)
        paths = [*folder.glob("*.json"), *folder.glob("*.jsonl"), *CORPUS.glob("scenes/*.json"),
                 *CORPUS.glob("certified/*.jsonl"), *CORPUS.glob("refuted/*.jsonl"),
                 *CORPUS.glob("undecided/*.jsonl"), *CORPUS.glob("cases/*/*/case.json"),
                 *CORPUS.glob("cases/few/*/*.json*")]
        for path in sorted(paths):
            text = path.read_text()
            formats.add(json.loads(text if path.suffix == ".json" else text.splitlines()[0])["format"])
            fault = files.fault(text)
            if fault is not None:
                print(f"{path.name}: {fault}")
                failed += 1
    for stranger in named_in_sources() - set(NAMES):
        print(f"no schema of the format voroproof-{stranger}")
        failed += 1
    for missing in {f"voroproof-{name}" for name in NAMES} - formats:
        print(f"nothing of the format {missing} was written")
        failed += 1
    print(f"{len(paths)} files, {failed} not of their schemas")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
