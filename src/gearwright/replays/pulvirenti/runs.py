"""The runs that the claims of Pulvirenti (2023) need: shipped designs sized, shipped studies with either motor law."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache

from gearwright.shipped import shipped_design, shipped_study
from gearwright.sizing import Sizing, size
from gearwright.spec import Study, read, read_study
from gearwright.study.running import run
from gearwright.study.tables import Row

THESIS, NDARC = "thesis", "ndarc"
"""Laws of the motor's mass: the thesis's own, and the one that gearwright takes by default."""
_HYBRIDS = {"off-set-h1": "h1", "off-set-h2": "h2"}
"""Design of the study -> hybrid."""
_LAW, _SPEED = "motors.electric.mass_law", "motors.electric.speed_rpm"


@dataclass(frozen=True)
class Computed:
    """What was computed for one claim."""

    value: float
    """As the claim counts, in the unit that is shown."""
    other: float | None = None
    """By the second way to count, in the same unit."""
    numbers: Mapping[str, float] = field(default_factory=dict)
    """What the reason quotes."""


def by_laws(measure: Callable[[str], float], numbers: Mapping[str, float]) -> Computed:
    """Return a number with the thesis's motor and beside it with NDARC's.

    Args:
        measure: Gives the number for a motor law.
        numbers: What the reason quotes.
    """
    return Computed(measure(THESIS), measure(NDARC), numbers)


@dataclass(frozen=True)
class Masses:
    """What a hybrid weighs."""

    gearbox: float
    """Gears, shafts, carriers [kg]."""
    total: float
    """With the motor [kg]."""

    @property
    def motor(self) -> float:
        """[kg]"""
        return self.total - self.gearbox


@cache
def sized(name: str) -> Sizing:
    """Return a shipped design, sized.

    Args:
        name: Of the design.
    """
    return size(read(shipped_design(name)))


@cache
def in_line_h2(law: str) -> Mapping[int, Masses]:
    """Return motor speed [rpm] -> masses of In-Line H2.

    Args:
        law: Of the motor's mass.
    """
    rows = _rows("power-density")
    return {_speed(row): _masses(row) for row in rows if row.inputs[_LAW] == law}


@cache
def off_set(law: str) -> Mapping[tuple[str, int], Masses]:
    """Return hybrid (``h1``, ``h2``) and motor speed [rpm] -> masses of Off-Set.

    Args:
        law: Of the motor's mass.
    """
    return {(_HYBRIDS[row.design], _speed(row)): _masses(row) for row in _rows("off-set-hybrids", law)}


@cache
def hybrids(law: str) -> Mapping[str, Masses]:
    """Return design -> masses of every hybrid among the ten architectures, as shipped.

    Args:
        law: Of the motor's mass.
    """
    study = read_study(shipped_study("architectures"))
    names = [name for name in study.designs if read(shipped_design(name)).motors]
    varied = study.model_copy(update={"designs": names, "results": ["mass", "total_mass"]})
    return {row.design: _masses(row) for row in _run(varied, law)}


@cache
def _rows(name: str, law: str = "") -> tuple[Row, ...]:
    return _run(read_study(shipped_study(name)), law)


def _run(study: Study, law: str) -> tuple[Row, ...]:
    changes = {**study.changes, _LAW: law} if law else study.changes
    designs = {name: read(shipped_design(name)) for name in study.designs}
    return run(study.model_copy(update={"changes": changes}), designs).rows


def _speed(row: Row) -> int:
    return round(float(row.inputs[_SPEED]))


def _masses(row: Row) -> Masses:
    return Masses(row.number("mass"), row.number("total_mass"))
