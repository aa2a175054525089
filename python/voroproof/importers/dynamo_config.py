"""DynamO's configuration files as settings of billiards; whatever a billiard cannot express is refused.

DynamO's own reader decides what the file means: particles have the ids of their order in the file, a property is
first looked up by name and is a number otherwise, walls are planes with two sides, and images across the sides of
Lees-Edwards move along x. All numbers are in the units of the file, as the events are that DynamO writes.
"""

import math
from fractions import Fraction
from typing import Dict, List, NamedTuple, NoReturn, Optional, Tuple

from . import dynamo_kinds, numbers
from .billiard import MOST_BALLS, Ball, Setting, Vector, Wall
from .faults import printable
from .markup import Element, Markup

VERSION = "1.5.0"
_SECTIONS = ("Scheduler", "SimulationSize", "Genus", "BC", "Topology", "Interactions", "Locals", "Globals",
             "SystemEvents", "Dynamics")
Sides = Tuple[Optional[Fraction], ...]
_PERIODIC = {"None": "", "Null": "", "PBC": "xyz", "NoXPBC": "yz", "OnlyXPBC": "x", "LE": "xyz"}


class Configuration(NamedTuple):
    setting: Setting
    remarks: List[str]


class _Particle(NamedTuple):
    at: Vector
    velocity: Vector
    static: bool
    element: Element  # without the elements within


class _Reader:

    def __init__(self, path: str):
        self.document = Markup(path)
        self.particles: List[_Particle] = []
        self.named: Dict[str, str] = {}  # the units of each property
        self.remarks: List[str] = []

    def fail(self, element: Element, field: str, reason: str) -> NoReturn:
        self.document.fail(element, field, reason)

    def read(self) -> Configuration:
        document = self.document
        root = document.read(("DynamOconfig", "ParticleData", "Pt"), self.particle)
        if root.tag != "DynamOconfig":
            self.fail(root, "", "not the tag DynamOconfig: this is no configuration of DynamO")
        if document.text(root, "version") != VERSION:
            self.fail(root, "version", f"{printable(root.attributes['version'])}; version {VERSION} is read")
        document.require_known(root, ["version"], ["Simulation", "Properties", "ParticleData"])
        data = document.one(root, "ParticleData")
        if "OrientationData" in data.attributes:
            self.remarks.append("the orientation and spin of particles are left out: smooth spheres do not change them")
        document.require_known(data, ["OrientationData"], [])
        if not self.particles:
            self.fail(data, "Pt", "no particle")
        self.properties(root)
        simulation = document.one(root, "Simulation")
        document.require_known(simulation, ["lastMFT"], _SECTIONS)
        self.require_no_more(simulation)
        self.ranges = dynamo_kinds.Ranges(document, len(self.particles))
        return Configuration(self.setting(simulation), self.remarks)

    def particle(self, element: Element) -> None:
        document, index = self.document, len(self.particles)
        if index == MOST_BALLS:
            self.fail(element, "", f"more than {MOST_BALLS} particles")
        if "ID" in element.attributes and element.attributes["ID"] != str(index):
            self.fail(element, "ID", f"not {index}: DynamO counts the particles in the order of the file")
        document.require_known(element, element.attributes, ["P", "V", "O", "U"])
        at, velocity = (document.vector(document.one(element, tag)) for tag in ("P", "V"))
        element.children = []
        self.particles.append(_Particle(at, velocity, "Static" in element.attributes, element))

    def properties(self, root: Element) -> None:
        element = self.document.at_most_one(root, "Properties")
        for one in self.document.children(element, "Property") if element is not None else []:
            self.document.require_known(one, ["Type", "Name", "Units"], [])
            if self.document.text(one, "Type") != "PerParticle":
                self.fail(one, "Type", "not PerParticle")
            name = self.document.text(one, "Name")
            if name in self.named:
                self.fail(one, "", "a second time")
            self.named[name] = self.document.text(one, "Units")

    def require_no_more(self, simulation: Element) -> None:
        """Nothing acts but interactions, walls and gravity."""
        document = self.document
        for tag, allowed in (("SystemEvents", ()), ("Globals", ("Cells",)), ("Topology", None)):
            section = document.at_most_one(simulation, tag)
            for one in section.children if section is not None else []:
                if allowed is not None and document.text(one, "Type") not in allowed:
                    self.fail(one, "Type", f"{printable(one.attributes['Type'])}: a billiard knows no such thing")
                if tag == "Topology":
                    name = printable(one.attributes.get("Name", ""))
                    self.remarks.append(f"the structure {name} is left out: it only groups particles")
        scheduler = document.at_most_one(simulation, "Scheduler")
        if scheduler is not None and document.text(scheduler, "Type") not in ("NeighbourList", "Dumb"):
            self.fail(scheduler, "Type", "not NeighbourList or Dumb: collisions may not be looked for")

    def value(self, element: Element, name: str, units: str) -> dynamo_kinds.Value:
        """A property of particles, which the attribute gives by its name or as a number."""
        given = self.document.text(element, name)
        if given not in self.named:
            number = self.document.number(element, name)
            return lambda i: number
        if self.named[given] != units:
            self.fail(element, name, f"the property {printable(given)} has other units than {units}")
        known: Dict[int, Fraction] = {}
        def of(i: int) -> Fraction:
            if i not in known:
                known[i] = self.document.number(self.particles[i].element, given)
            return known[i]
        return of

    def setting(self, simulation: Element) -> Setting:
        sizes = self.sizes(simulation)
        bc = self.document.one(simulation, "BC")
        kind = self.document.text(bc, "Type")
        if kind not in _PERIODIC:
            self.fail(bc, "Type", f"{printable(kind)} is not known")
        lengths = self.document.vector(self.document.one(simulation, "SimulationSize"))
        if min(lengths) <= 0:
            self.fail(simulation, "SimulationSize", "no positive length")
        sides = tuple(length if axis in _PERIODIC[kind] else None for axis, length in zip("xyz", lengths))
        shear = self.shear(bc, lengths) if kind == "LE" else Fraction(0)
        balls = self.balls(simulation, sizes)
        walls, gravity = self.walls(simulation, sides, balls), self.gravity(simulation)
        return Setting(sides, shear, walls, gravity, sizes.restitution, balls)

    def shear(self, bc: Element, lengths: Vector) -> Fraction:
        self.document.require_known(bc, ["Type", "DXD", "Rate"], [])
        if "DXD" in bc.attributes and (self.document.number(bc, "DXD") / lengths[0]).denominator != 1:
            self.fail(bc, "DXD", "images are displaced at the beginning; those of a billiard are not")
        return self.document.number(bc, "Rate")

    def sizes(self, simulation: Element) -> dynamo_kinds.Sizes:
        section = self.document.one(simulation, "Interactions")
        found = []
        for one in self.document.children(section, "Interaction"):
            kind = self.document.text(one, "Type")
            if kind != "HardSphere":
                self.fail(one, "Type", f"{printable(kind)}: the disks of a billiard are hard spheres")
            if "TangentialElasticity" in one.attributes:
                self.fail(one, "TangentialElasticity", "rough spheres; those of a billiard are smooth")
            self.document.require_known(one, ["Type", "Name", "Diameter", "Elasticity"], ["IDPairRange"])
            elasticity = (self.value(one, "Elasticity", "Dimensionless") if "Elasticity" in one.attributes
                          else lambda i: Fraction(1))
            found.append(dynamo_kinds.Interaction(one, self.value(one, "Diameter", "Length"), elasticity))
        if not 0 < len(found) <= dynamo_kinds.MOST:
            self.fail(section, "Interaction", f"{len(found)} of them; 1 to {dynamo_kinds.MOST} are read")
        return dynamo_kinds.Sizes(self.document, self.ranges, found, len(self.particles))

    def balls(self, simulation: Element, sizes: dynamo_kinds.Sizes) -> List[Ball]:
        masses: List[Optional[Fraction]] = [None] * len(self.particles)
        species: List[Optional[Element]] = [None] * len(self.particles)
        for one in self.document.children(self.document.one(simulation, "Genus"), "Species"):
            kind = self.document.text(one, "Type")
            if kind not in ("Point", "SphericalTop", "FixedCollider"):
                self.fail(one, "Type", f"{printable(kind)}: a billiard knows no such thing")
            self.document.require_known(one, ["Type", "Name", "Mass", "InertiaConstant"], ["IDRange"])
            holds = self.ranges.within(one)
            mass = self.value(one, "Mass", "Mass") if kind != "FixedCollider" else None
            for i in filter(holds, range(len(self.particles))):
                if species[i] is not None:
                    self.fail(one, "IDRange", f"particle {i} is of another species already")
                species[i], masses[i] = one, mass(i) if mass is not None else None
                if mass is not None and masses[i] <= 0:
                    self.fail(one, "Mass", f"not positive for particle {i}")
        return [self.ball(i, of, masses[i], sizes.radii[i]) for i, of in enumerate(species)]

    def ball(self, i: int, species: Optional[Element], mass: Optional[Fraction], radius: Fraction) -> Ball:
        particle = self.particles[i]
        if species is None:
            self.fail(particle.element, "", f"particle {i} is of no species")
        if mass is None and any(particle.velocity):
            self.fail(particle.element, "V", "a particle of a FixedCollider moves; a fixed disk does not")
        if mass is not None and particle.static:
            self.fail(particle.element, "Static",
                      "a particle that gravity does not move, and others do: a disk is fixed, or gravity moves it")
        return Ball(particle.at, particle.velocity, radius, mass)

    def gravity(self, simulation: Element) -> Vector:
        dynamics = self.document.one(simulation, "Dynamics")
        kind = self.document.text(dynamics, "Type")
        if kind == "Newtonian":
            self.document.require_known(dynamics, ["Type"], [])
            return Fraction(0), Fraction(0), Fraction(0)
        if kind != "NewtonianGravity":
            self.fail(dynamics, "Type", f"{printable(kind)}: a billiard knows Newtonian and NewtonianGravity")
        for name in ("ElasticV", "tc"):
            if name in dynamics.attributes:
                self.fail(dynamics, name, "collisions are elastic at times; a billiard has one restitution")
        self.document.require_known(dynamics, ["Type"], ["g"])
        return self.document.vector(self.document.one(dynamics, "g"))

    def walls(self, simulation: Element, sides: Sides, balls: List[Ball]) -> List[Wall]:
        section = self.document.at_most_one(simulation, "Locals")
        found = section.children if section is not None else []
        if len(found) > dynamo_kinds.MOST:
            self.fail(section, "Local", f"more than {dynamo_kinds.MOST}")
        return [self.wall(one, sides, balls) for one in found]

    def wall(self, element: Element, sides: Sides, balls: List[Ball]) -> Wall:
        kind = self.document.text(element, "Type")
        if kind != "Wall":
            self.fail(element, "Type", f"{printable(kind)}: a billiard has flat walls")
        if "Temperature" in element.attributes:
            self.fail(element, "Temperature", "a wall that gives random velocities")
        self.document.require_known(element, ["Type", "Name", "Elasticity", "Diameter"], ["IDRange", "Norm", "Origin"])
        normal = self.normal(element, sides)
        holds = self.ranges.within(element)
        origin = self.document.vector(self.document.one(element, "Origin"))
        height = sum(n * o for n, o in zip(normal, origin))
        diameter = self.value(element, "Diameter", "Length")
        elasticity = self.value(element, "Elasticity", "Dimensionless")
        moving = [i for i, ball in enumerate(balls) if ball.mass is not None]
        if not all(map(holds, moving)):
            self.fail(element, "IDRange", "some particles pass through the wall; no disk of a billiard does")
        above = {sum(n * c for n, c in zip(normal, ball.center)) >= height for ball in balls}
        margins = {diameter(i) / 2 - balls[i].radius for i in moving}
        bounces = {elasticity(i) for i in moving}
        if len(above) > 1:
            self.fail(element, "Origin", "particles are on both sides of the wall; a billiard is on one")
        if len(margins) > 1:
            self.fail(element, "Diameter", "not larger than those of the particles by one number for all of them")
        if len(bounces) > 1 or not all(0 < bounce <= 1 for bounce in bounces):
            self.fail(element, "Elasticity", "not one number for all particles, more than 0 and at most 1")
        if not above.pop():
            normal, height = tuple(-n for n in normal), -height
        return Wall(normal, height + (margins.pop() if margins else 0), bounces.pop() if bounces else Fraction(1))

    def normal(self, element: Element, sides: Sides) -> Vector:
        """That of the plane, which DynamO scales to the length 1."""
        norm = self.document.one(element, "Norm")
        vector = self.document.vector(norm)
        square = sum(n * n for n in vector)
        length = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
        if square == 0 or length * length != square:
            self.fail(norm, "", "its length is 0 or no fraction: a wall of a billiard has a normal of exactly length 1")
        if any(n != 0 and side is not None for n, side in zip(vector, sides)):
            self.fail(element, "Norm", "the wall lies across a periodic side")
        return tuple(n / length for n in vector)


def read(path: str) -> Configuration:
    """Raises InputError."""
    return _Reader(path).read()
