"""What a gearbox must meet: every mode that a review can fail, by the requirement that it belongs to."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import NamedTuple

from gearwright.checks import Check
from gearwright.identity import Kind
from gearwright.spec import Design, edited
from gearwright.spec.edit import Value


class Requirement(NamedTuple):
    """One requirement."""

    modes: tuple[str, ...]
    """How the modes of its checks begin."""
    kinds: tuple[Kind, ...]
    """Of the parts that it is about; empty: of any."""
    moved_by: str
    """What the closure changes to meet it."""
    helps: str
    """What helps where that does not do."""
    unasked: Mapping[str, Value] = MappingProxyType({})
    """Rules of a design by which nothing is asked, where the sizing itself meets it."""


_GEARS = (Kind.GEAR, Kind.MESH, Kind.STAGE)
REQUIREMENTS: Mapping[str, Requirement] = MappingProxyType({
    "flank": Requirement(
        ("pitting", "contact", "micropitting"), _GEARS, "module and face width of the stage",
        "a better steel or grade, more planets, another split of the ratio, a wider face (widest_diameters)",
    ),
    "root": Requirement(
        ("tooth root", "bending", "yielding root"), _GEARS, "module and face width of the stage",
        "a better steel or grade, more planets, profile shift, a thicker rim",
    ),
    "static strength": Requirement(("static",), _GEARS, "module and face width of the stage", "a smaller limit load"),
    "scuffing": Requirement(
        ("scuffing",), _GEARS, "module and face width of the stage",
        "smaller modules, profile shift that balances sliding, tip relief, an oil of a higher load stage, cooler oil",
    ),
    "teeth": Requirement(
        ("contact ratio", "undercut", "tip thickness", "involute interference", "tip interference", "radial assembly",
         "planets apart", "backlash", "face width", "cutter", "speed of K_V"), _GEARS,
        "tooth numbers, by the search of the sizing; the widest face that its rules allow",
        "other tooth numbers, profile shift, fewer planets, gears.iso6336.widest_diameters",
        MappingProxyType({"gears.iso6336.widest_modules": 60.0, "gears.iso6336.widest_diameters": 3.0}),
    ),
    "rims": Requirement(("rim",), (), "nothing yet", "a thicker rim (rim_ratio, rim_thickness_ratio)"),
    "sharing": Requirement(
        ("load sharing",), (), "K_γ of the stage, and with it module and face width",
        "smaller errors, a floating member ([supports]), gears clocked on their shafts, fewer planets",
    ),
    "peaks": Requirement(
        ("peak",), _GEARS, "least K_V of the stage, and with it module and face width",
        "other speeds or teeth, tip relief, more damping",
    ),
    "bearings": Requirement(
        ("", "life", "bearing life", "static safety", "bearing static safety", "room around the pin", "room in the rim",
         "room for its bearing", "room beside the plate", "shaft in its bore"),
        (Kind.BEARING,), "bearings of shafts, by the sizing; what planets turn on, where the design leaves it open",
        "more or lighter planets, plain bearings, a star stage in place of the planetary one, a slower carrier",
    ),
    "room of planets": Requirement(
        ("room for its bearing", "room beside the plate", "pin in its bore"), (Kind.GEAR,), "nothing yet",
        "larger planets, smaller or fewer bearings side by side",
    ),
    "shafts": Requirement(
        ("Tresca", "fatigue", "yield", "slope", "first critical speed", "face load"), (Kind.SHAFT, Kind.MESH),
        "diameters, by the sizing", "a stronger shaft material, shorter spans",
        MappingProxyType({"shafting.safety": 1.0}),
    ),
    "carriers": Requirement(
        ("", "pin", "plate"), (Kind.CARRIER,), "pins and plates, by the sizing",
        "fewer or narrower planets, a stronger carrier material",
    ),
    "joints": Requirement((), (Kind.JOINT,), "sizes of keys, splines and fits, by the sizing", "another kind of joint"),
    "critical speeds": Requirement(
        ("resonance of", "resonances", "main resonance"), (), "tooth numbers and modules",
        "other speeds, another split of the ratio, stiffer or softer shafts; a waiver where the peak passes",
    ),
    "room": Requirement(
        ("room", "keep-out", "axes of"), (), "places of axes, by the sizing",
        "other sides or distances of shafts ([layout])",
    ),
    "making": Requirement(
        ("assembly", "axial retention", "access", "running clearance", "wheel that grinds", "order along",
         "bridges between planets", "webs of bosses", "ring seat", "plate through its ring", "seal"), (), "nothing",
        "other places of gears and bearings, thinner shafts, more room",
    ),
    "life in flight": Requirement(
        ("pitting life", "bending life"), _GEARS, "module and face width of the stage", "a lighter duty, a better steel"
    ),
    "machines": Requirement((), (Kind.MACHINE, Kind.BATTERY), "nothing", "other machines, speeds or cases"),
    "others": Requirement((), (), "nothing", "see the check"),
})  # fmt: skip
"""Name of a requirement -> what it is about; a check belongs to the first of the most exact mode that covers it."""
STRENGTH = ("flank", "root", "static strength", "scuffing", "life in flight")
"""Those that module and face width of a stage move."""


def requirement_of(check: Check) -> str:
    """Return the name of the requirement that a check belongs to.

    Args:
        check: Any.
    """
    best, length = "others", -1
    for name, requirement in REQUIREMENTS.items():
        if requirement.kinds and check.part.kind not in requirement.kinds:
            continue
        fitting = [len(mode) for mode in requirement.modes if check.mode.startswith(mode)]
        fitting += [0] if not requirement.modes and requirement.kinds else []
        if fitting and max(fitting) > length:
            best, length = name, max(fitting)
    return best


def wanted(checks: Iterable[Check], left_out: frozenset[str]) -> list[Check]:
    """Return the checks of the requirements that count.

    Args:
        checks: Any.
        left_out: Names of requirements that do not.
    """
    return [check for check in checks if not left_out or requirement_of(check) not in left_out]


def without(design: Design, left_out: Iterable[str]) -> Design:
    """Return a design whose rules ask nothing of what its sizing would meet by itself.

    Args:
        design: With its rules.
        left_out: Names of requirements that do not count.
    """
    changes = {path: value for name in left_out for path, value in REQUIREMENTS[name].unasked.items()}
    return edited(design, changes) if changes else design
