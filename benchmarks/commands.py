"""Processor time of commands: user and system, the median of several runs, each in a process of its own.

`python benchmarks/commands.py` measures ``--help`` and ``size`` of two shipped designs.
"""

from __future__ import annotations

import argparse
import resource
import statistics
import subprocess
import sys

COMMANDS = (("--help",), ("size", "single-planetary"), ("size", "off-set"))


def processor_time(*arguments: str) -> float:
    """Return user and system time of a command [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", "from gearwright.cli import main; main()", *arguments],
                   check=True, stdout=subprocess.DEVNULL)  # fmt: skip
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main() -> None:
    """Print a table of medians and smallest times."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=7)
    runs = parser.parse_args().runs
    print("| command | median [s] | minimum [s] |\n| --- | --- | --- |")
    for command in COMMANDS:
        times = [processor_time(*command) for _ in range(runs)]
        print(f"| `gearwright {' '.join(command)}` | {statistics.median(times):.2f} | {min(times):.2f} |")


if __name__ == "__main__":
    main()
