"""Designs with the options that no shipped one has, by numbers that are neither 0 nor 1, so that none drops out."""

from designs import HYBRID, changed
from mounted_designs import HELICOPTER, PAIR

_SERVICE = """
[service]
life_h = 2200
bearing_life_h = 1300
application_factor = 1.4
static_safety = 1.2
shaft_fatigue_safety = 1.3
shaft_yield_safety = 1.25
torque_swing = 0.3
shares = { rated = 0.3, cruise = 0.7 }
[cases.cruise.engine]
power_kw = 210
[cases.rated.engine]
rating = 1
"""
_ISO = """
[gears.iso6336]
grade = "ME"
hardness_hv = 680
pitting_safety = 1.15
bending_safety = 1.45
scuffing_safety = 1.3
tolerance_class = 6
flank_roughness_um = 6
root_roughness_um = 14
oil_viscosity = 60
oil_temperature = 75
scuffing_stage = 12
"""
_WITHOUT_SERVICE = changed(PAIR, "[service]\nbearing_life_h = 5000\n", "")
_RULES = changed(
    _WITHOUT_SERVICE,
    "helix_angle_deg = 12\n",
    "helix_angle_deg = 12\nmesh_load_factor = 1.15\nmesh_efficiency = 0.985\nprofile_shift = 0.3\nweb_ratio = 0.6\n"
    f'{_ISO}widest_diameters = 1.1\nhelix_modification = "crowning"\n',
)
_SPLINE = '[joints."helical.wheel"]\nkind = "spline"\n'
_BUILT = """
[shafting]
safety = 1.8
fatigue = "goodman"
reliability = 0.99
surface = "ground"
fillet_ratio = 0.08
"""

GOODMAN = changed(
    _RULES + _SERVICE + _BUILT,
    _SPLINE,
    '[joints."helical.wheel"]\nkind = "press-fit"\nfriction = 0.15\nsafety = 1.7\ndiameter_mm = 75\n',
)
"""Press fit, Goodman, two cases, a load factor, ground shafts."""

KEYS = (
    changed(
        changed(
            _RULES + _SERVICE + _BUILT.replace("goodman", "asme"),
            'kind = "taper"\nlocates = "first"',
            'kind = "deep-groove"\nlocates = "both"',
        ),
        'kind = "taper"\nlocates = "second"',
        'kind = "cylindrical"',
    )
    .replace(
        _SPLINE,
        '[joints."helical.wheel"]\nkind = "key"\nform = "B"\npressure_mpa = 400\ndiameter_mm = 70\nlength_mm = 45\n',
    )
    .replace("[layout.output]\n", "[layout.output]\nbore_mm = 20\n")
)
"""Keys of form B, a deep-groove bearing that locates, a bore."""

SPLINES = changed(_RULES + _SERVICE, _SPLINE, '[joints."helical.wheel"]\nkind = "spline"\nmodule_mm = 2\n').replace(
    "[bearings.1a]\n", '[bearings.1a]\ndesignation = "NU 2209"\ndynamic_rating_kn = 70\nstatic_rating_kn = 90\n'
)
"""A spline of a given module, ratings of the maker."""

BEVEL = (
    changed(
        changed(HELICOPTER, "spiral_angle_deg = 35", "spiral_angle_deg = 28"),
        "gears = { helix_angle_deg = 0 }",
        'gears = { helix_angle_deg = 0, mesh_load_factor = 1.2, iso6336 = { mounting = "straddle", grade = "ME" } }',
    )
    .replace("mean_load = 0.8", "mean_load = 0.8\napplication_factor = 1.1\nlife_h = 900")
    .replace("thrust_kn = 16.8", "thrust_kn = -9.5")
)
"""A bevel pair with a load factor, straddled, and a rotor that pulls the other way."""

PLANETARY = (
    changed(
        HYBRID,
        'carrier = "middle"\nplanets = 3\n',
        'carrier = "middle"\nplanets = 4\nratio_split = 1.05\n'
        "gears = { mesh_load_factor = 1.1, rim_thickness_ratio = 3.2 }\n"
        'planet_bearing = { designation = "NU 2205", side_by_side = 2 }\nbacklash_um = 80\n'
        "bearings = { sun_n_um = 40, carrier_n_um = 300, ring_n_um = 500, ring_tangential_n_um = 800, pin_n_um = 9 }\n",
    )
    + """
[gears]
rating = "iso6336"
pressure_angle_deg = 25
mesh_efficiency = 0.99
[gears.iso6336]
steel = "case-hardened"
tolerance_class = 4
standard_modules = false
helix_modification = "none"
flank_roughness_um = 2
[carriers]
safety = 2.6
plate_ratio = 0.4
fill = 0.5
[dynamics]
fidelity = "translational"
mesh_damping = 0.06
shaft_damping = 0.03
harmonics = 3
[errors."first.planet-2"]
pin_radial_um = 12
pin_tangential_um = -7
tooth_thickness_um = 4
eccentricity_um = 9
phase_deg = 35
[errors."first.sun"]
eccentricity_um = 15
phase_deg = 80
"""
)
"""Planets that idle, carriers of other proportions, errors, members that move."""

OFF_SET = """
schema = 1
name = "parallel pairs of unequal share"
level = "concept"
shafts = ["input", "left", "right", "output"]
[turbines.turbine]
shaft = "input"
power_kw = 2051
speed_rpm = 20000
inertia_kg_m2 = 0.4
[propellers.propeller]
shaft = "output"
speed_rpm = 1212
diameter_m = 3.93
blades = 6
[pairs.first]
pinion = "input"
wheel = ["left", "right"]
halves = 2
backlash_um = 60
gears = { helix_angle_deg = 20, overlap_ratio = 1.3, contact_angles = "transverse", mesh_load_factor = 1.05 }
[pairs.second]
pinion = ["left", "right"]
wheel = "output"
share = [0.55, 0.45]
ratio_split = 0.8
gears = { helix_angle_deg = 12, face_width_ratio = 14, pressure_angle_deg = 22.5 }
[gears]
bending_safety = 2.1
contact_safety = 1.35
mesh_efficiency = 0.992
web_ratio = 0.7
[teeth]
split = "optimal"
hunting = true
[shafting]
safety = 2.4
end_length_mm = 80
bearing_length_mm = 22
bore_ratio = 0.45
[layout.left]
angle_deg = -30
[layout.right]
angle_deg = 200
diameter_mm = 90
torsional_stiffness_knm_rad = 310
[layout.output]
length_mm = 420
inertia_kg_m2 = 0.9
first_bearing_mm = 20
second_bearing_mm = 370
[supports.output]
radial_n_um = 240
axial_n_um = 90
mass_kg = 45
damping = 0.07
[errors."first.pinion"]
eccentricity_um = 8
phase_deg = 20
radial_um = 11
radial_angle_deg = 65
tooth_thickness_um = 3
[errors."second.pinion.left"]
clocking_deg = 0.01
axial_um = 14
[dynamics]
mesh_stiffness = "energy"
harmonics = 4
"""
"""Chosen teeth, an optimal split, helices, shafts as given, supports and errors."""

FACE = """
schema = 1
name = "face gear, internal pair, two pairs of one centre distance"
level = "concept"
shafts = ["input", "middle", "lay", "output"]
[turbines.turbine]
shaft = "input"
power_kw = 400
speed_rpm = 9000
[propellers.rotor]
shaft = "output"
speed_rpm = 500
diameter_m = 4
thrust_kn = 3
[pairs.face]
kind = "face"
axis_angle_deg = 90
pinion = "input"
wheel = "middle"
pinion_teeth = 25
wheel_teeth = 80
gears = { mesh_load_factor = 1.3 }
[pairs.out]
pinion = "middle"
wheel = "lay"
pinion_teeth = 27
wheel_teeth = 50
mesh_stiffness_n_um = 210
stiffness_swing = 0.12
[pairs.internal]
pinion = "lay"
wheel = "output"
internal = true
pinion_teeth = 24
wheel_teeth = 73
gears = { helix_angle_deg = 9 }
[dynamics]
mesh_stiffness = "square-wave"
[overrides]
"out.module_mm" = 3.5
"internal.face_width_mm" = 61
"""

VARIANTS = {
    "bevel": BEVEL,
    "face": FACE,
    "goodman": GOODMAN,
    "keys": KEYS,
    "off-set": OFF_SET,
    "planetary": PLANETARY,
    "splines": SPLINES,
}
"""Name -> text of a design file."""
