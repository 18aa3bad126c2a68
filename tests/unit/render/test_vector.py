"""Figures as values: round numbers, scales and decimation by hand; SVG that every reader of XML takes."""

import xml.etree.ElementTree as ET

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.particulars import particulars
from gearwright.render.figures.masses import margin_figure, mass_figure
from gearwright.render.schematic import schematic_figure
from gearwright.render.vector.layout import Scale, linear_ticks, log_ticks, nice_step
from gearwright.render.vector.svg import COLUMN, extremes, svg_text, thinned

SVG = "{http://www.w3.org/2000/svg}"


def test_steps_are_one_two_or_five_times_a_power_of_ten():
    assert [nice_step(span, 5) for span in (5.0, 5.1, 10.1, 25.1, 0.5)] == pytest.approx([1.0, 2.0, 5.0, 10.0, 0.1])


def test_numbers_of_an_axis_stand_inside_it():
    assert linear_ticks(-0.3, 1.1, 5).names == ["0.0", "0.5", "1.0"]
    assert linear_ticks(-4.0, 4.0, 4).names == ["−4", "−2", "0", "2", "4"]
    assert log_ticks(1e-6, 1.0).names[0] == "$10^{−6}$"


def test_a_logarithmic_scale_puts_the_geometric_mean_in_the_middle():
    scale = Scale(1.0, 100.0, 20.0, 80.0, log=True)
    assert scale.place(10.0) == pytest.approx(50.0)
    assert scale.place(0.0) < 20.0  # a curve leaves the paper downwards


def test_thinning_keeps_the_one_peak_among_many_points():
    x = np.linspace(0.0, 50.0, 100_000)
    y = np.where(np.arange(len(x)) == 54_321, 9.0, 0.0)
    kept = extremes(np.stack([x, y], axis=1))
    assert kept[:, 1].max() == 9.0
    assert len(kept) <= 2.0 * (50.0 / COLUMN + 1.0) + 2.0


def test_a_path_that_repeats_is_drawn_once():
    angle = np.linspace(0.0, 40.0 * np.pi, 40_001)
    pieces = thinned(10.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1))
    assert sum(map(len, pieces)) < 700  # of one turn: 63 mm in grains of 0.2 mm, some corners twice


def test_every_figure_is_xml_with_text_title_and_ids_of_its_own(in_line_h2):
    figures = (mass_figure(particulars(in_line_h2)), margin_figure(in_line_h2), schematic_figure(in_line_h2))
    for figure in figures:
        root = ET.fromstring(svg_text(figure, "a"))
        assert len(root.findall(f".//{SVG}text")) > 5
        assert root.find(f"{SVG}title").text
        assert all(node.get("id").startswith("a-") for node in root.iter() if node.get("id"))


def test_a_figure_writes_itself_as_the_name_asks(in_line_h2, tmp_path):
    mass_figure(particulars(in_line_h2)).savefig(tmp_path / "mass.svg")
    mass_figure(particulars(in_line_h2)).savefig(tmp_path / "mass.png")
    assert (tmp_path / "mass.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "mass.svg").stat().st_size < 10_000
    with pytest.raises(DesignError, match="is not drawn"):
        mass_figure(particulars(in_line_h2)).savefig(tmp_path / "mass.tiff")
