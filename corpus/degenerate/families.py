"""All families, in the order in which they are listed."""
from degenerate import cocircular, configurations, contacts, few, lattices, motions, roots, swarms, symmetry
from degenerate.case import FAMILIES

MODULES = (configurations, cocircular, lattices, contacts, roots, motions, symmetry, swarms, few)


def all_families():
    return FAMILIES
