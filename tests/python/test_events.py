"""Histories as arrays: the memory itself, and back to a history that is certified."""

import numpy as np
import pytest

import voroproof as vp


@pytest.fixture(scope="module")
def scene():
    return vp.Scene.reference(30, horizon=60)


@pytest.fixture(scope="module")
def history(scene):
    return vp.simulate(scene)


def test_the_array_is_the_memory_itself(history):
    first, again = history.events, history.events
    assert first.dtype == vp.event_dtype
    assert np.shares_memory(first, again)
    assert first.__array_interface__["data"][0] == again.__array_interface__["data"][0]
    with pytest.raises(ValueError):
        first["t"][0] = 1


def test_the_array_keeps_its_memory():
    events = vp.simulate(vp.Scene.reference(10, horizon=20)).events
    again = vp.simulate(vp.Scene.reference(10, horizon=20)).events
    assert events.tobytes() == again.tobytes()


def test_what_the_fields_say(scene, history):
    events = history.events
    assert np.all(np.diff(events["t"]) >= 0)
    counts = history.counts()
    assert sum(counts.values()) == len(history) and counts["flip"] > 0 and counts["collision"] > 0
    flips = events[events["kind"] == vp.FLIP]
    assert flips["ids"].min() >= -1 and flips["ids"].max() < 30
    assert np.isnan(flips["velocity"]).all()
    walls = events[(events["kind"] == vp.COLLISION) & (events["ids"][:, 0] == vp.CONTAINER)]
    assert np.isnan(walls["center"][:, 0]).all()
    # At the wall a disk is as far from the centre as its radius lets.
    x, y, radius = map(float, scene.container)
    far = np.hypot(walls["center"][:, 1, 0] - x, walls["center"][:, 1, 1] - y)
    np.testing.assert_allclose(far + scene.radii[walls["ids"][:, 1]], radius, rtol=1e-14)


def test_files_and_back(tmp_path, scene, history):
    history.write(tmp_path / "a.jsonl")
    read = vp.History.read(tmp_path / "a.jsonl", scene)
    assert read.events.tobytes() == history.events.tobytes()
    assert read.ending == history.ending and read.ending.complete and read.ending.t == 60
    np.testing.assert_array_equal(read.initial, history.initial)
    read.write(tmp_path / "b.jsonl")
    assert (tmp_path / "a.jsonl").read_bytes() == (tmp_path / "b.jsonl").read_bytes()
    with pytest.raises(vp.InputError, match="another scene"):
        vp.History.read(tmp_path / "a.jsonl", scene.replace(name="other"))
    with pytest.raises(ValueError, match="without its scene"):
        vp.History.read(tmp_path / "a.jsonl").positions(0)
    (tmp_path / "c.jsonl").write_text((tmp_path / "a.jsonl").read_text().replace('"t"', '"u"', 1))
    with pytest.raises(vp.InputError) as caught:
        vp.History.read(tmp_path / "c.jsonl")
    assert caught.value.line == 2


def test_an_engine_of_ones_own(scene, history):
    made = vp.History(scene, history.events, initial=history.initial, producer="mine 1")
    assert made.producer == "mine 1"
    assert vp.certify(scene, made).certified
    assert vp.certify(scene, vp.History(scene, history.events)).certified
    events = history.events.copy()
    events["kind"][3] = 9
    with pytest.raises(ValueError, match="no kind"):
        vp.History(scene, events)
    events = history.events.copy()
    events["t"][3] = -1
    with pytest.raises(vp.InputError) as caught:
        vp.certify(scene, history.with_events(events))
    assert caught.value.line == 5  # event k is on line k + 2


def test_with_events_keeps_the_rest(scene):
    stopped = vp.simulate(scene, max_events=20)
    other = stopped.with_events(stopped.events[:10])
    assert other.ending == stopped.ending and not other.ending.complete
    assert other.producer == stopped.producer and other.horizon == stopped.horizon
    np.testing.assert_array_equal(other.initial, stopped.initial)


def test_maneuvers():
    scene = vp.Scene.swarm(4, horizon=20)
    history = vp.simulate(scene)
    told = history.events[history.events["kind"] == vp.MANEUVER]
    assert len(told) == 4 and sorted(told["ids"][:, 0]) == [0, 1, 2, 3]
    assert (told["velocity"][:, 0] == 0).all() and (told["t"] == 10).all()
    assert vp.certify(scene, history.with_events(history.events.copy())).certified


def test_a_frame(history):
    pandas = pytest.importorskip("pandas")
    frame = history.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and len(frame) == len(history)
    assert (frame["kind"].value_counts().sort_index().to_dict()
            == {k: c for k, c in history.counts().items()})
    np.testing.assert_array_equal(frame["vx1"], history.events["velocity"][:, 1, 0])
    np.testing.assert_array_equal(frame["id3"], history.events["ids"][:, 3])
