"""XML files without declarations, in bounded memory and time."""

import contextlib
import zlib
from fractions import Fraction
from typing import Callable, Dict, Iterable, List, NoReturn, Optional, Tuple
from xml.parsers import expat

from . import numbers
from .faults import fail, printable
from .lines import binary_input

DEEPEST = 16  # levels of nesting, as in the program's own files
MOST_BYTES = 1 << 30  # after expansion, as in the program's own files
MOST_ELEMENTS = 1_000_000  # that are kept
LONGEST_TAG = 1 << 20  # bytes
_CHUNK = 1 << 16


class Element:
    """A tag with its attributes and the elements within; text within is not kept."""

    __slots__ = ("tag", "attributes", "children", "line")

    def __init__(self, tag: str, attributes: Dict[str, str], line: int):
        self.tag = tag
        self.attributes = attributes
        self.children: List["Element"] = []
        self.line = line


class Markup:
    """An XML file, and what its elements must have. All methods raise InputError."""

    def __init__(self, path: str):
        self.path = path

    def read(self, passing: Tuple[str, ...], take: Callable[[Element], None]) -> Element:
        """The root. Elements whose tags from the root on are `passing` go to `take` when they end, and are not kept."""
        return _Parse(self.path, passing, take).root()

    def fail(self, element: Element, field: str, reason: str) -> NoReturn:
        """Names the element by its tag, and by its attribute Name if it has one."""
        words = (element.tag, element.attributes.get("Name", ""), field)
        fail(self.path, element.line, " ".join(filter(None, words)), reason)

    def children(self, element: Element, tag: str) -> List[Element]:
        """The elements within, all of which have this tag."""
        for child in element.children:
            if child.tag != tag:
                self.fail(element, child.tag, "not known here")
        return element.children

    def at_most_one(self, element: Element, tag: str) -> Optional[Element]:
        found = [child for child in element.children if child.tag == tag]
        if len(found) > 1:
            self.fail(element, tag, "a second time")
        return found[0] if found else None

    def one(self, element: Element, tag: str) -> Element:
        return self.at_most_one(element, tag) or self.fail(element, tag, "missing")

    def text(self, element: Element, name: str) -> str:
        if name not in element.attributes:
            self.fail(element, name, "missing")
        return element.attributes[name]

    def number(self, element: Element, name: str) -> Fraction:
        try:
            return numbers.decimal(self.text(element, name))
        except ValueError as error:
            self.fail(element, name, str(error))

    def integer(self, element: Element, name: str) -> int:
        try:
            return numbers.integer(self.text(element, name))
        except ValueError as error:
            self.fail(element, name, str(error))

    def vector(self, element: Element) -> Tuple[Fraction, Fraction, Fraction]:
        """The attributes x, y and z."""
        return self.number(element, "x"), self.number(element, "y"), self.number(element, "z")

    def require_known(self, element: Element, attributes: Iterable[str], children: Iterable[str]) -> None:
        """Refuses what else stands there: it may mean what nobody here knows."""
        for name in element.attributes:
            if name not in attributes:
                self.fail(element, name, "not known here")
        for child in element.children:
            if child.tag not in children:
                self.fail(element, child.tag, "not known here")


class _Parse:

    def __init__(self, path: str, passing: Tuple[str, ...], take: Callable[[Element], None]):
        self.path = path
        self.passing = passing
        self.take = take
        self.top: Optional[Element] = None
        self.open: List[Element] = []
        self.kept = 0
        self.parser = expat.ParserCreate("utf-8")
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        # Entities, with which a short file may stand for an endless one, need a declaration.
        self.parser.StartDoctypeDeclHandler = self.declare

    def fail(self, reason: str) -> NoReturn:
        fail(self.path, self.parser.CurrentLineNumber, "", reason)

    def declare(self, *_: object) -> None:
        self.fail("a declaration of the document's type: such files are not read")

    def start(self, tag: str, attributes: Dict[str, str]) -> None:
        if len(self.open) == DEEPEST:
            self.fail(f"more than {DEEPEST} levels of nesting")
        self.kept += 1
        if self.kept > MOST_ELEMENTS:
            self.fail(f"more than {MOST_ELEMENTS} elements")
        element = Element(tag, attributes, self.parser.CurrentLineNumber)
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.top = element
        self.open.append(element)

    def end(self, _: str) -> None:
        if len(self.open) == len(self.passing) and all(
                element.tag == tag for element, tag in zip(self.open, self.passing)):
            self.take(self.open[-1])
            self.kept -= 1 + len(self.open[-1].children)
            self.open[-2].children.pop()
        self.open.pop()

    def root(self) -> Element:
        with contextlib.ExitStack() as stack:
            try:
                file = binary_input(self.path, stack)
                self.feed(iter(lambda: file.read(_CHUNK), b""))
            except expat.ExpatError as error:
                fail(self.path, error.lineno, "", f"no XML: {printable(expat.ErrorString(error.code))}")
            except (OSError, EOFError, zlib.error) as error:
                fail(self.path, 0, "", getattr(error, "strerror", None) or str(error))
        return self.top

    def feed(self, chunks: Iterable[bytes]) -> None:
        fed = 0
        for chunk in chunks:
            fed += len(chunk)
            if fed > MOST_BYTES:
                self.fail(f"more than {MOST_BYTES} bytes")
            self.parser.Parse(chunk, False)
            # The parser looks at an unfinished tag anew whenever it is given more of it.
            if fed - self.parser.CurrentByteIndex > LONGEST_TAG:
                self.fail(f"a tag of more than {LONGEST_TAG} bytes")
        self.parser.Parse(b"", True)
