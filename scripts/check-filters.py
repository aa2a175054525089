#!/usr/bin/env python3
"""Proves by Gappa the bounds of rounding errors from which the filters are built (docs/proved.md, section 6).

usage: scripts/check-filters.py

Each script of certify/proofs/filters/ is about some lines of code, which must be there as CODE below has them. The constant
of its bound is read out of the sources (BOUNDS), with what the other constants that rest on it must leave room for
(ROOM). Other scripts are made from what the code computes: coefficients of products (FORMS), the circles of rough
judges (circles()), use of a form later (later_use()), sums with a few roundings on every way (WAYS), factors that pay
for roundings (PAID). A constant that is too small is not proved; a changed line of code fails until its script is
looked at. Exit code 77 where Gappa is missing.
"""
import math
import pathlib
import re
import shutil
import sys

TREE = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TREE / "certify" / "proofs" / "filters"))
sys.dont_write_bytecode = True
from formula import Formula, exact_inputs, paid, why_not  # noqa: E402  (the folder is named above)

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
    ("exact/predicates.h", """    const T a = e.x * t.sp - e.s * t.xp + e.p * t.xs;
    const T b = e.y * t.sp - e.s * t.yp + e.p * t.ys;
    return t.xp * a + t.yp * b;
"""),
    ("exact/predicates.h", "  T c() const { return e.x * t.yp - e.y * t.xp + e.p * t.xy; }\n"),
    ("exact/predicates.h", "  return {x, y, s, x * x + y * y - s * s};\n"),
    ("exact/predicates.h", """        xp(j.x * k.p - j.p * k.x),
        yp(j.y * k.p - j.p * k.y),
        sp(j.s * k.p - j.p * k.s),
        xs(j.x * k.s - j.s * k.x),
        ys(j.y * k.s - j.s * k.y),
        xy(j.x * k.y - j.y * k.x),
"""),
    ("filtered/search/rough_circles.h", "    const Lanes direct = t_.xp * t_.xs + t_.yp * t_.ys;\n"),
    ("filtered/search/rough_circles.h",
     "    const Lanes conjugate = t_.xs * t_.xs + t_.ys * t_.ys - t_.xy * t_.xy;\n"),
    ("filtered/search/rough_circles.h", """    eta_ = 2 * error + u * r_;
    theta_ = eta_ / r_ + 4 * u;
"""),
    ("filtered/numbers/form.h", "    return p[i] * q[k - i] + convolution<k, i + 1, last>(p, q);\n"),
    ("filtered/numbers/form.h",
     "      return form_detail::convolution<k, first, last>(twice.c, p.c) + p.c[k / 2] * p.c[k / 2];\n"),
    ("filtered/numbers/double_roots.cpp", "      w, [](double a, double b) { return 0.5 * (a + b); },\n"),
    ("filtered/numbers/double_roots.cpp", "  const double y = 1 - x;\n"),
    ("filtered/numbers/double_roots.cpp", "      w, [&](double a, double b) { return y * a + x * b; },\n"),
    ("filtered/search/bernstein.cpp", "out.c[k] = f.c[k] * (1.0 / scale[k]);\n"),
    ("exact/predicates.h", """  const A g = a - b - c;
  const A twice = b + b;
  const A four_times = twice + twice;
  return squared(g) - four_times * c;
"""),
    ("filtered/motion/window_places.h", """    const T ta = a - m.t, tb = b - m.t;
    x0 = m.x + m.vx * ta;
"""),
    # certify/proofs/Newton.v and certify/proofs/Growth.v.
    ("filtered/search/newton_step.cpp", """  const double size = std::fabs(f), step = f / slope;
  const auto sigma_within = [&](double reach) { return (e_slope + curve * reach) * up; };
  const auto least_for = [&](double sigma) { return (std::fabs(slope) - sigma) * (1 - 0x1p-50); };
  const double everywhere = least_for(sigma_within(h));
  if (!(everywhere > 0)) return unknown;
  const double reach = std::min(h, ((size * (1 + 2 * u) + e_f) / everywhere) * up + tiny);
  const double sigma = sigma_within(reach), least = least_for(sigma);
  if (!(least > 0)) return unknown;
  const double off =
      ((e_f + u * size + std::fabs(step) * sigma) / least + 2 * u * std::fabs(step)) * up + tiny;
"""),
    ("filtered/search/bernstein.cpp", """            (5 * square_root(pairs.s0) + 3 * eta) * eta + (4 * u * pairs.s0 + bound_tiny)};
  };
  return {cotangency_error(bound(with_l), bound(others)), growth};
"""),
    ("filtered/numbers/double_roots.cpp", """  const double left = (1 - p.u0) + bound.growth * p.u0;
  const double growth = ((1 - p.u1) + bound.growth * p.u1) / left;
"""),
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

# Sums of products with so many roundings on the longest way from a product to the sum, in units of u times the sum of the
# products' absolute values.
BOUND, JUDGE = "filtered/numbers/bound.h", "filtered/search/rough_judge.cpp"
PLACES = "filtered/motion/window_places.h"
CIRCLES, CONTACT = "filtered/search/rough_circles.h", "filtered/search/contact.cpp"
WAYS = [
    ("offset of two disks squared, less the reach squared", 3, CONTACT, r"(\d+) \* u \* \(R \* R \+ reach"),
    ("offset times velocity", 2, CONTACT, r"eta \* omega \+ (\d+) \* u \* R \* W"),
    ("velocity squared", 2, CONTACT, r"\* omega \+ (\d+) \* u \* W \* W"),
    ("discriminant of a contact", 2, CONTACT, r"(\d+) \* u \* \(b \* b \+ a \* size\)"),
    ("D_xp, D_yp and D_sp", 2, CIRCLES, r"\+ (\d+) \* u \* \(aj_ \* pk \+ ak_ \* pj\)"),
    ("D_xs, D_ys, D_xy", 2, CIRCLES, r"\* eta_\) \* eta_ \+ (\d+) \* u \* aj_ \* ak_"),
    ("D_xp D_xs + D_yp D_ys", 2, CIRCLES, r"(\d+) \* u \* f\.large \* f\.small"),
    ("D_xs^2 + D_ys^2 - D_xy^2", 3, CIRCLES, r"(\d+) \* u \* all \* all"),
    ("tangency, by components", 3, CIRCLES, r"(\d+) \* u \* a \* a; \}"),
    ("A and B", 3, CIRCLES, r"(\d+) \* u \* k;"),
    ("G", 2, CIRCLES, r"(\d+) \* u \* f\.large \* \(k \+ ab\)"),
    ("C", 3, CIRCLES, r"(\d+) \* u \* \(ao_ \* f\.large \+ p \* xy\)"),
    ("place at an end of a window: x", 1, PLACES, r"(\d+) \* unit_roundoff \* \(abs\(m\.x\)"),
    ("place at an end of a window: v dt", 3, PLACES, r"\((\d+) \* unit_roundoff \* v"),
    ("coefficient of a product", 5, BOUND, r"a\.err \* \(b\.size \+ b\.err\) \+ \((\d+) \* unit_roundoff"),
]

# Factors that bounds are multiplied by, and how many roundings of nonnegative numbers they pay for.
PAID = [
    ("bound_up", "filtered/numbers/bound.h", r"bound_up = (1 \+ 0x1p-\d+)", 4096),
    ("jet_up", "filtered/numbers/jet.h", r"jet_up = (1 \+ 0x1p-\d+)", 512 * 4),
    ("slope at least", "filtered/search/newton_step.cpp", r"- sigma\) \* (\(1 - 0x1p-\d+)\)", 2),
    ("rough circles", CIRCLES, r"unit_roundoff, up = (1 \+ 0x1p-\d+)", 64),
    ("rough pairs", CONTACT, r"unit_roundoff, up = (1 \+ 0x1p-\d+)", 64),
    ("radius of a ball", "filtered/numbers/double_ball.h", r"kUp = (1 \+ 0x1p-\d+)", 8),
]

# Degrees of the forms that are multiplied, from products of two linear ones up.
FORMS = [(1, 1), (2, 2), (4, 4)]


def product(formula, n, m, k):
    """Coefficient k of a product of two forms, in the scaled basis: coefficients of the factors are at most binomials."""
    terms = [formula.times(formula.input(math.comb(n, i)), formula.input(math.comb(m, k - i)))
             for i in range(max(0, k - m), min(k, n) + 1)]
    total = terms.pop()
    while terms:
        total = formula.plus(terms.pop(), total)
    return total


def square(formula, n, k):
    """Coefficient k of the square of a form: mixed products once, of twice the coefficient."""
    first, last = max(0, k - n), (k - 1) // 2
    terms = [formula.times(formula.input(2 * math.comb(n, i)), formula.input(math.comb(n, k - i))) for i in range(first, last + 1)]
    middle = [formula.times(formula.input(math.comb(n, k // 2)), formula.input(math.comb(n, k // 2)))] if k % 2 == 0 else []
    if not terms:
        return middle[0]
    total = terms.pop()
    while terms:
        total = formula.plus(terms.pop(), total)
    return formula.plus(total, middle[0]) if middle else total


def forms():
    """Name, script."""
    most = constant(BOUND, r"a\.err \* \(b\.size \+ b\.err\) \+ \((\d+) \* unit_roundoff")
    for n, m in FORMS:
        for k in range(n + m + 1):
            formula = exact_inputs()
            yield f"coefficient {k} of degrees {n} and {m}", formula.script(product(formula, n, m, k), most * math.comb(n + m, k))
        for k in range(2 * n + 1):
            formula = exact_inputs()
            yield f"coefficient {k} of a square of degree {n}", formula.script(square(formula, n, k), most * math.comb(2 * n, k))


# Cost of a form's later use, in u of the size: a level of halving, a level of evaluation, the division by binomials.
HALVING, EVALUATION, UNSCALED = 1, 4, 3


def later_use():
    formula = exact_inputs()
    yield "half of a sum", formula.script(formula.plus(formula.input(0.5), formula.input(0.5)), HALVING)
    formula = exact_inputs()
    x = formula.input(1, least=0)
    rest = formula.minus(("1", "1", None), x)
    mean = formula.plus(formula.times(rest, formula.input(1)), formula.times(x, formula.input(1)))
    formula.split_input(x, 64)
    yield "level of an evaluation", formula.script(mean, EVALUATION)
    formula = exact_inputs()
    yield "coefficient by its binomial", formula.script(formula.times(formula.input(1), formula.input(1, 1)), UNSCALED)


def too_much_later_use():
    """The value may exceed the size by its error: once more for each degree."""
    room = constant("filtered/search/bernstein.cpp", r"unit_roundoff \* \((\d+)\.0 \* degree")
    levels = constant("filtered/numbers/double_roots.h", r"kMaxDepth = (\d+)")
    cost = levels * HALVING + EVALUATION + 1
    return [f"later use: {room} u for each degree is less than {cost} u and {UNSCALED} u once"
            for degree in (4, 8) if room * degree < cost * degree + UNSCALED]


def too_much_for_cotangency():
    """Two roundings of g, twice in its square; the square and the product; their difference."""
    product = constant(BOUND, r"a\.err \* \(b\.size \+ b\.err\) \+ \((\d+) \* unit_roundoff")
    room, cost = constant(BOUND, r"sum\.err\) \* sum\.err \+ \((\d+) \* unit_roundoff"), 2 * 2 + 2 * product + 1
    return [f"cotangency: {room} u is not more than {cost} u"] if room <= cost else []


def circles():
    """Rough circles, R = 1: errors in theta, of which u is at most a quarter. The inputs' are those of the comment in the code."""
    theta = ("1b-51", "1b-" + str(constant(CIRCLES, r"theta_ <= 0x1p-(\d+)")))
    coarse = r"exists\(k, (\d+) \* r4_ \* r_ \* theta_, (\d+) \* r2_ \* theta_, (\d+) \* r4_ \* theta_\)"
    direct, second, conjugate = constants(CIRCLES, coarse)
    g, c = constants(CIRCLES, r"\? (\d+) \* r2_ \* r_ : (\d+)\.0\) \* r4_ \* theta_")
    first = constant(CIRCLES, r"//   D_xp = x_j p_k - p_j x_k +2 R\^3 +(\d+) R")
    tangency = constant(CIRCLES, r"//   p = x\^2 \+ y\^2 - s\^2 +R\^2 +(\d+) R")
    inputs = {"x": (1, 1), "p": (1, tangency), "xp": (2, first), "xs": (2, second), "a": (6, c)}
    for name, products, signs, bound in [
            ("D_xp", ["x p", "p x"], "-", first), ("D_xs", ["x x", "x x"], "-", second),
            ("D_xp D_xs + D_yp D_ys", ["xp xs", "xp xs"], "+", direct),
            ("D_xs^2 + D_ys^2 - D_xy^2", ["xs xs"] * 3, "+-", conjugate),
            ("A, B and C", ["x xp", "x xp", "p xs"], "-+", c), ("G", ["xp a", "xp a"], "+", g)]:
        formula = Formula(theta, 0.25)
        terms = [formula.times(*(formula.input(*inputs[one]) for one in two.split())) for two in products]
        total = terms[0]
        for term, sign in zip(terms[1:], signs):
            total = formula.plus(total, term, sign)
        yield "rough circles: " + name, formula.script(total, bound)


def ways():
    for name, roundings, file, pattern in WAYS:
        product_of = " * ".join(f"(1 + d{k})" for k in range(roundings))
        within = " /\\ ".join(f"d{k} in [-1b-53, 1b-53]" for k in range(roundings))
        yield name, f"{{ {within} -> |{product_of} - 1| <= {constant(file, pattern)}b-53 }}\n"


def payments():
    for name, file, pattern, roundings in PAID:
        yield name, paid(text_of(file, pattern)[0].strip("(").replace("0x1p", "1b"), roundings)


def text_of(file, pattern):
    """The pattern's groups at the one place where it occurs."""
    found = list(re.finditer(pattern, (TREE / file).read_text()))
    if len(found) != 1:
        raise SystemExit(f"check-filters: {file}: {len(found)} places like {pattern}, not one")
    return found[0].groups()


def constants(file, pattern):
    return tuple(int(word) for word in text_of(file, pattern))


def constant(file, pattern):
    return constants(file, pattern)[0]


def why_not_case(script, case, bound):
    text = (TREE / "certify" / "proofs" / "filters" / f"{script}.gappa").read_text()
    for name, value in sorted(case.items(), reverse=True):
        text = re.sub(rf"\b{name}\b", value, text)
    return why_not(text.replace("BOUND", str(bound)))


def main():
    if not shutil.which("gappa"):
        print("check-filters: skipped: gappa is not installed (scripts/install-deps.sh proofs)")
        return 77
    bad = [f"{file} has no longer the lines of a script in certify/proofs/filters:\n{lines}"
           for file, lines in CODE if (TREE / file).read_text().count(lines) != 1]
    bounds = {}
    for name, (script, cases, file, pattern) in BOUNDS.items():
        bounds[name] = constant(file, pattern)
        for case in cases:
            why = why_not_case(script, case, bounds[name])
            if why:
                bad.append(f"{name}: {bounds[name]} roundings are not proved ({script}.gappa {case}):\n{why}")
    made = [*forms(), *later_use(), *circles(), *ways(), *payments()]
    for name, script in made:
        why = why_not(script)
        if why:
            bad.append(f"{name}: not proved:\n{script}{why}")
    bad += too_much_later_use() + too_much_for_cotangency()
    for name, file, pattern, parts in ROOM:
        total = sum(bounds[part] for part in parts)
        if constant(file, pattern) <= total:
            bad.append(f"{name}: {constant(file, pattern)} is not more than {total}, of {', '.join(parts)}")
    print("\n".join(bad) or f"{len(bounds)} bounds proved, {len(made)} scripts made of the code proved, {len(ROOM)} that are made of them have room")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
