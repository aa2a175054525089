"""Files of other programs as tables of waypoints or pieces, which `clearance` reads, or as billiards with their
histories, which `certify` reads (docs/others.md).

    python3 -m voroproof.importers jupedsim trajectories.sqlite --radius 0.2 -o agents.csv
    voroproof clearance agents.csv --required 0

Each importer writes numbers exactly, and says in remarks what the file cannot say and which digits are
lost. The remarks stand in the table as well, and what reads it repeats them, or in the scene.
"""

from . import (aa_sipp, ais, bluesky, dynamo, gsd_file, jupedsim, lammps_data, lammps_dump, mapf, polynomials, skybrush,
               xyz)
from .pieces import Pieces
from .table import Table

FORMATS = {module.NAME: module for module in (aa_sipp, ais, bluesky, dynamo, gsd_file, jupedsim, lammps_data, lammps_dump,
                                              mapf, polynomials, skybrush, xyz)}

__all__ = ["FORMATS", "Pieces", "Table", "aa_sipp", "ais", "bluesky", "dynamo", "gsd_file", "jupedsim", "lammps_data",
           "lammps_dump", "mapf", "polynomials", "skybrush", "xyz"]
