"""What computes is told apart by versions and by the files themselves."""

from pathlib import Path

from gearwright.study.journal import changes_of, made_with
from gearwright.version import digest


def test_an_edited_file_a_new_one_and_a_new_name_are_noticed_and_compiled_files_are_not(tmp_path: Path) -> None:
    (tmp_path / "inner").mkdir()
    (tmp_path / "inner" / "one.py").write_text("speed = 1\n", encoding="utf-8")
    seen = [digest(tmp_path)]
    (tmp_path / "inner" / "one.py").write_text("speed = 2\n", encoding="utf-8")
    seen.append(digest(tmp_path))
    (tmp_path / "table.csv").touch()
    seen.append(digest(tmp_path))
    (tmp_path / "table.csv").rename(tmp_path / "other.csv")
    seen.append(digest(tmp_path))
    assert len(set(seen)) == 4
    (tmp_path / "inner" / "__pycache__").mkdir()
    (tmp_path / "inner" / "__pycache__" / "one.pyc").touch()
    assert digest(tmp_path) == seen[-1]


def test_the_libraries_that_compute_are_named() -> None:
    assert made_with().keys() == {"gearwright", "python", "numpy", "scipy", "numba", "llvmlite"}


def test_what_differs_is_told_with_both_versions() -> None:
    then, now = {"numpy": "1.26.0", "scipy": "1.12.0"}, {"numpy": "2.0.0", "scipy": "1.12.0", "numba": "0.60"}
    assert changes_of(then, now) == [("numpy", "1.26.0", "2.0.0"), ("numba", "none", "0.60")]
