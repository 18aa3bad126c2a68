"""Comparison of rating methods on sized meshes, and sensitivity of safety factors to their inputs.

It rates anew what is sized; it sizes nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.base import Check, DesignError, Floats, GearwrightError, Origin, Quantity, Shown, SolveError, verb
from gearwright.sizing.rating import (
    METHODS,
    REST,
    Context,
    Factor,
    Made,
    MeshRating,
    Rating,
    Unloaded,
    context_of,
    factor_rows,
    least_width,
    load_sharing,
    method_for,
    rate_row,
    rating_of,
    sizes_near,
)
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso6336_inputs import EDITIONS, clause_of
from gearwright.sizing.result import GearSizing, MeshSizing, Sizing
from gearwright.sizing.stages import geared
from gearwright.sizing.teeth import Chosen
from gearwright.spec import Design, edited
from gearwright.spec.design import RATINGS, given_values
from gearwright.spec.edit import Value
from gearwright.train import INTERNAL, Mesh

# ----------------------------------------------------------------------------------------------------------------------
# The factors that methods share under other names, and why their values differ: data for the comparison.
# ----------------------------------------------------------------------------------------------------------------------


Key = tuple[str, str]
"""Chapter and quantity of a row of a method's factors."""


class Aspect(NamedTuple):
    """One thing that every method has to say of a mesh."""

    name: str
    """In words, with the symbols of ISO and AGMA."""
    iso: Key | None
    """Row of ISO 6336 and DIN 3990."""
    agma: Key | None
    """Row of AGMA 2001."""
    lewis: Key | None
    """Row of Lewis and Hertz."""
    why: str
    """Why values differ."""


_FLANK, _ROOT, _STATIC = "strength of flanks", "strength of roots", "static strength"
ASPECTS: tuple[Aspect, ...] = (
    Aspect("force F_t, W_t", ("mesh", "tangential force"), ("mesh", "tangential force"), None,
           "AGMA takes working pitch diameters and K_γ into W_t; ISO and DIN reference ones"),
    Aspect("application K_A, K_o", ("load factors", "application"), ("mesh", "overload"), None,
           "one number of the design; Lewis and Hertz rate nominal loads"),
    Aspect("dynamics K_V, K_v", ("load factors", "dynamic"), ("mesh", "dynamic"), None,
           "ISO and DIN: resonance and deviations by class; AGMA: velocity and Q_v alone"),
    Aspect("face K_Hβ, K_m", ("load factors", "face contact"), ("mesh", "distribution"), None,
           "ISO and DIN: misalignment times stiffness over load; AGMA: sizes and housing"),
    Aspect("pairs in contact K_Hα", ("load factors", "transverse contact"), None, None,
           "AGMA has no such factor; precision is taken for granted"),
    Aspect("face, root K_Fβ, K_m", ("load factors", "face bending"), ("mesh", "distribution"), None,
           "ISO and DIN: K_Hβ to the power N_F; AGMA: one K_m for both"),
    Aspect("flank geometry Z_H", ("pitting", "zone"), None, None, "AGMA: in I"),
    Aspect("contact ratio Z_ε", ("pitting", "contact ratio"), None, None, "AGMA: in I by m_N; Hertz: none"),
    Aspect("helix Z_β", ("pitting", "helix"), None, None,
           "DIN: √cos β; ISO since its correction of 2008: the inverse"),
    Aspect("geometry I", None, ("mesh", "pitting geometry"), None,
           "AGMA: lowest point of single contact for spur, mean for helical teeth"),
    Aspect("elasticity Z_E, C_p", ("pitting", "elasticity"), ("mesh", "elastic"), None, "one formula"),
    Aspect("contact stress σ_H, s_c", ("pitting", "stresses"), ("stresses", "contact stress"),
           ("mesh", "contact stress"), "the factors above; Hertz: nominal load at the pitch point"),
    Aspect("strength σ_Hlim, s_ac", ("steel", "contact strength"), ("strength", "contact"), None,
           "ISO 6336-5: 1 % failures of test gears of this steel; AGMA: table 3 of its own steel and grade"),
    Aspect("life Z_NT, Z_N", (_FLANK, "life"), ("mesh", "contact cycles"), None,
           "ISO falls to 0.85 at 1e10 cycles and on, DIN stays at 1, AGMA falls with N^−0.023 (0.056)"),
    Aspect("lubricant Z_L", (_FLANK, "lubricant"), None, None, "AGMA: no film factors"),
    Aspect("speed Z_v", (_FLANK, "speed"), None, None, "AGMA: no film factors"),
    Aspect("roughness Z_R", (_FLANK, "roughness"), None, None, "AGMA: C_f = 1"),
    Aspect("work hardening Z_W, C_H", (_FLANK, "work hardening"), ("mesh", "hardness ratio"), None,
           "ISO by R_zH, DIN by hardness alone; AGMA by both hardnesses and the ratio, of the gear alone"),
    Aspect("size Z_X", (_FLANK, "size"), None, None, "DIN from m_n = 10 mm; ISO leaves it at 1"),
    Aspect("limit σ_HG", ("pitting", "permissible"), ("stresses", "contact limit"), ("mesh", "contact allowable"),
           "the factors above; Hertz: 2.5 HB over the asked factor"),
    Aspect("tooth form Y_F, Y", ("tooth root", "form"), ("tooth root", "form"), ("mesh", "form factor"),
           "ISO: 30° tangent; AGMA: Lewis' parabola, both at the outer single contact; Lewis: tip; their Y is inverse"),
    Aspect("sharing f_ε, m_N", ("tooth root", "load sharing"), ("tooth root", "sharing"), None,
           "only the edition of 2019 shares helical loads in Y_F; AGMA by its lines of contact"),
    Aspect("notch Y_S, K_f", ("tooth root", "stress correction"), ("tooth root", "stress correction"), None,
           "ISO: strain gauges; AGMA: photoelasticity of Dolan and Broghamer"),
    Aspect("helix Y_β", ("tooth root", "helix"), None, None, "1/cos³ β in the edition of 2019 alone; AGMA: C_ψ in J"),
    Aspect("load at the tip Y_ε", ("tooth root", "contact ratio"), None, None,
           "method C of ISO and DIN takes the load from the tip to the outer single contact so"),
    Aspect("rim Y_B, K_B", ("tooth root", "rim"), ("mesh", "rims"), None,
           "one formula below 1.2 tooth heights; rings by ISO below 3.5 m_n"),
    Aspect("geometry J", None, ("tooth root", "factor"), None, "AGMA: Y C_ψ/(K_f m_N)"),
    Aspect("size Y_X, K_s", (_ROOT, "size"), ("mesh", "size"), None,
           "ISO: lessens strength; AGMA: raises stress (Shigley)"),
    Aspect("root stress σ_F, s_t", ("tooth root", "stress"), ("stresses", "bending stress"),
           ("mesh", "bending stress"), "the factors above; Lewis: no notch, nominal load"),
    Aspect("strength σ_Flim, s_at", ("steel", "bending strength"), ("strength", "bending"), None,
           "ISO: doubled by Y_ST = 2 of the test gear; AGMA: as it stands"),
    Aspect("life Y_NT, Y_N", (_ROOT, "life"), ("mesh", "bending cycles"), None,
           "ISO falls to 0.85 at 1e10 cycles and on, DIN stays at 1, AGMA falls with N^−0.0178 (0.0323)"),
    Aspect("notch sensitivity Y_δrelT", (_ROOT, "notch sensitivity"), None, None, "AGMA: in s_at"),
    Aspect("fillet roughness Y_RrelT", (_ROOT, "surface"), None, None, "AGMA: in s_at"),
    Aspect("mean stress Y_M", (_ROOT, "mean stress"), None, None,
           "AGMA: 0.7 left to the designer; Lewis: idler_factor"),
    Aspect("reliability K_R", None, ("mesh", "reliability"), None,
           "ISO and DIN: 99 % in σ_lim, other parts by the same table"),
    Aspect("limit σ_FG", ("tooth root", "permissible"), ("stresses", "bending limit"), ("mesh", "bending allowable"),
           "the factors above; Lewis: R_p0.2 over the asked factor"),
    Aspect("safety S_H", ("pitting", "safeties"), ("stresses", "contact safety"), None,
           "AGMA and ISO square the same load: S_H² compares with S_F"),
    Aspect("safety S_F", ("tooth root", "safety"), ("stresses", "bending safety"), None, "stress and strength above"),
    Aspect("static S_H", (_STATIC, "contact safety"), None, None, "AGMA: no static limit of flanks"),
    Aspect("static S_F, S_y", (_STATIC, "bending safety"), (_STATIC, "safeties"), None,
           "ISO: first crack, Y_NT and Y_δrelT of static stress; AGMA: yielding by s_ay K_y"),
    Aspect("scuffing S_intS", ("scuffing", "safety"), None, None, "integral temperature; AGMA 2001 has none"),
    Aspect("scuffing S_B", ("scuffing, flash temperature", "safety"), None, None,
           "flash temperature; AGMA 2001 has none"),
    Aspect("micropitting S_λ", ("micropitting", "safety"), None, None, "ISO/TS 6336-22; AGMA 2001 has none"),
)  # fmt: skip
"""In the order in which a rating is computed: loads, flanks, roots, safeties."""
FAMILIES = {
    "iso6336": "iso", "iso6336-2006": "iso", "din3990": "iso", "agma2001": "agma", "lewis-hertz": "lewis",
}  # fmt: skip
"""Method -> whose names its rows have; the columns of a comparison, in this order."""


# ----------------------------------------------------------------------------------------------------------------------
# The factors that ISO 10300 and AGMA 2003 share under other names, and why their values differ.
# ----------------------------------------------------------------------------------------------------------------------


BEVEL_ASPECTS: tuple[Aspect, ...] = (
    Aspect("force F_mt, W_t", ("mesh", "tangential force"), ("mesh", "tangential force"), None,
           "ISO: at the mean cone; AGMA: at the outer one, by d_m/d_e less"),
    Aspect("velocity v_mt, v_et", ("mesh", "speed"), ("mesh", "speed"), None, "mean cone and outer cone"),
    Aspect("application K_A, K_o", ("load factors", "application"), ("mesh", "overload"), None,
           "one number of the design"),
    Aspect("dynamics K_V, K_v", ("load factors", "dynamic"), ("mesh", "dynamic"), None,
           "ISO: resonance and pitch deviation by class; AGMA: velocity and Q_v alone"),
    Aspect("face K_Hβ, K_m", ("load factors", "face contact"), ("mesh", "distribution"), None,
           "ISO: 1.5 times the mounting's, crowning within; AGMA: mounting and width, crowning in C_xc"),
    Aspect("crowning C_xc", None, ("mesh", "crowning"), None, "ISO: the 1.5 in K_Hβ"),
    Aspect("pairs in contact K_Hα", ("load factors", "transverse contact"), None, None,
           "AGMA has no such factor; precision is taken for granted"),
    Aspect("face, root K_Fβ, K_m", ("load factors", "face bending"), ("mesh", "distribution"), None,
           "ISO: K_Hβ/K_F0; AGMA: without the crowning's 1.5 on the root"),
    Aspect("lengthwise curvature K_x", None, ("mesh", "curvature"), None, "ISO: K_F0 in K_Fβ"),
    Aspect("size C_s", None, ("mesh", "size contact"), None, "AGMA: raises stress with the width; ISO: none"),
    Aspect("mid zone Z_M-B", ("pitting", "mid zone"), None, None, "AGMA: the critical point in I"),
    Aspect("sharing Z_LS², ε_NI", ("tooth root", "load sharing"), ("pitting", "sharing"), None,
           "ISO: areas under three lines; AGMA: cubes of the lengths of all"),
    Aspect("few teeth in contact Z_i", None, ("pitting", "inertia"), None, "AGMA: 2/ε_o below an ε_o of 2; ISO: none"),
    Aspect("geometry I", None, ("pitting", "factor"), None, "AGMA: curvature, line and sharing in one number"),
    Aspect("elasticity Z_E, C_p", ("pitting", "elasticity"), ("mesh", "elastic"), None, "one formula"),
    Aspect("contact stress σ_H, s_c", ("pitting", "stress"), ("stresses", "contact stress"), None,
           "the factors above"),
    Aspect("strength σ_Hlim, s_ac", ("steel", "contact strength"), ("strength", "contact"), None,
           "ISO 6336-5: test gears of this steel; AGMA: table 3 of its own steel and grade"),
    Aspect("life Z_NT, C_L", ("mesh", "contact life"), ("mesh", "contact cycles"), None,
           "ISO: 1 at the knee of its steel; AGMA: 1 at 1e9, N^−0.0602 all the way"),
    Aspect("film Z_L, Z_v, Z_R", ("pitting", "film"), None, None, "AGMA: no film factors"),
    Aspect("hardness ratio C_H", None, ("mesh", "hardness ratio"), None, "ISO: Z_W = 1 of one steel"),
    Aspect("limit σ_HP, s_wc", ("pitting", "permissible"), ("stresses", "contact limit"), None,
           "the factors above, and Z_KP = 1.2 of ISO"),
    Aspect("tooth form Y_Fa, Y", ("tooth root", "form"), ("tooth root", "form"), None,
           "ISO: 30° tangent, load at the tip; AGMA: parabola, load where one pair bears alone; Y is inverse"),
    Aspect("notch Y_Sa, Y_f", ("tooth root", "stress correction"), ("tooth root", "stress correction"), None,
           "ISO: strain gauges; AGMA: photoelasticity of Dolan and Broghamer"),
    Aspect("contact ratio Y_ε, ε_NJ", ("tooth root", "contact ratio"), ("tooth root", "sharing"), None,
           "ISO: from the tip inwards; AGMA: the load is put there"),
    Aspect("face Y_BS, b′/b", ("tooth root", "spiral"), ("tooth root", "effective face"), None,
           "ISO: raises stress by the slant of the line; AGMA: spreads the load over the root"),
    Aspect("geometry J", None, ("tooth root", "factor"), None, "AGMA: form, notch, sharing and face in one number"),
    Aspect("size Y_X, K_s", ("tooth root", "size"), ("mesh", "size bending"), None,
           "ISO: lessens strength; AGMA: below 1, on the stress"),
    Aspect("root stress σ_F, s_t", ("tooth root", "stress"), ("stresses", "bending stress"), None,
           "the factors above; AGMA's K_s halves it"),
    Aspect("strength σ_Flim, s_at", ("steel", "bending strength"), ("strength", "bending"), None,
           "ISO: doubled by Y_ST = 2 of the test gear; AGMA: as it stands"),
    Aspect("life Y_NT, K_L", ("mesh", "root life"), ("mesh", "bending cycles"), None,
           "ISO: 1 at 3e6; AGMA: 1.04 there, then N^−0.0178 (0.0323)"),
    Aspect("both flanks loaded", None, ("mesh", "reversal"), None, "AGMA: 0.7; ISO 10300: left to the designer"),
    Aspect("notch sensitivity Y_δrelT", ("tooth root", "notch sensitivity"), None, None, "AGMA: in s_at"),
    Aspect("fillet roughness Y_R,relT", ("tooth root", "surface"), None, None, "AGMA: in s_at"),
    Aspect("reliability K_R", None, ("mesh", "reliability bending"), None, "ISO: 99 %, fixed by σ_lim"),
    Aspect("temperature K_T", None, ("mesh", "temperature"), None, "ISO: none"),
    Aspect("limit σ_FP, s_wt", ("tooth root", "permissible"), ("stresses", "bending limit"), None,
           "the factors above, and Y_ST = 2 of ISO"),
    Aspect("safety S_H", ("pitting", "safeties"), ("stresses", "contact safety"), None, "stress and strength above"),
    Aspect("safety S_F", ("tooth root", "safety"), ("stresses", "bending safety"), None, "stress and strength above"),
)  # fmt: skip
"""In the order in which a rating is computed: loads, flanks, roots, safeties."""
BEVEL_FAMILIES = {"iso10300": "iso", "agma2003": "agma"}
"""Method -> whose names its rows have; the columns of a comparison of bevel gears, in this order."""


# ----------------------------------------------------------------------------------------------------------------------
# The sized meshes of a design as their methods rated them, to be rated again with something changed.
# ----------------------------------------------------------------------------------------------------------------------


class SizedMesh(NamedTuple):
    """A row of meshes with what rates it."""

    context: Context
    """What sizing read."""
    row: Mesh
    """Of the train."""
    module: float
    """m_n, of bevel gears m_mn [m]."""
    face_width: float
    """b [m]."""

    @property
    def rating(self) -> Rating:
        """Rules of its stage."""
        return self.context.rating(self.row)

    def rated(self, rating: Rating | None = None) -> MeshRating:
        """Return the rating, by other rules if they are given.

        Args:
            rating: Instead of the design's rules.
        """
        rules = self.rating if rating is None else rating
        context = replace(self.context, ratings={**self.context.ratings, self.row.stage: rules})
        return rate_row(context, self.row, self.module, self.face_width)


def sized_meshes(sizing: Sizing) -> Iterator[SizedMesh]:
    """Yield every row of meshes of a sized design that a load case loads.

    Args:
        sizing: As sized.
    """
    context = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    sizes = {gear.name: (gear.module, gear.face_width) for gear in sizing.gears}
    rows = {mesh.name: mesh for mesh in sizing.train.meshes}
    for mesh in sizing.meshes:
        if mesh.rating.method:
            yield SizedMesh(context, rows[mesh.name], *sizes[mesh.gears[0]])


# ----------------------------------------------------------------------------------------------------------------------
# One sized mesh by every method that rates its kind of gears: teeth, module, width and loads are the same.
# ----------------------------------------------------------------------------------------------------------------------


_KINDS = ((FAMILIES, ASPECTS), (BEVEL_FAMILIES, BEVEL_ASPECTS))
"""Of cylindrical and of bevel gears: method -> whose names its rows have, and what is compared."""
CLOSE = 0.005
"""Part by which values may differ and still count as equal [-]."""


class Beside(NamedTuple):
    """One aspect of a mesh by every method."""

    aspect: str
    """In words, with symbols."""
    values: Mapping[str, tuple[float, ...]]
    """Method -> of both gears, or one of the mesh [SI]; methods that know no such factor are left out."""
    dimension: str
    why: str
    """Why the values differ; empty where they do not."""


@dataclass(frozen=True, repr=False)
class MeshBeside(Shown):
    """A mesh by every method."""

    mesh: str
    """Name of the mesh."""
    rows: tuple[Beside, ...]
    margins: Mapping[str, tuple[float, float]]
    """Method -> margins of flanks and of roots over the asked safeties [-]."""
    refused: Mapping[str, str]
    """Method -> why it does not rate this mesh."""


@verb
def methods_beside(sizing: Sizing) -> tuple[MeshBeside, ...]:
    """Return every mesh of a design by every method of its kind, factor by factor, with the reasons of differences.

    Args:
        sizing: As sized; its teeth, modules, widths and loads are kept.
    """
    return tuple(
        _beside(mesh, families, aspects)
        for mesh in sized_meshes(sizing)
        for families, aspects in _KINDS
        if mesh.rating.method in families
    )


def _beside(mesh: SizedMesh, families: Mapping[str, str], aspects: tuple[Aspect, ...]) -> MeshBeside:
    rated: dict[str, MeshRating] = {}
    refused: dict[str, str] = {}
    for name in families:
        why = _uncovered(mesh, name)
        try:
            if not why:
                rated[name] = mesh.rated(replace(mesh.rating, method=name))
        except (DesignError, SolveError) as error:
            why = error.problems[0].message if isinstance(error, DesignError) else str(error)
        if why:
            refused[name] = why
    margins = {name: (record.contact_margin, record.bending_margin) for name, record in rated.items()}
    return MeshBeside(mesh.row.name, tuple(_lines(rated, families, aspects)), margins, refused)


def _uncovered(mesh: SizedMesh, method: str) -> str:
    """Return why a method does not rate a mesh; empty where it does."""
    internal = mesh.row.sign == INTERNAL
    kind = "internal" if internal else mesh.rating.kind
    if kind not in RATINGS[method].covers:
        return f"{RATINGS[method].title} rates no {kind} meshes here"
    material = mesh.rating.material
    lacking = [need for need in RATINGS[method].needs if getattr(material, need, None) is None]
    if lacking:
        return f"{material.name} has no {' and no '.join(lacking)}"
    first, second = (mesh.context.teeth[gear] for gear in mesh.row.gears)
    teeth = (first, -second if internal else second)
    problem = next(METHODS[method].refuse(replace(mesh.rating, method=method), teeth), None)
    return "" if problem is None else problem.message


def _lines(
    rated: Mapping[str, MeshRating], families: Mapping[str, str], aspects: tuple[Aspect, ...]
) -> Iterator[Beside]:
    rows = {name: {(row.chapter, row.quantity): row for row in _rows(name, record)} for name, record in rated.items()}
    for aspect in aspects:
        shown = {name: rows[name].get(_key(aspect, families[name])) for name in rated}  # type: ignore[arg-type]
        known = {name: row for name, row in shown.items() if row is not None}
        if known:
            values = {name: tuple(float(value) for value in row.values) for name, row in known.items()}
            differ = len(known) < len(rated) or _differ(list(values.values()))
            yield Beside(aspect.name, values, next(iter(known.values())).dimension, aspect.why if differ else "")


def _rows(method: str, record: MeshRating) -> list[Factor]:
    """Return the factors of a rating; of a method without such a list the numbers of its record."""
    return [*METHODS[method].factors(record)] or [*factor_rows(record, "mesh")]


def _key(aspect: Aspect, family: str) -> tuple[str, str] | None:
    return {"iso": aspect.iso, "agma": aspect.agma, "lewis": aspect.lewis}[family]


def _differ(values: list[tuple[float, ...]]) -> bool:
    first = values[0]
    return any(
        len(other) != len(first)
        or any(abs(a - b) > CLOSE * max(abs(a), abs(b)) for a, b in zip(first, other, strict=True))
        for other in values[1:]
    )


# ----------------------------------------------------------------------------------------------------------------------
# What moves the margins of a mesh, and how far each thing must be turned until the worst margin is a wished one.
# ----------------------------------------------------------------------------------------------------------------------


STEP = 0.005
"""Relative step of the central differences [-]."""
FARTHEST = 3.0
"""Factor beyond which a thing is not turned [-]."""
_HALVINGS = 30
"""Of a step of the scan: 5 % / 2³⁰ is 5e-11 of a value."""
_SCAN = 24


class Handle(NamedTuple):
    """Something that a user can turn."""

    name: str
    """In words, with its symbol."""
    dimension: str
    value: float
    """As it is [SI]."""
    turned: Callable[[float], SizedMesh]
    """Value -> the mesh with it."""


@dataclass(frozen=True)
class Influence:
    """How one thing moves the margins of a mesh."""

    handle: str
    dimension: str
    value: float
    """As it is [SI]."""
    flank: float
    """∂ ln S_H/∂ ln x, of the weaker gear [-]."""
    root: float
    """∂ ln S_F/∂ ln x, of the weaker gear [-]."""
    wanted: float | None
    """Value at which the worst margin is the wished one [SI]; None where a threefold change does not do."""


@dataclass(frozen=True, repr=False)
class MeshInfluences(Shown):
    """A mesh, and everything that moves its margins."""

    mesh: str
    method: str
    margin: float
    """The worst of flanks and roots, as it is [-]."""
    wish: float
    """Margin that is wished [-]."""
    rows: tuple[Influence, ...]


@verb
def influences(sizing: Sizing, wish: float = 1.0) -> tuple[MeshInfluences, ...]:
    """Return of every loaded mesh what moves its margins, and what would raise the worst to a wish.

    Args:
        sizing: As sized; teeth are kept.
        wish: Margin over the asked safeties that is wished [-]; 1 is just enough.
    """
    return tuple(_influences(mesh, wish) for mesh in sized_meshes(sizing))


def _influences(mesh: SizedMesh, wish: float) -> MeshInfluences:
    rows = (_influence(handle, wish) for handle in handles(mesh))
    return MeshInfluences(
        mesh.row.name, mesh.rating.method, min(_margins(mesh)), wish, tuple(row for row in rows if row is not None)
    )


def handles(mesh: SizedMesh) -> Iterator[Handle]:
    """Yield what a user can turn of a mesh: sizes, duty, and the numbers of its method's rules.

    Args:
        mesh: As sized.
    """
    rating = mesh.rating
    service = rating.service
    yield Handle("face width b", "length", mesh.face_width, lambda x: mesh._replace(face_width=x))
    yield Handle("module m_n", "length", mesh.module, lambda x: mesh._replace(module=x))
    if rating.helix_angle:
        yield Handle("helix angle β", "angle", rating.helix_angle, lambda x: _by(mesh, replace(rating, helix_angle=x)))
    if RATINGS[rating.method].fatigue:
        factor = service.application_factor
        yield Handle("application factor K_A", "ratio", factor, _service(mesh, "application_factor"))
        yield Handle("life", "life", service.life, _service(mesh, "life"))
    if RATINGS[rating.method].table == "iso6336":
        for name, dimension, key in (
            ("flank roughness R_z", "length", "flank_roughness"), ("root roughness R_z", "length", "root_roughness"),
            ("oil ν_40 in mm²/s", "number", "oil_viscosity"), ("tip relief C_a", "length", "tip_relief"),
        ):  # fmt: skip
            if value := getattr(rating.rules.iso6336, key):
                yield Handle(name, dimension, value, _making(mesh, key))


def _by(mesh: SizedMesh, rating: Rating) -> SizedMesh:
    ratings = {**mesh.context.ratings, mesh.row.stage: rating}
    return mesh._replace(context=replace(mesh.context, ratings=ratings))


def _service(mesh: SizedMesh, key: str) -> Callable[[float], SizedMesh]:
    def turned(value: float) -> SizedMesh:
        service = mesh.rating.service.model_copy(update={key: value})
        design = mesh.context.design.model_copy(update={"service": service})
        return _by(mesh._replace(context=replace(mesh.context, design=design)), replace(mesh.rating, service=service))

    return turned


def _making(mesh: SizedMesh, key: str) -> Callable[[float], SizedMesh]:
    def turned(value: float) -> SizedMesh:
        rules = mesh.rating.rules
        table = rules.iso6336.model_copy(update={key: value})
        return _by(mesh, replace(mesh.rating, rules=rules.model_copy(update={"iso6336": table})))

    return turned


def _margins(mesh: SizedMesh) -> tuple[float, float]:
    rated = mesh.rated()
    return float(rated.contact_margin), float(rated.bending_margin)


def _influence(handle: Handle, wish: float) -> Influence | None:
    """Return what a handle does; None where it cannot be turned at all."""
    try:
        below, above = (_margins(handle.turned(handle.value * (1.0 + step))) for step in (-STEP, STEP))
    except (DesignError, SolveError):
        return None
    span = math.log((1.0 + STEP) / (1.0 - STEP))
    flank, root = (math.log(high / low) / span for low, high in zip(below, above, strict=True))
    return Influence(handle.name, handle.dimension, handle.value, flank, root, _wanted(handle, wish))


def _wanted(handle: Handle, wish: float) -> float | None:
    """Return the nearest value at which the worst margin is the wished one, looked for on both sides."""
    here = _short(handle, 1.0, wish)
    last = {1: (1.0, here), -1: (1.0, here)}
    for far in range(1, _SCAN + 1):
        for side, (near_by, before) in last.items():
            factor = FARTHEST ** (side * far / _SCAN)
            short = _short(handle, factor, wish)
            if {before, short} == {True, False}:
                return handle.value * _crossing(handle, near_by, factor, wish, short=before)
            last[side] = factor, short
    return None


def _short(handle: Handle, factor: float, wish: float) -> bool | None:
    """Tell whether the worst margin falls short of the wish; None where the gears are none."""
    try:
        return min(_margins(handle.turned(handle.value * factor))) < wish
    except (DesignError, SolveError):
        return None


def _crossing(handle: Handle, one: float, other: float, wish: float, *, short: bool | None) -> float:
    """Return the factor at which the margin is the wished one, between one that is short, or not, and another."""
    for _ in range(_HALVINGS):
        middle = math.sqrt(one * other)
        one, other = (middle, other) if _short(handle, middle, wish) == short else (one, middle)
    return math.sqrt(one * other)


# ----------------------------------------------------------------------------------------------------------------------
# What a design leaves to usual values in its load factors, each with its source and what it moves in the mass.
# ----------------------------------------------------------------------------------------------------------------------


_RELIEVED = "C_a = C_eff in the case that does most damage, at most 0.02 m_n"
_CLASS = "by pitch-line velocity: 4 above 60 m/s, 5 from 15 m/s on, 6 below"


@dataclass(frozen=True)
class UsualValue:
    """A value that a design leaves open, as it was taken."""

    stage: str
    quantity: str
    """With its symbol."""
    value: str
    source: str
    otherwise: str
    """What it is held against."""
    mass: Annotated[float | None, Quantity("mass"), Origin("Δm of the gears, their teeth as they are", "sized anew")]
    """By how much its gears would weigh more with the other value [kg]; None where sizes are given or nothing does."""


@verb
def usual_values(sizing: Sizing) -> tuple[UsualValue, ...]:
    """Return the load factors, tip reliefs and classes that a design leaves open, and what others would weigh.

    Args:
        sizing: As sized; its teeth are kept.
    """
    return tuple(value for stage in sizing.design.stages for value in _of_stage(sizing, stage))


def _of_stage(sizing: Sizing, stage: str) -> Iterator[UsualValue]:
    design, table = sizing.design, sizing.design.table(stage)
    meshes = [mesh for mesh in sizing.meshes if mesh.stage == stage]
    sharing = load_sharing(design, stage)
    factor = max(mesh.load_factor for mesh in meshes)
    if sharing.usual and RATINGS[design.rating(stage)].fatigue and factor > 1.0:
        mass = _change(sizing, {f"{table}.gears.mesh_load_factor": 1.0})
        yield UsualValue(stage, "load sharing K_γ", f"{factor:.3g}", sharing.words, "1, all alike", mass)
    made = [mesh.rating.made for mesh in meshes if isinstance(mesh.rating, Iso6336Rating)]
    rules = design.rules(stage).iso6336
    if made and rules.tip_relief is None:
        low, high = (pick(one.relief for one in made) for pick in (min, max))
        words = f"{1e6 * low:.3g}" if low == high else f"{1e6 * low:.3g} to {1e6 * high:.3g}"
        mass = _change(sizing, {f"{table}.gears.iso6336.tip_relief_mm": 0.0})
        clause = clause_of("ISO 6336-1, 6.5.5", EDITIONS[design.rating(stage)])
        source = f"{clause}: {_RELIEVED if rules.tip_relief_for == 'load' else 'C_ay by running in'}"
        yield UsualValue(stage, "tip relief C_a", f"{words} µm", source, "none", mass)
    if made and rules.tolerance_class is None:
        own = int(min(one.grade for one in made))
        mass = _change(sizing, {f"{table}.gears.iso6336.tolerance_class": own + 1})
        yield UsualValue(stage, "flank class A", f"{own}", _CLASS, f"{own + 1}", mass)


def _change(sizing: Sizing, changes: Mapping[str, Value]) -> float | None:
    """Return by how much gears weigh more with some changes, their teeth as they are [kg]."""
    try:
        design = edited(sizing.design, dict(changes))
        other = geared(design, sizing.train, Chosen(dict(sizing.teeth), {}), given=given_values(design).values)
    except GearwrightError:
        return None
    before, after = (sum(_volume(gear) for gear in gears) for gears in (sizing.gears, other.gears))
    return None if before == after else sum(gear.bodies * gear.mass for gear in sizing.gears) * (after / before - 1.0)


def _volume(gear: GearSizing) -> float:
    """Return what all bodies of a gear take as discs, of a ring its wall [m³]."""
    wall = 4.0 * gear.rim * gear.pitch_diameter if gear.rim else gear.pitch_diameter**2
    return gear.bodies * wall * gear.face_width


# ----------------------------------------------------------------------------------------------------------------------
# Stages as they would be with another module and width: what their strengths say there, and what they would fill.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Trial:
    """Every stage of a design, its teeth and loads as they were sized."""

    context: Context

    @property
    def design(self) -> Design:
        """With the rules by which it is rated."""
        return self.context.design

    @property
    def given(self) -> Mapping[str, float]:
        """Path -> value that the design gives [SI]."""
        return self.context.given

    def rating(self, stage: str) -> Rating:
        """Return the resolved rules of a stage.

        Args:
            stage: Pair or set.
        """
        return self.context.ratings[stage]

    def rows(self, stage: str) -> list[Mesh]:
        """Return the mesh rows of a stage.

        Args:
            stage: Pair or set.
        """
        return [mesh for mesh in self.context.train.meshes if mesh.stage == stage]

    def widest(self, stage: str, module: float) -> float:
        """Return the widest face that the rules of a stage call usual [m].

        Args:
            stage: Of cylindrical gears.
            module: m_n [m].
        """
        rating = self.rating(stage)
        limits, teeth = rating.proportions, self.context.teeth[self.rows(stage)[0].gears[0]]
        if limits is None:
            return math.inf
        diameter = module * teeth / math.cos(rating.helix_angle)
        return min(limits.widest_modules * module, limits.widest_diameters * diameter)

    def least(self, stage: str, module: float) -> float:
        """Return the narrowest face that the rules of a stage allow: that of the overlap ratio [m].

        Args:
            stage: Of cylindrical gears.
            module: m_n [m].
        """
        return least_width(self.rating(stage), module)

    def checks(self, stage: str, module: float, width: float) -> Iterator[Check]:
        """Yield what the method of a stage says of its meshes at a size, those of strength and of the oil film.

        Args:
            stage: Of cylindrical gears.
            module: m_n [m].
            width: b [m].
        """
        train, method = self.context.train, method_for(self.rating(stage))
        for mesh in self.rows(stage):
            rated = rate_row(self.context, mesh, module, width)
            if not isinstance(rated, Unloaded):
                first, second = (train.gear(gear).part for gear in mesh.gears)
                yield from method.checks(rated, mesh.part, (first, second))

    def near(self, stage: str, modules: Floats, widths: Floats) -> Floats | None:
        """Return about by what factor the loads on flanks and roots could grow at sizes, all at once [-].

        None where nothing loads the stage, or its method takes sizes one by one.

        Args:
            stage: Of cylindrical gears.
            modules: m_n [m].
            widths: b, of the same shape [m].
        """
        with np.errstate(all="ignore"):  # what overflows or is no number does not do
            rows = [sizes_near(self.context, mesh, modules, widths, (REST,)) for mesh in self.rows(stage)]
        found = [row for row in rows if row is not None]
        return np.minimum.reduce(found) if found else None

    def volume(self, stage: str, module: float, width: float) -> float:
        """Return what the gears of a stage fill as cylinders, rings as their wall [m³].

        Args:
            stage: Of cylindrical gears.
            module: m_n [m].
            width: b [m].
        """
        rating, rows, total = self.rating(stage), self.rows(stage), 0.0
        inner = {mesh.gears[1] for mesh in rows if mesh.sign == INTERNAL}
        for gear in {name for mesh in rows for name in mesh.gears}:
            pitch = module * self.context.teeth[gear] / math.cos(rating.helix_angle)
            wall = pitch + 2.0 * rating.rules.rim_thickness_ratio * module
            area = wall**2 - pitch**2 if gear in inner else pitch**2
            total += self.context.train.gear(gear).bodies * math.pi / 4.0 * area * width
        return total


def trial_of(design: Design, sizing: Sizing) -> Trial:
    """Return the stages of a design to be tried, with the teeth and loads of a sizing.

    Args:
        design: The rules, and what is given.
        sizing: Of it, or of one with the same teeth and cases.
    """
    return Trial(context_of(design, sizing.train, sizing.teeth, sizing.flows, given_values(design).values))


# ----------------------------------------------------------------------------------------------------------------------
# The rules of a stage as its gears are sized: with its K_γ, and the flank class that its speed gave.
# ----------------------------------------------------------------------------------------------------------------------


def rating_as_sized(sizing: Sizing, stage: str) -> Rating:
    """Return the resolved rules of a stage with K_γ and flank class as its gears are sized.

    Args:
        sizing: As sized.
        stage: Pair or set.
    """
    rating = rating_of(sizing.design, stage, sizing.teeth)
    meshes = [mesh for mesh in sizing.meshes if mesh.stage == stage]
    rating = replace(rating, load_factor=max((mesh.load_factor for mesh in meshes), default=rating.load_factor))
    classes = [made.grade for made in _made(meshes)]
    if rating.rules.iso6336.tolerance_class is not None or not classes:
        return rating
    table = rating.rules.iso6336.model_copy(update={"tolerance_class": int(min(classes))})
    return replace(rating, rules=rating.rules.model_copy(update={"iso6336": table}))


def made_of(mesh: MeshSizing) -> Made | None:
    """Return relief and class of the teeth of a mesh; None where its method knows none.

    Args:
        mesh: As sized.
    """
    return mesh.rating.made if isinstance(mesh.rating, Iso6336Rating) else None


def gear_relief(sizing: Sizing, gear: str) -> float | None:
    """Return the tip relief of a gear, the least of those of its meshes [m]; None where its method knows none.

    Args:
        sizing: As sized.
        gear: Its name.
    """
    reliefs = [made.relief for made in _made(mesh for mesh in sizing.meshes if gear in mesh.gears)]
    return min(reliefs, default=None)


def _made(meshes: Iterator[MeshSizing] | list[MeshSizing]) -> Iterator[Made]:
    return (made for mesh in meshes if (made := made_of(mesh)) is not None)
