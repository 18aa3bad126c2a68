"""Functions stay short, and the project speaks only of itself."""

import ast
import re
import subprocess
from collections import defaultdict
from pathlib import Path

import pytest
from sources import MODULES, breaking, functions, tree

ROOT = Path(__file__).parents[2]
LONGEST_FUNCTION, MOST_ARGUMENTS = 70, 9
HOMES = re.compile(r"(?<![\w.])/(?:work|opt|home|root|Users|tmp)/[\w.-]+")
REGISTRIES = re.compile(
    r"\b(?:pypi\.org|files\.pythonhosted\.org|conda\.anaconda\.org|artifactory|nexus|devpi)\b", re.IGNORECASE
)
HOW = "tests/architecture/test_size_and_words.py"


def too_long(path):
    """Return the functions of a module that are too long, or take too much."""
    wrong = []
    for function in functions(path):
        arguments = function.args
        count = len(arguments.posonlyargs) + len(arguments.args) + len(arguments.kwonlyargs)
        # Options of commands, and looks of marks in the drawing verbs of a panel, are told apart by their names.
        is_command = "commands" in path.parts or path.parts[-2:] == ("vector", "figure.py")
        # A wrapper may pass on what it wraps, typed by a ParamSpec, or as the library takes it whose place it takes;
        # nothing else takes what it does not name.
        loose = (
            arguments.kwarg is not None
            and path.parent.name != "lanes"
            and not ast.unparse(arguments.kwarg.annotation).endswith(".kwargs")
        )
        long = function.end_lineno - function.lineno >= LONGEST_FUNCTION
        if long or loose or (count > MOST_ARGUMENTS and not is_command):
            wrong.append(function.name)
    return wrong


def test_functions_are_short():
    assert breaking(too_long) == {}


def test_no_module_is_a_drawer_for_everything():
    names = {path.stem for path in MODULES.values()}
    assert not names & {"utils", "helpers", "misc", "common", "core", "tools"}


def test_concrete_classes_do_not_inherit_from_each_other():
    """Records, exceptions, enumerations, protocols and tuples are no implementations."""
    allowed = {
        "BaseModel",
        "Record",
        "Exception",
        "FutureWarning",
        "GearwrightError",
        "NamedTuple",
        "StrEnum",
        "IntEnum",
        "Enum",
        "Protocol",
        "Generic",
        "Machine",  # abstract, as are
        "ElectricMachine",
        "Airscrew",  # what machines of a file share
        "Shown",  # which has no fields: repr and notebook form
        "Mark",  # of a figure: layer and name in the legend, which all marks have
        "Console",  # of rich, and
        "TypeError",
        "str",  # of which the names of lanes are one, as words take them, and
        "InLanes",  # of which there is one, whose operators need functions of it
        "NodeTransformer",
        "SourceFileLoader",
        "MetaPathFinder",  # of Python's import, and
        "TyperGroup",  # of typer,
        "H11Protocol",  # of uvicorn, and
        "ExplicitComponent",  # of OpenMDAO, which are extended in this way alone
    }
    for path in MODULES.values():
        for node in ast.walk(tree(path)):
            if isinstance(node, ast.ClassDef):
                plain = [base.value if isinstance(base, ast.Subscript) else base for base in node.bases]
                bases = {getattr(base, "id", getattr(base, "attr", "")) for base in plain}
                assert bases <= allowed, f"{path}: {node.name}"


def test_no_name_of_a_class_stands_twice_within_a_layer():
    places = defaultdict(list)
    for module, path in MODULES.items():
        for node in ast.walk(tree(path)):
            if isinstance(node, ast.ClassDef):
                places[Path(module).parts[0], node.name].append(module)
    assert {name: modules for name, modules in places.items() if len(modules) > 1} == {}


def tracked():
    """Return the text files of the project."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False)
    if listed.returncode:
        pytest.skip("this is no working copy of the repository")
    for name in listed.stdout.split("\0"):
        path = ROOT / name
        if name and name != HOW and path.is_file():
            try:
                yield name, path.read_text(encoding="utf-8")
            except UnicodeDecodeError:
                continue


def test_no_path_of_a_machine_and_no_host_of_a_registry():
    found = [
        f"{name}: {match.group()}"
        for name, text in tracked()
        for pattern in (HOMES, REGISTRIES)
        for match in pattern.finditer(text)
    ]
    assert found == []


def test_the_patterns_find_what_they_should():
    assert HOMES.search("see /home/someone/file")
    assert not HOMES.search("src/home/page and a/tmp/b")
    assert REGISTRIES.search("https://pypi.org/simple")


def test_the_readme_and_the_checks_run_the_same_test_command():
    """One line that makes the environment, installs the project and runs pytest."""
    readme, run = (ROOT / name for name in ("README.md", ".ci/run"))
    if not run.exists() or "pytest" not in readme.read_text(encoding="utf-8"):
        pytest.skip("the README states no test command yet")
    commands = [
        {
            _plain(line)
            for line in path.read_text(encoding="utf-8").splitlines()
            if "pytest" in line and "-m venv" in line
        }
        for path in (readme, run)
    ]
    assert commands[1], "the checks run no pytest"
    assert commands[0] & commands[1]


def _plain(line):
    """Return a command with the interpreter's name made one."""
    return line.strip().replace('"$python"', "python3").replace("`", "")
