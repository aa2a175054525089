"""Small files as DynamO writes them, and what becomes of them."""

import json

from importer_files import command, program


def vector(tag, values):
    return f"<{tag} " + " ".join(f'{axis}="{value}"' for axis, value in zip("xyz", values)) + "/>"


def configuration(particles, bc='<BC Type="PBC"/>', size=(8, 8, 8), elasticity="1", local="", dynamics='Type="Newtonian"/',
                  genus='<Species Mass="M" Name="Bulk" Type="Point">\n        <IDRange Type="All"/>\n      </Species>'):
    """A file of the tool dynamod: particles of diameter, mass, place and velocity."""
    points = "".join(f'    <Pt D="{diameter}" M="{mass}" ID="{k}">\n      {vector("P", at)}\n      {vector("V", velocity)}\n'
                     "    </Pt>\n" for k, (diameter, mass, at, velocity) in enumerate(particles))
    return f"""<?xml version="1.0"?>
<DynamOconfig version="1.5.0">
  <Simulation lastMFT="0">
    <Scheduler Type="NeighbourList">
      <Sorter Type="BoundedPQMinMax3"/>
    </Scheduler>
    {vector("SimulationSize", size)}
    <Genus>
      {genus}
    </Genus>
    {bc}
    <Topology/>
    <Interactions>
      <Interaction Type="HardSphere" Diameter="D" Elasticity="{elasticity}" Name="Bulk">
        <IDPairRange Type="All"/>
      </Interaction>
    </Interactions>
    <Locals>{local}</Locals>
    <Globals>
      <Global Type="Cells" Name="SchedulerNBList" NeighbourhoodRange="1">
        <IDRange Type="All"/>
      </Global>
    </Globals>
    <SystemEvents/>
    <Dynamics {dynamics}>
  </Simulation>
  <Properties>
    <Property Type="PerParticle" Name="D" Units="Length"/>
    <Property Type="PerParticle" Name="M" Units="Mass"/>
  </Properties>
  <ParticleData>
{points}  </ParticleData>
</DynamOconfig>
"""


def wall(name, normal, origin, elasticity="0.5"):
    return (f'<Local Type="Wall" Name="{name}" Elasticity="{elasticity}" Diameter="D">\n<IDRange Type="All"/>\n'
            f'{vector("Norm", normal)}\n{vector("Origin", origin)}\n</Local>')


def _text(values):
    return "Vector{" + ",".join(f"{float(value):.17g}" for value in values) + "}"


def pair_event(t, i, j, impulse, apart):
    """A collision of two particles; DynamO's impulse is taken from the first and given to the second."""
    return (f"00000001, Source=Interaction, SourceID=0, Event Type=CORE, t={float(t):.4f}, dt=0.1000\n"
            f"   2PEvent: p1={i:05}, p2={j:05}, delP1={_text(impulse)}, |r12|=1.0000, post-r12={_text(apart)}, "
            f"post-v12={_text((0, 0, 0))}, post-rvdot=1.0000\n")


def wall_event(t, number, i, at, velocity):
    return (f"00000001, Source=Local, SourceID={number}, Event Type=WALL, t={float(t):.4f}, dt=0.1000\n"
            f"   1PEvent: p1={i}, Type=WALL, delP1={_text((0, 0, 0))}, pos={_text(at)}, vel={_text(velocity)}, "
            f"oldvel={_text((0, 0, 0))}\n\n")


IDLE_EVENT = ("00000001, Source=Global, SourceID=1, Event Type=VIRTUAL, t=0.1000, dt=0.1000\n   1PEvent: p1=0, Type=VIRTUAL, "
              "delP1=Vector{0,0,0}, pos=Vector{1,2,3}, vel=Vector{1,0,0}, oldvel=Vector{1,0,0}\n\n")


# Two balls between walls at x = -5 and 5. The first hits the left wall at t = 2, with half of its speed from there on,
# and the second, which rests, at t = 13, where 1.5 mu (w.n) n / n.n with mu = 3/4 changes the momenta; the second hits
# the right wall at t = 21.
BETWEEN = configuration([(2, 1, (-2, 0, 0), (-1, 0, 0)), (1, 3, (3, 0, 0), (0, 0, 0))], '<BC Type="NoXPBC"/>', (10, 8, 8), "0.5",
                        wall("LowWall", (1, 0, 0), (-5, 0, 0)) + wall("HighWall", (-2, 0, 0), (5, 0, 0)))
HITS = [wall_event(2, 0, 0, (-4, 0, 0), (0.5, 0, 0)), pair_event(13, 0, 1, (0.5625, 0, 0), (-1.5, 0, 0)),
        wall_event(21, 1, 1, (4.5, 0, 0), (-0.09375, 0, 0))]


def made(tmp_path, text, events=None, *options):
    """The scene and the lines of the history that the command makes of the files, and what it says."""
    (tmp_path / "config.start.xml").write_text(text)
    if events is not None:
        (tmp_path / "trajectory.out").write_text("".join(events))
        options += ("--events", tmp_path / "trajectory.out", "--history", tmp_path / "a.history.jsonl")
    done = command("dynamo", tmp_path / "config.start.xml", *options, "-o", tmp_path / "a.scene.json")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    history = ([json.loads(line) for line in (tmp_path / "a.history.jsonl").read_text().splitlines()]
               if events is not None else [])
    return json.loads((tmp_path / "a.scene.json").read_text()), history, done.stdout


def judged(tmp_path, *options):
    """The verdict on the files of `made`."""
    done = program("certify", tmp_path / "a.scene.json", tmp_path / "a.history.jsonl", "--truth", "recorded", *options)
    return done.stdout.splitlines()[-1]
