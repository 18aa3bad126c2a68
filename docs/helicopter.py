"""The page on the helicopter gearbox: the report's numbers, a hand design for the same duty, and ours."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from gearwright.catalogue import gear_steel
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth, gleason_profile_shift
from gearwright.parts.iso10300 import (
    LOW_CROWNING,
    BevelDuty,
    BevelRating,
    BevelSurfaces,
    bevel_pitch_tolerance,
    rate_bevel,
)
from gearwright.render.tables.checks import check_sentence
from gearwright.shipped import shipped_design
from gearwright.sizing import GearSizing, MeshSizing, Sizing, size
from gearwright.spec import read

_HEAD = """# A helicopter's gearbox

A student term project designed the main gearbox of the EC120B: 322 kW from 6000 to 600 rpm by a helical and a bevel
pair, three shafts, bearings and keys.
[Its numbers are replayed](../theory/colibri.md) with `gearwright replay colibri`. A rotor of 10 m at 600 rpm has tips
of 314 m/s, Mach 0.92: the helicopter's turns at 406 rpm, and its engine gives 376 kW at take-off. Two designs come with
gearwright: the gearbox as the report prints it, with its rotor's tips flagged, and one for the helicopter as it is
that holds, with the drive of the tail rotor, an oil pump, a rotor brake and [load cases](cases.md) beside.

```console
$ gearwright new ec120b-as-reported
…
$ gearwright new ec120b
…
```

`gearwright check` says what fails, with clause, value and limit, the worst first:

```console
$ gearwright check ec120b-as-reported
{weak}
…
```

`gearwright size ec120b` prints teeth, forces, shafts, bearings, joints and every margin; with `--factors` every
factor of both ratings. `gearwright run ec120b` writes all
of it as a page, `gearwright draw ec120b` [draws it](drawings.md), `gearwright fly ec120b ec120b-sortie` flies it.

## What differs

"""
_TAIL = """
Torques and forces of `ec120b` are those of its take-off of {minutes:.0f} minutes in an hour's flight, {power:.0f} kW
with {tail:.0f} kW to the tail rotor. Forces of the bevel pair act at its mean diameters. Tooth numbers, all places
along the shafts, powers of the cases, the rotor's loads, the life of {life:.0f} h and the oil are assumptions in the
design file, which says what is published. The hand design is an earlier calculation by the same standards for the
report's inputs.
What else differs:

* **Speed.** At 406 instead of 600 rpm the mast has {more:.2f} times the torque of the hand design's; masses follow it.
* **Cases.** Gears of the hand design bear 322 kW for all of its life, bearings a cubic mean of 0.8 of it; `ec120b`
  sums the damage of its cases.
* **Bevel pair.** The hand design shifts the profile, finishes the flanks finer and crowns them less than ours.
  [Step by step](#the-hand-designs-bevel-pair) it comes out; as ours is cut it would not hold. Hence a larger cone.
* **Tooth numbers.** 15/47 with 36/169 would be 75 kg, with the bevel mesh within 15 % of a torsional mode;
  14/43 with 36/173 has none so near, and 406.5 rpm.
* **Bearings.** Ratings of the catalogue are those of ISO 281 for a plain inside; makers' are up to 22 % off. Ours
  stand elsewhere along the shafts, and the rear of
  the mast carries the bevel wheel nearly alone.
* **Shafts.** Sized at every shoulder, seat and spline by DE-ASME with notch factors, not as one diameter.
* **As reported.** The report's page gives its bearings [38, 46 and 136 h](../theory/colibri.md) under its own forces;
  here forces are those of the gears: both load shaft 2, where their axial forces nearly cancel, and the mast bears
  twice the tooth force that the report takes at 306 mm.
  Shafts, bearings and keys are [taken as given](../theory/shafts-in-bearings.md#taken-as-given).
* **The report's bevel pair** has S_H 0.31 and S_F 0.26 in the replay, for unlimited life without life factors and
  with an oil of 100 mm²/s, and less here, for 3500 h with an oil of 25 mm²/s.
* **Splines.** Tooth height 0.9 m on d_B − 1.1 m by DIN 5480; the hand design takes 0.8 m on d = m z.

## The hand design's bevel pair

17/43 of 8.50 mm and 51 mm by our ISO 10300-1 and -2:2023, which give ISO/TR 10300-30, sample 1, to its printed digits;
oil of 25 mm²/s and a life of 3500 h throughout. S_H is printed as 1.22 / 1.25.

| step after step | S_H, pinion / wheel |
| --- | --- |
{steps}

The shift is Gleason's usual one by ISO 23509, which a design file cannot yet ask of a bevel pair.

| | command |
| --- | --- |
| this page | `python docs/generate.py` |
| the ratings against published ones | `pytest tests/validation -k "iso6336 or bevel"` |
| time of the whole sizing | `python benchmarks/rating.py` |
"""

SHOWN = 12
"""Checks that the page shows."""
HAND_TORQUE = 5137.4
"""Of the hand design's mast [N m]."""


def helicopter_markdown() -> str:
    """Return the page."""
    ours, reported = (size(read(shipped_design(name))) for name in ("ec120b", "ec120b-as-reported"))
    rows = "".join(f"| {' | '.join(cells)} |\n" for cells in _rows(ours, reported))
    head = "| quantity | as reported | hand design, same inputs | `ec120b` |\n| --- | --- | --- | --- |\n"
    return _HEAD.format(weak=_weak(reported)) + head + rows + _TAIL.format(steps=_steps(), **_duty(ours))


def _duty(sizing: Sizing) -> dict[str, float]:
    """Return what the page says of the loads: take-off, tail rotor, mast and life."""
    flow = sizing.reference
    return {
        "life": sizing.design.service.life / 3600.0,
        "minutes": (sizing.design.cases[flow.case].duration or 0.0) / 60.0,
        "power": 1e-3 * flow.machine_powers["arrius-2f"],
        "tail": -1e-3 * flow.machine_powers["tail-drive"],
        "more": abs(flow.machine_torques["main-rotor"]) / HAND_TORQUE,
    }


def _weak(sizing: Sizing) -> str:
    """Return the worst checks as the command prints them."""
    return "\n".join(f"{check_sentence(check)}; the margin should be 1 or more" for check in sizing.checks[:SHOWN])


def _steps() -> str:
    """Return S_H of the hand design's bevel pair: cut as ours are, then as it was meant, one step after another."""
    plain = BevelPair((17, 43), 8.5e-3, 51e-3, math.radians(35.0))
    shifted = replace(plain, tooth=BevelTooth(profile_shift=gleason_profile_shift(plain.teeth)))
    coarse = BevelSurfaces(viscosity=25e-6)
    fine = replace(coarse, flank_roughness=2e-6)
    return "\n".join(
        f"| {step} | {_hand_design(pair, surfaces)} |"
        for step, pair, surfaces in (
            (f"no profile shift, R_z {1e6 * coarse.flank_roughness:.0f} µm, crowning exponent 1.5", plain, coarse),
            (f"x_hm1 = {shifted.tooth.profile_shift:.3f}", shifted, coarse),
            ("R_z 2 µm", shifted, fine),
            ("crowning exponent 3", shifted, replace(fine, peak_exponent=LOW_CROWNING)),
        )
    )


def _hand_design(pair: BevelPair, surfaces: BevelSurfaces) -> str:
    """Return S_H of pinion and wheel under the hand design's load, for 3500 h."""
    steel = gear_steel("case-hardened", "MQ", 700.0)
    tolerance = bevel_pitch_tolerance(pair.mean_diameters[1], pair.mean_module, 4)
    duty = BevelDuty(2031.1, 6000.0 / 3.963 * math.pi / 30.0, tolerance, 1.25)
    rated = rate_bevel(pair, (steel, steel), duty, 3500.0 * 3600.0, surfaces=surfaces)
    return " / ".join(f"{safety:.3f}" for safety in rated.pitting.safeties)


def _rows(ours: Sizing, reported: Sizing) -> Iterator[tuple[str, str, str, str]]:
    """Yield quantity, value of the report, of the hand design, and ours."""
    for what, reading, value in (
        ("ratio i_1 × i_2, rotor speed", "3.963 × 2.529, 598.6 rpm", _ratios),
        ("T_1 / T_2 / T_3 [N m]", "512.5 / 2031.1 / 5137.4", _torques),
        ("helical z, m_n [mm], b [mm]", "27/107, 2.50, 45", lambda each: _teeth(each, "helical")),
        ("b/d_1", "0.65", _slenderness),
        ("helical F_t / F_r / F_a [N]", "14 854 / 5527 / 3157", lambda each: _forces(each, "helical")),
        ("helical S_H, pinion / wheel", "1.20 / 1.25", lambda each: _safeties(each, "helical", "pitting")),
        ("helical S_F", "2.00 / 2.03", lambda each: _safeties(each, "helical", "bending")),
        ("bevel z, m_et [mm], b [mm]", "17/43, 8.50, 51, spiral 35°", lambda each: _teeth(each, "bevel")),
        ("bevel cone distance R_e [mm]", "196.5", lambda each: f"{1e3 * _cone(each).outer_cone_distance:.1f}"),
        ("bevel F_t / F_r / F_a on the pinion [N]", "32 304 / 5032 / 26 312", lambda each: _forces(each, "bevel")),
        ("bevel S_H", "1.22 / 1.25", lambda each: _safeties(each, "bevel", "pitting")),
        ("bevel S_F", "1.85 / 1.83", lambda each: _safeties(each, "bevel", "bending")),
        ("shaft diameters [mm]", "38.5 / 67.4 / 80.4", _diameters),
        ("weakest sections of shafts, n_f", "1.5 / 1.5 / 1.5", _weakest),
        ("bearings and L_10h [h]", "NU 2209 18 277, NU 2209 13 132, QJ 209 35 185, NU 2212 15 315, NU 2212 5139, "
         "QJ 312 5367, 33016 18 348, 33118 11 998", _bearings),
        ("system L_10 of the bearings [h]", "1621", _system),
        ("shaft-hub joints", "splines of module 2, 13 / 16 / 28 mm, or longer", _joints),
        ("pressure in joints [MPa]", "100", _pressures),
        ("mass of gears and shafts [kg]", "–", lambda each: f"{each.mass:.1f}"),
        ("worst margin", "–", lambda each: f"{each.worst_margin:#.3g}"),
        ("checks that fail, of all", "–", _failing),
    ):  # fmt: skip
        yield what, value(reported), reading, value(ours)


def _ratios(sizing: Sizing) -> str:
    teeth, rotor = sizing.teeth, abs(sizing.reference.speeds["mast"]) * 30.0 / math.pi
    first, second = (teeth[f"{name}.wheel"] / teeth[f"{name}.pinion"] for name in ("helical", "bevel"))
    return f"{first:.3f} × {second:.3f}, {rotor:.1f} rpm"


def _torques(sizing: Sizing) -> str:
    meshes = sizing.reference.meshes
    found = (meshes["helical"].torques[0], meshes["bevel"].torques[0], meshes["bevel"].torques[1])
    return " / ".join(f"{abs(each):.1f}" for each in found)


def _mesh(sizing: Sizing, name: str) -> MeshSizing:
    return next(each for each in sizing.meshes if each.name == name)


def _gear(sizing: Sizing, name: str) -> GearSizing:
    return next(each for each in sizing.gears if each.name == name)


def _cone(sizing: Sizing) -> BevelPair:
    rated = _mesh(sizing, "bevel").rating
    assert rated is not None and isinstance(rated.factors, BevelRating)
    return rated.factors.virtual.bevel


def _teeth(sizing: Sizing, stage: str) -> str:
    one, other = (_gear(sizing, f"{stage}.{side}") for side in ("pinion", "wheel"))
    module = _cone(sizing).outer_module if stage == "bevel" else one.module
    given = sizing.given.get(f"{stage}.face_width")
    asked = one.face_width if given is None else given.value
    lean = f", spiral {math.degrees(one.helix_angle):.0f}°" if stage == "bevel" and one.helix_angle else ""
    rated = "" if asked == one.face_width else f" (rated at {1e3 * one.face_width:.1f})"
    return f"{one.teeth}/{other.teeth}, {1e3 * module:.2f}, {1e3 * asked:.0f}{rated}{lean}"


def _slenderness(sizing: Sizing) -> str:
    gear = _gear(sizing, "helical.pinion")
    return f"{gear.face_width / gear.pitch_diameter:.2f}"


def _forces(sizing: Sizing, stage: str) -> str:
    mesh = _mesh(sizing, stage)
    return " / ".join(f"{each:.0f}" for each in (mesh.tangential_force, mesh.radial_force, mesh.axial_force))


def _safeties(sizing: Sizing, stage: str, mode: str) -> str:
    rated = _mesh(sizing, stage).rating
    return " / ".join(f"{each:.2f}" for each in getattr(rated, mode))


def _diameters(sizing: Sizing) -> str:
    return " / ".join(f"{1e3 * each.diameter:.0f}" for each in sizing.shafts)


def _bearings(sizing: Sizing) -> str:
    return ", ".join(f"{each.bearing.designation} {each.life / 3600.0:.0f}" for each in sizing.bearings)


def _system(sizing: Sizing) -> str:
    return f"{(sizing.system_life or 0.0) / 3600.0:.0f}"


def _weakest(sizing: Sizing) -> str:
    return " / ".join(f"{each.weakest.fatigue_safety:.2f}" for each in sizing.built_shafts)


def _joints(sizing: Sizing) -> str:
    found = [f"{each.part}: {each.designation}, {1e3 * each.length:.0f} mm" for each in sizing.joints if each.length]
    return "; ".join(found)


def _pressures(sizing: Sizing) -> str:
    return " / ".join(f"{1e-6 * each.pressure:.0f}" for each in sizing.joints if each.length)


def _failing(sizing: Sizing) -> str:
    return f"{sum(check.fails for check in sizing.checks)} of {len(sizing.checks)}"
