"""Plans of agents and drones become exact waypoints or pieces of polynomials, and tell every loss."""

import gzip
from fractions import Fraction

import pytest
from importer_files import (LOG, POLYNOMIALS, SCHEDULE, TRAJECTORY, command, given, imported, program, rows_of, told,
                            write_skyc)

from voroproof.importers import Table, polynomials, skybrush
from voroproof.importers.faults import Refused
from voroproof.importers.pieces import Pieces

HALF = Fraction(1, 2)


def test_schedules(given, tmp_path):
    rows, remarks = imported("mapf", given(SCHEDULE), tmp_path, radius=HALF)
    assert rows == {"agent0": [(0, 0, 0, HALF), (1, 1, 0, HALF), (2, 2, 0, HALF)],
                    "agent1": [(0, 2, 2, HALF), (2, 2, 2, HALF), (3, 2, 1, HALF)]}
    assert told(remarks, "whether it stays at its goal or leaves") and not told(remarks, "missing")


@pytest.mark.parametrize("text", [
    "schedule:\n  a:\n  - t: 0\n    x: 1\n    y: 2.5\n  - t: 1\n    x: 1\n    y: 3\n  b c:\n  - {t: 4, x: -1e1, y: 0}\n",
    "---\ncost: 5\nschedule:  # all\n   a:\n   -   {x: 1, y: 2.5, t: 0}\n   - {y: 3, t: 1, x: 1}\n\n   b c:\n"
    "      - x: -10.0\n        y: +0\n        # late\n        t: 4\nother:\n- 1\n- schedule: 2\n",
    "schedule:\n  a:\n    - y: 2.5\n      t: 0\n      x: 1\n    - x: 1\n      y: 3\n      t: 1\n  b c:\n    - x: -10\n"
    "      y: 0\n      t: 4\n",
])
def test_spellings_of_schedules(given, tmp_path, text):
    """As libMultiRobotPlanning and as PyYAML write them, of old and of new versions."""
    rows, _ = imported("mapf", given(text.replace("\n", "\r\n")), tmp_path)
    assert rows == {"a": [(0, 1, Fraction(5, 2)), (1, 1, 3)], "b c": [(4, -10, 0)]}


def test_agents_without_a_plan_may_be_near(given, tmp_path):
    """As the prioritized planner writes those for which it finds none."""
    text = "schedule:\n  agent0:\n    []\n  agent1:\n    - x: 0\n      y: 0\n      t: 0\nstatistics:\n  cost: 9\n"
    for spelled in (text, text.replace(":\n    []", ": []")):
        rows, remarks = imported("mapf", given(spelled), tmp_path)
        assert rows == {"agent1": [(0, 0, 0)]} and told(remarks, "missing: 1 agents")


def test_logs_of_aa_sipp(given, tmp_path):
    rows, remarks = imported("aa-sipp", given(LOG), tmp_path)
    size, third = Fraction("0.40000001"), Fraction("0.33333")
    assert rows == {"0": [(0, 0, 0, size), (2 + HALF, 0, 0, size), (8 + HALF, 3, 0, size), (9 + HALF, 3, 0, size)],
                    "b": [(0, 5, 1, HALF)],
                    "obstacle 0": [(0, 0, 9, third), (2 + HALF, 0, 9, third), (Fraction("11.4442719"), 2, 8, third)]}
    assert told(remarks, "in 1 sections a disk stands where the agent turns") and told(remarks, "1 dynamic obstacles")
    assert not told(remarks, "missing")
    assert {row[0][3] for row in imported("aa-sipp", given(LOG), tmp_path, radius=HALF)[0].values()} == {HALF}
    # An obstacle's own size, and the planner's default.
    own = LOG.replace('<obstacle id="0">', '<obstacle id="0" size="2">')
    assert imported("aa-sipp", given(own), tmp_path)[0]["obstacle 0"][0][3] == 2
    for other in ("", "<defaultparameters/>"):
        none = LOG.replace('<defaultparameters size="0.33333"/>', other)
        assert imported("aa-sipp", given(none), tmp_path)[0]["obstacle 0"][0][3] == HALF


def test_who_is_not_in_a_log_may_be_near(given, tmp_path):
    """Obstacles that another file has, and agents without a path."""
    begin, end = LOG.index("<agents"), LOG.index("<log>")
    short = LOG[:begin] + LOG[end:].replace("<log>", "<log><obstaclesfilename>o.xml</obstaclesfilename>", 1)
    rows, remarks = imported("aa-sipp", given(short), tmp_path)
    assert set(rows) == {"0", "b"} and told(remarks, "missing: the dynamic obstacles of another file")
    lost = LOG.replace('pathfound="true" runtime="0.0001"', 'pathfound="false" runtime="0.0001"')
    rows, remarks = imported("aa-sipp", given(lost), tmp_path)
    assert set(rows) == {"0", "obstacle 0"} and told(remarks, "missing: 1 agents for which no path was found")


def test_plans_are_judged(given, tmp_path):
    """From the file to the verdict: two that change places, and a log whose paths end at other times."""
    swap = "schedule:\n" + "".join(f"  a{k}:\n    - x: {k}\n      y: 0\n      t: 0\n    - x: {1 - k}\n      y: 0\n      t: 1\n"
                                   for k in (0, 1))
    assert command("mapf", given(swap), "--radius", "0.25", "-o", tmp_path / "a.csv").returncode == 0
    assert program("clearance", tmp_path / "a.csv", "--required", "0").stdout.endswith("s REFUTED\n")
    assert command("aa-sipp", given(LOG), "-o", tmp_path / "a.csv").returncode == 0
    assert program("clearance", tmp_path / "a.csv", "--required", "0").returncode == 2
    assert program("clearance", tmp_path / "a.csv", "--required", "0", "--stay").stdout.endswith("s FREE\n")


def at(piece, axis, s, degree):
    """A coordinate of a row of pieces: t, duration and the coefficients by axis."""
    first = 2 + axis * (degree + 1)
    return sum(value * s**k for k, value in enumerate(piece[first:first + degree + 1]))


def test_polynomials(given, tmp_path):
    rows, remarks = imported("polynomials", given(POLYNOMIALS, "cf1.csv"), tmp_path)
    first, second = rows["cf1"]
    assert first[:2] == (0, Fraction("1.05")) and second[:2] == (Fraction("1.05"), Fraction("0.71"))
    assert first[2:10] == (0, 0, 0, 0, *map(Fraction, ("0.830443", "-0.276140", "-0.384219", "0.180493")))
    assert first[18:] == (HALF, 0, 0, 0, 0, 0, 0, 0) and told(remarks, "degree 7")
    for axis, there in enumerate(("0.396058", "-0.445604", "0.5")):
        assert float(at(first, axis, first[1], 7)) == pytest.approx(float(there), abs=1e-6) and (
            at(second, axis, 0, 7) == Fraction(there))
    heading = (tmp_path / "table.csv").read_text().split("\ndisk,")[1].split("\n")[0]
    assert heading.startswith("t,duration,x^0,x^1,") and heading.endswith(",z^7")


def test_spellings_of_polynomials(given, tmp_path):
    """As uav_trajectories, NumPy and Crazyswarm write them; coefficients that no piece needs are left out."""
    numbered = "Duration," + ",".join(f"{axis}^{k}" for axis in ("x", "y", "z", "yaw") for k in range(8)) + "\n"
    line = ",".join(["2", *["1", "-1e-05", "3", "0", "0", "0", "0", "0"] * 4]) + "\n"
    paths = [given(numbered + line, "cf1.csv"), given("# " + numbered.lower() + line + "\n", "cf 2"), tmp_path / "cf3.csv.gz"]
    paths[2].write_bytes(gzip.compress((numbered + line).encode()))
    table = polynomials.read(*map(str, paths), radius=HALF)
    table.write(str(tmp_path / "t.csv"))
    row = (0, 2, *[1, Fraction(-1, 10**5), 3] * 3, HALF)
    assert rows_of(tmp_path / "t.csv") == {"cf1": [row], "cf 2": [row], "cf3": [row]}
    assert "\ndisk,t,duration,x^0,x^1,x^2,y^0,y^1,y^2,z^0,z^1,z^2,radius\n" in (tmp_path / "t.csv").read_text()


def test_several_files_by_the_command(given, tmp_path):
    paths = [given(POLYNOMIALS, f"cf{k}.csv") for k in (1, 2)]
    done = command("polynomials", *paths, "--radius", "0.05", "-o", tmp_path / "t.csv")
    assert done.returncode == 0 and set(rows_of(tmp_path / "t.csv")) == {"cf1", "cf2"}
    done = command("polynomials", *paths, "-o", paths[1])
    assert done.returncode == 2 and "would replace" in done.stderr and paths[1].read_text() == POLYNOMIALS
    assert command("mapf", *paths, "-o", tmp_path / "t.csv").returncode == 2


def casteljau(points, part):
    """A point of a Bezier curve, by its definition."""
    while len(points) > 1:
        points = [a + part * (b - a) for a, b in zip(points, points[1:])]
    return points[0]


def test_shows_of_skybrush(tmp_path):
    write_skyc(tmp_path / "a.skyc", TRAJECTORY, TRAJECTORY, settings=[{"name": "left", "home": [0, 0, 0]}])
    rows, remarks = imported("skybrush", tmp_path / "a.skyc", tmp_path)
    assert rows["left"] == rows["2"] and [row[:2] for row in rows["2"]] == [
        (6, 6), (12, 16), (28, 16), (44, Fraction("12.3"))]
    curves = [[(0, 0, 0), (0, 0, 0), (0, 0, 12), (0, 0, 12)], [(0, 0, 12), (-4, -20, 12), (32, 16, 12), (12, 12, 12)],
              [(12, 12, 12), (-6, 18, 12), (0, 0, 12)], [(0, 0, 12), (-6, Fraction("-6.1"), 18)]]
    for piece, points in zip(rows["2"], curves):
        for part in (0, Fraction(1, 3), HALF, 1):
            for axis, coordinates in enumerate(zip(*points)):
                assert at(piece, axis, part * piece[1], 3) == casteljau([Fraction(c) for c in coordinates], part)
    assert told(remarks, "degree 3") and not told(remarks, "missing")


@pytest.mark.parametrize("settings, missing", [
    ({"home": [0, 0, -0.1]}, "how 1 drones come from home"),
    ({"landAt": [-6, -6.1, 0]}, "how 1 drones come from the last points")])
def test_ways_that_a_show_does_not_tell(tmp_path, settings, missing):
    write_skyc(tmp_path / "a.skyc", TRAJECTORY, TRAJECTORY, settings=[settings, {"home": [0, 0, 0.0]}])
    _, remarks = imported("skybrush", tmp_path / "a.skyc", tmp_path)
    assert [remark for remark in remarks if remark.startswith("missing")] == [
        remark for remark in remarks if remark.startswith(f"missing: {missing}")] != []


def test_a_drone_at_one_time(tmp_path):
    """The trajectory may also stand in show.json itself."""
    show = ('{"version": 1, "swarm": {"drones": [{"settings": {"trajectory": {"version": 1, "points": [[10, [1, 2, 3]]]}}},'
            f'{{"settings": {{"trajectory": {TRAJECTORY}, "name": null}}}}]}}}}')
    write_skyc(tmp_path / "a.skyc", show=show)
    rows, remarks = imported("skybrush", tmp_path / "a.skyc", tmp_path)
    assert list(rows) == ["2"] and told(remarks, "missing: 1 drones whose trajectory is one point")


def test_bezier_curves_of_all_degrees():
    for degree in range(8):
        points = [Fraction((7 * k * k + 3) % 11, 3) for k in range(degree + 1)]
        made = skybrush.coefficients(points, Fraction(7, 5))
        for part in (Fraction(0), Fraction(2, 7), Fraction(1)):
            s = part * Fraction(7, 5)
            assert sum(value * s**k for k, value in enumerate(made)) == casteljau(points, part)


def test_pieces_follow_each_other():
    line = [[Fraction(0), Fraction(1)]] * 2
    table = Pieces(with_radius=False, dimension=2)
    table.add("a", Fraction(0), Fraction(2), line)
    for name, t, duration, curves, field, reason in [
        ("a", 1, 1, line, "t", "before the end"), ("a", 3, 1, line, "t", "without a gap"),
        ("b", 0, 0, line, "duration", "not positive"), ("b", 0, -1, line, "duration", "not positive"),
        ("b", 0, 1, [line[0], [Fraction(0), Fraction(10)**101]], "y^1", "magnitude"),
        ("b", Fraction(1, 3**1300), 1, line, "t", "2000 bits"), ("b,", 0, 1, line, "disk", "name"),
    ]:
        with pytest.raises(Refused) as caught:
            table.add(name, Fraction(t), Fraction(duration), curves)
        assert caught.value.field == field and reason in caught.value.reason
    with pytest.raises(Refused, match="keeps its radius"):
        table.add("a", Fraction(2), Fraction(1), line, HALF)
    table.add("a", Fraction(2), Fraction(1), line)
    assert len(table) == 1 and "a" in table and "b" not in table


@pytest.mark.parametrize("heights, columns", [((1, 1), "disk,t,x,y,radius"), ((1, 2), "disk,t,x,y,z,radius")])
def test_waypoints_in_space(tmp_path, heights, columns):
    """Where all heights are one, the table is one of the plane."""
    table = Table(with_radius=True, dimension=3)
    for t, z in enumerate(heights):
        table.add("a", Fraction(t), (Fraction(3), Fraction(4), Fraction(z)), HALF)
    table.write(str(tmp_path / "t.csv"))
    assert f"\n{columns}\n" in (tmp_path / "t.csv").read_text()
    assert rows_of(tmp_path / "t.csv")["a"] == [(t, 3, 4, *([z] if len(columns) > 17 else []), HALF)
                                                for t, z in enumerate(heights)]
