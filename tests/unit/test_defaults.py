"""What a record or a verb of the engine takes where nothing is said: neutral, or a standard's own number."""

import dataclasses
import functools
import importlib
import inspect
import math
import pkgutil
from collections.abc import Iterator

import pytest

ROOMS = (
    "gearwright.parts", "gearwright.train", "gearwright.sizing", "gearwright.dynamics.model",
    "gearwright.dynamics.assembly",
)  # fmt: skip

FACTORS_OF_ONE = """
    AgmaDuty.overload AgmaGear.bending_cycles AgmaGear.contact_cycles AgmaGear.hardness_ratio AgmaGear.rim AgmaGear.size
    AgmaLoad.distribution AgmaLoad.dynamic AgmaLoad.overload AgmaMaking.adjustment AgmaMaking.crowning
    AgmaMaking.temperature AgmaBevelDuty.overload BevelDuty.application_factor ContactStrengthFactors.life
    ContactStrengthFactors.lubricant ContactStrengthFactors.roughness ContactStrengthFactors.size
    ContactStrengthFactors.speed ContactStrengthFactors.work_hardening GearBlank.web_ratio GearSteel.survival
    ToothLoadFactors.application ToothLoadFactors.dynamic ToothLoadFactors.face_bending ToothLoadFactors.face_contact
    ToothLoadFactors.mesh_load
    ToothLoadFactors.transverse_bending ToothLoadFactors.transverse_contact MeshDuty.application_factor
    MeshDuty.mesh_load_factor
    MeshQuality.profile_factor OilState.lubricant_factor RootBody.deep_tooth RootBody.rim RootStrengthFactors.life
    RootStrengthFactors.mean_stress RootStrengthFactors.notch_sensitivity RootStrengthFactors.size
    RootStrengthFactors.surface ShaftSection.hardening FilmMesh.relief FilmMesh.supply LewisHertzRating.peaks
    Unloaded.peaks Oil.enclosure Oil.lubricant_factor agma_rating.reliability agma_rating.temperature
    bevel_push.pushed cone_forces.pushed contact_geometry_factors.profile_factor load_distribution_factor.adjustment
    load_distribution_factor.crowning load_distribution_factor.offset pitting_rating.profile_factor
    single_contact_factors.profile_factor windage_power_dawson.enclosure BearingGeometry.rows Seat.side_by_side
    deflection_misalignment.paths key_length.keys key_pressure.keys fitting_turns.number GearContact.sense
    PlanetarySet.flank influences.wish Needs.kept needs_of.kept Choices.least_dynamic shifted_mesh.module
    PinionShaft.diameter Oil.kind Oil.supply ScuffingMesh.structure TransverseTooth.side
    TeethSearch.sized RollerProportions.share Run.piece MeshDeviations.relief_term MeshQuality.blank mesh_springs.blank
    MovingBody.meshes Rating.load_factor ScuffingMesh.mates StageTask.fastest StageTask.steady Part.ratio
"""
"""Factors, counts and senses that leave a formula as it is."""

NOTHINGS = """
    Chosen.gear_mass Item.inside Item.is_sun Line.slack Line.thicker Rating.least_area _Looked.sized MassBasis.bell
    MassBasis.per_heat
    oil_mass.planets
    AxialLoad.amplitude AxialLoad.greatest AxialLoad.mean BearingGeometry.contact_angle BearingGeometry.roller_length
    BevelPair.spiral_angle BevelTooth.profile_shift CylindricalGear.helix_angle CylindricalGear.profile_shift
    CylindricalGear.tip_alteration FitPart.roughness Hardnesses.roughness HobbedPair.helix_angle LoadFactors.axial_low
    LoadedTooth.thickness_shift MeshGeometry.helix_angle MeshQuality.tip_relief
    PinionShaft.offset PinionShaft.span RingLoad.axial RingLoad.moment_x RingLoad.moment_y RingLoad.x RingLoad.y
    SectionLoad.bending_amplitude SectionLoad.bending_mean SectionLoad.torque_amplitude SectionLoad.torque_mean
    ShaftSection.bore ShaperCutter.shift ToothContact.helix ToothProportions.profile_shift ToothProportions.undercut
    ToothShift.profile_shift ToothShift.tip_alteration agma_strength.hardness bevel_strength.hardness
    churning_power.helix_angle film_speed.load module_hertz.helix_angle module_lewis.helix_angle
    rectangular_curve.overlap section_stress.bore shaft_diameter.bore_ratio shaft_inertia.bore shaft_mass.bore
    shaft_stress.bore shaped_fillet_radius.cutter_shift shifted_mesh.helix_angle tooth_contact.helix_angle
    tooth_stiffness_kuang_yang.profile_shift torsional_stiffness.bore Body.bore Seat.swung Seat.across Seat.rotor_side
    BearingSizing.judged_life BearingSizing.lightest_load BearingSizing.least_load BearingSizing.highest_speed
    BearingSizing.reference_speed BearingSizing.speed_factor JointSizing.interference JointSizing.running_pressure
    JointSizing.needed_pressure JointSizing.module Unloaded.module_bending Unloaded.module_contact
    Unloaded.bending_stress Unloaded.contact_stress Ask.speed ShaftStretch.diameter ShaftStretch.shoulder
    ShaftStretch.fillet
    Section.radius Holder.force Holder.capacity Holder.lip covers.apart Shoulder.undercut Blank.holes Blank.dish
    bevel_volume.dish bevel_way.dish way_behind.dish frequency_number.rim
    SectionStrength.fillet Segment.bore bending_shaft.damping_ratio PropellerDrive.pitch_command MachineDrive.slope
    Periodic.offset Periodic.constant Line.damping Line.backlash Member.torsion Member.run_out PlanetError.radial
    PlanetError.tangential PlanetError.tooth_thickness PlanetarySet.damping GearContact.helix_angle GearContact.place
    add_body.damping_ratio add_rotor.damping_ratio add_gear_contact.damping add_gear_contact.backlash
    Model.mesh.damping Model.mesh.backlash Model.shaft.damping Model.support.damping Model.load.constant
    Model.load.damping Model.load.quadratic Disc.of_steel.bore PlanetarySet.sun_teeth fewest_teeth.gear
    ClassDamage.within.start TransverseTooth.helix_angle TransverseTooth.profile_shift TransverseTooth.tip_alteration
    TransverseTooth.shaper cantilever_tilt.bore pin_stress.bore pin_mass.bore section_stresses.bore TeethSearch.refused
    JointSizing.speed Ask.fastest Ask.relieved on_film.fastest JointSeat.speed TipRelief.stiffness
    TipRelief.tolerance StageTask.deviation ClutchDrive.carried TeethSearch.failing
"""
"""Loads, shifts, bores, angles, dampings and errors that are not there."""

NO = """
    Groove.is_thread LoadStep.static Iso6336._of_sizes.once
    AgmaBevelMaking.is_critical Hardnesses.hard_pinion Hardnesses.hard_wheel MeanSection.is_static
    ShaftSection.hard_surface rim_factor.internal
    Load.static Ask.internal rim_below_roots.internal cylindrical_mesh.internal beyond_ranges.films Joint.is_open
    ClutchDrive.one_way Line.turns_along contact_life_curve.some_pitting
    Needs.every PropellerDrive.beyond Seated.is_machine StageTask.made StageTask.films completed.still settle.still
    CarrierSizing.alone LoadSharing.by_size bevel_size.films LoadSharing.usual MovingBody.held TipRelief.stated
    body_inside.internal
"""
PAIRS_OF_ONE = (
    "AgmaBevelDuty.meshes_per_turn AgmaDuty.meshes_per_turn AgmaMaking.rims MeshDuty.meshes_per_turn"
    " MeshQuality.mean_stresses MeshQuality.rims Ask.passes HobbedPair.addenda quality_of.rims Ask.reverse"
    " quality_of.reverse section_stress.notch section_stresses.notch"
)
PAIRS_OF_NO = "AgmaBevelDuty.is_reversed Ask.idlers Ask.held"
PAIRS_OF_NOTHING = """
    BevelTooth.thickness_shifts HobbedPair.profile_shifts ScuffingMesh.reliefs ToothContact.path
    theoretical_stiffness.profile_shifts Bearing.cross_stiffness Bearing.damping
    Bearing.cross_damping Bearing.axial Bearing.tilting PlanetarySet.backlash rate_row.asked
"""
ENDLESS = """
    AgmaBevelMaking.cutter_radius BevelDuty.cutter_radius ToothContact.base_pitch MachineDrive.highest_torque
    MachineDrive.highest_power Member.support SeatedPart.limit room_between.enough solid_room.enough
    Unloaded.bending_margin
    Unloaded.contact_margin TeethSearch.next_sized_mass with_face.most
"""
"""What is straight, rigid or without a limit."""

OF_STANDARDS = {
    # ISO 53:1998, profile A, and the usual 20°.
    "BasicRack.pressure_angle": math.radians(20.0), "BasicRack.addendum": 1.0, "BasicRack.dedendum": 1.25,
    "BasicRack.fillet_radius": 0.38, "ToothProportions.dedendum": 1.25, "ToothProportions.fillet_radius": 0.38,
    "MeshGeometry.pressure_angle": math.radians(20.0), "BevelPair.pressure_angle": math.radians(20.0),
    "BevelPair.shaft_angle": math.radians(90.0), "BevelTooth.addendum": 1.0, "BevelTooth.dedendum": 1.25,
    "BevelTooth.edge_radii": (0.3, 0.3),
    # AGMA 908-B89: hob of 1.25 with a tip radius of 0.25, 20°, Δs_n = 0.024 over the diametral pitch.
    "HobbedPair.pressure_angle": math.radians(20.0), "HobbedPair.hob_addendum": 1.25, "HobbedPair.hob_radius": 0.25,
    "HobbedPair.thinning": 0.024, "HobbedPair.face_width": 10.0,
    # Steel: ISO 6336-1 206 GPa; AGMA 2003 30 · 10⁶ psi, rounded; DIN 7190 by its own examples.
    "GearSteel.elastic_modulus": 206e9, "GearSteel.poisson_ratio": 0.3, "GearSteel.density": 7830.0,
    "FilmMesh.elastic_modulus": 206e9, "FilmMesh.poisson_ratio": 0.3, "ScuffingMesh.elastic_modulus": 206e9,
    "ScuffingMesh.poisson_ratio": 0.3, "AgmaBevelMaking.elastic_modulus": 207e9, "AgmaBevelMaking.poisson_ratio": 0.3,
    "modulus_factor.steel": 206e9, "mesh_stiffness_kuang_yang.elastic_moduli": (206e9, 206e9),
    "deflection_misalignment.elastic_modulus": 206e9, "module_hertz.poisson_ratio": 0.3,
    "contact_stress.poisson_ratio": 0.3,
    "FitPart.density": 7850.0, "FitPart.poisson_ratio": 0.3, "Segment.elasticity": 206e9,
    "Segment.poisson": 0.3, "Segment.density": 7850.0, "Disc.of_steel.density": 7850.0,
    # Quality: grade 5 of ISO 1328, 6 in scuffing and micropitting, 11 of AGMA; R_z of 4 µm on flanks, 10 µm at roots.
    "MeshQuality.grade": 5, "FilmMesh.grade": 6, "ScuffingMesh.grade": 6, "AgmaMaking.quality": 11,
    "AgmaBevelMaking.quality": 11, "MeshQuality.flank_roughness": 4e-6, "MeshQuality.root_roughness": 10e-6,
    "BevelSurfaces.flank_roughness": 4e-6, "BevelSurfaces.root_roughness": 10e-6, "bevel_bending.roughness": 16e-6,
    "bevel_pitting.roughness": 8e-6, "ShaftSection.roughness": 10e-6,
    # ISO VG 100; oil of 2 kJ/(kg K); 80 °C in AGMA 2003.
    "MeshQuality.viscosity": 100e-6, "BevelSurfaces.viscosity": 100e-6, "bevel_pitting.viscosity": 100e-6,
    "Oil.viscosity_40": 100e-6, "oil_flow.heat_capacity": 2000.0, "AgmaBevelMaking.temperature": 80.0,
    # One failure in 100: K_R = 1 of AGMA; half of the shafts: Shigley's endurance limit without k_e.
    "AgmaMaking.reliability": 0.99, "AgmaBevelMaking.reliability": 0.99, "endurance_limit.reliability": 0.5,
    # ISO/TS 16281: race radii of 0.52 and 0.53 ball diameters; ISO 281: p = 3 of balls, e = 10/9.
    "BearingGeometry.inner_conformity": 0.52, "BearingGeometry.outer_conformity": 0.53, "mean_load.exponent": 3.0,
    "system_life.slope": 10.0 / 9.0,
    # ISO 6336-1: K′ = 0.48 between bearings; c′ of 14 and c_γ of 20 N/(mm µm).
    "PinionShaft.constant": 0.48, "ScuffingMesh.stiffness": (14e9, 20e9),
    "mesh_springs.specific_load": 1e5,
    # ISO 6336-2 and -3, clause 11: 0.85 at 1e10 cycles; a face of ten modules.
    "contact_life_curve.at_1e10": 0.85, "bending_life_curve.at_1e10": 0.85, "knee_curve.at_1e10": 0.85,
    "shifted_mesh.face_width": 10.0,
    # One member between bearings, crowned: K_mb and C_xc of AGMA 2003, K_Hβ-be and e of ISO 10300.
    "AgmaBevelMaking.mounting": 1.1, "AgmaBevelMaking.crowning": 1.5, "BevelDuty.mounting": 1.1,
    "BevelSurfaces.peak_exponent": 1.5, "VirtualPair.peak_exponent": 1.5,
    # λ_M 45 W/(m K), ρ_M 7800 kg/m³, c_M 440 J/(kg K).
    "FilmMesh.thermal": math.sqrt(45.0 * 7800.0 * 440.0),
    # A plate of three tenths of the width between rim and hub of a bevel gear.
    "bevel_way.web": 0.3, "bevel_volume.web": 0.3,
    "GearBlank.rim_ratio": 5.0, "rectangular_curve.step": 0.75,
    # Bearing steel of 7850 kg/m³; splines bear on three of four flanks; ISO/TR 14179-1: 0.0011, 0.003737 N m/mm a seal.
    "rolling_weights.density": 7850.0, "RollerProportions.density": 7850.0, "spline_pressure.share": 0.75,
    "spline_length.share": 0.75, "bearing_torque_constant.friction": 0.0011,
    "seal_power_14179_1.torque_per_mm": 0.003737,
    # SKF: K_rs = 3e-8 of a bath; MIL-PRF-23699: 26 and 5 mm²/s at 40 and 100 °C, 950 kg/m³.
    "bearing_torque_skf.replenishment": 3e-8, "oil_viscosity.grade": (26e-6, 5e-6), "Oil.grade": (26e-6, 5e-6),
    "Oil.density": 950.0, "oil_flow.density": 950.0,
    # ISO 6336-1: steel on steel at F_t K_A/b of 100 N/mm.
    "mesh_stiffness_iso6336.specific_load": 1e5, "mesh_stiffness_iso6336.elastic_moduli": (206e9, 206e9),
    # Neither a force along a shaft nor a radius of a flank.
    "din743_safety.axial": (0.0, 0.0, 0.0), "ToothContact.radii": (math.inf, math.inf),
    # Eight harmonics of a stiffness, forty slices of a shaft.
    "mesh_stiffness_energy.harmonics": 8, "mesh_curve_iso6336.harmonics": 8, "mesh_stiffness_kuang_yang.harmonics": 8,
    "rectangular_curve.harmonics": 8, "lumped_shaft.pieces": 40,
}  # fmt: skip
"""Numbers that their standard, or a catalogue of steels and oils, gives."""

WANTED = {
    "factors of one": dict.fromkeys(FACTORS_OF_ONE.split(), 1.0),
    "nothing": dict.fromkeys(NOTHINGS.split(), 0.0),
    "no": dict.fromkeys(NO.split(), False),
    "pairs of one": dict.fromkeys(PAIRS_OF_ONE.split(), (1.0, 1.0)),
    "pairs of no": dict.fromkeys(PAIRS_OF_NO.split(), (False, False)),
    "pairs of nothing": dict.fromkeys(PAIRS_OF_NOTHING.split(), (0.0, 0.0)),
    "endless": dict.fromkeys(ENDLESS.split(), math.inf),
    "standards": OF_STANDARDS,
}


@functools.cache
def defaults() -> dict[str, list[object]]:
    """Return record or verb and its field or argument -> what it is where it is left out; two may share a name."""
    known: dict[str, list[object]] = {}
    for room in map(importlib.import_module, ROOMS):
        for found in pkgutil.walk_packages(room.__path__, f"{room.__name__}."):
            for owner, thing in vars(importlib.import_module(found.name)).items():
                if getattr(thing, "__module__", "") == found.name:
                    for name, value in _of(owner, thing):
                        known.setdefault(name, []).append(value)
    return known


def _of(owner: str, thing: object) -> Iterator[tuple[str, object]]:
    thing = inspect.unwrap(thing) if callable(thing) else thing  # type: ignore[arg-type]
    if inspect.isclass(thing) and dataclasses.is_dataclass(thing):
        yield from ((f"{owner}.{field.name}", field.default) for field in dataclasses.fields(thing))
    if inspect.isclass(thing):
        yield from ((f"{owner}.{name}", value) for name, value in getattr(thing, "_field_defaults", {}).items())
        for name, method in vars(thing).items():
            if not name.startswith("__"):
                yield from _of(f"{owner}.{name}", getattr(method, "__func__", method))
    elif inspect.isfunction(thing):
        parameters = inspect.signature(thing).parameters.values()
        yield from ((f"{owner}.{parameter.name}", parameter.default) for parameter in parameters)


@pytest.mark.parametrize("meaning", WANTED)
def test_what_is_left_out_is_neutral_or_a_standards_number(meaning):
    wrong = {}
    for name, value in WANTED[meaning].items():
        numbers = [default for default in defaults().get(name, ()) if isinstance(default, int | float | tuple)]
        if not numbers or any(number != pytest.approx(value, rel=1e-12, abs=0.0) for number in numbers):
            wrong[name] = numbers
    assert wrong == {}


def test_every_number_that_is_taken_where_nothing_is_said_is_in_these_tables():
    told = {name for names in WANTED.values() for name in names}
    untold = {
        name
        for room in ROOMS
        for found in pkgutil.walk_packages(importlib.import_module(room).__path__, f"{room}.")
        for owner, thing in vars(importlib.import_module(found.name)).items()
        if getattr(thing, "__module__", "") == found.name and not owner.startswith("_")
        for name, value in _of(owner, thing)
        if isinstance(value, int | float) or (isinstance(value, tuple) and value and isinstance(value[0], int | float))
    }
    assert untold <= told
