"""Rows of stages, data of pairs and named results, computed once more from gears, teeth and forces."""

import math

import pytest
from shaft_designs import INTERNAL

from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import named_results, pair_data, size
from gearwright.sizing.arrangement import envelope
from gearwright.sizing.summaries import stage_summaries
from gearwright.spec import edited, parse, read

KINDS = {
    "in-line-h2": ["planetary", "planetary"], "star": ["star"], "off-set": ["parallel pairs", "parallel pairs"],
    "single-planetary": ["planetary"], "ec120b": ["pair", "pair"],
}  # fmt: skip


@pytest.mark.parametrize("name", KINDS)
def test_a_row_of_a_stage_is_what_its_gears_are(name):
    """Torque of one mesh on the first gear, K_γ included; module and width of that gear; the mass of all its bodies."""
    sizing = size(read(shipped_design(name)))
    gears = {gear.name: gear for gear in sizing.gears}
    rows = list(stage_summaries(sizing, name))
    assert [row.kind for row in rows][: len(KINDS[name])] == KINDS[name]
    for row in rows:
        meshes = [mesh for mesh in sizing.meshes if mesh.stage == row.stage]
        first = gears[meshes[0].gears[0]]
        assert (row.design, row.module, row.face_width) == (name, first.module, first.face_width)
        own = [gear for gear in sizing.gears if gear.stage == row.stage]
        assert row.mass == pytest.approx(sum(gear.mass * gear.bodies for gear in own))
        torques = []
        for mesh in meshes:
            loads = [abs(flow.meshes[mesh.name].multiplier) for flow in sizing.flows.values()]
            torques.append(max(loads) * first.teeth / mesh.count * mesh.load_factor)
        assert row.torque == pytest.approx(max(torques))


@pytest.mark.parametrize("name", shipped_designs())
def test_torques_on_every_shaft_close_with_clutches_and_dampers(name):
    """What machines, links and gears give to a shaft adds up to nothing in every case."""
    sizing = size(read(shipped_design(name)))
    for flow in sizing.flows.values():
        for shaft in sizing.design.shafts:
            torque = [
                flow.machine_torques.get(machine, 0.0) for machine, at in sizing.train.machines.items() if at == shaft
            ]
            for link in sizing.train.links:
                torque.append(flow.given(link.name) * ((link.driven == shaft) - (link.driving == shaft)))
            for mesh in sizing.train.meshes:
                sides = zip(mesh.nodes, flow.meshes[mesh.name].torques, strict=True)
                torque += [part for node, part in sides if node == shaft]
            assert abs(sum(torque)) <= 1e-9 * max(1.0, *map(abs, torque))


@pytest.mark.parametrize("internal", [False, True])
def test_data_of_a_pair_are_those_of_iso_21771(internal):
    """Diameters, span over k teeth (none in a ring), overlap; root circles by the rack of 1.25."""
    design = parse(INTERNAL) if internal else read(shipped_design("off-set"))
    sizing = size(edited(design, {"gears.rating": "iso6336"}))
    mesh = sizing.meshes[0]
    gears = {gear.name: gear for gear in sizing.gears}
    first, second = (gears[name] for name in mesh.gears)
    data = pair_data(sizing, mesh)
    module, beta = first.module, first.helix_angle
    alpha = sizing.design.rules(mesh.stage).pressure_angle
    transverse = math.atan(math.tan(alpha) / math.cos(beta))
    shift = 0.0 if internal else sizing.design.rules(mesh.stage).profile_shift
    side = -1.0 if internal else 1.0
    for k, (gear, x) in enumerate(((first, shift), (second, -shift))):
        outward = side if k else 1.0
        pitch = gear.teeth * module / math.cos(beta)
        assert data.pitch_diameter[k] == pytest.approx(pitch)
        assert data.base_diameter[k] == pytest.approx(pitch * math.cos(transverse))
        assert data.tip_diameter[k] == pytest.approx(pitch + outward * 2.0 * (1.0 + x) * module)
        assert data.root_diameter[k] == pytest.approx(pitch - outward * 2.0 * (1.25 - x) * module)
        assert data.profile_shift[k] == pytest.approx(x)
        if not internal:
            involute = math.tan(transverse) - transverse
            teeth = data.spanned_teeth[k]
            span = math.pi * (teeth - 0.5) + gear.teeth * involute + 2.0 * x * math.tan(alpha)
            assert data.span[k] == pytest.approx(module * math.cos(alpha) * span)
    if internal:
        assert data.span is None and data.spanned_teeth is None
    apart = (second.pitch_diameter + side * first.pitch_diameter) / 2.0
    assert data.centre_distance == pytest.approx(apart)
    assert data.overlap_ratio == pytest.approx(data.face_width * math.sin(beta) / (math.pi * module))
    part = f"{mesh.stage} contact ratio"
    checked = next(check.value for check in sizing.checks if check.name == part)
    assert checked == pytest.approx(data.transverse_contact_ratio)
    assert data.teeth == (first.teeth, second.teeth) and data.face_width == min(first.face_width, second.face_width)


def test_named_results_have_their_dimensions():
    sizing = size(read(shipped_design("off-set")))
    results = named_results(sizing)
    box = envelope(sizing)
    assert results["envelope.volume"] == (box.volume, "volume")
    for side in ("width", "height", "length"):
        assert results[f"envelope.{side}"] == (getattr(box, side), "length")
    for gear in sizing.gears:
        assert results[f"gears.{gear.name}.teeth"].value == gear.teeth
        assert results[f"gears.{gear.name}.mass"] == (gear.mass, "mass")
        assert results[f"gears.{gear.name}.module"] == (gear.module, "length")
    assert results["power_density"].dimension == "specific_power" and results["worst_margin"].dimension == "ratio"


def test_shafts_of_one_axis_stand_where_the_first_of_them_does():
    """Members of sets, and what clutches join; in whatever order the file names them."""
    for name in ("in-line-h2", "twin-engine-sprag", "mixed-h2"):
        sizing = size(read(shipped_design(name)))
        axes = sizing.arrangement.axes
        for stage in sizing.design.planetaries.values():
            places = {axes[member] for member in (stage.sun, stage.ring, stage.carrier) if member in axes}
            assert len(places) == 1
        for link in sizing.train.links:
            assert axes[link.driving] == axes[link.driven]
        assert axes[sizing.design.shafts[0]] == 0j
