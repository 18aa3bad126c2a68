"""Figures of studies: lines along an axis, stacked masses, spreads and fronts, trades between designs.

Their tables are in `tables/study`.
"""
