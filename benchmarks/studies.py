"""How fast studies are: ``python benchmarks/studies.py`` measures all, or some of what stands below.

command   100 000 first sizings of In-Line H2 by ``gearwright study FILE --journal FILE --workers 2``, from its start to
          the last word; once
sizing    the same in this process and two workers, and where the CPU time of a row goes; once
scaling   the same cases with one worker and with two, in turn, seven times
overhead  cases of 10 ms of CPU: CPU time of runner and worker over that of the cases, start apart; five times
journal   rows a second into the journal, each transaction on disk before the next; five times
merged    eight journals of 25 000 rows by ``gearwright merge … --into FILE --export FILE.parquet``, from its start

It prints a table with medians and the spread from least to most, and how busy the machine was with other work: the
CPU time of a case counts what other processes do not take. How safe studies are is told by the tests:
``pytest tests/unit/study/test_faults.py tests/unit/study/test_faults_of_clusters.py --faults 20``.
"""

from __future__ import annotations

import os
import platform
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from unittest.mock import patch

from gearwright.shipped import shipped_design
from gearwright.sizing import Named
from gearwright.spec import Study, parse_study, read
from gearwright.study import run
from gearwright.study.cases import Case, cases
from gearwright.study.journal import Journal, begin, opened
from gearwright.study.running import Progress, run_study
from gearwright.study.tables import Row, blocks_of
from gearwright.study.workers import local

NAME = "in-line-h2"
DESIGNS = {NAME: read(shipped_design(NAME))}
CASE_TIME = 0.010
"""[s]"""


def study_of(count: int) -> Study:
    return parse_study(text_of(count))


def text_of(count: int) -> str:
    return f"""
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
"""


def waiting(study: Study, design: object, case: Case) -> Row:
    """Return a row after 10 ms of work."""
    until = time.process_time() + CASE_TIME
    while time.process_time() < until:
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


def timed(count: int, workers: int) -> tuple[float, float, float]:
    """Return the time of a whole run [s], its rate once workers are there [1/s], and its CPU time [s]."""
    with tempfile.TemporaryDirectory() as folder:
        watch, start, cpu = Watch(), time.perf_counter(), cpu_time()
        run_study(study_of(count), DESIGNS, workers=workers, journal=Path(folder) / "j", watch=watch)
        return time.perf_counter() - start, watch.rate, cpu_time() - cpu


def cpu_time() -> float:
    """Return the CPU time of this process and of those that it has waited for [s]."""
    spent = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in spent)


def spread(values: Iterable[float], form: str) -> str:
    """Return the median and, in brackets, the least and the most."""
    found = sorted(values)
    return f"{statistics.median(found):{form}} ({found[0]:{form}} to {found[-1]:{form}})"


def command(count: int = 100_000) -> str:
    before, start = cpu_time(), time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "study.toml").write_text(text_of(count), encoding="utf-8")
        call = (sys.executable, "-c", "from gearwright.cli import main; main()", "study", "study.toml")
        subprocess.run((*call, "--journal", "j", "--workers", "2"), cwd=folder, check=True, capture_output=True)
    seconds, cpu = time.perf_counter() - start, cpu_time() - before
    return f"the command `study`: {count} first sizings, two workers, journal | {seconds:.1f} s, {cpu:.0f} s of CPU"


def sizing(count: int = 100_000) -> str:
    append, spent = Journal.append, [0.0]

    def timed_append(book: Journal, rows: Iterable[tuple[int, Row]]) -> None:
        start = time.process_time()
        append(book, rows)
        spent[0] += time.process_time() - start

    with patch.object(Journal, "append", timed_append):
        own = time.process_time()
        seconds, rate, cpu = timed(count, 2)
        own = time.process_time() - own
    a_row = [1e6 * part / count for part in (cpu - own, spent[0], own - spent[0])]
    return (
        f"{count} first sizings, two workers, journal on disk | {seconds:.1f} s, {rate:.0f}/s; {cpu:.0f} s of CPU,"
        f" a row {a_row[0]:.0f} µs in workers, {a_row[1]:.1f} in the journal, {a_row[2]:.0f} in the rest of the runner"
    )


def scaling(count: int = 3000, repeats: int = 7) -> str:
    pairs = [(timed(count, 1)[1], timed(count, 2)[1]) for _ in range(repeats)]
    one, two = ([pair[k] for pair in pairs] for k in (0, 1))
    gain = spread((second / first for first, second in pairs), ".2f")
    return f"{count} cases, one worker, then two | {spread(one, '.0f')}/s, {spread(two, '.0f')}/s: {gain} times"


def overhead(few: int = 100, many: int = 500, repeats: int = 5) -> str:
    found = [(_spent(many) - _spent(few)) / (many - few) / CASE_TIME - 1.0 for _ in range(repeats)]
    return f"runner and journal at 10 ms a case, one worker | {spread((1e2 * each for each in found), '.1f')} %"


def _spent(count: int) -> float:
    """Return the CPU time of a run with its journal, its runner and its worker together [s]."""
    study, before = study_of(count), cpu_time()
    with tempfile.TemporaryDirectory() as folder:
        begin(Path(folder) / "j", study, DESIGNS)
        with opened(Path(folder) / "j") as book, local(study, DESIGNS, 1, function=waiting) as compute:
            book.begin_run(1)
            for rows in compute(cases(study), count):
                book.append(rows)
    return cpu_time() - before


def journal(count: int = 20_000, repeats: int = 5) -> str:
    found = {batch: [_rows_a_second(count, batch) for _ in range(repeats)] for batch in (100, 1000, 4000)}
    words = (
        f"{spread((wall for wall, _ in each), '.0f')}/s, {spread((cpu for _, cpu in each), '.0f')} a second of CPU"
        for each in found.values()
    )
    return f"rows into the journal, 100, 1000 and 4000 a transaction | {'; '.join(words)}"


def _rows_a_second(count: int, batch: int) -> tuple[float, float]:
    """Return rows a second, and rows a second of CPU time."""
    row = run(study_of(1), DESIGNS).rows[0]
    with tempfile.TemporaryDirectory() as folder:
        begin(Path(folder) / "j", study_of(count), DESIGNS)
        with opened(Path(folder) / "j") as book:
            book.begin_run(1)
            blocks = [blocks_of((number, row) for number in range(first, first + batch))
                      for first in range(0, count, batch)]  # as workers send them  # fmt: skip
            start, cpu = time.perf_counter(), cpu_time()
            for block in blocks:
                book.append(block)
            return count / (time.perf_counter() - start), count / (cpu_time() - cpu)


def merged(parts: int = 8, count: int = 25_000) -> str:
    row = run(study_of(1), DESIGNS).rows[0]
    with tempfile.TemporaryDirectory() as folder:
        names = [f"{part}.journal" for part in range(parts)]
        for part, name in enumerate(names):
            begin(Path(folder) / name, study_of(parts * count), DESIGNS)
            with opened(Path(folder) / name) as book:
                book.begin_run(1)
                book.append(blocks_of((own, _of(row, own)) for own in range(part, parts * count, parts)))
        call = (sys.executable, "-c", "from gearwright.cli import main; main()", "merge", *names)
        before, start = cpu_time(), time.perf_counter()
        subprocess.run((*call, "--into", "all.journal", "--export", "all.parquet"), cwd=folder, check=True,
                       capture_output=True)  # fmt: skip
        seconds, cpu = time.perf_counter() - start, cpu_time() - before
        sizes = [(Path(folder) / f"all.{kind}").stat().st_size / 1e6 for kind in ("journal", "parquet")]
    return (
        f"{parts} journals of {count} rows into one, and to Parquet | {seconds:.1f} s, {cpu:.1f} s of CPU;"
        f" {sizes[0]:.1f} and {sizes[1]:.1f} MB"
    )


def _of(row: Row, number: int) -> Row:
    """Return a row like another one, with numbers of its own."""
    near = 1.0 + 1e-6 * number
    inputs = {path: near * float(value) for path, value in row.inputs.items()}
    results = {name: Named(near * float(named.value), named.dimension) for name, named in row.results.items()}
    return Row(row.design, inputs, results)


def main() -> None:
    known: dict[str, Callable[[], str]] = {
        each.__name__: each for each in (command, sizing, scaling, overhead, journal, merged)
    }
    print(f"Python {platform.python_version()}, {os.cpu_count()} cores\n\n| what | measured | processes at work |")
    print("| --- | --- | --- |")
    for name in sys.argv[1:] or known:
        before = os.getloadavg()[0]
        print(f"| {known[name]()} | {before:.1f} before, {os.getloadavg()[0]:.1f} after |", flush=True)


if __name__ == "__main__":
    main()
