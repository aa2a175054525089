"""The weighted diagram of any disks: arrays in, arrays and maps out."""

import json

import numpy as np
import pytest

import voroproof as vp


def area(polygon):
    x, y = polygon.T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


@pytest.fixture(scope="module")
def diagram():
    random = np.random.default_rng(1)
    return vp.voronoi(random.uniform(0, 20, (400, 2)), random.uniform(0, 1, 400))


def test_neighbours_are_those_of_edges(diagram):
    visible = int((~diagram.hidden).sum())
    assert 0 < visible < 400
    assert diagram.edges.shape == (3 * (visible + 1) - 6, 4)
    assert set(map(tuple, diagram.neighbours)) == {
        (min(l, r), max(l, r)) for l, r, _, _ in diagram.edges.tolist() if min(l, r) >= 0}
    for disk, host in enumerate(diagram.hosts):
        if host != -2:
            gap = np.linalg.norm(diagram.centers[disk] - diagram.centers[host])
            assert gap <= diagram.radii[host] - diagram.radii[disk] + 1e-12


def test_vertices_touch_their_three(diagram):
    for k in range(3):
        g = diagram.vertices[:, k]
        far = np.linalg.norm(diagram.vertex_positions - diagram.centers[g], axis=1)
        np.testing.assert_allclose(far, diagram.vertex_radii + diagram.radii[g], rtol=1e-9)


def test_cells_fill_the_box(diagram):
    x0, y0, x1, y1 = diagram.box
    cells = diagram.cells()
    assert [bool(cell) for cell in cells] == (~diagram.hidden).tolist()
    assert sum(area(p) for cell in cells for p in cell) == pytest.approx((x1 - x0) * (y1 - y0))
    small = diagram.cells((5, 5, 6, 6), 1e-4)
    assert sum(area(p) for cell in small for p in cell) == pytest.approx(1)


def test_geojson(diagram):
    names = [f"town {k}" for k in range(400)]
    features = json.loads(diagram.to_geojson(columns={"name": names}))["features"]
    assert [feature["properties"]["name"] for feature in features] == names
    with pytest.raises(ValueError, match="name"):
        diagram.to_geojson(columns={"name": names[1:]})
    for feature, hidden in zip(features, diagram.hidden):
        assert (feature["geometry"] is None) == hidden
        if not hidden:
            ring = feature["geometry"]["coordinates"][0]
            ring = ring if feature["geometry"]["type"] == "Polygon" else ring[0]
            assert ring[0] == ring[-1]


def test_frame_and_few_disks():
    framed = vp.voronoi([[0, 0], [4, 0]], [1, 2], frame=(2, 0, 5))
    assert framed.edges.tolist() == [[-1, 0, 1, 1], [-1, 1, 0, 0], [0, 1, -1, -1]]
    assert repr(framed) == "<StaticDiagram of 2 disks in a circle, 0 hidden>"
    assert vp.voronoi([], []).edges.shape == (0, 4)
    assert vp.voronoi([[1, 1], [1, 1]], [2, 2]).hosts.tolist() == [-2, 0]


@pytest.mark.parametrize("centers, radii, frame, word", [
    ([[0, 0]], [1, 2], None, "radii"),
    ([0, 0], [1], None, "centers"),
    ([[0, 0, 0]], [1], None, "centers"),
    ([[0, float("nan")]], [1], None, "center"),
    ([[0, 0]], [float("inf")], None, "radius"),
    ([[0, 0]], [-1], (0, 0, 1), "negative"),
    ([[0, 0]], [1], (0, 0, 0), "frame"),
])
def test_bad_values(centers, radii, frame, word):
    with pytest.raises(ValueError, match=word):
        vp.voronoi(centers, radii, frame)


def test_bad_boxes(diagram):
    for box, tolerance in (((0, 0, 0, 1), 0.1), ((0, 0, 1), 0.1), ((0, 0, 1, 1), 1e-12)):
        with pytest.raises(ValueError):
            diagram.cells(box, tolerance)
