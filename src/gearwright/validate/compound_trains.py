"""Published automatic transmissions, gear by gear, and a Wolfrom train: ratios, and torque ratios with losses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

from gearwright.spec import parse
from gearwright.train import build_train, power_flow, teeth_of
from gearwright.validate.automatics import FORD_6R_80, FORD_AOD, GM_8L_90, THM_440_T4, ZF_8HP_70, Automatic
from gearwright.validate.case import Case

EACH = {"sun-planet": math.sqrt(0.98), "planet-ring": math.sqrt(0.98)}
"""Efficiencies of meshes with which a set with its carrier held has 0.98 from sun to ring [-]."""
_WIKIPEDIA = "Wikipedia (read as mirrored by Wikiwand)"

WOLFROM = """\
schema = 1
name = "Wolfrom"
shafts = ["fast", "slow", "cage"]
turbines.driver = {{ shaft = "{driver}", power_kw = 1, speed_rpm = 100 }}
propellers.load = {{ shaft = "{load}", speed_rpm = 100, diameter_m = 1 }}
gears.mesh_efficiency = 0.99
[epicyclics.wolfrom]
carrier = "cage"
suns.sun = {{ shaft = "fast", teeth = 12 }}
rings.held = {{ shaft = "ground", teeth = 84 }}
rings.turned = {{ shaft = "slow", teeth = 81 }}
planets.wide = {{ teeth = 36, meshes = ["sun", "held"] }}
planets.narrow = {{ teeth = 33, meshes = ["turned"], in_one_piece_with = "wide" }}
"""
"""A stepped planet between a sun, a ring that is held and a ring that turns; the carrier is free."""


def wolfrom(driver: str, load: str) -> tuple[float, float]:
    """Return ratio of the sun to the ring that turns, and efficiency, of a Wolfrom train [-].

    Args:
        driver: Shaft that drives, fast or slow.
        load: Shaft that is driven.
    """
    design = parse(WOLFROM.format(driver=driver, load=load))
    flow = power_flow(design, build_train(design), teeth_of(design, "wolfrom"), efficiency=design.efficiencies)
    return flow.speeds["fast"] / flow.speeds["slow"], -flow.machine_powers["load"] / flow.machine_powers["driver"]


def _ratios(automatic: Automatic) -> Sequence[float]:
    return [automatic.ratio(gear) for gear in automatic.gears]


def _torque_ratios(automatic: Automatic, gears: str) -> Sequence[float]:
    return [automatic.torque_ratio(gear, EACH) for gear in gears]


def _printed(automatic: Automatic, source: str, ratios: tuple[float, ...], digit: float) -> Case:
    return Case(
        f"{automatic.name}, ratios of gears {', '.join(automatic.gears)}", source, "-", ratios,
        partial(_ratios, automatic), 0.51 * digit, "what the source rounds", is_relative=False,
    )  # fmt: skip


CASES = (
    _printed(GM_8L_90, f"{_WIKIPEDIA}, GM 8L transmission, table with assessment",
             (4.56, 2.9709, 2.0751, 1.6876, 1.27, 1.0, 0.8455, 0.6515, -3.8176), 1e-4),
    Case("GM 8L 90, torque ratios of gears 1, 2, 4, 6, 7, 8, R", f"{_WIKIPEDIA}, GM 8L transmission, specific torque",
         "-", (4.4888, 2.9039, 1.665, 1.0, 0.8411, 0.6469, -3.6149),
         partial(_torque_ratios, GM_8L_90, "124678R"), 5.1e-5, "what the source rounds", is_relative=False),
    _printed(ZF_8HP_70, f"{_WIKIPEDIA}, ZF 8HP transmission, table with assessment",
             (4.6957, 3.1304, 2.1039, 1.6667, 1.2845, 1.0, 0.8392, 0.6667, -3.2968), 1e-4),
    Case("ZF 8HP 70, torque ratios of gears 1, 2, 4, 6, 7, 8, R", f"{_WIKIPEDIA}, ZF 8HP transmission, specific torque",
         "-", (4.6217, 3.0603, 1.6446, 1.0, 0.8347, 0.6622, -3.1186),
         partial(_torque_ratios, ZF_8HP_70, "124678R"), 5.1e-5, "what the source rounds", is_relative=False),
    _printed(FORD_6R_80, "Ford 2010, Explorer Sport Trac service description, 6R80 gear ratios",
             (4.17, 2.34, 1.52, 1.14, 0.87, 0.69, -3.4), 1e-2),
    Case("Ford AOD, ratios of gears 1, 2, 3", "Yugo 1991, service bulletins for automatic transmissions, Ravigneaux",
         "-", (2.4, 1.47, 1.0), lambda: _ratios(FORD_AOD)[:3], 5.1e-3, "what the source rounds", is_relative=False),
    Case("GM THM 440-T4, ratios of gears 1, 2, 3", "Yugo 1991, service bulletins for automatic transmissions, Simpson",
         "-", (2.92, 1.57, 1.0), lambda: _ratios(THM_440_T4)[:3], 5.1e-3, "what the source rounds", is_relative=False),
    Case("Wolfrom train, ratio and efficiency forwards", "Müller 1998, Die Umlaufgetriebe: tooth power in the carrier",
         "-", (162.0, 0.710437), lambda: wolfrom("fast", "slow"), 1e-6, "six digits, by an independent program"),
    Case("Wolfrom train, efficiency backwards", "Müller 1998, Die Umlaufgetriebe: tooth power in the carrier",
         "-", (0.598514,), lambda: wolfrom("slow", "fast")[1:], 1e-6, "six digits, by an independent program"),
)  # fmt: skip
"""Print and equilibrium disagree in gear 3 of both eight-speed boxes, and in gear 5: see the page on compound sets."""
