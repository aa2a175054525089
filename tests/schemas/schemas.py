"""The schemas of packaging/schemas/, applied to files by Debian's python3-jsonschema."""

import copy
import json
import pathlib

import jsonschema

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "packaging" / "schemas"
# The names of the schemas. A history and an index have one for each kind of line.
NAMES = sorted(path.name.removesuffix(".schema.json") for path in FOLDER.glob("*.schema.json")
               if not path.name.startswith("common."))
# The formats of lines: the schema, and the kind of those between the first and the last.
LINES = {"voroproof-history": ("history", "event"), "voroproof-index": ("index", "entry")}


def load(name):
    return json.loads((FOLDER / f"{name}.schema.json").read_text())


def closed(schema):
    """The schema, but fields that it does not describe are errors: for what this program writes."""
    schema = copy.deepcopy(schema)

    def close(node):
        if isinstance(node, list):
            for element in node:
                close(element)
        elif isinstance(node, dict):
            for key, value in node.items():
                if key in ("properties", "$defs"):
                    for inner in value.values():
                        close(inner)
                elif key not in ("if", "then", "else", "not"):
                    close(value)
            if "properties" in node:
                node.setdefault("additionalProperties", False)

    close(schema)
    return schema


class Schema:
    """A schema, or one of its definitions."""

    def __init__(self, name, definition=None, strangers=True):
        whole = load(name) if strangers else closed(load(name))
        resolver = jsonschema.RefResolver((FOLDER / f"{name}.schema.json").as_uri(), whole)
        part = whole if definition is None else {"$ref": f"#/$defs/{definition}"}
        self.validator = jsonschema.Draft202012Validator(part, resolver=resolver)

    def fault(self, document):
        """The fault of the document; None for none."""
        error = jsonschema.exceptions.best_match(self.validator.iter_errors(document))
        return None if error is None else f"{error.json_path}: {error.message[:200]}"


class Files:
    """All schemas, each made once."""

    def __init__(self, strangers=True):
        self.schemas = {}
        self.strangers = strangers

    def schema(self, name, definition=None):
        key = name, definition
        if key not in self.schemas:
            self.schemas[key] = Schema(name, definition, self.strangers)
        return self.schemas[key]

    def fault(self, text):
        """The fault of a file of any of the formats; None for none."""
        try:
            first = json.loads(text.splitlines()[0])
        except (ValueError, IndexError):
            first = None
        for name, of_lines in LINES.items():
            if isinstance(first, dict) and first.get("format") == name:
                return self.fault_of_lines(text, *of_lines)
        try:
            document = json.loads(text)
        except ValueError as error:
            return str(error)
        name = document.get("format") if isinstance(document, dict) else None
        if not isinstance(name, str) or name.removeprefix("voroproof-") not in NAMES:
            return "no format that has a schema"
        return self.schema(name.removeprefix("voroproof-")).fault(document)

    def fault_of_lines(self, text, name, between):
        lines = text.removesuffix("\n").split("\n")
        for number, line in enumerate(lines):
            kind = "header" if number == 0 else "last" if number == len(lines) - 1 else between
            try:
                fault = self.schema(name, kind).fault(json.loads(line))
            except ValueError as error:
                fault = str(error)
            if fault is not None:
                return f"line {number + 1}: {fault}"
        return None
