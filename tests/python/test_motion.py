"""Places and gaps on recorded paths, against the same in Fractions."""

import math
from decimal import Decimal, localcontext
from fractions import Fraction

import numpy as np
import pytest

import voroproof as vp


@pytest.fixture(scope="module")
def history():
    return vp.simulate(vp.Scene.reference(25, horizon=80, density=0.2))


def exact_position(history, disk, t):
    """Where the paths lead, by nothing but the scene and the events."""
    given = history.scene.disks[disk]
    since, center, velocity = Fraction(0), (given.x, given.y), (given.vx, given.vy)
    for event in history.events:
        if Fraction(event["t"]) > t:
            break
        if event["kind"] != vp.COLLISION:
            continue
        for side in range(2):
            if event["ids"][side] == disk:
                # It turns where it is.
                center = tuple(c + v * (Fraction(event["t"]) - since) for c, v in zip(center, velocity))
                since = Fraction(event["t"])
                velocity = tuple(map(Fraction, event["velocity"][side]))
    return tuple(c + v * (t - since) for c, v in zip(center, velocity))


TIMES = [0, 0.1, Fraction(1, 3), "12.345", 40, math.pi * 20, Fraction(79999, 1000), 80]


def test_positions_are_the_nearest(history):
    assert history.counts()["collision"] > 100
    for t, sampled in zip(TIMES, history.sample(TIMES)):
        positions = history.positions(t)
        np.testing.assert_array_equal(positions, sampled)
        for disk, place in enumerate(positions):
            # The quotient of two integers is rounded to nearest.
            exact = exact_position(history, disk, Fraction(t))
            assert tuple(place) == tuple(q.numerator / q.denominator for q in exact)


def test_positions_at_events_are_near_those_recorded(history):
    for event in history.events[history.events["kind"] == vp.COLLISION]:
        for side in range(2):
            disk = event["ids"][side]
            if disk >= 0:
                np.testing.assert_allclose(history.positions(event["t"])[disk], event["center"][side], rtol=0, atol=1e-9)


def exact_gap(history, i, j, t):
    with localcontext() as context:
        context.prec = 80
        decimal = lambda q: Decimal(q.numerator) / Decimal(q.denominator)
        x, y, radius = history.scene.container
        a = exact_position(history, i, t)
        b = exact_position(history, j, t) if j >= 0 else (x, y)
        distance = decimal((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2).sqrt()
        reach = history.scene.disks[i].radius
        if j < 0:
            return decimal(radius - reach) - distance
        return distance - decimal(reach + history.scene.disks[j].radius)


@pytest.mark.parametrize("i, j", [(0, 1), (7, 3), (5, -1)])
def test_gaps_within_an_ulp(history, i, j):
    for t, gap in zip(TIMES, history.gap_series(i, j, TIMES)):
        assert abs(Decimal(gap) - exact_gap(history, i, j, Fraction(t))) <= Decimal(math.ulp(gap))
    assert history.gap_series(j, i, TIMES).tolist() == history.gap_series(i, j, TIMES).tolist()


def test_the_least_gap_is_below_every_sample(history):
    for i, j in [(0, 1), (2, -1), (4, 9)]:
        least = history.least_gap(i, j)
        assert least.gap[0] <= history.gap_series(i, j).min() + 1e-12
        near = history.gap_series(i, j, [least.t])[0]
        assert least.contact or least.gap[0] <= near <= least.gap[1]
    assert history.least_gap().contact
    before = history.least_gap(start=0, end=Fraction(1, 7))
    assert before.t <= Fraction(1, 7)
    with pytest.raises(ValueError):
        history.least_gap(3)


def test_neighbours_over_time_are_those_of_diagrams(history):
    for t in (0, "11.5", 70):
        now = {n.generator for n in history.neighbours_over(4) if n.start <= Fraction(t) < n.end}
        assert sorted(now) == history.diagram(t).neighbours(4)


def test_what_is_not_covered_is_refused(history):
    with pytest.raises(ValueError, match="beyond"):
        history.positions(80.5)
    with pytest.raises(ValueError):
        history.positions(-1)
    with pytest.raises(ValueError):
        history.positions(float("nan"))
    with pytest.raises(ValueError, match="no generator"):
        history.gap_series(0, 25)
    with pytest.raises(TypeError):
        history.positions(None)
    stopped = vp.simulate(history.scene, max_events=50)
    assert not stopped.ending.complete
    assert stopped.times()[-1] < stopped.ending.t
    assert stopped.gap_series(0, 1).shape == (1001,)
    with pytest.raises(ValueError, match="beyond"):
        stopped.positions(stopped.ending.t)


def test_places_that_are_not_told(history):
    events = history.events.copy()
    events["center"] = np.nan
    np.testing.assert_array_equal(history.with_events(events).positions(70), history.positions(70))
    events["velocity"] = np.nan
    with pytest.raises(vp.InputError, match="its v is needed"):
        history.with_events(events).positions(1)
