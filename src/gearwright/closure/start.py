"""What a closure starts from: the design with a rating that knows fatigue, the life that is asked, nothing chosen."""

from __future__ import annotations

from collections.abc import Mapping

from gearwright.closure.wishes import HOUR, Wishes
from gearwright.spec import Design, against_fatigue
from gearwright.spec.edit import Value


def start_of(design: Design, wishes: Wishes) -> Design:
    """Return the design as a closure begins with it.

    Stages that Lewis and Hertz rate are rated by ISO 6336, as no life can be asked of static strength; the rules that
    only those two read are left out with them.

    Args:
        design: As read.
        wishes: What is asked.

    Raises:
        DesignError: Values that the keys of the design do not allow.
    """
    return against_fatigue(design, _lives(wishes))


def _lives(wishes: Wishes) -> Mapping[str, Value]:
    if wishes.life is None:
        return {}
    hours = wishes.life / HOUR
    return {"service.life_h": hours, "service.bearing_life_h": hours}
