"""A study in parts on machines that know nothing of each other: the same rows, whatever died."""

from pathlib import Path

import h5py
import pytest
from typer.testing import CliRunner

from gearwright.cli import app
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.spec import edited, parse_study, read
from gearwright.study import run
from gearwright.study.journal import rows_of, status
from gearwright.study.running import Part, merge, part_of, resume, run_study, slurm

NAME = "single-planetary"
DESIGNS = {NAME: read(shipped_design(NAME))}


def study_of(method="sobol", *, name="parts"):
    return parse_study(f"""
schema = 1
name = "{name}"
designs = ["{NAME}"]
results = ["mass"]
{"[objectives]" if method == "nsga2" else ""}
{'mass = "minimum"' if method == "nsga2" else ""}
[axes]
"gears.contact_safety" = {{from = 1.0, to = 1.6}}
[sampling]
method = "{method}"
count = 23
seed = 3
""")


def test_merged_parts_are_the_whole_study_bit_for_bit(tmp_path: Path) -> None:
    study = study_of()
    paths = [tmp_path / f"{number}.journal" for number in (1, 2, 3)]
    for number, path in enumerate(paths, start=1):
        run_study(study, DESIGNS, journal=path, part=Part(number, 3))
        assert status(path).done == len(Part(number, 3).cases(23))
    assert merge(paths, tmp_path / "all") == (23, 23)
    assert rows_of(tmp_path / "all") == list(run(study, DESIGNS).rows)


def test_what_a_part_lacks_is_computed_by_whoever_resumes(tmp_path: Path) -> None:
    study = study_of()
    run_study(study, DESIGNS, journal=tmp_path / "1", part=Part(1, 4))
    run_study(study, DESIGNS, journal=tmp_path / "3", part=Part(3, 4))
    assert merge([tmp_path / "1", tmp_path / "3", tmp_path / "1"], tmp_path / "all") == (12, 23)
    assert len(resume(tmp_path / "all", part=Part(2, 4)).rows) == 6
    assert merge([tmp_path / "1"], tmp_path / "all") == (18, 23)
    assert status(tmp_path / "all").done == 18
    assert resume(tmp_path / "all") == run(study, DESIGNS)


@pytest.mark.parametrize("text", ["0/8", "9/8", "a/b", "2", "2/", "/8", "1/0", "-1/8", "1/1000000"])
def test_what_is_no_part_is_told(text: str) -> None:
    with pytest.raises(DesignError, match="such as 2/8"):
        part_of(text)


def test_parts_of_another_study_or_design_are_refused_and_nothing_is_written(tmp_path: Path) -> None:
    run_study(study_of(), DESIGNS, journal=tmp_path / "a", part=Part(1, 2))
    run_study(study_of(name="another"), DESIGNS, journal=tmp_path / "b", part=Part(2, 2))
    other = {NAME: edited(DESIGNS[NAME], {"gears.bending_safety": 2.0})}
    run_study(study_of(), other, journal=tmp_path / "c", part=Part(2, 2))
    with pytest.raises(DesignError) as told:
        merge([tmp_path / "a", tmp_path / "b", tmp_path / "c"], tmp_path / "all")
    assert ["other axes" in str(problem) or "a design differs" in str(problem) for problem in told.value.problems] == [
        True, True
    ]  # fmt: skip
    assert not (tmp_path / "all").exists()


def test_a_search_that_goes_on_from_its_results_has_no_parts() -> None:
    with pytest.raises(DesignError, match="it has no parts"):
        run_study(study_of("nsga2"), DESIGNS, part=Part(1, 2))


def test_every_task_of_the_script_begins_or_goes_on_with_its_own_journal() -> None:
    script = slurm(Path("my study.toml"), 8)
    assert "#SBATCH --array=1-8" in script
    assert "gearwright study 'my study.toml' --shard $shard --journal 'my study'-$SLURM_ARRAY_TASK_ID.journal" in script
    assert "gearwright resume 'my study'-$SLURM_ARRAY_TASK_ID.journal --shard $shard" in script


def test_merge_writes_the_table_of_what_is_there(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    run_study(study_of(), DESIGNS, journal=Path("1"), part=Part(1, 4))
    run_study(study_of(), DESIGNS, journal=Path("2"), part=Part(2, 4))
    said = CliRunner().invoke(app, ["merge", "1", "2", "--into", "all", "--export", "all.nc"])
    assert (said.exit_code, "12 of 23 cases" in said.output, "wrote all.nc" in said.output) == (0, True, True)
    with h5py.File("all.nc") as file:
        assert file["mass"][:].tolist() == [row.shown("mass") for row in rows_of(Path("all"))]
