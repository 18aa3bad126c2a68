"""Figures of results over axes: sizing, dynamics, flights, studies, masses, load sharing.

Skeletons and power flow are in `schematic`, technical drawings in `drawings`.
"""
