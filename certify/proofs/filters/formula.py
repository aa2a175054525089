"""Gappa scripts for formulas in doubles, written as the code computes them: how far the computed value is from the true one.

Each rounding is a factor 1 + d with |d| <= u, which holds where nothing overflows or underflows; so sizes may be taken
relative to a common one, which is 1 here. Errors are counted in a unit, `theta`: u itself, or what an input errs by.
"""
import itertools
import subprocess


class Formula:
    """A formula. A value is the names of its true form, of its computed one, and of their difference in thetas (none for
    exact inputs). Gappa is told how that difference is made of those of the operands; it checks that this is an identity.
    """

    def __init__(self, theta, roundoff):
        """`theta`: its least and its greatest value, as Gappa has numbers; `roundoff`: the most that u is of theta."""
        self.roundoff = roundoff
        self.lines, self.facts, self.hints = [], [], []
        self.split = ""
        self.names = itertools.count()
        if theta[0] == theta[1]:
            self.lines.append(f"theta = {theta[0]};")
        else:
            self.facts.append(f"theta in [{theta[0]}, {theta[1]}]")

    def input(self, size, error=0, least=None):
        """A number of at most this size (and not less than `least`), that errs by at most `error` thetas."""
        n = next(self.names)
        self.facts.append(f"T{n} in [{-size if least is None else least}, {size}]")
        if error == 0:
            return f"T{n}", f"T{n}", None
        self.facts.append(f"e{n} in [-{error}, {error}]")
        self.lines.append(f"C{n} = T{n} + theta * e{n};")
        return self._value(n, f"e{n}")

    def times(self, a, b):
        errors = ([f"{a[2]} * {b[1]}"] if a[2] else []) + ([f"{a[0]} * {b[2]}"] if b[2] else [])
        return self._rounded(f"{a[0]} * {b[0]}", f"{a[1]} * {b[1]}", errors)

    def plus(self, a, b, sign="+"):
        minus = "" if sign == "+" else "-1 * "
        errors = ([a[2]] if a[2] else []) + ([minus + b[2]] if b[2] else [])
        return self._rounded(f"{a[0]} {sign} {b[0]}", f"{a[1]} {sign} {b[1]}", errors)

    def minus(self, a, b):
        return self.plus(a, b, "-")

    def split_input(self, value, parts):
        """Looks at so many parts of an input's range in turn."""
        self.split = f"$ {value[0]} in {parts};"

    def script(self, value, bound):
        """That the value errs by at most `bound` thetas."""
        goal = "{ " + " /\\ ".join(self.facts) + f" -> |{value[2]}| <= {bound} }}"
        return "\n".join(self.lines + [goal] + self.hints + [self.split]) + "\n"

    def _value(self, n, error):
        self.hints.append(f"(C{n} - T{n}) / theta -> {error} {{ theta <> 0 }};")
        self.hints.append(f"C{n} -> T{n} + theta * ((C{n} - T{n}) / theta) {{ theta <> 0 }};")
        return f"T{n}", f"C{n}", f"((C{n} - T{n}) / theta)"

    def _rounded(self, true, computed, errors):
        n = next(self.names)
        self.facts.append(f"d{n} in [-{self.roundoff}, {self.roundoff}]")
        self.lines += [f"T{n} = {true};", f"C{n} = ({computed}) * (1 + theta * d{n});"]
        return self._value(n, " + ".join([f"({computed}) * d{n}"] + errors))


def exact_inputs():
    """A formula whose errors are those of its roundings, in u."""
    return Formula(("1b-53", "1b-53"), 1)


def why_not(script):
    """None where Gappa proves the script, else what it says. Of a hint that is no identity it warns."""
    done = subprocess.run(["gappa"], input=script, capture_output=True, text=True)
    # Where it halves a range until it finds a proof, it tells of the first attempts.
    said = [line for line in done.stderr.splitlines() if line != "Warning: maximum number of iterations reached."]
    return None if done.returncode == 0 and not said else "\n".join(said) or "not proved"


def paid(factor, roundings):
    """That a factor pays for so many roundings one after the other, of a sum of nonnegative numbers: up where it is more
    than 1, else down."""
    up = "+" in factor
    lines, power = [f"p0 = 1 {'-' if up else '+'} 1b-53;"], 0
    while 1 << power < roundings:
        lines.append(f"p{power + 1} = p{power} * p{power};")
        power += 1
    return "\n".join(lines + [f"{{ p{power} * ({factor}) {'>=' if up else '<='} 1 }}"]) + "\n"
