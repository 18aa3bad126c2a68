"""Pieces of housings that are no chambers; which a housing has is for `housing`."""
