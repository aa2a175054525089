"""Long work: other threads run, progress is told, and Ctrl-C ends it. Nothing here waits for a time:
the scene would take hours."""

import os
import signal
import sys
import threading

import pytest

import voroproof as vp


@pytest.fixture(scope="module")
def endless():
    return vp.Scene.reference(3000, horizon=1_000_000)


@pytest.fixture(autouse=True)
def no_switching():
    """Other threads get Python's lock only where it is given away."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    yield
    sys.setswitchinterval(before)


def test_ctrl_c(endless):
    thread = threading.Thread(target=lambda: os.kill(os.getpid(), signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        thread.start()
        vp.simulate(endless)
    thread.join()


def test_other_threads_run(endless):
    ran = threading.Event()
    thread = threading.Thread(target=ran.set)
    thread.start()
    history = vp.simulate(endless, progress=lambda t, events: not ran.is_set())
    thread.join()
    assert not history.ending.complete and history.ending.reason == "interrupted"


def test_what_progress_raises_arrives(endless):
    def progress(t, events):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        vp.simulate(endless, progress=progress)


def test_progress_is_told_the_end():
    scene = vp.Scene.reference(10, horizon=20)
    told = []
    history = vp.simulate(scene, progress=lambda t, events: told.append((t, events)))
    assert told[-1] == (20, len(history))
    vp.certify(scene, history, progress=lambda t, events: told.append((t, events)))
    assert told[-1] == (20, len(history))


def test_certifying_is_interrupted():
    scene = vp.Scene.reference(100, horizon=300)
    history = vp.simulate(scene)
    with pytest.raises(vp.Interrupted):
        vp.certify(scene, history, progress=lambda t, events: False)
    with pytest.raises(ZeroDivisionError):
        vp.certify(scene, history, truth="recorded", progress=lambda t, events: 1 / 0)
