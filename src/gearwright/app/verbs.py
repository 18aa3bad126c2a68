"""What the page may ask, each one public verb: a question of text in, an answer of bytes out. Runs in a worker.

Nothing is computed here; sizings are kept for a while, as the numbers, the power flow and the solids of one text ask
for the same one.
"""

from __future__ import annotations

import json
from collections import OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from gearwright.errors import DesignError, GearwrightError, Problem, by_name, refuse

if TYPE_CHECKING:
    from gearwright.sizing import Sizing

MOST_KEPT = 32
"""Sizings that are kept [-]."""
_kept: OrderedDict[tuple[str, str], Sizing] = OrderedDict()


@dataclass(frozen=True)
class Question:
    """What a page asks."""

    verb: str
    text: str
    """Of the design."""
    folder: str
    """Where the files that it names are looked for."""
    options: Mapping[str, Any] = field(default_factory=dict)


class Answer(NamedTuple):
    """What it is told."""

    content: bytes
    kind: str = "application/json"
    status: int = 200


def answered(question: Question) -> Answer:
    """Return the answer to a question; what is wrong with the design is an answer too.

    Args:
        question: Of a page.
    """
    try:
        return VERBS[question.verb](question)
    except DesignError as error:
        return _told([{"path": one.path, "message": one.message, "line": one.line} for one in error.problems])
    except (GearwrightError, MemoryError) as error:
        return _told([{"path": "", "message": str(error) or "there is not enough memory for this", "line": None}])


def _told(problems: list[dict[str, Any]]) -> Answer:
    return Answer(_json({"problems": problems}), status=422)


def _json(value: object) -> bytes:
    return json.dumps(value, ensure_ascii=False, allow_nan=False).encode("utf-8", "backslashreplace")


def _sized(question: Question) -> Sizing:
    """Return the sizing of a text; one that names files is sized anew each time, as those may change."""
    from gearwright.sizing import size
    from gearwright.spec import parse, placed

    key = (question.text, question.folder)
    if key in _kept:
        _kept.move_to_end(key)
        return _kept[key]
    design = parse(question.text, folder=Path(question.folder))
    try:
        sizing = size(design)
    except DesignError as error:
        raise DesignError(placed(error.problems, question.text)) from None
    if "file" not in question.text:
        _kept[key] = sizing
        while len(_kept) > MOST_KEPT:
            _kept.popitem(last=False)
    return sizing


def _case(question: Question, sizing: Sizing) -> str:
    """Return the load case that is asked for, or the first."""
    name = question.options.get("case") or next(iter(sizing.flows))
    if not isinstance(name, str):
        refuse([Problem("case", "a name is needed")])
    by_name(name, sizing.flows, "case")
    return str(name)


def _size(question: Question) -> Answer:
    from gearwright.render.answers.design import size_answer
    from gearwright.render.answers.plain import plain
    from gearwright.render.words.headline import sizing_headline

    sizing = _sized(question)
    told = {
        "name": sizing.design.name,
        "headline": sizing_headline(sizing),
        "holds": not any(check.fails for check in sizing.checks),
        "result": plain(size_answer(sizing)),
    }
    return Answer(_json(told))


def _form(question: Question) -> Answer:
    from gearwright.app.form import form_json

    return Answer(form_json(question.text))


def _edit(question: Question) -> Answer:
    from gearwright.app.edits import in_unit, with_entry

    path, value, key = (question.options.get(name) for name in ("path", "value", "key"))
    if not isinstance(path, list) or not all(isinstance(name, str) for name in path):
        refuse([Problem("path", "a list of names is needed")])
    elif isinstance(key, str):
        return Answer(_json({"text": in_unit(question.text, path, key)}))
    return Answer(_json({"text": with_entry(question.text, path or (), value)}))


def _flow(question: Question) -> Answer:
    from gearwright.render.schematic.schematic import power_flow_figure
    from gearwright.render.style.theme import to_svg

    sizing = _sized(question)
    return Answer(to_svg(power_flow_figure(sizing, _case(question, sizing)), "flow").encode(), "image/svg+xml")


def _model(question: Question) -> Answer:
    """Return the solids, behind what the page says of them: length of that text in four bytes, the text, the GLB."""
    from gearwright.render.pages.turning import solid_facts
    from gearwright.shape import glb, scene

    sizing = _sized(question)
    built = scene(sizing, detail="fine" if question.options.get("detail") == "fine" else "coarse")
    facts = _json(solid_facts(sizing, built))
    facts += b" " * (-len(facts) % 4)
    return Answer(len(facts).to_bytes(4, "little") + facts + glb(built), "application/octet-stream")


def _review(question: Question) -> Answer:
    from gearwright.render.answers.plain import plain
    from gearwright.render.answers.review import review_answer
    from gearwright.render.words.headline import headline
    from gearwright.reviews import review_of
    from gearwright.spec import placed

    sizing = _sized(question)
    try:
        review = review_of(sizing)
    except DesignError as error:
        raise DesignError(placed(error.problems, question.text)) from None
    return Answer(_json({"headline": headline(review), "result": plain(review_answer(review))}))


def _influences(question: Question) -> Answer:
    from gearwright.render.answers.insight import factors_answer, influences_answer
    from gearwright.render.answers.plain import plain

    sizing = _sized(question)
    told = {"factors": factors_answer(sizing), "influences": influences_answer(sizing, 1.0)}
    return Answer(_json(plain(told)))


def _meaning(_: Question) -> Answer:
    """Return what every number of a sizing means: words, unit, equation and source, as its schema has them."""
    from gearwright.render.answers.described import described
    from gearwright.render.answers.design import SizeAnswer

    definitions: dict[str, Any] = {}
    described(SizeAnswer, definitions)
    return Answer(_json(definitions))


def _export(question: Question) -> Answer:
    from gearwright.formats import AS_USUAL, FORMATS

    wanted = question.options.get("format")
    name = wanted if isinstance(wanted, str) else ""
    by_name(name, FORMATS, "format")
    return Answer(FORMATS[name](_sized(question), AS_USUAL)[0], "application/octet-stream")


def _report(question: Question) -> Answer:
    from gearwright.render.pages.report import report

    return Answer(report(_sized(question)).encode(), "application/octet-stream")


VERBS: Mapping[str, Callable[[Question], Answer]] = {
    "edit": _edit,
    "export": _export,
    "flow": _flow,
    "form": _form,
    "influences": _influences,
    "meaning": _meaning,
    "model": _model,
    "report": _report,
    "review": _review,
    "size": _size,
}
"""Name in the address -> what answers."""
SLOW = frozenset({"export", "influences", "report", "review"})
"""Verbs that take seconds: they have a process of their own."""
ENDED = frozenset({"export", "report", "review"})
"""Those of them that a newer question ends; the others come to their end."""
