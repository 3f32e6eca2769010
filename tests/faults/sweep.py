"""Child process: break the n-th call of a writer, for every n, and look at what is left.

Runs with the shim preloaded: `python -m tests.faults.sweep KIND FOLDER`. Prints one JSON object: calls made
by unbroken runs, and every finding that should not be.
"""

import ctypes
import errno
import itertools
import json
import os
import sys
import traceback
from pathlib import Path

from firebreak_gis.errors import OutputError
from tests.faults import writers
from tests.faults.state import account_tells, after_a_kill, content, difference, left_over, put_back

CODES = (errno.ENOSPC, errno.EACCES, errno.EIO)
DIE = -1


def attempt(kind, folder, overwrite):
    """Write variant 1; return the error, None if there was none."""
    try:
        writers.write(kind, folder, 1, overwrite)
    except OutputError as error:
        return error
    return None


def faults(shim, kind, folder, codes, old, new, step):
    """Yield findings for every `step`-th n until a run does not meet the fault; last the number of its calls."""
    for n in itertools.count(1, step):
        code = codes[n % len(codes)]
        put_back(folder, old)
        error = crash = None
        shim.faults_arm(str(folder).encode(), n, code)
        try:
            error = attempt(kind, folder, overwrite=bool(old))
        except Exception:
            crash = traceback.format_exc()
        met = shim.faults_seen() >= n
        where = f"{kind}, {errno.errorcode[code]} at call {n} ({shim.faults_last().decode()})"
        shim.faults_arm(b"", 0, 0)
        if crash:
            yield f"{where}: {crash}"
        found = content(folder)
        if error is None and crash is None and found != new:
            yield f"{where}: no error, but {difference(found, new)}"
        if error is not None and found not in (old, new):
            yield f"{where}: {error}: {difference(found, old)}"
        if not met:
            if error is not None:
                yield f"{where}: {error} without a fault"
            yield n - 1
            return
        if left_over(folder) or n % (8 * step) == 1:
            yield from _next_run(kind, folder, new, where)


def kills(shim, kind, folder, old, new, numbers):
    """As `faults`, but the process is killed at its n-th call, for the numbers given."""
    for n in numbers:
        put_back(folder, old)
        child = os.fork()
        if child == 0:
            shim.faults_arm(str(folder).encode(), n, DIE)
            os._exit(0 if attempt(kind, folder, overwrite=bool(old)) is None else 4)
        _, status = os.waitpid(child, 0)
        where = f"{kind}, killed at call {n}"
        if not os.WIFSIGNALED(status):
            if status != 0 or content(folder) != new:
                yield f"{where}: not met, yet {difference(content(folder), new)}"
            yield n - 1
            return
        if wrong := after_a_kill(folder, old, new):
            yield f"{where}: {wrong}"
        if not account_tells(folder, old, new):
            yield f"{where}: an account stands among files that it does not name"
        yield from _next_run(kind, folder, new, where)


def _some(calls):
    """Every 16th call, and every third of those that move the files."""
    moving = calls - 110
    return [*range(16, moving, 16), *range(moving, calls, 3), calls + 1]


def _next_run(kind, folder, new, where):
    writers.write(kind, folder, 1, overwrite=True)
    if content(folder) != new or left_over(folder):
        yield f"{where}: the next run left {left_over(folder)}, {difference(content(folder), new)}"


def main():
    kind, folder = sys.argv[1], Path(sys.argv[2])
    shim = ctypes.CDLL(None)
    shim.faults_last.restype = ctypes.c_char_p
    writers.prepare(kind, folder)
    old, new = writers.contents(kind, folder)
    findings, calls = [], []
    # The kind of fault changes from one call to the next; where writing takes long every tenth call is broken.
    whole = kind in writers.LONG
    for before in [old] if whole else [{}, old]:
        *wrong, count = faults(shim, kind, folder, CODES, before, new, 10 if whole else 1)
        findings += wrong
        calls.append(count)
    *wrong, count = kills(shim, kind, folder, old, new, _some(calls[-1]) if whole else itertools.count(1))
    print(json.dumps({"calls": [*calls, count], "findings": findings + wrong}))


if __name__ == "__main__":
    main()
