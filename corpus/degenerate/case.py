"""Cases, and the list of all."""
import re
import textwrap
from dataclasses import dataclass, field

from degenerate.scene import exact

FAMILIES = {}  # name: (one line on it, function that yields its cases)


@dataclass
class Case:
    name: str
    story: str
    scene: object
    instants: list
    tags: list
    wrong: list = field(default_factory=list)
    verdict: str = "certified"
    picture: int = 0  # which instant is drawn
    events: tuple = None  # how many flips, collisions and maneuvers there must be
    flips: dict = None  # how many of which kind (paper, Figs. 9 to 14)
    # Truths under which the exact history is certified. A recorded motion with rounded collision
    # times is another motion: a tie after a collision is one only in the exact truth.
    truths: tuple = ("exact", "recorded")
    # Midpoints at which the brute force has nothing to say, because a point touches something.
    unseen: int = 0

    # The feature that the program needs before it can make this case; until then the case is left out.
    awaits: str = None

    def __post_init__(self):
        if not re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", self.name):
            raise ValueError(f"{self.name}: not a name for a folder")
        self.story = " ".join(textwrap.dedent(self.story).split())
        self.instants = [exact(t) for t in self.instants]
        self.family = None


def family(name, line):
    def register(function):
        FAMILIES[name] = (line, function)
        return function
    return register


def cases_of(name):
    cases = list(FAMILIES[name][1]())
    for case in cases:
        case.family = name
    names = [case.name for case in cases]
    if len(set(names)) != len(names):
        raise ValueError(f"{name}: two cases of one name in {sorted(names)}")
    return cases
