"""What the page asks of closure: a design whose free sizes meet every check, or what none of them meets."""

from __future__ import annotations

from pathlib import Path

from gearwright.app.asked import Answer, Progress, Question, Tell, as_json
from gearwright.errors import DesignError, Problem


def close(question: Question, tell: Tell) -> Answer:
    """Return a closed design as a text, with what it meets, and the nearest variant that closes if one is asked for.

    Args:
        question: With the text, the life [h] if another one is asked for, and whether variants are looked for.
        tell: Takes what is being done.
    """
    from gearwright.closure import Outcome, Wishes, nearest_variant
    from gearwright.closure import close as closed_by
    from gearwright.closure.wishes import HOUR
    from gearwright.render.answers.closure import close_answer
    from gearwright.render.answers.plain import plain
    from gearwright.render.tables.checks import check_sentence
    from gearwright.spec import parse

    design = parse(question.text, folder=Path(question.folder))
    hours, wide = question.options.get("life_h"), question.options.get("variants", False)
    if not isinstance(wide, bool):
        raise DesignError([Problem("variants", "true or false is needed")])
    wishes = Wishes(life=None if hours is None else question.number("life_h", 1.0, 1e7) * HOUR)
    done = [0.0]

    def say(words: str) -> None:
        done[0] += 0.1 * (1.0 - done[0])
        tell(Progress(done[0], words))

    closed = closed_by(design, wishes=wishes, tell=say)
    found = nearest_variant(design, closed, tell=say) if wide and closed.outcome is Outcome.OPEN else None
    words = f"{closed.outcome}: the worst is {check_sentence(closed.worst)}" if closed.worst else str(closed.outcome)
    return Answer(as_json({"headline": words, **plain(close_answer(closed, found))}))
