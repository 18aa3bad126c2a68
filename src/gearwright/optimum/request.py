"""A study that looks for the best of one design, for who has no study file: freedoms, objectives, bounds in short."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from gearwright.spec import Design, Study
from gearwright.spec.edit import standing_at
from gearwright.spec.studies import Axis, Bound, Search

OBJECTIVES = {"total_mass": "minimum", "loss": "minimum"}
"""What is wanted where nothing is said."""
CONSTRAINTS = {"worst_margin": {"minimum": 1.0}}
"""What every design keeps: the worst margin of its sizing."""
PLANETS = (3, 4, 5, 6)
SPEEDS = (0.8, 1.25)
"""Of a motor's speed, from and to [-]."""
WIDTHS = (6.0, 16.0)
"""Face width over module, from and to [-]."""


def study_for(
    name: str, design: Design, *, axes: Mapping[str, Axis] | None = None, objectives: Mapping[str, str] | None = None,
    constraints: Mapping[str, Bound] | None = None, search: Search | None = None,
) -> Study:  # fmt: skip
    """Return the study that looks for the best of a design.

    Args:
        name: Of the design, as it is found.
        design: What may be changed.
        axes: Path -> range or list; left out: speeds of motors, numbers of planets, face width over module.
        objectives: Result -> ``minimum`` or ``maximum``; left out: mass with motors, and lost power.
        constraints: Result -> bounds, beside the margin of the sizing.
        search: How far it goes.
    """
    free = dict(axes) if axes else {path: Axis.model_validate(axis) for path, axis in _freedoms(design)}
    kept = {key: Bound.model_validate(bound) for key, bound in CONSTRAINTS.items()}
    return Study.model_validate({
        "name": f"The best of {design.name}", "designs": [name], "axes": free,
        "results": list(objectives or OBJECTIVES), "objectives": dict(objectives or OBJECTIVES),
        "constraints": {**kept, **(constraints or {})}, "search": search or Search(),
    })  # fmt: skip


def _freedoms(design: Design) -> Iterable[tuple[str, dict[str, object]]]:
    """Yield what most designs leave free."""
    for name in design.motors:
        speed = standing_at(design, path := f"motors.{name}.speed_rpm").value
        if isinstance(speed, float):
            yield path, {"from": round(SPEEDS[0] * speed), "to": round(SPEEDS[1] * speed)}
    for name, stage in design.planetaries.items():
        if stage.sun_teeth is None and stage.planet_teeth is None:
            yield f"planetaries.{name}.planets", {"values": list(PLANETS)}
    if design.planetaries or design.pairs:
        yield "gears.face_width_ratio", {"from": WIDTHS[0], "to": WIDTHS[1]}
