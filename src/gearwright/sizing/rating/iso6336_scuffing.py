"""What the oil does between the flanks of a rated mesh: scuffing by both temperatures, and micropitting."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Annotated, Protocol

from gearwright.base import CELSIUS, Check, Floats, Origin, PartId, Quantity
from gearwright.parts.iso6336 import RZ_OVER_RA, PairRating, Treatment, mesh_springs
from gearwright.parts.losses import OIL_DENSITY, oil_viscosity
from gearwright.parts.micropitting import BASES, FilmMesh, Micropitting, OilGrade, micropitting, relief_factor
from gearwright.parts.scuffing import (
    SPRAY,
    IntegralTemperature,
    Oil,
    ScuffingMesh,
    flash_temperature,
    integral_temperature,
    relieved_part,
)
from gearwright.sizing.rating.geometry import cylindrical_mesh
from gearwright.sizing.rating.iso6336_inputs import SQUARE_MM, steels_of
from gearwright.sizing.rating.protocol import LoadedMesh
from gearwright.spec.design import Iso6336Rules

_FLASH = "ISO/TS 6336-20:2017"
CLAUSES = ("ISO/TS 6336-21, eq. 14", "ISO/TS 6336-20, eq. 100")
"""Of the judgements by integral and by flash temperature."""
_SOFTEST = (
    Treatment.STRUCTURAL, Treatment.THROUGH_HARDENED, Treatment.INDUCTION_HARDENED, Treatment.CASE_HARDENED,
)  # fmt: skip
"""Treatments from the one that micropits first."""


@dataclass(frozen=True)
class FlashPeak:
    """The hottest place of the path of contact."""

    friction: Annotated[float, Quantity("ratio"), Origin("μ_m", f"{_FLASH}, eq. 25")]
    """Mean coefficient of friction [-]."""
    bulk: Annotated[float, Quantity("temperature"), Origin("ϑ_M = ϑ_oil + 0.47 X_S X_mp ϑ_flm", f"{_FLASH}, eq. 22")]
    """Bulk temperature [°C]."""
    contact: Annotated[float, Quantity("temperature"), Origin("ϑ_B = ϑ_M + ϑ_flmax", f"{_FLASH}, eq. 2")]
    """Greatest contact temperature [°C]."""
    scuffing: Annotated[
        float, Quantity("temperature"), Origin("ϑ_S = 80 + (0.85 + 1.4 X_W) X_L S_FZG²", f"{_FLASH}, eq. 99")
    ]
    """Scuffing temperature [°C]."""
    safety: Annotated[float, Quantity("ratio"), Origin("S_B = (ϑ_S − ϑ_oil)/(ϑ_B − ϑ_oil)", f"{_FLASH}, eq. 100")]
    """S_B [-]."""


@dataclass(frozen=True)
class OilFilm:
    """Scuffing by both temperatures, and micropitting where the oil was tested for it."""

    integral: IntegralTemperature | None
    """By the integral temperature; None where contact lies on one side of the pitch point alone."""
    flash: FlashPeak
    """By the flash temperature."""
    micropitting: Micropitting | None
    """None where the oil's load stage is not given."""


class Scuffed(Protocol):
    """A mesh with its temperatures."""

    @property
    def scuffing(self) -> IntegralTemperature | None:
        """By the integral temperature."""

    @property
    def flash(self) -> FlashPeak | None:
        """By the flash temperature."""

    @property
    def scuffing_asked(self) -> float:
        """Least safety [-]."""

    @property
    def scuffing_by(self) -> str:
        """Temperature that the asked safety is against."""


class Filmed(Protocol):
    """A mesh with its oil film."""

    @property
    def micropitting(self) -> Micropitting | None:
        """Where it is assessed."""

    @property
    def micropitting_asked(self) -> float:
        """Least S_λ [-]."""


def oil_film(mesh: LoadedMesh, factors: PairRating) -> OilFilm | None:
    """Return what the oil does in a mesh; None where tips interfere, so that nothing rolls.

    Args:
        mesh: With its heaviest load.
        factors: As rated in it.
    """
    rating, rules, ask = mesh.rating, mesh.rating.rules.iso6336, mesh.heaviest.ask
    geometry = cylindrical_mesh(ask.teeth, mesh.module, mesh.face_width, rating, internal=ask.internal)
    if not geometry.rolls:
        return None
    force = float(factors.tangential_force) / mesh.face_width
    first, second = steels_of(rating, ask.roles)
    nominal = force * float(factors.loads.application) * float(factors.loads.mesh_load)
    springs = mesh_springs(geometry, nominal, steels=(first, second), blank=rules.blank_factor)
    scuffed = ScuffingMesh(
        geometry,
        specific_load=force * float(factors.loads.contact),
        nominal_load=nominal,
        speed=float(factors.speed),
        roughness=rules.flank_roughness / RZ_OVER_RA,
        stiffness=(float(springs.single), float(springs.mesh)),
        grade=int(factors.grade),
        elastic_modulus=first.elastic_modulus,
        poisson_ratio=first.poisson_ratio,
        mate=(second.elastic_modulus, second.poisson_ratio),
        reliefs=(float(factors.relief.amount), float(factors.relief.amount)),
        mates=ask.passes[0],
    )
    oil = oil_of(rules)
    around = min(float(ratio) for ratio in geometry.addendum_contact_ratios) > 0.0
    integral = integral_temperature(scuffed, oil) if around else None
    return OilFilm(integral, flash_peak(scuffed, oil), _micropitted(mesh, scuffed, factors))


def scuffing_checks(rated: Scuffed, mesh: PartId, *, clauses: tuple[str, str] = CLAUSES) -> Iterator[Check]:
    """Yield the judgements on scuffing: by the temperature asked for, or by the only one that can be had.

    Args:
        rated: The mesh.
        mesh: Its name.
        clauses: Of the integral and of the flash temperature.
    """
    for clause, symbol, safety in zip(clauses, ("S_intS", "S_B"), scuffing_safeties(rated), strict=True):
        if safety is not None:
            yield Check(mesh, "scuffing", clause, safety, rated.scuffing_asked, symbol=symbol)


def scuffing_safeties(rated: Scuffed) -> tuple[float | None, float | None]:
    """Return the safeties that are asked for, against the integral and the flash temperature [-]; None of the others.

    Args:
        rated: The mesh.
    """
    scuffed, peak, by = rated.scuffing, rated.flash, rated.scuffing_by
    mean = scuffed.safety if scuffed is not None and (peak is None or by != "flash") else None
    return mean, peak.safety if peak is not None and (scuffed is None or by != "integral") else None


def film_checks(rated: Filmed, mesh: PartId) -> Iterator[Check]:
    """Yield the judgement on micropitting, where it is assessed.

    Args:
        rated: The mesh.
        mesh: Its name.
    """
    if (film := rated.micropitting) is not None:
        place = f"at {film.point}"
        clause = "ISO/TS 6336-22, method B"
        yield Check(
            mesh, "micropitting", clause, film.safety, rated.micropitting_asked, symbol="S_λ", place=place,
            exponent=None,
        )  # fmt: skip


def flash_peak(mesh: ScuffingMesh, oil: Oil, sharing: Callable[[Floats], Floats] | None = None) -> FlashPeak:
    """Return the hottest place of a mesh by the flash temperature.

    Args:
        mesh: As the methods of scuffing see it.
        oil: At work.
        sharing: X_Γ of crowned flanks [-]; None: of unmodified ones.
    """
    flash = flash_temperature(mesh, oil, sharing=sharing)
    return FlashPeak(flash.friction, flash.bulk, flash.contact, flash.scuffing, flash.safety)


def _micropitted(mesh: LoadedMesh, scuffed: ScuffingMesh, factors: PairRating) -> Micropitting | None:
    rules = mesh.rating.rules.iso6336
    treatments = [steel.treatment for steel in steels_of(mesh.rating, mesh.heaviest.ask.roles)]
    if rules.micropitting_stage is None or any(treatment.is_cast_iron for treatment in treatments):
        return None
    film = FilmMesh(
        scuffed.geometry,
        float(factors.tangential_force),
        float(factors.loads.contact),
        float(factors.speed / (0.5 * scuffed.geometry.pitch_diameters[0])),
        scuffed.roughness,
        grade=scuffed.grade,
        elastic_modulus=scuffed.elastic_modulus,
        poisson_ratio=scuffed.poisson_ratio,
        supply=SPRAY,
        relief=relief_factor(scuffed.geometry, relieved_part(scuffed), scuffed.grade),
    )
    weaker = next((treatment for treatment in _SOFTEST if treatment in treatments), treatments[0])
    oil, temperature = _grade(rules), rules.oil_temperature
    return micropitting(film, oil, temperature, stage=rules.micropitting_stage, treatment=weaker)


def _grade(rules: Iso6336Rules) -> OilGrade:
    hot = None if rules.oil_viscosity_100 is None else rules.oil_viscosity_100 * SQUARE_MM
    return OilGrade(rules.oil_viscosity * SQUARE_MM, hot, base=BASES[rules.oil_type])


def oil_of(rules: Iso6336Rules) -> Oil:
    """Return the design's oil; where ν_100 is not given its viscosity falls with temperature as a turbine oil's does.

    Args:
        rules: Viscosity, temperature, kind and load stage.
    """
    grade = _grade(rules)
    hot = grade.viscosity_40 * oil_viscosity(rules.oil_temperature + CELSIUS) / oil_viscosity(40.0 + CELSIUS)
    if grade.viscosity_100 is not None:
        hot = float(grade.kinematic(rules.oil_temperature))
    return Oil(
        rules.oil_temperature, hot * OIL_DENSITY, float(rules.scuffing_stage), kind=grade.base.lubricant, supply=SPRAY,
        viscosity_40=grade.viscosity_40,
    )  # fmt: skip
