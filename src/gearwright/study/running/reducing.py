"""Running a study that keeps no rows: finished cases are reduced as they come, and the state is on disk every while."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from gearwright.arrays import Ints
from gearwright.errors import DesignError, Problem, refuse
from gearwright.reading import bytes_of
from gearwright.spec import Design, Study, case_count
from gearwright.study.answers import Blocks, Reduced, as_plain, blocks_of, from_plain
from gearwright.study.answers.blocks import NUMBER
from gearwright.study.cases import cases, fixed, refuse_unknown_paths
from gearwright.study.journal.file import dumped, summed
from gearwright.study.journal.made_with import changes_of, made_with
from gearwright.study.running.parts import WHOLE, Part, refuse_part
from gearwright.study.running.runner import Progress, Start, Watch
from gearwright.study.running.workers import local
from gearwright.writing import write_text

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
