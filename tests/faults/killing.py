"""Child process: writers killed at random moments. `python -m tests.faults.killing KIND FOLDER KILLS SEED`."""

import json
import os
import random
import signal
import sys
import time
from pathlib import Path

from tests.faults import writers
from tests.faults.state import account_tells, after_a_kill, content, left_over, put_back


def main():
    kind, folder, number, seed = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
    writers.prepare(kind, folder)
    old, new = writers.contents(kind, folder)
    started = time.monotonic()
    writers.write(kind, folder, 1, overwrite=True)
    usual = time.monotonic() - started
    chance = random.Random(seed)
    findings, fell = [], 0
    for turn in range(number):
        put_back(folder, old)
        child = os.fork()
        if child == 0:
            writers.write(kind, folder, 1, overwrite=True)
            os._exit(0)
        time.sleep(chance.uniform(0.0, 1.1 * usual))
        os.kill(child, signal.SIGKILL)
        _, status = os.waitpid(child, 0)
        fell += os.WIFSIGNALED(status)
        wrong = after_a_kill(folder, old, new)
        if wrong or not account_tells(folder, old, new):
            findings.append(f"{kind}, kill {turn}: {wrong or 'an account among files of another run'}")
        writers.write(kind, folder, 1, overwrite=True)
        if content(folder) != new or left_over(folder):
            findings.append(f"{kind}, kill {turn}: the next run left {left_over(folder)}")
    print(json.dumps({"fell": fell, "findings": findings}))


if __name__ == "__main__":
    main()
