"""Scenes: what goes in comes out, exactly, and what is no scene is refused by name."""

import json
import pickle
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import voroproof as vp


def two_disks(**fields):
    return vp.Scene({
        "container": {"center": [0, 0], "radius": 10}, "horizon": 8,
        "disks": [{"center": [-3, 0], "radius": 1, "velocity": [1, 0]},
                  {"center": [3, 0], "radius": 1, "velocity": [-1, 0]}], **fields})


@pytest.mark.parametrize("given, value", [
    (Fraction(1, 3), Fraction(1, 3)),
    ("1/3", Fraction(1, 3)),
    ("0.1", Fraction(1, 10)),
    (0.1, Fraction(0.1)),
    (Decimal("0.1"), Fraction(1, 10)),
    (np.float32(0.1), Fraction(float(np.float32(0.1)))),
    (np.int64(2), Fraction(2)),
    (3, Fraction(3)),
])
def test_numbers_are_exact(given, value):
    scene = two_disks(disks=[{"center": [given, 0], "radius": 1, "velocity": [0, given]}])
    disk = scene.disks[0]
    assert disk.x == value and disk.vy == value
    assert scene.diagram(0).t == 0
    # The same where a number is an argument.
    assert scene.diagram(given).t == value


def test_fields_and_back(tmp_path):
    scene = two_disks(name="two", restitution="1/3", container_law="whole",
                      maneuvers=[{"t": 1, "disk": 1, "velocity": ["1/7", 0]}])
    assert scene.restitution == Fraction(1, 3) and scene.container_law == "whole"
    assert scene.maneuvers == [vp.Maneuver(1, 1, Fraction(1, 7), 0)]
    assert scene.container == (0, 0, 10) and scene.horizon == 8 and len(scene) == 2
    assert vp.Scene(scene.to_dict()) == scene
    assert pickle.loads(pickle.dumps(scene)) == scene
    scene.write(tmp_path / "a.json")
    assert vp.Scene.read(tmp_path / "a.json") == scene
    assert vp.Scene.read(tmp_path / "a.json").sha256 == scene.sha256
    # A file of other bytes has another identity, which a copy keeps.
    (tmp_path / "b.json").write_text(json.dumps(scene.to_dict()))
    other = vp.Scene.read(tmp_path / "b.json")
    assert other == scene and other.sha256 != scene.sha256
    assert pickle.loads(pickle.dumps(other)).sha256 == other.sha256
    assert scene.replace(horizon="1/2").horizon == Fraction(1, 2)
    np.testing.assert_array_equal(scene.radii, [1, 1])


def test_arrays_are_taken():
    centers = np.array([[0.5, 0], [4, 0]])
    scene = two_disks(disks=[{"center": c, "radius": np.float64(1), "velocity": c} for c in centers])
    assert scene.disks[0].x == Fraction(1, 2)


def test_what_is_no_scene_is_named(tmp_path):
    with pytest.raises(vp.InputError) as caught:
        two_disks(disks=[{"center": [0, 0], "radius": 1, "velocity": [0, float("nan")]}])
    assert caught.value.field == "disks[0].velocity[1]"
    assert caught.value.file == "scene" and caught.value.line == 0
    assert isinstance(caught.value, ValueError)
    with pytest.raises(vp.InputError, match="overlap"):
        two_disks(disks=[{"center": [0, 0], "radius": 1, "velocity": [0, 0]}] * 2)
    (tmp_path / "a.json").write_text('{"format": "voroproof-scene",\n "version": 1,\n "horizon": "x"}')
    with pytest.raises(vp.InputError) as caught:
        vp.Scene.read(tmp_path / "a.json")
    assert caught.value.line == 3 and caught.value.file == str(tmp_path / "a.json")
    assert pickle.loads(pickle.dumps(caught.value)).line == 3
    with pytest.raises(TypeError, match="object"):
        two_disks(name=object())
    with pytest.raises(vp.OutputError):
        two_disks().write(tmp_path / "no" / "a.json")
    assert issubclass(vp.OutputError, OSError)


def test_generators():
    assert len(vp.Scene.reference(5, radii="equal")) == 5
    assert len(vp.Scene.grid(9, motion="rest")) == 9
    assert vp.Scene.swarm(4, horizon=10).maneuvers[0].t == 5
    assert vp.Scene.reference(5, seed=2) != vp.Scene.reference(5)
    with pytest.raises(ValueError, match="uniform, log, equal"):
        vp.Scene.reference(5, radii="large")
    with pytest.raises(ValueError):
        vp.Scene.reference(-1)


def test_nobody():
    scene = two_disks(disks=[])
    history = vp.simulate(scene)
    assert len(history) == 0 and history.positions(8).shape == (0, 2)
    assert history.sample([0, 1]).shape == (2, 0, 2)
    assert vp.certify(scene, history).certified
    assert json.loads(scene.text)["disks"] == []
