"""Pieces of the ratings of bevel gears, ISO 10300 and AGMA 2003, without a sizing: widths, limits, inputs."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from gearwright.parts.iso6336 import Treatment
from gearwright.parts.iso10300 import BOTH_OVERHUNG, ONE_OVERHUNG, STRADDLE
from gearwright.sizing.rating.agma import bevel_making_of
from gearwright.sizing.rating.geometry import bevel_pair, bevel_width
from gearwright.sizing.rating.iso6336_inputs import steel_of
from gearwright.sizing.rating.iso10300 import bevel_duty, bevel_surfaces, limited as bevel_limited
from gearwright.sizing.rating.protocol import Factor
from rated_pieces import METHODS, near, rating


@pytest.mark.parametrize("is_open", [False, True])
def test_widths_of_bevel_pairs_end_at_the_widest_or_at_the_safeties(is_open):
    """b of λ = b/m_mn: b = λ m_et cos β (1 − b/(2 R_e))."""
    own = rating("iso10300")
    own = replace(own, rules=own.rules.model_copy(update={"face_width_ratio": None if is_open else 8.0}))
    cosine, cone = math.cos(own.helix_angle), 4e-3 * math.hypot(17, 43) / 2.0
    tried = []

    def gap(module, width):
        tried.append((module, width))
        return width / 20.3e-3

    found = bevel_width((17, 43), 4e-3, 8.0, own, gap)
    if is_open:
        assert found == near(21e-3)
        assert all(m == near(cosine * (4e-3 - b * 4e-3 / (2.0 * cone))) for m, b in tried)
        enough = bevel_width((17, 43), 4e-3, 8.0, own, lambda module, width: 2.0)
        widest = 8.0 * 4e-3 * cosine / (1.0 + 8.0 * 4e-3 * cosine / (2.0 * cone))
        mean = cosine * (4e-3 - widest * 4e-3 / (2.0 * cone))
        least = own.rules.overlap_ratio * math.pi * mean / math.sin(own.helix_angle)
        assert enough == near(1e-3 * math.ceil(1e3 * least))
    else:
        assert found == near(8.0 * 4e-3 * cosine * (1.0 - found / (2.0 * cone))) and not tried


@pytest.mark.parametrize(
    ("eased", "words"), [(1.0, "K_F0 least, or straight teeth"), (1.15, "K_F0 greatest"), (1.08, "")]
)
@pytest.mark.parametrize(
    ("strength", "film"),
    [
        (850e6, "σ_Hlim counts as 850"),
        (1000e6, ""),
        (1200e6, "σ_Hlim counts as 1200"),
        (1500e6, "σ_Hlim counts as 1200"),
    ],
)
def test_every_clamp_of_iso_10300_is_named_at_its_value_and_nowhere_else(eased, words, strength, film):
    steel = replace(steel_of(rating("iso6336")), contact_strength=strength, treatment=Treatment.CASE_HARDENED)
    loads = SimpleNamespace(face_contact=1.65, face_bending=1.65 / eased)
    rated = SimpleNamespace(
        loads=loads, pitting=SimpleNamespace(film=(0.91, 0.93)), cycles=(1e9, 2e10), contact_life=(0.9, 0.83),
        root_life=(0.9, 0.84),
    )  # fmt: skip
    clamps = [
        ("load factors", "transverse contact", 1.0, "least"), ("load factors", "transverse bending", 1.0, "least"),
        ("tooth root", "contact ratio", 0.625, "least: ε_vβ from 1"), ("tooth root", "spiral", 1.0, "straight teeth"),
        ("tooth root", "size", 1.0, "greatest"), ("tooth root", "size", 0.8, "least"),
        ("tooth root", "size", 0.85, "least"),
        ("mesh", "contact life", 1.6, "greatest: static"), ("mesh", "contact life", 0.83, "beyond 1e10 cycles"),
        ("mesh", "root life", 2.5, "greatest: static"), ("mesh", "root life", 0.84, "beyond 1e10 cycles"),
        ("load factors", "face bending", 1.65 / eased, words), ("pitting", "film", 0.91, film),
    ]  # fmt: skip
    for chapter, quantity, value, expected in clamps:
        row = Factor(chapter, quantity, "", (value,), "ratio", "")
        at, beside = bevel_limited([row, replace(row, values=(value * 1.001,))], rated, steel)  # type: ignore[arg-type]
        assert (at.limit, beside.limit) == (expected, "")


def test_what_iso_10300_is_told_of_a_stage():
    for name, mounting in (("straddle", STRADDLE), ("one-overhung", ONE_OVERHUNG), ("both-overhung", BOTH_OVERHUNG)):
        own = rating("iso10300")
        rules = own.rules.iso6336.model_copy(
            update={"mounting": name, "profile_crowning": "low", "oil_viscosity": 150.0}
        )
        own = replace(own, rules=own.rules.model_copy(update={"iso6336": rules, "cutter_radius": None}))
        pair = bevel_pair((17, 43), 4e-3, 30e-3, own)
        duty = bevel_duty(own, pair, 321.0, 45.0)
        assert (duty.mounting, duty.cutter_radius) == (mounting, math.inf)
        assert (duty.pinion_torque, duty.pinion_speed) == (321.0, 45.0)
        surfaces = bevel_surfaces(own)
        assert (surfaces.peak_exponent, surfaces.viscosity) == (3.0, near(150e-6))
        high = own.rules.model_copy(update={"iso6336": rules.model_copy(update={"profile_crowning": "high"})})
        assert bevel_surfaces(replace(own, rules=high)).peak_exponent == 1.5


def test_making_of_bevel_gears_by_agma_2003():
    own = rating("agma2003")
    changed = {"steel": "through-hardened", "grade": 1, "hardness_hb": 300.0, "wheel_hardness_hb": 240.0}
    rules = own.rules.agma2003.model_copy(update=changed | {"crowned": False, "mounting": "both-overhung"})
    told = replace(own, rules=own.rules.model_copy(update={"agma2003": rules, "cutter_radius": 0.1}))
    making = bevel_making_of(told)
    assert making.hardnesses == (300.0, 240.0)
    assert (making.crowning, making.mounting, making.cutter_radius) == (2.0, 1.25, 0.1)
    psi = 6894.757
    assert making.strengths[0].bending == pytest.approx((44.0 * 300.0 + 2100.0) * psi, rel=1e-6)
    assert making.strengths[1].contact == pytest.approx((341.0 * 240.0 + 23620.0) * psi, rel=1e-6)
    same = replace(
        told, rules=told.rules.model_copy(update={"agma2003": rules.model_copy(update={"wheel_hardness_hb": None})})
    )
    assert bevel_making_of(same).hardnesses == (300.0, 300.0)
    carburised = rules.model_copy(update={"steel": "carburised", "crowned": True})
    usual = bevel_making_of(
        replace(own, rules=own.rules.model_copy(update={"agma2003": carburised, "cutter_radius": None}))
    )
    assert usual.hardnesses is None and (usual.crowning, usual.cutter_radius) == (1.5, math.inf)


@pytest.mark.parametrize("method", ["iso10300", "agma2003"])
@pytest.mark.parametrize("teeth", [(17, 43), (30, 90), (20, 25)])
def test_bevel_widths_are_three_tenths_of_the_cone_and_ten_modules_at_most(method, teeth):
    """b = 0.30 R_e, at most 10 m_et; λ = b/m_mn, m_mn = m_et cos β (1 − b/(2 R_e))."""
    own = rating(method)
    cone = math.hypot(*teeth) / 2.0
    width = min(0.3 * cone, 10.0)
    mean = math.cos(own.helix_angle) * (1.0 - width / (2.0 * cone))
    found = METHODS[method].width_ratio(own, *(np.array([z]) for z in teeth))
    assert float(found[0]) == near(width / mean)
