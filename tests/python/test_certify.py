"""The certifier: verdicts, witnesses in Fractions, words, refusals."""

import hashlib
from fractions import Fraction

import numpy as np
import pytest

import voroproof as vp


@pytest.fixture(scope="module")
def scene():
    return vp.Scene({"container": {"center": [0, 0], "radius": 10}, "horizon": 8,
                     "disks": [{"center": [-3, 0], "radius": 1, "velocity": [1, 0]},
                               {"center": [3, 0], "radius": 1, "velocity": [-1, 0]}]})


@pytest.fixture(scope="module")
def history(scene):
    return vp.simulate(scene)


@pytest.mark.parametrize("truth", ["exact", "recorded"])
def test_right(scene, history, truth):
    report = vp.certify(scene, history, truth=truth, strict=True)
    assert report.certified and report.verdict == "certified" and report.divergence is None
    assert report.prefix_events == len(history) and report.collisions == 1
    assert str(report) == "CERTIFIED" and "CERTIFIED" in report.explain()
    assert report.about == f"all events, {truth} truth, up to t = 8, times within 1e-6, velocities within 1e-9, strict"
    assert report.reservations == []
    assert report.to_dict()["format"] == "voroproof-report"


def test_a_report_is_of_bytes(scene, history, tmp_path):
    scene.write(tmp_path / "a.scene.json")
    history.write(tmp_path / "a.history.jsonl")
    of_files = vp.certify_files(tmp_path / "a.scene.json", tmp_path / "a.history.jsonl")
    written = hashlib.sha256((tmp_path / "a.history.jsonl").read_bytes()).hexdigest()
    for report in (of_files, vp.certify(scene, history)):
        assert report.to_dict()["history_sha256"] == written
    wrong = history.with_events(history.events[1:])
    for report in (of_files, vp.certify(scene, history)):
        assert '"words":"CERTIFIED"' in history.movie_page(report=report)
        with pytest.raises(vp.InputError, match="another history"):
            wrong.movie_page(report=report)


def test_collisions_alone_are_said_to_be(scene, history):
    report = vp.certify(scene, history, events="collisions")
    assert "CERTIFIED (collisions alone)" in report.explain()
    page = history.movie_page(report=report)
    assert '"words":"CERTIFIED (collisions alone)"' in page and '"noDiagram":"' in page


def test_leniency_is_a_reservation(scene, history):
    report = vp.certify(scene, history.with_events(history.events[:0]), truth="recorded", tolerance=8)
    assert report.certified and "not claimed" in report.reservations[0]


def test_a_witness_in_fractions(scene, history):
    wrong = history.with_events(history.events[history.events["kind"] != vp.COLLISION])
    report = vp.certify(scene, wrong)
    assert report.verdict == "refuted" and not report.certified
    assert report.divergence.fault == "missing event" and report.divergence.pair == (0, 1)
    witness = report.divergence.witness
    # Centres -3 + t and 3 - t that meet at the distance 2: (6 - 2 t)^2 - 4.
    assert [c for c, _ in witness.polynomial] == [32, -24, 4]
    low, high = witness.root
    value = lambda t: sum(c * t ** k for k, (c, _) in enumerate(witness.polynomial))
    assert isinstance(low, Fraction) and low <= 2 <= high
    assert value(low) >= 0 >= value(high)
    motion = witness.generators[0]
    assert motion.vx == (1, 1) and motion.signed_radius == (1, 1)
    assert motion.x[0] + motion.vx[0] * (2 - motion.t0) == -1
    assert "Exactly one root" in report.explain()
    assert "CGAL" in report.evidence


def test_bounds_where_the_motion_is_irrational():
    scene = vp.Scene.reference(20, horizon=60)
    history = vp.simulate(scene)
    events = history.events.copy()
    last = np.flatnonzero(events["kind"] == vp.FLIP)[-1]
    report = vp.certify(scene, history.with_events(np.delete(events, last)))
    assert report.verdict == "refuted" and report.divergence.line == last + 2
    loose = [m for m in report.divergence.witness.generators if m.x[0] != m.x[1]]
    assert loose
    for motion in loose:
        assert motion.x[0] < motion.x[1] and motion.x[1] - motion.x[0] < Fraction(1, 10 ** 20)


def test_a_stopped_history_is_undecided(scene):
    history = vp.simulate(vp.Scene.reference(10, horizon=50), max_events=5)
    report = vp.certify(history.scene, history)
    assert report.verdict == "undecided" and report.prefix_events == 5


def test_files(tmp_path, scene, history):
    scene.write(tmp_path / "a.json")
    history.write(tmp_path / "a.jsonl")
    report = vp.certify_files(tmp_path / "a.json", tmp_path / "a.jsonl", truth="recorded", threads=2)
    assert report.certified
    report.write(tmp_path / "a.report.json")
    assert (tmp_path / "a.report.json").read_text() == report.json
    with pytest.raises(vp.InputError):
        vp.certify_files(tmp_path / "a.json", tmp_path / "none.jsonl")


def test_refusals(scene, history):
    with pytest.raises(vp.InputError, match="another scene"):
        vp.certify(vp.Scene.reference(2), history)
    with pytest.raises(ValueError, match="tolerance"):
        vp.certify(scene, history, tolerance=-1)
    with pytest.raises(ValueError, match="truth"):
        vp.certify(scene, history, truth="guessed")
    with pytest.raises(ValueError, match="order"):
        vp.certify(scene, history, order="mine")
    with pytest.raises(ValueError, match="order"):
        vp.certify(scene, history, truth="recorded", order="any")
    # Leniency is counted: a velocity that is off by a float32's rounding.
    events = history.events.copy()
    events["velocity"] = events["velocity"] * (1 + 1e-8)
    wrong = history.with_events(events)
    assert vp.certify(scene, wrong).divergence.fault == "wrong response"
    assert vp.certify(scene, wrong, law_tolerance="1e-6").certified
