"""Mesh stiffness against the mesh phase: by ISO 6336-1, by strain energy, by closed forms.

What it does to a train is for `dynamics`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearwright.base import DesignError, Floats, Problem, refuse
from gearwright.parts.gears import (
    BasicRack,
    CylindricalGear,
    GearPair,
    ToothForm,
    contact_radii,
    load_point,
    tooth_form,
    virtual_teeth,
)
from gearwright.parts.material import STEEL_MODULUS, Material

# ----------------------------------------------------------------------------------------------------------------------
# The one form in which every mesh stiffness model hands over its result: a Fourier series in the mesh phase.
#
# The mesh phase φ grows by 2π per tooth in the direction of the drive and is zero when a tooth pair touches at the
# pitch point (at mid face for helical teeth). Written in an angle, not in time, it stays right while speeds change.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class StiffnessCurve:
    """A mesh stiffness along the line of action, k(φ) = mean + Σ cosine_n cos nφ + sine_n sin nφ."""

    mean: float
    """Mean stiffness [N/m]."""
    cosine: tuple[float, ...] = ()
    """Cosine coefficients of harmonics 1, 2, … of the mesh phase [N/m]."""
    sine: tuple[float, ...] = ()
    """Sine coefficients of the same harmonics [N/m]."""
    source: str = ""
    """Model and clause that made the curve."""

    def __post_init__(self) -> None:
        if len(self.cosine) != len(self.sine):
            message = f"{len(self.cosine)} cosine and {len(self.sine)} sine coefficients given; give as many of each"
            raise DesignError([Problem("stiffness", message)])
        if not all(math.isfinite(value) for value in (self.mean, *self.cosine, *self.sine)):
            raise DesignError([Problem("stiffness", "a coefficient is not a finite number")])
        lowest, phase = _lowest(self)
        if not lowest > 0.0:
            message = (
                f"{lowest:.4g} N/m at mesh phase {phase:.3f} rad; a stiffness must be positive: lower the harmonics"
            )
            raise DesignError([Problem("stiffness", message)])


def stiffness_at(curve: StiffnessCurve, phase: ArrayLike) -> Floats:
    """Return the stiffness at given mesh phases.

    Args:
        curve: The curve.
        phase: Mesh phases φ [rad], any shape.

    Returns:
        k [N/m], shape of `phase`.

    Source: definition of the Fourier series.
    """
    angle = np.asarray(phase, dtype=np.float64)
    order = np.arange(1, len(curve.cosine) + 1)
    terms = np.multiply.outer(angle, order)
    return np.asarray(curve.mean + np.cos(terms) @ np.array(curve.cosine) + np.sin(terms) @ np.array(curve.sine))


def curve_of(coefficients: NDArray[Any], source: str) -> StiffnessCurve:
    """Return the curve with given complex Fourier coefficients.

    Args:
        coefficients: Coefficients c_n of e^(i n φ), n = 0, 1, … [N/m], shape (harmonics + 1,).
        source: Model that made them.

    Source: k = c_0 + Σ 2 Re c_n cos nφ − 2 Im c_n sin nφ.
    """
    waves = coefficients[1:]
    cosine, sine = (2.0 * waves.real).tolist(), (-2.0 * waves.imag).tolist()
    return StiffnessCurve(float(coefficients[0].real), tuple(cosine), tuple(sine), source)


def sampled_curve(phase: ArrayLike, stiffness: ArrayLike, *, harmonics: int, source: str) -> StiffnessCurve:
    """Return a user's own curve, given as points over one mesh cycle and joined by straight lines.

    Args:
        phase: Mesh phases [rad], shape (n,), increasing; the cycle closes 2π after the first.
        stiffness: Stiffness at them [N/m], shape (n,), positive. A last point one cycle after the first must repeat it.
        harmonics: Harmonics of the mesh phase to keep [-].
        source: Where the points come from.

    Returns:
        The exact Fourier coefficients of the polygon.

    Source: from the jumps of slope, c_n = −Σ Δs_i e^(−i n φ_i) / (2π n²).

    Raises:
        DesignError: for points that do not increase, are not positive or do not close.
    """
    x, y = np.asarray(phase, dtype=np.float64), np.asarray(stiffness, dtype=np.float64)
    refuse(_sample_problems(x, y))
    if not math.isclose(x[-1] - x[0], 2.0 * math.pi, rel_tol=1e-9):
        x, y = np.append(x, x[0] + 2.0 * math.pi), np.append(y, y[0])
    slope = np.diff(y) / np.diff(x)
    jump = slope - np.roll(slope, 1)
    order = np.arange(1, harmonics + 1)
    waves = -(np.exp(-1j * np.outer(order, x[:-1])) @ jump) / (2.0 * np.pi * order**2)
    mean = float(np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(x))) / (2.0 * math.pi)
    return curve_of(np.concatenate(([mean], waves)), source)


def _lowest(curve: StiffnessCurve) -> tuple[float, float]:
    """Lowest stiffness of a fine sampling of one cycle [N/m] and its phase [rad]."""
    phase = np.linspace(0.0, 2.0 * np.pi, 32 * len(curve.cosine) + 1)
    stiffness = stiffness_at(curve, phase)
    lowest = int(np.argmin(stiffness))
    return float(stiffness[lowest]), float(phase[lowest])


def _sample_problems(x: Floats, y: Floats) -> list[Problem]:
    """What is wrong with a user's points."""
    if x.ndim != 1 or x.shape != y.shape or x.size < 3:
        return [
            Problem("phase", f"shapes {x.shape} and {y.shape} given; give at least 3 phases and as many stiffnesses")
        ]
    problems = []
    if not (np.all(np.isfinite(x)) and np.all(np.diff(x) > 0.0)):
        problems.append(Problem("phase", "the phases must be finite and increase from point to point"))
    elif x[-1] - x[0] > 2.0 * math.pi * (1.0 + 1e-9):
        problems.append(Problem("phase", f"the phases cover {x[-1] - x[0]:.4g} rad; one mesh cycle is 2π"))
    elif math.isclose(x[-1] - x[0], 2.0 * math.pi, rel_tol=1e-9) and not math.isclose(y[0], y[-1], rel_tol=1e-6):
        problems.append(
            Problem("stiffness", f"{y[0]:.6g} N/m at the start and {y[-1]:.6g} N/m one cycle later: not periodic")
        )
    if not (np.all(np.isfinite(y)) and np.all(y > 0.0)):
        index = int(np.argmax(~(y > 0.0)))
        problems.append(
            Problem("stiffness", f"point {index}: {y[index]:.6g} N/m given; a stiffness must be positive and finite")
        )
    return problems


# ----------------------------------------------------------------------------------------------------------------------
# Mesh stiffness as the sum of tooth pairs that pass through the path of contact one base pitch after another.
#
# Places on the path are counted in base pitches from the pitch point, in the direction in which the contact moves.
# ----------------------------------------------------------------------------------------------------------------------


def pair_curve(
    ends: tuple[float, float], stiffness: Callable[[Floats], Floats], *, overlap: float, harmonics: int, source: str
) -> StiffnessCurve:
    """Return the mesh stiffness that passing tooth pairs add up to.

    Args:
        ends: Start and end of contact, in base pitches from the pitch point [-].
        stiffness: Stiffness of one pair over its whole face width [N/m] at places in base pitches from the pitch point.
        overlap: Overlap ratio ε_β of helical teeth, 0 for spur [-].
        harmonics: Harmonics of the mesh phase to keep [-].
        source: Model of the pair stiffness.

    Returns:
        Its coefficients are the exact integrals ∫ k(τ) e^(−2πi n τ) dτ over the path of contact; slices of a helical
        tooth follow each other by ε_β pitches across the face, which multiplies harmonic n by sinc(n ε_β).

    Source: Poisson's sum of shifted pairs; slicing as Wan et al. 2015, Mech. Mach. Theory 92, without
        coupling between slices.
    """
    start, end = ends
    _check_contact(end - start + overlap)
    # Gauss needs half a point per radian of the highest harmonic; 24 more carry the pair stiffness itself.
    nodes, weights = np.polynomial.legendre.leggauss(24 + math.ceil(2.0 * harmonics * (end - start)))
    place = 0.5 * (start + end) + 0.5 * (end - start) * nodes
    order = np.arange(harmonics + 1)
    weighted = 0.5 * (end - start) * weights * stiffness(place)
    coefficients = np.exp(-2j * np.pi * np.outer(order, place)) @ weighted * np.sinc(order * overlap)
    return curve_of(coefficients, source)


def summed_pairs(ends: tuple[float, float], stiffness: Callable[[Floats], Floats], phase: ArrayLike) -> Floats:
    """Return the stiffness of passing spur tooth pairs at given mesh phases, jumps and all, without a Fourier series.

    Args:
        ends: Start and end of contact, in base pitches from the pitch point [-].
        stiffness: Stiffness of one pair over its whole face width [N/m] at places in base pitches from the pitch point.
        phase: Mesh phases φ [rad], shape (n,).

    Returns:
        k [N/m], shape (n,): what a figure shows beside the series that the dynamics keeps.

    Source: definition, k(φ) = Σ_j k_pair(φ/2π + j) over the pairs between the ends.
    """
    start, end = ends
    _check_contact(end - start)
    first = np.asarray(phase, dtype=np.float64) / (2.0 * np.pi)
    first = first - np.floor(first - start)  # the first pair after the start of contact
    total = np.zeros_like(first)
    for pair in range(math.ceil(end - start)):
        place = first + pair
        touching = place <= end
        total[touching] += stiffness(place[touching])
    return total


def rectangular_curve(
    single: float, ends: tuple[float, float], *, step: float = 0.75, overlap: float = 0.0, harmonics: int = 8
) -> StiffnessCurve:
    """Return the two-level curve of ISO 6336-1: c′ with one pair in contact, c′ (1 + 0.75) with two.

    Args:
        single: Stiffness of one pair in single contact, c′ b [N/m].
        ends: Start and end of contact, in base pitches from the pitch point [-].
        step: What each further pair adds, as a part of `single` [-].
        overlap: Overlap ratio ε_β [-].
        harmonics: Harmonics of the mesh phase to keep [-].

    Returns:
        A curve whose mean is c_γ b = c′ b (0.75 ε_α + 0.25).

    Source: ISO 6336-1:2006, clause 9; the levels are the only ones whose mean gives c_γα for every 1 ≤ ε_α ≤ 2.
    """
    start, end = ends
    _check_contact(end - start + overlap)
    order = np.arange(1, harmonics + 1)
    wave = np.exp(-2j * np.pi * order * end) - np.exp(-2j * np.pi * order * start)
    pairs = np.concatenate(([end - start], 1j * wave / (2.0 * np.pi * order) * np.sinc(order * overlap)))
    coefficients = single * step * pairs
    coefficients[0] += single * (1.0 - step)
    return curve_of(coefficients, "ISO 6336-1:2006, two levels")


def _check_contact(ratio: float) -> None:
    """Refuse a total contact ratio below 1: some of the time no tooth would touch."""
    if not ratio >= 1.0:
        message = f"{ratio:.3f} given; a mesh needs at least 1: longer teeth, less profile shift or more overlap"
        raise DesignError([Problem("contact_ratio", message)])


# ----------------------------------------------------------------------------------------------------------------------
# Mesh stiffness per unit face width by ISO 6336-1: the default, fitted to measured gears.
#
# Stiffnesses are in N/m per metre of face width; 1 N/(mm µm) = 1e9 N/m².
# ----------------------------------------------------------------------------------------------------------------------


_C = (0.04723, 0.15551, 0.25791, -0.00635, -0.11654, -0.00193, -0.24188, 0.00529, 0.00182)
"""Coefficients C_1 to C_9 of the least flexibility q′ in mm µm/N (ISO 6336-1:2006, clause 9, method B)."""
_UNIT = 1e9  # N/(mm µm) in N/m²
THEORY_TO_MEASUREMENT = 0.8
"""Correction factor C_M [-] (ISO 6336-1:2006, clause 9)."""
LINEAR_LOAD = 100e3
"""Specific load F_t K_A / b from which load no longer matters [N/m] (ISO 6336-1:2006, clause 9)."""


@dataclass(frozen=True)
class GearBlank:
    """The body that carries the teeth."""

    web_ratio: float = 1.0
    """Web thickness over face width b_s/b [-]; 1: solid disc."""
    rim_ratio: float = 5.0
    """Rim thickness over normal module s_R/m_n [-]; without effect on a solid disc."""


SOLID = GearBlank()
"""A solid disc, C_R = 1."""


@dataclass(frozen=True)
class MeshStiffness:
    """Stiffnesses of a mesh per unit face width, in the transverse plane along the line of action."""

    theoretical: float
    """Theoretical single stiffness c′_th [N/m²]."""
    single: float
    """Single stiffness of one tooth pair c′ [N/m²]."""
    mesh: float
    """Mean mesh stiffness c_γα [N/m²], for dynamic and transverse load factors."""
    face: float
    """Mean mesh stiffness c_γβ = 0.85 c_γα [N/m²], for the face load factor."""


def theoretical_stiffness(teeth: tuple[float, float], profile_shifts: tuple[float, float] = (0.0, 0.0)) -> float:
    """Return the theoretical single stiffness c′_th of a pair of solid steel spur gears.

    The regression for q′ has one set of coefficients for the pinion and one for the wheel: the gear with fewer teeth
    counts as the pinion, whichever drives; of equal ones that with the larger shift.

    Args:
        teeth: Virtual numbers of teeth z_n of both gears [-], or arrays of them; infinite for an internal gear.
        profile_shifts: x of both [-].

    Returns:
        c′_th [N/m²], from the least flexibility q′.

    Source: ISO 6336-1:2006, clause 9, 1/q′; index 1 is the pinion, 2 the wheel.
    Valid for: x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2.

    >>> round(theoretical_stiffness((18.905, 114.543), (0.145, 0.0)) / 1e9, 4)
    17.8558
    """
    (z_1, z_2), (x_1, x_2), c = *_pinion_first(teeth, profile_shifts), _C
    flexibility = c[0] + c[1] / z_1 + c[2] / z_2 + c[3] * x_1 + c[4] * x_1 / z_1
    flexibility += c[5] * x_2 + c[6] * x_2 / z_2 + c[7] * x_1**2 + c[8] * x_2**2
    stiffness = _UNIT / flexibility
    return cast(float, stiffness if np.ndim(stiffness) else float(stiffness))  # arrays pass through


def _pinion_first(
    teeth: tuple[float, float], shifts: tuple[float, float]
) -> tuple[tuple[Floats, Floats], tuple[Floats, Floats]]:
    z_1, z_2, x_1, x_2 = (np.asarray(value, dtype=np.float64) for value in (*teeth, *shifts))
    turned = (z_1 > z_2) | ((z_1 == z_2) & (x_1 < x_2))
    ordered = [(np.where(turned, b, a), np.where(turned, a, b)) for a, b in ((z_1, z_2), (x_1, x_2))]
    return ordered[0], ordered[1]


def blank_factor(blank: GearBlank) -> float:
    """Return the gear blank factor C_R.

    Args:
        blank: The gear's body.

    Returns:
        C_R [-]; 1 for a solid disc.

    Source: ISO 6336-1:2006, clause 9, C_R = 1 + ln(b_s/b) / (5 e^(s_R/(5 m_n))).
    Valid for: 0.2 ≤ b_s/b ≤ 1.2 and s_R/m_n ≥ 1; beyond them the standard takes the limits.
    """
    web = min(max(blank.web_ratio, 0.2), 1.2)
    return 1.0 + math.log(web) / (5.0 * math.exp(max(blank.rim_ratio, 1.0) / 5.0))


def rack_factor(first: BasicRack, second: BasicRack) -> float:
    """Return the basic rack factor C_B of a pair, the mean of its two gears'.

    Args:
        first: Basic rack of one gear.
        second: Basic rack of the other.

    Returns:
        C_B [-].

    Source: ISO 6336-1:2006, clause 9, C_B = [1 + 0.5 (1.2 − h_fP/m_n)] [1 − 0.02 (20° − α_Pn)].

    >>> from gearwright.parts.gears import ISO53_A
    >>> round(rack_factor(ISO53_A, ISO53_A), 4)
    0.975
    """
    return 0.5 * sum(
        (1.0 + 0.5 * (1.2 - rack.dedendum)) * (1.0 - 0.02 * (20.0 - math.degrees(rack.pressure_angle)))
        for rack in (first, second)
    )


def load_factor(specific_load: float) -> float:
    """Return by how much a light load lowers the single stiffness.

    Args:
        specific_load: F_t K_A / b [N/m].

    Returns:
        1 from 100 N/mm upwards, below it (F_t K_A / b / 100 N/mm)^0.25 [-].

    Source: ISO 6336-1:2006, clause 9.
    """
    if not specific_load > 0.0:
        message = f"{specific_load:.6g} N/m given; must be above 0, or leave it out for 100 N/mm and more"
        raise DesignError([Problem("specific_load", message)])
    return float(min(1.0, (specific_load / LINEAR_LOAD) ** 0.25))


def modulus_factor(elastic_moduli: tuple[float, float], steel: float = STEEL_MODULUS) -> float:
    """Return E/E_St, by which c′ of other materials than steel differs [-].

    Args:
        elastic_moduli: Young's moduli of the two gears [Pa].
        steel: E_St [Pa].

    Source: ISO 6336-1:2006, clause 9, E = 2 E_1 E_2/(E_1 + E_2), E_St = 206 000 N/mm².

    >>> round(modulus_factor((206e9, 173e9)), 4)  # steel on nodular iron
    0.9129
    """
    first, second = elastic_moduli
    return 2.0 * first * second / (first + second) / steel


def mesh_stiffness_iso6336(
    pair: GearPair,
    *,
    blank: GearBlank = SOLID,
    specific_load: float = LINEAR_LOAD,
    elastic_moduli: tuple[float, float] = (STEEL_MODULUS, STEEL_MODULUS),
) -> MeshStiffness:
    """Return c′ and c_γ of a mesh by method B of ISO 6336-1.

    Args:
        pair: External or internal pair.
        blank: The less stiff of the two bodies.
        specific_load: F_t K_A / b [N/m]; matters below 100 N/mm.
        elastic_moduli: Young's moduli of the two gears [Pa].

    Returns:
        c_γα = c′ (0.75 ε_α + 0.25), c_γβ = 0.85 c_γα.

    Source: ISO 6336-1:2006, clause 9; an internal gear counts as z_n = ∞; other materials by E = 2 E_1 E_2/(E_1 + E_2).
    Valid for: β ≤ 45°, ε_α from 1.2 to 1.9 (higher is taken as it is), −0.5 ≤ x_1 + x_2 ≤ 2.

    Raises:
        DesignError: outside the ranges of β, x_1 + x_2 and below ε_α = 1.
    """
    refuse(_outside(pair))
    driver, driven = pair.driver, pair.driven
    z_1, z_2 = (virtual_teeth(gear.teeth, gear.rack.pressure_angle, gear.helix_angle) for gear in (driver, driven))
    x_1, x_2 = driver.profile_shift, driven.profile_shift
    if pair.side < 0:
        z_2 = math.inf
    theoretical = theoretical_stiffness((z_1, z_2), (x_1, x_2))
    factor = THEORY_TO_MEASUREMENT * blank_factor(blank) * rack_factor(driver.rack, driven.rack)
    single = theoretical * factor * math.cos(driver.helix_angle) * load_factor(specific_load)
    single *= modulus_factor(elastic_moduli)
    mesh = single * (0.75 * pair.transverse_contact_ratio + 0.25)
    return MeshStiffness(theoretical, single, mesh, 0.85 * mesh)


def mesh_curve_iso6336(pair: GearPair, stiffness: MeshStiffness, *, harmonics: int = 8) -> StiffnessCurve:
    """Return the two-level mesh stiffness that c′ and ε_α imply: c′ b in single, 1.75 c′ b in double contact.

    Args:
        pair: The pair.
        stiffness: Its stiffnesses from `mesh_stiffness_iso6336`.
        harmonics: Harmonics of the mesh phase to keep [-]; 0 gives the constant c_γα b.

    Source: see `rectangular_curve`; helical teeth in slices without coupling.
    """
    pitch = pair.driver.base_pitch
    ends = (-pair.approach / pitch, pair.recess / pitch)
    single = stiffness.single * pair.face_width
    return rectangular_curve(single, ends, overlap=pair.overlap_ratio, harmonics=harmonics)


def _outside(pair: GearPair) -> list[Problem]:
    """What lies outside the method's range."""
    total = pair.driver.profile_shift + pair.driven.profile_shift
    problems = []
    if pair.driver.helix_angle > math.radians(45.0):
        degrees = math.degrees(pair.driver.helix_angle)
        problems.append(Problem("helix_angle", f"{degrees:.4g}° given; ISO 6336-1 allows at most 45°"))
    if not -0.5 <= total <= 2.0:
        problems.append(Problem("profile_shift", f"x_1 + x_2 = {total:.4g}; ISO 6336-1 allows −0.5 to 2"))
    ratio = pair.transverse_contact_ratio
    if not ratio >= 1.0:
        problems.append(Problem("", f"contact ratio {ratio:.3f}; a mesh needs at least 1: longer teeth or less shift"))
    return problems


# ----------------------------------------------------------------------------------------------------------------------
# Two closed forms of mesh stiffness: Kuang & Yang's single tooth, and a cut square wave.
#
# They are here to be compared with; `mesh_stiffness_iso6336` is the default.
# ----------------------------------------------------------------------------------------------------------------------


KUANG_YANG_TEETH = (12, 50)
"""Numbers of teeth for which the cubics are trusted [-]: A_0 falls 19 % from z = 40 to 80; real teeth get stiffer."""
_CUBICS = (
    (3.867, 1.612, -0.02916, 0.0001553),
    (17.060, 0.7289, -0.01728, 0.0000993),
    (2.637, -1.222, 0.02217, -0.0001179),
    (-6.330, -1.033, 0.02068, -0.0001130),
)
"""A_0 to A_3 as cubics of z, N/(µm mm). The thesis prints 0.00009993 and 0.0001179 for the last two of A_1 and A_3."""


def tooth_stiffness_kuang_yang(teeth: int, radius_offset: ArrayLike, profile_shift: float = 0.0) -> Floats:
    """Return the stiffness of one tooth of a steel spur gear per unit face width.

    Args:
        teeth: Number of teeth z [-].
        radius_offset: Radius of the load less the reference radius, in modules [-], any shape.
        profile_shift: Profile shift coefficient X [-].

    Returns:
        K [N/m²], shape of `radius_offset`.

    Source: Kuang & Yang 1992, Int. Power Transmission and Gearing Conf., ASME; Pulvirenti 2023, eq. (3.18) to (3.22)
        with the factor 10⁹ on the whole sum and (1 + X) in the denominator.
    Valid for: external, 20° full depth, 12 ≤ z ≤ 50 and |X| ≤ 0.6.

    Raises:
        DesignError: outside that range.

    >>> round(float(tooth_stiffness_kuang_yang(20, 0.0)) / 1e9, 4)
    25.6854
    """
    fewest, most = KUANG_YANG_TEETH
    problems = []
    if not fewest <= teeth <= most:
        problems.append(
            Problem("teeth", f"{teeth} given; Kuang & Yang's fit holds from {fewest} to {most}: use ISO 6336-1")
        )
    if abs(profile_shift) > 0.6:
        problems.append(
            Problem("profile_shift", f"{profile_shift:.3g} given; Kuang & Yang's fit holds from −0.6 to 0.6")
        )
    refuse(problems)
    a_0, a_1, a_2, a_3 = (sum(c * teeth**n for n, c in enumerate(cubic)) for cubic in _CUBICS)
    x = profile_shift
    return np.asarray(_UNIT * ((a_0 + a_1 * x) + (a_2 + a_3 * x) * np.asarray(radius_offset) / (1.0 + x)))


def mesh_stiffness_kuang_yang(
    pair: GearPair, *, harmonics: int = 8, elastic_moduli: tuple[float, float] = (STEEL_MODULUS, STEEL_MODULUS)
) -> StiffnessCurve:
    """Return the time-varying stiffness of two teeth in series by Kuang and Yang, pairs in contact added.

    Args:
        pair: External spur pair.
        harmonics: Harmonics of the mesh phase to keep [-].
        elastic_moduli: E of driver and driven gear [Pa]; a tooth is as stiff as its E beside that of steel.

    Source: Kuang & Yang 1992; Pulvirenti 2023, eq. (3.23). No Hertzian deflection.
    Valid for: as `tooth_stiffness_kuang_yang`.
    """
    if pair.side < 0 or pair.driver.helix_angle > 0.0:
        raise DesignError(
            [Problem("", "Kuang & Yang's fit holds for external spur pairs: use ISO 6336-1 or the energy method")]
        )
    pitch = pair.driver.base_pitch

    def single(place: Floats) -> Floats:
        radii = np.array([contact_radii(pair, float(s) * pitch) for s in place]).T
        teeth = zip((pair.driver, pair.driven), radii, elastic_moduli, strict=True)
        first, second = (modulus / STEEL_MODULUS * _tooth(gear, r) for gear, r, modulus in teeth)
        return pair.face_width * first * second / (first + second)

    return pair_curve(
        (-pair.approach / pitch, pair.recess / pitch),
        single,
        overlap=0.0,
        harmonics=harmonics,
        source="Kuang & Yang 1992",
    )


def cut_square_wave(mean: float) -> StiffnessCurve:
    """Return a variable stiffness: a square wave of ± a quarter of the mean, cut at its fifth harmonic.

    Args:
        mean: Mean mesh stiffness K [N/m].

    Returns:
        K + (K/π) (sin φ + sin 3φ/3 + sin 5φ/5); contact ratio and levels of the real teeth are not in it.

    Source: Pulvirenti 2023, eq. (3.35), written in the mesh phase.
    """
    sine = tuple(mean / (math.pi * n) if n % 2 else 0.0 for n in range(1, 6))
    return StiffnessCurve(mean, (0.0,) * 5, sine, "Pulvirenti 2023, eq. (3.35)")


def _tooth(gear: CylindricalGear, radius: Floats) -> Floats:
    """Stiffness of a gear's tooth at given radii [N/m²]."""
    return tooth_stiffness_kuang_yang(gear.teeth, (radius - gear.pitch_radius) / gear.module, gear.profile_shift)


# ----------------------------------------------------------------------------------------------------------------------
# How far one tooth gives under load: a cantilever of its true outline, fillet included, on an elastic body.
# ----------------------------------------------------------------------------------------------------------------------


SHEAR_FACTOR = 1.2
"""Shear coefficient of a rectangular section [-] (Tian 2004)."""
_SECTIONS = 24  # Gauss points along the tooth; 96 change a compliance by less than 1e-4

_BODY = np.array(
    [
        [-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045],
        [60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086],
        [-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236],
        [-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904],
    ]
)
"""Rows L*, M*, P*, Q*; columns A to F (Sainsot, Velex & Duverger 2004, table 1)."""


@dataclass(frozen=True)
class ToothCompliance:
    """Deflection of one tooth per unit normal force and unit length of contact, at given contact points."""

    bending: Floats
    """Bending of the cantilever [m²/N], shape (n,)."""
    shear: Floats
    """Shear [m²/N], shape (n,)."""
    compression: Floats
    """Compression along the tooth's centre line [m²/N], shape (n,)."""
    foundation: Floats
    """Tilt and shift of the tooth's root in the gear body [m²/N], shape (n,)."""

    @property
    def total(self) -> Floats:
        """Sum [m²/N], shape (n,)."""
        return self.bending + self.shear + self.compression + self.foundation


def tooth_compliance(
    form: ToothForm, radius: Floats, *, material: Material, bore_radius: float | None = None
) -> ToothCompliance:
    """Return the compliance of one tooth loaded at given radii.

    Args:
        form: Outline of the tooth.
        radius: Radii of the equivalent spur gear at which the flank is touched [m], shape (n,).
        material: For E and ν; plane stress.
        bore_radius: Radius at which an external gear's body is held [m]; None: the tooth stands on a half plane.

    Source: Yang & Lin 1987 (bending, compression), Tian 2004 (shear); for the foundation see `half_plane_foundation`
        and `held_body_foundation`.
    """
    height, half, angle = load_point(form, radius)
    nodes, weights = np.polynomial.legendre.leggauss(_SECTIONS)
    section = np.outer(height, 0.5 * (1.0 + nodes))
    step = np.outer(height, 0.5 * weights)
    width = 2.0 * np.interp(section, form.height, form.half_thickness)
    cosine, sine = np.cos(angle), np.sin(angle)
    moment = cosine[:, None] * (height[:, None] - section) - (sine * half)[:, None]
    young = material.elastic_modulus
    if bore_radius is None:
        foundation = half_plane_foundation(form, radius, material=material)
    else:
        foundation = held_body_foundation(form, radius, material=material, bore_radius=bore_radius)
    return ToothCompliance(
        bending=np.sum(step * 12.0 * moment**2 / width**3, axis=1) / young,
        shear=SHEAR_FACTOR * cosine**2 * np.sum(step / width, axis=1) / material.shear_modulus,
        compression=sine**2 * np.sum(step / width, axis=1) / young,
        foundation=foundation,
    )


def half_plane_foundation(form: ToothForm, radius: Floats, *, material: Material) -> Floats:
    """Return the compliance of a tooth's root in a half plane: external gears with a thick body, and rings.

    Args:
        form: Outline of the tooth.
        radius: Radii at which the flank is touched [m], shape (n,).
        material: For E and ν; plane stress.

    Returns:
        Deflection along the line of action per unit force and length [m²/N], shape (n,).

    Source: O'Donnell 1960 and 1963 (foundation of a cantilever), as used by Cornell 1981, J. Mech. Des. 103, for narrow
        faces: cos² α/E [5.306 (l/h)² + 2 (1 − ν) l/h + 1.534 (1 + 0.4167 tan² α/(1 + ν))].
    """
    lever, angle = _lever(form, radius)
    ratio, nu = lever / form.root_chord, material.poisson_ratio
    axial = 1.534 * (1.0 + 0.4167 * np.tan(angle) ** 2 / (1.0 + nu))
    terms = 5.306 * ratio**2 + 2.0 * (1.0 - nu) * ratio + axial
    return np.asarray(np.cos(angle) ** 2 / material.elastic_modulus * terms)


def held_body_foundation(form: ToothForm, radius: Floats, *, material: Material, bore_radius: float) -> Floats:
    """Return the compliance of a tooth's root in a disc that is held at its bore, the disc's twist included.

    Args:
        form: Outline of an external tooth.
        radius: Radii at which the flank is touched [m], shape (n,).
        material: For E; plane stress.
        bore_radius: Radius at which the body is held [m].

    Returns:
        Deflection along the line of action per unit force and length [m²/N], shape (n,).

    Source: Sainsot, Velex & Duverger 2004, J. Mech. Des. 126, 748-752, table 1.
    Valid for: 1.4 ≤ r_f/r_bore ≤ 7 and 0.01 ≤ θ_f ≤ 0.12 rad.

    Raises:
        DesignError: outside that range.
    """
    ratio, half_angle = form.root_radius / bore_radius, form.root_half_angle
    problems = _outside_body(ratio, half_angle)
    if form.side < 0:
        problems = [
            Problem("bore_radius", "given for an internal gear; a ring's teeth stand on a half plane, leave it out")
        ]
    refuse(problems)
    terms = np.array([half_angle**-2, ratio**2, ratio / half_angle, 1.0 / half_angle, ratio, 1.0])
    l_star, m_star, p_star, q_star = _BODY @ terms
    lever, angle = _lever(form, radius)
    reach = lever / form.root_chord
    bracket = l_star * reach**2 + m_star * reach + p_star * (1.0 + q_star * np.tan(angle) ** 2)
    return np.asarray(np.cos(angle) ** 2 / material.elastic_modulus * bracket)


def _lever(form: ToothForm, radius: Floats) -> tuple[Floats, Floats]:
    """Height above the root circle where the force crosses the tooth's centre line [m], and the force's angle [rad]."""
    height, half, angle = load_point(form, radius)
    rise = form.side * form.root_radius * (1.0 - math.cos(form.root_half_angle))
    return height - half * np.tan(angle) - rise, angle


def _outside_body(ratio: float, half_angle: float) -> list[Problem]:
    """Problems with the range of the fit."""
    fix = "leave the bore radius out to use the half plane"
    problems = []
    if not 1.4 <= ratio <= 7.0:
        problems.append(
            Problem("bore_radius", f"root to bore radius is {ratio:.3g}; the fit holds from 1.4 to 7, {fix}")
        )
    if not 0.01 <= half_angle <= 0.12:
        message = (
            f"the root's half angle is {half_angle:.3g} rad; the fit holds from 0.01 to 0.12 (z above about 25), {fix}"
        )
        problems.append(Problem("bore_radius", message))
    return problems


# ----------------------------------------------------------------------------------------------------------------------
# Time-varying mesh stiffness from the strain energy of the teeth: bending, shear, compression, foundation, Hertz.
#
# Pairs in contact are added as independent springs: what one pair does to its neighbour through their common body is
# left out. The rim's own bending is not in it either: an elastic ring is a body of the dynamic model. A bore radius
# brings in the twist of the disc, which every pair then feels for itself; a thin web is better a shaft of the model.
# ----------------------------------------------------------------------------------------------------------------------


Bores: TypeAlias = tuple[float | None, float | None]


@dataclass(frozen=True)
class PairStiffness:
    """What gives where, when one tooth pair passes through its path of contact."""

    distance: Floats
    """Distance from the pitch point towards the driver's tip [m], shape (n,)."""
    driver: ToothCompliance
    """Compliance of the driver's tooth."""
    driven: ToothCompliance
    """Compliance of the driven tooth."""
    contact: float
    """Hertzian compliance of the contact line [m²/N]."""

    @property
    def stiffness(self) -> Floats:
        """Stiffness per unit length of contact along the flank's normal [N/m²], shape (n,)."""
        return 1.0 / (self.driver.total + self.driven.total + self.contact)


def contact_compliance(first: Material, second: Material) -> float:
    """Return the Hertzian compliance of a contact line, independent of the load.

    Args:
        first: Material of one flank.
        second: Material of the other.

    Returns:
        Approach per unit force and length [m²/N]; for equal materials 4 (1 − ν²)/(π E).

    Source: Yang & Sun 1985, J. Mech. Trans. Autom. Des. 107.
    """
    return (2.0 / math.pi) * sum((1.0 - m.poisson_ratio**2) / m.elastic_modulus for m in (first, second))


def pair_stiffness(
    pair: GearPair, distance: Floats, *, materials: tuple[Material, Material], bore_radii: Bores = (None, None)
) -> PairStiffness:
    """Return the stiffness of one tooth pair at given places of its path of contact.

    Args:
        pair: External or internal pair.
        distance: Distances from the pitch point towards the driver's tip [m], shape (n,).
        materials: Of driver and driven gear.
        bore_radii: Radii at which the two bodies are held [m]; None: half plane, always so for a ring.

    Source: as `tooth_compliance` and `contact_compliance`; helical teeth by their equivalent spur gears.
    """
    radii = np.array([contact_radii(pair, float(place)) for place in distance]).reshape(-1, 2)
    driver, driven = radii.T
    return PairStiffness(
        distance=distance,
        driver=_gear_compliance(pair.driver, driver, material=materials[0], bore_radius=bore_radii[0]),
        driven=_gear_compliance(pair.driven, driven, material=materials[1], bore_radius=bore_radii[1]),
        contact=contact_compliance(*materials),
    )


def mesh_stiffness_energy(
    pair: GearPair, *, materials: tuple[Material, Material], bore_radii: Bores = (None, None), harmonics: int = 8
) -> StiffnessCurve:
    """Return the time-varying mesh stiffness by the potential-energy method.

    Args:
        pair: External or internal, spur or helical.
        materials: Of driver and driven gear.
        bore_radii: Radii at which the two bodies are held [m]; None: half plane.
        harmonics: Harmonics of the mesh phase to keep [-].

    Returns:
        Stiffness along the transverse line of action [N/m] over the whole face width.

    Source: Yang & Lin 1987; Tian 2004; Cornell 1981 or Sainsot et al. 2004; Yang & Sun 1985. Helical teeth in slices
        (see `pair_curve`), each with the normal section's stiffness times cos β_b, as ISO 6336-1:2006 does with cos β.
    Valid for: perfect flanks without modifications; full contact along every line of contact.

    Raises:
        DesignError: for a total contact ratio below 1.
    """
    return pair_curve(
        _ends(pair),
        _passing_pair(pair, materials, bore_radii),
        overlap=pair.overlap_ratio,
        harmonics=harmonics,
        source="potential energy of the tooth",
    )


def mesh_cycle_energy(
    pair: GearPair, phase: Floats, *, materials: tuple[Material, Material], bore_radii: Bores = (None, None)
) -> Floats:
    """Return the stiffness of a spur mesh at given mesh phases with its jumps, as a figure shows it.

    Args:
        pair: External or internal spur pair.
        phase: Mesh phases φ [rad], shape (n,).
        materials: Of driver and driven gear.
        bore_radii: Radii at which the two bodies are held [m]; None: half plane.

    Returns:
        k [N/m], shape (n,).

    Source: as `mesh_stiffness_energy`, without its Fourier series.
    """
    if pair.driver.helix_angle > 0.0:
        raise DesignError([Problem("helix_angle", "helical teeth have no jumps to show; use `mesh_stiffness_energy`")])
    return summed_pairs(_ends(pair), _passing_pair(pair, materials, bore_radii), phase)


def _ends(pair: GearPair) -> tuple[float, float]:
    """Start and end of contact in base pitches from the pitch point."""
    return -pair.approach / pair.driver.base_pitch, pair.recess / pair.driver.base_pitch


def _passing_pair(
    pair: GearPair, materials: tuple[Material, Material], bore_radii: Bores
) -> Callable[[Floats], Floats]:
    """Stiffness of one pair [N/m] as a function of its place in base pitches, along the transverse line of action."""
    width = pair.face_width * math.cos(pair.driver.base_helix_angle)

    def stiffness(place: Floats) -> Floats:
        distance = place * pair.driver.base_pitch
        return width * pair_stiffness(pair, distance, materials=materials, bore_radii=bore_radii).stiffness

    return stiffness


def _gear_compliance(
    gear: CylindricalGear, radius: Floats, *, material: Material, bore_radius: float | None
) -> ToothCompliance:
    """Compliance of a gear's tooth; transverse radii go to the equivalent spur gear at equal height above its pitch."""
    virtual = virtual_teeth(abs(gear.teeth), gear.rack.pressure_angle, gear.helix_angle)
    moved = radius + (0.5 * virtual * gear.module - gear.pitch_radius)
    return tooth_compliance(tooth_form(gear), moved, material=material, bore_radius=bore_radius)
