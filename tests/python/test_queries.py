"""Instants and plans."""

from fractions import Fraction

import numpy as np
import pytest

import voroproof as vp


def test_an_instant():
    scene = vp.Scene.grid(9, motion="rest", spacing=4, radius=1)
    instant = scene.at(0)
    near = instant.nearest(2, 2, 4)
    # The centre of a square of the lattice: all four at the very same distance.
    assert [n.tied for n in near] == [False, True, True, True]
    assert near[0].distance[0] <= np.sqrt(8) - 1 <= near[0].distance[1]
    closest = instant.closest_disks()
    assert len(closest.pairs) == 12 and closest.gap[0] <= 2 <= closest.gap[1]
    diagram = scene.diagram(0)
    assert [n.generator for n in instant.neighbours(4)] == diagram.neighbours(4)
    with pytest.raises(ValueError):
        instant.neighbours(9)
    assert instant.closest_generators().gap[0] <= closest.gap[1]


def test_a_plan():
    vehicles = [vp.Vehicle(1, (-10, 0), (10, 0)), vp.Vehicle(1, (0, -10), (0, 10))]
    plan = vp.plan(vehicles, container=(0, 0, 50), arrive=10, clearance="1/3")
    assert plan.found and plan.avoided == 1 and plan.conflict is None
    assert plan.nearest.gap[0] >= 1 / 3
    history = vp.simulate(plan.scene)
    assert history.counts()["collision"] == 0
    least = history.least_gap()
    # The history rounds the times at which vehicles turn, and their velocities.
    assert abs(least.t - plan.nearest.t) < 1e-13 and least.gap == pytest.approx(plan.nearest.gap, abs=1e-13)
    np.testing.assert_allclose(history.positions(10), [[10, 0], [0, 10]], atol=1e-12)


def test_no_plan():
    vehicles = [(1, (-10, 0), (10, 0)), (1, (10, 3), (10, Fraction(1)))]
    plan = vp.plan(vehicles, container=(0, 0, 50), arrive=10)
    assert not plan.found and (plan.conflict.i, plan.conflict.j) == (0, 1)
    with pytest.raises(vp.InputError) as caught:
        vp.plan([(1, (-60, 0), (10, 0))], container=(0, 0, 50), arrive=10)
    assert caught.value.file == "plan"
