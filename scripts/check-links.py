#!/usr/bin/env python3
"""Finds links that lead nowhere and documents that no contents list, and prints them: FILE:LINE: TARGET: what is wrong.

usage: check-links.py                 all Markdown documents of the repository: relative links, pictures, anchors,
                                      folders of "make -C"; and whether the site's contents list each document
       check-links.py --site FOLDER   all pages below FOLDER: links and anchors; and whatever a page
                                      would load from the network

Links to the network are not followed. Anchors of Markdown are those that GitHub makes of headings.
"""
import html.parser
import pathlib
import re
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent


def is_remote(target):
    return re.match(r"[a-z][a-z0-9+.-]*:|//", target, re.I) is not None


# ---- Markdown


def without_code(text):
    """The text with blocks and spans of code blanked, line for line."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match[0])
    text = re.sub(r"^```.*?^```[^\n]*$", blank, text, flags=re.M | re.S)
    text = re.sub(r"(?<=\n\n)(?:    [^\n]*\n|\n(?=    ))+", blank, text)
    return re.sub(r"(`+)[^`].*?\1", blank, text)


def slugs(path):
    """The anchors of a document's headings."""
    found = set()
    text = re.sub(r"^```.*?^```[^\n]*$", "", path.read_text(), flags=re.M | re.S)
    for heading in re.findall(r"^#{1,6}\s+(.*?)\s*#*$", text, re.M):
        heading = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        unique, k = slug, 0
        while unique in found:
            k += 1
            unique = f"{slug}-{k}"
        found.add(unique)
    return found


def markdown_links(text):
    """Line and target of each link, each reference's definition and each picture."""
    text = without_code(text)
    for pattern in (r"\]\(\s*<?([^)\s>]+)>?[^)]*\)", r"^\[[^]]+\]:\s*(\S+)", r"(?:src|href)=\"([^\"]+)\""):
        for match in re.finditer(pattern, text, re.M):
            yield text.count("\n", 0, match.start()) + 1, match[1]


def markdown_files():
    """Names of all Markdown files: those that git knows, or, in an archive, those that are there."""
    if (ROOT / ".git").exists():
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "*.md"],
                                cwd=ROOT, check=True, capture_output=True, text=True).stdout
        return [name for name in listed.split("\0") if name]
    return [str(path.relative_to(ROOT)) for path in ROOT.rglob("*.md")
            if not re.match(r"build|packages|demo", path.relative_to(ROOT).parts[0])]


def documents_in_contents():
    """The documents that the first page of the site has in a table of contents, by their names in the repository."""
    names = set()
    for contents in re.findall(r"^```\{toctree\}\n(.*?)^```", (ROOT / "docs/site/index.md").read_text(), re.M | re.S):
        for line in contents.splitlines():
            names.add(re.sub(r"^.*<(.*)>$", r"\1", line) + ".md")
    return names


def check_contents():
    """The complaints that Sphinx would make of documents in no table of contents, without Sphinx."""
    listed = documents_in_contents()
    return [f"{name}: in no table of contents of docs/site/index.md" for name in sorted(markdown_files())
            if not name.startswith("docs/site/") and name not in listed]


def check_markdown():
    # The pages of the site alone link to what is made; --site checks them.
    documents = [ROOT / name for name in sorted(markdown_files())
                 if not name.startswith("docs/site/") and (ROOT / name).exists()]
    faults, count = [], 0
    for document in documents:
        text = document.read_text()
        for match in re.finditer(r"make -C ([\w./-]+)", text):
            if not (ROOT / match[1] / "Makefile").exists():
                line = text.count("\n", 0, match.start()) + 1
                faults.append(f"{document.relative_to(ROOT)}:{line}: {match[0]}: there is no such folder")
        for line, target in markdown_links(text):
            if is_remote(target):
                continue
            count += 1
            where = f"{document.relative_to(ROOT)}:{line}: {target}"
            name, _, anchor = urllib.parse.unquote(target).partition("#")
            path = (document.parent / name).resolve() if name else document
            if not path.exists():
                faults.append(f"{where}: there is no such file")
            elif ROOT not in path.parents and path != ROOT:
                faults.append(f"{where}: outside of the repository")
            elif anchor and path.suffix == ".md" and anchor not in slugs(path):
                faults.append(f"{where}: there is no such heading")
    return faults, f"{count} links of {len(documents)} documents"


# ---- Pages


class Page(html.parser.HTMLParser):
    """Collects a page's links, what it loads, and its anchors."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given[key] for key in ("id", "name") if given.get(key)}
        line = self.getpos()[0]
        for key in ("href", "src", "data", "poster"):
            if given.get(key):
                is_link = tag == "a" or (tag == "link" and given.get("rel") in ("canonical", "index", "search", "next", "prev"))
                (self.links if is_link else self.loaded).append((line, given[key]))


def check_site(folder):
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    faults, count = [], 0
    for path, page in pages.items():
        where = path.relative_to(folder)
        faults += [f"{where}:{line}: {target}: loaded from the network" for line, target in page.loaded
                   if is_remote(target) and not target.startswith(("data:", "javascript:"))]
        for line, target in page.links + page.loaded:
            if is_remote(target):
                continue
            count += 1
            name, _, anchor = urllib.parse.unquote(target).partition("#")
            name = name.partition("?")[0]
            to = (path.parent / name).resolve() if name else path
            if to.is_dir():
                to /= "index.html"
            if not to.exists():
                faults.append(f"{where}:{line}: {target}: there is no such file")
            elif anchor and to in pages and anchor not in pages[to].anchors:
                faults.append(f"{where}:{line}: {target}: there is no such anchor")
    for path in sorted(folder.rglob("*.css")):
        for target in re.findall(r"(?:url\(|@import\s+)\s*[\"']?([^\"')]+)", path.read_text()):
            if not target.startswith(("data:", "#")) and (is_remote(target) or not (path.parent / target).exists()):
                faults.append(f"{path.relative_to(folder)}: {target}: not in the site")
    return faults, f"{count} links of {len(pages)} pages"


def main():
    if sys.argv[1:2] == ["--site"] and len(sys.argv) == 3:
        faults, what = check_site(pathlib.Path(sys.argv[2]).resolve())
    elif len(sys.argv) == 1:
        faults, what = check_markdown()
        faults += check_contents()
    else:
        sys.exit(__doc__)
    print("\n".join([*faults, f"{what}: {len(faults)} faults"]))
    sys.exit(1 if faults else 0)


main()
