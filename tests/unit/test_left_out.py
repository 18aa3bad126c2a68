"""What is meant where something is left out: nothing is added, nothing is multiplied, the usual is taken."""

import dataclasses
import inspect
import math

import pytest

from gearwright.dynamics.model import (
    elements as drives,
    elements as line,
    model,
    planetary as planetary_set,
    rotors as beam,
)
from gearwright.parts import (
    agma908 as agma_geometry,
    agma2001 as agma_factors,
    agma2001 as agma_mesh,
    agma2001 as agma_rating,
    bevel_geometry,
    iso10300 as bevel_bending,
    iso10300 as bevel_pitting,
    iso10300 as bevel_rating,
    losses as mesh_loss,
    losses as oil,
    shaft_fatigue,
    shaft_fatigue as fatigue,
    shafts as key,
    shafts as press_fit,
    shafts as shaft,
    stiffness as energy,
    stiffness as kuang_yang,
    stiffness as mesh_stiffness,
    stiffness as passing_pairs,
)
from gearwright.parts.bearings import life as bearing_life, life as bearing_load, rolling_bearing
from gearwright.parts.gears import cylindrical_gear, gear_pair as hertz, gear_pair as lewis
from gearwright.parts.iso6336 import (
    geometry,
    geometry as root,
    loads,
    loads as face,
    steels as life,
    steels as strength,
    tooth_strength,
)
from gearwright.parts.scuffing import Oil, ScuffingMesh
from gearwright.parts.shafts import lumped_shaft
from gearwright.sizing import shaft_results as mounted
from gearwright.sizing.bearing_seats import Seat
from gearwright.sizing.rating import geometry as standard_teeth, lewis_hertz as record, protocol
from gearwright.sizing.shafts import stretches

ONES = [
    (agma_factors.load_distribution_factor, "crowning offset adjustment"),
    (agma_mesh.AgmaDuty, "overload"),
    (agma_mesh.AgmaMaking, "crowning adjustment temperature"),
    (agma_rating.AgmaLoad, "overload dynamic distribution"),
    (agma_rating.AgmaGear, "size rim bending_cycles contact_cycles hardness_ratio"),
    (agma_rating.agma_rating, "reliability temperature"),
    (bevel_geometry.cone_forces, "pushed"),
    (bevel_pitting.BevelDuty, "application_factor"),
    (tooth_strength.RootBody, "rim deep_tooth"),
    (tooth_strength.RootStrengthFactors, "life notch_sensitivity surface size mean_stress"),
    (loads.MeshDuty, "application_factor mesh_load_factor"),
    (loads.MeshQuality, "profile_factor"),
    (tooth_strength.ToothLoadFactors,
     "application mesh_load dynamic face_contact transverse_contact face_bending transverse_bending"),
    (tooth_strength.ContactStrengthFactors, "life lubricant speed roughness work_hardening size"),
    (tooth_strength.single_contact_factors, "profile_factor"),
    (tooth_strength.contact_geometry_factors, "profile_factor"),
    (tooth_strength.pitting_rating, "profile_factor"),
    (face.deflection_misalignment, "paths"),
    (key.key_pressure, "keys"),
    (key.key_length, "keys"),
    (shaft_fatigue.ShaftSection, "hardening"),
    (mesh_stiffness.GearBlank, "web_ratio"),
    (rolling_bearing.BearingGeometry, "rows"),
    (record.LewisHertzRating, "peaks"),
    (protocol.Unloaded, "peaks"),
    (standard_teeth.bevel_push, "pushed"),
]  # fmt: skip
"""Factors, counts and senses: left out, they are 1."""

ZEROS = [
    (beam.Segment, "bore"), (beam.bending_shaft, "damping_ratio"),
    (drives.PropellerDrive, "pitch_command"), (drives.MachineDrive, "slope"), (drives.ClutchDrive, "one_way"),
    (line.Periodic, "offset constant"), (line.Line, "damping backlash"),
    (model.Model.mesh, "damping backlash"), (model.Model.shaft, "damping"), (model.Model.support, "damping"),
    (model.Model.load, "constant damping quadratic"),
    (planetary_set.Member, "torsion run_out"), (planetary_set.PlanetError, "radial tangential tooth_thickness"),
    (planetary_set.PlanetarySet, "sun_teeth damping backlash"),
    (agma_geometry.HobbedPair, "helix_angle profile_shifts"), (agma_rating.agma_strength, "hardness"),
    (rolling_bearing.RingLoad, "x y axial moment_x moment_y"), (bearing_load.LoadFactors, "axial_low"),
    (rolling_bearing.BearingGeometry, "contact_angle roller_length"),
    (bevel_geometry.BevelTooth, "profile_shift thickness_shifts"), (bevel_geometry.BevelPair, "spiral_angle"),
    (cylindrical_gear.CylindricalGear, "helix_angle profile_shift tip_alteration"),
    (hertz.module_hertz, "helix_angle"), (lewis.module_lewis, "helix_angle"),
    (tooth_strength.rim_factor, "internal"), (face.PinionShaft, "offset span"),
    (geometry.ToothProportions, "profile_shift undercut"),
    (geometry.MeshGeometry, "helix_angle"), (life.contact_life_curve, "some_pitting"),
    (loads.MeshQuality, "tip_relief"), (root.LoadedTooth, "thickness_shift"),
    (root.shaped_fillet_radius, "cutter_shift"), (press_fit.FitPart, "roughness"),
    (mesh_loss.tooth_contact, "helix_angle"), (oil.churning_power, "helix_angle"),
    (ScuffingMesh, "reliefs"), (shaft_fatigue.ShaftSection, "bore"),
    (fatigue.SectionLoad, "bending_amplitude bending_mean torque_amplitude torque_mean"),
    (fatigue.section_stress, "bore"), (shaft.shaft_stress, "bore"), (shaft.shaft_diameter, "bore_ratio"),
    (shaft.shaft_mass, "bore"), (shaft.shaft_inertia, "bore"), (shaft.torsional_stiffness, "bore"),
    (mesh_stiffness.theoretical_stiffness, "profile_shifts"),
    (kuang_yang.tooth_stiffness_kuang_yang, "profile_shift"), (passing_pairs.rectangular_curve, "overlap"),
    (Seat, "swung across rotor_side"), (mounted.SectionStrength, "fillet"),
    (mounted.JointSizing, "interference module"),
    (protocol.Unloaded, "module_bending module_contact bending_stress contact_stress"),
    (protocol.Ask, "internal speed"), (standard_teeth.cylindrical_mesh, "internal"),
    (stretches.ShaftStretch, "diameter shoulder fillet"),
]  # fmt: skip
"""Angles, shifts, errors, dampings, bores and loads: left out, there is none."""

USUAL = [
    (beam.Segment, {"elasticity": 206e9, "poisson": 0.3, "density": 7850.0}),
    (model.Model, {"profile": ((0.0, 1.0),)}),
    (planetary_set.PlanetarySet, {"flank": 1}),
    # AGMA 908-B89: hobs of 1.25 with an edge of 0.25, teeth thinned by 0.024 in normal modules.
    (agma_geometry.HobbedPair, {"pressure_angle": math.radians(20.0), "face_width": 10.0, "addenda": (1.0, 1.0),
                                "hob_addendum": 1.25, "hob_radius": 0.25, "thinning": 0.024}),
    (agma_mesh.AgmaDuty, {"meshes_per_turn": (1.0, 1.0)}),
    (agma_mesh.AgmaMaking, {"quality": 11, "reliability": 0.99}),
    # ISO 281: e = 10/9 of ball bearings, life with the cube of the load; grooves of 0.52 and 0.53.
    (bearing_life.system_life, {"slope": 10.0 / 9.0}),
    (bearing_load.mean_load, {"exponent": 3.0}),
    (rolling_bearing.BearingGeometry, {"inner_conformity": 0.52, "outer_conformity": 0.53}),
    # ISO 10300: R_z of the reference test gears, oil of 100 mm²/s, teeth of ISO 23509.
    (bevel_bending.bevel_bending, {"roughness": 16e-6}),
    (bevel_geometry.BevelTooth, {"addendum": 1.0, "dedendum": 1.25, "edge_radii": (0.3, 0.3)}),
    (bevel_geometry.BevelPair, {"pressure_angle": math.radians(20.0), "shaft_angle": math.radians(90.0)}),
    (bevel_pitting.bevel_pitting, {"viscosity": 100e-6, "roughness": 8e-6}),
    (bevel_rating.BevelSurfaces, {"flank_roughness": 4e-6, "root_roughness": 10e-6, "viscosity": 100e-6}),
    # ISO 53, profile A.
    (cylindrical_gear.BasicRack, {"pressure_angle": math.radians(20.0), "addendum": 1.0, "dedendum": 1.25,
                                  "fillet_radius": 0.38}),
    (geometry.ToothProportions, {"dedendum": 1.25, "fillet_radius": 0.38}),
    (geometry.MeshGeometry, {"pressure_angle": math.radians(20.0)}),
    # ISO 6336-1: a pinion in the middle, K' = 0.48; steel of 206 GPa and 7.83 kg/dm³.
    (face.PinionShaft, {"diameter": 1.0, "constant": 0.48}),
    (loads.MeshDuty, {"meshes_per_turn": (1.0, 1.0)}),
    (loads.MeshQuality, {"grade": 5, "flank_roughness": 4e-6, "root_roughness": 10e-6, "viscosity": 100e-6,
                         "rims": (1.0, 1.0), "mean_stresses": (1.0, 1.0)}),
    (strength.GearSteel, {"elastic_modulus": 206e9, "poisson_ratio": 0.3, "density": 7830.0}),
    (press_fit.FitPart, {"poisson_ratio": 0.3}),
    (oil.oil_flow, {"heat_capacity": 2000.0}),
    # ISO/TS 6336-20: c′ = 14 and c_γ = 20 N/(mm µm) of steel.
    (Oil, {"viscosity_40": 100e-6}),
    (ScuffingMesh, {"stiffness": (14e9, 20e9), "grade": 6, "elastic_modulus": 206e9,
                                      "poisson_ratio": 0.3}),
    (lumped_shaft, {"pieces": 40}),
    (shaft_fatigue.ShaftSection, {"roughness": 10e-6}),
    (fatigue.endurance_limit, {"reliability": 0.5}),
    (mesh_stiffness.GearBlank, {"rim_ratio": 5.0}),
    (passing_pairs.rectangular_curve, {"step": 0.75, "harmonics": 8}),
    (energy.mesh_stiffness_energy, {"harmonics": 8}),
    (kuang_yang.mesh_stiffness_kuang_yang, {"harmonics": 8}),
    (mesh_stiffness.mesh_curve_iso6336, {"harmonics": 8}),
    (protocol.Ask, {"idlers": (False, False), "passes": (1.0, 1.0)}),
]  # fmt: skip


def left_out(thing):
    """Return name -> what is taken where it is left out, of a record or a function."""
    if dataclasses.is_dataclass(thing):
        pairs = [(field.name, field) for field in dataclasses.fields(thing)]
        return {
            name: field.default_factory() if field.default is dataclasses.MISSING else field.default
            for name, field in pairs
            if field.default is not dataclasses.MISSING or field.default_factory is not dataclasses.MISSING
        }
    parameters = inspect.signature(thing).parameters.values()
    return {one.name: one.default for one in parameters if one.default is not inspect.Parameter.empty}


@pytest.mark.parametrize(("thing", "names"), ONES)
def test_factors_that_are_left_out_change_nothing(thing, names):
    taken = left_out(thing)
    assert {name: taken[name] for name in names.split()} == dict.fromkeys(names.split(), 1)


@pytest.mark.parametrize(("thing", "names"), ZEROS)
def test_what_is_left_out_is_not_there(thing, names):
    taken = left_out(thing)
    for name in names.split():
        assert taken[name] in (0, (0.0, 0.0)), name


@pytest.mark.parametrize(("thing", "values"), USUAL)
def test_the_usual_is_taken_where_nothing_is_said(thing, values):
    taken = left_out(thing)
    for name, value in values.items():
        assert taken[name] == (value if isinstance(value, tuple) else pytest.approx(value)), name
