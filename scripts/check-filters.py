#!/usr/bin/env python3
"""Proves by Gappa the bounds of rounding errors from which the filters are built (docs/proved.md, section 6).

usage: scripts/check-filters.py

Each script of proofs/filters/ is about some lines of code, which must be there as CODE below has them. The constant
of its bound is read out of the sources (BOUNDS), with what the other constants that rest on it must leave room for
(ROOM). A constant that is too small is not proved; a changed line of code fails until its script is looked at. Exit
code 77 where Gappa is missing.
"""
import pathlib
import re
import shutil
import subprocess
import sys

TREE = pathlib.Path(__file__).resolve().parents[1]
SAME_SIGN, OTHER_SIGN = "[1b-1000, 2]", "[-2, -1b-1000]"

# File, lines as they must stand there.
CODE = [
    ("filtered/numbers/jet.h", """  two_sum_of(a.hi, b.hi, s, e);
  Dd<T> r;
  two_sum_of<T>(s, e + (a.lo + b.lo), r.hi, r.lo);
"""),
    ("filtered/numbers/jet.h", """  const T p = a.hi * b.hi;
  const T e = product_error(a.hi, b.hi, p) + (a.hi * b.lo + a.lo * b.hi);
  const T s = p + e;
  return {s, e - (s - p)};
"""),
    ("filtered/numbers/jet.h", "          a.v.hi * b.d + a.d * b.v.hi,\n"),
    ("filtered/search/rough_judge.cpp", "  return {bx * cy - by * cx, "),
    ("exact/predicates.h", "  return squared(dx) + squared(dy) - squared(dr);\n"),
    ("exact/predicates.h", "  return x1 * y2 - y1 * x2;\n"),
]

# Name: script, its cases, file, pattern of the constant.
BOUNDS = {
    "sum of double-doubles": (
        "dd_sum", [{"RANGE": SAME_SIGN, "SIGN": "+"}, {"RANGE": OTHER_SIGN, "SIGN": "-"}],
        "filtered/numbers/jet.h", r"a\.e_v \+ b\.e_v \+ (\d+) \* jet_w \* V"),
    "product of double-doubles": (
        "dd_product", [{}], "filtered/numbers/jet.h", r"//   a \* b  errs by at most (\d+) w \|a\.hi b\.hi\|"),
    "sum of two products": (
        "two_products", [{"RANGE": SAME_SIGN, "SIGN": "+"}, {"RANGE": OTHER_SIGN, "SIGN": "-"}],
        "filtered/numbers/bound.h", r"2 \* eta1 \* eta2 \+ \((\d+) \* unit_roundoff \* size"),
    "tangency": (
        "tangency", [{"RANGE_P": "[1, 2]", "RANGE_R": "[0, 2]"}, {"RANGE_P": "[0, 2]", "RANGE_R": "[1, 2]"}],
        "filtered/numbers/bound.h", r"\* eta\) \* eta \+ \((\d+) \* unit_roundoff \* size"),
}

# Constants that must be greater than what is proved for the operations of which the computation consists.
SUM, PRODUCT = "sum of double-doubles", "product of double-doubles"
ROOM = [
    ("product of jets", "filtered/numbers/jet.h", r"a\.e_v \* b\.e_v \+ (\d+) \* jet_w \* V", [PRODUCT]),
    ("place of a centre", "filtered/search/newton_step.cpp", r"v_rad \* far \+ (\d+) \* w \*", [PRODUCT, SUM]),
    ("tangency jet", "filtered/search/newton_step.cpp", r"\* e_r \+ (\d+) \* w \* p\.V", [PRODUCT, SUM, SUM]),
    ("determinant jet", "filtered/search/newton_step.cpp", r"next\(e_s\) \+ (\d+) \* w \* x\.V", [PRODUCT, SUM]),
]


def constant(file, pattern):
    found = re.findall(pattern, (TREE / file).read_text())
    if len(found) != 1:
        raise SystemExit(f"check-filters: {file}: {len(found)} places like {pattern}, not one")
    return int(found[0])


def proved(script, case, bound):
    text = (TREE / "proofs" / "filters" / f"{script}.gappa").read_text()
    for name, value in sorted(case.items(), reverse=True):
        text = re.sub(rf"\b{name}\b", value, text)
    done = subprocess.run(["gappa"], input=text.replace("BOUND", str(bound)), capture_output=True, text=True)
    return None if done.returncode == 0 and "Error" not in done.stderr else done.stderr


def main():
    if not shutil.which("gappa"):
        print("check-filters: skipped: gappa is not installed (scripts/install-deps.sh proofs)")
        return 77
    bad = [f"{file} has no longer the lines of a script in proofs/filters:\n{lines}"
           for file, lines in CODE if (TREE / file).read_text().count(lines) != 1]
    bounds = {}
    for name, (script, cases, file, pattern) in BOUNDS.items():
        bounds[name] = constant(file, pattern)
        for case in cases:
            why = proved(script, case, bounds[name])
            if why:
                bad.append(f"{name}: {bounds[name]} roundings are not proved ({script}.gappa {case}):\n{why}")
    for name, file, pattern, parts in ROOM:
        total = sum(bounds[part] for part in parts)
        if constant(file, pattern) <= total:
            bad.append(f"{name}: {constant(file, pattern)} is not more than {total}, of {', '.join(parts)}")
    print("\n".join(bad) or f"{len(bounds)} bounds proved, {len(ROOM)} that are made of them have room")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
