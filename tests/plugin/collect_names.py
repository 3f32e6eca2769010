"""Note which names of QGIS and Qt that the plugin uses a release has: `qgis_names.json`, for a test without QGIS.

Of the QGIS at hand, with its own Python (3.22 on Debian 12):

    QT_QPA_PLATFORM=offscreen /usr/bin/python3 tests/plugin/collect_names.py "QGIS 3.22"

Of QGIS 4, which is QGIS 3.44 on Qt 6, from type stubs: those of the bindings of 3.44 (wheel `qgis-stubs` 0.5.0, which
leaves the old names of enums out) and those in the wheel `PyQt6`, both unpacked into a folder:

    python tests/plugin/collect_names.py "QGIS 4" FOLDER
"""

from __future__ import annotations

import ast
import json
import re
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
PLUGIN = ROOT / "qgis_plugin" / "firebreak"
KEPT = Path(__file__).with_name("qgis_names.json")
MODULES = ("qgis.core", "qgis.gui", "qgis.PyQt.QtCore", "qgis.PyQt.QtGui", "qgis.PyQt.QtWidgets")
#: qgis.PyQt of QGIS 4 offers in QtWidgets what Qt 6 has moved to QtGui.
MOVED = ("QAction", "QShortcut")


def used(folder: Path = PLUGIN) -> tuple[set[str], set[str]]:
    """Return dotted names (`qgis.core.Qgis.MessageLevel.Success`), and names of methods called or overridden."""
    dotted, methods = set(), set()
    for path in sorted(folder.rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        known = {
            alias.name: f"{node.module}.{alias.name}"
            for node in ast.walk(tree)
            if isinstance(node, ast.ImportFrom) and node.module in MODULES
            for alias in node.names
        }
        dotted |= set(known.values())
        is_qgis = bool(known) or "from qgis import" in path.read_text(encoding="utf-8")
        own = {node.name for node in ast.walk(tree) if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        for node in ast.walk(tree):
            names, inner = [], node
            while isinstance(inner, ast.Attribute):
                names.insert(0, inner.attr)
                inner = inner.value
            if names and isinstance(inner, ast.Name) and inner.id in known:
                dotted.add(".".join([known[inner.id], *names]))
            if is_qgis and isinstance(node, ast.Attribute) and re.fullmatch(r"[a-z]+[A-Z]\w*", node.attr):
                methods.add(node.attr)
        if is_qgis:
            methods |= {name for name in own if re.fullmatch(r"[a-z]+[A-Z]\w*", name)}
    return dotted, methods - {"classFactory", "initProcessing", "initGui"}


def of_enums() -> tuple[set[str], set[str]]:
    """Return the names in enums.py: those of QGIS 4, and those of QGIS 3."""
    tree = ast.parse((PLUGIN / "enums.py").read_text(encoding="utf-8"))
    calls = [n for n in ast.walk(tree) if isinstance(n, ast.Call) and getattr(n.func, "id", "") == "_first"]
    new, old = ({f"qgis.core.{call.args[place].value}" for call in calls} for place in (0, -1))
    return new, old


def here() -> tuple[Any, Any]:
    """Return questions to the QGIS at hand: has it a dotted name, has any class a method."""
    import importlib

    modules = {name: importlib.import_module(name) for name in MODULES}
    classes = [thing for module in modules.values() for thing in vars(module).values() if isinstance(thing, type)]
    classes += [inner for one in classes for inner in vars(one).values() if isinstance(inner, type)]
    members = {member for one in classes for member in dir(one)}

    def has(name: str) -> bool:
        module = max((m for m in MODULES if name.startswith(m + ".")), key=len)
        thing = modules[module]
        for part in name[len(module) + 1 :].split("."):
            if not hasattr(thing, part):
                return False
            thing = getattr(thing, part)
        return True

    return has, members.__contains__


def in_stubs(folder: Path) -> tuple[Any, Any]:
    """Return the same questions to type stubs."""
    files = {"qgis.core": "qgis-stubs/_core.pyi", "qgis.gui": "qgis-stubs/_gui.pyi"}
    files |= {f"qgis.PyQt.{m}": f"PyQt6/{m}.pyi" for m in ("QtCore", "QtGui", "QtWidgets")}
    known: dict[str, set[str]] = {}  # members of each class by its dotted name, those of its bases among them
    bases: dict[str, list[str]] = {}

    def read(body: list[ast.stmt], name: str) -> None:
        for node in body:
            if isinstance(node, ast.ClassDef):
                known.setdefault(name, set()).add(node.name)
                bases[f"{name}.{node.name}"] = [ast.unparse(b).strip("'\"").rpartition(".")[2] for b in node.bases]
                known.setdefault(f"{name}.{node.name}", set())
                read(node.body, f"{name}.{node.name}")
            elif isinstance(node, ast.FunctionDef):
                known.setdefault(name, set()).add(node.name)
            elif isinstance(node, (ast.Assign, ast.AnnAssign)):
                targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                known.setdefault(name, set()).update(t.id for t in targets if isinstance(t, ast.Name))

    for module, file in files.items():
        text = (folder / file).read_text(encoding="utf-8")
        text = re.sub(r"class (\w+)\('([\w.]+)'\)", r"class \1(\2)", text).replace(", /)", ")")
        read(ast.parse(text).body, module)
    known["qgis.PyQt.QtWidgets"] |= set(MOVED)
    known["qgis.core"].add("QgsProcessingException")  # stubs of bindings leave exceptions out
    full = {name.rpartition(".")[2]: name for name in bases if name.count(".") <= 3}

    def has(name: str) -> bool:
        place, _, part = name.rpartition(".")
        if part in known.get(place, ()):
            return True
        return any(has(f"{full[base]}.{part}") for base in bases.get(place, ()) if base in full)

    members = set().union(*known.values())
    return has, members.__contains__


def main() -> None:
    """Write what was found."""
    release, *folder = sys.argv[1:]
    has, has_method = in_stubs(Path(folder[0])) if folder else here()
    dotted, methods = used()
    dotted |= of_enums()[0 if folder else 1]
    found = {
        "dotted": sorted(name for name in dotted if has(name)),
        "methods": sorted(name for name in methods if has_method(name)),
    }
    kept = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {}
    KEPT.write_text(json.dumps({**kept, release: found}, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    print(f"{release} lacks {sorted(dotted - set(found['dotted']))} {sorted(methods - set(found['methods']))}")


if __name__ == "__main__":
    main()
