"""The weighted diagram of any disks: arrays in, arrays and maps out."""

import json
import os
import re
import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import pytest

import voroproof as vp
from voroproof.colours import cell_colour, disk_colour


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


def test_areas_fill_the_box(diagram):
    measures = diagram.measures()
    x0, y0, x1, y1 = diagram.box
    assert measures.shape == (400,) and measures["centroid"].shape == (400, 2)
    assert abs(measures["area"].sum() - (x1 - x0) * (y1 - y0)) <= measures["area_error"].sum() + 1e-10
    assert measures["area_error"].max() < 1e-9
    np.testing.assert_array_equal(diagram.areas(), measures["area"])
    np.testing.assert_array_equal(measures["area"] == 0, diagram.hidden)
    np.testing.assert_array_equal(np.isnan(measures["centroid"][:, 0]), diagram.hidden)
    for cell, measure in zip(diagram.cells(tolerance=1e-6), measures):
        for polygon in cell:
            assert measure["area"] == pytest.approx(sum(map(area, cell)), abs=1e-4)
    assert diagram.areas((5, 5, 6, 6)).sum() == pytest.approx(1, abs=1e-12)
    assert vp.voronoi([], []).measures((0, 0, 1, 1)).shape == (0,)


def test_arcs_are_on_the_edges(diagram):
    arcs = diagram.edge_arcs(errors=True)
    assert [a.shape[1] for a in diagram.edge_arcs()] == [7] * len(diagram.edges)
    assert len(arcs) == len(diagram.edges)
    t = np.linspace(0, 1, 5)[:, None]
    for (l, r, _, _), edge in zip(diagram.edges.tolist(), arcs):
        assert l >= 0 or len(edge) == 0
        for *curve, error in edge:
            start, control, end, w = np.array(curve[:2]), np.array(curve[2:4]), np.array(curve[4:6]), curve[6]
            a, b, c = (1 - t) ** 2, 2 * t * (1 - t) * w, t ** 2
            points = (a * start + b * control + c * end) / (a + b + c)
            far = [np.linalg.norm(points - diagram.centers[g], axis=1) - diagram.radii[g] for g in (l, r)]
            np.testing.assert_allclose(*far, rtol=0, atol=2 * error + 1e-13)
            assert error < 1e-10


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


def test_nearest_by_the_definition(diagram):
    points = np.random.default_rng(2).uniform(-2, 22, (7, 11, 2))
    generators, distances = diagram.nearest(points)
    assert generators.shape == distances.shape == (7, 11)
    assert generators.dtype.kind == "i"
    all_distances = np.linalg.norm(points[..., None, :] - diagram.centers, axis=-1) - diagram.radii
    np.testing.assert_array_equal(generators, all_distances.argmin(axis=-1))
    np.testing.assert_allclose(distances, all_distances.min(axis=-1), rtol=0, atol=1e-13)
    one, distance = diagram.nearest(points[3, 4])
    assert one.shape == () and int(one) == generators[3, 4] and float(distance) == distances[3, 4]
    assert diagram.nearest(np.empty((3, 0, 2)))[0].shape == (3, 0)
    every_other, _ = diagram.nearest(points[:, ::2])
    np.testing.assert_array_equal(every_other, generators[:, ::2])


def test_nearest_in_a_frame():
    framed = vp.voronoi([[0, 0], [4, 0]], [1, 1], frame=(2, 0, 5))
    generators, distances = framed.nearest([[2, 0], [0, 0], [2, 5], [9, 0]])
    assert generators.tolist() == [1, 0, -1, -1] and distances.tolist() == [1, -1, 0, -2]
    for points, word in ([[1, 2, 3]], "shape"), (3, "shape"), ([[0, float("nan")]], "point 0"):
        with pytest.raises(ValueError, match=word):
            framed.nearest(points)
    with pytest.raises(ValueError, match="no disk"):
        vp.voronoi([], []).nearest([[0, 0]])


def test_voids(diagram):
    voids = diagram.voids(0.5)
    assert len(voids) > 3 and isinstance(voids[0], vp.EmptyCircle)
    assert voids[0] == diagram.largest_empty_circle()
    assert [v.radius for v in voids] == sorted((v.radius for v in voids), reverse=True)
    _, distances = diagram.nearest([v.center for v in voids])
    np.testing.assert_allclose(distances, [v.radius for v in voids], rtol=0, atol=1e-13)
    for void in voids:
        for g in void.generators:
            gap = np.linalg.norm(diagram.centers[g] - void.center) - diagram.radii[g]
            assert gap == pytest.approx(void.radius)
    square = vp.voronoi([[0, 0], [0, 2], [2, 0], [2, 2]], [1, 1, 1, 1])
    assert square.largest_empty_circle((0, 0, 2, 2)) == ((1, 1), 0.41421356237309503, (0, 1, 2, 3))
    assert vp.voronoi([[0, 0]], [9]).largest_empty_circle((0, 0, 2, 2)) is None
    for probe, box in (-1, None), (0, (0, 0, 0, 1)), (0, (0, 0, 1)):
        with pytest.raises(ValueError):
            square.voids(probe, box)


def test_frame_and_few_disks():
    framed = vp.voronoi([[0, 0], [4, 0]], [1, 2], frame=(2, 0, 5))
    assert framed.edges.tolist() == [[-1, 0, 1, 1], [-1, 1, 0, 0], [0, 1, -1, -1]]
    assert repr(framed) == "<StaticDiagram of 2 disks in a circle, 0 hidden>"
    assert vp.voronoi([], []).edges.shape == (0, 4)
    assert vp.voronoi([[1, 1], [1, 1]], [2, 2]).hosts.tolist() == [-2, 0]


def test_walls():
    framed = vp.voronoi([[1, 1], [3, 1]], [0.5, 0.5], frame=(0, 0, 4, 2))
    assert repr(framed) == "<StaticDiagram of 2 disks in a rectangle, 0 hidden>"
    assert framed.box == (0, 0, 4, 2) and framed.neighbours.tolist() == [[0, 1]]
    assert framed.nearest([[0.1, 1], [3, 1]])[0].tolist() == [2, 1]
    left, right = framed.areas()
    assert left == pytest.approx(right) and 0 < left < 4
    assert {len(cell) for cell in framed.cells()} == {1}
    for edge, arcs in zip(framed.edges, framed.edge_arcs()):
        assert (len(arcs) == 0) == (edge[0] == -1)
    report = vp.certify_diagram(framed.centers, framed.radii, frame=framed.frame, edges=framed.edges)
    assert report.certified and "in a rectangle" in report.about
    assert not vp.certify_diagram(framed.centers, framed.radii, frame=(0, 0, 4, 9), edges=framed.edges).certified
    assert vp.voronoi([], [], frame=(0, 0, 4, 2)).edges.shape == (9, 4)
    with pytest.raises(ValueError, match="walls"):
        framed.largest_empty_circle()


@pytest.mark.parametrize("centers, radii, frame, word", [
    ([[0, 0]], [1, 2], None, "radii"),
    ([[0, 0]], [1], (0, 0, 0, 1), "area"),
    ([[0, 0]], [1], (0, 0), "frame"),
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
    for cut in (diagram.measures, diagram.areas, diagram.edge_arcs):
        with pytest.raises(ValueError, match="box"):
            cut((0, 0, 0, 1))


def test_pandas(diagram):
    pandas = pytest.importorskip("pandas")
    frame = diagram.to_pandas(columns={"name": range(400)})
    assert list(frame.columns) == ["x", "y", "radius", "hidden_by", "degree", "name"]
    assert frame.index.name == "disk" and len(frame) == 400
    assert frame.hidden_by.isna().tolist() == (~diagram.hidden).tolist()
    assert (frame.hidden_by.dropna() == diagram.hosts[diagram.hidden]).all()
    assert frame.degree.sum() == 2 * len(diagram.neighbours)
    assert (frame.degree[diagram.hidden] == 0).all()
    again = vp.voronoi(frame[["x", "y"]], frame.radius).to_pandas(columns=pandas.DataFrame({"name": range(400)}))
    pandas.testing.assert_frame_equal(again, frame)
    assert vp.voronoi([[9, 0]], [1], frame=(0, 0, 2)).to_pandas().hidden_by.tolist() == [-1]
    assert len(vp.voronoi([], []).to_pandas()) == 0
    with pytest.raises(ValueError, match="name: 399 values, not 400"):
        diagram.to_pandas(columns={"name": range(399)})
    with pytest.raises(ValueError, match="radius"):
        diagram.to_pandas(columns={"radius": range(400)})


def test_shapely(diagram):
    pytest.importorskip("shapely")
    box = (-1, 5, 30, 5.2)  # cuts some cells in pieces
    for shapes, limits in ((diagram.polygons(), diagram.box), (diagram.polygons(box, 1e-4), box)):
        x0, y0, x1, y1 = limits
        assert all(shape.is_valid for shape in shapes)
        assert sum(shape.area for shape in shapes) == pytest.approx((x1 - x0) * (y1 - y0))
        assert all(shape.is_empty for shape in np.array(shapes, dtype=object)[diagram.hidden])
    # The larger cell reaches around the smaller one, in front of which the box cuts it.
    pieces = vp.voronoi([[0, 0], [0, 9]], [0, 4]).polygons((-30, 0, 30, 4))
    assert [shape.geom_type for shape in pieces] == ["Polygon", "Polygon"]
    pieces = vp.voronoi([[0, 0], [0, 9]], [0, 4]).polygons((-30, -9, 30, 1))
    assert [shape.geom_type for shape in pieces] == ["Polygon", "MultiPolygon"]


def test_geopandas(diagram, tmp_path):
    geopandas = pytest.importorskip("geopandas")
    frame = diagram.to_geopandas(crs="EPSG:3857", columns={"name": [f"town {k}" for k in range(400)]})
    assert frame.crs == "EPSG:3857" and list(frame.columns)[-2:] == ["name", "geometry"]
    assert frame.geometry.is_empty.tolist() == diagram.hidden.tolist()
    x0, y0, x1, y1 = diagram.box
    assert frame.area.sum() == pytest.approx((x1 - x0) * (y1 - y0))
    frame.to_file(tmp_path / "cells.geojson", driver="GeoJSON")
    assert len(geopandas.read_file(tmp_path / "cells.geojson")) == 400


@pytest.mark.parametrize("module, method", [("pandas", "to_pandas"), ("shapely.geometry", "polygons"),
                                            ("geopandas", "to_geopandas")])
def test_what_is_not_installed_is_named(diagram, monkeypatch, module, method):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ImportError, match=f"(?i){module.partition('.')[0]} is not installed"):
        getattr(diagram, method)()


def test_picture_in_notebooks(diagram):
    shown = diagram._repr_html_()
    picture = ElementTree.fromstring(re.match("<svg.*</svg>", shown)[0])
    drawn = picture[0]
    assert len(drawn) == 400 + int((~diagram.hidden).sum())
    assert sum("stroke-dasharray" in part.attrib for part in drawn) == int(diagram.hidden.sum())
    assert "400 disks in the plane" in shown and "\n" not in shown and len(shown) < 150_000
    many = vp.voronoi(np.random.default_rng(2).uniform(0, 1, (2001, 2)), np.zeros(2001))
    assert many._repr_html_() == "<p>&lt;StaticDiagram of 2001 disks in the plane, 0 hidden&gt;</p>"
    for few in (vp.voronoi([], []), vp.voronoi([[1, 2]], [3]), vp.voronoi([[1, 2]], [3], frame=(0, 0, 9))):
        ElementTree.fromstring(re.match("<svg.*</svg>", few._repr_html_())[0])


@pytest.mark.skipif("VOROPROOF_PROGRAM" not in os.environ, reason="the program is not built")
def test_colours_are_those_of_the_program(tmp_path):
    (tmp_path / "a.csv").write_text("x,y,r\n" + "".join(f"{3 * k},{k * k},1\n" for k in range(30)))
    done = subprocess.run([os.environ["VOROPROOF_PROGRAM"], "diagram", "a.csv", "-o", "a.svg"], cwd=tmp_path)
    assert done.returncode == 0
    text = (tmp_path / "a.svg").read_text()
    told = [tuple(float(x) / 100 for x in colour) for colour in
            re.findall(r"fill:rgb\(([\d.]+)%,([\d.]+)%,([\d.]+)%\)", text)]
    for colour in (disk_colour, cell_colour):
        for disk in range(30):
            assert any(np.allclose(colour(disk), other, atol=1e-5) for other in told), disk


def test_plot(diagram):
    plt = pytest.importorskip("matplotlib.pyplot")
    figure, ax = plt.subplots()
    assert diagram.plot(ax, box=(5, 5, 9, 8), labels=range(400)) is ax
    cells = ax.collections[0]
    drawn = [k for k, cell in enumerate(diagram.cells((5, 5, 9, 8))) for _ in cell]
    np.testing.assert_allclose(cells.get_facecolors()[:, :3], [cell_colour(k) for k in drawn])
    inside = [str(k) for k, (x, y) in enumerate(diagram.centers)
              if not diagram.hidden[k] and 5 <= x <= 9 and 5 <= y <= 8]
    assert [text.get_text() for text in ax.texts] == inside
    assert ax.get_xlim() == (5, 9) and ax.get_ylim() == (5, 8)
    with pytest.raises(ValueError, match="labels: 3, not 400"):
        diagram.plot(labels="abc")
    vp.voronoi([], []).plot(plt.subplots()[1])
    plt.close("all")


def test_claims_of_others_are_judged():
    centers, radii = [[0, 0], [4, 0], [0, 4], [4, 4], [0.1, 0]], [1, 1, 1, 1, 0.5]
    d = vp.voronoi(centers, radii)
    right = vp.certify_diagram(centers, radii, hosts=d.hosts, edges=d.edges, neighbours=d.neighbours,
                               vertices=(d.vertices, d.vertex_positions, d.vertex_radii))
    assert right.certified and right.reason == "" and "5 disks in the plane: edges, neighbours" in right.about
    pairs = [[0, 1], [1, 3], [3, 2], [2, 0]]
    assert vp.certify_diagram(centers, radii, neighbours=pairs).certified
    crossed = vp.certify_diagram(centers, radii, neighbours=pairs + [[0, 3], [1, 2]])
    assert crossed.reservations[0] == "2 pairs of neighbours meet in a vertex only"
    wrong = vp.certify_diagram(centers, radii, neighbours=pairs + [[0, 4]])
    assert wrong.verdict == "refuted" and wrong.reason == "the cells of [0,4] have no edge in common"
    with pytest.raises(ValueError, match="says nothing"):
        vp.certify_diagram(centers, radii)
    with pytest.raises(ValueError, match="there is no 7"):
        vp.certify_diagram(centers, radii, neighbours=[[0, 7]])
