"""What a load-sharing study shows: words, JSON, figures, page."""

from __future__ import annotations

import functools

import numpy as np
import pytest

from gearwright.dynamics.sharing import (
    PlanetSharing,
    SharingStudy,
    floating,
    parallel_meshes,
    sharing_problem,
    sharing_study,
    slow_displacement,
    support_sweep,
)
from gearwright.errors import DesignError
from gearwright.render.answers.motion import sharing_answer
from gearwright.render.answers.schema import plain
from gearwright.render.figures.dynamics import (
    allocation_figure,
    displacement_figure,
    distribution_figure,
    load_factor_figure,
    orbit_figure,
    sharing_figure,
    support_figure,
    tornado_figure,
)
from gearwright.render.pages.motion import sharing_page, summary
from gearwright.render.style import to_svg
from gearwright.replays import paper_on
from gearwright.replays.wang.claims import split_torque
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size
from gearwright.spec import read

TABLES = {"a table": {3: 1.1, 4: 1.25}}


@functools.cache
def sized(name="face-gear-split-torque") -> Sizing:
    return size(read(shipped_design(name)))


@functools.cache
def studied() -> SharingStudy:
    return sharing_study(sharing_problem(sized()), target=0.52)


def test_summary_answers_the_question():
    words = " ".join(summary(studied()))
    for part in ("loops of the load in the train: 1", "second.left 49.80%", "95 % below 53.5", "+0.305 mrad"):
        assert part in words


def test_shares_that_the_design_states_are_told_from_the_elastic_ones():
    """`share` reaches sizing alone: the text and the JSON say so beside what stiffness gives."""
    design = read(shipped_design("face-gear-split-torque"))
    pairs = {**design.pairs, "second": design.pairs["second"].model_copy(update={"share": [0.6, 0.4]})}
    problem = sharing_problem(size(design.model_copy(update={"pairs": pairs})))
    study = sharing_study(problem, method="quasi-static")
    line = "stated in the design and taken by sizing: second.left 60.00%, second.right 40.00%; all below is what"
    assert summary(study)[1].startswith(line)
    assert "without errors: second.left 49.80%" in summary(study)[2]
    assert [path.stated for path in sharing_answer(study).paths] == [0.6, 0.4]
    assert [path.stated for path in sharing_answer(studied()).paths] == [None, None]
    assert [path.without_errors for path in sharing_answer(study).paths] == pytest.approx([0.498, 0.502], abs=1e-4)


def test_the_answer_holds_what_the_tables_show():
    content = plain(sharing_answer(studied()))
    sizes = {row["error"]: row for row in content["allocation"]["tolerances"]}
    assert [path["path"] for path in content["paths"]] == ["second.left", "second.right"]
    assert content["allocation"]["reached"] == pytest.approx(0.52, abs=1e-6)
    assert content["allocation"]["gearboxes_percent"] == pytest.approx(95.0)
    assert sizes["left eccentricity"]["given_mm"] == pytest.approx(25e-3)
    assert sizes["left eccentricity"]["allowed_mm"] < 15e-3
    assert content["influences"][0]["effect"] == pytest.approx(0.01054, rel=1e-3)


def test_every_figure_is_drawn_and_the_same_twice():
    study, time = studied(), np.linspace(0.0, 0.02, 50)
    sweep = support_sweep(sized(), "input", [1e7, 1e9])
    paths = {shaft: slow_displacement(study.problem, shaft, time) for shaft in ("input", "left")}
    draw = {
        "load sharing": lambda: sharing_figure({"load sharing": study.sharing}),
        "tornado": lambda: tornado_figure(study),
        "distribution": lambda: distribution_figure(study, 0.52),
        "allocation": lambda: allocation_figure(study.allocation),
        "support": lambda: support_figure(sweep, {1e7: "design"}),
        "displacement": lambda: displacement_figure({"design": paths["input"]}, "input", time),
        "load factor": lambda: load_factor_figure(
            {"three and four": PlanetSharing((3, 4), np.ones((2, 9)) * 1.2, 1)}, TABLES
        ),
        "orbit": lambda: orbit_figure(paths),
    }
    for one in draw.values():
        svg = to_svg(one())
        assert svg.count("<path") > 3 and svg.count("<text") > 8
        assert svg == to_svg(one())


def test_page_stands_alone():
    page = sharing_page(sized(), [studied()], floats=floating(sized()), target=0.52, paper=paper_on(sized()))
    assert "Stage second" in page
    assert page.count("<svg") == 11
    assert 'src="http' not in page
    assert 'href="http' not in page.replace('xlink:href="#', "").replace("http://www.w3.org", "")


def test_every_error_that_the_paper_shows_alone_is_one_of_the_design():
    """Figures 8 to 18 of the paper, one error each."""
    names, shown = {source.name for source in studied().problem.sources}, split_torque(sized().design).single_errors
    assert set(shown) <= names
    assert sorted(int(word.split()[1]) for word in shown.values()) == list(range(8, 19))


def test_planets_have_no_clocking_and_share_equally_without_errors():
    study = sharing_study(sharing_problem(sized("single-planetary")))
    assert study.clocking is None
    assert study.sharing.load_factor == pytest.approx(1.0, abs=1e-6)


def test_stage_without_parallel_meshes_is_refused_with_those_that_have_some():
    assert set(parallel_meshes(sized())) == {"first", "second"}
    with pytest.raises(DesignError, match="did you mean first"):
        sharing_problem(sized(), "firstt")


def test_target_without_errors_is_refused():
    with pytest.raises(DesignError, match="gives no error to tighten"):
        sharing_study(sharing_problem(sized("off-set")), target=0.52)


def test_sweep_of_a_shaft_in_rigid_bearings_is_refused():
    with pytest.raises(DesignError, match=r"add \[supports.input\]"):
        support_sweep(sized("off-set"), "input", [1e7])
