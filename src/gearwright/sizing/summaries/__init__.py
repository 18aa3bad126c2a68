"""Stages and pairs of a sizing, each in one row, as tables and drawings show them, and what their tips reach. It sizes
nothing."""

from gearwright.sizing.summaries.fillets import InFillet, tips_in_fillets
from gearwright.sizing.summaries.load_factors import MeshFactors, mesh_factors
from gearwright.sizing.summaries.pair_data import BevelPairData, CylindricalPairData, pair_data
from gearwright.sizing.summaries.stage_summary import StageSummary, stage_summaries

__all__ = [
    "BevelPairData",
    "CylindricalPairData",
    "InFillet",
    "MeshFactors",
    "StageSummary",
    "mesh_factors",
    "pair_data",
    "stage_summaries",
    "tips_in_fillets",
]
