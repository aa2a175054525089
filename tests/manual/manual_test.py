#!/usr/bin/env python3
"""That manual pages and completions have each verb with each of its options, and that man and the shells
take them without a word.

bash and fish are asked for completions as on a terminal; zsh, which cannot be, reads the file. A shell
that is not there is passed over, and named.

usage: manual_test.py PROGRAM
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import manual  # noqa: E402

BASH = """
source "$1"
while IFS=$'\\t' read -r line; do
  read -ra COMP_WORDS <<< "$line"
  COMP_WORDS+=("$2")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _voroproof
  echo "${COMPREPLY[*]}"
done
"""


def run(*arguments, given=None):
    return subprocess.run(arguments, input=given, capture_output=True, text=True,
                          env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8", "MANROFFSEQ": "", "MANWIDTH": "100"})


def names_of(verb):
    return {name for option in manual.options(verb) for name in option["names"]}


def pages(folder, described):
    for path, verb in described:
        page = folder / "man1" / ("-".join(("voroproof", *path)) + ".1")
        shown = run("man", "--warnings", "-E", "UTF-8", "-l", page) if shutil.which("man") else None
        if shown is not None and (shown.returncode != 0 or shown.stderr or not shown.stdout):
            yield f"man {page.name}: {shown.stderr or 'shows nothing'}"
        text = page.read_text().replace("\\-", "-")
        for name in names_of(verb) | {argument["names"][-1].upper() for argument in verb["arguments"]}:
            if f"\\f{'B' if name.startswith('-') else 'I'}{name}\\fR" not in text:
                yield f"{page.name}: nothing about {name}"


def in_bash(folder, described):
    lines = "".join(" ".join(("voroproof", *path)) + "\n" for path, _ in described)
    for typed, wanted in (("-", names_of), ("", lambda verb: {below["name"] for below in verb["verbs"]} | {
            choice for argument in verb["arguments"] for choice in argument.get("choices", [])})):
        answer = run("bash", "-c", BASH, "bash", folder / "bash/voroproof", typed, given=lines)
        if answer.stderr:
            yield f"bash: {answer.stderr}"
        for (path, verb), found in zip(described, answer.stdout.split("\n")):
            if set(found.split()) != wanted(verb):
                yield f"bash: {' '.join(path)} {typed}: {found}"
    for path, verb in described:
        for option in (option for option in verb["options"] if option.get("choices")):
            line = " ".join(("voroproof", *path, option["names"][-1])) + "\n"
            found = run("bash", "-c", BASH, "bash", folder / "bash/voroproof", "", given=line).stdout.split()
            if found != option["choices"]:
                yield f"bash: {line.strip()}: {found}"


def in_fish(folder, described):
    commands = "".join(f"echo ==; complete -C 'voroproof {' '.join((*path, '-'))}'; complete -C 'voroproof {' '.join((*path, '--'))}'\n"
                       for path, _ in described)
    answer = run("fish", "--no-config", "-c", f"source {folder}/fish/voroproof.fish\n{commands}")
    if answer.stderr:
        yield f"fish: {answer.stderr}"
    for (path, verb), found in zip(described, answer.stdout.split("==\n")[1:]):
        missing = names_of(verb) - {line.split("\t")[0] for line in found.splitlines()}
        if missing:
            yield f"fish: {' '.join(path)}: without {missing}"


def in_zsh(folder, described):
    answer = run("zsh", "-n", folder / "zsh/_voroproof")
    if answer.returncode != 0 or answer.stderr:
        yield f"zsh: {answer.stderr}"
    functions = (folder / "zsh/_voroproof").read_text().split("() {\n")
    bodies = {before.rsplit("\n", 1)[-1]: body for before, body in zip(functions, functions[1:])}
    for path, verb in described:
        body = bodies["_".join(("_voroproof", *path)).replace("-", "_")]
        for name in names_of(verb):
            if f"){name}[" not in body and f"'*{name}[" not in body:
                yield f"zsh: {' '.join(path)}: without {name}"
        for below in verb["verbs"]:
            if f" {below['name']}) _voroproof" not in body:
                yield f"zsh: {' '.join(path)}: without {below['name']}"


def main():
    told = run(sys.argv[1], "help", "--json")
    assert told.returncode == 0, told.stderr
    described = list(manual.verbs(json.loads(told.stdout)))
    faults = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "help.json").write_text(told.stdout)
        made = run(sys.executable, "-B", ROOT / "scripts/manual.py", folder / "help.json", folder)
        assert made.returncode == 0, made.stderr
        faults += pages(folder, described)
        for shell, check in (("bash", in_bash), ("fish", in_fish), ("zsh", in_zsh)):
            if shutil.which(shell):
                faults += check(folder, described)
            else:
                print(f"{shell} is not there: passed over")
    print("\n".join([*faults, f"{len(described)} verbs, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
