"""Replays register themselves, and each has a command."""

from __future__ import annotations

from pathlib import Path

import pytest

import gearwright.replays
from gearwright.cli.commands.replay import COMMANDS
from gearwright.replays import REPLAYS, Replay, paper_on, register
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read


def test_every_folder_is_a_replay_with_a_command():
    folders = {
        path.name for path in Path(gearwright.replays.__file__).parent.iterdir() if (path / "__init__.py").exists()
    }
    assert set(REPLAYS) == set(COMMANDS) == folders


def test_two_replays_of_one_name_are_refused():
    with pytest.raises(ValueError, match="two replays are called wang"):
        register(Replay("wang", "again"))


def test_a_train_that_no_paper_is_about_gets_nothing():
    assert paper_on(size(read(shipped_design("in-line")))) is None
