"""Where a probe fits: two disks by hand, what the program answers, and few disks."""

import json
import math
import os
import subprocess

import pytest

import voroproof as vp

LEFT, RIGHT = (-1, 0, 1), (-1, 1, 0)  # the vertices: to the container's centre, disk 0 is on the left


@pytest.fixture(scope="module")
def two():
    """Gap 4 - 2t up to their collision at 2, then 2(t - 2)."""
    return vp.simulate(vp.Scene({"container": {"center": [0, 0], "radius": 10}, "horizon": 8, "disks": [
        {"center": [-3, 0], "radius": 1, "velocity": [1, 0]}, {"center": [3, 0], "radius": 1, "velocity": [-1, 0]}]}))


def encloses(pair, value):
    return pair[0] <= value <= pair[1] and pair[1] - pair[0] < 1e-9


def test_critical_radii(two):
    tunnels, voids = two.scene.at(0).critical()
    assert [(t.edge[:2], t.at.kind) for t in tunnels] == [((-1, 0), "gate"), ((-1, 1), "gate"), ((0, 1), "gate")]
    assert [t.at.generators for t in tunnels] == [(0, -1), (1, -1), (0, 1)]
    assert all(encloses(t.closes, r) for t, r in zip(tunnels, (3, 3, 2)))
    # The circle about (0, y): sqrt(9 + y^2) - 1 = 10 - y.
    assert [v.at for v in voids] == [vp.Place("vertex", LEFT), vp.Place("vertex", RIGHT)]
    assert all(encloses(v.vanishes, 10 - (121 - 9) / 22) for v in voids)


def test_voids(two):
    instant = two.scene.at(0)
    whole, = instant.voids("1/2")
    assert whole.vertices == [LEFT, RIGHT] and len(whole.tunnels) == 3
    # The ends count: a probe of exactly the gate passes, one a little larger does not.
    assert [len(v.tunnels) for v in instant.voids(2)] == [3]
    assert [len(v.tunnels) for v in instant.voids("2.0000000000000000000001")] == [2]
    parted = instant.voids("16/5")
    assert [v.vertices for v in parted] == [[LEFT], [RIGHT]] and not any(v.tunnels for v in parted)
    assert instant.voids(5) == []


def test_the_offset(two):
    instant = two.scene.at(0)
    assert [(a.generator, a.start, a.end) for a in instant.offset("1/2")] == [(g, None, None) for g in (-1, 0, 1)]
    around = {a.generator: a for a in instant.offset("5/2")}
    assert around[-1].start is None
    # Counterclockwise around disk 0, from above the gap to below it; the axis is that from 1 to 0, to the left.
    start, end = around[0].start, around[0].end
    assert (start[:3], end[:3]) == ((1, 0, -1), (1, 0, 1))
    assert encloses(start.x, 0) and encloses(start.y, math.sqrt(3.25)) and encloses(end.y, -math.sqrt(3.25))
    assert (around[1].start, around[1].end) == (end, start)


def test_openings(two):
    first, second = two.tunnel_openings(0, 1, "1/2")
    assert encloses(first.start, 0) and encloses(first.end, 1.5)
    assert encloses(second.start, 2.5) and encloses(second.end, 8)
    assert two.tunnel_openings(1, 0, "1/2", start=1.5, end=2.5) == []
    (start, end), = two.void_openings(LEFT, 5)
    assert encloses(start, 1 + math.sqrt(11)) and encloses(end, 8)
    # Turned round it is the same vertex; the other way round it is the other one, which is like it.
    assert two.void_openings((1, -1, 0), 5) == two.void_openings(RIGHT, 5) == [(start, end)]


def test_lives_of_voids(two):
    lives = two.void_lives("16/5")
    spells = [(0, 0.4), (0, 0.4), (0.4, 3.6), (3.6, 5.2), (3.6, 5.2), (5.2, 8)]
    assert len(lives) == len(spells)
    assert all(encloses(v.start, a) and encloses(v.end, b) for v, (a, b) in zip(lives, spells))
    assert [v.before for v in lives] == [[], [], [0, 1], [2], [2], [3, 4]]
    assert [v.after for v in lives] == [[2], [2], [3, 4], [5], [5], []]
    assert lives[0].at == vp.Place("vertex", LEFT)


def test_bad_questions(two):
    instant = two.scene.at(0)
    for ask in (instant.voids, instant.offset, two.void_lives):
        with pytest.raises(ValueError, match="probe"):
            ask(-1)
    for wrong in ((0, 0), (0, 2), (-2, 0)):
        with pytest.raises(ValueError, match="generator"):
            two.tunnel_openings(*wrong, 1)
    with pytest.raises(ValueError, match="generator"):
        two.void_openings((-1, 0, -1), 1)
    with pytest.raises(ValueError, match="before"):
        two.void_lives(1, start=3, end=3)
    with pytest.raises(ValueError, match="beyond"):
        two.void_lives(1, end=9)


def few(n):
    return vp.Scene({"container": {"center": [0, 0], "radius": 10}, "horizon": 1, "disks": [
        {"center": [3 * k, 0], "radius": 1, "velocity": [0, 0]} for k in range(n)]})


def test_few_disks():
    empty = few(0).at(0)
    nothing, = empty.voids(1)
    assert nothing.vertices == [] and nothing.at is None and encloses(nothing.vanishes, 10)
    assert empty.voids(11) == [] and empty.critical() == ([], [])
    alone, = few(1).at(0).voids("9/2")
    assert alone.vertices == [] and encloses(alone.vanishes, 4.5)
    assert few(1).at(0).voids("4.500001") == []
    for n in (0, 1):
        life, = vp.simulate(few(n)).void_lives(1)
        assert encloses(life.start, 0) and encloses(life.end, 1) and life.before == life.after == []


def place_of(json_place):
    (kind, ids), = json_place.items()
    return vp.Place(kind, (ids, -1) if kind == "far" else tuple(ids))


@pytest.mark.skipif("VOROPROOF_PROGRAM" not in os.environ, reason="the program is not built")
def test_the_answers_are_those_of_the_program(tmp_path):
    history = vp.simulate(vp.Scene.reference(20, horizon=8, seed=4, density=0.4))
    scene, instant = history.scene, history.scene.at("7/2")
    scene.write(tmp_path / "a.scene.json")
    history.write(tmp_path / "a.history.jsonl")

    def asked(*words):
        done = subprocess.run([os.environ["VOROPROOF_PROGRAM"], "query", *words, "-o", "answer.json"], cwd=tmp_path,
                              capture_output=True)
        assert done.returncode == 0, done.stderr
        return json.loads((tmp_path / "answer.json").read_text())

    def tunnels(all):
        return [vp.Tunnel(tuple(t["edge"]), tuple(t["closes"]), place_of(t["at"])) for t in all]

    def point(end):
        return end and vp.OffsetPoint(*end["edge"], end["side"], tuple(end["x"]), tuple(end["y"]))

    moment = ("a.scene.json", "--at", "7/2")
    told = asked("voids", *moment, "--probe", "4")["voids"]
    assert len(told) > 1
    assert instant.voids(4) == [vp.Void([tuple(v) for v in void["vertices"]], tunnels(void["tunnels"]),
                                        tuple(void["vanishes"]), place_of(void["at"])) for void in told]
    told = asked("critical", *moment)
    assert instant.critical() == (tunnels(told["tunnels"]),
                                  [(tuple(v["vanishes"]), place_of(v["at"])) for v in told["voids"]])
    told = asked("offset", *moment, "--probe", "4")["arcs"]
    assert instant.offset(4) == [(a["generator"], point(a.get("from")), point(a.get("to"))) for a in told]

    files = ("a.scene.json", "a.history.jsonl")
    told = asked("voids-over", *files, "--probe", "5")["voids"]
    assert len(told) > 2
    assert history.void_lives(5) == [(tuple(v["from"]), tuple(v["to"]), v["before"], v["after"], place_of(v["at"]))
                                     for v in told]
    i, j = map(int, history.initial[-1][:2])
    told = asked("tunnel", *files, "--pair", str(i), str(j), "--probe", "1")["open"]
    assert told and history.tunnel_openings(i, j, 1) == [(tuple(o["from"]), tuple(o["to"])) for o in told]
