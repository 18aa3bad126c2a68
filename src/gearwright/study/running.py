"""Running of studies: small or large, resumed, in parts, and without rows.

A single case is computed in `cases`.
"""

import json
import shlex
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, closing
from dataclasses import dataclass, field
from functools import cached_property
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from gearwright.base import DesignError, Ints, Problem, SolveError, refuse, verb
from gearwright.files import bytes_of, write_text
from gearwright.shipped import find_design, shipped_study
from gearwright.spec import Axis, Design, Mission, Study, case_count, read, read_study
from gearwright.spec.studies import RELIABILITY, Value, study_problems
from gearwright.study.answers import Reduced, as_plain, from_plain
from gearwright.study.cases import Case, cases, evaluate, fixed, generations, refuse_unknown_paths
from gearwright.study.engine import for_requirement, refuse_no_size
from gearwright.study.journal import (
    Journal,
    Recorded,
    begin,
    changes_of,
    dumped,
    in_memory,
    kept_rows,
    made_with,
    opened,
    reading,
    recorded,
    summed,
)
from gearwright.study.reliability import failures
from gearwright.study.tables import NUMBER, Blocks, Row, Table, blocks_of
from gearwright.study.workers import Compute, local

# ----------------------------------------------------------------------------------------------------------------------
# Parts of one study for machines that know nothing of each other, and their journals as one.
# ----------------------------------------------------------------------------------------------------------------------


MOST = 100_000
"""Parts of one study, at most [-]."""
_BATCH = 10_000
"""Rows that are written at once."""


@dataclass(frozen=True)
class Part:
    """Every so-manieth case of a study: parts cost alike, whatever an axis costs."""

    number: int = 1
    """Which part, from 1."""
    of: int = 1
    """How many parts there are."""

    def has(self, case: int) -> bool:
        """Tell whether a case belongs to it.

        Args:
            case: Its number, from 0.
        """
        return case % self.of == self.number - 1

    def cases(self, total: int) -> range:
        """Return the numbers of its cases.

        Args:
            total: Cases of the whole study.
        """
        return range(self.number - 1, total, self.of)


WHOLE = Part()


def part_of(text: str) -> Part:
    """Return the part that a text such as ``2/8`` means.

    Args:
        text: As a user wrote it.

    Raises:
        DesignError: If it means none.
    """
    number, _, of = text.partition("/")
    if number.isdecimal() and of.isdecimal() and 1 <= int(number) <= int(of) <= MOST:
        return Part(int(number), int(of))
    raise DesignError([Problem("--shard", f"{text!r} is no part; give its number and how many there are, such as 2/8")])


def refuse_part(study: Study, part: Part) -> None:
    """Raise where a study cannot be taken in parts.

    Args:
        study: As read.
        part: Of it.

    Raises:
        DesignError: If its cases follow from earlier results.
    """
    if part.of > 1 and study.searches:
        message = (
            f"{study.sampling.method} goes on from the results of all its cases: it has no parts;"
            " take another method, or a cluster"
        )
        raise DesignError([Problem("sampling.method", message)])


def merge(journals: Sequence[Path], into: Path) -> tuple[int, int]:
    """Put the finished cases of several journals of one study into one; return how many it has, and of how many.

    A case that several have is taken from the first; all give it the same, bit for bit. What is damaged is left out.

    Args:
        journals: Of parts, or of whatever was finished of one study.
        into: New journal, or one of the same study, which `resume` completes and shows.

    Raises:
        DesignError: If they are not of one study, its designs and one version, or the file is something else.
        SolveError: If it cannot be written.
    """
    if not journals:
        raise DesignError([Problem("journals", "there are none; name those of the parts")])
    every = [*journals, into] if into.exists() else list(journals)
    known = [recorded(path) for path in every]
    first = known[0]
    refuse(
        Problem(str(path), f"is not of the same study as {journals[0]}: {why}; leave it out")
        for path, other in zip(every[1:], known[1:], strict=True)
        if (why := _other(first, other))
    )
    if not into.exists():
        begin(into, first.study, first.designs, origin=first.origin)
    with opened(into) as book:
        book.begin_run(0)
        for path in journals:
            with reading(path) as database:
                rows = ((number, row) for number, row in kept_rows(database, first.total) if row is not None)
                while batch := list(islice(rows, _BATCH)):
                    book.append(batch)
        return len(book.kept), first.total


def _other(first: Recorded, other: Recorded) -> str:
    """Return in what two journals differ; empty where they are of one study."""
    if other.study != first.study:
        return "other axes, results or sampling"
    if other.designs != first.designs:
        return "a design differs"
    changes = changes_of(first.made_with, other.made_with)
    return "; ".join(f"{name} {ours} there, {theirs} here" for name, ours, theirs in changes)


def slurm(study: Path, parts: int) -> str:
    """Return a script for Slurm that runs a study in parts, one task each, and what to do after it.

    Args:
        study: Its file.
        parts: How many.

    Raises:
        DesignError: If there are none, or too many.
    """
    if not 1 <= parts <= MOST:
        raise DesignError([Problem("--slurm", f"{parts} parts are asked; allowed are 1 to {MOST:,}")])
    stem, name = shlex.quote(study.stem), shlex.quote(str(study))
    journal = f"{stem}-$SLURM_ARRAY_TASK_ID.journal"
    return "\n".join([
        "#!/bin/bash",
        f"#SBATCH --job-name={stem}",
        f"#SBATCH --array=1-{parts}",
        "#SBATCH --cpus-per-task=4",
        f"shard=$SLURM_ARRAY_TASK_ID/{parts}",
        f"if [ -e {journal} ]; then",
        f"  gearwright resume {journal} --shard $shard --workers $SLURM_CPUS_PER_TASK",
        "else",
        f"  gearwright study {name} --shard $shard --journal {journal} --workers $SLURM_CPUS_PER_TASK",
        "fi",
        f"# when all tasks have ended:  gearwright merge {stem}-*.journal --into {stem}.journal",
        f"# then:                       gearwright resume {stem}.journal --export {stem}.parquet",
    ])  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Run a small study here and now.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def run(
    study: Study,
    designs: Mapping[str, Design] | None = None,
    *,
    workers: int = 0,
    folder: Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> Table:
    """Return the table of a study; the same bits with any number of workers.

    Args:
        study: Axes, changes and results.
        designs: Name -> design, for every name in the study; left out: read by their names.
        workers: Processes that compute; 0 computes in this one.
        folder: Of the study, where files that it names are; left out: where the program runs.
        progress: Called with the fraction done, from 0 to 1.

    Raises:
        DesignError: If there are too many cases, or all of them fail. A variant that fails is a row with its reason.
        SolveError: If no worker starts.
    """
    refuse_search(study)
    count, rows = case_count(study), dict[int, Row]()
    if designs is None:
        designs = {name: read(find_design(name, folder)) for name in study.designs}

    with local(study, fixed(study, designs), workers) as compute:
        for batch, answer in batches(study):
            first = len(rows)
            for finished in compute(batch, count):
                rows.update(finished)
                if progress is not None:
                    progress(len(rows) / count)
            answer([rows[number] for number in range(first, len(rows))])
    return table_of(study, [rows[number] for number in range(len(rows))])


def refuse_search(study: Study) -> None:
    """Raise where a study has no cases to run, because it looks for the best.

    Args:
        study: As read.

    Raises:
        DesignError: If it has a table ``search``.
    """
    if study.search is not None:
        message = "this study looks for the best: `gearwright optimise` runs it; take [search] away to run its cases"
        raise DesignError([Problem("search", message)])


def batches(study: Study) -> Iterator[tuple[Iterator[Case], Callable[[list[Row]], None]]]:
    """Yield batches of cases, each with the function that takes its rows: one batch, or a search's generations.

    Args:
        study: Axes and method.
    """
    if not study.searches:
        yield cases(study), lambda rows: None
        return
    search = failures(study) if study.sampling.method in RELIABILITY else generations(study)
    batch = next(search, None)
    while batch is not None:
        answers: list[Row] = []
        yield iter(batch), answers.extend
        try:
            batch = search.send(answers)
        except StopIteration:
            batch = None


def table_of(study: Study, rows: list[Row]) -> Table:
    """Return the table of rows.

    Args:
        study: That they belong to.
        rows: In the order of the cases.

    Raises:
        DesignError: If all of them failed.
    """
    if rows and all(row.problem for row in rows):
        first = {row.design: row.problem for row in reversed(rows)}
        named = len(first) > 1
        raise DesignError(
            [
                Problem(design if named else "", f"every case failed, the first with {reason}")
                for design, reason in reversed(first.items())
            ],
            study.name,
        )
    return Table(study.name, study.description, study.asked, tuple(rows), tied=study.sampling.method == "list")


# ----------------------------------------------------------------------------------------------------------------------
# Run a study of any size: cases to workers, finished ones to the journal; continue where it stopped.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Progress:
    """How far a run is."""

    done: int
    """Finished cases, those of earlier runs included."""
    total: int
    """All cases."""
    failed: int
    """Finished cases that are a reason instead of results."""
    rate: float
    """Cases a second since this run began [1/s]."""
    finished: Iterable[tuple[int, Row]] = ()
    """Cases that have been finished since this was told last; at first those of earlier runs."""

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """Their rows."""
        return tuple(row for _, row in self.finished)

    @property
    def remaining(self) -> float:
        """Estimated time until all are done [s]."""
        return (self.total - self.done) / self.rate if self.rate else float("inf")


Start = Callable[[Study, Mapping[str, Design], int], AbstractContextManager[Compute]]
"""What holds workers for a study: `local`, or a cluster."""
Watch = Callable[[Progress], None]


def run_study(
    study: Study, designs: Mapping[str, Design], *, workers: int = 0, journal: Path | None = None, origin: str = "",
    watch: Watch | None = None, start: Start = local, part: Part = WHOLE,
) -> Table:  # fmt: skip
    """Return the table of a study; the same for one seed, bit for bit, whatever computes it.

    Args:
        study: Axes, method and results.
        designs: Name -> design.
        workers: Processes that compute; 0 computes in this one.
        journal: File that keeps every finished case at once, for `resume`; left out: nothing is kept.
        origin: Folder in which the names of designs were looked up.
        watch: Called with the progress each time that cases are finished.
        start: What holds workers; left out: processes of this machine.
        part: Of the study, for several machines; left out: all of it. `merge` makes the journals of parts one.

    Raises:
        DesignError: If paths do not exist, cases are too many, all of them fail, or the journal is there already.
        SolveError: If the journal cannot be written, or no worker starts.
    """
    refuse_search(study)
    case_count(study)
    refuse_part(study, part)
    refuse_unknown_paths(study, designs)
    if journal is None:
        book = in_memory(study, designs)
        with closing(book.database), start(study, fixed(study, designs), workers) as compute:
            return _run(book, study, workers, watch, compute, part)
    begin(journal, study, designs, origin=origin)
    with opened(journal) as book, start(study, fixed(study, designs), workers) as compute:
        return _run(book, study, workers, watch, compute, part)


def resume(
    journal: Path, *, workers: int = 0, designs: Mapping[str, Design] | None = None, anyway: bool = False,
    watch: Watch | None = None, start: Start = local, part: Part = WHOLE,
) -> Table:  # fmt: skip
    """Return the table of a study that was stopped, after computing what is missing, from the journal alone.

    Args:
        journal: Its file.
        workers: Processes that compute; 0 computes in this one.
        designs: The designs as they are now, to compare; left out: not compared.
        anyway: Continue with the designs in the journal even if they, or what computes, have changed since.
        watch: Called with the progress each time that cases are finished.
        start: What holds workers; left out: processes of this machine.
        part: Of the study that is computed; left out: all that is missing.

    Raises:
        DesignError: If it is no journal, another runner is at it, or designs or versions have changed.
        SolveError: If the journal cannot be written, or no worker starts.
    """
    known = recorded(journal)
    refuse_search(known.study)
    refuse_part(known.study, part)
    if not anyway:
        refuse_changes(journal, known, designs or {})
    with opened(journal) as book, start(known.study, fixed(known.study, known.designs), workers) as compute:
        return _run(book, known.study, workers, watch, compute, part)


def refuse_changes(journal: Path, known: Recorded, designs: Mapping[str, Design]) -> None:
    """Raise if a study would be continued with anything but what it was begun with.

    Args:
        journal: Its file.
        known: What it says.
        designs: The designs as they are now.

    Raises:
        DesignError: With what has changed.
    """
    fix = "begin a new journal, or continue --anyway with the designs in the journal"
    problems = [
        Problem(f"designs.{name}", f"has changed since the study was begun; {fix}")
        for name, design in designs.items()
        if design != known.designs[name]
    ]
    problems += [
        Problem(name, f"the study was begun with {begun}, this is {now}; results may differ: {fix}")
        for name, begun, now in changes_of(known.made_with, made_with())
    ]
    refuse(problems, str(journal))


def _run(book: Journal, study: Study, workers: int, watch: Watch | None, compute: Compute, part: Part) -> Table:
    """Compute what the journal lacks of a part, batch after batch."""
    own = part.cases(case_count(study))
    done = {number: failed for number, failed in book.finished().items() if number in own}
    meter = _Meter(len(own), len(done), sum(done.values()), watch)
    searches = study.searches
    known = dict(zip(sorted(done), book.rows(done), strict=True)) if done and (searches or watch is not None) else {}
    if watch is not None and done:
        watch(Progress(len(done), meter.total, meter.failed, 0.0, tuple(known.items())))
    known = known if searches else {}
    book.begin_run(workers)
    for batch, answer in batches(study):
        wanted: list[int] = []
        missing = _missing((case for case in batch if case.number in own), done, wanted)
        for finished in compute(missing, meter.total - len(done)):
            together = blocks_of(finished)
            book.append(together)
            meter.count(together)
            if searches:
                known.update(together)
        answer([known[number] for number in wanted if number in known])
    rows = book.rows(own)
    if len(rows) < meter.total:
        raise SolveError(
            f"{meter.total - len(rows)} of {meter.total} cases were not computed; `gearwright resume` does"
        )
    return table_of(study, rows)


def _missing(batch: Iterator[Case], done: Mapping[int, bool], wanted: list[int]) -> Iterator[Case]:
    for case in batch:
        wanted.append(case.number)
        if case.number not in done:
            yield case


class _Meter:
    """Counts finished cases and tells who watches."""

    def __init__(self, total: int, done: int, failed: int, watch: Watch | None) -> None:
        self.total, self.earlier, self.done, self.failed, self.watch = total, done, done, failed, watch
        self.start = time.monotonic()

    def count(self, finished: Blocks) -> None:
        self.done += len(finished)
        self.failed += finished.failed
        if self.watch is not None:
            elapsed = time.monotonic() - self.start
            rate = (self.done - self.earlier) / elapsed if elapsed > 0.0 else 0.0
            self.watch(Progress(self.done, self.total, self.failed, rate, finished))


# ----------------------------------------------------------------------------------------------------------------------
# Running a study that keeps no rows: finished cases are reduced as they come, and the state is on disk every while.
# ----------------------------------------------------------------------------------------------------------------------


FORMAT = "gearwright reduced study 1"
"""First entry of a state file."""
LARGEST = 1 << 30
"""State file that is read [bytes]."""
EVERY = 20.0
"""Time between two states on disk [s]: what a kill costs at most."""


@dataclass
class Spans:
    """Which of the cases, counted within a part, are finished: spans that do not touch."""

    ends: dict[int, int] = field(default_factory=dict)
    """First -> one behind the last."""

    def add(self, numbers: Ints) -> None:
        """Add finished cases.

        Args:
            numbers: Of the cases within the part, none of them added before.
        """
        numbers = np.sort(numbers)
        breaks = np.flatnonzero(np.diff(numbers) > 1) + 1
        for span in np.split(numbers, breaks):
            if len(span):
                self._join(int(span[0]), int(span[-1]) + 1)

    def _join(self, first: int, end: int) -> None:
        before = next((start for start, stop in self.ends.items() if stop == first), None)
        if before is not None:
            first = before
        self.ends[first] = self.ends.pop(end, end)

    def __contains__(self, number: int) -> bool:
        """Tell whether a case is finished."""
        return any(first <= number < end for first, end in self.ends.items())

    def __len__(self) -> int:
        """Return how many are."""
        return sum(end - first for first, end in self.ends.items())


def reduce_study(
    study: Study, designs: Mapping[str, Design], *, workers: int = 0, state: Path | None = None,
    watch: Watch | None = None, start: Start = local, part: Part = WHOLE,
) -> Reduced:  # fmt: skip
    """Return what is left of a study when each of its cases has been seen once; the same whatever computes it.

    Args:
        study: With the table ``reduced``.
        designs: Name -> design.
        workers: Processes that compute; 0 computes in this one.
        state: File that keeps what is left every while; one that is there is continued. Left out: nothing is kept.
        watch: Called with the progress each time that cases are finished.
        start: What holds workers; left out: processes of this machine.
        part: Of the study, for several machines; `merge_reduced` adds them up.

    Raises:
        DesignError: If paths do not exist, cases are too many, or the file is of another study or version.
        SolveError: If no worker starts.
    """
    total = len(part.cases(case_count(study)))
    refuse_part(study, part)
    refuse_unknown_paths(study, designs)
    reduced, spans = _begun(study, designs, state, part)
    own = (case for case in cases(study) if part.has(case.number))
    missing = (case for case in own if case.number // part.of not in spans) if len(spans) else own
    earlier, begun = len(spans), time.monotonic()
    saved = begun
    with start(study, fixed(study, designs), workers) as compute:
        try:
            for finished in compute(missing, total - earlier):
                together = blocks_of(finished)
                reduced.absorb(together)
                spans.add(_numbers(together) // part.of)
                now = time.monotonic()
                if state is not None and now - saved > EVERY:
                    _save(state, reduced, designs, spans, part)
                    saved = now
                if watch is not None:
                    watch(Progress(len(spans), total, reduced.failed, (len(spans) - earlier) / max(now - begun, 1e-9)))
        finally:
            if state is not None:
                _save(state, reduced, designs, spans, part)
    return reduced


def merge_reduced(states: Sequence[Path], into: Path) -> Reduced:
    """Add up the states of parts of one study, write them as one, and return it.

    Args:
        states: Of different parts.
        into: New file.

    Raises:
        DesignError: If they are not of one study, its designs and one version, or a part is there twice.
    """
    trees = [_read(path) for path in states]
    problems, seen = list[Problem](), dict[str, Path]()
    for path, tree in zip(states, trees, strict=True):
        if (tree["study"], tree["designs"], tree["made_with"]) != tuple(
            trees[0][key] for key in ("study", "designs", "made_with")
        ):
            problems.append(Problem(str(path), f"is not of the same study, designs and versions as {states[0]}"))
        if (other := seen.setdefault(tree["part"], path)) is not path:
            problems.append(Problem(str(path), f"has the same part {tree['part']} as {other}; leave one of them out"))
    refuse(problems)
    study = Study.model_validate_json(trees[0]["study"])
    whole = from_plain(study, trees[0]["reduced"])
    for tree in trees[1:]:
        whole.add(from_plain(study, tree["reduced"]))
    _write(into, {**trees[0], "part": "all", "spans": [], "reduced": as_plain(whole)})
    return whole


def is_reduced(path: Path) -> bool:
    """Tell whether a file is the state of a reduced study.

    Args:
        path: Of a file that is there.
    """
    with path.open("rb") as file:
        return FORMAT.encode() in file.read(len(FORMAT) + 40)


def _begun(study: Study, designs: Mapping[str, Design], state: Path | None, part: Part) -> tuple[Reduced, Spans]:
    """Return what a file has kept of the study, or nothing."""
    if state is None or not state.exists():
        return Reduced(study), Spans()
    tree = _read(state)
    fix = "name a new file, or run the study that it is of"
    problems = []
    if tree["study"] != dumped(study):
        problems.append(Problem("journal", f"is of another study: other axes, results or sampling; {fix}"))
    problems += [
        Problem(f"designs.{name}", f"has changed since the study was begun; {fix}")
        for name, design in designs.items()
        if tree["designs"].get(name) != dumped(design)
    ]
    problems += [
        Problem(name, f"the study was begun with {begun}, this is {now}; {fix}")
        for name, begun, now in changes_of(tree["made_with"], made_with())
    ]
    if tree["part"] != _name(part):
        problems.append(Problem("--shard", f"the file has part {tree['part']}, this is {_name(part)}; {fix}"))
    refuse(problems, str(state))
    return from_plain(study, tree["reduced"]), Spans(dict(map(tuple, tree["spans"])))


def _save(path: Path, reduced: Reduced, designs: Mapping[str, Design], spans: Spans, part: Part) -> None:
    _write(path, {
        "study": dumped(reduced.study),
        "designs": {name: dumped(design) for name, design in designs.items()},
        "made_with": dict(made_with()),
        "part": _name(part),
        "spans": sorted(spans.ends.items()),
        "reduced": as_plain(reduced),
    })  # fmt: skip


def _write(path: Path, tree: Mapping[str, Any]) -> None:
    text = json.dumps({key: value for key, value in tree.items() if key not in ("format", "sum")})
    write_text(path, json.dumps({"format": FORMAT, "sum": summed(text)[-1], "content": text}))


def _read(path: Path) -> dict[str, Any]:
    try:
        outer = json.loads(bytes_of(path, largest=LARGEST))
        if outer["format"] != FORMAT or summed(outer["content"])[-1] != outer["sum"]:
            raise ValueError
        tree: dict[str, Any] = json.loads(outer["content"])
    except (ValueError, KeyError, TypeError):
        message = "is no state of a reduced study, or a damaged one; name a new file to begin again"
        raise DesignError([Problem("", message)], str(path)) from None
    return tree


def _name(part: Part) -> str:
    return f"{part.number}/{part.of}"


def _numbers(finished: Blocks) -> Ints:
    return np.concatenate([block.records[NUMBER] for block in finished.blocks])


# ----------------------------------------------------------------------------------------------------------------------
# Compare architectures: designs fitted to one engine, in one table.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def compare(
    designs: Mapping[str, Design] | None = None,
    *,
    power: float | None = None,
    engine_speed: float | None = None,
    propeller_speed: float | None = None,
    changes: Mapping[str, Value] | None = None,
) -> Table:
    """Return masses, margins and power densities of designs, each as it is or fitted to one engine by `for_engine`.

    Where a power or speed is asked, the designs are architectures: tooth numbers and how many planets there are become
    free and are chosen for the least mass. `changes` may give them.

    Args:
        designs: Name -> design; left out: the architectures of the shipped study.
        power: Rated power of turbines and motors together [W]; left out: each design's own, as the speeds below.
        engine_speed: Speed of the turbines [rad/s].
        propeller_speed: Speed of the propellers [rad/s].
        changes: Dotted path -> value, the same in every design.

    Raises:
        DesignError: If a power or speed is none, or all designs fail; one that fails is a row with its reason.
    """
    study = comparison_of(designs, changes=changes)
    chosen = {name: read(name) for name in study.designs} if designs is None else designs

    def fitted(design: Design) -> Design:
        return for_requirement(design, power=power, engine_speed=engine_speed, propeller_speed=propeller_speed)

    refuse_no_size(power=power, engine_speed=engine_speed, propeller_speed=propeller_speed)
    return table_of(study, [evaluate(study, chosen[case.design], case, fitted=fitted) for case in cases(study)])


def comparison_of(designs: Iterable[str] | None, *, changes: Mapping[str, Value] | None = None) -> Study:
    """Return the study of which `compare` gives the table.

    Args:
        designs: Their names; left out: those of the shipped study.
        changes: Dotted path -> value, the same in every design.
    """
    study = read_study(shipped_study("architectures"))
    names = study.designs if designs is None else list(designs)
    name = study.name if names == list(study.designs) else f"{len(names)} designs for one engine"
    return study.model_copy(update={"designs": names, "name": name, "changes": dict(changes or {})})


# ----------------------------------------------------------------------------------------------------------------------
# The verb: many scattered flights of one design, and how fuel, charge and lives are spread.
# ----------------------------------------------------------------------------------------------------------------------


USUAL_RESULTS = ("fly.fuel", "fly.battery_energy", "fly.minimum_charge", "fly.duration", "fly.life")
"""What is kept of a flight where nothing is asked."""


@verb
def fly_many(
    design: Design,
    mission: Mission,
    scatter: Mapping[str, Axis | Mapping[str, float | str]],
    count: int,
    *,
    seed: int = 1,
    results: Sequence[str] = USUAL_RESULTS,
    workers: int = 0,
    journal: Path | None = None,
    watch: Callable[[Progress], None] | None = None,
) -> Table:
    """Return the table of scattered flights of a design, a row for each; the same bits with any number of workers.

    Args:
        design: As read; it is sized once, unless the scatter changes it.
        mission: What is flown.
        scatter: Dotted path with unit -> distribution, as the axes of a study; a path of the mission begins with
            ``mission.``, and several paths with commas between them have the same value in every flight.
        count: Flights [-].
        seed: Of the random numbers.
        results: What is kept of each flight, by the names of studies.
        workers: Processes that compute; 0 computes in this one.
        journal: File that keeps every finished flight at once, for `gearwright resume`; left out: nothing is kept.
        watch: Called with the progress each time that flights are finished.

    Raises:
        DesignError: A path that does not exist, a distribution that is none, or every flight fails. One that fails is
            a row with its reason.
    """
    name = design.name
    problems = [Problem("count", f"{count}; fly one at least")] if count < 1 else []
    refuse(problems, "fly_many")
    axes = {path: Axis.model_validate(axis) if isinstance(axis, Mapping) else axis for path, axis in scatter.items()}
    study = Study.model_validate(
        {
            "name": f"{count} flights of {name}",
            "designs": [name],
            "axes": {path: axis.model_dump(by_alias=True, exclude_unset=True) for path, axis in axes.items()},
            "results": list(results),
            "sampling": {"method": "random", "count": count, "seed": seed},
        }
    ).model_copy(update={"mission": mission})
    refuse(study_problems(study), "fly_many")
    return run_study(study, {name: design}, workers=workers, journal=journal, watch=watch)
