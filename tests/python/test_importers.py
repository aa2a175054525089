"""Importers turn the files of other programs into exact numbers, and tell every loss."""

import gzip
import math
import os
import pathlib
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction

import pytest
from importer_files import (AMERICAN, DANISH, DATA, DUMP, command, given, imported, periodic_dump, program, single, told,
                            write_gsd, write_jupedsim)

from voroproof.importers import airspeed, geography, numbers


def test_numbers_keep_every_digit():
    assert numbers.decimal("-1.50e-3") == Fraction(-15, 10000)
    assert numbers.text(Fraction(-15, 10000)) == "-0.0015"
    assert numbers.text(Fraction(1, 30)) == "1/30" and numbers.text(Fraction(7)) == "7"
    assert Fraction(numbers.text(numbers.binary(0.1))) == Fraction(0.1) != Fraction(1, 10)
    for least in (2.0**-149, 1e-99, -1.5e99):
        assert Fraction(numbers.text(numbers.binary(least))) == Fraction(least)
    for bad in ("", ".", "1e", "nan", "inf", "0x1", "1_0", "1e101", "1e999999999", "1" * 401, "\u0661", "1e-101"):
        with pytest.raises(ValueError):
            numbers.decimal(bad)
    for bad in (math.nan, math.inf, 1e101, 5e-324):
        with pytest.raises(ValueError):
            numbers.binary(bad)


def test_a_dump_of_lammps(given, tmp_path):
    rows, remarks = imported("lammps-dump", given(DUMP), tmp_path)
    quarter, half = Fraction(1, 4), Fraction(1, 2)
    assert rows == {"2": [(0, Fraction(91, 10), 0, half), (100, Fraction(91, 10), Fraction(-3, 4), half)],
                    "1": [(0, Fraction(1, 10), Fraction(1, 5), quarter), (100, Fraction(13, 10), Fraction(1, 5), quarter)]}
    assert told(remarks, "t is counted in steps") and told(remarks, "(lj)") and not told(remarks, "periodic")
    rows, remarks = imported("lammps-dump", given(DUMP), tmp_path, timestep=Fraction("0.005"), radius=Fraction(2))
    assert [row[0] for row in rows["1"]] == [0, half] and rows["1"][0][3] == 2
    assert told(remarks, "a step takes 0.005")


@pytest.mark.parametrize("columns, atoms", [
    ("xs ys ix iy", ["0.875 0.5 0 0", "0.125 0.5 1 -1"]),
    ("x y iy ix", ["2.5 4 0 0", "-0.5 4 -1 1"]),
    ("xu yu x y", ["2.5 4 9 9", "3.5 -4 9 9"]),
    ("xsu ysu", ["0.875 0.5", "1.125 -0.5"]),
])
def test_coordinates_are_unwrapped_and_unscaled(given, tmp_path, columns, atoms):
    rows, remarks = imported("lammps-dump", given(periodic_dump(columns, *atoms)), tmp_path, periodic="unwrap")
    assert rows == {"7": [(0, Fraction(5, 2), 4), (1, Fraction(7, 2), -4)]}
    assert not told(remarks, "missing:") and "# periodic: 4,8\n" in (tmp_path / "table.csv").read_text()


def test_a_data_file_of_lammps(given, tmp_path):
    rows, remarks = imported("lammps-data", given(DATA), tmp_path)
    assert rows["3"] == [(0, Fraction(3, 2), Fraction(5, 2), Fraction(1, 2))] and len(rows) == 3
    assert told(remarks, "one instant")
    rows, _ = imported("lammps-data", given(DATA), tmp_path, until=Fraction(2))
    assert rows["1"][1] == (2, 6, 3, Fraction(1, 4)) and rows["2"][1][:3] == (2, 4, Fraction(37, 4))
    bare = DATA.replace("Atoms  # sphere", "Atoms")
    assert imported("lammps-data", given(bare), tmp_path, style="sphere")[0].keys() == rows.keys()


def test_a_gsd_file(tmp_path):
    path = tmp_path / "a.gsd"
    places = [[[0.1, 0.2, 0], [4.5, 0, 0]], [[0.3, 0.2, 0], [-4.5, 0, 0]]]
    write_gsd(path, [(0, places[0], {"diameter": [0.5, 0.7]}),
                     (10, places[1], {"diameter": [0.5, 0.7], "image": [[0, 0, 0], [1, 0, 0]]})])
    rows, remarks = imported("gsd", path, tmp_path, periodic="unwrap", timestep=Fraction(1, 2))
    assert rows["0"] == [(0, single(0.1), single(0.2), Fraction(1, 4)), (5, single(0.3), single(0.2), Fraction(1, 4))]
    assert rows["1"] == [(0, Fraction(9, 2), 0, single(0.7) / 2), (5, Fraction(11, 2), 0, single(0.7) / 2)]
    assert told(remarks, "binary32") and told(remarks, "half of the diameters")
    # Without diameters there is no radius, and flags that never change are not in the file.
    write_gsd(path, [(0, places[0], {}), (10, places[0], {})])
    rows, remarks = imported("gsd", path, tmp_path, periodic="unwrap")
    assert len(rows["1"][0]) == 3 and rows["1"][1][1] == Fraction(9, 2)
    assert told(remarks, "does not give diameters")


def test_trajectories_of_jupedsim(tmp_path):
    write_jupedsim(tmp_path / "a.sqlite")
    rows, remarks = imported("jupedsim", tmp_path / "a.sqlite", tmp_path)
    assert rows == {"1": [(0, Fraction(0.1), Fraction(0.2)), (Fraction(1, 30), Fraction(0.3), Fraction(0.2))],
                    "2": [(0, 1, 0), (Fraction(2, 30), 1, Fraction(-1, 2))]}
    assert told(remarks, "walls are left out: 1 geometry") and told(remarks, "does not give the size of an agent")
    assert told(remarks, "1 times a disk is missing from frames")


def test_the_plane_of_a_map():
    plane = geography.Projection(Fraction("51.9"), Fraction("4.1"))
    assert plane.place(Fraction("51.9"), Fraction("4.1")) == (0, 0)
    # Against the haversine formula near the point, in floats.
    for lat, lon in (("51.95", "4.15"), ("51.85", "4.1"), ("51.9", "4.0")):
        x, y = map(float, plane.place(Fraction(lat), Fraction(lon)))
        a, b = math.radians(51.9), math.radians(float(lat))
        half = math.sin((b - a) / 2)**2 + math.cos(a) * math.cos(b) * math.sin(math.radians(float(lon) - 4.1) / 2)**2
        assert math.hypot(x, y) == pytest.approx(2 * 6371008.8 * math.asin(math.sqrt(half)), rel=2e-3)
    # The short way around the Earth.
    pacific = geography.Projection(Fraction(0), Fraction(180))
    assert pacific.place(Fraction(0), Fraction(-179))[0] == -pacific.place(Fraction(0), Fraction(179))[0] == pacific.east
    assert pacific.place(Fraction(0), Fraction(181)) == pacific.place(Fraction(0), Fraction(-179))
    assert told(plane.remarks([Fraction("52.9")]), "off by 2.3 %")  # cos 51.9 / cos 52.9 = 1.0229
    for degrees in (0, 30, 90, 123, 270, 359):
        sine, cosine = geography.sine_and_cosine(Fraction(degrees))
        assert float(sine) == pytest.approx(math.sin(math.radians(degrees)), abs=1e-15)
        assert float(cosine) == pytest.approx(math.cos(math.radians(degrees)), abs=1e-15)


def test_the_standard_atmosphere():
    """Against its tables, and where calibrated and true airspeed are one."""
    for height, pressure, temperature in ((0, 101325, 288.15), (5000, 54019.9, 255.65), (11000, 22632.06, 216.65),
                                          (20000, 5474.889, 216.65)):
        p, kelvins = airspeed.atmosphere(Decimal(height))
        assert float(p) == pytest.approx(pressure, rel=3e-6) and float(kelvins) == temperature
    assert float(airspeed.of_calibrated(Decimal(100), Decimal(0))) == pytest.approx(100, rel=1e-7)
    assert float(airspeed.of_mach(Decimal("0.8"), Decimal(11000))) == pytest.approx(236.06, abs=0.01)
    # Values known to pilots: 272 knots at 35,000 feet are Mach 0.8, and 461 knots of true airspeed.
    true = airspeed.of_calibrated(272 * airspeed.KNOT, Decimal(10668))
    assert float(true / airspeed.KNOT) == pytest.approx(461, abs=1)
    assert float(true / airspeed.of_mach(Decimal(1), Decimal(10668))) == pytest.approx(0.8, abs=2e-3)
    with pytest.raises(ValueError):
        airspeed.atmosphere(Decimal(20001))


def test_american_tracks_of_ships(given, tmp_path):
    rows, remarks = imported("ais", given(AMERICAN), tmp_path)
    plane = geography.Projection(Fraction("29.55"), Fraction("-90.1"))
    assert [row[0] for row in rows["367000001"]] == [0, 60]
    assert [row[0] for row in rows["367000002"]] == [30, Fraction(181, 2)]
    assert rows["367000001"][0][1:] == plane.place(Fraction("29.5"), Fraction("-90.104"))
    assert told(remarks, "from 2020-01-01T00:00:00 UTC")
    for loss in ("1 messages without a position", "1 messages repeat", "missing: 1 messages that give another place",
                 "missing: 1 ships of which no message has a position", "length, width"):
        assert told(remarks, loss)
    rows, remarks = imported("ais", given(AMERICAN), tmp_path, longest_gap=Fraction(60))
    assert list(rows) == ["367000001", "367000002", "367000002/2"] and told(remarks, "cut 1 times")
    assert told(remarks, "missing: ships between the parts of their tracks")


def test_a_part_of_a_track_has_no_other_ships_name(given, tmp_path):
    tracks = [("a", (0, 100)), ("a/2", (0, 10)), ("b/2", (5,)), ("b", (0, 50, 99))]
    rows = "\n".join(f"{name},52,4,{t}" for name, times in tracks for t in times)
    columns = {"id": "ship", "time": "when"}
    ships, _ = imported("ais", given(f"ship,lat,lon,when\n{rows}\n"), tmp_path, columns=columns, longest_gap=Fraction(20))
    assert {name: [row[0] for row in rows] for name, rows in ships.items()} == {
        "a": [0], "a/3": [100], "a/2": [0, 10], "b/2": [5], "b": [0], "b/3": [50], "b/4": [99]}


def test_danish_and_other_tracks_of_ships(given, tmp_path):
    rows, _ = imported("ais", given(DANISH), tmp_path)
    assert [row[0] for row in rows["219000001"]] == [0, 10] and rows["2190068"][0][0] == 5
    other = "ship;x\n".replace(";", ",").replace("x", "lon,lat,when") + "a,4,52,1.5\na,5,52,2.5\n"
    rows, remarks = imported("ais", given(other), tmp_path, columns={"id": "ship", "time": "when"})
    assert [row[0] for row in rows["a"]] == [0, 1] and told(remarks, "the number 1.5 of the file")


def test_tables_are_judged_and_their_remarks_repeated(tmp_path):
    """From the file to the verdict, by the commands."""
    write_jupedsim(tmp_path / "a.sqlite", rows=[(0, 1, 0, 0), (10, 1, 4, 0), (0, 2, 4, 0.5), (10, 2, 0, 0.5)], fps="10")
    done = command("jupedsim", tmp_path / "a.sqlite", "--radius", "0.25", "-o", tmp_path / "a.csv")
    assert done.returncode == 0 and done.stderr == "" and "walls are left out" in done.stdout
    judged = program("clearance", tmp_path / "a.csv", "--required", "0")
    assert judged.returncode == 1 and "c least gap 0, of 1 2 at t = 0.5\ns REFUTED\n" in judged.stdout
    assert "c judged are the piecewise linear paths" in judged.stdout and "c walls are left out: 1 geometry" in judged.stdout
    command("jupedsim", tmp_path / "a.sqlite", "--radius", "0.24999999999999999999", "-o", tmp_path / "a.csv")
    assert program("clearance", tmp_path / "a.csv", "--required", "0").stdout.endswith("s FREE\n")
    scene, history = tmp_path / "a.scene.json", tmp_path / "a.history.jsonl"
    assert "walls are left out" in program("convert", tmp_path / "a.csv", "-o", scene).stdout
    assert program("simulate", scene, "-o", history).returncode == 0
    assert program("certify", scene, history).stdout.endswith("s CERTIFIED\n")


def test_streams_and_compression(given, tmp_path):
    plain = command("lammps-dump", given(DUMP), "-o", tmp_path / "a.csv")
    (tmp_path / "a.gz").write_bytes(gzip.compress(DUMP.encode()))
    packed = command("lammps-dump", tmp_path / "a.gz", "-o", "-")
    piped = command("lammps-dump", "-", "-o", "-", input=DUMP.replace("\n", "\r\n"))
    assert packed.stdout == piped.stdout == pathlib.Path(tmp_path / "a.csv").read_text() != ""
    assert packed.stderr == piped.stderr == plain.stdout


def test_nobody(given, tmp_path):
    write_jupedsim(tmp_path / "a.sqlite", rows=[], walls=[])
    assert imported("jupedsim", tmp_path / "a.sqlite", tmp_path)[0] == {}
    assert imported("ais", given(AMERICAN.splitlines()[0]), tmp_path)[0] == {}
    empty = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id x y\n"
    assert imported("lammps-dump", given(empty), tmp_path)[0] == {}
    assert program("clearance", tmp_path / "table.csv", "--radius", "1", "--required", "0").stdout.endswith("s UNDECIDED\n")


MESSAGES = """MMSI,BaseDateTime,LAT,LON,SOG,COG
1,2020-05-01T18:20:00,37.0700,23.4700,0.1,27
2,2020-05-01T18:20:00,36.7000,23.9000,11.0,332
3,2020-05-01T18:20:00,37.0800,23.5200,0.1,27
"""


def test_one_message_a_ship(given, tmp_path):
    """The closest point of approach of two that go on as their messages say: -(d.v)/(v.v), in floats here."""
    where = geography.Projection(Fraction("37.07"), Fraction("23.47"))
    rows, remarks = imported("ais", given(MESSAGES), tmp_path, origin=where, until=Fraction(21600), radius=Fraction(0))
    assert told(remarks, "goes on with the speed and the course") and not told(remarks, "missing")
    def motion(name):
        (_, *start, _), (t, *end, _) = rows[name]
        assert t == 21600
        return start, [(b - a) / t for a, b in zip(start, end)]
    (p, v), (q, w) = motion("1"), motion("2")
    for velocity, knots, course in ((v, 0.1, 27), (w, 11, 332)):
        speed = knots * 1852 / 3600
        assert float(velocity[0]) == pytest.approx(speed * math.sin(math.radians(course)), abs=1e-10)
        assert float(velocity[1]) == pytest.approx(speed * math.cos(math.radians(course)), abs=1e-10)
    d, u = [float(b - a) for a, b in zip(p, q)], [float(b - a) for a, b in zip(v, w)]
    t = -(d[0] * u[0] + d[1] * u[1]) / (u[0]**2 + u[1]**2)
    assert t == pytest.approx(9653.205, abs=1e-3)
    assert math.hypot(d[0] + t * u[0], d[1] + t * u[1]) == pytest.approx(13963.5668, abs=1e-3)
    judged = program("clearance", tmp_path / "table.csv", "--below", "15000", "--required", "4000")
    assert judged.returncode == 0 and "13963.5668  9653.205" in judged.stdout
    # Without it there is one instant; a ship without speed is followed up to its message.
    assert told(imported("ais", given(MESSAGES), tmp_path)[1], "--until gives motion")
    for other in ("102.3,332", ",332", "11.0,360"):
        rows, remarks = imported("ais", given(MESSAGES.replace("11.0,332", other)), tmp_path, until=Fraction(60))
        assert len(rows["2"]) == 1 and told(remarks, "missing: 1 ships after their last message")


def test_images_across_a_periodic_side_may_be_near(given, tmp_path):
    """Two atoms that overlap by 0.2 across a side, and are far apart in the box."""
    head = "ITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp ff pp\n0 10\n0 20\n-0.5 0.5\nITEM: ATOMS id x y radius\n"
    path = given("".join(f"ITEM: TIMESTEP\n{t}\n{head}1 0.2 5 0.25\n2 9.9 5 0.25\n" for t in (0, 1000)))
    assert command("lammps-dump", path, "--periodic", "as-is", "-o", tmp_path / "a.csv").returncode == 0
    judged = program("clearance", tmp_path / "a.csv", "--required", "0")
    assert judged.returncode == 1 and "c least gap -0.2 (they overlap), of 1 2[-1,0] at t = 0\n" in judged.stdout
    assert command("lammps-dump", given(path.read_text().replace("0 10\n", "0 11\n", 1)), "--periodic", "as-is", "-o",
                   tmp_path / "a.csv").returncode == 0
    judged = program("clearance", tmp_path / "a.csv", "--required", "0")
    assert judged.returncode == 3 and "c missing: the periodic images of the disks: the box is not" in judged.stdout


def test_importers_need_no_compiled_module(given, tmp_path):
    """The sources have none beside them; nor have they NumPy here."""
    sources = os.path.join(os.environ["VOROPROOF_SOURCE"], "python")
    def python(*arguments):
        return subprocess.run([sys.executable, "-B", "-S", *map(str, arguments)], capture_output=True, text=True,
                              env={"PYTHONPATH": sources})
    done = python("-m", "voroproof.importers", "lammps-dump", given(DUMP), "-o", tmp_path / "a.csv")
    assert done.returncode == 0 and done.stderr == "" and (tmp_path / "a.csv").exists()
    done = python("-c", "import voroproof; voroproof.InputError; voroproof.Scene")
    assert done.stderr.splitlines()[-1].startswith("ImportError: voroproof.Scene is not there: No module named")
