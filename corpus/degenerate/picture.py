"""The pictures of Cairo in a third of their bytes."""
import re
from fractions import Fraction

# Number of decimals of a pixel that are kept: finer differences are not seen.
DECIMALS = 1
DEFAULTS = re.compile(r" *(fill-rule:nonzero|(fill|stroke)-opacity:1|stroke-miterlimit:10|stroke:none);")
CAPS = "stroke-linecap:round;stroke-linejoin:round;"
PATH = re.compile(r'<path style="([^"]*)" d="([^"]*)"/>')


def number(value):
    """A multiple of 10^-DECIMALS in as few characters as it takes."""
    text = f"{float(value):.{DECIMALS}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return {"-0": "0"}.get(text, text.replace("0.", ".", 1) if re.match("-?0\\.", text) else text)


def numbers(values):
    """Numbers in a row; a sign separates as well as a blank does."""
    return re.sub(r" -", "-", " ".join(number(v) for v in values))


def relative(path):
    """A path of absolute M, L, C and Z with places rounded, and told by the steps between them."""
    here = start = (Fraction(0), Fraction(0))
    out = []
    for command, text in re.findall(r"([MLCZ])([^MLCZ]*)", path):
        if command == "Z":
            out.append("z")
            here = start
            continue
        values = [Fraction(f"{float(v):.{DECIMALS}f}") for v in text.split()]
        points = list(zip(values[::2], values[1::2]))
        out.append(command.lower() + numbers(p[k] - here[k] for p in points for k in (0, 1)))
        here = points[-1]
        if command == "M":
            start = here
    # Cairo ends what is closed by going to where it began.
    return re.sub(r"(?<=z)m[^a-z]*$", "", "".join(out))


def hexadecimal(match):
    return "#" + "".join(f"{round(float(part) * 255 / 100):02x}" for part in match.groups())


def style_of(text):
    text = DEFAULTS.sub("", text).replace(CAPS, "").strip()
    return re.sub(r"rgb\(([\d.]+)%,([\d.]+)%,([\d.]+)%\)", hexadecimal, text).rstrip(";")


def compact(svg):
    """The same picture: one path for all that follow each other in one style."""
    out, style = [], None
    for line in svg.splitlines():
        path = PATH.fullmatch(line)
        if not path:
            style = None
            out.append(line.replace("<g ", f'<g style="{CAPS[:-1]}" ', 1))
        elif style_of(path[1]) == style:
            # Steps of the next begin where the last one ended, so its first is absolute.
            out[-1] = out[-1][:-len('"/>')] + absolute_start(path[2]) + '"/>'
        else:
            style = style_of(path[1])
            out.append(f'<path style="{style}" d="{absolute_start(path[2])}"/>')
    return "\n".join(out) + "\n"


def absolute_start(path):
    return "M" + relative(path)[1:]
