"""Pieces of housings that are no chambers, and loops around cross-sections; which a housing has is for `housing`."""
