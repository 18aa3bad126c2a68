"""Answers about masses, the catalogue of engines, published numbers, and what comes with gearwright."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from gearwright.base import Mass, Number, Power, Speed
from gearwright.render.words.design_file import ShippedFile
from gearwright.validate import Checked
from gearwright.weights import COLUMNS, Band, CheckedEngine, Comparison, Coverage, StatedMass, gearbox_mass


@dataclass(frozen=True)
class RequirementAnswer:
    """From which every statistical method starts."""

    power: Power
    engine_speed: Speed
    propeller_speed: Speed
    beta: Number
    """Weight parameter β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15."""


@dataclass(frozen=True)
class MethodMass:
    """What a published method says."""

    key: str
    name: str
    mass: Mass | None
    """Null outside the range of the method."""
    reason: str
    """Why there is no mass."""
    beyond_range: Mass | None
    """Bare formula outside its range, for the reader only."""
    formula: str
    source: str
    assumes: str
    includes: Coverage


@dataclass(frozen=True)
class MassAnswer:
    """What a gearbox weighs by every public method."""

    requirement: RequirementAnswer
    methods: tuple[MethodMass, ...]
    bands: tuple[Band, ...]
    """Prediction bands of the refit of real weights; empty outside its range."""
    nearest_engines: tuple[str, ...]
    bottom_up: StatedMass | None
    """Sum of the parts of a design, where one is given."""
    stated: StatedMass | None
    """The user's own mass."""
    taken: StatedMass | None
    """The mass to go on with."""


def mass_answer(comparison: Comparison) -> MassAnswer:
    """Return what `gearwright mass --json` answers.

    Args:
        comparison: Of `compare`.
    """
    need = comparison.requirement
    return MassAnswer(
        RequirementAnswer(need.power, need.engine_speed, need.propeller_speed, need.beta),
        tuple(
            MethodMass(
                key=estimate.method.key,
                name=estimate.method.name,
                mass=estimate.mass,
                reason=estimate.reason,
                beyond_range=estimate.beyond,
                formula=estimate.method.formula,
                source=estimate.method.source,
                assumes=estimate.method.assumes,
                includes=estimate.method.includes,
            )
            for estimate in comparison.estimates
        ),
        comparison.bands,
        tuple(f"{engine.series.name} {engine.model}" for engine in comparison.engines),
        comparison.bottom_up,
        comparison.stated,
        comparison.taken,
    )


@dataclass(frozen=True)
class PrintedNumber:
    """One printed number of an engine beside the computed one, in the unit of its column."""

    printed: str | None
    computed: float | None
    verdict: str
    reason: str


@dataclass(frozen=True)
class EngineRow:
    """One engine of the catalogue; a line of `--jsonl`."""

    table: str
    series: str
    manufacturer: str
    kind: str
    model: str
    power: Power
    engine_speed: Speed
    engine_speed_rule: str
    """Where the engine's speed comes from."""
    propeller_speed: Speed
    gearbox_mass: Mass
    """By NASA'15."""
    engine_mass_minimum: Mass | None
    """That reproduces the printed row; null where none does."""
    engine_mass_maximum: Mass | None
    columns: Mapping[str, PrintedNumber]
    """Column of the printed tables, with its unit -> number."""


@dataclass(frozen=True)
class EnginesAnswer:
    """Engines of the catalogue."""

    rows: tuple[EngineRow, ...]


def engines_answer(rows: Iterable[CheckedEngine]) -> EnginesAnswer:
    """Return what `gearwright engines --json` answers.

    Args:
        rows: Checked rows of the catalogue.
    """
    return EnginesAnswer(tuple(_engine(row) for row in rows))


def _engine(checked: CheckedEngine) -> EngineRow:
    engine = checked.engine
    minimum, maximum = checked.engine_mass or (None, None)
    return EngineRow(
        table=engine.series.table,
        series=engine.series.name,
        manufacturer=engine.series.manufacturer,
        kind=engine.series.kind,
        model=engine.model,
        power=engine.power,
        engine_speed=engine.engine_speed,
        engine_speed_rule=engine.series.reason,
        propeller_speed=engine.propeller_speed,
        gearbox_mass=gearbox_mass(engine),
        engine_mass_minimum=minimum,
        engine_mass_maximum=maximum,
        columns={column: _printed(checked, column) for column in COLUMNS},
    )


def _printed(checked: CheckedEngine, column: str) -> PrintedNumber:
    check = checked.check(column)
    return PrintedNumber(
        check.printed.text if check.printed else None, check.computed, check.verdict.value, check.reason
    )


@dataclass(frozen=True)
class ValidateAnswer:
    """Published numbers beside those of gearwright."""

    missed: int
    """Numbers that are not within their tolerance; then the exit code is 1."""
    rows: tuple[Checked, ...]


@dataclass(frozen=True)
class NewAnswer:
    """Designs, missions, mixes, studies and notebooks to start from."""

    shipped: tuple[ShippedFile, ...]
