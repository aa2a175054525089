"""How Sphinx makes the site, from the documents as they stand in the repository (scripts/site.sh)."""
import os
import pathlib
import re
import sys

from pygments.lexers.data import JsonLexer
from sphinx.errors import ExtensionError

ROOT = pathlib.Path(__file__).resolve().parents[2]
NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")

project = "voroproof"
author = "the authors of voroproof"
version = release = os.environ["VOROPROOF_VERSION"]

extensions = ["myst_parser", "sphinx.ext.autodoc"]
exclude_patterns = []
source_suffix = {".md": "markdown"}
# Anchors as GitHub makes them, on which the documents rely.
myst_heading_anchors = 4
# An indented block in a document is a command, a program or what one prints: shown as it is.
highlight_language = "text"

# The reference of Python is that of the package's sources; its compiled part need not be there.
sys.path.insert(0, str(ROOT / "python"))
autodoc_mock_imports = ["voroproof._core"]
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_preserve_defaults = True
default_role = "code"
add_module_names = False

html_theme = "furo"
html_title = "voroproof"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False
html_last_updated_fmt = None
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1b5a9c", "color-brand-content": "#1b5a9c"},
    "dark_css_variables": {"color-brand-primary": "#7fb4ea", "color-brand-content": "#7fb4ea"},
}

# The text that replaces a comment of a document in the site, where pages are made that the repository lacks.
PLAYER = """
<div class="player">
<iframe src="../player.html" title="The player, with a history of 30 disks" loading="lazy"></iframe>
<p>The player, with a history of 30 disks: press play, or choose an event.
<a href="../player.html">Open it as a page of its own.</a></p>
</div>
"""
PAGES = """
<p class="buttons"><a href="../player.html">Open a player</a> <a href="../certifier.html">Open the certifier</a></p>
"""


def fill_in(app, name, source):
    text = source[0].replace("<!-- player -->", PLAYER).replace("<!-- pages -->", PAGES)
    # Notebooks are pages here.
    source[0] = re.sub(r"\]\((notebooks/[\w-]+)\.ipynb\)", r"](\1.md)", text)


def mark_code(app, what, name, found, options, lines):
    """Indented blocks of docstrings are Python."""
    marked = []
    for k, line in enumerate(lines):
        if line.startswith("    ") and k > 0 and not lines[k - 1] and (k < 2 or not lines[k - 2].startswith("    ")):
            marked += [".. code-block:: python", ""]
        marked.append(line)
    lines[:] = marked


def skip_fields(app, what, name, found, skip, options):
    """Fields of a named tuple are in its signature."""
    return True if (found.__doc__ or "").startswith("Alias for field number") else None


def replace_once(text, old, new):
    if text.count(old) != 1:
        raise ExtensionError(f"the theme has changed: {old!r} is {text.count(old)} times in it")
    return text.replace(old, new)


def finish_theme(app, failure):
    """Makes Debian's copy of the theme one that works from a folder: no style sheet of the system's root, no
    modules of scripts, which browsers load from servers only, and dark where the system is."""
    if failure:
        return
    static = pathlib.Path(app.outdir) / "_static"
    style = static / "styles" / "furo.css"
    text = style.read_text()
    text = replace_once(text, "@import url(/javascript/normalize.css/normalize.css);", NORMALIZE.read_text())
    dark = re.search(r"body\[data-theme=\"dark\"\] \{([^}]*)\}", text)
    style.write_text(text + "@media screen and (prefers-color-scheme: dark) {\n"
                     '  body[data-theme="auto"] {' + dark[1] + "}\n}\n")
    scripts = static / "scripts"
    gumshoe = (scripts / "gumshoe-patched.js").read_text()
    script = replace_once((scripts / "furo.js").read_text(), 'import Gumshoe from "./gumshoe-patched.js";', "")
    (scripts / "furo.js").write_text(gumshoe + script)
    (scripts / "gumshoe-patched.js").unlink()


def setup(app):
    app.add_lexer("jsonl", JsonLexer)
    app.connect("source-read", fill_in)
    app.connect("autodoc-process-docstring", mark_code)
    app.connect("autodoc-skip-member", skip_fields)
    app.connect("build-finished", finish_theme)
