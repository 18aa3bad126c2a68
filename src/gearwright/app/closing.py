"""What the page asks of closure: a design whose free sizes meet every check, or what none of them meets."""

from __future__ import annotations

import re
from pathlib import Path

from gearwright.app.asked import Answer, Progress, Question, Tell, as_json
from gearwright.app.edits import with_entry
from gearwright.app.form import form
from gearwright.errors import DesignError, Problem

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
    from gearwright.closure import Outcome, Wishes, nearest_variant
    from gearwright.closure import close as closed_by
    from gearwright.closure.wishes import HOUR
    from gearwright.render.answers.closure import close_answer
    from gearwright.render.answers.plain import plain
    from gearwright.render.tables.checks import check_sentence
    from gearwright.spec import parse

    hours, wide, anew = question.options.get("life_h"), _told(question, "variants"), _told(question, "anew")
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


def _told(question: Question, name: str) -> bool:
    value = question.options.get(name, False)
    if not isinstance(value, bool):
        raise DesignError([Problem(name, "true or false is needed")])
    return value
