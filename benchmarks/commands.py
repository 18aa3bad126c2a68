"""Processor time of commands: user and system, the median of several runs, each in a process of its own.

`python benchmarks/commands.py` measures ``--help`` and ``size`` of two shipped designs. Modules are read as bytecode,
as `pip install` leaves them, whatever the environment says about writing it: a run that is not counted writes it to
a folder that is removed afterwards.
"""

from __future__ import annotations

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile

COMMANDS = (("--help",), ("size", "single-planetary"), ("size", "off-set"))


def processor_time(bytecode: str, *arguments: str) -> float:
    """Return user and system time of a command [s].

    Args:
        bytecode: Folder of the bytecode.
        arguments: Of the command.
    """
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment["PYTHONPYCACHEPREFIX"] = bytecode
    command = [sys.executable, "-c", "from gearwright.cli import main; main()", *arguments]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=environment)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main() -> None:
    """Print a table of medians and smallest times."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=7)
    runs = parser.parse_args().runs
    print("| command | median [s] | minimum [s] |\n| --- | --- | --- |")
    with tempfile.TemporaryDirectory() as bytecode:
        for command in COMMANDS:
            times = [processor_time(bytecode, *command) for _ in range(1 + runs)][1:]
            print(f"| `gearwright {' '.join(command)}` | {statistics.median(times):.2f} | {min(times):.2f} |")


if __name__ == "__main__":
    main()
