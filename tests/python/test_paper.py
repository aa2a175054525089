"""The paper's experiments and its test of section 7.2 (bench/paper): what is counted, against counting in other ways."""

import json
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import voroproof as vp

PAPER = pathlib.Path(os.environ["VOROPROOF_SOURCE"]) / "bench" / "paper"
sys.path.insert(0, str(PAPER))
from check72 import Check  # noqa: E402
from predictions import predictions  # noqa: E402


@pytest.fixture(scope="module")
def history():
    return vp.simulate(vp.Scene.reference(40, horizon=40, seed=3, density=0.2))


def check72(history):
    check = Check(history.scene, history, 1e-6)
    return check, check.run(0.1)


def some_flip(history):
    flips = np.flatnonzero(history.events["kind"] == vp.FLIP)
    return flips[len(flips) // 2]


def is_refuted(history):
    return all(vp.certify(history.scene, history, truth=truth).verdict == "refuted" for truth in ("exact", "recorded"))


@pytest.mark.parametrize("scene", [
    vp.Scene.reference(40, horizon=20, seed=3, density=0.2), vp.Scene.grid(25, horizon=20),
    vp.Scene.reference(30, horizon=20, radii="log", rmin=0.1, density=0.3), vp.Scene.reference(1, horizon=20)])
def test_right_histories_pass(scene):
    check, found = check72(vp.simulate(scene))
    assert found is None and check.regular == 201  # k times 0.1 for k = 0 to 200


def test_a_flip_that_comes_too_late_is_seen(history):
    events = history.events.copy()
    k = some_flip(history)
    late = events[k].copy()
    late["t"] += 0.5
    events = np.delete(events, k)
    wrong = history.with_events(np.insert(events, np.searchsorted(events["t"], late["t"]), late))
    assert check72(wrong)[1] is not None and is_refuted(wrong)


def test_how_far_a_disk_reaches_in_is_told():
    """Four at rest; a flip makes the wrong two neighbours. The centres of 0, 1 and 2 have the circle around (0, -10.5)
    of radius 14.5, and disk 3, 6.5 from its centre, reaches into that of the disks by 13.5 + 1 - 6.5."""
    centers = [(-10, 0), (10, 0), (0, 4), (0, -4)]
    scene = vp.Scene({"container": {"center": [0, 0], "radius": 100}, "horizon": 10,
                      "disks": [{"center": c, "radius": 1, "velocity": [0, 0]} for c in centers]})
    history = vp.simulate(scene)
    quad = next(q for q in history.initial.tolist() if set(q[:2]) == {2, 3} and set(q[2:]) == {0, 1})
    flip = np.zeros(1, vp.event_dtype)
    flip["t"], flip["ids"] = 5.05, quad
    t, _, generator, depth = check72(history.with_events(flip))[1]
    assert t == 51 * 0.1 and generator in (2, 3) and depth == pytest.approx(8)


def test_faults_that_it_cannot_see(history):
    """A flip and its reversal; and collisions of another law, for it follows the recorded motion."""
    k = some_flip(history)
    l, r, s, e = history.events["ids"][k]
    back, again = history.events[k].copy(), history.events[k].copy()
    back["ids"], again["ids"] = (s, e, r, l), (r, l, e, s)
    doubled = history.with_events(np.insert(history.events, k + 1, [back, again]))
    other = vp.simulate(history.scene.replace(restitution=0.5))
    lossy = vp.History(history.scene, other.events, initial=other.initial)
    for wrong in (doubled, lossy):
        assert check72(wrong)[1] is None and is_refuted(wrong)


def test_predicted_collisions_are_those_of_the_rule():
    """Two disks on a line meet at t = 8.5. After each instant the new pairs that would meet count."""
    scene = vp.Scene({"container": {"center": [0, 0], "radius": 100}, "horizon": 100,
                      "disks": [{"center": [-10, 0], "radius": 1, "velocity": [1, 0]},
                                {"center": [10, 0], "radius": 2, "velocity": [-1, 0]}]})
    history = vp.simulate(scene)
    x, v, radius, expected, now = [-10.0, 10.0], [1.0, -1.0], [1, 2], 0, 0.0

    def count(t, moved):
        gap, closing = x[1] - x[0] - 3, v[0] - v[1]
        met = gap > 1e-9 and closing > 0 and gap / closing <= 100 - t
        walls = [i for i in moved if v[i] and (100 - radius[i] - np.sign(v[i]) * x[i]) / abs(v[i]) <= 100 - t]
        return met + len(walls)

    expected += count(0, [0, 1])
    for event in history.events:
        x, now = [p + w * (event["t"] - now) for p, w in zip(x, v)], event["t"]
        moved = [(i, side) for side, i in enumerate(event["ids"][:2]) if i >= 0]
        for i, side in moved:
            v[i] = event["velocity"][side, 0]
        expected += count(now, [i for i, _ in moved])
    assert len(history) > 1 and predictions(scene, history)["collisions"] == expected


@pytest.mark.skipif("VOROPROOF_PROGRAM" not in os.environ, reason="the program is not built")
def test_experiments_and_their_figures(tmp_path):
    panels = {"reference": 2, "speed": 3, "size": 3, "density": 3, "restitution": 2}
    for name, count in panels.items():
        subprocess.run([sys.executable, PAPER / "experiment.py", os.environ["VOROPROOF_PROGRAM"], name, "-o", tmp_path / name,
                        "--scale", "0.02", "--horizon", "25", "--members", "2", "--seeds", "2", "--predictions"], check=True)
        experiment = json.loads((tmp_path / name).read_text())
        assert len(experiment["members"]) == 4
        for member in experiment["members"]:
            # Frequencies sum to the counts, and every event that occurs has been predicted.
            collisions = sum(member["collisions"].values())
            assert [len(member["flip_frequency"]), sum(member["flip_frequency"])] == [3, member["flips"]]
            assert sum(member["collision_frequency"]) == collisions
            predicted = member["predicted"]
            assert predicted["roots"] > predicted["flips"] >= predicted["flips_before_contact"] >= member["flips"]
            assert predicted["collisions"] >= collisions and member["neighbor_distance"]["count"] == member["n"]
    pytest.importorskip("matplotlib")
    subprocess.run([sys.executable, PAPER / "plot.py", *(tmp_path / name for name in panels), "-o", tmp_path], check=True)
    for name, count in panels.items():
        assert (tmp_path / f"{name}.svg").read_text().count('<g id="axes_') == count
