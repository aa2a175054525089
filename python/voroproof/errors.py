"""The module's exceptions, besides ValueError for arguments without meaning."""


class Error(Exception):
    """The base of all errors of the library."""


class InputError(Error, ValueError):
    """A scene, a history, a plan or a file that is not what it claims to be.

    `file` names the file, or "scene", "history" and "plan" for values in memory; `line` counts from
    1 and is 0 where the file as a whole is meant; `field` is such as "disks[3].velocity[0]".
    """

    def __init__(self, what: str, file: str, line: int, field: str, reason: str):
        super().__init__(what)
        self.file = file
        self.line = line
        self.field = field
        self.reason = reason

    def __reduce__(self):
        return type(self), (str(self), self.file, self.line, self.field, self.reason)


class OutputError(Error, OSError):
    """A file that cannot be written. Nothing is half-written then."""


class Undecided(Error):
    """A decision needs more than the budget (`max_bits`)."""


class Interrupted(Error):
    """`progress` returned False, where no partial result can say so."""
