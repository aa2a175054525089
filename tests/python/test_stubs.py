"""The stubs say what the compiled part has, and everything public is documented."""

import ast
import inspect
import pathlib

import voroproof as vp
from voroproof import _core

STUB = pathlib.Path(vp.__file__).with_name("_core.pyi")


def own(names):
    return {name for name in names if not name.startswith("_") or name == "__init__"}


def members(cls):
    return own(name for name in vars(cls))


def test_the_stub_is_complete():
    declared, classes = set(), {}
    for node in ast.parse(STUB.read_text()).body:
        if isinstance(node, ast.ClassDef):
            classes[node.name] = own(m.name for m in node.body if isinstance(m, ast.FunctionDef))
            declared.add(node.name)
        elif isinstance(node, ast.FunctionDef):
            declared.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            declared.add(node.target.id)
    assert declared == own(dir(_core))
    for name, told in classes.items():
        has = members(getattr(_core, name))
        # A class that cannot be made in Python has an __init__ of pybind11's that raises.
        assert told == has or told == has - {"__init__"}, name


def test_everything_public_is_documented():
    for name in vp.__all__:
        thing = getattr(vp, name)
        if not callable(thing) or name == "event_dtype":
            continue
        assert inspect.getdoc(thing), name
        if inspect.isclass(thing) and thing.__module__.startswith("voroproof") and not issubclass(thing, tuple):
            for member, value in vars(thing).items():
                if not member.startswith("_") and callable(value):
                    assert inspect.getdoc(value), f"{name}.{member}"


def test_the_package_is_typed():
    assert STUB.with_name("py.typed").exists()
