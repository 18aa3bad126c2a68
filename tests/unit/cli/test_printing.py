"""PDF: who has no browser is told what to do, and nothing is written."""

import pytest

from gearwright.cli.printing import print_pdf
from gearwright.errors import DesignError


def test_without_a_browser_it_says_what_to_do(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setenv("CHROMIUM", "no-such-browser")
    with pytest.raises(DesignError, match="no browser is found that prints; install Chromium"):
        print_pdf("<p>page", tmp_path / "page.pdf")
    assert not (tmp_path / "page.pdf").exists()


def test_a_browser_that_prints_nothing_is_told(monkeypatch, tmp_path):
    silent = tmp_path / "silent"
    silent.write_text("#!/bin/sh\nexit 0\n", encoding="utf-8")
    silent.chmod(0o755)
    monkeypatch.setenv("CHROMIUM", str(silent))
    with pytest.raises(DesignError, match="printed nothing"):
        print_pdf("<p>page", tmp_path / "page.pdf")
    assert not (tmp_path / "page.pdf").exists()
