"""Importers refuse with one line that names file, line, field and reason; exit code 2; nothing written."""

import os
import random
import sqlite3
from fractions import Fraction

import pytest
from dynamo_files import BETWEEN, HITS
from importer_files import (AMERICAN, DATA, DUMP, EXTENDED, LOG, POLYNOMIALS, SCENARIO, SCHEDULE, TRAJECTORY, broken,
                            command, periodic_dump, refusal, write_gsd, write_jupedsim, write_skyc)

import voroproof as vp
from voroproof.importers import FORMATS


@pytest.mark.parametrize("old, new, line, field, reason", [
    ("ITEM: UNITS", "LIST: UNITS", 1, "", "not an item"),
    ("ITEM: TIMESTEP\n0", "ITEM: TIMESTEP\n0.5", 4, "TIMESTEP", "not an integer"),
    ("ITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff fs pp\n0.0", "ITEM: BOX BOUNDS ff fs pp\n0.0", 9, "NUMBER OF ATOMS",
     "missing"),
    ("ATOMS\n2", "ATOMS\n3", 14, "ATOMS", "2 values, not the 6"),
    ("-1.0e1 1.0e1\n", "-1.0e1\n", 9, "BOX BOUNDS", "not two numbers for y"),
    ("-1.0e1 1.0e1\n", "1.0e1 -1.0e1\n", 9, "BOX BOUNDS", "exchanged"),
    ("BOX BOUNDS ff fs pp", "BOX BOUNDS xy xz yz ff ff pp", 7, "BOX BOUNDS", "tilted"),
    ("BOX BOUNDS ff", "BOX BOUNDS pp", 11, "BOX BOUNDS", "periodic in x"),
    ("BOX BOUNDS ff fs pp", "BOX BOUNDS", 11, "BOX BOUNDS", "does not say"),
    ("id type x", "nr type x", 11, "ATOMS", "no column id"),
    ("id type x", "id type u", 11, "ATOMS", "no column of x"),
    ("id type x", "id id x", 11, "ATOMS", "occurs twice"),
    ("2 1 9.1 0", "2 1 nan 0", 12, "x", "not a decimal"),
    ("2 1 9.1 0", "2 1 1e999 0", 12, "x", "magnitude"),
    ("2 1 9.1 0", "1 1 9.1 0", 13, "t", "no later"),
    ("1 1 0.1 0.2 0 0.25", "1 1 0.1 0.2 0.5 0.25", 13, "BOX BOUNDS", "periodic in z"),
    ("1 1 0.1 0.2 0 0.25", "1 1 0.1 0.2 - 0.25", 13, "z", "not a decimal"),
    ("1 1 0.1 0.2 0 0.25", "1 1 0.1 0.2 0 -1", 13, "radius", "negative"),
    ("1 1 1.3e0 .2 0 0.25", "1 1 1.3e0 .2 0 0.5", 23, "radius", "another than before"),
    ("ITEM: TIMESTEP\n100", "ITEM: TIMESTEP\n-5", 23, "t", "no later"),
    ("2 1 9.1 -0.75 0 0.5\n", "", 23, "ATOMS", "ends within a frame"),
    (DUMP, "", 0, "", "no dump"),
])
def test_dumps(tmp_path, old, new, line, field, reason):
    path = tmp_path / "a.dump"
    assert old in DUMP
    path.write_text(DUMP.replace(old, new, 1))
    error = refusal("lammps-dump", path)
    assert (error.line, error.field) == (line, field), str(error)
    assert reason in error.reason


@pytest.mark.parametrize("columns, atoms, treatment, line, field, reason", [
    ("x y", ["2.5 4", "-0.9 4"], "as-is", 20, "x", "crossed a side"),
    ("x y ix", ["2.5 4 0", "-0.9 4 1"], "unwrap", 9, "ATOMS", "no column yu or iy"),
    ("x y ix iy", ["2.5 4 0 0.5"], "unwrap", 10, "iy", "not an integer"),
])
def test_periodic_boxes(tmp_path, columns, atoms, treatment, line, field, reason):
    path = tmp_path / "a.dump"
    path.write_text(periodic_dump(columns, *atoms))
    error = refusal("lammps-dump", path, periodic=treatment)
    assert (error.line, error.field) == (line, field), str(error)
    assert reason in error.reason


@pytest.mark.parametrize("old, new, line, field, reason", [
    ("  # sphere", "", 14, "Atoms", "--atom-style"),
    ("  # sphere", " # ellipsoid", 14, "Atoms", "not read"),
    ("3 atoms", "4 atoms", 0, "Atoms", "3 atoms, and the head of the file says 4"),
    ("3 1 1.0 1 1.5 2.5 0 0 0 0", "3 1 1.0 1 1.5 2.5", 16, "Atoms", "6 values"),
    ("1 1 0.5 1 8 2 0", "3 1 0.5 1 8 2 0", 17, "Atoms id", "second time"),
    ("1 1 0.5 1 8 2 0", "1 1 0.5 1 8 2 high", 17, "Atoms z", "not a decimal"),
    ("1 1 0.5 1 8", "1 1 half 1 8", 17, "Atoms diameter", "not a decimal"),
    ("2 0 0 0 0 0 0\n", "", 0, "Velocities", "not those of the atoms"),
    ("2 0 0 0 0 0 0\n", "2 0 0\n", 23, "Velocities", "3 values"),
    ("Atoms", "Atom", 0, "Atoms", "no such section"),
    ("3 atoms", "2 atoms", 18, "Atoms", "more than the 2"),
    ("3 atoms\n", "", 13, "Atoms", "does not say how many"),
    ("1 -1 0.5 0", "1 -1 1e100 0", 0, "y", "magnitude"),
])
def test_data_files(tmp_path, old, new, line, field, reason):
    path = tmp_path / "a.data"
    assert old in DATA
    path.write_text(DATA.replace(old, new, 1))
    error = refusal("lammps-data", path, until=Fraction(1))
    assert (error.line, error.field) == (line, field), str(error)
    assert reason in error.reason


def test_gsd_files(tmp_path):
    path = tmp_path / "a.gsd"
    at = [[0, 0, 0], [1, 1, 0]]
    write_gsd(path, [(0, at, {})])
    assert "periodic in x" in refusal("gsd", path).reason
    for frames, box, field, reason in [
        ([(0, at, {}), (1, at[:1], {})], None, "frame 1 particles/N", "another number"),
        ([(0, at, {}), (0, at[::-1], {})], None, "frame 1 particle 0 t", "no later"),
        ([(0, at, {}), (1, [[5, 0, 0], [-4.5, 1, 0]], {})], None, "frame 1 particles/position[1]", "crossed a side"),
        ([(0, [[0, 0, 0], [1, float("nan"), 0]], {})], None, "frame 0 particles/position[1]", "finite"),
        ([(0, at, {}), (1, [[0, 0, 0], [1, 1, 0.75]], {})], None, "frame 1 particles/position[1]", "z changes by more"),
        ([(0, at, {})], (9, 9, 1, 0.5, 0, 0), "frame 0 configuration/box", "tilted"),
        ([(0, at, {})], (9, 0, 1, 0, 0, 0), "frame 0 configuration/box", "no positive length"),
        ([(0, at, {"diameter": [1, 2]}), (1, at, {"diameter": [1, 3]})], None, "frame 1 particle 1 radius", "another"),
        ([], None, "", "no frame"),
    ]:
        write_gsd(path, frames, *([box] if box else []))
        error = refusal("gsd", path, periodic="as-is")
        assert error.field == field and reason in error.reason, str(error)
    # Diameters of 1 are not written: these change in frame 1.
    write_gsd(path, [(0, at, {}), (1, at[::-1], {"diameter": [1, 3]})])
    assert "another than before" in refusal("gsd", path, periodic="as-is").reason
    # Image flags that are not kept up.
    write_gsd(path, [(0, at, {}), (1, [[0, 0, 0], [-4.5, 1, 0]], {})])
    assert "crossed a side" in refusal("gsd", path, periodic="unwrap").reason
    path.write_bytes(path.read_bytes()[:100])
    assert "no GSD file" in refusal("gsd", path).reason


@pytest.mark.parametrize("count, reason", [([2**27], "134217728, and the file has"), ([1, 1], "no whole number")])
@pytest.mark.parametrize("what", ["particles", "bonds"])
def test_counts_beyond_a_gsd_file(tmp_path, what, count, reason):
    """The module gsd would make arrays of that many."""
    layer, numpy = pytest.importorskip("gsd.fl"), pytest.importorskip("numpy")
    path = tmp_path / "a.gsd"
    with layer.open(str(path), "wb", application="a test", schema="hoomd", schema_version=[1, 4]) as file:
        file.write_chunk(f"{what}/N", numpy.array(count, dtype=numpy.uint32))
        file.end_frame()
    error = refusal("gsd", path, periodic="as-is")
    assert error.field == f"frame 0 {what}/N" and reason in error.reason, str(error)


def test_an_array_of_a_gsd_file_that_no_memory_holds(tmp_path):
    """The index of the file, of entries of 32 bytes, says how large the arrays are."""
    path = tmp_path / "a.gsd"
    write_gsd(path, [(0, [[0, 0, 0], [1, 0, 0]], {})])
    data = bytearray(path.read_bytes())
    index = int.from_bytes(data[8:16], "little")
    # The box has 6 numbers in a row each. Such an array is far beyond the file, and is asked for all the same.
    entry = next(k for k in range(index, len(data) - 32, 32) if int.from_bytes(data[k + 8:k + 16], "little") == 6)
    data[entry + 24:entry + 28] = (2046820353).to_bytes(4, "little")
    path.write_bytes(data)
    assert "no frame can be read" in refusal("gsd", path, periodic="as-is").reason


def test_databases(tmp_path):
    for k, (given, field, reason) in enumerate([
        ({"version": "3"}, "metadata version", "versions 1 and 2"),
        ({"fps": "0"}, "metadata fps", "not positive"),
        ({"fps": "fast"}, "metadata fps", "not a decimal"),
        ({"rows": [(0, 1, "here", 0)]}, "trajectory_data frame 0 id 1 pos_x", "no number"),
        ({"rows": [(0, 1, 0, float("inf"))]}, "trajectory_data frame 0 id 1", "finite"),
        ({"rows": [(10**9, 1, 0, 0)], "fps": "1e-99"}, f"trajectory_data frame {10**9} id 1 t", "magnitude"),
        ({"rows": [("a", 1, 0, 0)]}, "trajectory_data frame a id 1", "no integer"),
        ({"rows": [(0, 1, 0, 0), (0, 1, 1, 0)]}, "trajectory_data frame 0 id 1 t", "no later"),
    ]):
        path = tmp_path / f"{k}.sqlite"
        write_jupedsim(path, **given)
        error = refusal("jupedsim", path)
        assert error.field == field and reason in error.reason, str(error)
    with sqlite3.connect(tmp_path / "view.sqlite") as database:
        database.execute("CREATE VIEW trajectory_data AS WITH RECURSIVE n(frame) AS (SELECT 0 UNION ALL SELECT frame + 1 FROM "
                         "n) SELECT frame, 1 AS id, 0.0 AS pos_x, 0.0 AS pos_y FROM n")
    assert "no table" in refusal("jupedsim", tmp_path / "view.sqlite").reason
    sqlite3.connect(tmp_path / "empty.sqlite").execute("CREATE TABLE other (a)").connection.commit()
    assert "no such table" in refusal("jupedsim", tmp_path / "empty.sqlite").reason
    (tmp_path / "no.sqlite").write_text(DUMP * 10)
    assert "not a database" in refusal("jupedsim", tmp_path / "no.sqlite").reason
    # SQLite's message about this schema is itself no UTF-8.
    write_jupedsim(tmp_path / "damaged.sqlite")
    whole = (tmp_path / "damaged.sqlite").read_bytes()
    (tmp_path / "damaged.sqlite").write_bytes(whole.replace(b"CREATE TABLE geometry", b"CREATE \xe6ABLE geometry"))
    assert "no trajectories of JuPedSim" in refusal("jupedsim", tmp_path / "damaged.sqlite").reason
    assert "no such file" in refusal("jupedsim", tmp_path / "none").reason
    assert not (tmp_path / "none").exists()


@pytest.mark.parametrize("text, line, field, reason", [
    ("", 0, "CRE", "no aircraft"),
    (DUMP, 0, "CRE", "no aircraft"),
    ("0:0:0>CRE A,B744,52,4,90,0,100\n", 1, "A HDG", "--until"),
    ("0:0:0>CRE A,B744,52,4,90,0,0\n0:0:0>ADDWPT A 53 4\n", 1, "A SPD", "stands still"),
    ("0:0:0>CRE A,B744,52,4\n", 0, "CRE", "of no aircraft"),
    ("0:0:0>CRE A,B744,52,4,90,70000,100\n", 0, "CRE", "of no aircraft"),
    ("0:0:0>CRE A,B744,52,4,90,0,1e90\n", 0, "CRE", "of no aircraft"),
    ("0:0:0>CRE A,B744,52,\\\n4,90,0,100\n", 2, "", "shorter than 12"),
    ("0:0:0>CRE A,B744,52,4,90,0,100\\\n", 1, "", "goes on"),
    ("0:0:0>CASMACHTHR no\n0:0:0>CRE A,B744,52,4,90,0,1\n", 1, "CASMACHTHR", "not a decimal"),
])
def test_scenarios(tmp_path, text, line, field, reason):
    path = tmp_path / "a.scn"
    path.write_text(text)
    error = refusal("bluesky", path)
    assert (error.line, error.field) == (line, field), str(error)
    assert reason in error.reason


@pytest.mark.parametrize("old, new, line, field, reason", [
    (AMERICAN, "", 0, "", "no heading"),
    ("MMSI", "ship", 1, "heading", "no column of id"),
    ("SOG", "LAT", 1, "heading", "several columns of lat"),
    ("29.50000,-90.10000", "29.5", 2, "", "13 fields"),
    ("29.50000,-90.10000", "99.5,-90.1", 2, "lat", "latitude of more than 89"),
    ("29.50000,-90.10000", "29.5,-190.1", 2, "lon", "longitude"),
    ("29.50000,-90.10000", "29.5,west", 2, "lon", "not a decimal"),
    ("2020-01-01T00:01:00", "2020-13-01T00:01:00", 2, "time", "month"),
    ("2020-01-01T00:00:30", "12", 3, "time", "mixed"),
    ("367000001", "", 2, "disk", "name"),
    ('"ONE', 'O"NE', 2, "", ""),
])
def test_tracks(tmp_path, old, new, line, field, reason):
    path = tmp_path / "a.csv"
    assert old in AMERICAN
    path.write_text(AMERICAN.replace(old, new, 1))
    error = refusal("ais", path)
    assert (error.line, error.field) == (line, field), str(error)
    assert reason in error.reason


@pytest.mark.parametrize("old, new, line, field, reason", [
    ("SOG", "speed", 1, "heading", "no column of speed"),
    ("8.1,90.0,90.0", "fast,90.0,90.0", 2, "speed", "not a decimal"),
    ("8.1,90.0,90.0", "8.1,-90.0,90.0", 2, "course", "negative"),
    ("2020-01-01T00:01:00", "2020-01-01T01:00:00", 2, "time", "--until 600 is no later"),
])
def test_tracks_that_go_on(tmp_path, old, new, line, field, reason):
    path = tmp_path / "a.csv"
    assert old in AMERICAN
    path.write_text(AMERICAN.replace(old, new, 1))
    error = refusal("ais", path, until=Fraction(600))
    assert (error.line, error.field) == (line, field), str(error)
    assert reason in error.reason


def test_tracks_around_the_earth(tmp_path):
    (tmp_path / "a.csv").write_text("mmsi,timestamp,lat,lon\n1,0,0,0\n1,1,0,179\n1,2,0,-179\n")
    assert "other side of the Earth" in refusal("ais", tmp_path / "a.csv").reason


def test_a_line_end_in_a_name(tmp_path):
    """Without it the name would be that of another ship."""
    (tmp_path / "a.csv").write_text('mmsi,basedatetime,lat,lon\n12,1,0,0\n"1\n2",2,0,0\n')
    assert "its name" in refusal("ais", tmp_path / "a.csv").reason


def test_commands_leave_what_was_there(tmp_path):
    dump, table = tmp_path / "a\x1bb.dump", tmp_path / "t.csv"
    dump.write_text(DUMP.replace("2 1 9.1 -0.75", "2 1 9.1 x"))
    table.write_text("kept")
    done = command("lammps-dump", dump, "-o", table)
    assert done.returncode == 2 and done.stdout == "" and table.read_text() == "kept"
    assert done.stderr == f"voroproof.importers: {tmp_path}/a\\x1bb.dump:24: y: not a decimal number\n"
    assert sorted(os.listdir(tmp_path)) == ["a\x1bb.dump", "t.csv"]
    for arguments in (["lammps-dump", tmp_path / "none", "-o", table], ["lammps-dump", dump, "-o", dump],
                      ["lammps-dump", tmp_path, "-o", table], ["none", dump, "-o", table], ["ais", dump],
                      ["jupedsim", dump, "--radius", "-1", "-o", table], ["ais", dump, "--columns", "id", "-o", table]):
        done = command(*arguments)
        assert done.returncode == 2 and done.stderr and "Traceback" not in done.stderr, arguments
    assert table.read_text() == "kept"
    dump.write_text(DUMP)
    done = command("lammps-dump", dump, "-o", tmp_path / "no" / "t.csv")
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    # A device is written to, and stays one; a link stays a link.
    assert command("lammps-dump", dump, "-o", "/dev/null").returncode == 0 and not os.path.isfile("/dev/null")
    (tmp_path / "link.csv").symlink_to(table)
    assert command("lammps-dump", dump, "-o", tmp_path / "link.csv").returncode == 0
    assert (tmp_path / "link.csv").is_symlink() and table.read_text().startswith("# remark: ")


def test_nothing_is_left_where_writing_fails(tmp_path, monkeypatch):
    (tmp_path / "a").write_text(DUMP)
    table = FORMATS["lammps-dump"].read(str(tmp_path / "a"))
    def fail(*_):
        raise OSError(28, "No space left on device")
    monkeypatch.setattr(os, "replace", fail)
    with pytest.raises(vp.OutputError, match="t.csv: No space left on device"):
        table.write(str(tmp_path / "t.csv"))
    assert os.listdir(tmp_path) == ["a"]


@pytest.mark.parametrize("kind", ["lammps-dump", "lammps-data", "bluesky", "ais", "xyz", "dynamo", "events", "jupedsim",
                                  "gsd", "mapf", "aa-sipp", "polynomials", "skybrush"])
def test_whatever_is_broken_is_read_or_refused(tmp_path, kind):
    """No other error than InputError, whatever the bytes; scripts/fuzz.sh asks for other and for more changes."""
    whole = tmp_path / "whole"
    options = {"bluesky": {"until": Fraction(600)}, "gsd": {"periodic": "as-is"}, "lammps-data": {"until": Fraction(3)},
               "xyz": {"periodic": "as-is"}, "dynamo": {"horizon": Fraction(25)}}
    if kind == "jupedsim":
        write_jupedsim(whole)
    elif kind == "gsd":
        write_gsd(whole, [(0, [[0, 0, 0]], {}), (1, [[1, 0, 0]], {})])
    elif kind == "skybrush":
        write_skyc(whole, TRAJECTORY)
    else:
        whole.write_text({"lammps-dump": DUMP, "lammps-data": DATA, "bluesky": SCENARIO, "ais": AMERICAN, "xyz": EXTENDED,
                          "dynamo": BETWEEN, "events": "".join(HITS), "mapf": SCHEDULE, "aa-sipp": LOG,
                          "polynomials": POLYNOMIALS}[kind])
    (tmp_path / "config").write_text(BETWEEN)
    def read(path):
        if kind == "events":
            return FORMATS["dynamo"].read(str(tmp_path / "config"), events=path, history="none")
        return FORMATS[kind].read(path, **options.get(kind, {}))
    dice = random.Random(int(os.environ.get("VOROPROOF_FUZZ_SEED", 7)))
    outcomes = {True: 0, False: 0}
    times = int(os.environ.get("VOROPROOF_FUZZ_TIMES", 1))
    for k in range(times * (60 if kind in ("jupedsim", "gsd") else 250)):
        path = tmp_path / f"{kind}{k}"
        path.write_bytes(broken(dice, whole.read_bytes()))
        try:
            read(str(path))
            outcomes[True] += 1
        except vp.InputError as error:
            assert str(error).startswith(str(path)) and "\n" not in str(error)
            outcomes[False] += 1
        path.unlink()
    assert min(outcomes.values()) > 0, outcomes
