"""Designs whose life is told in parts: equal parts change no check, an easier part lowers no margin, by any method."""

import pytest

from designs import PAIR, changed
from gearwright.sizing import size
from gearwright.spec import edited, parse

FAST = changed(changed(PAIR, "speed_rpm = 6000", "speed_rpm = 24000"), "speed_rpm = 2000", "speed_rpm = 8000")
SET = """\
schema = 1
name = "a fast set"
shafts = ["sun", "out"]
level = "concept"
[turbines.turbine]
shaft = "sun"
power_kw = 1000
speed_rpm = 20000
[propellers.propeller]
shaft = "out"
diameter_m = 3
speed_rpm = 4000
[planetaries.stage]
sun = "sun"
ring = "ground"
carrier = "out"
planets = 3
"""
BEVEL = 'kind = "bevel"\naxis_angle_deg = 90\nspiral_angle_deg = 35\n'
STEEL = '[gears]\nmaterial = "18CrNiMo7-6"\nrating = '
TEETH = "pinion_teeth = 23\nwheel_teeth = 69\n"
DESIGNS = {
    "iso6336": FAST + TEETH + STEEL + '"iso6336"\n',
    "iso6336-2006": FAST + TEETH + STEEL + '"iso6336-2006"\n',
    "din3990": FAST + TEETH + STEEL + '"din3990"\n',
    "endless": FAST + TEETH + STEEL + '"iso6336"\n[gears.iso6336]\nlife_factor_1e10 = 1\n',
    "planets": SET + STEEL + '"iso6336"\n',
    "agma2001": FAST + TEETH + STEEL + '"agma2001"\n',
    "iso10300": FAST + BEVEL + TEETH + STEEL + '"iso6336"\n',
    "agma2003": FAST + BEVEL + TEETH + STEEL + '"agma2001"\n',
}
LIVES = (20.0, 30_000.0)
"""Asked life: well below and well beyond 1e10 cycles [h]."""


def told(text: str, life: float, loads) -> str:
    """Return the text of a design whose turbine lasts the given parts of its life at ratings."""
    cases = [f"[cases.c{k}]\nshare = {part!r}\nturbine.rating = {rating!r}\n" for k, (part, rating) in enumerate(loads)]
    return f"{text}[service]\nlife_h = {life}\n{''.join(cases)}"


def judged(text: str):
    return [(check.name, check.place, check.value, check.limit) for check in size(parse(text)).checks]


@pytest.mark.parametrize("life", LIVES)
@pytest.mark.parametrize("method", DESIGNS)
def test_a_life_in_equal_parts_moves_no_check(method, life):
    """Miner 1945: k parts of a k-th of the life each are the life; to the rounding of a root, 1e-9."""
    whole = judged(told(DESIGNS[method], life, [(1.0, 1.0)]))
    for parts in (2, 3, 7):
        split = judged(told(DESIGNS[method], life, [(1.0 / parts, 1.0)] * parts))
        for one, other in zip(whole, split, strict=True):
            assert one == (*other[:2], *(pytest.approx(value, rel=1e-9) for value in other[2:]))


@pytest.mark.parametrize("life", LIVES)
@pytest.mark.parametrize("method", DESIGNS)
def test_an_easier_half_lowers_no_safety_of_teeth(method, life):
    """Of teeth whose sizes are given, so that nothing but the loads differs."""
    stage = "planetaries.stage" if method == "planets" else "pairs.stage"
    module = "outer_module_mm" if method in ("iso10300", "agma2003") else "module_mm"
    sizes = {f"{stage}.{module}": 3.0, f"{stage}.face_width_mm": 30.0}
    whole = size(edited(parse(told(DESIGNS[method], life, [(1.0, 1.0)])), sizes))
    teeth = {f"{stage}.{gear.partition('.')[2]}_teeth": number for gear, number in whole.teeth.items()}
    easier = size(edited(parse(told(DESIGNS[method], life, [(0.5, 1.0), (0.5, 0.6)])), sizes | teeth))
    for mesh, other in zip(whole.meshes, easier.meshes, strict=True):
        for mode in ("bending_margin", "contact_margin"):
            assert getattr(other.rating, mode) >= getattr(mesh.rating, mode) * (1.0 - 1e-9)
