"""Write the reference from the code: commands, methods, legends, files, exit codes, the Python names.

Commands and methods have anchors that stay: `commands.html#plan`, `commands.html#reproduce-landscape`,
`methods.html#dissection`. The forms of QGIS and others link to them.

Everything here comes from `firebreak describe`, `firebreak_gis.errors` and `firebreak_gis.__all__`; nothing of it is
kept in the repository. `conf.py` calls it before every build.
"""

from __future__ import annotations

import inspect
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import firebreak_gis
from firebreak_gis import errors
from firebreak_gis.landscape import legends

ROOT = Path(__file__).resolve().parents[1]
Tree = dict[str, Any]


def describe() -> Tree:
    """What `firebreak describe` says."""
    command = [sys.executable, "-m", "firebreak_gis", "describe"]
    found: Tree = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return found


def write(folder: Path) -> None:
    """Write all pages into a folder; a page whose text is as before is left alone."""
    program = describe()
    pages = {
        "commands.md": _commands(program["commands"]),
        "methods.md": _methods(program["methods"]),
        "legends.md": _legends(program["legends"]),
        "files.md": _files(program["commands"]),
        "exit-codes.md": _exit_codes(),
        "api.md": _api(),
        "contributing.md": _beside("CONTRIBUTING.md"),
        "changelog.md": _beside("CHANGELOG.md"),
    }
    folder.mkdir(exist_ok=True)
    for old in folder.glob("*.md"):
        if old.name not in pages:
            old.unlink()
    for name, text in pages.items():
        path = folder / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


def _cell(text: object) -> str:
    """Text that cannot end a cell of a table, and means just itself."""
    return re.sub(r"([\\|<>*_`\[\]$#])", r"\\\1", " ".join(str(text).split()))


def _table(heads: list[str], rows: list[list[str]]) -> str:
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def _literal(text: str) -> str:
    """Help as the terminal shows it: paragraphs, and lists of options as they are."""
    return "\n\n".join(_cell(part) for part in text.split("\n\n"))


def _commands(commands: Tree, words: str = "firebreak", level: int = 2) -> str:
    out = ["# Commands\n", "Made from `firebreak describe`.\n"] if level == 2 else []
    for name, command in commands.items():
        out += [_anchor(f"{words} {name}".partition(" ")[2]), f"{'#' * level} {words} {name}\n"]
        out += [_literal(command["help"]) + "\n", _in_python(name) if level == 2 else ""]
        rows = [
            [_name(p), _cell(p["type"]), _default(p), _cell(p.get("help", ""))] for p in command.get("parameters", [])
        ]
        if rows:
            out.append(_table(["option or argument", "kind", "default", "what"], rows))
        if command.get("commands"):
            out.append(_commands(command["commands"], f"{words} {name}", level + 1))
    return "\n".join(out)


def _anchor(words: str) -> str:
    """Target of the heading below, such as `plan`; other text of the heading may change."""
    return f"({words.replace(' ', '-').replace('_', '-')})=\n"


def _in_python(command: str) -> str:
    name = firebreak_gis.COMMANDS.get(command, command)
    return "" if name is None else f"In Python: [`fb.{name}`](api.md#fb-{name.lower().replace('_', '-')}).\n"


def _name(parameter: Tree) -> str:
    flags = parameter.get("flags")
    return " ".join(f"`{flag}`" for flag in flags) if flags else f"`{parameter['name'].upper()}`"


def _default(parameter: Tree) -> str:
    return "required" if parameter.get("required") else _cell(parameter.get("default", ""))


def _what(parameter: Tree) -> str:
    choices = ", ".join(f"`{choice}`" for choice in parameter.get("choices", []))
    return _cell(parameter.get("help", "")) + (f" One of {choices}." if choices else "")


def _methods(kinds: Tree) -> str:
    out = [
        "# Rankings and spread models\n",
        "Made from `firebreak describe`, as `firebreak methods NAME` is.\n",
    ]
    for kind, methods in kinds.items():
        out.append(f"## {kind.capitalize()}\n")
        for method in methods:
            out += [_anchor(method["name"]), f"### {method['name']}\n", _literal(method["text"]) + "\n"]
            rows = [
                [f"`{p['name']}`", _cell(p.get("default", "")), _cell(p.get("units", "")), _cell(p["text"])]
                for p in method.get("parameters", [])
            ]
            if rows:
                out.append(_table(["parameter", "default", "units", "what"], rows))
    return "\n".join(out)


def _legends(names: Tree) -> str:
    out = ["# Legends\n", "Made from the legends in the package; `firebreak legends NAME` shows one.\n"]
    for name in names:
        legend = legends.read_legend(name)
        rows = [
            [f"{e.low:g}" if e.low == e.high else f"{e.low:g} to {e.high:g}", *_classes(e), _cell(e.label)]
            for e in legend.entries
        ]
        out += [f"## {name}\n", "\n\n".join(_cell(line) for line in legend.about) + "\n"]
        out.append(_table(["code", "vegetation", "density", "label"], rows))
    return "\n".join(out)


def _classes(entry: legends.Entry) -> tuple[str, str]:
    if entry.missing:
        return legends.NO_DATA, ""
    words = []
    for code, effect, names in (
        (entry.vegetation, entry.vegetation_effect, legends.VEGETATION),
        (entry.density, entry.density_effect, legends.DENSITY),
    ):
        words.append(f"{effect:g}" if effect is not None else "" if code is None else names[code])
    return words[0], words[1]


def _files(commands: Tree) -> str:
    out = ["# Output files\n", "Files that a command writes into its folder, made from `firebreak describe`.\n"]
    for name, command in commands.items():
        for words, one in [(name, command), *((f"{name} {w}", c) for w, c in command.get("commands", {}).items())]:
            if one.get("outputs"):
                out += [f"## firebreak {words}\n"]
                out += [_table(["file", "what"], [[f"`{file}`", _cell(text)] for file, text in one["outputs"].items()])]
    return "\n".join(out)


def _exit_codes() -> str:
    rows = [["0", "", "done"], ["1", "", "a bug; please report it"]]
    found = [e for _, e in inspect.getmembers(errors, inspect.isclass) if issubclass(e, errors.FirebreakError)]
    found = [e for e in found if e is not errors.FirebreakError]
    rows += [[str(e.exit_code), f"`{e.__name__}`", _first(e)] for e in sorted(found, key=lambda e: e.exit_code)]
    rows.append(["143", "", "ended by SIGTERM"])
    return "# Exit codes\n\nMade from the classes of errors.\n\n" + _table(["code", "error in Python", "what"], rows)


def _first(thing: object) -> str:
    return _cell((inspect.getdoc(thing) or "").split("\n\n")[0])


def _api() -> str:
    """Every public name, where it lives."""
    out = [
        "# Python\n",
        "All names of `firebreak_gis`, by the alphabet; usually `import firebreak_gis as fb`.\n",
    ]
    for name in sorted(firebreak_gis.__all__, key=str.lower):
        thing = getattr(firebreak_gis, name)
        if name.startswith("__"):
            continue
        home = f"{thing.__module__}.{thing.__qualname__}" if not inspect.ismodule(thing) else thing.__name__
        kind = "module" if inspect.ismodule(thing) else "class" if inspect.isclass(thing) else "function"
        kind = "exception" if inspect.isclass(thing) and issubclass(thing, BaseException) else kind
        members = "   :members:\n" if kind in ("class", "module") else ""
        out += [
            _anchor(f"fb-{name.lower()}"),
            f"## fb.{name}\n",
            f"```{{eval-rst}}\n.. auto{kind}:: {home}\n{members}```\n",
        ]
    return "\n".join(out)


def _beside(name: str) -> str:
    """A file of the top folder: links to pages of the site lead there, those to other files become their names."""
    text = (ROOT / name).read_text(encoding="utf-8")

    def link(found: re.Match[str]) -> str:
        words, target = found[1], found[2]
        if target.startswith(("http", "#")):
            return found[0]
        if target.startswith("docs/"):
            return f"[{words}](../{target.removeprefix('docs/')})"
        return f"{words}" if words == target.split("#")[0] else f"{words} (`{target.split('#')[0]}`)"

    return re.sub(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)", link, text)
