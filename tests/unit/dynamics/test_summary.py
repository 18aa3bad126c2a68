"""The generated summary of a record is that of plain numpy."""

import numpy as np
import pytest

from gearwright.dynamics.codegen import summarise
from gearwright.dynamics.motion import blank_summary, summary_of


@pytest.mark.parametrize("width", [8, 32, 40, 72])
@pytest.mark.parametrize("rows", [1, 7, 512])
def test_the_summary_is_that_of_plain_numpy(width, rows):
    """Least and greatest exactly; sums to rounding, since their order differs."""
    record = np.random.default_rng(width).normal(1.0, 3.0, (rows, width))
    found = blank_summary(width)
    summarise(record, found)
    wanted = summary_of(record)
    assert np.array_equal(found[:2], wanted[:2])
    np.testing.assert_allclose(found[2:], wanted[2:], rtol=1e-12, atol=1e-12 * rows)


def test_a_value_that_is_no_number_shows_in_the_sums():
    """A run that has diverged is found by them."""
    record = np.ones((5, 8))
    record[2, 3] = np.nan
    found = blank_summary(8)
    summarise(record, found)
    assert np.isnan(found[3, 3])
    assert np.all(np.isfinite(np.delete(found[3], 3)))
