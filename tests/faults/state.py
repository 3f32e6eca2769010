"""What stands in a folder, and what may stand there after a writer was broken off."""

import hashlib

from firebreak_gis.files.locks import PREFIX


def content(folder):
    """Bytes of every file by name, temporary files left out."""
    return {p.name: p.read_bytes() for p in folder.iterdir() if not p.name.startswith(PREFIX)}


def left_over(folder):
    """Names of temporary files."""
    return sorted(p.name for p in folder.iterdir() if p.name.startswith(PREFIX))


def put_back(folder, files):
    """Let the folder hold these files and no other."""
    for entry in folder.iterdir():
        entry.unlink()
    for name, data in files.items():
        (folder / name).write_bytes(data)


def difference(found, expected):
    names = sorted(found.keys() | expected.keys())
    return "changed: " + ", ".join(name for name in names if found.get(name) != expected.get(name))


def after_a_kill(folder, old, new):
    """Return what is wrong in a folder after a kill, None if nothing is.

    All files are old, or all are new; or the kill fell between two moves: then each is old, new or absent,
    and the file that was to come last is not there or links to old files tell.
    """
    found = content(folder)
    if found in (old, new):
        return None
    for name, data in found.items():
        if data not in (old.get(name), new.get(name)):
            return f"{name} is neither old nor new ({len(data)} bytes, {hashlib.sha256(data).hexdigest()[:8]})"
    kept = [name for name in left_over(folder) if name.endswith(".part-old")]
    if len(new) > 1 and (kept if old else not found.keys() >= new.keys()):
        return None
    return f"files of two runs, and nothing tells: {difference(found, old)}; {left_over(folder)}"


def account_tells(folder, old, new):
    """Whether the account is there only where all files are those it names."""
    found = content(folder)
    return "run.json" not in found or found in (old, new)
