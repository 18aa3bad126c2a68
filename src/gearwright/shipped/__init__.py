"""Design, mission, mix and study files and notebooks that come with gearwright; `gearwright new` copies them."""

from collections.abc import Callable
from pathlib import Path
from typing import Literal

from gearwright.errors import DesignError, Problem, excerpt, near
from gearwright.files import beside
from gearwright.verbs import verb

_DESIGNS = Path(__file__).parent / "designs"
_MISSIONS = Path(__file__).parent / "missions"
_MIXES = Path(__file__).parent / "mixes"
_STUDIES = Path(__file__).parent / "studies"
_NOTEBOOKS = Path(__file__).parent / "notebooks"


def shipped_designs() -> tuple[str, ...]:
    """Return the names of all shipped designs."""
    return _names(_DESIGNS)


@verb
def shipped_design(name: str) -> Path:
    """Return the path of a shipped design file.

    Args:
        name: Such as ``in-line-h2``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    return _named(_DESIGNS, "design", name)


@verb
def shipped_file(name: str) -> Path:
    """Return the path of a shipped design, mission, mix or study file or notebook; no two share a name.

    Args:
        name: Such as ``in-line-h2`` or ``thesis``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    if name in shipped_missions():
        return shipped_mission(name)
    if name in shipped_mixes():
        return shipped_mix(name)
    if name in shipped_studies():
        return shipped_study(name)
    if name in shipped_notebooks():
        return shipped_notebook(name)
    if name in shipped_designs():
        return shipped_design(name)
    names = (*shipped_designs(), *shipped_missions(), *shipped_mixes(), *shipped_studies(), *shipped_notebooks())
    kinds = "design, mission, mix, study or notebook"
    raise DesignError([Problem("name", f"there is no shipped {kinds} {excerpt(name)!r}; {near(name, names)}")])


@verb
def find_design(name: str, folder: Path | None = None) -> Path:
    """Return the path of a design file, or of the shipped design of that name.

    Args:
        name: A path, or a name such as ``in-line-h2``; a file of that name comes first.
        folder: Of the study that names it, in which it must stand; left out: the path may lead anywhere.

    Raises:
        DesignError: If it looks like the name of a shipped design and is none; with the nearest one.
    """
    return _found(name, folder, shipped_design, "designs")


@verb
def find_mission(name: str, folder: Path | None = None, *, key: Literal["fly.mission", ""] = "fly.mission") -> Path:
    """Return the path of a mission file, or of the shipped mission of that name.

    Args:
        name: A path, or a name such as ``thesis``; a file of that name comes first.
        folder: Of the study or mix that names it, in which it must stand; left out: the path may lead anywhere.
        key: Entry of the file that names it.

    Raises:
        DesignError: If it looks like the name of a shipped mission and is none; with the nearest one.
    """
    return _found(name, folder, shipped_mission, key)


@verb
def find_mix(name: str) -> Path:
    """Return the path of a mix file, or of the shipped mix of that name.

    Args:
        name: A path, or a name such as ``regional-life``; a file of that name comes first.

    Raises:
        DesignError: If it looks like the name of a shipped mix and is none; with the nearest one.
    """
    return _found(name, None, shipped_mix, "")


@verb
def find_study(name: str) -> Path:
    """Return the path of a study file, or of the shipped study of that name.

    Args:
        name: A path, or a name such as ``motor-speed``; a file of that name comes first.

    Raises:
        DesignError: If it looks like the name of a shipped study and is none; with the nearest one.
    """
    return _found(name, None, shipped_study, "")


def _found(name: str, folder: Path | None, shipped: Callable[[str], Path], key: str) -> Path:
    """Return a file, or what is shipped of that name; a folder stands for itself only where nothing is."""
    path = Path(name) if folder is None else beside(name, folder, key)
    if _is_there(path, Path.is_file) or path.suffix or len(Path(name).parts) != 1:
        return path
    try:
        return shipped(name)
    except DesignError:
        if _is_there(path, Path.exists):
            return path
        raise


def _is_there(path: Path, asked: Callable[[Path], bool]) -> bool:
    """Ask for a file; a name that no file can have, as it is too long or holds a null byte, is not there."""
    try:
        return asked(path)
    except (OSError, ValueError):
        return False


def shipped_mixes() -> tuple[str, ...]:
    """Return the names of all shipped mixes."""
    return _names(_MIXES)


@verb
def shipped_mix(name: str) -> Path:
    """Return the path of a shipped mix file.

    Args:
        name: Such as ``regional-life``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    return _named(_MIXES, "mix", name)


def shipped_studies() -> tuple[str, ...]:
    """Return the names of all shipped studies."""
    return _names(_STUDIES)


@verb
def shipped_study(name: str) -> Path:
    """Return the path of a shipped study file.

    Args:
        name: Such as ``motor-speed``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    return _named(_STUDIES, "study", name)


def shipped_notebooks() -> tuple[str, ...]:
    """Return the names of all shipped notebooks."""
    return _names(_NOTEBOOKS, ".ipynb")


@verb
def shipped_notebook(name: str) -> Path:
    """Return the path of a shipped notebook.

    Args:
        name: Such as ``a-first-architecture``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    return _named(_NOTEBOOKS, "notebook", name, ".ipynb")


def shipped_missions() -> tuple[str, ...]:
    """Return the names of all shipped missions."""
    return _names(_MISSIONS)


@verb
def shipped_mission(name: str) -> Path:
    """Return the path of a shipped mission file.

    Args:
        name: Such as ``thesis``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    if name in shipped_mixes():
        raise DesignError([Problem("name", f"{name!r} is a mix of missions; gearwright mix DESIGN {name} flies it")])
    return _named(_MISSIONS, "mission", name)


def _names(folder: Path, ending: str = ".toml") -> tuple[str, ...]:
    return tuple(sorted(path.stem for path in folder.glob(f"*{ending}")))


def _named(folder: Path, kind: str, name: str, ending: str = ".toml") -> Path:
    """Return a shipped file of a kind, or refuse its name with the nearest one."""
    names = _names(folder, ending)
    if name not in names:
        raise DesignError([Problem("name", f"there is no shipped {kind} {excerpt(name)!r}; {near(name, names)}")])
    return folder / f"{name}{ending}"
