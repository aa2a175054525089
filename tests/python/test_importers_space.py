"""Heights become a column z where they differ; xyz files, which are in space."""

import bz2
from fractions import Fraction

import pytest
from importer_files import DATA, DUMP, EXTENDED, command, given, imported, periodic_dump, single, told, write_gsd

import voroproof as vp
from voroproof.importers import FORMATS, Table

PLAIN = "2\n\nAr 0 0 0\nAr 4 0 1.5\n2\n\nAr 1 0 0\nAr 4 1 1.5\n"


def heading(tmp_path):
    """The columns of the table that `imported` has written."""
    return next(line for line in (tmp_path / "table.csv").read_text().splitlines() if not line.startswith("#"))


def test_a_table_in_space_is_written_in_the_plane_where_it_lies_in_one(tmp_path):
    for radius in (None, Fraction(1, 2)):
        size = ",radius" if radius is not None else ""
        table = Table(radius is not None, 3)
        for t, z in ((0, 7), (1, 7), (2, 8)):
            table.write(str(tmp_path / "table.csv"))
            assert heading(tmp_path) == "disk,t,x,y" + size
            table.add("a", Fraction(t), (Fraction(t), Fraction(2), Fraction(z)), radius)
        lines = (tmp_path / "table.csv").read_text().splitlines()
        assert lines[-2:] == ["a,0,0,2" + size.replace("radius", "0.5"), "a,1,1,2" + size.replace("radius", "0.5")]
        table.write(str(tmp_path / "table.csv"))
        assert heading(tmp_path) == "disk,t,x,y,z" + size
        assert (tmp_path / "table.csv").read_text().splitlines()[-1] == "a,2,2,2,8" + size.replace("radius", "0.5")
        assert any("over 1.41421 at most" in said for said in table.summary())


def test_heights_of_dumps(given, tmp_path):
    high = DUMP.replace("fs pp", "fs ff").replace("1 1 1.3e0 .2 0 0.25", "1 1 1.3e0 .2 -0.75 0.25")
    rows, remarks = imported("lammps-dump", given(high), tmp_path)
    assert heading(tmp_path) == "disk,t,x,y,z,radius" and not told(remarks, "heights")
    assert rows["1"] == [(0, Fraction("0.1"), Fraction("0.2"), 0, Fraction(1, 4)),
                         (100, Fraction("1.3"), Fraction("0.2"), Fraction("-0.75"), Fraction(1, 4))]
    rows, remarks = imported("lammps-dump", given(high), tmp_path, flatten=True)
    assert heading(tmp_path) == "disk,t,x,y,radius" and told(remarks, "heights are left out")
    _, remarks = imported("lammps-dump", given(DUMP), tmp_path, flatten=True)
    assert not told(remarks, "heights")


@pytest.mark.parametrize("columns, atoms", [
    ("xs ys zs ix iy iz", ["0.875 0.5 0.25 0 0 0", "0.125 0.5 0.75 1 -1 -1"]),
    ("xu yu zu z", ["2.5 4 -0.5 9", "3.5 -4 -1.5 9"]),
])
def test_heights_are_unwrapped_as_the_rest_is(given, tmp_path, columns, atoms):
    rows, remarks = imported("lammps-dump", given(periodic_dump(columns, *atoms)), tmp_path, periodic="unwrap")
    assert rows == {"7": [(0, Fraction(5, 2), 4, Fraction(-1, 2)), (1, Fraction(7, 2), -4, Fraction(-3, 2))]}
    assert not told(remarks, "missing:") and "# periodic: 4,8,2\n" in (tmp_path / "table.csv").read_text()


@pytest.mark.parametrize("columns, atoms, treatment, reason", [
    ("xu yu z", ["1 1 0", "1 1 0.5"], "unwrap", "no column zu or iz"),
    ("x y z", ["1 1 -0.75", "1 1 0.75"], "as-is", "z changes by more than half"),
    ("x y z", ["1 1 0", "1 1 0.5"], None, "periodic in x"),
])
def test_periodic_heights(given, tmp_path, columns, atoms, treatment, reason):
    with pytest.raises(vp.InputError, match=reason):
        FORMATS["lammps-dump"].read(str(given(periodic_dump(columns, *atoms))), periodic=treatment)
    # Where all heights are one nothing is asked of them.
    level = periodic_dump(columns, *[" ".join([*atom.split()[:2], "0.25"]) for atom in atoms])
    if treatment is not None:
        assert len(imported("lammps-dump", given(level), tmp_path, periodic=treatment)[0]["7"][0]) == 3


def test_a_dump_of_a_box_in_the_plane(given, tmp_path):
    text = DUMP.replace("BOX BOUNDS ff fs pp", "BOX BOUNDS ff fs")
    text = text.replace("-5.0000000000000000e-01 5.0000000000000000e-01\n", "")
    assert imported("lammps-dump", given(text), tmp_path)[0] == imported("lammps-dump", given(DUMP), tmp_path)[0]


def test_heights_of_data_files(given, tmp_path):
    """A velocity leads out of the plane, too."""
    text = DATA.replace("1 -1 0.5 0 0 0 0", "1 -1 0.5 0.25 0 0 0")
    rows, _ = imported("lammps-data", given(text), tmp_path, until=Fraction(2))
    assert rows["1"][1] == (2, 6, 3, Fraction(1, 2), Fraction(1, 4)) and rows["3"][1][3] == 0
    rows, remarks = imported("lammps-data", given(text), tmp_path, until=Fraction(2), flatten=True)
    assert rows["1"][1] == (2, 6, 3, Fraction(1, 4)) and told(remarks, "heights are left out")
    assert len(imported("lammps-data", given(text), tmp_path)[0]["1"][0]) == 4


def test_heights_of_gsd_files(tmp_path):
    path = tmp_path / "a.gsd"
    write_gsd(path, [(0, [[0.1, 0.2, 1], [1, 0, -1.5]], {}),
                     (1, [[0.1, 0.2, 1], [1, 0, 1.75]], {"image": [[0, 0, 0], [0, 0, -1]]})], (10, 8, 4, 0, 0, 0))
    rows, _ = imported("gsd", path, tmp_path, periodic="unwrap")
    assert rows["1"] == [(0, 1, 0, Fraction(-3, 2)), (1, 1, 0, Fraction(-9, 4))]
    assert rows["0"][0] == (0, single(0.1), single(0.2), 1)
    rows, remarks = imported("gsd", path, tmp_path, periodic="unwrap", flatten=True)
    assert rows["1"] == [(0, 1, 0), (1, 1, 0)] and told(remarks, "heights are left out")
    with pytest.raises(vp.InputError, match="z changes by more than half of the box"):
        FORMATS["gsd"].read(str(path), periodic="as-is")
    write_gsd(path, [(0, [[0, 0, 0]], {}), (1, [[1, 0, 0]], {})], (10, 8, 0, 0, 0, 0))
    assert imported("gsd", path, tmp_path, periodic="as-is")[0] == {"0": [(0, 0, 0), (1, 1, 0)]}


def test_extended_xyz(given, tmp_path):
    half, quarter = Fraction(1, 2), Fraction(1, 4)
    rows, remarks = imported("xyz", given(EXTENDED), tmp_path, periodic="as-is")
    tenth = Fraction(1, 10)
    assert rows == {"7": [(half, 3 * half, -2, tenth, half), (3 * quarter, 3 * half, -7 * quarter, tenth, half)],
                    "3": [(half, 4, quarter, -tenth, quarter), (3 * quarter, 9 * half, quarter, 3 * tenth, quarter)]}
    assert not told(remarks, "missing:") and not told(remarks, "no ids")
    assert "# periodic: 10,none,6\n" in (tmp_path / "table.csv").read_text()
    assert imported("xyz", given(EXTENDED), tmp_path, periodic="as-is", radius=Fraction(1))[0]["3"][0][4] == 1
    assert len(imported("xyz", given(EXTENDED), tmp_path, periodic="as-is", flatten=True)[0]["7"][0]) == 4
    # Spellings: other capitals, blanks about "=", names as ids, no box, the plane, bzip2.
    other = EXTENDED.replace("Properties=species", "step=3 pbc = 'f F F' properties = Species").replace(' pbc="T F T"', "")
    other = other.replace("radius", "Radius").replace("id:I", "ID:S").replace("Time=0", "time = 0")
    rows, remarks = imported("xyz", given(other), tmp_path)
    assert list(rows) == ["7", "3"] and not told(remarks, "missing")
    plane = '1\nProperties=pos:R:2:velo:R:2 pbc="F F"\n1 2 0 0\n' * 2
    (tmp_path / "a.bz2").write_bytes(bz2.compress(plane.encode()))
    assert imported("xyz", tmp_path / "a.bz2", tmp_path, timestep=half)[0] == {"0": [(0, 1, 2), (half, 1, 2)]}


def test_plain_xyz(given, tmp_path):
    rows, remarks = imported("xyz", given(PLAIN), tmp_path)
    assert rows == {"0": [(0, 0, 0, 0), (1, 1, 0, 0)], "1": [(0, 4, 0, Fraction(3, 2)), (1, 4, 1, Fraction(3, 2))]}
    for said in ("atoms have no ids", "t is counted in frames", "does not give radii",
                 "missing: the periodic images of the disks, where the box is periodic"):
        assert told(remarks, said)
    lammps = PLAIN.replace("\n\n", "\nAtoms. Timestep: 0\n", 1).replace("\n\n", "\nAtoms. Timestep: 50\n") + "\n\n"
    rows, remarks = imported("xyz", given(lammps), tmp_path, timestep=Fraction(1, 100))
    assert [row[0] for row in rows["1"]] == [0, Fraction(1, 2)] and told(remarks, "one of the steps takes 0.01")
    done = command("xyz", given(PLAIN), "-o", tmp_path / "a.csv", "--radius", "0.5")
    assert done.returncode == 0 and "\ndisk,t,x,y,z,radius\n" in (tmp_path / "a.csv").read_text()


@pytest.mark.parametrize("text, old, new, line, field, reason", [
    (PLAIN, PLAIN, "", 0, "", "no frame"),
    (PLAIN, "2\n", "two\n", 1, "count", "not an integer"),
    (PLAIN, "2\n", "-2\n", 1, "count", "negative"),
    (PLAIN, "2\n", f"{10**17}\n", 5, "atom", "1 values, not a name"),
    (PLAIN, PLAIN, f"{10**17}\n\nAr 0 0 0\n", 3, "atom", "ends within a frame"),
    (PLAIN, "Ar 4 1 1.5\n", "Ne 4 1 1.5\n", 8, "species", "their order changes"),
    (PLAIN, "Ar 4 1 1.5\n", "Ar 4 1\n", 8, "atom", "3 values, not a name and x, y, z"),
    (PLAIN, "Ar 4 1 1.5\n", "Ar 4 nan 1.5\n", 8, "y", "not a decimal"),
    (PLAIN, "2\n\nAr 1", "1\n\nAr 1", 6, "count", "no ids"),
    (PLAIN, "2\n\nAr 1", "2\nTime=4\nAr 1", 6, "comment", "a frame with a time, after those with a frame"),
    (EXTENDED, "Time=0.75", "", 6, "comment", "a frame with a frame, after those with a time"),
    (EXTENDED, "Time=0.75", "Time=0.5", 7, "t", "no later"),
    (EXTENDED, "Time=0.75", "Time=1 time=2", 6, "time", "a second time"),
    (EXTENDED, "Time=0.5", "Time=soon", 2, "Time", "not a decimal"),
    (EXTENDED, 'pbc="T F T"', "", 2, "Lattice", "perhaps periodic"),
    (EXTENDED, 'pbc="T F T"', 'pbc="F F T"', 4, "Lattice", "periodic in z"),
    (EXTENDED, 'pbc="T F T"', 'pbc="T F yes"', 2, "pbc", "not two or three"),
    (EXTENDED, 'Lattice="10.0 0.0 0.0 0.0 8.0 0.0 0.0 0.0 6.0"', "", 2, "pbc", "no Lattice"),
    (EXTENDED, '0.0 6.0"', '6.0"', 2, "Lattice", "8 numbers"),
    (EXTENDED, "10.0 0.0", "-10.0 0.0", 2, "Lattice", "no positive length"),
    (EXTENDED, "10.0 0.0", "10.0 1.0", 2, "Lattice", "tilted"),
    (EXTENDED, "pos:R:3", "pos:R", 2, "Properties", "not triples"),
    (EXTENDED, "pos:R:3", "pos:R:1", 2, "Properties", "no pos:R:3"),
    (EXTENDED, "pos:R:3", "place:R:3", 2, "Properties", "no pos:R:3"),
    (EXTENDED, "forces:R:3", "id:R:3", 2, "Properties", "id a second time"),
    (EXTENDED, "forces:R:3", f"forces:R:{10**17}", 2, "Properties", "1 to 1000 columns"),
    (EXTENDED, "id:I:1", "id:R:1", 2, "Properties", "id is not one column"),
    (EXTENDED, "1.5 -2.0 0.1 7", "1.5 -2.0 0.1 3", 4, "t", "no later"),
])
def test_xyz_files_that_are_refused(given, text, old, new, line, field, reason):
    assert old in text
    path = given(text.replace(old, new, 1))
    with pytest.raises(vp.InputError) as caught:
        FORMATS["xyz"].read(str(path), periodic=None if "periodic" in reason else "as-is")
    assert (caught.value.line, caught.value.field) == (line, field), str(caught.value)
    assert reason in caught.value.reason and caught.value.file == str(path)


def test_xyz_files_have_no_image_flags(given):
    with pytest.raises(vp.InputError, match="no image flags"):
        FORMATS["xyz"].read(str(given(EXTENDED)), periodic="unwrap")
