"""Small files as other programs write them, made for the tests of the importers, and what reads tables back."""

import os
import pathlib
import sqlite3
import struct
import subprocess
import sys
from fractions import Fraction

import pytest

from voroproof.importers import FORMATS

DUMP = """ITEM: UNITS
lj
ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff fs pp
0.0000000000000000e+00 2.0000000000000000e+01
-1.0e1 1.0e1
-5.0000000000000000e-01 5.0000000000000000e-01
ITEM: ATOMS id type x y z radius
2 1 9.1 0 0 0.5
1 1 0.1 0.2 0 0.25
ITEM: TIMESTEP
100
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff fs pp
0.0000000000000000e+00 2.0000000000000000e+01
-1.0e1 1.0e1
-5.0000000000000000e-01 5.0000000000000000e-01
ITEM: ATOMS id type x y z radius
1 1 1.3e0 .2 0 0.25
2 1 9.1 -0.75 0 0.5
"""

DATA = """made for a test

3 atoms
1 atom types

0 10 xlo xhi
0 10 ylo yhi
-0.5 0.5 zlo zhi

Masses

1 1.0  # kind 1

Atoms  # sphere

3 1 1.0 1 1.5 2.5 0 0 0 0
1 1 0.5 1 8 2 0 0 0 0
2 1 0.3 1 4 9.25 0 0 0 0

Velocities

1 -1 0.5 0 0 0 0
2 0 0 0 0 0 0
3 0.125 0 0 0 0 0
"""

SCENARIO = """# two that cross, one that has a route
00:00:00.00>HOLD
00:00:00.00>CRE KL1,B744,52.0,4.0,90,FL100,250
0:00:00.00> CRE KL2 A320 52.0 4.2 270 10000 M.5
00:00:10.00>cre KL3, C172, 52.1, 4.1, 0, 0, 100
00:00:10.00>ADDWPT KL3 52.2 4.1
00:00:10.00>ADDWPT KL3,52.2,4.3,,50
00:00:10.00>KL3 DEST 52.1 4.3
00:01:00.00>KL1 HDG 180
"""

EXTENDED = """2
Lattice="10.0 0.0 0.0 0.0 8.0 0.0 0.0 0.0 6.0" Properties=species:S:1:pos:R:3:id:I:1:radius:R:1:forces:R:3 pbc="T F T" Time=0.5
Ar 1.5 -2.0 0.1 7 0.5 0 0 0
Ne 4.0 0.25 -1e-1 3 0.25 0 0 1.5
2
Lattice="10.0 0.0 0.0 0.0 8.0 0.0 0.0 0.0 6.0" Properties=species:S:1:pos:R:3:id:I:1:radius:R:1:forces:R:3 pbc="T F T" Time=0.75
Ne 4.5 0.25 0.3 3 0.25 0 0 0
Ar 1.5 -1.75 0.1 7 0.5 0 0 0
"""

AMERICAN = """MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName,IMO,CallSign,VesselType,Status,Length,Width
367000001,2020-01-01T00:01:00,29.50000,-90.10000,8.1,90.0,90.0,"ONE, TWO",,,31,0,50,10
367000002,2020-01-01T00:00:30,29.50000,-90.09000,7.9,270.0,270.0,THREE,,,31,0,40,10
367000001,2020-01-01T00:00:00,29.50000,-90.10400,8.1,90.0,90.0,"ONE, TWO",,,31,0,50,10
367000002,2020-01-01T00:01:30.5,29.50000,-90.10200,7.9,270.0,270.0,THREE,,,31,0,40,10
367000002,2020-01-01T00:01:30.5,29.50000,-90.10200,7.9,270.0,270.0,THREE,,,31,0,40,10
367000002,2020-01-01T00:00:30,29.60000,-90.09000,7.9,270.0,270.0,THREE,,,31,0,40,10
367000003,2020-01-01T00:00:30,91.0,181.0,0.0,0.0,511.0,,,,,,,
"""

DANISH = """# Timestamp,Type of mobile,MMSI,Latitude,Longitude,Navigational status,ROT,SOG,COG,Heading
31/01/2021 23:59:50,Class A,219000001,55.500000,10.900000,Under way using engine,0.0,10.0,90.0,90
01/02/2021 00:00:00,Class A,219000001,55.500000,10.901000,Under way using engine,0.0,10.0,90.0,90
31/01/2021 23:59:55,Base Station,2190068,55.510000,10.900000,Unknown value,,,,
"""


def periodic_dump(columns, *atoms):
    """A dump of one atom in a periodic box, a frame for each of its lines."""
    return "".join(f"ITEM: TIMESTEP\n{k}\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n-1 3\n0 8\n-1 1\n"
                   f"ITEM: ATOMS id {columns}\n7 {atom}\n" for k, atom in enumerate(atoms))


def write_jupedsim(path, rows=((0, 1, 0.1, 0.2), (1, 1, 0.3, 0.2), (0, 2, 1.0, 0.0), (2, 2, 1.0, -0.5)), fps="30.0",
                   version="2", walls=("POLYGON ((0 0, 4 0, 4 4, 0 0))",)):
    """A database as JuPedSim writes it: rows of frame, id, x, y."""
    with sqlite3.connect(path) as database:
        database.execute("CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL,"
                         " pos_y REAL NOT NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL)")
        database.execute("CREATE TABLE metadata (key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL)")
        database.execute("CREATE TABLE geometry (hash INTEGER NOT NULL, wkt TEXT NOT NULL)")
        database.executemany("INSERT INTO trajectory_data VALUES (?, ?, ?, ?, 1, 0)", rows)
        database.executemany("INSERT INTO metadata VALUES (?, ?)", [("version", version), ("fps", fps)])
        database.executemany("INSERT INTO geometry VALUES (?, ?)", enumerate(walls))
    database.close()


def write_gsd(path, frames, box=(10, 8, 1, 0, 0, 0)):
    """A GSD file of frames: step, places and perhaps diameters and images."""
    hoomd = pytest.importorskip("gsd.hoomd")
    with hoomd.open(str(path), "wb") as file:
        for step, places, extra in frames:
            snapshot = getattr(hoomd, "Frame", getattr(hoomd, "Snapshot", None))()
            snapshot.configuration.step = step
            snapshot.configuration.box = box
            snapshot.configuration.dimensions = 2
            snapshot.particles.N = len(places)
            snapshot.particles.position = places
            for name, value in extra.items():
                setattr(snapshot.particles, name, value)
            file.append(snapshot)


def single(value):
    """The binary32 that is nearest, exactly."""
    return Fraction(struct.unpack("<f", struct.pack("<f", value))[0])


def rows_of(path):
    """The waypoints of a table by disk: t, x, y, perhaps z, and the radius, where there is one, as Fractions."""
    disks = {}
    lines = [line for line in pathlib.Path(path).read_text().splitlines() if not line.startswith("#")]
    for line in lines[1:]:
        name, *cells = line.split(",")
        disks.setdefault(name, []).append(tuple(map(Fraction, cells)))
    return disks


@pytest.fixture
def given(tmp_path):
    def write(text, name="given"):
        (tmp_path / name).write_text(text)
        return tmp_path / name
    return write


def told(remarks, text):
    return any(text in remark for remark in remarks)


def imported(kind, path, tmp_path, **options):
    """The waypoints by disk that an importer makes of a file, and its remarks."""
    table = FORMATS[kind].read(str(path), **options)
    table.write(str(tmp_path / "table.csv"))
    return rows_of(tmp_path / "table.csv"), table.summary()


def command(*arguments, **kept):
    return subprocess.run([sys.executable, "-B", "-m", "voroproof.importers", *map(str, arguments)],
                          capture_output=True, text=True, **kept)


def program(*arguments):
    """The program voroproof on a file of paths."""
    return subprocess.run([os.environ["VOROPROOF_PROGRAM"], *map(str, arguments)], capture_output=True, text=True)
