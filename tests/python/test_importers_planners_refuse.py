"""Importers of plans refuse what is damaged or hostile with one line, in bounded memory."""

import json
import random
import subprocess
import sys
import zipfile

import pytest
from importer_files import LOG, POLYNOMIALS, SCHEDULE, TRAJECTORY, broken, refusal, write_skyc

import voroproof as vp
from voroproof.importers import polynomials, skybrush


@pytest.mark.parametrize("old, new, line, field, reason", [
    (SCHEDULE, "", 0, "schedule", "no such key"),
    (SCHEDULE, "hello\n", 1, "", "no key"),
    (SCHEDULE, "- x: 1\n", 1, "", "no schedule"),
    (SCHEDULE, "schedule:\n", 1, "schedule", "no agent"),
    (SCHEDULE, "statistics:\n  success: 0\n", 0, "schedule", "no such key"),
    ("schedule:", "schedule: {}", 7, "schedule", "no agents below"),
    ("      t: 3\n", "      t: 3\nschedule:\n", 28, "schedule", "occurs twice"),
    ("  agent0:", "  agent0: &a", 8, "schedule", "no agent's name"),
    ("  agent1:", "  agent0:", 18, "agent0", "occurs twice"),
    ("  agent1:", "  agent2:\n  agent1:", 18, "agent2", "no state"),
    ("  agent1:", " agent1:", 18, "schedule", "indented"),
    ("    - x: 1\n", "   - x: 1\n", 12, "schedule", "belongs to no agent"),
    ("  agent0:\n", "", 8, "schedule", "belongs to no agent"),
    ("      y: 0\n      t: 1", "     y: 0\n      t: 1", 13, "schedule", "indented"),
    ("      y: 0\n      t: 1", "      y: 0\n      y: 1", 14, "agent0 y", "occurs twice"),
    ("      y: 0\n      t: 1", "      y: 0\n      z: 1", 14, "agent0 z", "not x, y or t"),
    ("      y: 0\n      t: 1", "      t: 1", 12, "agent0 y", "missing"),
    ("    - x: 1\n      y: 0", "    - v: v1", 12, "agent0 v", "roadmap"),
    ("    - x: 1\n      y: 0\n      t: 1", "    - {x: 1, y: 0, t: 1, t: 1}", 12, "agent0 t", "occurs twice"),
    ("    - x: 1\n      y: 0\n      t: 1", "    - {x: 1, y: 0}", 12, "agent0 t", "missing"),
    ("    - x: 1\n      y: 0\n      t: 1", "    - [1, 0, 1]", 12, "agent0", "no coordinate"),
    ("    - x: 1\n      y: 0\n      t: 1", "    - *a", 12, "agent0", "no coordinate"),
    ("x: 1", "x: .nan", 12, "agent0 x", "not a decimal"),
    ("x: 1", "x: 01", 12, "agent0 x", "octal"),
    ("x: 1", "x: 1e999", 12, "agent0 x", "magnitude"),
    ("t: 1\n", "t: 0\n", 12, "agent0 t", "no later"),
    ("t: 1\n", "t: -1\n", 12, "agent0 t", "no later"),
    (SCHEDULE[SCHEDULE.index("    - x: 2\n      y: 1"):], "", 0, "statistics makespan", "3, and the schedule takes only 2"),
    (SCHEDULE[SCHEDULE.index("  agent1"):], "", 0, "statistics makespan", "states are missing"),
    (SCHEDULE[SCHEDULE.index("    - x: 2\n      y: 0"):SCHEDULE.index("  agent1")], "", 0, "statistics cost",
     "5, and the schedule takes only 4"),
    (SCHEDULE[SCHEDULE.index("      t: 3"):], "", 25, "agent1 t", "missing"),
])
def test_schedules(tmp_path, old, new, line, field, reason):
    assert old in SCHEDULE
    (tmp_path / "a.yaml").write_text(SCHEDULE.replace(old, new, 1))
    error = refusal("mapf", tmp_path / "a.yaml")
    assert (error.line, error.field) == (line, field) and reason in error.reason, str(error)


AGENT = LOG.index('<agent id="b" start.x="5" start.y="1" goal.x="5" goal.y="1" size')


@pytest.mark.parametrize("old, new, field, reason", [
    (LOG, "", "", "no XML"),
    (LOG, "no", "", "no XML"),
    (LOG, "<a><log/></a>", "root/log/agent", "no agent"),
    (LOG[AGENT:], "", "", "no XML"),
    (LOG[AGENT:LOG.index("</log>")], "", "agents agent", "2 in the task, and 1 in the log"),
    (LOG[LOG.index("<log>"):], "</root>", "root/log/agent", "no agent"),
    ('<?xml version="1.0" ?>', '<!DOCTYPE root [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>', "", "not read"),
    ('<?xml version="1.0" ?>', '<!DOCTYPE root SYSTEM "/etc/hostname">', "", "not read"),
    ('size="0.40000001"', "", "agent size", "missing"),
    ('size="0.40000001"', 'size="-1"', "agent radius", "negative"),
    ('size="0.40000001"', 'size="nan"', "agent size", "not a decimal"),
    ('<obstacle id="0">', '<obstacle id="0" size="0">', "obstacle size", "the solver takes another"),
    ('size="0.33333"', 'size="11"', "defaultparameters size", "the solver takes another"),
    ('pathfound="true" runtime="0.0007"', "", "path pathfound", "missing"),
    ('pathfound="true" runtime="0.0007"', 'pathfound="1"', "path pathfound", "neither true nor false"),
    ('duration="9.5"', 'duration="9.4"', "path duration", "9.4, and its sections take 9.5"),
    ('duration="9.5"', "", "path duration", "missing"),
    ('id="1" start.x="0" start.y="0"', 'id="2" start.x="0" start.y="0"', "section id", "section 1 is missing"),
    ('start.y="0" start.heading="0" goal.x="3"', 'start.y="1" start.heading="0" goal.x="3"', "section start.x", "elsewhere"),
    ('duration="6"', 'duration="-6"', "section duration", "negative"),
    ('duration="6"', 'duration="0"', "section duration", "0, and the agent moves"),
    ('duration="6"', 'duration="six"', "section duration", "not a decimal"),
    ('goal.x="3" goal.y="0" goal.heading="0" size', 'goal.x="4" goal.y="0" goal.heading="0" size', "agent goal.x", "not lead"),
    ('<agent id="b" start.x="5" start.y="1" goal.x="5" goal.y="1" size',
     '<agent id="0" start.x="5" start.y="1" goal.x="5" goal.y="1" size', "agent id", "0 occurs twice"),
    ('<agent id="b" start.x="5" start.y="1" goal.x="5" goal.y="1" size',
     '<agent id="b,c" start.x="5" start.y="1" goal.x="5" goal.y="1" size', "agent disk", "comma"),
    ('<path pathfound="true" runtime="0.0001" duration="0"/>', "", "agent path", "missing"),
    ('<path pathfound="true" runtime="0.0001" duration="0"/>', '<path pathfound="false"/><path pathfound="true"/>',
     "agent path", "a second time"),
    (LOG[LOG.index('<section id="0"'):LOG.index("</obstacle>")], "", "obstacle section", "none tells where it is"),
    ("</log>", "</log><log/>", "root log", "a second time"),
])
def test_logs(tmp_path, old, new, field, reason):
    assert old in LOG
    (tmp_path / "a_log.xml").write_text(LOG.replace(old, new, 1))
    error = refusal("aa-sipp", tmp_path / "a_log.xml")
    assert error.field == field and reason in error.reason, str(error)


def test_lines_of_logs_are_named(tmp_path):
    (tmp_path / "a_log.xml").write_text(LOG.replace('duration="6"', 'duration="six"'))
    wanted = 1 + LOG[:LOG.index('duration="6"')].count("\n")
    assert refusal("aa-sipp", tmp_path / "a_log.xml").line == wanted


@pytest.mark.parametrize("text", ['<root><log a="' + "bbbbbbbbbbbbbbb\n" * (1 << 17), "<root><log>" + "<a>" * (1 << 17)])
def test_logs_without_an_end(tmp_path, text):
    (tmp_path / "a_log.xml").write_text(text)
    assert "more than" in refusal("aa-sipp", tmp_path / "a_log.xml").reason


FIRST = POLYNOMIALS.splitlines()[1]


@pytest.mark.parametrize("old, new, line, field, reason", [
    (POLYNOMIALS, "", 0, "", "no heading"),
    (POLYNOMIALS[POLYNOMIALS.index("\n"):], "", 0, "", "no piece"),
    ("duration", "time", 1, "heading", "not duration"),
    ("x^7", "x^8", 1, "heading", "not duration"),
    (",yaw^7", "", 1, "heading", "not duration"),
    (",0.180493", "", 2, "", "32 fields, not the 33"),
    (FIRST, FIRST + "1", 2, "", "34 fields"),
    ("1.050000", "0", 2, "duration", "not positive"),
    ("1.050000", "-1", 2, "duration", "not positive"),
    ("1.050000", "nan", 2, "duration", "not a decimal"),
    ("0.830443", "inf", 2, "x^4", "not a decimal"),
    ("0.830443", "", 2, "x^4", "not a decimal"),
    ("0.830443", "1e101", 2, "x^4", "magnitude"),
    ("0.830443", '"0.8', 3, "", "unexpected end"),
])
def test_polynomials(tmp_path, old, new, line, field, reason):
    assert old in POLYNOMIALS
    (tmp_path / "a.csv").write_text(POLYNOMIALS.replace(old, new, 1))
    error = refusal("polynomials", tmp_path / "a.csv")
    assert (error.line, error.field) == (line, field) and reason in error.reason, str(error)


def test_two_files_for_one_disk(tmp_path):
    (tmp_path / "b").mkdir()
    paths = [str(tmp_path / "a.csv"), str(tmp_path / "b" / "a.csv")]
    for path in paths:
        with open(path, "w", encoding="utf-8") as file:
            file.write(POLYNOMIALS)
    with pytest.raises(vp.InputError, match="another file before has this name") as caught:
        polynomials.read(*paths)
    assert caught.value.file == paths[1]


PART = "drones/drone_0/trajectory.json"


@pytest.mark.parametrize("old, new, field, reason", [
    (TRAJECTORY, "", "", "no JSON"),
    ("]}", "", "", "no JSON"),
    (TRAJECTORY, "[" * 200000, "", "no JSON"),
    (TRAJECTORY, "[]", "version", "not 1"),
    ('"version": 1', '"version": 2', "version", "not 1"),
    ('"version": 1', '"version": "1"', "version", "not 1"),
    ('"version": 1', '"version": 1, "version": 1', "", "occurs twice"),
    ('"points"', '"point"', "points", "no list"),
    (TRAJECTORY, '{"version": 1, "points": []}', "points", "none"),
    ('"takeoffTime": 6', '"takeoffTime": "6"', "takeoffTime", "not a number"),
    ('"takeoffTime": 6', '"takeoffTime": NaN', "takeoffTime", "not a decimal"),
    ("[0.0, [0.0, 0.0, 0.0], []]", "[0.0, [0.0, 0.0, 0.0], [[0, 0, 0]]]", "points[0]", "before the first"),
    ("[22, [12", "[5, [12", "points[2][0]", "no later"),
    ("[22, [12", "[6, [12", "points[2][0]", "no later"),
    ("[22, [12, 12, 12]", "[22, [12, 12]", "points[2][1]", "three coordinates"),
    ("[22, [12, 12, 12]", "[22, [12, 12, Infinity]", "points[2][1]", "not a decimal"),
    ("[22, [12, 12, 12]", "[22, [12, 12, true]", "points[2][1]", "not a number"),
    ("[22, [12, 12, 12]", "[22, [12, 12, 1e400]", "points[2][1]", "magnitude"),
    ("[22, [12, 12, 12]", "[22, {}", "points[2][1]", "three coordinates"),
    ("[22, [12, 12, 12], [", "[22, [12, 12, 12], 1, [", "points[2]", "not a time, a place"),
    ("[[-6, 18, 12]]", "[" + "[-6, 18, 12]," * 6 + "[0, 0, 0]]", "points[3][2]", "at most 6 control points"),
    ("[[-6, 18, 12]]", "[-6, 18, 12]", "points[3][2][0]", "three coordinates"),
    ("38.0", "38." + "0" * 300 + "1", "points[3] x^2", "2000 bits"),
])
def test_trajectories_of_shows(tmp_path, old, new, field, reason):
    assert old in TRAJECTORY
    write_skyc(tmp_path / "a.skyc", TRAJECTORY.replace(old, new, 1))
    error = refusal("skybrush", tmp_path / "a.skyc")
    assert error.field == f"{PART} {field}".rstrip() and reason in error.reason, str(error)


def shown(**settings):
    return {"version": 1, "swarm": {"drones": [{"settings": settings}]}}


@pytest.mark.parametrize("show, field, reason", [
    ("[]", "version", "not 1"),
    ({"version": 1}, "swarm", "no object"),
    ({"version": 1, "swarm": {"drones": {}}}, "swarm.drones", "no list"),
    ({"version": 1, "swarm": {"drones": []}}, "swarm.drones", "none"),
    ({"version": 1, "swarm": {"drones": [{}] * 5001}}, "swarm.drones", "more than 5000"),
    ({"version": 1, "swarm": {"drones": [3]}}, "swarm.drones[0].settings", "no object"),
    (shown(), "swarm.drones[0].settings.trajectory", "no object"),
    (shown(trajectory={"$ref": 3}), "swarm.drones[0].settings.trajectory.$ref", "no string"),
    (shown(trajectory={"$ref": f"{PART}#/points"}), "swarm.drones[0].settings.trajectory.$ref", "a part of a file"),
    (shown(trajectory={"$ref": PART}, name=7), "swarm.drones[0].settings.name", "no string"),
    (shown(trajectory={"$ref": PART}, home=[1]), "swarm.drones[0].settings.home", "three coordinates"),
    (shown(trajectory={"version": 1, "points": [[0, [0]]]}), "swarm.drones[0].settings.trajectory.points[0][1]", "three"),
])
def test_shows(tmp_path, show, field, reason):
    write_skyc(tmp_path / "a.skyc", TRAJECTORY, show=show if isinstance(show, str) else json.dumps(show))
    error = refusal("skybrush", tmp_path / "a.skyc")
    assert error.field == f"show.json {field}" and reason in error.reason, str(error)


def test_archives(tmp_path, monkeypatch):
    path = tmp_path / "a.skyc"
    write_skyc(path, TRAJECTORY, TRAJECTORY, settings=[{"name": "a"}, {"name": "a"}])
    assert "that of another drone" in refusal("skybrush", path).reason
    write_skyc(path, TRAJECTORY, settings=[{"name": "a,b"}])
    assert "comma" in refusal("skybrush", path).reason
    write_skyc(path, TRAJECTORY, show=json.dumps(shown(trajectory={"$ref": "../../etc/passwd"})))
    error = refusal("skybrush", path)
    assert error.field == "../../etc/passwd" and "no such file in the show" in error.reason
    write_skyc(path, TRAJECTORY, packing=zipfile.ZIP_LZMA)
    assert "deflation" in refusal("skybrush", path).reason
    write_skyc(path, TRAJECTORY)
    whole = path.read_bytes()
    with pytest.warns(UserWarning), zipfile.ZipFile(path, "a") as archive:
        archive.writestr(PART, TRAJECTORY)
    assert "occurs twice" in refusal("skybrush", path).reason
    for damaged in (b"", b"PK", whole[:-30], whole[len(whole) // 2:]):
        path.write_bytes(damaged)
        assert "no show of Skybrush" in refusal("skybrush", path).reason
    assert "no such file" in refusal("skybrush", tmp_path / "none").reason
    # One part named by many drones counts each time.
    write_skyc(path, TRAJECTORY, *[TRAJECTORY] * 9)
    monkeypatch.setattr(skybrush, "LARGEST_SHOW", 5 * len(TRAJECTORY))
    assert "in all" in refusal("skybrush", path).reason


READ = """
import resource, sys
from voroproof.importers import skybrush
now = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (now + (3 << 25), now + (3 << 25)))
skybrush.read(sys.argv[1])
"""


def test_bombs(tmp_path):
    """128 MiB of blanks, which are packed in a thousandth, and are refused in less memory than they take."""
    path = tmp_path / "a.skyc"
    write_skyc(path, TRAJECTORY + " " * (1 << 27))
    assert path.stat().st_size < 1 << 18
    done = subprocess.run([sys.executable, "-B", "-c", READ, str(path)], capture_output=True, text=True)
    assert "InputError" in done.stderr and "more than 33554432 bytes" in done.stderr


def test_broken_trajectories_are_read_or_refused(tmp_path):
    """In sound archives, so that the damage comes to the reader of JSON and beyond."""
    dice = random.Random(11)
    outcomes = {True: 0, False: 0}
    for _ in range(150):
        write_skyc(tmp_path / "a.skyc", broken(dice, TRAJECTORY.encode()))
        try:
            skybrush.read(str(tmp_path / "a.skyc"))
            outcomes[True] += 1
        except vp.InputError as error:
            assert "\n" not in str(error)
            outcomes[False] += 1
    assert min(outcomes.values()) > 0, outcomes
