"""Find, read and size the design that a command names."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gearwright.dynamics.vibration import SpeedCase
    from gearwright.render.pages.page import Stamp
    from gearwright.reviews import Review
    from gearwright.sizing import Sizing
    from gearwright.spec import Design


def design_of(name: str, folder: Path | None = None) -> Design:
    """Return a design from a file, or a shipped one by its name.

    Args:
        name: Path or name.
        folder: Of the study that names it; left out: the path may lead anywhere.
    """
    from gearwright.shipped import find_design
    from gearwright.spec import read

    return read(find_design(name, folder))


def sized(name: str, level: str | None = None, life_h: float | None = None) -> Sizing:
    """Return the sizing of a design; what sizing finds wrong is placed at its line in the file.

    Args:
        name: Path or name of the design.
        level: At which it is sized; None: its own.
        life_h: Life that is asked of gears and bearings [h]; None: its own.

    Raises:
        DesignError: If the design cannot be read or sized.
    """
    from gearwright.sizing import size
    from gearwright.spec import at_level, edited

    design = design_of(name)
    with placed_in(name):
        design = design if level is None else at_level(design, level)
        lives = {} if life_h is None else dict.fromkeys(("service.life_h", "service.bearing_life_h"), life_h)
        return size(edited(design, lives) if lives else design)


def reviewed(sizing: Sizing, name: str, speeds: Sequence[SpeedCase] | None = None) -> Review:
    """Return the review of a sizing; a waiver of no check is placed at its line in the design's file.

    Args:
        sizing: Of the design.
        name: Path or name of the design.
        speeds: Its critical speeds, where they are known already.

    Raises:
        DesignError: If a waiver names no check.
    """
    from gearwright.reviews import review_of

    with placed_in(name):
        return review_of(sizing, speeds=speeds)


def stamped(name: str, date: str = "") -> Stamp:
    """Return what a page says of where it comes from.

    Args:
        name: Path or name of the design whose lines it shows.
        date: As the user writes it.
    """
    from gearwright.render.pages.page import Stamp
    from gearwright.shipped import find_design
    from gearwright.spec import file_text
    from gearwright.spec.lines import key_lines

    return Stamp(date, key_lines(file_text(find_design(name))))


@contextmanager
def placed_in(name: str) -> Iterator[None]:
    """Place what is found wrong at its line in the design's file.

    Args:
        name: Path or name of the design.

    Raises:
        DesignError: What was raised inside, with lines.
    """
    from gearwright.errors import DesignError
    from gearwright.shipped import find_design
    from gearwright.spec import file_text, placed

    try:
        yield
    except DesignError as error:
        raise DesignError(placed(error.problems, file_text(find_design(name))), name) from None
