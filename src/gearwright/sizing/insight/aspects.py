"""The factors that methods share under other names, and why their values differ: data for the comparison."""

from __future__ import annotations

from typing import NamedTuple

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
