"""One workbench for the tests of a file."""

import pytest


@pytest.fixture(scope="module")
def asked(tmp_path_factory):
    from asking import Asked

    bench = Asked(tmp_path_factory.mktemp("designs"))
    yield bench
    bench.close()


@pytest.fixture
def folder(asked):
    return next(route.endpoint.__self__.opened.folder for route in asked.app.routes if route.path == "/api/start")
