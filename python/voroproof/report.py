"""The certifier: proves a history, refutes it with evidence, or says what it cannot decide."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple, Union

from . import _core
from .files import write_whole
from .history import History, Progress
from .scene import Number, Path, Scene

if TYPE_CHECKING:
    from .billiard import Billiard, BilliardHistory

#: Two Fractions with the number between them; equal where it is given exactly.
Bounds = Tuple[Fraction, Fraction]


@dataclass(frozen=True)
class WitnessMotion:
    """A generator near the event: at t its centre is (x + vx (t - t0), y + vy (t - t0)).

    The signed radius of the container is negative.
    """

    generator: int
    t0: Fraction
    x: Bounds
    y: Bounds
    vx: Bounds
    vy: Bounds
    signed_radius: Bounds


@dataclass(frozen=True)
class Witness:
    """Evidence that anybody can check by hand or with a computer algebra system, in Fractions.

    `polynomial`: the coefficients, of 1, t, t^2, ..., of what `polynomial_is` names; it has exactly
    one root in `root`, which is the exact time of the event. Or: at `t` the two overlap, or the circle
    of `vertex` contains a point of `contains`. docs/certificate.md, section 9.
    """

    generators: List[WitnessMotion]
    polynomial_is: str
    polynomial: List[Bounds]
    root: Optional[Bounds]
    t: Optional[Fraction]
    vertex: Optional[Tuple[int, int, int]]
    contains: Optional[int]


@dataclass(frozen=True)
class Divergence:
    """Where a refuted history is wrong.

    `fault` is such as "missing event"; `line` that of the file: event k is on line k + 2; `t` the time
    of the claim, or of the truth where no claim is at fault; `truth` what is true, in one sentence;
    `edge` flips, or `pair` touches, in truth.
    """

    fault: str
    line: int
    t: float
    truth: str
    edge: Optional[Tuple[int, int, int, int]]
    pair: Optional[Tuple[int, int]]
    witness: Witness


@dataclass(frozen=True)
class Leniency:
    """Something that was accepted although it is not exact (docs/claim.md, section 5)."""

    name: str
    words: str
    count: int


@dataclass(frozen=True, repr=False)
class Report:
    """The certifier's findings. docs/claim.md states what each verdict says.

    `verdict` is "certified", "refuted" or "undecided"; `words` the same as the program has it, with
    "(collisions alone)" behind it where only these were judged; `about` which events, which truth, up to
    when, within which tolerances; `reservations` what it is not about and what was accepted that is not
    exact, each a line; `reason` why it is not certified. The first
    `prefix_events` events are right, and nothing is missing before `prefix_t`. `evidence` says how the
    witness of a refutation was checked. `json` is the report's file.
    """

    verdict: str
    words: str
    about: str
    reservations: List[str]
    reason: str
    divergence: Optional[Divergence]
    evidence: str
    prefix_events: int
    prefix_t: float
    flips: int
    collisions: int
    maneuvers: int
    leniency: List[Leniency]
    remarks: List[str]
    json: str

    @property
    def certified(self) -> bool:
        return self.verdict == "certified"

    def explain(self) -> str:
        """The report in words, several lines, with its witness."""
        return _core.explain(self.json)

    def to_dict(self) -> Dict[str, Any]:
        """The fields of the report's file (packaging/schemas/report.schema.json)."""
        return json.loads(self.json)

    def write(self, path: Path) -> None:
        """Writes the report's file, whole or not at all. Raises OSError."""
        write_whole(path, self.json)

    def __str__(self) -> str:
        said = self.words + (f": {self.reason}" if self.reason else "")
        return said + (f" ({'; '.join(self.reservations)})" if self.reservations else "")

    def __repr__(self) -> str:
        return f"<Report: {self}>"


def _report(fields: Dict[str, Any]) -> Report:
    divergence = fields["divergence"]
    if divergence is not None:
        witness: Dict[str, Any] = divergence["witness"]
        witness["generators"] = [WitnessMotion(*motion) for motion in witness["generators"]]
        witness["vertex"] = witness["vertex"] and tuple(witness["vertex"])
        divergence["witness"] = Witness(**witness)
        fields["divergence"] = Divergence(**divergence)
    fields["leniency"] = [Leniency(*entry) for entry in fields["leniency"]]
    return Report(**fields)


def certify(scene: "Union[Scene, Billiard]", history: "Union[History, BilliardHistory]", *, truth: str = "exact",
            events: str = "all", tolerance: Number = 1e-6, law_tolerance: Number = 1e-9, order: str = "format",
            strict: bool = False, threads: int = 1, max_bits: int = 32768, progress: Optional[Progress] = None) -> Report:
    """Proves the history of the scene, refutes it with evidence, or says what it cannot decide.

    `truth` is "exact", the true motion of the scene, or "recorded", the motion that the history's
    own collision times and velocities define. With the events "collisions" flips and the initial
    diagram are passed over, and the verdict says so. `tolerance` is one of times, `law_tolerance` one of
    velocities, relative to the speeds involved. With the order "any" collisions and maneuvers of one
    instant may come in any order in which every collision is of two that touch and approach then,
    and no such pair is left (exact truth). With `strict` swaps, other orders, unoriented edges
    and another horizon are refuted. `progress(t, events)` is called several times a second and once at the end.
    Ctrl-C raises KeyboardInterrupt. A billiard has collisions and maneuvers only, and neither `strict` nor
    another order.

    Raises InputError where the history is none or not of this scene, Interrupted where `progress`
    returns False, and ValueError for tolerances without meaning.
    """
    return _report(_core.certify(scene._core, history._core, progress, truth, events, tolerance,
                                 law_tolerance, order, strict, threads, max_bits))


def certify_files(scene: Path, history: Path, *, truth: str = "exact", events: str = "all",
                  tolerance: Number = 1e-6, law_tolerance: Number = 1e-9, order: str = "format", strict: bool = False,
                  threads: int = 1,
                  max_bits: int = 32768, progress: Optional[Progress] = None) -> Report:
    """Certifies files in any format that the program reads; see `certify`."""
    return _report(_core.certify_files(os.fspath(scene), os.fspath(history), progress, truth, events,
                                       tolerance, law_tolerance, order, strict, threads, max_bits))
