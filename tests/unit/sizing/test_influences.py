"""What moves the margins of a mesh: laws of the formulas, and the wished value met when the design is sized with it."""

import pytest

from designs import PAIR
from gearwright.shipped import shipped_design
from gearwright.sizing import MeshInfluences, influences, size
from gearwright.sizing.insight import sized_meshes
from gearwright.spec import parse, read

DESIGN = (
    f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n\n[gears]\nrating = "METHOD"\nhelix_angle_deg = 0\n'
    '[overrides]\n"stage.module_mm" = MODULE\n"stage.face_width_mm" = WIDTH\n'
)


def design(method: str, module: float = 3.0, width: float = 30.0) -> str:
    return DESIGN.replace("METHOD", method).replace("MODULE", f"{module:.9g}").replace("WIDTH", f"{width:.9g}")


def moved(method: str, wish: float = 1.0) -> MeshInfluences:
    (mesh,) = influences(size(parse(design(method))), wish)
    return mesh


def slopes(mesh: MeshInfluences) -> dict[str, tuple[float, float]]:
    return {row.handle: (row.flank, row.root) for row in mesh.rows}


def test_lewis_and_hertz_move_by_their_powers():
    """S_F = σ b m_n Y/F_t ~ b m_n² with F_t ~ 1/m_n; S_H ~ √(b d/F_t) ~ b^½ m_n."""
    assert slopes(moved("lewis-hertz")) == {
        "face width b": (pytest.approx(0.5, abs=1e-4), pytest.approx(1.0, abs=1e-4)),
        "module m_n": (pytest.approx(1.0, abs=1e-4), pytest.approx(2.0, abs=1e-4)),
    }


def test_agma_stresses_go_with_the_overload_and_its_root():
    flank, root = slopes(moved("agma2001"))["application factor K_A"]
    assert (flank, root) == (pytest.approx(-0.5, abs=1e-6), pytest.approx(-1.0, abs=1e-6))


def test_roughness_and_oil_move_flanks_alone_and_fillets_roots_alone():
    """Z_R = (3 µm/R_z10)^0.08 at σ_Hlim of 1200 N/mm² and beyond."""
    found = slopes(moved("iso6336"))
    assert found["flank roughness R_z"] == (pytest.approx(-0.08, abs=1e-6), 0.0)
    assert found["oil ν_40 in mm²/s"][0] > 0.0 == found["oil ν_40 in mm²/s"][1]
    assert found["root roughness R_z"][0] == 0.0 > found["root roughness R_z"][1]


@pytest.mark.parametrize("method", ["iso6336", "din3990", "agma2001", "lewis-hertz"])
@pytest.mark.parametrize("wish", [0.8, 1.3])
def test_a_design_with_the_wanted_module_has_the_wished_margin(method, wish):
    mesh = moved(method, wish)
    module = next(row.wanted for row in mesh.rows if row.handle == "module m_n")
    assert module is not None
    rated = size(parse(design(method, module=1e3 * module))).meshes[0].rating
    assert min(rated.contact_margin, rated.bending_margin) == pytest.approx(wish, rel=1e-6)


def test_what_never_reaches_the_wish_is_said_to_be_none():
    rows = {row.handle: row.wanted for row in moved("iso6336", 3.0).rows}
    assert rows["flank roughness R_z"] is None


@pytest.mark.parametrize("name", ["ec120b", "in-line", "off-set"])
def test_every_mesh_is_rated_again_as_it_was_sized(name):
    """Bevel gears by their mean module, planets by their share of the load, cases by Miner's sum."""
    sizing = size(read(shipped_design(name)))
    rated = {mesh.row.name: mesh.rated() for mesh in sized_meshes(sizing)}
    assert set(rated) == {mesh.name for mesh in sizing.meshes if mesh.rating.method}
    for mesh in sizing.meshes:
        if mesh.rating.method:
            found = rated[mesh.name]
            assert (found.contact_margin, found.bending_margin) == pytest.approx(
                (mesh.rating.contact_margin, mesh.rating.bending_margin), rel=1e-12
            )


def test_a_factor_says_at_which_limit_it_stands():
    """At 24 teeth K_Hα of class 5 is within its limits; Z_W of two hard gears is not, and σ_Hlim counts as 1200."""
    from gearwright.sizing.rating import METHODS

    rating = size(parse(design("iso6336"))).meshes[0].rating
    rows = {(row.chapter, row.quantity): row.limit for row in METHODS["iso6336"].factors(rating)}
    assert rows["strength of flanks", "work hardening"] == "least"
    assert rows["strength of flanks", "lubricant"] == "σ_Hlim counts as 1200"
    assert rows["strength of roots", "size"] == "greatest"
    assert rows["pitting", "zone"] == ""
