#!/usr/bin/env python3
"""Checks that all files have one version, that of CMakeLists.txt, and say the same of the project. Prints FILE: reason.

usage: scripts/check-release.py [--final]     --final: also that the tree is clean, and what it describes released

Without python3-yaml only the keys of CITATION.cff are looked at."""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
final, faults = sys.argv[1:] == ["--final"], []


def expect(holds, name, reason):
    faults.extend([] if holds else [f"{name}: {reason}"])


def require(name, of, keys, where=""):
    for key in keys.split():
        expect(of.get(key), name, f"lacks {key}{where}")


def text(name):
    return (ROOT / name).read_text() if (ROOT / name).is_file() else ""


version = re.search(r"^project\(voroproof VERSION (\d+\.\d+\.\d+)", text("CMakeLists.txt"), re.M)[1]
doi = re.search(r"doi:(\S+\w)", text("README.md"))[1]
for name, pattern, wanted in (("CITATION.cff", r"^version: (.+)", version), ("codemeta.json", r'^  "version": "(.+)"', version),
                              ("CITATION.cff", r"^license: (.+)", "GPL-3.0-or-later"),
                              ("codemeta.json", r'"https://spdx.org/licenses/(.+)"', "GPL-3.0-or-later"),
                              ("CITATION.cff", r"^ +doi: (.+)", doi), ("codemeta.json", r'"@id": "https://doi.org/(.+)"', doi),
                              ("CHANGELOG.md", r"\A# .*\n\n## (?:Unreleased \()?([^\s)]+)\)?$", version),
                              ("packaging/debian/changelog", r"\Avoroproof \((.+)-\d+\)", version),
                              ("packaging/debian/control", r"^Package: libvoroproof(\d\S*)", version.rpartition(".")[0]),
                              ("docs/install.md", r"voroproof-(\d\S*?)-linux", version)):
    found = (re.findall(pattern, text(name), re.M) or ["nothing"])[0]
    expect(found == wanted, name, f"has {found} instead of {wanted}")
try:
    from yaml import safe_load
except ImportError:
    def safe_load(words):
        return dict(re.findall(r"^([a-z-]+):(.*\n(?: .*\n)*)", words, re.M))
try:
    cff, meta = safe_load(text("CITATION.cff")) or {}, json.loads(text("codemeta.json") or "{}")
except Exception as error:  # whichever of the two
    sys.exit(f"CITATION.cff or codemeta.json: {' '.join(str(error).split())}")
require("CITATION.cff", cff, "cff-version message type title keywords abstract authors references" + " date-released" * final)
require("codemeta.json", meta, "@context @type name description keywords author referencePublication")
if isinstance(cff.get("references"), list):
    require("CITATION.cff", cff["references"][0], "type title authors", " in its reference")
    for key, other in (("title", "name"), ("keywords", "keywords"), ("abstract", "description")):
        expect(cff.get(key) == meta.get(other), "CITATION.cff", f"has another {key} than codemeta.json")
for line in subprocess.run(["git", "-C", ROOT, "status", "--porcelain", "-uall"], capture_output=True, text=True).stdout.splitlines():
    expect(not final and not re.search(r"(\.orig|\.rej|\.swp|\.pyc|~|/core)$", line), line[3:], "is not expected")
expect(not final or "Unreleased" not in text("CHANGELOG.md"), "CHANGELOG.md", "has an entry that is not released")
sys.exit("\n".join(faults) or None)
