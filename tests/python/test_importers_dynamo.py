"""Configurations and events of DynamO become billiards and histories, which certify judges."""

import bz2
import json
import os
import re
from fractions import Fraction

import pytest
from dynamo_files import BETWEEN, HITS, IDLE_EVENT, configuration, judged, made, pair_event, wall, wall_event
from importer_files import command, program

import voroproof as vp
from voroproof.importers import FORMATS

CERTIFIED, REFUTED = "s CERTIFIED", "s REFUTED"


def test_balls_between_walls(tmp_path):
    scene, history, said = made(tmp_path, BETWEEN, HITS, "--horizon", "25")
    assert scene["frame"] == {"periodic": [None, 8, 8],
                              "walls": [{"normal": [1, 0, 0], "offset": -5, "restitution": "0.5"},
                                        {"normal": [-1, 0, 0], "offset": -5, "restitution": "0.5"}]}
    assert scene["restitution"] == "0.5" and scene["horizon"] == 25 and scene["dimension"] == 3
    assert scene["disks"] == [{"center": [-2, 0, 0], "radius": 1, "velocity": [-1, 0, 0], "mass": 1},
                              {"center": [3, 0, 0], "radius": "0.5", "velocity": [0, 0, 0], "mass": 3}]
    assert history[1:] == [
        {"t": 2, "collide": [-1, 0], "p": [None, [-4, 0, 0]], "v": [None, [0.5, 0, 0]]},
        {"t": 13, "collide": [0, 1], "image": [0, 0, 0], "v": [[-0.0625, 0, 0], [0.1875, 0, 0]]},
        {"t": 21, "collide": [-2, 1], "p": [None, [4.5, 0, 0]], "v": [None, [-0.09375, 0, 0]]},
        {"end": {"t": 25, "collisions": 3, "maneuvers": 0}}]
    assert judged(tmp_path) == CERTIFIED
    assert "at most 0.00005 from that" in said and "no digit is lost" in scene["comment"] and "left out" not in said


@pytest.mark.parametrize("wrong", [
    HITS[:2], [HITS[0], HITS[2]], [*HITS[:2], HITS[2].replace("vel=Vector{-0.09375", "vel=Vector{-0.09374")],
    [HITS[0], HITS[1].replace("delP1=Vector{0.5625", "delP1=Vector{0.5626"), HITS[2]],
    [*HITS[:2], HITS[2].replace("t=21.0000", "t=21.0002")], [*HITS[:2], HITS[2].replace("SourceID=1", "SourceID=0")]])
def test_wrong_events_are_refuted(tmp_path, wrong):
    made(tmp_path, BETWEEN, wrong, "--horizon", "25")
    assert judged(tmp_path) == REFUTED


def test_times_are_found_beyond_the_decimals_of_the_file(tmp_path):
    """Two balls that meet across a side at t = 1/3, and in the cell at t = 4/3."""
    text = configuration([(1, 1, (-3, 0, 0), (-3, 0, 0)), (1, 1, (2, 0, 0), (3, 0, 0))])
    events = [IDLE_EVENT, pair_event(Fraction(1, 3), 0, 1, (-6, 0, 0), (1, 0, 0)), IDLE_EVENT,
              pair_event(Fraction(4, 3), 0, 1, (6, 0, 0), (-1, 0, 0))]
    scene, history, said = made(tmp_path, text, events)
    assert [line["t"] for line in history[1:3]] == [pytest.approx(1 / 3, abs=1e-15), pytest.approx(4 / 3, abs=1e-15)]
    assert [line["image"] for line in history[1:3]] == [[-1, 0, 0], [0, 0, 0]]
    assert Fraction(scene["horizon"]) == Fraction(history[2]["t"]) and "the horizon is the time of the last" in said
    assert judged(tmp_path, "--tolerance", "1e-12") == CERTIFIED
    # Events after the horizon are left out.
    _, history, said = made(tmp_path, text, events, "--horizon", "1.25")
    assert history[-1]["end"]["collisions"] == 1 and "1 collisions after the horizon are left out" in said
    assert judged(tmp_path) == CERTIFIED
    # A distance vector that is not where the paths lead keeps the time of the file.
    events[1] = events[1].replace("post-r12=Vector{1,", "post-r12=Vector{1.1,")
    _, history, said = made(tmp_path, text, events)
    assert history[1]["t"] == 0.3333 and "image" not in history[1]
    assert "1 collisions are not where the paths lead" in said
    assert judged(tmp_path) == REFUTED and judged(tmp_path, "--tolerance", "0.0001") == CERTIFIED


def test_shear_moves_images_as_that_of_dynamo(tmp_path):
    """At t = 1/3 the image above of the second ball, which moves with speed 3 along x, is right above the first."""
    text = configuration([(1, 1, (-1, 3, 0), (3, 3, 0)), (1, 1, (-1, -3, 0), (0, 0, 0))],
                         '<BC Type="LE" DXD="8" Rate="0.375"/>')
    scene, history, _ = made(tmp_path, text, [pair_event(Fraction(1, 3), 0, 1, (0, 3, 0), (0, -1, 0))], "--horizon", "0.5")
    assert scene["frame"] == {"periodic": [8, 8, 8], "shear": "0.375"} and history[1]["image"] == [0, 1, 0]
    assert history[1]["t"] == pytest.approx(1 / 3, abs=1e-15) and history[1]["v"] == [[3, 0, 0], [0, 3, 0]]
    assert judged(tmp_path) == CERTIFIED


def test_gravity(tmp_path):
    """A ball falls on a floor, a height of 9/4 t^2 below, at t = 2/3."""
    text = configuration([(2, 1, (0, 0, 0), (0, 0, 0))], '<BC Type="None"/>',
                         local=wall("GroundPlate", (0, 1, 0), (0, -2, 0), "1"),
                         dynamics='Type="NewtonianGravity"><g x="0" y="-4.5" z="0"/></Dynamics')
    scene, history, _ = made(tmp_path, text, [wall_event(Fraction(2, 3), 0, 0, (0, -1, 0), (0, 3, 0))], "--horizon", "1.5")
    assert scene["gravity"] == [0, "-4.5", 0] and history[1]["v"] == [None, [0, 3, 0]]
    assert history[1]["t"] == pytest.approx(2 / 3, abs=1e-15) and judged(tmp_path) == CERTIFIED


def test_walls_have_two_sides_and_diameters(tmp_path):
    """All balls are on one side, which may be the one that the normal leads away from."""
    walls = wall("A", (0, 3, 0), (0, -2, 0)).replace('"D"', '"3"') + wall("B", ("0.6", 0, "0.8"), (3, 0, 4))
    scene, _, _ = made(tmp_path, configuration([(2, 1, (0, 0, 0), (0, 0, 0))], '<BC Type="None"/>', local=walls), None,
                       "--horizon", "1")
    assert scene["frame"]["walls"] == [{"normal": [0, 1, 0], "offset": "-1.5", "restitution": "0.5"},
                                       {"normal": ["-0.6", 0, "-0.8"], "offset": -5, "restitution": "0.5"}]


def test_fixed_particles_and_spin(tmp_path):
    genus = ('<Species Mass="1" Name="Ball" Type="SphericalTop" InertiaConstant="0.1">'
             '<IDRange Type="Ranged" Start="0" End="0"/></Species>'
             '<Species Name="Post" Type="FixedCollider"><IDRange Type="List"><ID val="1"/></IDRange></Species>')
    text = configuration([(2, 1, (0, 0, 0), (1, 0, 0)), (2, 1, (5, 0, 0), (0, 0, 0))], '<BC Type="None"/>', genus=genus)
    text = text.replace('ID="1">', 'ID="1" Static="Static">')
    text = text.replace("<ParticleData>", '<ParticleData OrientationData="Y">')
    text = text.replace("</Pt>", '<O x="0" y="0" z="1"/><U w="1" x="0" y="0" z="0"/></Pt>')
    scene, history, said = made(tmp_path, text, [pair_event(3, 0, 1, (2, 0, 0), (-2, 0, 0))], "--horizon", "4")
    assert scene["disks"][1] == {"center": [5, 0, 0], "radius": 1, "fixed": True} and scene["frame"] == "none"
    assert history[1] == {"t": 3, "collide": [0, 1], "v": [[-1, 0, 0], None]} and "orientation and spin" in said
    assert judged(tmp_path) == CERTIFIED
    moving = text.replace('<V x="0" y="0" z="0"/>', '<V x="0" y="1" z="0"/>')
    assert "a fixed disk does not" in refusal(tmp_path, moving).reason


def test_sizes_come_from_the_interactions_of_pairs(tmp_path):
    """As DynamO has it: the first interaction that holds; diameters of pairs are means."""
    def of(*interactions):
        text = configuration([(1, 1, (-3 + k, 0, 0), (0, 0, 0)) for k in range(4)])
        return re.sub("<Interactions>.*</Interactions>", f"<Interactions>{''.join(interactions)}</Interactions>", text,
                      flags=re.DOTALL)
    def one(diameter, pairs, name="Bulk"):
        return f'<Interaction Type="HardSphere" Diameter="{diameter}" Name="{name}">{pairs}</Interaction>'
    first, rest = ('<IDRange Type="Ranged" Start="0" End="1"/>',
                   '<IDRange Type="Union"><IDRange Type="List"><ID val="2"/></IDRange>'
                   '<IDRange Type="Ranged" Start="3" End="3"/></IDRange>')
    single = f'<IDPairRange Type="Single">{first}</IDPairRange>'
    mixed = f'<IDPairRange Type="Pair">{first}{rest}</IDPairRange>'
    every = '<IDPairRange Type="All"/>'
    scene, _, _ = made(tmp_path, of(one("0.5", single), one("0.3", mixed), one("0.1", every)), None, "--horizon", "1")
    assert [disk["radius"] for disk in scene["disks"]] == ["0.25", "0.25", "0.05", "0.05"]
    elastic = one("1", every).replace("Diameter", 'Elasticity="0.5" Diameter')
    assert made(tmp_path, of(elastic), None, "--horizon", "1")[0]["restitution"] == "0.5"
    by_name = of(elastic.replace('"0.5"', '"E"')).replace("<Properties>", '<Properties><Property Type="PerParticle" Name="E" '
                                                         'Units="Dimensionless"/>').replace("<Pt ", '<Pt E="0.25" ')
    assert made(tmp_path, by_name, None, "--horizon", "1")[0]["restitution"] == "0.25"
    assert "one restitution" in refusal(tmp_path, by_name.replace('E="0.25"', 'E="0.5"', 1)).reason
    assert "one restitution" in refusal(tmp_path, of(one("0.5", single), elastic.replace('"1"', '"0.5"'))).reason
    for interactions, reason in [
        ([one("0.5", single), one("0.4", mixed), one("0.1", every)], "additive diameters"),
        ([one("0.5", single), one("D", mixed), one("0.1", every)], "additive diameters"),
        ([one("0.5", single), one("0.1", '<IDPairRange Type="None"/>')], "no interaction holds between particles"),
        ([one("-0.5", every)], "negative"),
        ([one("0.5", every.replace("All", "Chains"))], "Chains is not read"),
        ([one("E", every)], "not a decimal number"),
        ([one("M", every)], "other units than Length"),
        ([one("1", f'<IDPairRange Type="Single">{first.replace("1", "4")}</IDPairRange>')], "beyond the 4 particles"),
        ([one("1", single).replace(first, first.replace('End="1"', f'End="{10**17}"'))], "beyond the 4 particles"),
    ]:
        assert reason in refusal(tmp_path, of(*interactions)).reason


def refusal(tmp_path, text, **options):
    path = tmp_path / "config.start.xml"
    path.write_text(text) if isinstance(text, str) else path.write_bytes(text)
    with pytest.raises(vp.InputError) as caught:
        FORMATS["dynamo"].read(str(path), **{"horizon": Fraction(1), **options})
    assert "\n" not in str(caught.value) and str(path) in str(caught.value)
    return caught.value


@pytest.mark.parametrize("old, new, field, reason", [
    ('version="1.5.0"', 'version="1.6.0"', "DynamOconfig version", "version 1.5.0 is read"),
    ('"HardSphere"', '"SquareWell"', "Interaction Bulk Type", "SquareWell: the disks"),
    ('Diameter="D" Elasticity="0.5" Name="Bulk"', 'Diameter="D" TangentialElasticity="1" Name="Bulk"',
     "Interaction Bulk TangentialElasticity", "smooth"),
    ('Elasticity="0.5" Name="Bulk"', 'Elasticity="1.5" Name="Bulk"', "Interaction Bulk Elasticity", "not from 0 to 1"),
    ('Elasticity="0.5" Name="Bulk"', 'Elasticity="M" Name="Bulk"', "Interaction Bulk Elasticity", "other units"),
    ('Diameter="D" Elasticity="0.5" Name="Bulk"', 'Name="Bulk"', "Interaction Bulk Diameter", "missing"),
    ("<SystemEvents/>", '<SystemEvents>\n<System Type="Andersen" Name="Thermostat"/></SystemEvents>',
     "System Thermostat Type", "Andersen: a billiard knows no such thing"),
    ('Type="Cells"', 'Type="SOCells"', "Global SchedulerNBList Type", "SOCells"),
    ('Type="NeighbourList"', 'Type="SystemOnly"', "Scheduler Type", "not NeighbourList"),
    ('<Dynamics Type="Newtonian"/>', '<Dynamics Type="Viscous"/>', "Dynamics Type", "Viscous"),
    ('<Dynamics Type="Newtonian"/>', '<Dynamics Type="NewtonianGravity" ElasticV="0.1"><g x="0" y="0" z="0"/></Dynamics>',
     "Dynamics ElasticV", "one restitution"),
    ('<Dynamics Type="Newtonian"/>', "", "Simulation Dynamics", "missing"),
    ('Type="Point"', 'Type="Lines"', "Species Bulk Type", "Lines"),
    ('<IDRange Type="All"/>\n      </Species>', '<IDRange Type="Ranged" Start="0" End="0"/>\n      </Species>', "Pt",
     "of no species"),
    ('Mass="M"', 'Mass="-1"', "Species Bulk Mass", "not positive"),
    ('Mass="M"', 'Mass="inf"', "Species Bulk Mass", "not a decimal"),
    ('<BC Type="NoXPBC"/>', '<BC Type="PBC"/>', "Local LowWall Norm", "across a periodic side"),
    ('<BC Type="NoXPBC"/>', '<BC Type="LE" DXD="1" Rate="1"/>', "BC DXD", "displaced at the beginning"),
    ('<BC Type="NoXPBC"/>', '<BC Type="LE"/>', "BC Rate", "missing"),
    ('<BC Type="NoXPBC"/>', '<BC Type="Round"/>', "BC Type", "Round is not known"),
    ('Type="Wall"', 'Type="TriangleMesh"', "Local LowWall Type", "flat walls"),
    ('Name="LowWall"', 'Name="LowWall" Temperature="1"', "Local LowWall Temperature", "random"),
    ('<Norm x="1" y="0" z="0"/>', '<Norm x="0" y="0" z="0"/>', "Norm", "length"),
    ('<Norm x="1" y="0" z="0"/>', '<Norm x="1" y="1" z="0"/>', "Norm", "length"),
    ('<Origin x="-5" y="0" z="0"/>', '<Origin x="0" y="0" z="0"/>', "Local LowWall Origin", "on both sides"),
    ('Name="LowWall" Elasticity="0.5"', 'Name="LowWall" Elasticity="0"', "Local LowWall Elasticity", "more than 0"),
    ('Diameter="D">\n<IDRange', 'Diameter="2">\n<IDRange', "Local LowWall Diameter", "by one number"),
    ('Diameter="D">\n<IDRange Type="All"/>', 'Diameter="D">\n<IDRange Type="None"/>', "Local LowWall IDRange", "pass through"),
    ('<SimulationSize x="10"', '<SimulationSize x="-10"', "Simulation SimulationSize", "no positive"),
    ('<Property Type="PerParticle" Name="M"', '<Property Type="PerParticle" Name="D"', "Property D", "a second time"),
    ('M="1" ID="0"', 'ID="0"', "Pt M", "missing"),
    ('ID="1"', 'ID="0"', "Pt ID", "not 1: DynamO counts"),
    ('<P x="-2"', '<P x="nan"', "P x", "not a decimal"),
    ('<P x="-2" y="0" z="0"/>', '<P x="-2" y="0"/>', "P z", "missing"),
    ('<P x="-2" y="0" z="0"/>', "", "Pt P", "missing"),
    ('ID="0">', 'ID="0" Static="Static">', "Pt Static", "a disk is fixed"),
    ("<Topology/>", "<Ensemble/>", "Simulation Ensemble", "not known"),
    ("<Topology/>", "<Topology/><Topology/>", "Simulation Topology", "a second time"),
    ("<Globals>", "<Locals/><Globals>", "Simulation Locals", "a second time"),
    (BETWEEN, BETWEEN[:1000], "", "no XML"),
    (BETWEEN, "", "", "no XML"),
    (BETWEEN, "<a/>", "a", "no configuration of DynamO"),
])
def test_what_a_billiard_cannot_express_is_refused(tmp_path, old, new, field, reason):
    assert old in BETWEEN
    text = BETWEEN.replace(old, new, 1)
    error = refusal(tmp_path, text)
    assert error.field == field and reason in error.reason, str(error)
    assert not field or f"<{field.split()[0]}" in text.splitlines()[error.line - 1], str(error)


def test_files_that_ask_for_too_much(tmp_path):
    entities = "".join(f'<!ENTITY l{k} "{f"&l{k - 1};" * 10 if k else "lol"}">' for k in range(20))
    laughs = BETWEEN.replace("<DynamOconfig", f"<!DOCTYPE DynamOconfig [{entities}]>\n<DynamOconfig", 1)
    for text, reason in [(laughs.replace('Name="Bulk"', 'Name="&l19;"'), "declaration of the document's type"),
                         (BETWEEN.replace('Name="Bulk"', 'Name="&l19;"'), "undefined entity"),
                         ("<a>" * 10**5, "levels of nesting"), ("<a b='" + "x" * (1 << 22), "a tag of more than"),
                         (BETWEEN.replace('Name="Bulk"', 'Name="\xe9"').encode("latin-1"), "no XML"),
                         (bz2.compress(BETWEEN.encode())[:-20], "end-of-stream marker"),
                         (BETWEEN.replace("<Topology/>", "<Topology>" + "<a/>" * 10**6 + "</Topology>"), "elements")]:
        assert reason in refusal(tmp_path, text).reason
    many = '<IDRange Type="Union">' + '<IDRange Type="All"/>' * 65 + "</IDRange>"
    assert "more than 64 ranges" in refusal(tmp_path, BETWEEN.replace('<IDRange Type="All"/>', many, 1)).reason


@pytest.mark.parametrize("old, new, line, field, reason", [
    ("Source=Interaction", "Source=System", 5, "Event Type", "System CORE"),
    ("Event Type=CORE", "Event Type=BOUNCE", 5, "Event Type", "Interaction BOUNCE"),
    ("p2=00001", "p2=00002", 5, "p2", "the configuration has 2 particles"),
    ("p2=00001", "p2=00000", 5, "p2", "not larger"),
    ("p1=0,", "p1=7,", 2, "p1", "the configuration has 2 particles"),
    ("SourceID=1", "SourceID=2", 7, "SourceID", "the configuration has 2 walls"),
    ("t=13.0000", "t=1.0000", 5, "t", "earlier"),
    ("t=13.0000", "t=nan", 5, "t", "not a decimal"),
    ("t=13.0000", "t=1e5", 5, "t", "with decimals"),
    ("post-r12=Vector{-1.5,", "post-r12=Vector{inf,", 5, "post-r12", "not a decimal"),
    ("delP1=Vector{0.5625,0,0}", "delP1=Vector{0.5625,0}", 5, "", "not a line 2PEvent"),
    (HITS[1], HITS[1].splitlines()[0] + "\n", 5, "", "cut off"),
    (HITS[1], HITS[1] + HITS[1].splitlines()[1] + "\n", 6, "", "a second change"),
    ("00000001, Source=Interaction", "1 Source=Interaction", 4, "", "not an event"),
    (HITS[2], HITS[2][:150], 7, "", "not a line 1PEvent"),
])
def test_damaged_events_are_refused(tmp_path, old, new, line, field, reason):
    (tmp_path / "config.start.xml").write_text(BETWEEN)
    assert old in "".join(HITS)
    (tmp_path / "trajectory.out").write_text("".join(HITS).replace(old, new, 1))
    with pytest.raises(vp.InputError) as caught:
        FORMATS["dynamo"].read(str(tmp_path / "config.start.xml"), events=str(tmp_path / "trajectory.out"), history="h")
    assert (caught.value.line, caught.value.field) == (line, field), str(caught.value)
    assert reason in caught.value.reason and caught.value.file == str(tmp_path / "trajectory.out")


def test_the_command_leaves_what_was_there(tmp_path):
    config, events, scene, history = (tmp_path / name for name in ("a.xml.bz2", "trajectory.out", "s.json", "h.jsonl"))
    config.write_bytes(bz2.compress(BETWEEN.encode()))
    events.write_text("".join(HITS))
    scene.write_text("kept")
    for options, reason in [((), "give --horizon"), (("--events", events), "go together"),
                            (("--history", history), "go together"),
                            (("--events", events, "--history", events), "would replace"),
                            (("--events", events, "--history", config), "would replace"),
                            (("--events", events, "--history", scene), "two files would be written"),
                            (("--events", tmp_path / "none", "--history", history), "No such file"),
                            (("--events", events, "--history", tmp_path / "no" / "h"), "No such file")]:
        done = command("dynamo", config, *options, "-o", scene)
        assert done.returncode == 2 and reason in done.stderr and done.stderr.count("\n") == 1, done.stderr
        assert scene.read_text() == "kept" and sorted(os.listdir(tmp_path)) == ["a.xml.bz2", "s.json", "trajectory.out"]
    done = command("dynamo", config, "--events", events, "--history", history, "--horizon", "25", "-o", "-")
    assert done.returncode == 0 and json.loads(done.stdout)["horizon"] == 25 and "3 collisions" in done.stderr
    done = command("dynamo", "-", "--horizon", "1/2", "-o", scene, input=BETWEEN)
    assert done.returncode == 2 and "--horizon" in done.stderr
    events.write_text("")
    assert "give --horizon" in command("dynamo", config, "--events", events, "--history", history, "-o", scene).stderr
    done = command("dynamo", config, "--events", events, "--history", history, "--horizon", "1.5", "-o", scene)
    assert done.returncode == 0 and program("certify", scene, history, "--truth", "recorded").returncode == 0
