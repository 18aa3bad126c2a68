"""How fast and how safe studies are: ``python benchmarks/studies.py sizing|scaling|overhead|journal|faults|disk``.

sizing    100 000 first sizings of In-Line H2, two workers, journal on disk
scaling   the same cases with one worker and with two, three times each, medians
overhead  cases of 10 ms: time of the run over cases times 10 ms, start of the workers apart
journal   rows a second into the journal, in transactions of 100 and of 1000
faults    twenty times a worker and twenty times the runner killed at a random case: every case once, bit for bit
disk      a file system of 1 MB that fills up (needs the right to mount), then resumed
"""

from __future__ import annotations

import multiprocessing
import os
import random
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from gearwright.shipped import shipped_design
from gearwright.sizing.named import Named
from gearwright.spec import read
from gearwright.spec.study import Study, parse_study
from gearwright.study import run
from gearwright.study.journal import begin, opened, rows_of, status
from gearwright.study.runner import Progress, resume, run_study
from gearwright.study.sampling import Case, cases
from gearwright.study.table import Row
from gearwright.study.workers import local

NAME = "in-line-h2"
DESIGNS = {NAME: read(shipped_design(NAME))}
CASE_TIME = 0.010
"""[s]"""


def study_of(count: int) -> Study:
    return parse_study(f"""
schema = 1
name = "benchmark"
designs = ["{NAME}"]
results = ["mass", "total_mass", "worst_margin"]
[axes]
"motors.electric.speed_rpm" = {{from = 3500, to = 5500}}
"carriers.fill" = {{from = 0.4, to = 0.8}}
[sampling]
method = "sobol"
count = {count}
""")


def waiting(study: Study, design: object, case: Case) -> Row:
    """Return a row after 10 ms of work."""
    until = time.perf_counter() + CASE_TIME
    while time.perf_counter() < until:
        pass
    return Row(case.design, case.inputs, {name: Named(1.0, "mass") for name in study.asked})


class Watch:
    """Remembers when the first and the last cases were finished: what lies between has no start of workers in it."""

    def __init__(self) -> None:
        self.seen: list[tuple[float, int]] = []

    def __call__(self, progress: Progress) -> None:
        """Note time and finished cases."""
        self.seen.append((time.perf_counter(), progress.done))

    @property
    def rate(self) -> float:
        """Cases a second between the first and the last time [1/s]."""
        (start, first), (end, last) = self.seen[0], self.seen[-1]
        return (last - first) / (end - start)


def timed(count: int, workers: int) -> tuple[float, float]:
    """Return the time of a whole run with its journal [s], and its rate once workers are there [1/s]."""
    with tempfile.TemporaryDirectory() as folder:
        watch, start = Watch(), time.perf_counter()
        run_study(study_of(count), DESIGNS, workers=workers, journal=Path(folder) / "j", watch=watch)
        return time.perf_counter() - start, watch.rate


def sizing() -> None:
    seconds, rate = timed(100_000, 2)
    print(f"100 000 first sizings, 2 workers, journal on disk: {seconds:.1f} s; {rate:.0f}/s")


def scaling(count: int = 3000) -> None:
    rates = {workers: [] for workers in (1, 2)}
    for _ in range(3):
        for workers, found in rates.items():
            found.append(timed(count, workers)[1])
    one, two = (statistics.median(found) for found in rates.values())
    print(f"{count} cases, medians of 3: one worker {one:.0f}/s, two {two:.0f}/s: {two / one:.2f} times")


def overhead(count: int = 500) -> None:
    study = study_of(count)
    with tempfile.TemporaryDirectory() as folder:
        begin(Path(folder) / "j", study, DESIGNS)
        with opened(Path(folder) / "j") as book:
            book.begin_run(1)
            start, first = 0.0, 0
            done = 0
            with local(study, DESIGNS, 1, function=waiting) as compute:
                for rows in compute(cases(study), count):
                    book.append(rows)
                    done += len(rows)
                    if not start:
                        start, first = time.perf_counter(), done
            elapsed = time.perf_counter() - start
    each = elapsed / (count - first)
    print(f"{count} cases of 10 ms, one worker: {1e3 * each:.2f} ms each, overhead {each / CASE_TIME - 1.0:.1%}")


def journal(count: int = 50_000) -> None:
    study = study_of(count)
    row = run(study_of(1), DESIGNS).rows[0]
    for batch in (100, 1000):
        with tempfile.TemporaryDirectory() as folder:
            begin(Path(folder) / "j", study, DESIGNS)
            with opened(Path(folder) / "j") as book:
                book.begin_run(1)
                start = time.perf_counter()
                for first in range(0, count, batch):
                    book.append((number, row) for number in range(first, first + batch))
                rate = count / (time.perf_counter() - start)
        print(f"journal, {batch} rows a transaction, on disk after each: {rate:.0f} rows/s")


def faults(times: int = 20, count: int = 300) -> None:
    study = study_of(count)
    undisturbed = run(study, DESIGNS)
    generator = random.Random(1)
    for k in range(times):
        place = generator.randrange(count)
        with tempfile.TemporaryDirectory() as folder:
            table = run_study(study, DESIGNS, workers=2, journal=Path(folder) / "j", watch=Killer(place))
        assert table == undisturbed, f"worker killed at {place}"
        print(f"worker killed at case {place}: equal, {k + 1} of {times}")
    for k in range(times):
        done = runner_killed(study, generator.randrange(1, count), undisturbed)
        print(f"runner killed after {done} cases: equal, {k + 1} of {times}")


class Killer:
    """Kills one worker once so many cases are done."""

    def __init__(self, place: int) -> None:
        self.place, self.used = place, False

    def __call__(self, progress: Progress) -> None:
        """Kill when it is time."""
        if progress.done >= self.place and not self.used:
            self.used = True
            os.kill(multiprocessing.active_children()[0].pid or 0, signal.SIGKILL)


def runner_killed(study: Study, place: int, undisturbed: object) -> int:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "j"
        process = subprocess.Popen([sys.executable, __file__, "_run", str(path), str(len(list(cases(study))))])
        while process.poll() is None:
            if path.with_name("j-lock").exists() and status(path).done >= place:
                break
            time.sleep(0.005)
        process.kill()
        process.wait()
        before = rows_of(path)
        table = resume(path, workers=2)
        assert table == undisturbed, f"runner killed after {len(before)}"
        return len(before)


def disk() -> None:
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", folder], check=True)
        try:
            path, study = Path(folder) / "j", study_of(3000)
            process = subprocess.run(
                [sys.executable, __file__, "_run", str(path), "3000"], capture_output=True, text=True
            )
            print(process.stderr.strip().splitlines()[-1])
            print(f"{status(path).done} of 3000 kept")
            subprocess.run(["mount", "-o", "remount,size=64m", folder], check=True)
            assert resume(path, workers=2) == run(study, DESIGNS)
            print("resumed: equal")
        finally:
            subprocess.run(["umount", folder], check=True)


def _run() -> None:
    run_study(study_of(int(sys.argv[3])), DESIGNS, workers=2, journal=Path(sys.argv[2]))


if __name__ == "__main__":
    {each.__name__: each for each in (sizing, scaling, overhead, journal, faults, disk, _run)}[sys.argv[1]]()
