"""Puts this folder on the path, so that every test can import `designs`; says how often faults are made to happen.

Tests that need what only an extra installs are marked with it: ``@pytest.mark.extra("distributed")``.
"""

import importlib
import os

import pytest
from hypothesis import settings

# The matrices are small: threads of linear algebra would mostly wait for each other. numpy asks when it is imported.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("MKL_NUM_THREADS", "1")
# Folders may have a conftest of their own; none holds examples, and as modules of tests they would share one name.
collect_ignore_glob = ["conftest.py", "*/conftest.py"]
settings.register_profile("repeatable", deadline=None, derandomize=True)
settings.register_profile("search", deadline=None)
settings.load_profile("repeatable")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--faults", type=int, default=1, help="Times that each fault of a study happens, at other moments")
    parser.addoption("--extras", action="store_true", help="Run the tests that need an extra, alone; none is skipped")


@pytest.hookimpl(tryfirst=True)
def pytest_cmdline_main(config: pytest.Config) -> None:
    """Let each process begin with its own half of the tests: what a file or a folder shares is made once."""
    if getattr(config.option, "numprocesses", None) and config.option.dist == "no":
        config.option.dist = "worksteal"


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "fault" in metafunc.fixturenames:
        metafunc.parametrize("fault", range(metafunc.config.getoption("--faults")))


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep those that need an extra, where they are asked for."""
    if config.getoption("--extras"):
        others = [item for item in items if not item.get_closest_marker("extra")]
        config.hook.pytest_deselected(items=others)
        items[:] = [item for item in items if item.get_closest_marker("extra")]


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Skip what lacks its extra, or fail where every extra is said to be there."""
    demand = importlib.import_module if item.config.getoption("--extras") else pytest.importorskip
    for mark in item.iter_markers("extra"):
        for module in mark.args:
            demand(module)
