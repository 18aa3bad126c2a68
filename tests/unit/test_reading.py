"""Files that a user names: regular ones, below a limit, and in the folder of the file that names them."""

import os
from pathlib import Path

import pytest

from designs import PAIR
from gearwright.catalogue import read_propeller_map
from gearwright.catalogue.propeller_maps import LARGEST_MAP
from gearwright.errors import DesignError
from gearwright.files import LARGEST_TEXT, beside, text_of
from gearwright.shipped import find_design, shipped_mission
from gearwright.spec import parse, parse_mission, parse_study, read, read_mission, read_study
from gearwright.store import load
from gearwright.study.journal import reading

CURVE = PAIR + '[dynamics.curves.stage]\nfile = "{}"\n'
STUDY = 'schema = 1\nname = "s"\ndesigns = ["in-line-h2"]\n'


def _journal(path: Path) -> None:
    with reading(path):
        raise AssertionError("it was opened")


@pytest.mark.parametrize(
    "use", [text_of, read, read_mission, read_study, read_propeller_map, load, _journal], ids=lambda use: use.__name__
)
@pytest.mark.parametrize("kind", ["pipe", "device", "folder"])
def test_nothing_but_a_regular_file_is_opened(tmp_path: Path, use, kind: str) -> None:
    """A pipe that nobody writes into would block, and a device has no end."""
    path = {"pipe": tmp_path / "pipe", "device": Path("/dev/zero"), "folder": tmp_path}[kind]
    if kind == "pipe":
        os.mkfifo(path)
    with pytest.raises(DesignError, match="folder" if kind == "folder" else "a pipe or a device") as caught:
        use(path)
    assert str(path) in str(caught.value)


def test_a_curve_is_no_device(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    with pytest.raises(DesignError, match=r"dynamics\.curves\.stage\.file: .*pipe\.csv: this is a pipe or a device"):
        parse(CURVE.format("pipe.csv"), folder=tmp_path)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("/etc/passwd", "/etc/passwd: this path is absolute"),
        ("../secret.csv", "../secret.csv: this path leads upwards"),
        ("a/../../secret.csv", "leads upwards"),
        ("..\\\\secret.csv", "leads upwards"),
        ("C:\\\\secret.csv", "is absolute"),
        ("link.csv", "link.csv: a link leads out of the folder"),
        ("below/secret.csv", "a link leads out of the folder"),
        ("circle.csv", "circle.csv"),
        ("a\\u0000b.csv", "control characters have no place in it"),
    ],
)
def test_a_file_that_a_design_names_lies_in_its_folder(tmp_path: Path, name: str, said: str) -> None:
    home, other = tmp_path / "home", tmp_path / "other"
    home.mkdir()
    other.mkdir()
    (other / "secret.csv").write_text("phase_cycles,stiffness_n_m\nkeep,this\n", encoding="utf-8")
    (home / "link.csv").symlink_to(other / "secret.csv")
    (home / "below").symlink_to(other)
    (home / "circle.csv").symlink_to(home / "circle.csv")
    with pytest.raises(DesignError) as caught:
        parse(CURVE.format(name), folder=home)
    assert said in str(caught.value)
    assert "keep" not in str(caught.value)


def test_a_file_below_the_folder_is_read_and_so_is_a_link_that_stays_inside(tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    rows = "".join(f"{k / 4},{5e8 + k % 2 * 1e7}\n" for k in range(4))
    (tmp_path / "data" / "curve.csv").write_text(f"phase_cycles,stiffness_n_m\n{rows}", encoding="utf-8")
    (tmp_path / "link.csv").symlink_to(tmp_path / "data" / "curve.csv")
    for name in ("data/curve.csv", "link.csv"):
        design = parse(CURVE.format(name), folder=tmp_path)
        assert design.dynamics.curves["stage"].phase_cycles == [0.0, 0.25, 0.5, 0.75]


def test_what_stands_in_a_file_that_is_no_table_is_not_told(tmp_path: Path) -> None:
    (tmp_path / "curve.csv").write_text("phase_cycles,stiffness_n_m\n0.0,hunter2\n", encoding="utf-8")
    with pytest.raises(DesignError, match="line 2") as caught:
        parse(CURVE.format("curve.csv"), folder=tmp_path)
    assert "hunter2" not in str(caught.value)


@pytest.mark.parametrize("use", [read, read_mission, read_study], ids=lambda use: use.__name__)
@pytest.mark.parametrize("size", [LARGEST_TEXT + 1, 100 * LARGEST_TEXT])
def test_a_file_beyond_the_limit_is_refused(tmp_path: Path, use, size: int) -> None:
    path = tmp_path / "large.toml"
    with path.open("wb") as file:
        file.truncate(size)
    with pytest.raises(DesignError, match=f"more than {LARGEST_TEXT:,} bytes"):
        use(path)


def test_a_map_beyond_the_limit_of_maps_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "large.csv"
    with path.open("wb") as file:
        file.truncate(LARGEST_MAP + 1)
    with pytest.raises(DesignError, match=f"more than {LARGEST_MAP:,} bytes"):
        read_propeller_map(path)


def test_a_study_names_designs_missions_and_maps_in_its_folder_only(tmp_path: Path) -> None:
    with pytest.raises(DesignError, match=r"designs: \.\./mine\.toml: this path leads upwards"):
        find_design("../mine.toml", tmp_path)
    assert find_design("../mine.toml") == Path("../mine.toml"), "a command may be given any path"
    with pytest.raises(DesignError, match=r"fly\.mission: /m\.toml: this path is absolute"):
        parse_study(f'{STUDY}[fly]\nmission = "/m.toml"\n', folder=tmp_path)
    flown = f'{STUDY}[fly]\nmission = "thesis"\n'
    with pytest.raises(DesignError, match=r"axes\.mission\.propeller_map: /x\.csv: this path is absolute"):
        parse_study(f'{flown}[axes]\n"mission.propeller_map" = {{values = ["/x.csv", "none"]}}\n', folder=tmp_path)
    study = parse_study(f'{flown}[changes]\n"mission.propeller_map" = "own.csv"\n', folder=tmp_path)
    assert study.changes["mission.propeller_map"] == str((tmp_path / "own.csv").resolve())


def test_a_mission_names_a_map_in_its_folder(tmp_path: Path) -> None:
    text = shipped_mission("thesis").read_text(encoding="utf-8").replace('"6-blades-af115"', '"../map.csv"')
    with pytest.raises(DesignError, match=r"propeller_map: \.\./map\.csv: this path leads upwards"):
        parse_mission(text, folder=tmp_path)


def test_a_map_of_more_points_than_memory_takes_is_refused_with_their_number(tmp_path: Path) -> None:
    rows = "".join(f"{k / 1000},{k / 1000},0.1,0.1\n" for k in range(1000))
    head = "advance_ratio,blade_angle_deg,power_coefficient,thrust_coefficient\n"
    (tmp_path / "map.csv").write_text(head + rows, encoding="utf-8")
    with pytest.raises(DesignError, match=r"1,000 advance ratios by 1,000 blade angles are more than 250,000"):
        read_propeller_map(tmp_path / "map.csv")


def test_a_map_of_what_no_propeller_has_is_refused(tmp_path: Path) -> None:
    head = "advance_ratio,blade_angle_deg,power_coefficient,thrust_coefficient\n"
    (tmp_path / "map.csv").write_text(f"{head}0,20,1e308,0.1\n", encoding="utf-8")
    with pytest.raises(DesignError, match="line 2: power_coefficient is not from -20 to 20"):
        read_propeller_map(tmp_path / "map.csv")


def test_a_path_that_no_file_can_have_is_refused(tmp_path: Path) -> None:
    for name in ("a\0b", "x" * 5000):
        with pytest.raises(DesignError) as caught:
            read(tmp_path / name)
        assert len(str(caught.value)) < 400
    assert beside("a.csv", tmp_path, "file") == tmp_path / "a.csv"
