"""Diagrams: names, places, cells, against the definition of a Voronoi cell."""

import numpy as np
import pytest

import voroproof as vp


@pytest.fixture(scope="module")
def history():
    return vp.simulate(vp.Scene.reference(40, horizon=50))


def distances(diagram, points):
    """Distance of each point from the boundary of each disk and, last, of the container."""
    apart = points[:, None, :] - diagram.positions[None, :, :]
    x, y, radius = diagram.container
    to_disks = np.hypot(apart[..., 0], apart[..., 1]) - diagram.radii
    to_wall = radius - np.hypot(points[:, 0] - x, points[:, 1] - y)
    return np.column_stack((to_disks, to_wall))


def test_both_ways_agree(history):
    for t in (0, "17.25", 50):
        replayed, computed = history.diagram(t), history.scene.diagram(t)
        np.testing.assert_array_equal(replayed.edges, computed.edges)
        np.testing.assert_array_equal(replayed.vertices, computed.vertices)
        np.testing.assert_allclose(replayed.positions, computed.positions, rtol=0, atol=1e-9)


def test_vertices_touch_their_three(history):
    diagram = history.diagram(20)
    n = len(diagram.radii)
    assert diagram.edges.shape == (3 * (n + 1) - 6, 4)
    assert diagram.vertices.shape == (2 * (n + 1) - 4, 3)
    reach = distances(diagram, diagram.vertex_positions)
    for row, names, radius in zip(reach, diagram.vertices, diagram.vertex_radii):
        np.testing.assert_allclose(row[names], radius, atol=1e-10)
        assert row.min() >= radius - 1e-10


def test_cells_hold_what_is_nearest(history):
    diagram = history.diagram(20)
    cells = diagram.cell_polygons(1e-6 * diagram.container[2])
    assert len(cells) == len(diagram.radii) + 1
    for disk, cell in enumerate(cells[:-1]):
        reach = distances(diagram, cell)
        np.testing.assert_allclose(reach[:, disk], reach.min(axis=1), atol=1e-3)
    areas = diagram.cell_areas(1e-6 * diagram.container[2])
    assert (areas > np.pi * diagram.radii ** 2).all()
    assert areas.sum() < np.pi * diagram.container[2] ** 2
    with pytest.raises(ValueError, match="tolerance"):
        diagram.cell_polygons(0)


def test_neighbours(history):
    diagram = history.diagram(20)
    for g in range(-1, 40):
        edges = diagram.edges
        beside = set(edges[edges[:, 0] == g, 1]) | set(edges[edges[:, 1] == g, 0])
        assert diagram.neighbours(g) == sorted(beside)


def test_polylines_end_in_vertices(history):
    diagram = history.diagram(20)
    places = {tuple(v) for v in diagram.vertex_positions}
    for line in diagram.edge_polylines():
        assert tuple(line[0]) in places and tuple(line[-1]) in places


def test_files(tmp_path, history):
    history.diagram("1/3").write(tmp_path / "a.diagram.json")
    read = vp.Diagram.read(tmp_path / "a.diagram.json")
    assert read.t.denominator == 3
    np.testing.assert_array_equal(read.edges, history.diagram("1/3").edges)


def test_an_illegal_diagram_is_refused(history):
    flipless = history.with_events(history.events[history.events["kind"] != vp.FLIP])
    with pytest.raises(vp.InputError, match="illegal"):
        flipless.diagram(50)
    assert len(flipless.diagram(50, checked=False).edges) == len(history.diagram(50).edges)


@pytest.mark.parametrize("n", [0, 1, 2])
def test_few(n):
    diagram = vp.Scene.reference(n, horizon=1).diagram(1)
    assert len(diagram.edges) == (0 if n < 2 else 3 * (n + 1) - 6)
    cells = diagram.cell_polygons()
    assert len(cells) == n + 1 and all((len(cell) > 2) == (n > 0) for cell in cells)
