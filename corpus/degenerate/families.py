"""All families, in the order in which they are listed."""
from degenerate import few
from degenerate.case import FAMILIES

MODULES = (few,)


def all_families():
    return FAMILIES
