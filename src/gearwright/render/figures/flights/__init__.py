"""Figures of what flies: histories, energy, spectra and lives, mixes, windows, propellers.

Figures of motion without a mission are beside this folder.
"""
