"""Small files as other programs write them, made for the tests of the importers, and what reads tables back."""

import json
import os
import pathlib
import sqlite3
import struct
import subprocess
import sys
import zipfile
from fractions import Fraction

import pytest

import voroproof as vp
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

SCHEDULE = """statistics:
  cost: 5
  makespan: 3
  runtime: 1.1e-05
  highLevelExpanded: 1
  lowLevelExpanded: 7
schedule:
  agent0:
    - x: 0
      y: 0
      t: 0
    - x: 1
      y: 0
      t: 1
    - x: 2
      y: 0
      t: 2
  agent1:
    - x: 2
      y: 2
      t: 0
    - x: 2
      y: 2
      t: 2
    - x: 2
      y: 1
      t: 3
"""

LOG = """<?xml version="1.0" ?>
<root>
 <agents number="2">
  <defaultparameters size="0.4"/>
  <agent id="0" start.x="0" start.y="0" goal.x="3" goal.y="0"/>
  <agent id="b" start.x="5" start.y="1" goal.x="5" goal.y="1"/>
 </agents>
 <map type="grid">
  <grid width="6" height="2">
   <row number="0">0 0 0 0 1 0 </row>
  </grid>
 </map>
 <dynamicobstacles>
  <defaultparameters size="0.33333"/>
  <obstacle id="0">
   <section id="0" start.x="0" start.y="9" goal.x="0" goal.y="9" duration="2.5"/>
   <section id="1" start.x="0" start.y="9" goal.x="2" goal.y="8" duration="8.9442719"/>
  </obstacle>
 </dynamicobstacles>
 <log>
  <summary runtime="0.038355745" tries="1" agentssolved="2 (100.000000%)" flowtime="9.5" makespan="9.5"/>
  <path>
   <row number="0">* * * * 1 0 </row>
  </path>
  <agent id="0" start.x="0" start.y="0" start.heading="90" goal.x="3" goal.y="0" goal.heading="0" size="0.40000001">
   <path pathfound="true" runtime="0.0007" duration="9.5">
    <section id="0" start.x="0" start.y="0" start.heading="90" goal.x="0" goal.y="0" goal.heading="0" duration="2.5"/>
    <section id="1" start.x="0" start.y="0" start.heading="0" goal.x="3" goal.y="0" goal.heading="0" duration="6"/>
    <section id="2" start.x="3" start.y="0" start.heading="0" goal.x="3" goal.y="0" goal.heading="0" duration="1"/>
   </path>
  </agent>
  <agent id="b" start.x="5" start.y="1" goal.x="5" goal.y="1" size="0.5">
   <path pathfound="true" runtime="0.0001" duration="0"/>
  </agent>
 </log>
</root>
"""

ZEROS = "0.000000," * 8
POLYNOMIALS = "duration," + "".join(f"{axis}^{k}," for axis in ("x", "y", "z", "yaw") for k in range(8)) + f"""
1.050000,0.000000,-0.000000,0.000000,-0.000000,0.830443,-0.276140,-0.384219,0.180493,\
-0.000000,0.000000,-0.000000,0.000000,-1.356107,0.688430,0.587426,-0.329106,0.5{ZEROS[3:]}{ZEROS}
0.710000,0.396058,0.918033,0.128965,-0.773546,0.339704,0.034310,-0.026417,-0.030049,\
-0.445604,-0.684403,0.888433,1.493630,-1.361618,-0.139316,0.158875,0.095799,0.5{ZEROS[3:]}{ZEROS}
"""

TRAJECTORY = """{"version": 1, "takeoffTime": 6, "points": [
  [0.0, [0.0, 0.0, 0.0], []],
  [6, [0, 0, 12], [[0, 0, 0], [0, 0, 12]]],
  [22, [12, 12, 12], [[-4, -20, 12], [32, 16, 12]]],
  [38.0, [0, 0, 12], [[-6, 18, 12]]],
  [50.3, [-6, -6.1, 18]]]}
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


def write_skyc(path, *trajectories, settings=(), show=None, packing=zipfile.ZIP_DEFLATED):
    """A compiled show as Skybrush writes it, of a trajectory's text a drone, with more settings of the drones."""
    drones = [{"type": "generic", "settings": {"trajectory": {"$ref": f"./drones/drone_{k}/trajectory.json#"},
                                               "lights": {"$ref": f"./drones/drone_{k}/lights.json#"},
                                               **(settings[k] if k < len(settings) else {})}}
              for k in range(len(trajectories))]
    made = {"version": 1, "environment": {"type": "outdoor"}, "swarm": {"drones": drones}, "meta": {"title": "a test"}}
    with zipfile.ZipFile(path, "w", packing) as archive:
        archive.writestr("show.json", json.dumps(made) if show is None else show)
        for k, trajectory in enumerate(trajectories):
            archive.writestr(f"drones/drone_{k}/trajectory.json", trajectory)
            archive.writestr(f"drones/drone_{k}/lights.json", '{"version": 1, "data": "B6MQAA=="}')


def single(value):
    """The binary32 that is nearest, exactly."""
    return Fraction(struct.unpack("<f", struct.pack("<f", value))[0])


def rows_of(path):
    """The rows of a table by disk, as Fractions: t, x, y, perhaps z, and perhaps the radius; or the columns of pieces."""
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


def refusal(kind, path, **options):
    with pytest.raises(vp.InputError) as caught:
        FORMATS[kind].read(str(path), **options)
    assert "\n" not in str(caught.value) and caught.value.file == str(path)
    return caught.value


def broken(random_source, data):
    """The bytes with a few of them changed, taken out or doubled."""
    data = bytearray(data)
    for _ in range(random_source.randint(1, 4)):
        k = random_source.randrange(len(data))
        kind = random_source.randrange(4)
        if kind == 0:
            data[k] = random_source.choice(b"\x00\xff\n\r,\" #>:-.e0919azAZ")
        elif kind == 1:
            del data[k:k + random_source.randint(1, 9)]
        elif kind == 2:
            data[k:k] = data[k:k + random_source.randint(1, 40)]
        else:
            del data[k:]
        if not data:
            break
    return bytes(data)
