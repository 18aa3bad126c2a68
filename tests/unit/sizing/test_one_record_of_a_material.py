"""A property of a user's own material changes, and whatever reads it moves by its law."""

import math
from functools import cache

import pytest

from designs import PAIR
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.assembly.assemble import pin_stiffness
from gearwright.shape import scene, solid_masses
from gearwright.sizing import size
from gearwright.spec import parse

OWN = """\
[materials.mine]
elastic_modulus_gpa = {E}
poisson_ratio = {nu}
density_kg_m3 = {rho}
yield_strength_mpa = {proof}
ultimate_strength_mpa = 1300
group = "case-hardened"
hardness_hv = 700
steel = "case-hardened"
"""
USUAL = {"E": 206.0, "nu": 0.3, "rho": 7830.0, "proof": 900.0}
OTHER = {"E": 110.0, "nu": 0.34, "rho": 4430.0, "proof": 700.0}
TEETH = "pinion_teeth = 23\nwheel_teeth = 69\nface_width_mm = 30\n"
BEVEL = 'kind = "bevel"\naxis_angle_deg = 90\nspiral_angle_deg = 35\nouter_module_mm = 4\n'
SET = """\
schema = 1
name = "one set"
level = "concept"
shafts = ["sun", "out"]
[turbines.turbine]
shaft = "sun"
power_kw = 500
speed_rpm = 12000
[propellers.propeller]
shaft = "out"
diameter_m = 3
speed_rpm = 3000
[planetaries.stage]
sun = "sun"
ring = "ground"
carrier = "out"
planets = 3
sun_teeth = 26
planet_teeth = 25
ring_teeth = 76
module_mm = 3
face_width_mm = 40
"""


def gears(method: str, rest: str = "") -> str:
    return f'{rest}[gears]\nmaterial = "mine"\nrating = "{method}"\n'


DESIGNS = {
    "iso6336": SET + gears("iso6336") + '[dynamics]\nfidelity = "translational"\n',
    "lewis-hertz": SET + gears("lewis-hertz"),
    "agma2001": PAIR + TEETH + "module_mm = 3\n" + gears("agma2001"),
    "iso10300": PAIR + BEVEL + TEETH + gears("iso6336"),
    "agma2003": PAIR + BEVEL + TEETH + gears("agma2001"),
}


@cache
def sized(design: str, key: str = ""):
    """Return the sizing of a design of the usual material, or with one property of the other one."""
    told = USUAL | ({key: OTHER[key]} if key else {})
    return size(parse(DESIGNS[design] + OWN.format(**told)))


def sun(sizing):
    return next(gear for gear in sizing.gears if gear.name == "stage.sun")


def factors(sizing):
    return sizing.meshes[0].rating.factors


def line(sizing, name):
    system = assemble(sizing)
    return float(system.arrays.stiffness[system.labels.lines.index(name)])


def turning(sizing):
    system = assemble(sizing)
    return float(system.arrays.mass[system.labels.coordinates.index("stage.sun")])


def solid(sizing):
    return next(row.solid for row in solid_masses(sizing, scene(sizing)) if str(row.part) == "stage.sun")


def stressed(sizing, name):
    return next(check for check in sizing.checks if check.name == name)


WEIGHS = {"rho": lambda ratio: ratio}
STIFF = {"E": lambda ratio: ratio}
SOFT = {"E": lambda ratio: 1.0 / ratio}
PRESSED = {"E": math.sqrt, "nu": lambda _: math.sqrt((1.0 - 0.3**2) / (1.0 - 0.34**2))}
SHAKEN = {"E": lambda ratio: ratio**-0.5, "rho": math.sqrt}
BORNE = {"proof": lambda ratio: ratio}
READERS = {
    "mass of a gear": ("iso6336", lambda s: sun(s).mass, WEIGHS),
    "inertia of a gear": ("iso6336", lambda s: sun(s).inertia, WEIGHS),
    "mass of a solid": ("iso6336", solid, WEIGHS),
    "inertia of the dynamic model": ("iso6336", turning, WEIGHS),
    "m_red of K_V, ISO 6336": ("iso6336", lambda s: float(factors(s).dynamic.reduced_mass), WEIGHS),
    "N of K_V, ISO 6336": ("iso6336", lambda s: float(factors(s).dynamic.resonance_ratio), SHAKEN),
    "B_p of K_V, ISO 6336": ("iso6336", lambda s: float(factors(s).dynamic.pitch_term), STIFF),
    "f_sh over its load, ISO 6336": (
        "iso6336", lambda s: float(factors(s).face.deflection / factors(s).dynamic.factor), SOFT
    ),
    "Z_E, ISO 6336": ("iso6336", lambda s: float(factors(s).pitting.geometry.elasticity), PRESSED),
    "stiffness of a mesh": ("iso6336", lambda s: line(s, "stage.sun-planet-1"), {"E": lambda ratio: ratio}),
    "stiffness of a pin": ("iso6336", lambda s: pin_stiffness(s, "stage"), {"E": None}),
    "stiffness of a shaft": (
        "iso6336", lambda s: s.shafts[0].stiffness / s.shafts[0].diameter**4 * s.shafts[0].length,
        {"E": lambda ratio: ratio, "nu": lambda _: 1.3 / 1.34},
    ),
    "mass of a shaft": (
        "iso6336", lambda s: s.shafts[0].mass / s.shafts[0].diameter**2 / s.shafts[0].length, WEIGHS
    ),
    "strength of a carrier": ("iso6336", lambda s: stressed(s, "stage.carrier pin bending").limit, BORNE),
    "σ_H, Lewis and Hertz": ("lewis-hertz", lambda s: s.meshes[0].contact_stress, PRESSED),
    "allowable bending, Lewis": ("lewis-hertz", lambda s: s.meshes[0].rating.bending_allowable, BORNE),
    "C_p, AGMA 2001": ("agma2001", lambda s: factors(s).elastic, PRESSED),
    "C_p, AGMA 2003": ("agma2003", lambda s: factors(s).mesh.elastic, PRESSED),
    "m_red of K_V, ISO 10300": ("iso10300", lambda s: factors(s).dynamic.reduced_mass, WEIGHS),
    "N of K_V, ISO 10300": ("iso10300", lambda s: factors(s).dynamic.resonance_ratio, SHAKEN),
    "Z_E, ISO 10300": ("iso10300", lambda s: factors(s).pitting.elasticity, PRESSED),
    "X_M, ISO 10300": ("iso10300", lambda s: s.meshes[0].rating.scuffing.thermal_flash, {"E": None, "nu": None}),
}  # fmt: skip
"""Reader -> design, what it reads there, and property -> by what it moves with it; None: it moves."""


@pytest.mark.parametrize(("name", "key"), [(name, key) for name, (_, _, laws) in READERS.items() for key in laws])
def test_what_reads_a_property_moves_with_it(name, key):
    """Laws of each formula: masses ~ ρ, stiffness ~ E, Z_E ~ √(E/(1 − ν²)), N ~ √(ρ/E), G = E/(2 (1 + ν))."""
    design, read, laws = READERS[name]
    ratio = read(sized(design, key)) / read(sized(design))
    law = laws[key]
    if law is None:
        assert abs(ratio - 1.0) > 1e-3
    else:
        assert ratio == pytest.approx(law(OTHER[key] / USUAL[key]), rel=1e-9)


def test_pins_are_of_the_material_of_shafts_and_carriers_in_weight_and_stiffness():
    """[shafting] material: a pin as stiff as its E, whatever the gears are of."""
    text = DESIGNS["iso6336"] + OWN.format(**USUAL)
    own = size(parse(text))
    steel = size(parse(text + '[shafting]\nmaterial = "carburised-9310"\n'))
    stiffness = [
        pin_stiffness(sizing, "stage") / next(iter(sizing.carriers)).pin_diameter ** 4 for sizing in (own, steel)
    ]
    assert stiffness[1] / stiffness[0] == pytest.approx(210.0 / 206.0, rel=1e-9)
