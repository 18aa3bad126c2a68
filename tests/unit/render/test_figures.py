import sys

import matplotlib as mpl
import numpy as np
import pytest

from gearwright.dynamics import Outputs, simulate
from gearwright.errors import DesignError
from gearwright.particulars import particulars
from gearwright.render import style as theme
from gearwright.render.figures.masses import (
    bent_shafts,
    margin_figure,
    mass_figure,
    shaft_figure,
    squarified,
    treemap_figure,
)
from gearwright.render.figures.motion import mesh_frequencies, mode_figure, spectrum, spectrum_figure, time_figure
from gearwright.render.vector.figure import Box, Curve
from gearwright.sizing.mass import complete_mass


def every_figure(sizing, modal, run):
    return [mass_figure(particulars(sizing)), margin_figure(sizing), mode_figure(modal), time_figure(run),
            spectrum_figure(run, {"first.mesh": 5e3})]  # fmt: skip


def test_the_same_input_gives_the_same_svg(in_line_h2, modal, run) -> None:
    first = [theme.to_svg(figure) for figure in every_figure(in_line_h2, modal, run)]
    second = [theme.to_svg(figure) for figure in every_figure(in_line_h2, modal, run)]
    assert first == second


def test_an_svg_needs_nothing_from_outside(in_line_h2) -> None:
    svg = theme.to_svg(mass_figure(particulars(in_line_h2)), "mass")
    assert svg.startswith("<svg")
    for word in ("<image", "<metadata", "<!DOCTYPE", "href=", "url(http", "@import"):
        assert word not in svg
    assert svg.count("<text") > 10
    assert 'id="mass-clip-0"' in svg
    assert "url(#mass-clip-0)" in svg


def test_drawing_leaves_the_settings_of_matplotlib_alone(in_line_h2) -> None:
    before = dict(mpl.rcParams)
    theme.to_png(mass_figure(particulars(in_line_h2)))
    assert dict(mpl.rcParams) == before


def test_a_png_has_the_asked_resolution(in_line_h2) -> None:
    image = theme.to_png(margin_figure(in_line_h2), 100.0)
    assert image.startswith(b"\x89PNG")
    assert int.from_bytes(image[16:20], "big") == round(180.0 / 25.4 * 100.0 - 0.5)


def test_without_matplotlib_a_png_says_what_to_install(in_line_h2, monkeypatch, tmp_path) -> None:
    monkeypatch.delitem(sys.modules, "gearwright.render.vector.pixels", raising=False)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(DesignError, match=r"PNG needs matplotlib.*\[png\].*or end the name with \.svg"):
        mass_figure(particulars(in_line_h2)).savefig(tmp_path / "mass.png")
    mass_figure(particulars(in_line_h2)).savefig(tmp_path / "mass.svg")
    assert [path.name for path in tmp_path.iterdir()] == ["mass.svg"]


def test_the_bars_of_the_mass_figure_are_the_masses(in_line_h2) -> None:
    widths = [bar.width for bar in mass_figure(particulars(in_line_h2)).axes[0].of(Box)]
    assert sum(widths) == pytest.approx(in_line_h2.parts_mass)
    assert widths[: len(widths) - 3] == sorted(widths[: len(widths) - 3], reverse=True)  # three more for the legend


def test_shaft_diagrams_reach_the_moment_and_torque_that_govern(designs) -> None:
    sizing = designs["off-set"]
    bent = bent_shafts(sizing)
    assert [shaft.name for shaft in bent] == ["left", "right", "output"]  # the input pinion's two meshes cancel
    axes = shaft_figure(sizing).axes
    for place, shaft in enumerate(bent):
        bending, torsion = (axes[3 * place + k].of(Curve)[0].y for k in (1, 2))
        stress = 32.0 / (np.pi * shaft.diameter**3) * np.hypot(bending, torsion)
        assert max(stress) == pytest.approx(shaft.stress, rel=1e-9), shaft.name  # Tresca of a solid shaft


def test_a_spectrum_gives_frequency_and_amplitude_of_a_sine() -> None:
    """3 sin(2π 250 t), whole periods in the record: Hann's window leaves the line's amplitude as it is."""
    time = np.arange(1000) / 5000.0
    frequency, amplitude = spectrum(time, 7.0 + 3.0 * np.sin(2.0 * np.pi * 250.0 * time))
    largest = int(np.argmax(amplitude))
    assert frequency[largest] == pytest.approx(250.0)
    assert amplitude[largest] == pytest.approx(3.0, rel=2e-3)  # np.hanning is the symmetric window: 1/N of its mean


def test_a_thinned_run_gives_no_spectrum(system) -> None:
    thinned = simulate(system, 0.05, outputs=Outputs(samples=20))
    with pytest.raises(DesignError, match="keep a window"):
        spectrum_figure(thinned, {})


def test_mesh_frequencies_follow_from_teeth_and_relative_speed(in_line_h2) -> None:
    """z (n_sun − n_carrier) = 54 (20 000 − 4500) / 60 = 13 950 Hz in stage 1, the same in both its meshes."""
    found = mesh_frequencies(in_line_h2, "rated")
    assert found["first.sun-planet"] == pytest.approx(in_line_h2.teeth["first.sun"] * (20000 - 4500) / 60)
    assert found["first.planet-ring"] == pytest.approx(found["first.sun-planet"])


def test_mode_shapes_leave_out_rigid_motion(modal) -> None:
    assert len(mode_figure(modal).axes) == 2


def test_areas_of_a_treemap_are_its_masses_and_cover_the_place_once(in_line_h2):
    sizes = [6.0, 6.0, 4.0, 3.0, 2.0, 2.0, 1.0]
    places = squarified(sizes, (1.0, 2.0, 6.0, 4.0))
    assert [width * height for *_, width, height in places] == pytest.approx(sizes)  # their sum is the place's area
    assert all(left >= 1.0 and left + width <= 7.0 + 1e-9 for left, _, width, _ in places)
    assert all(low >= 2.0 and low + height <= 6.0 + 1e-9 for _, low, _, height in places)
    assert max(max(width / height, height / width) for *_, width, height in places) < 3.0
    figure = treemap_figure(complete_mass(in_line_h2), 80.0, 120.0)
    assert any("second.ring" in words for words in figure.texts()) and "61 real gearboxes" in figure.texts()
