"""Stages and pairs of a sizing, each in one row, as tables and drawings show them. It sizes nothing."""

from gearwright.sizing.summaries.pair_data import BevelPairData, CylindricalPairData, pair_data
from gearwright.sizing.summaries.stage_summary import StageSummary, stage_summaries

__all__ = [
    "BevelPairData",
    "CylindricalPairData",
    "StageSummary",
    "pair_data",
    "stage_summaries",
]
