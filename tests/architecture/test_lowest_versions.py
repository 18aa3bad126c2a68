"""The environment of lowest versions has what pyproject.toml allows at least, neither more nor less."""

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]


def minimums():
    """Return the least versions of what gearwright and its tests need, by name."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    asked = [*project["dependencies"], *project["optional-dependencies"]["test"]]
    return dict(re.fullmatch(r"([\w-]+)>=([\d.]+)", one).groups() for one in asked)


def test_every_minimum_is_the_version_with_which_the_lowest_environment_runs():
    """`.ci/lowest` installs these; a minimum that is raised or lowered is tried before it is stated."""
    lines = (ROOT / "constraints-lowest.txt").read_text(encoding="utf-8").splitlines()
    pins = dict(line.lower().split("==") for line in lines if "==" in line)

    def numbers(version):
        return [int(part) for part in [*version.split("."), "0", "0"][:3]]

    assert {name: numbers(pins[name.lower()]) for name in minimums()} == {
        name: numbers(version) for name, version in minimums().items()
    }
