"""The three pictures: one call each, and they show the numbers."""

import numpy as np
import pytest

import voroproof as vp

plt = pytest.importorskip("matplotlib.pyplot")


@pytest.fixture(scope="module")
def history():
    return vp.simulate(vp.Scene.reference(20, horizon=60))


def test_events(history):
    ax = history.plot_events()
    counts = {line.get_label(): line.get_ydata()[-1] for line in ax.lines}
    told = history.counts()
    assert counts == {"flips": told["flip"], "collisions": told["collision"]}


def test_gap(history):
    events = history.events
    hit = events[(events["kind"] == vp.COLLISION) & (events["ids"][:, 0] >= 0)][0]
    i, j = map(int, hit["ids"][:2])
    figure, ax = plt.subplots()
    assert history.plot_gap(j, i, ax) is ax
    times, gaps = ax.lines[0].get_data()
    np.testing.assert_array_equal(gaps, history.gap_series(i, j, times))
    assert hit["t"] in ax.lines[1].get_xdata()
    assert abs(gaps[times == hit["t"]]).max() < 1e-9
    assert ax.get_ylabel() == f"gap of disk {j} and disk {i}"


def test_diagram(history):
    diagram = history.diagram(30)
    ax = history.plot_diagram(30)
    disks, edges = ax.collections
    assert len(disks.get_paths()) == 20
    assert len(edges.get_segments()) == len(diagram.edges)


@pytest.mark.parametrize("n", [0, 1])
def test_few(n):
    history = vp.simulate(vp.Scene.reference(n, horizon=5))
    history.plot_events()
    assert len(history.plot_diagram(2).collections[1].get_segments()) == n
    if n == 1:
        history.plot_gap(0, vp.CONTAINER)
