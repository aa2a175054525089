"""Billiards: arrays in, exact histories out, verdicts in the program's words, refusals by name."""

import json
import os
import pickle
import signal
import subprocess
import threading
from fractions import Fraction

import numpy as np
import pytest

import voroproof as vp

NONE = -2**31


def cell(**fields):
    """Two balls in a periodic box that meet at 1, through the border, and at 4."""
    return vp.Billiard.from_arrays([[1, 4, 4], [6, 4, 4]], 0.5, velocities=[[-1, 0, 0], [1, 0, 0]],
                                   periodic=[8, 8, 8], **{"horizon": 5, **fields})


def box(**fields):
    """Three disks, one of which is fixed, between two walls and periodic besides."""
    walls = [{"normal": [0, 1], "offset": 0}, {"normal": [0, -1], "offset": -10}]
    return vp.Billiard.from_arrays([[1, 5], [7, 5], [4, 2]], [1, 1, 1], velocities=[[-2, 0.5], [0, 0], [0, 0]],
                                   masses=[1, 2, 1], periodic=[10, None], walls=walls,
                                   **{"fixed": [False, False, True], "horizon": 20, **fields})


@pytest.fixture(scope="module")
def history():
    return vp.simulate(cell())


def event(**fields):
    """A collision of 0 and 1 without velocities and places."""
    row = np.zeros(1, dtype=vp.billiard_event_dtype)
    row["velocity"] = row["center"] = np.nan
    row["kind"], row["ids"], row["image"] = vp.COLLISION, [0, 1], NONE
    for name, value in fields.items():
        row[name] = value
    return row


def test_arrays_and_fields_and_files(tmp_path):
    billiard = box(gravity=[0, "-1/3"], restitution=Fraction(1, 2))
    assert len(billiard) == 3 and billiard.dimension == 2 and billiard.horizon == 20
    fields = billiard.to_dict()
    assert fields["gravity"] == [0, "-1/3"] and fields["restitution"] == "1/2"
    assert fields["disks"][2] == {"center": [4, 2], "velocity": [0, 0], "radius": 1, "mass": 1, "fixed": True}
    assert vp.Billiard(fields) == billiard and billiard.replace(horizon=3).horizon == 3
    billiard.write(tmp_path / "a.json")
    read = vp.Billiard.read(tmp_path / "a.json")
    assert read == billiard and read.sha256 == billiard.sha256 and hash(read) == hash(billiard)
    assert vp.Billiard.parse(billiard.text) == pickle.loads(pickle.dumps(billiard)) == billiard
    assert repr(cell()) == "<Billiard: 2 balls in space, horizon 5>"
    free = vp.Billiard.from_arrays(np.array([[Fraction(1, 3), 0]]), np.float32(0.5), horizon="1/2", growths=0.25)
    assert free.to_dict()["disks"] == [{"center": ["1/3", 0], "velocity": [0, 0], "radius": 0.5, "growth": 0.25}]
    assert free.to_dict()["frame"] == "none"


def test_what_the_events_say(history):
    events = history.events
    assert events["t"].tolist() == [1, 4] and events["ids"].tolist() == [[0, 1], [0, 1]]
    assert events["image"].tolist() == [[-1, 0, 0], [0, 0, 0]]
    assert events["velocity"][0].tolist() == [[1, 0, 0], [-1, 0, 0]]
    assert events["center"][1].tolist() == [[3, 4, 4], [4, 4, 4]]
    assert history.ending == (True, 5, "") and len(history) == 2 and history.horizon == 5
    assert repr(history) == "<BilliardHistory: 2 collisions, 0 maneuvers; complete up to 5>"
    with pytest.raises(ValueError):
        events["t"][0] = 1


@pytest.mark.parametrize("truth", ["exact", "recorded"])
@pytest.mark.parametrize("billiard", [
    cell(), box(), box(gravity=[0.25, 0], fixed=None),
    vp.Billiard.from_arrays([[0, 0], [4, 0]], 1, velocities=[[1, 0.25], [0, 0]], periodic=[8, 8], shear=0.5, horizon=12),
    vp.Billiard.from_arrays([[0, 0], [4, 0]], 1, velocities=[[1, 0], [0, 0]], horizon=5, restitution=0.5,
                            maneuvers=[{"t": 3, "disk": 0, "velocity": [0, 1]}]),
], ids=["cell", "box", "gravity", "shear", "maneuver"])
def test_what_is_simulated_is_certified(billiard, truth):
    history = vp.simulate(billiard)
    assert len(history) > 0
    told = []
    report = vp.certify(billiard, history, truth=truth, progress=lambda t, events: told.append((t, events)))
    assert report.certified and report.words == "CERTIFIED (collisions alone)"
    assert report.collisions + report.maneuvers == len(history)
    assert told[-1] == (report.prefix_t, len(history))
    assert f"{truth} truth" in report.about
    assert vp.certify(billiard, history, truth=truth, events="collisions") == report
    # An event that is left out, or whose velocity is another one, is not.
    assert vp.certify(billiard, vp.BilliardHistory(billiard, history.events[1:]), truth=truth).verdict == "refuted"
    events = history.events.copy()
    events["velocity"][0] *= 1.5
    assert vp.certify(billiard, vp.BilliardHistory(billiard, events), truth=truth).verdict == "refuted"


def test_an_engine_of_ones_own():
    billiard = cell()
    events = np.concatenate([
        event(t=1, image=[-1, 0, 0], velocity=[[[1, 0, 0], [-1, 0, 0]]]),
        event(t=4 + 1e-5, velocity=[[[-1, 0, 0], [1, 0, 0]]])])  # the nearest image
    mine = vp.BilliardHistory(billiard, events, producer="mine 1")
    late = vp.certify(billiard, mine, truth="recorded")
    assert late.divergence.fault == "wrong time" and late.divergence.line == 3 and late.divergence.pair == (0, 1)
    report = vp.certify(billiard, mine, truth="recorded", tolerance="1e-4")
    assert report.certified and report.to_dict()["history_producer"] == "mine 1"
    events["image"][0] = [1, 0, 0]
    wrong = vp.certify(billiard, vp.BilliardHistory(billiard, events), truth="recorded")
    assert wrong.divergence.fault == "wrong image" and wrong.divergence.line == 2
    assert "ball 1 at image [-1,0,0] touch" in wrong.explain() and wrong.evidence.startswith("none")
    short = vp.BilliardHistory(billiard, mine.events[:1], horizon=2)
    assert vp.certify(billiard, short).leniency[0].name == "other_horizon"
    stopped = vp.BilliardHistory(billiard, mine.events[:1], ending=vp.Ending(False, 2, "enough"))
    report = vp.certify(billiard, stopped)
    assert report.verdict == "undecided" and "the history stops: enough" in report.reason


def test_what_is_not_proved_is_not_of_the_prefix(history):
    """Where times are within 1/2, up to 5/4 the truth is known up to 3/4."""
    stopped = vp.BilliardHistory(cell(), history.events[:1], ending=vp.Ending(False, 1.25, "enough"))
    report = vp.certify(cell(), stopped, tolerance=0.5)
    assert (report.verdict, report.prefix_t, report.prefix_events) == ("undecided", 0.75, 0)


def test_files_and_back(tmp_path, history):
    billiard = cell()
    history.write(tmp_path / "a.jsonl")
    read = vp.BilliardHistory.read(tmp_path / "a.jsonl", billiard)
    assert read.events.tobytes() == history.events.tobytes()
    assert read.ending == history.ending and read.producer == history.producer and read.rounded == 0
    stopped = vp.simulate(billiard, max_events=1)
    assert not stopped.ending.complete
    stopped.write(tmp_path / "b.jsonl")
    assert vp.BilliardHistory.read(tmp_path / "b.jsonl", billiard).ending == stopped.ending
    with pytest.raises(vp.InputError, match="scene_sha256") as caught:
        vp.BilliardHistory.read(tmp_path / "a.jsonl", billiard.replace(name="other"))
    assert caught.value.line == 1 and caught.value.file == str(tmp_path / "a.jsonl")
    # A file states numbers exactly that an array rounds.
    text = (tmp_path / "a.jsonl").read_text()
    (tmp_path / "c.jsonl").write_text(text.replace('"t":4', '"t":"4000000000000000000001/1000000000000000000000"'))
    assert vp.BilliardHistory.read(tmp_path / "c.jsonl", billiard).rounded == 1
    (tmp_path / "d.jsonl").write_text(text.replace('"collisions":2', '"collisions":3'))
    with pytest.raises(vp.InputError, match="wrong counts"):
        vp.BilliardHistory.read(tmp_path / "d.jsonl", billiard)


@pytest.mark.parametrize("wrong", [False, True])
def test_the_words_are_those_of_the_program(tmp_path, history, wrong):
    program = os.environ.get("VOROPROOF_PROGRAM")
    if program is None:
        pytest.skip("no program")
    scene, file, told = (str(tmp_path / name) for name in ("a.scene.json", "a.history.jsonl", "a.report.json"))
    cell().write(scene)
    simulated = subprocess.run([program, "simulate", scene, "-o", file], capture_output=True, text=True)
    assert simulated.returncode == 0, simulated.stderr
    history.write(tmp_path / "own.jsonl")
    assert (tmp_path / "own.jsonl").read_bytes() == (tmp_path / "a.history.jsonl").read_bytes()
    mine = vp.BilliardHistory(cell(), history.events[1:] if wrong else history.events, producer=history.producer)
    mine.write(file)
    run = subprocess.run([program, "certify", scene, file, "--report", told], capture_output=True, text=True)
    exact = {"tolerance": "1e-6", "law_tolerance": "1e-9"}  # the defaults of the program
    of_files, of_values = vp.certify_files(scene, file, **exact), vp.certify(cell(), mine, **exact)
    assert run.returncode == (1 if wrong else 0)
    assert of_files.json == (tmp_path / "a.report.json").read_text()
    assert f"c {of_files.about}\n" in run.stdout
    names = ("scene", "history")
    assert ({**of_values.to_dict(), **dict.fromkeys(names)} == {**of_files.to_dict(), **dict.fromkeys(names)})


@pytest.mark.parametrize("fields, message", [
    ({"centers": [1, 2]}, r"centers: the shape is neither \(n, 2\) nor \(n, 3\)"),
    ({"centers": np.zeros((2, 4))}, "centers: the shape"),
    ({"radii": [1, 1, 1]}, r"radii: the shape is not \(2,\)"),
    ({"velocities": [[1, 0, 0], [0, 0, 0]]}, r"velocities: the shape is not \(2, 2\)"),
    ({"masses": [1]}, "masses: the shape"),
    ({"fixed": [[True, False]]}, "fixed: the shape"),
])
def test_wrong_shapes(fields, message):
    with pytest.raises(ValueError, match=message):
        vp.Billiard.from_arrays(**{"centers": [[0, 0], [4, 0]], "radii": 1, "horizon": 1, **fields})


@pytest.mark.parametrize("fields, field, reason", [
    ({"centers": [[0, 0], [4, np.nan]]}, "disks[1].center[1]", ""),
    ({"radii": [1, -1]}, "disks[1].radius", "negative"),
    ({"masses": [1, 0]}, "disks[1].mass", "not positive"),
    ({"centers": [[0, 0], [1, 0]]}, "disks[1]", "overlaps"),
    ({"periodic": [8, 8, 8]}, "frame.periodic", "coordinates"),
    ({"shear": 1}, "frame", "neither round"),
    ({"walls": [{"normal": [1, 1], "offset": 0}]}, "frame.walls[0].normal", "length"),
    ({"walls": [{"normal": [1, 0], "offset": 0}]}, "disks[0]", "inside"),
    ({"gravity": [0]}, "gravity", "coordinates"),
    ({"restitution": 2}, "restitution", "not in [0, 1]"),
    ({"horizon": -1}, "horizon", "negative"),
])
def test_what_is_no_billiard_is_named(fields, field, reason):
    with pytest.raises(vp.InputError) as caught:
        vp.Billiard.from_arrays(**{"centers": [[0, 0], [4, 0]], "radii": 1, "horizon": 1, **fields})
    assert caught.value.field.startswith(field) and reason in caught.value.reason
    assert caught.value.file == "scene" and caught.value.line == 0 and isinstance(caught.value, ValueError)


def test_a_file_that_is_no_billiard_is_named(tmp_path):
    path = tmp_path / "a.json"
    path.write_text(json.dumps(cell().to_dict(), indent=0).replace('"bounce"', '"pass"'))
    with pytest.raises(vp.InputError, match='contacts: not "bounce"') as caught:
        vp.Billiard.read(path)
    assert caught.value.file == str(path) and caught.value.line > 1
    path.write_text(json.dumps(cell().replace(disks=[]).to_dict()).replace('"disks": []', '"disks": [1]'))
    with pytest.raises(vp.InputError, match=r"disks\[0\]"):
        vp.Billiard.read(path)
    with pytest.raises(vp.InputError, match="version"):
        vp.Billiard(vp.Scene.grid(4).to_dict())
    with pytest.raises(vp.InputError, match="cannot read"):
        vp.Billiard.read(tmp_path / "none.json")


@pytest.mark.parametrize("fields, field", [
    ({"t": np.nan}, "t"), ({"t": -1}, "t"), ({"t": 6}, "t"),
    ({"kind": vp.FLIP}, "kind"),
    ({"ids": [0, 2]}, "collide"), ({"ids": [1, 0]}, "collide"), ({"ids": [-1, 0]}, "collide"),
    ({"image": [0, NONE, 0]}, "image"),
    ({"velocity": np.inf}, "v"), ({"center": [[[0, 0, np.nan]] * 2]}, "p"),
    ({"velocity": [[[1, 0, 0], [np.nan] * 3]]}, "v"),
    ({"kind": vp.MANEUVER, "ids": [5, 0]}, "maneuver"),
])
def test_what_is_no_event_is_named(fields, field):
    billiard = cell()
    events = np.concatenate([event(t=1), event(**{"t": 1, **fields})])
    with pytest.raises(vp.InputError) as caught:
        vp.certify(billiard, vp.BilliardHistory(billiard, events))
    assert caught.value.line == 3 and caught.value.field.startswith(field) and caught.value.file == "history"


def test_the_plane_has_no_third_coordinate(tmp_path):
    billiard = box()
    for name, field in (("center", "p"), ("image", "image")):
        other = vp.BilliardHistory(billiard, event(t=1, **{name: 1}))
        with pytest.raises(vp.InputError, match=f"{field}: a third coordinate") as caught:
            other.write(tmp_path / "a.jsonl")
        assert caught.value.line == 2
    assert not (tmp_path / "a.jsonl").exists()


def test_other_refusals(history):
    with pytest.raises(ValueError, match="strict"):
        vp.certify(cell(), history, strict=True)
    with pytest.raises(ValueError, match="order"):
        vp.certify(cell(), history, order="any")
    with pytest.raises(ValueError, match="tolerance"):
        vp.certify(cell(), history, tolerance=6)
    with pytest.raises(ValueError, match="max_bits"):
        vp.simulate(cell(), max_bits=2)
    with pytest.raises(vp.InputError, match="scene_sha256"):
        vp.certify(cell(horizon=6), history)
    with pytest.raises(ValueError, match="one dimension"):
        vp.BilliardHistory(cell(), history.events.reshape(1, -1))


@pytest.fixture(scope="module")
def endless():
    rng = np.random.default_rng(1)
    centers = np.stack(np.meshgrid(*[np.arange(0, 40, 4)] * 2), axis=-1).reshape(-1, 2)
    return vp.Billiard.from_arrays(centers, 1, velocities=rng.uniform(-3, 3, centers.shape), periodic=[40, 40],
                                   horizon=1_000_000)


def test_ctrl_c(endless):
    thread = threading.Thread(target=lambda: os.kill(os.getpid(), signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        thread.start()
        vp.simulate(endless)
    thread.join()


def test_interruption(endless):
    ran = threading.Event()
    thread = threading.Thread(target=ran.set)
    thread.start()
    history = vp.simulate(endless, progress=lambda t, events: not ran.is_set())
    thread.join()
    assert not history.ending.complete and history.ending.reason == "interrupted"
    with pytest.raises(ZeroDivisionError):
        vp.simulate(endless, progress=lambda t, events: 1 / 0)
    many = vp.simulate(endless, max_events=3000)
    for truth in ("exact", "recorded"):
        with pytest.raises(vp.Interrupted):
            vp.certify(endless, many, truth=truth, progress=lambda t, events: False)


def test_a_frame(history):
    pandas = pytest.importorskip("pandas")
    frame = history.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and len(frame) == 2
    np.testing.assert_array_equal(frame["vx0"], [1, -1])
    assert frame["image_x"].tolist() == [-1, 0] and frame["id1"].tolist() == [1, 1] and "z1" in frame
    plane = vp.simulate(vp.Billiard.from_arrays([[0, 0], [4, 0]], 1, velocities=[[1, 0], [0, 0]], horizon=3,
                                                maneuvers=[{"t": 1, "disk": 0, "velocity": [2, 0]}])).to_pandas()
    assert plane["id1"].isna().tolist() == [True, False] and plane["image_y"].isna().all() and "z1" not in plane
