"""Options that do nothing as they are given, or are no finite number: refused, never passed over in silence.

An option that only means something with another one, or nothing beside another one, stands here by the names of the
command's parameters. One with its default is not seen as given: it changes nothing anyway.
"""

import inspect
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Any, get_args, get_type_hints

from gearwright.errors import Problem, refuse

Others = tuple[str, ...]
_POINT = ("diameter_m", "tas_m_s", "altitude_m", "power_kw", "blade_angle_deg", "incidence_deg")
_SLAM = ("slam_mach", "slam_s", "acceleration")
_TRANSIENT = ("inertia_kg_m2", "slam_altitude_m", "isa_offset_k")
_STUDY = (
    "changes", "journal", "shard", "workers", "cluster", "csv", "export", "figure", "report", "json", "jsonl",
)  # fmt: skip
NEEDS: Mapping[str, Mapping[str, Others]] = MappingProxyType({
    "new": {"file": ("name",), "force": ("name",)},
    "review": {"date": ("report", "pdf")},
    "draw": {"date": ("report",)},
    "validate": {"date": ("report",)},
    "sharing": {"percent": ("target",)},
    "fly": {"date": ("report",), **dict.fromkeys(("life_h", "report", "csv", "json", "jsonl"), ("design",))},
    "window": {"date": ("report",),
               **dict.fromkeys(("stiffness", "output", "figure", "report", "json", "jsonl"), ("name",))},
    "propeller": dict.fromkeys(_POINT, ("rpm",)),
    "rotor": {"tail_induced_factor": ("tail_diameter_m",)},
    "turboshaft": {**dict.fromkeys(_SLAM, ("slam_kw",)), **dict.fromkeys(_TRANSIENT, ("slam_kw", "starter_nm")),
                   **dict.fromkeys(("n2_gain", "n2_integral", "n2_limit"), ("rotor_inertia_kg_m2",)),
                   **dict.fromkeys(("starter_cut", "hottest_k"), ("starter_nm",))},
    "study": {**dict.fromkeys(_STUDY, ("name",)), "tls": ("cluster",)},
    "resume": {"tls": ("cluster",)},
    "optimise": {"anyway": ("journal",)},
    "cluster": {"study": ("slurm",)},
})  # fmt: skip
"""Command -> parameter -> those of which one must be given, too."""
BESIDE: Mapping[str, Mapping[str, Others]] = MappingProxyType({
    "new": {"json": ("name",)},
    "run": {"full": ("json",)},
    "close": {"rounds": ("json",)},
    "schema": {"of": ("answer",)},
    "propeller": dict.fromkeys(("activity_factor", "design_lift"), ("file",)),
    "status": {"json": ("verify",)},
    "cluster": dict.fromkeys(("host", "processes", "tls"), ("slurm",)),
    "thesis": dict.fromkeys(("out", "errata"), ("chapter_4",)),
})  # fmt: skip
"""Command -> parameter -> those beside which it does nothing."""


def refuse_idle(command: Callable[..., None], values: Mapping[str, Any]) -> None:
    """Refuse what is given to a command and would do nothing, or is no finite number; all of it at once.

    Args:
        command: As it is registered.
        values: Of its parameters, by name.
    """
    defaults = {name: entry.default for name, entry in inspect.signature(command).parameters.items()}
    given = {name for name, value in values.items() if value != defaults[name] and value not in (None, ())}
    refuse([*_idle(command, given), *_not_finite(command, {name: values[name] for name in sorted(given)})])


def _idle(command: Callable[..., None], given: set[str]) -> Iterator[Problem]:
    """Yield what is given in vain."""
    needs = NEEDS.get(command.__name__, {})
    beside = {"json": ("jsonl",), **BESIDE.get(command.__name__, {})}
    for name, others in needs.items():
        if name in given and not given.intersection(others):
            asked = " or ".join(_written(command, others))
            yield Problem(
                _written(command, [name])[0], f"does nothing without {asked}; give that, too, or leave it out"
            )
    for name, others in beside.items():
        if name in given and (stronger := [other for other in others if other in given]):
            asked = " and ".join(_written(command, stronger))
            yield Problem(_written(command, [name])[0], f"does nothing beside {asked}; leave one of them out")


def _not_finite(command: Callable[..., None], given: Mapping[str, Any]) -> Iterator[Problem]:
    """Yield the numbers that are infinite, or not a number."""
    for name, value in given.items():
        if isinstance(value, float) and not math.isfinite(value):
            yield Problem(_written(command, [name])[0], f"{value}; give a finite number")


def _written(command: Callable[..., None], names: Sequence[str]) -> list[str]:
    """Return parameters as users write them: ``--date``, ``BLADES``."""
    hints = get_type_hints(command, include_extras=True)
    return [_as_given(name, get_args(hints[name])[1]) for name in names]


def _as_given(name: str, mark: Any) -> str:
    declared: Sequence[str] = getattr(mark, "param_decls", None) or ()
    if type(mark).__name__ == "ArgumentInfo":
        return str(mark.metavar or name).strip("[]").upper()
    return next(iter(declared), f"--{name.replace('_', '-')}")
