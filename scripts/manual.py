#!/usr/bin/env python3
"""Manual pages, and completions for bash, zsh and fish, from what `voroproof help --json` says.

usage: scripts/manual.py HELP.JSON DESTINATION
  writes DESTINATION/man1/*.1, DESTINATION/bash/voroproof, DESTINATION/zsh/_voroproof and
  DESTINATION/fish/voroproof.fish
"""

import json
import pathlib
import sys

# The options that need no saying: of each verb, and of the program besides.
FLAG = {"type": "", "values": 0, "required": False, "repeats": False}
HELP = {"names": ["-h", "--help"], "help": "Show the help and exit.", **FLAG}
VERSION = {"names": ["--version"], "help": "Show the version and exit.", **FLAG}


def verbs(verb, path=()):
    """(path, verb) of a verb and of all below it; the path has the words after the program's name."""
    yield path, verb
    for below in verb["verbs"]:
        yield from verbs(below, path + (below["name"],))


def options(verb):
    """Its options, among them those that need no saying."""
    return [HELP, *([VERSION] if "version" in verb else []), *verb["options"]]


# ---- Manual pages


def troff(text):
    """The text as troff shows it as it is."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("^", "\\(ha")
    text = text.replace("`", "\\(ga").replace("~", "\\(ti")
    return "\n".join("\\&" + line if line.startswith(".") else line for line in text.split("\n"))


def bold(text):
    return f"\\fB{troff(text)}\\fR"


def values(option):
    return " ".join([f"\\fI{troff(option['type'])}\\fR"] * option["values"])


def is_required(option):
    """Whether no command line is without it."""
    return option["required"] and not option.get("unless")


def synopsis(verb, words):
    parts = [bold(words)]
    if verb["verbs"]:
        parts.append("\\fIVERB\\fR ...")
    else:
        parts.append("[\\fIOPTION\\fR]...")
    for option in options(verb):
        if is_required(option):
            parts.append(f"{bold(option['names'][-1])} {values(option)}")
    for argument in verb["arguments"]:
        name = f"\\fI{troff(argument['names'][-1].upper())}\\fR" + ("..." if argument["repeats"] else "")
        parts.append(name if is_required(argument) else f"[{name}]")
    return " ".join(parts)


def entry(option, is_argument):
    """The paragraph of an option or argument."""
    if is_argument:
        head = f"\\fI{troff(option['names'][-1].upper())}\\fR"
    else:
        head = ", ".join(bold(name) for name in option["names"])
        if option["values"]:
            head += " " + values(option)
    said = [troff(option["help"])]
    if option.get("choices"):
        said.append("One of " + ", ".join(bold(choice) for choice in option["choices"]) + ".")
    if option.get("default"):
        said.append(f"Default: {troff(option['default'])}.")
    if option.get("needs"):
        said.append("Only with " + ", ".join(map(bold, option["needs"])) + ".")
    if option.get("excludes"):
        said.append("Not with " + ", ".join(map(bold, option["excludes"])) + ".")
    if option.get("unless"):
        said.append(f"Required, but not with {bold(option['unless'])}.")
    elif option["required"] and not is_argument:
        said.append("Required.")
    if option["repeats"] and not is_argument:
        said.append("May be given several times.")
    return ".TP\n" + head + "\n" + "\n".join(said) + "\n"


def page(top, path, verb):
    words = " ".join((top["name"], *path))
    name = words.replace(" ", "-")
    text = f'.TH {troff(name.upper())} 1 "" "{troff(top["producer"])}" "User Commands"\n'
    description = verb["description"].replace("\n", " ")
    text += f".SH NAME\n{troff(name)} \\- {troff(description)}\n"
    text += f".SH SYNOPSIS\n{synopsis(verb, words)}\n"
    if verb["verbs"]:
        text += ".SH VERBS\n"
        for below in verb["verbs"]:
            text += f".TP\n{bold(words + ' ' + below['name'])}\n{troff(below['description'])}.\n"
            text += f"See {bold(name + '-' + below['name'])}(1).\n"
    for title, all_of_them, is_argument in (("ARGUMENTS", verb["arguments"], True),
                                            ("OPTIONS", options(verb), False)):
        if all_of_them:
            text += f".SH {title}\n" + "".join(entry(option, is_argument) for option in all_of_them)
    if verb["notes"]:
        text += f".SH NOTES\n{troff(verb['notes'])}\n"
    if verb["examples"]:
        text += ".SH EXAMPLES\n.EX\n" + "".join(troff(line) + "\n" for line in verb["examples"]) + ".EE\n"
    others = [top["name"]] if path else []
    others += ["-".join((top["name"], *path[:depth])) for depth in range(1, len(path))] + ["voroproof-kernel"]
    text += ".SH SEE ALSO\n" + ", ".join(f"{bold(other)}(1)" for other in others) + "\n"
    return name, text


# ---- Completions


def quoted(text):
    """The text as one word of a shell."""
    return "'" + text.replace("'", "'\\''") + "'"


def fish_quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def brief(text):
    """The first sentence, on one line."""
    line = " ".join(text.split())
    return line.split(". ")[0].rstrip(".")


def takes_file(option):
    return option["type"] == "FILE"


def bash(top):
    known = [path for path, _ in verbs(top) if path]
    text = f"# Completion of {top['name']} for bash. Made by scripts/manual.py.\n"
    text += "_voroproof() {\n  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} path= words= i\n"
    text += "  COMPREPLY=()\n  for ((i = 1; i < COMP_CWORD; i++)); do\n    case \"$path ${COMP_WORDS[i]}\" in\n"
    text += "      " + " | \\\n      ".join(quoted(" " + " ".join(path)) for path in known)
    text += ") path+=\" ${COMP_WORDS[i]}\" ;;\n    esac\n  done\n"
    text += "  # The value of an option.\n  case \"$path $prev\" in\n"
    for path, verb in verbs(top):
        plain = []
        for option in options(verb):
            patterns = [quoted("".join(" " + word for word in (*path, name))) for name in option["names"]]
            if option.get("choices"):
                text += f"    {' | '.join(patterns)}) words={quoted(' '.join(option['choices']))} ;;\n"
            elif option["values"] and takes_file(option):
                text += f"    {' | '.join(patterns)}) return ;;\n"
            elif option["values"]:
                plain += patterns
        if plain:
            text += "    " + " | \\\n      ".join(plain) + ") compopt +o default; return ;;\n"
    text += "  esac\n  if [ -z \"$words\" ]; then\n    case \"$path\" in\n"
    for path, verb in verbs(top):
        names = [name for option in options(verb) for name in option["names"]]
        other = [below["name"] for below in verb["verbs"]]
        for argument in verb["arguments"]:
            other += argument.get("choices", [])
        text += f"      {quoted(''.join(' ' + word for word in path))})\n"
        text += f"        if [[ $cur == -* ]]; then words={quoted(' '.join(names))}; else words={quoted(' '.join(other))}; fi ;;\n"
    text += "    esac\n  fi\n  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$cur\")\n}\n"
    return text + "complete -o default -F _voroproof voroproof\n"


def zsh_text(text):
    for special in "\\:[]":
        text = text.replace(special, "\\" + special)
    return text


def zsh_values(option):
    if option.get("choices"):
        action = "(" + " ".join(option["choices"]) + ")"
    else:
        action = "_files" if takes_file(option) else " "
    return f":{zsh_text(option['type'])}:{action}" * option["values"]


def zsh(top):
    text = f"#compdef {top['name']}\n# Completion of {top['name']} for zsh. Made by scripts/manual.py.\n"
    for path, verb in reversed(list(verbs(top))):
        specs = []
        for option in options(verb):
            names = option["names"]
            once = "*" if option["repeats"] else f"({' '.join(names)})"
            told = f"[{zsh_text(brief(option['help']))}]{zsh_values(option)}"
            specs += [quoted(once + name + told) for name in names]
        for place, argument in enumerate(verb["arguments"], 1):
            where = "*" if argument["repeats"] else str(place)
            specs.append(quoted(where + zsh_values(argument)))
        name = "_".join(("_voroproof", *(word.replace("-", "_") for word in path)))
        text += f"{name}() {{\n"
        if verb["verbs"]:
            words = " ".join(f"{below['name']}\\:{quoted_in_list(below['description'])}" for below in verb["verbs"])
            specs += [quoted(f"1:verb:(({words}))"), quoted("*::argument:->rest")]
            text += "  local state line\n  typeset -A opt_args\n"
        text += "  _arguments -C \\\n    " + " \\\n    ".join(specs) + "\n"
        if verb["verbs"]:
            text += "  if [[ $state == rest ]]; then\n    case $line[1] in\n"
            for below in verb["verbs"]:
                text += f"      {below['name']}) {name}_{below['name'].replace('-', '_')} ;;\n"
            text += "    esac\n  fi\n"
        text += "}\n"
    return text + "_voroproof \"$@\"\n"


def quoted_in_list(text):
    """A description within ((word\\:description ...))."""
    return '"' + brief(text).replace('"', "").replace(":", " ") + '"'


def fish(top):
    text = f"# Completion of {top['name']} for fish. Made by scripts/manual.py.\n"
    paths = [" ".join(path) for path, _ in verbs(top) if path]
    text += "# Whether the words so far name this verb.\nfunction __voroproof_at\n  set -l path\n"
    text += "  for word in (commandline -opc)[2..-1]\n    if contains -- (string trim -- \"$path $word\") "
    text += " ".join(map(fish_quoted, paths)) + "\n      set -a path $word\n    end\n  end\n"
    text += "  test \"$path\" = \"$argv\"\nend\n"
    for path, verb in verbs(top):
        start = f"complete -c {top['name']} -n {fish_quoted('__voroproof_at ' + ' '.join(path))}"
        for below in verb["verbs"]:
            text += f"{start} -f -a {below['name']} -d {fish_quoted(brief(below['description']))}\n"
        for argument in verb["arguments"]:
            if argument.get("choices"):
                text += f"{start} -f -a {fish_quoted(' '.join(argument['choices']))}\n"
        for option in options(verb):
            text += start
            for name in option["names"]:
                text += f" -l {name[2:]}" if name.startswith("--") else f" -s {name[1:]}"
            if option.get("choices"):
                text += f" -x -a {fish_quoted(' '.join(option['choices']))}"
            elif option["values"]:
                text += " -r -F" if takes_file(option) else " -x"
            text += f" -d {fish_quoted(brief(option['help']))}\n"
    return text


def main():
    top = json.loads(pathlib.Path(sys.argv[1]).read_text())
    destination = pathlib.Path(sys.argv[2])
    files = {"bash/voroproof": bash(top), "zsh/_voroproof": zsh(top), "fish/voroproof.fish": fish(top)}
    for path, verb in verbs(top):
        name, text = page(top, path, verb)
        files[f"man1/{name}.1"] = text
    for name, text in files.items():
        path = destination / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="ascii")


if __name__ == "__main__":
    main()
