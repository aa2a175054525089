"""Scenarios of BlueSky become the ways that its aircraft fly, and tell every loss."""

import math
from fractions import Fraction

import pytest
from importer_files import SCENARIO, command, given, imported, program, told

from voroproof.importers import geography


def test_a_scenario_of_bluesky(given, tmp_path):
    rows, remarks = imported("bluesky", given(SCENARIO), tmp_path, until=Fraction(600), radius=Fraction(4630))
    assert [row[0] for row in rows["KL1"]] == [0, 60, 600]
    start, turn, end, *_ = rows["KL1"]
    east = turn[1] - start[1]
    # 250 knots at 10,000 feet: by the density there, less 2 knots for compressibility.
    assert turn[2] == start[2] and float(east) / 60 == pytest.approx(248 * 1852 / 3600 / math.sqrt(0.7385), abs=0.2)
    assert end[1] == turn[1] and float(turn[2] - end[2]) / 540 == pytest.approx(float(east) / 60, abs=1e-5)
    assert float(rows["KL2"][0][1] - rows["KL2"][1][1]) == pytest.approx(600 * 0.5 * 328.39, rel=1e-3)  # Mach 1 there
    # At 100 knots to the first place, at 50 from there on; there it is at once a microsecond late at most.
    route = rows["KL3"]
    plane = geography.Projection(Fraction("52.05"), Fraction("4.0"))
    spots = [plane.place(Fraction(lat), Fraction(lon)) for lat, lon in (("52.1", "4.1"), ("52.2", "4.1"), ("52.2", "4.3"))]
    assert [row[1:3] for row in route[:3]] == spots and route[3][0] == 600 and route[3][2] < route[2][2]
    leg = float(plane.north) / 10 / (100 * 1852 / 3600)
    assert 0 <= float(route[1][0]) - 10 - leg < 3e-3  # its speed is rounded to thousandths
    # The speed that is given with a place holds from there on.
    leg = float(spots[2][0] - spots[1][0])
    assert float(route[2][0] - route[1][0]) == pytest.approx(leg / (100 * 1852 / 3600), abs=5e-3)
    speed = float(route[2][2] - route[3][2]) / float(600 - route[2][0])
    assert speed == pytest.approx(50 * 1852 / 3600, abs=1e-3)
    assert told(remarks, "heights are left out") and told(remarks, "and move nobody: HOLD 1")
    assert not told(remarks, "missing")


def test_spellings_of_scenarios(given, tmp_path):
    """Lines that end as on old Macintoshes, lines that go on, Mach numbers, times without a command."""
    text = ("00:00:00.00>CRE A,B744,52,4,90,0,M.80\r00:00:00.00>CRE B,B744,\\\r52,4,90,0,M80\rno time\r"
            "00:00:00.00>CRE C,B744,52,4,90,0,0.8\r00:00:00.00>CASMACHTHR 0\r00:00:00.00>CRE D,B744,52,4,90,0,0.8\r")
    (tmp_path / "a").write_bytes(text.encode())
    rows, remarks = imported("bluesky", tmp_path / "a", tmp_path, until=Fraction(10))
    assert rows["A"] == rows["B"] == rows["C"] != rows["D"] and told(remarks, "1 lines have no time")
    assert float(rows["A"][1][1] - rows["A"][0][1]) == pytest.approx(0.8 * 3402.94, abs=0.1)
    assert float(rows["D"][1][1] - rows["D"][0][1]) == pytest.approx(0.8 * 5.14444, abs=1e-2)


def test_routes_end_where_nobody_knows_the_way(given, tmp_path):
    head = "00:00:00.00>CRE A,B744,52,4,90,0,100\n00:00:00.00>CRE B,B744,50,4,90,0,100\n"
    rows, remarks = imported("bluesky", given(
        head + "00:00:00.00>DEFWPT HERE,52.01,4\n00:00:00.00>ADDWPT A HERE\n00:00:00.00>DEST A EHAM\n"
        "00:00:00.00>ADDWPT B SUGOL\n"), tmp_path, radius=Fraction(0))
    assert list(rows) == ["A"] and len(rows["A"]) == 2
    assert told(remarks, "missing: 1 aircraft are followed only up to")
    assert told(remarks, "missing: 1 aircraft are left out")
    # Commands that nobody follows end the path where they are given.
    rows, remarks = imported("bluesky", given(head + "00:01:00.00>DIRECT A HERE\n00:02:00.00>DEL B\n"), tmp_path)
    assert [row[0] for row in rows["A"]] == [0, 60] and [row[0] for row in rows["B"]] == [0, 120]
    assert told(remarks, "DIRECT 1")


def test_beyond_their_routes_aircraft_fly_straight_on(given, tmp_path):
    """As BlueSky's autopilot has it: at the track and the speed that they have there, until DEL."""
    text = ("00:00:00.00>CRE A,B744,52,4,0,0,100\n00:00:00.00>ADDWPT A 52 4.1\n00:00:00.00>ADDWPT A 52.1 4.2,,50\n"
            "00:00:00.00>CRE B,B744,50,4,90,0,100\n00:00:00.00>DEST B 50 4.01\n")
    rows, remarks = imported("bluesky", given(text), tmp_path)
    # Without --until the table ends with the last route, and nobody's path before.
    end = rows["A"][-1][0]
    assert len(rows["A"]) == 3 and [row[0] for row in rows["B"]] == [0, rows["B"][1][0], end]
    assert rows["B"][1][0] < end and rows["B"][2][2] == rows["B"][0][2]
    speed = float(rows["B"][2][1] - rows["B"][1][1]) / float(end - rows["B"][1][0])
    assert speed == pytest.approx(100 * 1852 / 3600, abs=1e-3)
    assert told(remarks, "1 aircraft fly straight on from the ends of their routes") and not told(remarks, "missing")
    rows, remarks = imported("bluesky", given(text), tmp_path, until=end + 100)
    (_, x, y, *_), (_, right, up, *_), (last, far, high, *_) = rows["A"][-3:]
    assert last == rows["B"][-1][0] == end + 100 and told(remarks, "2 aircraft fly straight on")
    assert math.hypot(far - right, high - up) / 100 == pytest.approx(50 * 1852 / 3600, abs=1e-3)
    assert float(far - right) / float(high - up) == pytest.approx(float(right - x) / float(up - y), rel=1e-6)
    # Commands are obeyed there, but for those that take the route up again.
    hour = "01:00:00.00>"
    rows, remarks = imported("bluesky", given(f"{text}{hour}HDG A 90\n{hour}DEL B\n"), tmp_path, until=Fraction(4000))
    assert [row[0] for row in rows["A"]][-2:] == [3600, 4000] and rows["A"][-2][2] == rows["A"][-1][2]
    assert rows["B"][-1][0] == 3600 and not told(remarks, "missing")
    for again in ("ADDWPT A 53 4", "LNAV A ON", "DEST A 53 4"):
        rows, remarks = imported("bluesky", given(f"{text}{hour}{again}\n"), tmp_path, until=Fraction(4000))
        assert rows["A"][-1][0] == 3600 and told(remarks, "missing: 1 aircraft are followed only up to")


def test_a_command_near_a_place_does_not_turn_the_way_beyond_it(given, tmp_path):
    """Where an aircraft is in mid-leg is rounded; its direction is not taken from there."""
    text = "00:00:00.00>CRE A,B744,52,4,0,0,100\n00:00:00.00>ADDWPT A 52.1 4.1\n"
    start, there = imported("bluesky", given(text), tmp_path)[0]["A"]
    just_before = there[0] - Fraction(1, 10**6)
    stamp = f"00:{int(just_before // 60):02}:{float(just_before % 60):.6f}>"
    rows, _ = imported("bluesky", given(f"{text}{stamp}SPD A 100\n"), tmp_path, until=Fraction(1000))
    assert [row[0] for row in rows["A"]] == [0, just_before, there[0], 1000]
    end = rows["A"][-1]
    assert float((end[2] - there[2]) / (end[1] - there[1])) == pytest.approx(
        float((there[2] - start[2]) / (there[1] - start[1])), rel=1e-6)


def test_who_flies_on_beyond_a_route_comes_near(given, tmp_path):
    """An aircraft that would be gone with its route meets another behind it."""
    path = given("00:00:00.00>CRE A,B744,52,4,90,FL100,250\n00:00:00.00>ADDWPT A 52 4.1\n"
                 "00:00:00.00>CRE B,B744,52,5,270,FL100,250\n")
    assert command("bluesky", path, "--until", "300", "--radius", "10", "-o", tmp_path / "a.csv").returncode == 0
    judged = program("clearance", tmp_path / "a.csv", "--required", "0", "--vanish")
    assert judged.stdout.endswith("s REFUTED\n")


@pytest.mark.parametrize("other", [
    "CRECONFS KL205 B744 KL204 90 1 120 0 0 300", "MCRE 20", "CRE KL205,B744,EHAM,0,FL300,250", "PCALL other.scn",
    "ADDWPT KL204 SUGOL", "NOBODY KNOWS THIS"])
def test_who_is_not_in_the_table_may_be_near(given, tmp_path, other):
    """Whatever may create or move somebody, and is not followed: free is not said."""
    path = given(f"00:00:00.00>CRE KL204 B744 52 4 0 FL300 250\n00:00:00.00>CRE KL9 B744 53 9 0 FL300 250\n00:00:01.00>{other}\n")
    table = tmp_path / "a.csv"
    assert command("bluesky", path, "--until", "60", "--radius", "10", "-o", table).returncode == 0
    judged = program("clearance", table, "--required", "0", "--vanish")
    assert judged.returncode == 3 and judged.stdout.endswith("s UNDECIDED\n") and "\nc missing: " in judged.stdout
    path = given(path.read_text().replace(other, "ZOOM 2"))
    command("bluesky", path, "--until", "60", "--radius", "10", "-o", table)
    assert program("clearance", table, "--required", "0").stdout.endswith("s FREE\n")


TWO_THAT_PASS = ("00:00:00.00>CRE KL1 B744 52 4 90 FL100 250\n00:00:00.00>CRE KL2 B744 52.2 4 180 FL100 250\n"
                 "00:00:00.00>DEFWPT HERE,52.1,4.2\n00:00:20.00>ECHO the end\n")


@pytest.mark.parametrize("other", [
    "00:00:10.00>DTMULT 5; MCRE 5", "00:00:10.00>CASMACHTHR 2 0", "00:00:10.00>CALC bs.traf.reset()",
    "00:00:10.00>HDG KL1 90 0", "00:00:10.00>SPD KL1 250 0", "00:00:10.00>DEL KL1 KL2",
    "00:00:10.00>CRE KL3,B744,52,9,0,0,250,1", "00:00:10.00>ADDWPT KL1 53 4 FL100 250 KL101",
    "00:00:10.00>ADDWPT KL1 53 4 HIGH", "00:00:10.00>DEST KL1 53 4 250",
    "00:00:10.00>ECHO #1; HDG KL1 0", "00:00:10.00>HDG KL1 0 # up", "00:00:10.00>HDG 'KL1 0'",
    "00:00:10.00:0>HDG KL1 0", "1_0:00:10.00>HDG KL1 0", "-1:00:10.00>HDG KL1 0", "00:00:inf>HDG KL1 0",
    f"{'9' * 400}:00:00>HDG KL1 0",
    "00:00:10.00>DEFWPT HERE,53,9\n00:00:11.00>ADDWPT KL1 HERE", "00:00:inf>DEFWPT HERE,53,9\n00:00:11.00>ADDWPT KL1 HERE",
    "00:00:10.00>DEFWPT N52 53 4\n00:00:11.00>ADDWPT KL1 N52 4",
    "00:00:10.00>ADDWPT KL1 53 4\n00:00:11.00>HDG KL1 0\n00:00:12.00>LNAV KL1 ON",
    "00:00:00.00>CRE A,B744,53,9,0,FL100,250\n0:0:1>DEL A",
    "00:00:00.00>CRE HDG,B744,53,9,0,FL100,250\n00:00:10.00>HDG HDG 9"])
def test_what_is_not_surely_understood_is_missing(given, tmp_path, other):
    rows, remarks = imported("bluesky", given(TWO_THAT_PASS + other + "\n"), tmp_path, until=Fraction(60))
    assert told(remarks, "missing: ")


@pytest.mark.parametrize("other", [
    "00:00:10.00>ECHO a; ALT KL1 FL110;;PAN KL2;", "00:00:10.00>ECHO #1; ALT KL1 FL110 'up'", "0:0:9>HOLD", "\n# 0:0:1>DEL KL1",
    "10.00>HDG KL1 0", "00:ten:00>HDG KL1 0", "00:00:10.00>'KL1' POS\n00:00:10.00>KL1", "00:00:10.00>HDG \"KL1\",90,"])
def test_what_moves_nobody_is_not_missing(given, tmp_path, other):
    rows, remarks = imported("bluesky", given(TWO_THAT_PASS + other + "\n"), tmp_path, until=Fraction(60))
    assert not told(remarks, "missing") and [row[0] for row in rows["KL1"]][-1] == 60


def test_a_line_may_hold_several_commands(given, tmp_path):
    for first in ("ECHO turn", "ALT KL1,FL110", "SPD KL2,250", "HDG KL2,90"):
        line = f"00:00:10.00>{first}; HDG KL1,0 ;CRE KL3,B744,52.1,4,0,FL100,250\n"
        rows, remarks = imported("bluesky", given(TWO_THAT_PASS + line), tmp_path, until=Fraction(60))
        assert [row[0] for row in rows["KL1"]] == [0, 10, 60] and rows["KL1"][1][1] == rows["KL1"][2][1]
        assert [row[0] for row in rows["KL3"]] == [10, 60] and not told(remarks, "missing")


@pytest.mark.parametrize("stamp", [
    "00:00:10.0000000000", "0:0:10.", "0:0:+1e1", "00:000:10.00", "00000:00:10.00", " 0 : 0 : 10.00 "])
def test_times_are_read_as_bluesky_reads_them(given, tmp_path, stamp):
    rows, remarks = imported("bluesky", given(TWO_THAT_PASS + stamp + ">HDG KL1,0\n"), tmp_path, until=Fraction(60))
    assert [row[0] for row in rows["KL1"]] == [0, 10, 60] and not told(remarks, "missing") and not told(remarks, "no time")
