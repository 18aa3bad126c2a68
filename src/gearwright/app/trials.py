"""Studies and design closure in the workbench."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from gearwright.app.form import form, with_entry
from gearwright.app.questions import Answer, Progress, Question, Tell, as_json, sized
from gearwright.app.serving import journal_path
from gearwright.errors import DesignError, Problem
from gearwright.shipped import find_design
from gearwright.spec import case_count, file_text, parse, parse_study
from gearwright.units import key_suffix

if TYPE_CHECKING:
    from gearwright.app.form import Field
    from gearwright.sizing import Sizing
    from gearwright.spec import Design, Study
    from gearwright.study import Table
    from gearwright.study.running import Progress as Ran


# ----------------------------------------------------------------------------------------------------------------------
# What the page asks of many designs: studies in the journal of the command line, one variant as a text, what moves.
# ----------------------------------------------------------------------------------------------------------------------


OWN = "this"
"""How a study calls the design that is on the page."""
SMALL = 200
"""Cases that are not worth the start of other processes, as `gearwright study` has it."""
MOST_ROWS = 20_000
"""Rows that a page is given; of more, evenly spaced ones [-]."""
MOST_MOVED = 120
"""Numbers of a design that are moved one by one [-]."""
MOST_WORDS = 5
"""Words of which one may be written that are tried [-]."""
STEP = 0.01
"""By which part a number is moved; whole numbers by one [-]."""
SAME = 1e-9
"""Relative change below which a result has not moved [-]."""


def study(question: Question, tell: Tell) -> Answer:
    """Run a study, every finished case in a journal of the folder; return its table.

    Args:
        question: With the study's text and the journal's name.
        tell: Takes how far it is.
    """
    from gearwright.study.running import run_study

    folder = Path(question.folder)
    read = parse_study(question.words("study"), folder=folder)
    designs = {name: _design(question, name, folder) for name in read.designs}
    journal = _journal(question, folder)
    workers = 0 if case_count(read) <= SMALL else os.cpu_count() or 1
    table = run_study(
        read, designs, workers=workers, journal=journal, origin=str(folder), watch=_watch(tell)
    )  # fmt: skip
    return Answer(as_json(_told_table(read, table)))


def resume(question: Question, tell: Tell) -> Answer:
    """Go on with a study that was paused, in the page or by the command line; return its table.

    Args:
        question: With the journal's name.
        tell: Takes how far it is.
    """
    from gearwright.study.journal import recorded
    from gearwright.study.running import resume as go_on

    journal = _journal(question, Path(question.folder))
    known = recorded(journal)
    workers = 0 if known.total <= SMALL else os.cpu_count() or 1
    return Answer(as_json(_told_table(known.study, go_on(journal, workers=workers, watch=_watch(tell)))))


def rows(question: Question, tell: Tell) -> Answer:
    """Return what a journal holds, also while it is written.

    Args:
        question: With the journal's name.
        tell: Takes how far it is; there is nothing to tell.
    """
    from gearwright.study.journal import rows_of, status
    from gearwright.study.running import table_of

    journal = _journal(question, Path(question.folder))
    state = status(journal)
    known = state.recorded.study
    finished = rows_of(journal)
    table = replace(table_of(known, finished), rows=tuple(finished)) if finished else None
    told = _told_table(known, table) if table is not None else {"rows": [], "front": []}
    return Answer(as_json({**told, "done": state.done, "total": state.recorded.total, "running": state.running}))


def variant(question: Question, tell: Tell) -> Answer:
    """Return the text of a design with the entries of one row of a study in it.

    Args:
        question: With the design's name, and path -> value.
        tell: Takes how far it is; there is nothing to tell.
    """
    name, changes = question.words("design"), question.options.get("changes")
    text = question.text if name == OWN else file_text(find_design(name, Path(question.folder)))
    if not isinstance(changes, dict):
        raise DesignError([Problem("changes", "paths with values are needed")])
    for path, value in changes.items():
        text = with_entry(text, path.split("."), value)
    return Answer(as_json({"text": text}))


def moved(question: Question, tell: Tell) -> Answer:
    """Return what a little more of each number, or another word, of those that a design could give does to its results.

    One per cent more, whole numbers by one, face widths by 1 mm; everything else is found anew, by `size_many`.

    Args:
        question: With the text.
        tell: Takes how far it is.
    """
    from gearwright.sizing import named_results, size_many

    sizing = sized(question)
    handles = [*_handles(question.text, sizing), *_words(question.text)][:MOST_MOVED]
    axes = {
        path: [one.more if one.path == path else None for one in handles]
        for path in dict.fromkeys(one.path for one in handles)
    }
    tell(Progress(0.05, f"{len(handles)} numbers, each moved alone"))
    base = named_results(sizing)
    found = size_many(sizing.design, axes, results=list(base))
    changes: dict[str, list[float | None]] = {}
    for name, (value, dimension) in base.items():
        if isinstance(value, str) or not value:
            continue
        shares = [_rounded(now / value - 1.0) for now in found.columns[name].tolist()]
        if any(shares):
            suffix = key_suffix(dimension)
            changes[f"{name}_{suffix}" if suffix else name] = shares
    rows = [{**one._asdict(), "why": found.reasons.get(k, "")} for k, one in enumerate(handles)]
    return Answer(as_json({"handles": rows, "changes": changes}))


def _rounded(share: float) -> float | None:
    return float(f"{share:.4g}") if math.isfinite(share) and abs(share) > SAME else None if share != share else 0.0


class Handle(NamedTuple):
    """A number that is moved."""

    path: str
    """Dotted, with the unit at its end."""
    value: float | str
    """As it is, in that unit."""
    more: float | str
    """As it is moved, or what else it may be."""
    kind: str
    """written, default, computed, or choice."""


def _handles(text: str, sizing: Sizing) -> Iterator[Handle]:
    """Yield the numbers that a text gives, the defaults of tables that it has, and widths and modules of stages."""
    for group in form(text):
        for entry in group.written:
            if entry.key != "schema":
                yield from _handle(group.path, entry, entry.value, "written")
        for entry in group.possible:
            yield from _handle(group.path, entry, entry.default, "default")
            yield from _handle(group.path, entry, _computed(sizing, group.path, entry.key), "computed")


def _words(text: str) -> Iterator[Handle]:
    """Yield what entries may be instead that are one of a few words: kinds of bearings, grades, laws."""
    for group in form(text):
        for entry in (*group.written, *group.possible):
            if len(entry.choices) <= MOST_WORDS:
                yield from _choices(group.path, entry)


def _choices(path: tuple[str, ...], entry: Field) -> Iterator[Handle]:
    """Yield what an entry may be instead, where it is one of a few words."""
    now = entry.value if entry.value is not None else entry.default
    for other in entry.choices if path else ():
        if other != now:
            yield Handle(".".join((*path, entry.key)), "" if now is None else str(now), other, "choice")


def _handle(path: tuple[str, ...], entry: Field, value: object, kind: str) -> Iterator[Handle]:
    if entry.kind not in ("number", "integer") or isinstance(value, bool) or not isinstance(value, int | float):
        return
    if kind == "computed" and entry.key == "face_width_mm":
        more = value + 1.0
    else:
        more = value + 1 if entry.kind == "integer" else value * (1.0 + STEP)
    if value and math.isfinite(value) and (entry.most is None or more <= entry.most):
        yield Handle(".".join((*path, entry.key)), value, more, kind)


def _computed(sizing: Sizing, path: tuple[str, ...], key: str) -> float | None:
    """Return the width or module of a stage that its table could give [mm], where all its gears share it."""
    field = {"face_width_mm": "face_width", "module_mm": "module"}.get(key)
    if field is None or len(path) != 2:
        return None
    values = {float(getattr(gear, field)) * 1e3 for gear in sizing.gears if gear.stage == path[1]}
    return values.pop() if len(values) == 1 else None


def _design(question: Question, name: str, folder: Path) -> Design:
    from gearwright.spec import parse, read

    return parse(question.text, folder=folder) if name == OWN else read(find_design(name, folder))


def _journal(question: Question, folder: Path) -> Path:
    return journal_path(folder, question.words("journal"))


def _watch(tell: Tell) -> Callable[[Ran], None]:
    def watch(now: Ran) -> None:
        words = f"{now.done:,} of {now.total:,} cases, {now.failed:,} infeasible, {now.rate:.3g}/s"
        tell(Progress(now.done / max(1, now.total), words))

    return watch


def _told_table(read: Study, table: Table) -> dict[str, Any]:
    """Return a table with its front and what it must keep, as the page draws it."""
    from gearwright.render.answers.schema import plain
    from gearwright.render.answers.studies import study_row
    from gearwright.render.words.study import answer

    stride = max(1, -(-len(table.rows) // MOST_ROWS))
    given = table.rows[::stride]
    best = _front(read, table)
    words = list(answer(read, table)) if read.objectives else []
    return {
        "name": read.name, "description": read.description, "changes": dict(read.changes), "words": words,
        "rows": [plain(study_row(row)) for row in given], "left_out": len(table.rows) - len(given),
        "front": [k for k, row in enumerate(given) if id(row) in best],
        "objectives": dict(read.objectives), "kept": _kept(read),
    }  # fmt: skip


def _kept(read: Study) -> list[dict[str, Any]]:
    return [
        {"result": name, "minimum": getattr(bound, "minimum", None), "maximum": getattr(bound, "maximum", None)}
        for name, bound in read.constraints.items()
    ]


def _front(read: Study, table: Table) -> set[int]:
    from gearwright.study.tables import pareto_front

    try:
        return {id(row) for row in pareto_front(read, table)} if read.objectives else set()
    except DesignError:
        return set()


# ----------------------------------------------------------------------------------------------------------------------
# What the page asks of closure: a design whose free sizes meet every check, or what none of them meets.
# ----------------------------------------------------------------------------------------------------------------------


FREE = re.compile(r"(?:.*_)?(?:teeth|module|face_width|diametral_pitch|least_dynamic_factor)(?:_[a-z]+)?")
"""Keys of stages that a closure chooses where nobody gives them."""
STAGES = ("pairs", "planetaries")
"""Tables of stages whose sizes may be left out."""


def freed(text: str) -> str:
    """Return a text without the teeth, modules, widths and diameters of shafts that it gives.

    Args:
        text: Of a design.
    """
    for group in form(text):
        stage, shaft = group.path[:1] and group.path[0] in STAGES, group.path[:1] == ("layout",)
        if any(entry.key == "as_given" and entry.value for entry in group.written):
            continue
        for entry in group.written:
            if (stage and FREE.fullmatch(entry.key)) or (shaft and entry.key.startswith("diameter_")):
                text = with_entry(text, (*group.path, entry.key), None)
    return text


def close(question: Question, tell: Tell) -> Answer:
    """Return a closed design as a text, with what it meets, and the nearest variant that closes if one is asked for.

    Args:
        question: With the text, the life [h] if another one is asked for, whether variants are looked for, and whether
            sizes that it gives are chosen anew.
        tell: Takes what is being done.
    """
    from gearwright.closure import Outcome, Wishes, close as closed_by, nearest_variant
    from gearwright.closure.requirements import HOUR
    from gearwright.render.answers.review import close_answer
    from gearwright.render.answers.schema import plain
    from gearwright.render.tables.checks import check_sentence

    hours, wide, anew = question.options.get("life_h"), _switched(question, "variants"), _switched(question, "anew")
    design = parse(freed(question.text) if anew else question.text, folder=Path(question.folder))
    wishes = Wishes(life=None if hours is None else question.number("life_h", 1.0, 1e7) * HOUR)
    done = [0.0]

    def say(words: str) -> None:
        done[0] += 0.1 * (1.0 - done[0])
        tell(Progress(done[0], words))

    closed = closed_by(design, wishes=wishes, tell=say)
    found = nearest_variant(design, closed, tell=say) if wide and closed.outcome is Outcome.OPEN else None
    words = f"{closed.outcome}: the worst is {check_sentence(closed.worst)}" if closed.worst else str(closed.outcome)
    return Answer(as_json({"headline": words, **plain(close_answer(closed, found))}))


def _switched(question: Question, name: str) -> bool:
    value = question.options.get(name, False)
    if not isinstance(value, bool):
        raise DesignError([Problem(name, "true or false is needed")])
    return value
