"""How many files a command leads through: those of gearwright in which a function is entered while it runs.

`python benchmarks/entered.py` runs `size` and `report` of every shipped design, each in a process of its own that
has loaded only the commands before, and prints the fewest and the most files with the designs that enter them. With
the name of a command and of a design it lists the files and how often their functions are entered. Functions that run
while a module loads are counted too; the text of modules and classes is not.
"""

from __future__ import annotations

import argparse
import contextlib
import inspect
import io
import multiprocessing
import sys
import tempfile
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from types import FrameType

import gearwright
from gearwright.cli import main as command_line

SOURCE = f"{Path(gearwright.__file__).parent}/"
COMMANDS = ("size", "report")


def entered(command: str, design: str) -> Counter[str]:
    """Return file -> how often its functions are entered while a command runs on a shipped design.

    Args:
        command: `size` or `report`; what it writes goes to a folder that is removed.
        design: Its name.
    """
    calls = Counter[str]()

    def note(frame: FrameType, event: str, _: object) -> None:
        code = frame.f_code
        if event == "call" and code.co_flags & inspect.CO_OPTIMIZED and code.co_filename.startswith(SOURCE):
            calls[code.co_filename.removeprefix(SOURCE)] += 1

    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
        page = ["--out", f"{folder}/report.html"] if command == "report" else []
        sys.argv = ["gearwright", command, design, *page]
        sys.setprofile(note)
        try:
            command_line()
        except SystemExit as end:
            # A design that fails a check is sized and shown; anything else did not run.
            if end.code not in (None, 0, 1):
                raise
        finally:
            sys.setprofile(None)
    return calls


def main() -> None:
    """Print a table of the commands, or the files of one."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("command", nargs="?", choices=COMMANDS)
    parser.add_argument("design", nargs="?")
    parser.add_argument("--workers", type=int, default=1)
    asked = parser.parse_args()
    alone = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(asked.workers, mp_context=alone, max_tasks_per_child=1) as processes:
        if asked.design:
            for file, calls in sorted(processes.submit(entered, asked.command, asked.design).result().items()):
                print(f"{file} {calls}")
            return
        designs = gearwright.shipped_designs()
        print("| command | fewest files | most files |\n| --- | --- | --- |")
        for command in COMMANDS if asked.command is None else (asked.command,):
            counts = dict(zip(designs, processes.map(entered, [command] * len(designs), designs), strict=True))
            few, many = (limit(counts, key=lambda name: len(counts[name])) for limit in (min, max))
            print(f"| `{command}` | {len(counts[few])} (`{few}`) | {len(counts[many])} (`{many}`) |", flush=True)


if __name__ == "__main__":
    main()
