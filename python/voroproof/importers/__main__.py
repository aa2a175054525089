"""The command: python3 -m voroproof.importers FORMAT FILE -o OUT."""

import argparse
import os
import sys
from fractions import Fraction
from typing import Any, Callable, Dict, List

from ..errors import InputError, OutputError
from . import (aa_sipp, ais, boxes, bluesky, dynamo, geography, gsd_file, jupedsim, lammps_data, lammps_dump, mapf,
               numbers, polynomials, skybrush, xyz)

BAD_INPUT, INTERNAL, MEMORY, INTERRUPTED = 2, 4, 5, 6  # as the program's


def positive(text: str) -> Fraction:
    value = number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError("not positive")
    return value


def not_negative(text: str) -> Fraction:
    value = number(text)
    if value < 0:
        raise argparse.ArgumentTypeError("negative")
    return value


def number(text: str) -> Fraction:
    try:
        return numbers.decimal(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from error


def origin(text: str) -> geography.Projection:
    parts = text.split(",")
    if len(parts) != 2:
        raise argparse.ArgumentTypeError("not LATITUDE,LONGITUDE")
    try:
        return geography.Projection(number(parts[0]), number(parts[1]))
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from error


def columns(text: str) -> Dict[str, str]:
    named = {}
    for pair in text.split(","):
        what, equals, name = pair.partition("=")
        if not equals or what not in ais.KNOWN or not name or what in named:
            raise argparse.ArgumentTypeError(f"not as in id=ship,time=when,lat=y,lon=x, with {', '.join(ais.KNOWN)}")
        named[what] = name
    return named


OPTIONS: Dict[str, Dict[str, Any]] = {
    "radius": dict(type=not_negative, metavar="R", help="the radius of every disk; without it those of the file"),
    "timestep": dict(type=positive, metavar="DT", help="how long a step takes; without it t is counted in steps"),
    "periodic": dict(choices=[boxes.UNWRAP, boxes.AS_IS], help="how coordinates of a periodic box are taken: "
                     "unwrapped by image flags, or as they stand, where no disk crosses a side"),
    "flatten": dict(action="store_true", help="leave heights out, where they differ"),
    "style": dict(choices=list(lammps_data.STYLES), help="the atom style, where the file does not say it"),
    "until": dict(type=positive, metavar="T", help="the end of motion"),
    "origin": dict(type=origin, metavar="LAT,LON", help="the point about which the Earth is taken for a plane, as in "
                   "--origin=-33.9,151.2"),
    "columns": dict(type=columns, metavar="WHAT=NAME,...", help="the names of columns: " + ", ".join(ais.KNOWN)),
    "horizon": dict(type=not_negative, metavar="T", help="the end of the history; without it the last collision of "
                    "--events"),
    "events": dict(metavar="FILE", help="the collisions of a run from this configuration: trajectory.out"),
    "history": dict(metavar="HISTORY", help="the file to write the history of --events to"),
    "longest_gap": dict(type=positive, metavar="S", help="cut a track where it has no message for so many seconds"),
}

READERS = {
    lammps_dump: ("text dumps of LAMMPS (atom, custom)", ["radius", "timestep", "periodic", "flatten"]),
    lammps_data: ("data files of LAMMPS", ["radius", "style", "until", "flatten"]),
    dynamo: ("configurations of DynamO (XML), and what its plugin Trajectory writes", ["horizon", "events", "history"]),
    xyz: ("xyz and extended xyz", ["radius", "timestep", "periodic", "flatten"]),
    gsd_file: ("GSD files of HOOMD-blue", ["radius", "timestep", "periodic", "flatten"]),
    jupedsim: ("SQLite trajectories of JuPedSim", ["radius"]),
    bluesky: ("scenarios of BlueSky (.scn)", ["radius", "origin", "until"]),
    ais: ("tables of AIS messages", ["radius", "columns", "origin", "longest_gap", "until"]),
    mapf: ("schedules of libMultiRobotPlanning (YAML)", ["radius"]),
    aa_sipp: ("logs of AA-SIPP(m) (XML)", ["radius"]),
    polynomials: ("polynomials of Crazyswarm and uav_trajectories, a file a drone", ["radius"]),
    skybrush: ("compiled shows of Skybrush (.skyc)", ["radius"]),
}
SEVERAL = {polynomials}  # those that make one table of several files


def parser() -> argparse.ArgumentParser:
    top = argparse.ArgumentParser(
        prog="python3 -m voroproof.importers", allow_abbrev=False,
        description="Make tables of paths, which voroproof clearance reads, of other programs' files, "
        "or scenes and histories, which voroproof certify reads. What the file cannot say is said, and stands in them.")
    formats = top.add_subparsers(metavar="FORMAT", required=True)
    for module, (what, options) in READERS.items():
        one = formats.add_parser(module.NAME, help=what, description=what, allow_abbrev=False)
        one.add_argument("files", metavar="FILE", nargs="+" if module in SEVERAL else 1,
                         help='"-" is standard input, where the format is text')
        one.add_argument("-o", "--output", required=True, metavar="OUT", help='"-" is standard output')
        for name in options:
            spelled = "atom-style" if name == "style" else name.replace("_", "-")
            one.add_argument("--" + spelled, dest=name, **OPTIONS[name])
        one.set_defaults(read=module.read, options=options)
    return top


def require_apart(given: argparse.Namespace) -> None:
    """No file is written that is read, or written twice."""
    read = [*given.files, getattr(given, "events", None)]
    if read.count("-") > 1:
        raise OutputError("-: would be read twice")
    written = list(filter(None, [given.output, getattr(given, "history", None)]))
    for name in filter(os.path.exists, written):
        if any(other not in (None, "-") and os.path.exists(other) and os.path.samefile(other, name) for other in read):
            raise OutputError(f"{name}: would replace the file that is read")
    if len({os.path.realpath(name) for name in written}) < len(written):
        raise OutputError(f"{given.output}: two files would be written to it")


def run(arguments: List[str]) -> int:
    given = parser().parse_args(arguments)
    require_apart(given)
    reader: Callable[..., Any] = given.read
    made = reader(*given.files, **{name: getattr(given, name) for name in given.options})
    made.write(given.output)
    beside = sys.stderr if "-" in (given.output, getattr(given, "history", None)) else sys.stdout
    print("\n".join(made.summary()), file=beside)
    return 0


def main() -> int:
    def complain(code: int, reason: object) -> int:
        print(f"voroproof.importers: {reason}", file=sys.stderr)
        return code
    try:
        return run(sys.argv[1:])
    except (InputError, OutputError) as error:
        return complain(BAD_INPUT, error)
    except OSError as error:  # from the file of rows that grows meanwhile
        return complain(BAD_INPUT, f"temporary file: {error.strerror or error}")
    except MemoryError:
        return complain(MEMORY, "out of memory")
    except KeyboardInterrupt:
        return complain(INTERRUPTED, "interrupted")
    except Exception as error:  # the last resort: one line, and its own code
        return complain(INTERNAL, f"internal error: {type(error).__name__}: {error}")


if __name__ == "__main__":
    sys.exit(main())
