"""Questions of the workbench page, their answers, and the cache of sized designs."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from gearwright.errors import DesignError, GearwrightError, Problem, by_name, refuse
from gearwright.memo import Memo

if TYPE_CHECKING:
    from gearwright.arrays import Floats
    from gearwright.sizing import Sizing


# ----------------------------------------------------------------------------------------------------------------------
# What the page may ask: verb -> module of this folder that has a function of that name. It loads nothing itself.
# ----------------------------------------------------------------------------------------------------------------------


QUICK = {
    "edit": "questions",
    "flow": "questions",
    "form": "questions",
    "influences": "questions",
    "meaning": "questions",
    "model": "questions",
    "schematic": "questions",
    "size": "questions",
}
"""What answers at once."""
BESIDE = {"form": "form", "meaning": "form", "influences": "influences"}
"""Those that need no sizing, or take seconds where a standard rates gears -> a process in which no number waits."""
LIMITS = {"form": 60.0, "influences": 900.0}
"""After which an answer of such a process is no longer waited for [s]."""
LONG = {
    "campbell": "motions",
    "close": "trials",
    "export": "questions",
    "fly": "motions",
    "mission": "motions",
    "modes": "motions",
    "moved": "trials",
    "report": "questions",
    "resume": "trials",
    "review": "questions",
    "rows": "trials",
    "runup": "motions",
    "simulate": "motions",
    "study": "trials",
    "variant": "trials",
    "window": "motions",
}
"""Jobs, which tell how far they are, in processes that can be ended."""


# ----------------------------------------------------------------------------------------------------------------------
# What a page asks and what it is told: questions and answers that travel between processes, sizings that are kept.
# ----------------------------------------------------------------------------------------------------------------------


_SIZINGS = Memo[tuple[str, str], "Sizing"](32)
"""The latest sizings, by text and folder."""


@dataclass(frozen=True)
class Question:
    """What a page asks."""

    verb: str
    text: str
    """Of the design."""
    folder: str
    """Where the files that it names are looked for."""
    options: Mapping[str, Any] = field(default_factory=dict)

    def words(self, name: str) -> str:
        """Return an option that is a text.

        Args:
            name: Of the option.

        Raises:
            DesignError: If it is none.
        """
        value = self.options.get(name)
        if not isinstance(value, str):
            raise DesignError([Problem(name, "a text is needed")])
        return value

    def number(self, name: str, usual: float, most: float) -> float:
        """Return an option that is a positive number.

        Args:
            name: Of the option.
            usual: Where it is left out.
            most: Largest that is allowed.

        Raises:
            DesignError: If it is none, or too large.
        """
        value = self.options.get(name, usual)
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0.0 < value <= most:
            raise DesignError([Problem(name, f"a number above 0 and at most {most:g} is needed")])
        return float(value)


class Answer(NamedTuple):
    """What it is told."""

    content: bytes
    kind: str = "application/json"
    status: int = 200


class Progress(NamedTuple):
    """How far a computation is."""

    done: float
    """Part of it, from 0 to 1."""
    words: str = ""
    lasting: bool = False
    """Whether it is to be shown even if another has just been, as nothing follows for a while."""


Tell = Callable[[Progress], None]
"""Takes how far a computation is."""


def as_json(value: object) -> bytes:
    """Return a plain value as JSON.

    Args:
        value: Without numbers that are not finite.
    """
    return json.dumps(value, ensure_ascii=False, allow_nan=False).encode("utf-8", "backslashreplace")


def packed(head: dict[str, Any], columns: Mapping[str, Floats]) -> Answer:
    """Return words and long columns of numbers: length of the words in four bytes, the words as JSON, the columns.

    Args:
        head: Plain; it is told where each column stands.
        columns: Name -> numbers, which travel in single precision, little-endian.
    """
    import numpy as np

    at, places = 0, dict[str, list[int]]()
    for name, values in columns.items():
        places[name] = [at, int(np.size(values))]
        at += int(np.size(values))
    words = as_json({**head, "columns": places})
    words += b" " * (-len(words) % 4)
    data = b"".join(np.ascontiguousarray(values, dtype="<f4").tobytes() for values in columns.values())
    return Answer(len(words).to_bytes(4, "little") + words + data, "application/octet-stream")


def sized(question: Question) -> Sizing:
    """Return the sizing of a text; one that names files is sized anew each time, as those may change.

    Args:
        question: With the text.
    """
    from gearwright.sizing import size
    from gearwright.spec import parse, placed

    key = (question.text, question.folder)
    if (known := _SIZINGS.get(key)) is not None:
        return known
    design = parse(question.text, folder=Path(question.folder))
    try:
        sizing = size(design)
    except DesignError as error:
        raise DesignError(placed(error.problems, question.text)) from None
    return sizing if "file" in question.text else _SIZINGS.keep(key, sizing)


def case_of(question: Question, sizing: Sizing) -> str:
    """Return the load case that is asked for, or the governing one.

    Args:
        question: With its case.
        sizing: Of the design.
    """
    from gearwright.sizing import governing_case

    name = question.options.get("case") or governing_case(sizing)
    if not isinstance(name, str):
        refuse([Problem("case", "a name is needed")])
    by_name(name, sizing.flows, "case")
    return str(name)


# ----------------------------------------------------------------------------------------------------------------------
# What the page may ask, each one public verb: a question of text in, an answer of bytes out. Runs in a worker.
#
# Nothing is computed here; sizings are kept for a while, as the numbers, the power flow and the solids of one text ask
# for the same one.
# ----------------------------------------------------------------------------------------------------------------------


CONTACT = ("scuffing, flash temperature", "contact")
"""Chapter and quantity of the hottest place of a flank."""


def answered(question: Question, tell: Tell = lambda _: None) -> Answer:
    """Return the answer to a question; what is wrong with the design is an answer too.

    Args:
        question: Of a page.
        tell: Takes how far a long computation is.
    """
    verb = question.verb
    try:
        found = getattr(import_module(f"gearwright.app.{QUICK.get(verb) or LONG[verb]}"), verb)
        answer: Answer = found(question) if verb in QUICK else found(question, tell)
        return answer
    except DesignError as error:
        return _told([{"path": one.path, "message": one.message, "line": one.line} for one in error.problems])
    except (GearwrightError, MemoryError) as error:
        return _told([{"path": "", "message": str(error) or "there is not enough memory for this", "line": None}])


def _told(problems: list[dict[str, Any]]) -> Answer:
    return Answer(as_json({"problems": problems}), status=422)


def size(question: Question) -> Answer:
    """Return every number of a sizing, with its verdict.

    Args:
        question: With the text.
    """
    from gearwright.particulars import particulars
    from gearwright.render.answers.design import size_answer
    from gearwright.render.answers.schema import plain
    from gearwright.render.words.sizing import sizing_headline
    from gearwright.sizing import governing_case

    sizing = sized(question)
    told = {
        "name": sizing.design.name,
        "case": governing_case(sizing),
        "headline": sizing_headline(sizing),
        "holds": not any(check.fails for check in sizing.checks),
        "result": plain(size_answer(particulars(sizing))),
    }
    return Answer(as_json(told))


def form(question: Question) -> Answer:
    """Return the text as a form: every entry, written or possible.

    Args:
        question: With the text.
    """
    from gearwright.app.form import form_json

    return Answer(form_json(question.text))


def edit(question: Question) -> Answer:
    """Return the text with one entry changed, or written in another unit.

    Args:
        question: With the text, the path, and the value or the key of the other unit.
    """
    from gearwright.app.form import in_unit, with_entry

    path, value, key = (question.options.get(name) for name in ("path", "value", "key"))
    if not isinstance(path, list) or not all(isinstance(name, str) for name in path):
        refuse([Problem("path", "a list of names is needed")])
    elif isinstance(key, str):
        return Answer(as_json({"text": in_unit(question.text, path, key)}))
    return Answer(as_json({"text": with_entry(question.text, path or (), value)}))


def flow(question: Question) -> Answer:
    """Return the power flow of a load case as SVG.

    Args:
        question: With the text, and the load case.
    """
    from gearwright.render.schematic import power_flow_figure
    from gearwright.render.style import to_svg

    sizing = sized(question)
    return Answer(to_svg(power_flow_figure(sizing, case_of(question, sizing)), "flow").encode(), "image/svg+xml")


def schematic(question: Question) -> Answer:
    """Return the skeleton as SVG.

    Args:
        question: With the text.
    """
    from gearwright.render.schematic import schematic_figure
    from gearwright.render.style import to_svg

    return Answer(to_svg(schematic_figure(sized(question)), "schematic").encode(), "image/svg+xml")


def model(question: Question) -> Answer:
    """Return the solids, behind what the page says of them: length of that text in four bytes, the text, the GLB.

    Args:
        question: With the text, and the detail.
    """
    from gearwright.render.pages.motion import solid_facts
    from gearwright.shape import glb, scene

    sizing = sized(question)
    built = scene(sizing, detail="fine" if question.options.get("detail") == "fine" else "coarse")
    facts = as_json(_with_temperatures(sizing, solid_facts(sizing, built)))
    facts += b" " * (-len(facts) % 4)
    return Answer(len(facts).to_bytes(4, "little") + facts + glb(built), "application/octet-stream")


def _with_temperatures(sizing: Sizing, facts: dict[str, Any]) -> dict[str, Any]:
    """Return what is said of solids with the contact temperature of gears that a standard rates against scuffing."""
    from gearwright.render.answers.design import factors_answer
    from gearwright.sizing import rated_factors

    for mesh in factors_answer(rated_factors(sizing)):
        hot = [value for row in mesh.factors if (row.chapter, row.quantity) == CONTACT for value in row.values]
        for gear in mesh.gears:
            if hot and gear in facts["parts"]:
                part = facts["parts"][gear]
                part["temperature"] = max(part.get("temperature", -273.15), *map(float, hot))
    return {**facts, "heat": "contact temperature of the flanks, ISO/TS 6336-20"}


def review(question: Question, _: Tell) -> Answer:
    """Return every check of the review, worst first.

    Args:
        question: With the text.
        _: There is nothing to tell.
    """
    from gearwright.render.answers.review import review_answer
    from gearwright.render.answers.schema import plain
    from gearwright.render.words.sizing import headline
    from gearwright.reviews import review_of
    from gearwright.spec import placed

    sizing = sized(question)
    try:
        review = review_of(sizing)
    except DesignError as error:
        raise DesignError(placed(error.problems, question.text)) from None
    return Answer(as_json({"headline": headline(review), "result": plain(review_answer(review))}))


def influences(question: Question) -> Answer:
    """Return every factor of gears that a standard rates, and what 1 % of each value does to the safeties.

    Args:
        question: With the text.
    """
    from gearwright.render.answers.design import factors_answer, influences_answer
    from gearwright.render.answers.schema import plain
    from gearwright.sizing import influences as find_influences, rated_factors

    sizing = sized(question)
    moving = influences_answer(find_influences(sizing, 1.0))
    return Answer(as_json(plain({"factors": factors_answer(rated_factors(sizing)), "influences": moving})))


def meaning(_: Question) -> Answer:
    """Return what every number of a sizing means: words, unit, equation and source, as its schema has them.

    Args:
        _: Of a page; the text does not matter.
    """
    from gearwright.render.answers.design import SizeAnswer
    from gearwright.render.answers.schema import described

    definitions: dict[str, Any] = {}
    described(SizeAnswer, definitions)
    return Answer(as_json(definitions))


def export(question: Question, _: Tell) -> Answer:
    """Return a file of a format.

    Args:
        question: With the text, and the format.
        _: There is nothing to tell.
    """
    from gearwright.formats import AS_USUAL, FORMATS

    wanted = question.options.get("format")
    name = wanted if isinstance(wanted, str) else ""
    by_name(name, FORMATS, "format")
    return Answer(FORMATS[name](sized(question), AS_USUAL)[0], "application/octet-stream")


def report(question: Question, _: Tell) -> Answer:
    """Return the report as a page.

    Args:
        question: With the text.
        _: There is nothing to tell.
    """
    from gearwright.render.pages.report import report

    return Answer(report(sized(question)).encode(), "application/octet-stream")
