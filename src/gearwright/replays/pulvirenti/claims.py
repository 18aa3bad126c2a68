"""Errata and claims of Pulvirenti (2023) on mass, torque and force, with the computed values."""

import math
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from types import MappingProxyType
from typing import Any

from gearwright.base import Role, Row, gear_part, mesh_part
from gearwright.catalogue import engines
from gearwright.replays.replay import Verdict
from gearwright.shipped import shipped_design, shipped_study
from gearwright.sizing import Sizing, size
from gearwright.spec import RATED, Study, read, read_study
from gearwright.study import Row as StudyRow, run

# ----------------------------------------------------------------------------------------------------------------------
# The runs that the claims of Pulvirenti (2023) need: shipped designs sized, shipped studies with either motor law.
# ----------------------------------------------------------------------------------------------------------------------


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
    return {_speed(row): _masses(row) for row in _study_rows("power-density") if row.inputs[_LAW] == law}


@cache
def off_set(law: str) -> Mapping[tuple[str, int], Masses]:
    """Return hybrid (``h1``, ``h2``) and motor speed [rpm] -> masses of Off-Set.

    Args:
        law: Of the motor's mass.
    """
    return {(_HYBRIDS[row.design], _speed(row)): _masses(row) for row in _study_rows("off-set-hybrids", law)}


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
def _study_rows(name: str, law: str = "") -> tuple[StudyRow, ...]:
    return _run(read_study(shipped_study(name)), law)


def _run(study: Study, law: str) -> tuple[StudyRow, ...]:
    changes = {**study.changes, _LAW: law} if law else study.changes
    designs = {name: read(shipped_design(name)) for name in study.designs}
    return run(study.model_copy(update={"changes": changes}), designs).rows


def _speed(row: StudyRow) -> int:
    return round(float(row.inputs[_SPEED]))


def _masses(row: StudyRow) -> Masses:
    return Masses(row.number("mass"), row.number("total_mass"))


# ----------------------------------------------------------------------------------------------------------------------
# What Pulvirenti (2023) prints wrong, and what it claims: data, with the evidence and the place of the right formula.
#
# The errata say which equation, why it is wrong, and which function of gearwright has the right one. The claims are the
# printed side only; `gearwright.replays.pulvirenti.claims` computes the other.
# ----------------------------------------------------------------------------------------------------------------------


SOURCE = "Pulvirenti 2023"
STANDINGS = ("wrong", "incomplete", "approximate", "text", "right")
"""``text``: words, not a formula; ``right``: doubted, and found right."""
EVIDENCE = ("provable", "public source", "general knowledge", "scan")
"""``provable``: by dimension, balance or geometry; ``scan``: the misprint may be that of the scanned text."""


@dataclass(frozen=True)
class Erratum:
    """One passage that cannot be used as it is printed, or that was doubted and holds."""

    equation: str
    """Number of the equation, or page."""
    standing: str
    """One of `STANDINGS`."""
    printed: str
    """What stands there, shortened."""
    correct: str
    """What is right."""
    why: str
    evidence: tuple[str, ...]
    """Some of `EVIDENCE`."""
    used: tuple[str, ...]
    """Functions below ``gearwright`` that have the right one; empty where nothing rests on it."""
    proof: tuple[str, ...]
    """Tests below ``tests/verification`` that show it; empty where the reason is plain or rests on a source."""


@dataclass(frozen=True)
class PrintedClaim:
    """What the thesis says of its gearboxes, and what its wording covers."""

    key: str
    place: str
    """Section or figure."""
    printed: str
    """The claim, in other words."""
    counts: str
    """What number it is about."""
    other: str
    """Second way to count, where the claim hangs on it; else empty."""
    dimension: str
    """Of the number, a key of the shown units."""
    low: float
    """Least value that the wording covers, in the unit that is shown."""
    high: float
    """Greatest value that the wording covers, in the unit that is shown."""
    why: str
    """Reason of the outcome; numbers in braces are filled in from the computation."""

    def covers(self, value: float) -> bool:
        """Tell whether the wording covers a number.

        Args:
            value: In the unit that is shown.
        """
        return self.low <= value <= self.high


@cache
def errata() -> tuple[Erratum, ...]:
    """Return the errata in the order of the equations."""
    return tuple(
        Erratum(
            **{key: row[key] for key in ("equation", "standing", "printed", "correct", "why")},
            evidence=tuple(row["evidence"]),
            used=tuple(row["used"]),
            proof=tuple(row["proof"]),
        )
        for row in _rows("errata")
    )


@cache
def printed_claims() -> tuple[PrintedClaim, ...]:
    """Return what the thesis claims, in the order of its chapters."""
    return tuple(PrintedClaim(**{"other": "", "high": math.inf, **row}) for row in _rows("claims"))


def _rows(name: str) -> list[dict[str, Any]]:
    text = files("gearwright.replays.pulvirenti").joinpath(f"data/{name}.toml").read_text(encoding="utf-8")
    rows: list[dict[str, Any]] = tomllib.loads(text)[name]
    return rows


# ----------------------------------------------------------------------------------------------------------------------
# The numbers behind the thesis's claims on mass, one function for each, in the units that are shown.
# ----------------------------------------------------------------------------------------------------------------------


SLOW, BEST, MIDDLE, FAST = 3500, 4100, 4500, 5500
"""Motor speeds of In-Line H2 that the claims are about [rpm]."""
_SLOW_PAIR = (("h2", 10000), ("h2", 5000))
_FAST_PAIR = (("h1", 20000), ("h1", 10000))
"""The four points of figure 2.30: Off-Set hybrid and motor speed [rpm]."""


def _percent(new: float, old: float) -> float:
    return 100.0 * (new / old - 1.0)


def _in_line_lightest() -> Computed:
    kg = {name.replace("-", "_"): sized(name).mass for name in ("in-line", "mixed", "off-set")}
    return Computed(min(kg["mixed"], kg["off_set"]) / kg["in_line"], numbers=kg)


def _h3_heaviest() -> Computed:
    kg = {name: sized(f"off-set-{name}").mass for name in ("h1", "h2", "h3")}
    return Computed(kg["h3"] / max(kg["h1"], kg["h2"]), numbers=kg)


def _conventional_density() -> Computed:
    sizing = sized("off-set")
    return Computed(sizing.power_density / 1e3, numbers={"mass": sizing.mass})


def _hybrid_density() -> Computed:
    sizing = sized("in-line-h2")
    power = sizing.power_density * sizing.mass / 1e3
    mass = {law: in_line_h2(law)[MIDDLE] for law in (THESIS, NDARC)}
    return by_laws(
        lambda law: power / mass[law].total,
        {
            "gearbox": sizing.mass,
            "needed": power / 18.0 - sizing.mass,
            "thesis": mass[THESIS].motor,
            "ndarc": mass[NDARC].motor,
        },
    )


def _in_line_h2_best() -> Computed:
    def ratio(law: str) -> float:
        of = hybrids(law)
        return min(kg.total for name, kg in of.items() if name != "in-line-h2") / of["in-line-h2"].total

    by_thesis, by_ndarc = hybrids(THESIS), hybrids(NDARC)
    return by_laws(
        ratio,
        {
            "h1": by_thesis["in-line-h1"].total,
            "h2": by_thesis["in-line-h2"].total,
            "h1_ndarc": by_ndarc["in-line-h1"].total,
            "h2_ndarc": by_ndarc["in-line-h2"].total,
            "quick": by_ndarc["in-line-h1"].motor,
            "slow": by_ndarc["in-line-h2"].motor,
        },
    )


def _optimum_speed() -> Computed:
    def best(law: str) -> int:
        of = in_line_h2(law)
        return min(of, key=lambda speed: of[speed].total)

    by_thesis, by_ndarc = in_line_h2(THESIS), in_line_h2(NDARC)
    flat = [speed for speed, kg in by_thesis.items() if kg.total <= 1.03 * by_thesis[best(THESIS)].total]
    gain = by_ndarc[SLOW].motor - by_ndarc[FAST].motor
    return by_laws(best, {"flat_from": min(flat), "flat_to": max(flat), "motor_gain": gain})


def _in_line_heavier(new: int, old: int = MIDDLE) -> Computed:
    gearbox = in_line_h2(THESIS)
    return by_laws(
        lambda law: _percent(in_line_h2(law)[new].total, in_line_h2(law)[old].total),
        {"gearbox": _percent(gearbox[new].gearbox, gearbox[old].gearbox)},
    )


def _optimum_gain() -> Computed:
    """Return by how much density falls from 4100 to 4500 rpm; the power is one, so masses suffice."""
    gearbox = in_line_h2(THESIS)
    return by_laws(
        lambda law: -_percent(in_line_h2(law)[BEST].total, in_line_h2(law)[MIDDLE].total),
        {"gearbox": -_percent(gearbox[BEST].gearbox, gearbox[MIDDLE].gearbox)},
    )


def _motor_flat() -> Computed:
    return by_laws(
        lambda law: in_line_h2(law)[FAST].motor / in_line_h2(law)[SLOW].motor, {"torque": 100.0 * SLOW / FAST}
    )


def _motor_share() -> Computed:
    kg = {law: in_line_h2(law)[MIDDLE] for law in (THESIS, NDARC)}
    return by_laws(
        lambda law: 100.0 * kg[law].motor / kg[law].total, {"thesis": kg[THESIS].motor, "ndarc": kg[NDARC].motor}
    )


def _h2_slow_heavier() -> Computed:
    slow, fast = (off_set(THESIS)["h2", speed].gearbox for speed in (5000, 10000))
    return by_laws(
        lambda law: _percent(off_set(law)["h2", 5000].total, off_set(law)["h2", 10000].total),
        {"gearbox": _percent(slow, fast), "slow": slow, "fast": fast},
    )


def _off_set_slow_heavier() -> Computed:
    of = off_set(THESIS)
    gearbox = _percent(sum(of[point].gearbox for point in _SLOW_PAIR), sum(of[point].gearbox for point in _FAST_PAIR))

    def heavier(law: str) -> float:
        slow, fast = (sum(off_set(law)[point].total for point in pair) for pair in (_SLOW_PAIR, _FAST_PAIR))
        return _percent(slow, fast)

    return by_laws(heavier, {"gearbox": gearbox})


def _off_set_faster() -> Computed:
    def h1(law: str) -> float:
        return off_set(law)["h1", 20000].total / off_set(law)["h1", 10000].total

    def h2(law: str) -> float:
        return off_set(law)["h2", 10000].total / off_set(law)["h2", 5000].total

    heaviest = off_set(THESIS)["h2", 20000].gearbox
    return by_laws(lambda law: max(h1(law), h2(law)), {"h1": h1(THESIS), "h2": h2(THESIS), "h2_fast": heaviest})


def _h1_best() -> Computed:
    def ratio(law: str) -> float:
        best, *others = (off_set(law)[point].total for point in (*_FAST_PAIR, *_SLOW_PAIR))
        return min(others) / best

    of = off_set(THESIS)
    return by_laws(ratio, {"h1": of["h1", 20000].total, "h2": of["h2", 5000].total})


def _pt6t_densest() -> Computed:
    def printed(column: str) -> dict[tuple[str, str], float]:
        digits_by_engine = {
            (engine.series.name, engine.model): engine.as_meant(column) for engine in engines() if engine.has_gearbox
        }
        return {key: digits.value for key, digits in digits_by_engine.items() if digits is not None}

    density, torque = printed("gearbox_kw_kg"), printed("torque_nm_kg")
    pt6t = {key for key in density if key[0].startswith("PT6T")}
    best, mine = (max(value for key, value in density.items() if (key in pt6t) is mine) for mine in (False, True))
    lowest = {"torque": min(torque[key] for key in pt6t), "lowest": min(torque.values())}
    return Computed(mine / best, numbers={"density": best, "own": mine, **lowest})


MASS_CLAIMS: Mapping[str, Callable[[], Computed]] = MappingProxyType({
    "in-line-lightest": _in_line_lightest,
    "off-set-h3-heaviest": _h3_heaviest,
    "conventional-density": _conventional_density,
    "hybrid-density": _hybrid_density,
    "in-line-h2-best": _in_line_h2_best,
    "optimum-speed": _optimum_speed,
    "fast-heavier": lambda: _in_line_heavier(FAST),
    "slow-heavier": lambda: _in_line_heavier(SLOW),
    "optimum-gain": _optimum_gain,
    "motor-mass-flat": _motor_flat,
    "motor-share": _motor_share,
    "off-set-h2-slow-heavier": _h2_slow_heavier,
    "off-set-slow-heavier": _off_set_slow_heavier,
    "off-set-faster-lighter": _off_set_faster,
    "off-set-h1-best": _h1_best,
    "pt6t-densest": _pt6t_densest,
})  # fmt: skip
"""Key of a claim -> what computes it."""


# ----------------------------------------------------------------------------------------------------------------------
# The numbers behind the thesis's claims on torques and forces of In-Line H2, from the power flow of its cases.
# ----------------------------------------------------------------------------------------------------------------------


CRUISE = "cruise"
_DESIGN = "in-line-h2"
_PRINTED_RATIO = 2.5
"""Force of a mesh of stage two over one of stage one, as the thesis says for cruise and take-off."""


@dataclass(frozen=True)
class _Torques:
    """In-Line H2 in one case [N m]."""

    turbine: float
    motor: float
    carrier: float
    """On the shaft from the first carrier to the second sun."""
    propeller: float


def _torques(case: str) -> _Torques:
    flow = sized(_DESIGN).flows[case]
    turbine, motor, propeller = (abs(flow.machine_torques[name]) for name in ("gas-turbine", "electric", "propeller"))
    return _Torques(turbine, motor, turbine * _stage_ratio("first") + motor, propeller)


def _stage_ratio(stage: str) -> float:
    sun, ring = (sized(_DESIGN).teeth[str(gear_part(stage, role))] for role in (Role.SUN, Role.RING))
    return 1.0 + ring / sun


def _motor_over_turbine() -> Computed:
    cruise, rated = _torques(CRUISE), _torques(RATED)
    return Computed(cruise.motor / cruise.turbine, numbers={"rated": rated.motor / rated.turbine})


def _carrier_over_turbine() -> Computed:
    cruise = _torques(CRUISE)
    return Computed(cruise.carrier / cruise.turbine, numbers={"tau": _stage_ratio("first")})


def _carrier_over_motor() -> Computed:
    cruise = _torques(CRUISE)
    return Computed(cruise.carrier / cruise.motor)


def _propeller_over_turbine() -> Computed:
    cruise = _torques(CRUISE)
    return Computed(cruise.propeller / cruise.turbine, numbers={"tau": _stage_ratio("second")})


def _force(stage: str, case: str) -> float:
    """Return the tangential force of one sun-planet mesh [N]."""
    sizing = sized(_DESIGN)
    row = next(mesh for mesh in sizing.train.meshes if mesh.part == mesh_part(stage, Row.SUN_PLANET))
    module = next(gear.module for gear in sizing.gears if gear.part == gear_part(stage, Role.SUN))
    return 2.0 * abs(sizing.flows[case].meshes[row.name].multiplier) / (module * row.count)


def _mesh_forces() -> Computed:
    """Return the ratio of forces, and the motor's share of the power that would give the printed one.

    The ratio is (1 + p) times what the turbine alone gives, p the motor's power over the turbine's. A torque τ times as
    large asks for a radius ∛τ times as large, so that the force grows with τ^(2/3).
    """
    cruise, rated = (_force("second", case) / _force("first", case) for case in (CRUISE, RATED))
    sun = {gear.name: gear.pitch_diameter for gear in sized(_DESIGN).gears}
    powers = sized(_DESIGN).flows[CRUISE].machine_powers
    turbine_alone = cruise / (1.0 + powers["electric"] / powers["gas-turbine"])
    numbers = {
        "radii": sun["second.sun"] / sun["first.sun"],
        "cruise": cruise,
        "rated": rated,
        "share": 100.0 * (1.0 - turbine_alone / _PRINTED_RATIO),
        "printed": cruise * _stage_ratio("second") ** (2.0 / 3.0),
    }
    return Computed(cruise, rated, numbers)


TORQUE_CLAIMS: Mapping[str, Callable[[], Computed]] = MappingProxyType({
    "torque-motor-turbine": _motor_over_turbine,
    "torque-carrier-turbine": _carrier_over_turbine,
    "torque-carrier-motor": _carrier_over_motor,
    "torque-propeller-turbine": _propeller_over_turbine,
    "mesh-force-ratio": _mesh_forces,
})  # fmt: skip
"""Key of a claim -> what computes it."""


# ----------------------------------------------------------------------------------------------------------------------
# The claims of Pulvirenti (2023) held against what gearwright computes: printed, computed, verdict, reason.
#
# Every number comes from the shipped designs and studies. Where a claim hangs on how one counts (the motor's mass law,
# the phase of flight) both ways are computed, and the verdict is that of the numbers.
# ----------------------------------------------------------------------------------------------------------------------


_NUMBERS = {**MASS_CLAIMS, **TORQUE_CLAIMS}


@dataclass(frozen=True)
class Claim:
    """A printed claim and what the equations give."""

    printed: PrintedClaim
    value: float
    """As the claim counts, in the unit in which its dimension is shown."""
    other: float | None
    """By the second way to count; None where there is none."""
    why: str
    """Reason, with numbers."""

    @property
    def verdict(self) -> Verdict:
        """`HOLDS` if the wording covers the number by every way of counting, `CONDITION` if only by one."""
        ways = [self.printed.covers(value) for value in (self.value, self.other) if value is not None]
        if all(ways):
            return Verdict.HOLDS
        return Verdict.CONDITION if any(ways) else Verdict.FAILS


def claims() -> tuple[Claim, ...]:
    """Return every claim with its numbers; takes some two hundred sizings, about a second."""
    return tuple(_claim(printed, _NUMBERS[printed.key]()) for printed in printed_claims())


def _claim(printed: PrintedClaim, computed: Computed) -> Claim:
    return Claim(printed, computed.value, computed.other, printed.why.format(**computed.numbers))
