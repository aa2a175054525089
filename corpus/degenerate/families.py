"""All families, in the order in which they are listed."""
from degenerate import cocircular, configurations, contacts, few, lattices
from degenerate.case import FAMILIES

MODULES = (configurations, cocircular, lattices, contacts, few)


def all_families():
    return FAMILIES
